// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/random.hpp>
#include <fstiff/measure/long_waves.hpp>
#include <fstiff/measure/parameters.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace long_waves_test {

using namespace fstiff;
using Parts = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>;

namespace {

/// A cosine of \p kx, \p ky half periods with the mean square height 1.
Parts wave(Eigen::Index rows, Eigen::Index columns, int kx, int ky) {
    return Parts::NullaryExpr(rows, columns, [&](Eigen::Index j, Eigen::Index i) {
        const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(columns);
        const double y = (static_cast<double>(j) + 0.5) / static_cast<double>(rows);
        return (kx > 0 ? std::sqrt(2.0) : 1) * (ky > 0 ? std::sqrt(2.0) : 1) *
               std::cos(std::numbers::pi_v<double> * kx * x) * std::cos(std::numbers::pi_v<double> * ky * y);
    });
}

/// The 5 % point of chi^2 with \p v degrees of freedom: where the integral of x^(v/2-1) e^(-x/2) is a twentieth of the
/// whole, by Simpson's rule in the root of x, v >= 2.
double chi_square_5_percent(double v) {
    const auto integral = [&](double to) {  // of 2 u^(v-1) e^(-u^2/2) du
        constexpr int steps = 4000;
        double sum = 0;
        for (int i = 0; i <= steps; ++i) {
            const double u = to * i / steps;
            sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * std::pow(u, v - 1) * std::exp(-u * u / 2);
        }
        return sum * to / steps / 3;
    };
    const double whole = integral(40);
    double low = 0, high = 40;
    for (int step = 0; step < 60; ++step) {
        const double u = (low + high) / 2;
        (integral(u) < 0.05 * whole ? low : high) = u;
    }
    return low * low;
}

}  // namespace

TEST_CASE("Waves of unlike numbers of periods make the share and the error of their chi square") {
    for (const auto& [rows, columns] : {std::pair{1, 64}, std::pair{64, 48}}) {
        for (const int waves : {1, 2, 4, 6}) {
            // m waves of one strength: e = 2/(3 m), V = 2/(3 m - 2); no shorter ones: four times that, or of a map
            // twice, since the power law has 1; and 1 at the most
            Parts sum = Parts::Zero(rows, columns);
            for (int k = 1; k <= waves; ++k) sum += wave(rows, columns, k, rows > 1 ? k % 2 : 0);
            const auto found = detail::long_waves<double>(sum, waves);
            CHECK(test::relative_error(found.share, 1.0) < 1e-12);
            const double variance = std::min(1.0, (rows > 1 ? 2.0 : 4.0) * 2 / (3 * waves - 2));
            const double v = 2 / variance,
                         exact = std::log(v / chi_square_5_percent(v)) / (2 * math::normal_95<double>.value);
            CAPTURE(rows, waves, exact);
            CHECK(test::relative_error(found.error, exact) < (v < 4 ? 0.1 : 0.02));
        }
        // a power law by its share: steps of its sum, and the tail by the integral
        double long_ones = 0, squares = 0, all = 0;
        for (int k = 2; k < 1000000; ++k) {
            const double c = std::pow(k, -2.0);
            all += c;
            if (k < 16) long_ones += c, squares += c * c;
        }
        CHECK(test::relative_error(detail::variance_of_power_law(long_ones / all, false), 2 * squares / (all * all)) <
              1e-3);
        // waves of eight periods and more are not covered
        const auto shorter = detail::long_waves<double>(wave(rows, columns, 16, 0), 1);
        CHECK(shorter.share < 1e-20);
        CHECK(shorter.error < 1e-20);
    }
}

TEST_CASE("sigma of a process lies within its band for 86 % of traces and more, however long its longest waves",
          "[long]") {
    // a trace of 2048 points, cut from a period of 4096 whose spectrum turns flat at a share of the trace
    for (const double hurst : {0.2, 0.5, 0.8})
        for (const double longest : {4096e-6, 2048e-6, 512e-6, 256e-6, 64e-6}) {
            constexpr int seeds = 200;
            double mean_square = 0;
            std::vector<Measurement<double>> found;
            for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
                const auto whole = self_affine_profile<double>({.hurst = hurst,
                                                                .rms = 1e-6,
                                                                .longest_wavelength = longest,
                                                                .shortest_wavelength = 8e-6,
                                                                .exact_rms = false,
                                                                .seed = seed},
                                                               4096, 1e-6);
                const Profile<double> part{{whole.heights.begin(), whole.heights.begin() + 2048}, 1e-6};
                found.push_back(detail::surface_parameters(detail::level(part, Form::line),
                                                           {.fit = {.resamples = 0}, .resamples = 100})
                                    .rms_height);
                mean_square += found.back().value * found.back().value / seeds;
            }
            int inside = 0;
            for (const auto& one : found) {
                const double error = std::sqrt(std::log1p(one.error * one.error / one.value / one.value));
                inside +=
                    std::abs(std::log(std::sqrt(mean_square) / one.value)) < math::normal_95<double>.value * error;
            }
            WARN("H = " << hurst << ", flat from " << longest << " m: sigma inside " << 100.0 * inside / seeds << " %");
            CHECK(inside >= 0.86 * seeds);  // 90 % less two standard errors
        }
}

}  // namespace long_waves_test
