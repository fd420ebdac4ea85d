// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/gaussian_filter.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

#include <algorithm>
#include <numbers>

namespace gaussian_filter_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

Profile<double> wave(std::size_t points, double samples) {
    Profile<double> profile{std::vector<double>(points), 1e-6};
    for (std::size_t i = 0; i < points; ++i)
        profile.heights[i] = 2e-9 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / samples);
    return profile;
}

/// The sums of the head of the header, one by one, with the weights of the standard as it writes them.
double slow(const Profile<double>& profile, double cutoff, std::size_t i) {
    const double a = std::sqrt(std::numbers::ln2 / std::numbers::pi);
    long double sum = 0, weights = 0;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        if (std::isnan(profile.heights[k])) continue;
        const double x = (static_cast<double>(k) - static_cast<double>(i)) * profile.spacing / (a * cutoff);
        const long double s = std::exp(-std::acos(-1.0L) * x * x) / (a * cutoff);
        sum += s * profile.heights[k];
        weights += s;
    }
    return static_cast<double>(sum / weights);
}

}  // namespace

TEST_CASE("A wave passes by the closed form, half of it at the cut-off") {
    const auto transmission = [](double wavelength, double cutoff) {
        return std::exp2(-std::pow(cutoff / wavelength, 2));  // ISO 16610-21
    };
    for (const double length : {10.0, 25.0, 50.0, 100.0, 400.0}) {
        const auto profile = wave(4000, length);
        for (const double samples : {5.0, 10.0, 50.0, 200.0}) {
            CAPTURE(length, samples);
            const auto waviness = detail::gaussian_waviness(profile, samples * 1e-6);
            const std::size_t middle = 2000;  // a crest, far from the ends
            const double passed = waviness.heights[middle] / 2e-9;
            // the sum over samples approximates an integral: its alias is exp(-ln 2 (5 (1 - 1/10))^2) = 8e-7 at most
            CHECK(std::abs(passed - transmission(length, samples)) < (samples < 10 ? 1e-6 : 1e-13));
        }
    }
}

TEST_CASE("Every point, the ends and the rims of gaps among them, is the weighted mean over the points that exist") {
    Profile<double> profile{test::fractional_brownian(512, 0.5, 1), 1e-6};
    for (std::size_t i = 0; i < 512; ++i)
        if (i % 17 == 3 || (i > 200 && i < 320)) profile.heights[i] = missing;
    for (const double cutoff : {5e-6, 40e-6, 511e-6}) {
        const auto waviness = detail::gaussian_waviness(profile, cutoff);
        const auto roughness = detail::gaussian_roughness(profile, cutoff);
        for (std::size_t i = 0; i < 512; ++i) {
            REQUIRE(std::isnan(waviness.heights[i]) == std::isnan(profile.heights[i]));
            if (std::isnan(profile.heights[i])) continue;
            CAPTURE(cutoff, i);
            // sums of numbers up to 30 by transform, divided by a weight of 1/2 or more
            REQUIRE(std::abs(waviness.heights[i] - slow(profile, cutoff, i)) < 1e-12);
            REQUIRE(roughness.heights[i] == profile.heights[i] - waviness.heights[i]);
        }
    }
}

TEST_CASE("The low pass is the waviness, and holds cut-offs down to two spacings") {
    Profile<double> profile{test::fractional_brownian(256, 0.5, 3), 1e-6};
    for (std::size_t i = 0; i < 256; ++i)
        if (i % 11 == 3 || (i > 60 && i < 90)) profile.heights[i] = missing;
    CHECK(std::ranges::equal(detail::gaussian_low_pass(profile, 20e-6).heights,
                             detail::gaussian_waviness(profile, 20e-6).heights,
                             [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
    for (const double cutoff : {2e-6, 3.7e-6}) {
        const auto low = detail::gaussian_low_pass(profile, cutoff);
        for (std::size_t i = 0; i < 256; ++i) {
            CAPTURE(cutoff, i);
            REQUIRE(std::isnan(low.heights[i]) == std::isnan(profile.heights[i]));
            if (!std::isnan(profile.heights[i]))
                REQUIRE(std::abs(low.heights[i] - slow(profile, cutoff, i)) < 1e-12);  // of heights up to 30
        }
    }
    CHECK(test::refusal([&] { (void)detail::gaussian_low_pass(profile, 1.9e-6); }).find("cut-off") == 0);
    CHECK(test::refusal([&] { (void)detail::gaussian_low_pass(profile, 256e-6); }).find("cut-off") == 0);
}

TEST_CASE("A constant is all waviness, ends included, whatever its height") {
    auto profile = wave(300, 7);
    const auto plain = detail::gaussian_roughness(profile, 60e-6);
    for (double& z : profile.heights) z += 1e-3;  // 5e5 times the wave; rounds it to 2e-19 m
    const auto raised = detail::gaussian_roughness(profile, 60e-6);
    for (std::size_t i = 0; i < 300; ++i) CHECK(std::abs(raised.heights[i] - plain.heights[i]) < 1e-18);
}

TEMPLATE_TEST_CASE("The waviness does not depend on the unit of length, nor on the scalar", "", FSTIFF_SCALARS) {
    using T = TestType;
    const auto z = test::fractional_brownian(256, 0.5, 2);
    const auto truth = detail::gaussian_waviness(Profile<double>{z, 1.0}, 32.0);
    for (const double unit : {1.0, 1e-9, 1e9}) {
        Profile<T> profile{std::vector<T>(256), static_cast<T>(unit)};
        for (std::size_t i = 0; i < 256; ++i) profile.heights[i] = static_cast<T>(z[i] * unit);
        const auto waviness = detail::gaussian_waviness(profile, static_cast<T>(32 * unit));
        const double epsilon = std::max(1e-13, static_cast<double>(std::numeric_limits<T>::epsilon()) * 100);
        for (std::size_t i = 0; i < 256; ++i)
            REQUIRE(std::abs(static_cast<double>(waviness.heights[i]) / unit - truth.heights[i]) < epsilon * 10);
    }
}

TEST_CASE("Cut-offs and profiles out of range are refused") {
    const auto profile = wave(100, 20);
    const auto refusal = [&](const Profile<double>& p, double cutoff) {
        return test::refusal([&] { (void)detail::gaussian_waviness(p, cutoff); });
    };
    CHECK(refusal(profile, 4.9e-6).find("cut-off") == 0);
    CHECK(refusal(profile, 100e-6).find("cut-off") == 0);
    CHECK(refusal(profile, missing).find("cut-off") == 0);
    CHECK(refusal(profile, 5e-6).empty());
    CHECK_FALSE(refusal(Profile<double>{}, 1.0).empty());
    CHECK(refusal(Profile<double>{std::vector<double>(100, missing), 1e-6}, 10e-6).find("0 points") !=
          std::string::npos);
    auto infinite = profile;
    infinite.heights[3] = std::numeric_limits<double>::infinity();
    CHECK(refusal(infinite, 10e-6).find("height") == 0);
}

}  // namespace gaussian_filter_test
