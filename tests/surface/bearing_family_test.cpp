// SPDX-License-Identifier: BSD-3-Clause
// Truth: a Gaussian surface; areas and moments summed over many values of the curve; the lognormal curve in closed
// form.
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <vector>

namespace bearing_family_test {

using namespace fstiff;

/// Skewness and kurtosis of the curve by Simpson's rule.
std::array<double, 4> moments_of(const MaterialRatioSlope<double>& curve) {
    std::array<double, 5> sum{};
    const double step = 1.0 / 512;
    for (int i = -4096; i <= 4096; ++i) {
        const double z = i * step, weight = (i % 2 == 0 ? 2 : 4) * step / 3 * math::normal_density(z);
        double power = weight;
        for (double& one : sum) one += power, power *= curve.height(z);
    }
    return {sum[1], sum[2], sum[3], sum[4]};
}

TEST_CASE("A bearing curve of the core of a Gaussian surface is that surface") {
    const double share = 0.0907, z = math::normal_quantile(1 - share), sigma = 2e-6;
    const double Spk = 2 / share * sigma * (math::normal_density(z) - z * share);
    const detail::MaterialRatio<double> core{2 * z * sigma, Spk, Spk, share, 1 - share};
    const auto curve = detail::bearing_of_core(core);
    for (const double center : {-3.0, 0.0, 1.4, 3.3})
        CHECK(test::relative_error(curve.slope(center, 0.5), sigma) < 1e-10);
}

TEST_CASE("A bearing curve has the core that it was made of") {
    const detail::MaterialRatio<double> core{1.0, 0.2, 1.5, 0.06, 0.82};
    const auto curve = detail::bearing_of_core(core);
    const double z1 = math::normal_quantile(1 - core.peak_share),
                 z2 = math::normal_quantile(1 - core.core_and_peak_share);
    CHECK(std::abs(curve.height(z1)) < 1e-12);
    CHECK(std::abs(curve.height(z2) + core.core_height) < 1e-12);
    double peaks = 0, valleys = 0;
    for (int i = 0; i < 200000; ++i) {
        const double t = (i + 0.5) / 200000, h = curve.height(math::normal_quantile(1 - t));
        peaks += std::max(h, 0.0) / 200000;
        valleys += std::max(-core.core_height - h, 0.0) / 200000;
    }
    CHECK(test::relative_error(peaks, core.reduced_peak_height * core.peak_share / 2) < 1e-4);
    CHECK(test::relative_error(valleys, core.reduced_valley_depth * (1 - core.core_and_peak_share) / 2) < 1e-4);
    CHECK(curve.slope(3, 0.3) < 0.3 * curve.slope(-3, 0.3));
    CHECK(detail::bearing_of_core(detail::MaterialRatio<double>{1, 0, 0, 0, 1}).knots().size() == 2);
    CHECK_THROWS_AS(detail::bearing_of_core(detail::MaterialRatio<double>{0, 1, 1, 0.1, 0.9}), domain_error);
    CHECK_THROWS_AS(detail::bearing_of_core(detail::MaterialRatio<double>{1, 1, 1, 0.9, 0.1}), domain_error);
    CHECK_THROWS_AS(detail::bearing_of_core(detail::MaterialRatio<double>{1, -1, 1, 0.1, 0.9}), domain_error);
}

TEST_CASE("A bearing curve of skewness and kurtosis has them, and no impossible ones are taken") {
    for (const auto& [skewness, kurtosis] : std::vector<std::pair<double, double>>{// clang-format off
             {0, 3}, {0, 1.8}, {0, 5}, {0.5, 3.4}, {1, 4.8}, {-0.5, 3.1}, {-1, 4.5}, {-1.7, 7}, {1, 3}, {2, 8}, {-0.8, 2.4},
             {0.001, 3.02222290919315}, {-0.01, 3}, {0.1, 3.0178}, {0.05, 3.003}, {1e-4, 2.99}, {2.9, 20}}) {
                                                                                   // clang-format on
        CAPTURE(skewness, kurtosis);
        const auto curve = detail::bearing_of_moments(skewness, kurtosis);
        const auto m = moments_of(curve);
        CHECK(std::abs(m[0]) < 1e-4);
        CHECK(std::abs(m[1] - 1) < 1e-4);
        CHECK(std::abs(m[2] - skewness) < 1e-3);
        CHECK(std::abs(m[3] - kurtosis) < 3e-3);
    }
    // the lognormal with (q - 1)(q + 2)^2 = 1 is between both families
    const double q = 1.1, sigma = std::sqrt(std::log(q)), skewness = (q + 2) * std::sqrt(q - 1);
    const auto curve = detail::bearing_of_moments(skewness, q * q * q * q + 2 * q * q * q + 3 * q * q - 3 + 1e-6);
    for (const double z : {-2.0, 0.0, 2.0})
        CHECK(std::abs(curve.height(z) - (std::exp(sigma * z) / std::sqrt(q) - 1) / std::sqrt(q - 1)) < 1e-3);
    // next to a Gaussian and to the lognormal of the same skewness there is a curve everywhere
    for (const double s : {0.0, 1e-6, 1e-3, 0.02, 0.1, 0.4, 1.6, 2.5})
        for (const double excess : {-0.1, -0.01, -1e-3, -1e-5, 0.0, 1e-5, 1e-3, 0.01, 0.1}) {
            CAPTURE(s, excess);
            CHECK_NOTHROW(detail::bearing_of_moments(s, std::max(3 + excess, detail::least_kurtosis(s))));
            CHECK_NOTHROW(detail::bearing_of_moments(-s, 3 + excess + 16 * s * s / 9));
        }
    CHECK_THROWS_AS(detail::bearing_of_moments(1.0, 1.9), domain_error);
    CHECK_THROWS_AS(detail::bearing_of_moments(6.0, 60.0), domain_error);
    CHECK_THROWS_AS(detail::bearing_of_moments(0.0, 200.0), domain_error);
}

}  // namespace bearing_family_test
