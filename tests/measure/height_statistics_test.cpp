// SPDX-License-Identifier: BSD-3-Clause
// Truth: sums in long double about the mean; areal_statistics.hpp; the closed moments of a sine.
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>
#include <random>

namespace height_statistics_test {

using namespace fstiff;

TEST_CASE("skewness, kurtosis and gradient of a profile are plain sums about the mean") {
    Profile<double> profile;
    profile.spacing = 2e-7;
    std::mt19937 random(3);
    std::exponential_distribution<double> skewed(1e6);
    for (int i = 0; i < 5000; ++i) profile.heights.push_back(3e-5 + skewed(random));
    profile.heights[77] = std::nan("");
    long double n = 0, mean = 0, two = 0, three = 0, four = 0, pairs = 0, slope = 0;
    for (const double z : profile.heights)
        if (!std::isnan(z)) n += 1, mean += static_cast<long double>(z);
    mean /= n;
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        if (std::isnan(profile.heights[i])) continue;
        const long double z = static_cast<long double>(profile.heights[i]) - mean;
        two += z * z, three += z * z * z, four += z * z * z * z;
        if (i + 1 == profile.heights.size() || std::isnan(profile.heights[i + 1])) continue;
        const auto rise = static_cast<long double>((profile.heights[i + 1] - profile.heights[i]) / profile.spacing);
        slope += rise * rise, pairs += 1;
    }
    const auto found = height_statistics(profile);
    const long double variance = two / n;
    CHECK(test::relative_error(found.skewness.value, static_cast<double>(three / n / std::pow(variance, 1.5L))) <
          1e-10);
    CHECK(test::relative_error(found.kurtosis.value, static_cast<double>(four / n / (variance * variance))) < 1e-10);
    CHECK(test::relative_error(found.rms_gradient.value, static_cast<double>(std::sqrt(2 * slope / pairs))) < 1e-10);
    // 2 and 9 of an exponential distribution, to their errors
    CHECK(std::abs(found.skewness.value - 2) < 3 * found.skewness.error);
    CHECK(std::abs(found.kurtosis.value - 9) < 4 * found.kurtosis.error);
}

TEST_CASE("the moments of a map are those of its areal statistics") {
    const auto map = self_affine_map<double>({.hurst = 0.8, .rms = 1e-7, .longest_wavelength = 3e-5, .seed = 5}, 128,
                                             96, 1e-6, 1.5e-6);
    const auto found = height_statistics(map);
    const auto areal = detail::areal_statistics(map);
    CHECK(test::relative_error(found.rms_gradient.value, areal.rms_gradient) <
          0.01);  // x and y by their number of pairs
    CHECK(test::relative_error(found.moments.m0, areal.m0) < 1e-10);
    CHECK(std::abs(found.skewness.value) < 4 * found.skewness.error + 0.05);
    CHECK(std::abs(found.kurtosis.value - 3) < 4 * found.kurtosis.error + 0.1);
}

TEST_CASE("too few points are refused") {
    Profile<double> profile;
    profile.spacing = 1;
    for (int i = 0; i < 40; ++i) profile.heights.push_back(std::sin(i));
    CHECK(test::refusal([&] { (void)height_statistics(profile); }).find("at least 64") != std::string::npos);
}

}  // namespace height_statistics_test
