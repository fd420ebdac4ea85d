// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/answer/face.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/profile.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

#include <numbers>

namespace spectral_moments_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

/// White noise smoothed over \p width samples: its moments converge.
Profile<double> smooth(std::size_t points, double width, std::uint64_t seed) {
    test::Normal normal(seed);
    const auto reach = static_cast<std::size_t>(5 * width);
    std::vector<double> noise(points + 2 * reach);
    for (double& z : noise) z = normal();
    Profile<double> profile{std::vector<double>(points), 1e-6};
    for (std::size_t i = 0; i < points; ++i)
        for (std::size_t k = 0; k <= 2 * reach; ++k) {
            const double x = (static_cast<double>(k) - static_cast<double>(reach)) / width;
            profile.heights[i] += 1e-9 * noise[i + k] * std::exp(-x * x);
        }
    return profile;
}

}  // namespace

TEST_CASE("The moments of a sampled sine are those of its finite differences") {
    const double a = 3e-9, h = 1e-7;
    for (const std::size_t period : {4u, 10u, 100u}) {
        CAPTURE(period);
        Profile<double> profile{std::vector<double>(20 * period + 1), h};
        const double phase = 2 * pi / static_cast<double>(period);
        // whole periods for the slopes, and for the mean except one point at 0
        for (std::size_t i = 0; i < profile.size(); ++i)
            profile.heights[i] = a * std::sin(phase * static_cast<double>(i % period));
        const auto moments = detail::spectral_moments(profile);
        const double sine = 2 * std::sin(phase / 2) / h, n = static_cast<double>(20 * period);
        CHECK(test::relative_error(moments.m0, a * a / 2 * n / (n + 1)) < 1e-13);
        CHECK(test::relative_error(moments.m2, a * a / 2 * sine * sine) < 1e-13);
        // the triples leave out the two at the crossing of zero, where the curvature is 0: n - 1 of n
        CHECK(test::relative_error(moments.m4, a * a / 2 * std::pow(sine, 4) * n / (n - 1)) < 1e-13);
        // alpha of a sine is 1 however it is sampled; the ends are n^2/(n^2 - 1)
        CHECK(test::relative_error(moments.bandwidth(), n * n / (n * n - 1)) < 1e-12);
    }
}

TEST_CASE("The moments are the integrals of the power spectrum") {
    // the window weighs the middle of the profile: means over some 2000 correlation lengths agree to some percent
    const auto profile = smooth(40000, 12, 1);
    const auto moments = detail::spectral_moments(profile);
    const auto spectrum = power_spectrum(profile);
    CHECK(test::relative_error(spectrum.moment(0), moments.m0) < 0.05);
    CHECK(test::relative_error(spectrum.moment(2), moments.m2) < 0.05);
    CHECK(test::relative_error(spectrum.moment(4), moments.m4) < 0.05);
    // Gaussian correlation exp(-x^2/(2 w^2)): m2 = m0/w^2, m4 = 3 m0/w^4, alpha = 3
    const double w = 12e-6;
    CHECK(test::relative_error(moments.m2, moments.m0 / (w * w)) < 0.05);
    CHECK(test::relative_error(moments.m4, 3 * moments.m0 / std::pow(w, 4)) < 0.1);
    CHECK(test::relative_error(moments.bandwidth(), 3.0) < 0.1);
}

TEST_CASE("The moments are the squares of the three-point statistics up to the ends") {
    const auto profile = smooth(5000, 3, 2);
    const auto moments = detail::spectral_moments(profile);
    const auto statistics = peak_statistics(profile);
    CHECK(test::relative_error(std::sqrt(moments.m0), statistics.rms_height) < 1e-14);
    CHECK(test::relative_error(std::sqrt(moments.m2), statistics.rms_slope) < 1e-3);  // one slope of 5000 at either end
    CHECK(test::relative_error(std::sqrt(moments.m4), statistics.rms_curvature) < 1e-13);
}

TEST_CASE("Missing points drop their pairs and triples, and the unit of length does not matter") {
    Profile<double> profile{{0, 1, 3, missing, 5, 5, 6, missing, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9}, 0.5};
    const auto moments = detail::spectral_moments(profile);
    CHECK(test::relative_error(moments.m2, (1.0 + 4 + 0 + 1) / 14 / 0.25) < 1e-14);  // 2 + 2 + 10 pairs
    CHECK(test::relative_error(moments.m4, (1.0 + 1) / 11 / 0.0625) < 1e-14);        // 1 + 1 + 9 triples
    for (const double unit : {1e-9, 1e9}) {
        auto scaled = profile;
        scaled.spacing *= unit;
        for (double& z : scaled.heights) z *= unit;
        const auto other = detail::spectral_moments(scaled);
        CHECK(test::relative_error(other.m0 / unit / unit, moments.m0) < 1e-14);
        CHECK(test::relative_error(other.m2, moments.m2) < 1e-14);
        CHECK(test::relative_error(other.bandwidth(), moments.bandwidth()) < 1e-13);
    }
}

TEST_CASE("Profiles without moments are refused") {
    const auto refusal = [](std::vector<double> z, double spacing) {
        return test::refusal([&] { (void)detail::spectral_moments(Profile<double>{z, spacing}); });
    };
    CHECK(refusal(std::vector<double>(20, 1.0), 1.0).find("constant height") != std::string::npos);
    CHECK(refusal(std::vector<double>(15, 1.0), 1.0).find("at least 16") != std::string::npos);
    std::vector<double> holes(48, missing);
    for (std::size_t i = 0; i < 48; i += 2) holes[i] = static_cast<double>(i);
    CHECK(refusal(holes, 1.0).find("0 triples") != std::string::npos);
    std::vector<double> huge(20);
    for (std::size_t i = 0; i < 20; ++i) huge[i] = static_cast<double>(i * i % 7) * 1e200;
    CHECK(refusal(huge, 1.0).find("m0 = ") == 0);
}

}  // namespace spectral_moments_test
