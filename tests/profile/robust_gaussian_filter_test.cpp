// SPDX-License-Identifier: BSD-3-Clause
// The robust filter against sums and normal equations point by point, and its purpose: grooves and spikes.

#include <fstiff/profile/gaussian_filter.hpp>

#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <random>

namespace robust_gaussian_filter_test {

using namespace fstiff;

namespace {

/// Rough, on a wave; every 40th point a spike, a groove, and points missing.
Profile<double> damaged() {
    Profile<double> profile{test::fractional_brownian(600, 0.3, 5), 1e-6};
    for (std::size_t i = 0; i < profile.size(); ++i) {
        profile.heights[i] += 20 * std::sin(0.02 * static_cast<double>(i));
        if (i % 40 == 7) profile.heights[i] += 60;
        if (i >= 300 && i < 330) profile.heights[i] -= 80;
        if (i % 97 == 3 || (i >= 400 && i < 410)) profile.heights[i] = std::nan("");
        profile.heights[i] *= 1e-8;
    }
    return profile;
}

/// The definition, without transforms: weights to the farthest point, normal equations by a decomposition.
std::vector<double> slow(const Profile<double>& profile, double cutoff, int order) {
    const std::size_t n = profile.size();
    const double pi = std::numbers::pi_v<double>;
    double t = std::log(2.);  // exp(-t) = 1/2; of order 2 (1 + t) exp(-t) = 1/2, by Newton
    if (order == 2) {
        t = 1.7;
        for (int i = 0; i < 50; ++i) t += ((1 + t) * std::exp(-t) - 0.5) / (t * std::exp(-t));
    }
    const double width = std::sqrt(t / pi) * cutoff;
    std::vector<double> delta(n), wave(n, std::nan("")), first;
    for (std::size_t i = 0; i < n; ++i) delta[i] = std::isnan(profile.heights[i]) ? 0 : 1;
    std::vector<double> weight_at_first(n);
    double previous = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
        std::vector<double> residuals;
        for (std::size_t i = 0; i < n; ++i) {
            if (std::isnan(profile.heights[i])) continue;
            Eigen::MatrixXd a = Eigen::MatrixXd::Zero(order + 1, order + 1);
            Eigen::VectorXd b = Eigen::VectorXd::Zero(order + 1);
            for (std::size_t k = 0; k < n; ++k) {
                if (delta[k] == 0) continue;
                const double x = (static_cast<double>(k) - static_cast<double>(i)) * profile.spacing / width;
                const double w = std::exp(-pi * x * x) * delta[k];
                Eigen::VectorXd powers(order + 1);
                for (int p = 0; p <= order; ++p) powers[p] = std::pow(x, p);
                a += w * powers * powers.transpose();
                b += w * profile.heights[k] * powers;
            }
            if (iteration == 0) weight_at_first[i] = a(0, 0);
            if (a(0, 0) >= (order == 0 ? 0.01 : 0.05) * weight_at_first[i]) wave[i] = a.ldlt().solve(b)[0];
            residuals.push_back(std::abs(profile.heights[i] - wave[i]));
        }
        std::sort(residuals.begin(), residuals.end());
        const std::size_t m = residuals.size();
        const double c = 3 / 0.67448975019608174320 * (residuals[m / 2] + residuals[(m - 1) / 2]) / 2;
        if (std::abs(c - previous) <= 1e-4 * c) break;
        previous = c;
        for (std::size_t k = 0; k < n; ++k) {
            const double q = std::isnan(profile.heights[k]) ? 2 : (profile.heights[k] - wave[k]) / c;
            delta[k] = std::abs(q) < 1 ? (1 - q * q) * (1 - q * q) : 0;
        }
    }
    return wave;
}

double rms_difference(const Profile<double>& a, const Profile<double>& b, std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += (a.heights[i] - b.heights[i]) * (a.heights[i] - b.heights[i]);
    return std::sqrt(sum / static_cast<double>(to - from));
}

}  // namespace

TEST_CASE("The robust waviness is that of sums point by point, with spikes, a groove and missing points") {
    const auto profile = damaged();
    const double size = rms_height(profile);
    for (const int order : {0, 2})
        for (const double cutoff : {20e-6, 80e-6, 400e-6}) {
            CAPTURE(order, cutoff);
            const auto found = detail::robust_waviness(profile, cutoff, order);
            CHECK(found.converged);
            CHECK(found.iterations > 2);
            const auto expected = slow(profile, cutoff, order);
            for (std::size_t i = 0; i < profile.size(); ++i) {
                REQUIRE(std::isnan(found.waviness.heights[i]) == std::isnan(profile.heights[i]));
                if (!std::isnan(expected[i])) REQUIRE(std::abs(found.waviness.heights[i] - expected[i]) < 1e-10 * size);
            }
        }
}

TEST_CASE("Spikes and grooves hardly move the robust mean line, and move the Gaussian one much") {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, 10e-9);
    Profile<double> clean{std::vector<double>(4000), 1e-6};
    for (std::size_t i = 0; i < clean.size(); ++i)
        clean.heights[i] = normal(random) + 100e-9 * std::sin(2 * 3.14159265 * static_cast<double>(i) / 4000);
    Profile<double> struck = clean;
    std::size_t points = 0;
    for (std::size_t i = 0; i < clean.size(); ++i)
        if (i % 200 < 20) struck.heights[i] -= 500e-9, ++points;  // grooves 20 um wide, on a tenth of the surface
    for (const int order : {0, 2}) {
        CAPTURE(order);
        const auto robust = detail::robust_waviness(struck, 200e-6, order);
        const auto undisturbed = detail::robust_waviness(clean, 200e-6, order);
        CHECK(rms_difference(robust.waviness, undisturbed.waviness, 200, 3800) < 1e-9);
        CHECK(robust.left_out >= points);
        CHECK(robust.left_out < points + 40);  // beyond three standard deviations of 3600 points: 10 expected
    }
    CHECK(rms_difference(detail::gaussian_waviness(struck, 200e-6), detail::gaussian_waviness(clean, 200e-6), 200,
                         3800) > 40e-9);
}

TEST_CASE("A parabola has no roughness with order 2 even at its ends") {
    Profile<double> parabola{std::vector<double>(500), 1e-6};
    for (std::size_t i = 0; i < parabola.size(); ++i) {
        const double x = static_cast<double>(i) / 100;
        parabola.heights[i] = 1e-6 * (x * x - 3 * x + 1) + (i % 50 == 25 ? 1e-3 : 0);  // and spikes
    }
    const auto waviness = detail::robust_waviness(parabola, 100e-6, 2).waviness;
    for (std::size_t i = 0; i < waviness.size(); ++i)
        if (i % 50 != 25) REQUIRE(std::abs(parabola.heights[i] - waviness.heights[i]) < 1e-11);
}

TEST_CASE("A cut-off, an order or a profile out of range of the robust filter is refused") {
    const auto profile = damaged();
    CHECK_THROWS_AS(detail::robust_waviness(profile, 4e-6), domain_error);
    CHECK_THROWS_AS(detail::robust_waviness(profile, 1.), domain_error);
    CHECK_THROWS_AS(detail::robust_waviness(profile, 80e-6, 1), domain_error);
}

}  // namespace robust_gaussian_filter_test
