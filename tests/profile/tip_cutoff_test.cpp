// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/profile/tip_lengths.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

#include <numbers>

namespace tip_cutoff_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Trace of a parabolic tip: the least height of its apex at which it stays above the surface.
std::vector<double> dilated(const std::vector<double>& z, double spacing, double radius) {
    std::vector<double> trace(z.size());
    for (std::size_t i = 0; i < z.size(); ++i) {
        trace[i] = z[i];
        for (std::size_t k = 0; k < z.size(); ++k) {
            const double x = (static_cast<double>(k) - static_cast<double>(i)) * spacing;
            trace[i] = std::max(trace[i], z[k] - x * x / (2 * radius));
        }
    }
    return trace;
}

}  // namespace

TEST_CASE("The least curvature of a sine is -(a/h^2) 4 sin^2(pi n h/lambda) n^-2") {
    Profile<double> profile{std::vector<double>(1000), 1e-7};
    for (std::size_t i = 0; i < 1000; ++i)  // a crest on a sample
        profile.heights[i] = 3e-9 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / 100);
    for (const std::size_t n : {1u, 7u, 25u, 50u}) {
        const double nh = static_cast<double>(n) * 1e-7,
                     sine = std::sin(std::numbers::pi * static_cast<double>(n) / 100);
        // three heights round to 1e-16 of 3 nm each, against a difference of 1.2e-11 m at the shortest
        CHECK(test::relative_error(*detail::min_curvature(profile, n), -3e-9 * 4 * sine * sine / (nh * nh)) < 1e-12);
    }
}

TEST_CASE("The trace of a parabolic tip is at no scale sharper than the tip") {
    const double spacing = 1e-9, radius = 40e-9;
    auto z = test::fractional_brownian(2048, 0.5, 3);
    for (double& v : z) v *= 1e-9;  // far sharper than the tip at one sample
    REQUIRE(*detail::min_curvature(Profile<double>{z, spacing}, 1) < -10 / radius);
    const Profile<double> trace{dilated(z, spacing, radius), spacing};
    for (const std::size_t n : detail::logarithmic_lags(256)) {
        CAPTURE(n);
        CHECK(*detail::min_curvature(trace, n) > -1 / radius * (1 + 1e-6));  // rounding: 1e-16 of 1e-7 m over (1 nm)^2
    }
    CHECK(*detail::min_curvature(trace, 1) < -0.99 / radius);  // and it has peaks that are the tip
    // the cut-off is where the curvature has fallen to half of it, on both sides of the step
    const double cutoff = detail::tip_cutoff(trace, radius);
    const auto reliable = static_cast<std::size_t>(std::lround(cutoff / spacing / 2));
    CHECK(*detail::min_curvature(trace, reliable) > -0.5 / radius);
    const auto lags = detail::logarithmic_lags(256);
    const auto here = std::find(lags.begin(), lags.end(), reliable);
    REQUIRE(here != lags.begin());
    REQUIRE(here != lags.end());
    CHECK(*detail::min_curvature(trace, *(here - 1)) <= -0.5 / radius);
}

TEST_CASE("A blunt tip leaves nothing, a point everything, and the unit of length does not matter") {
    auto z = test::fractional_brownian(1024, 0.5, 4);
    const Profile<double> profile{z, 1.0};
    CHECK(detail::tip_cutoff(profile, 1e9) == std::numeric_limits<double>::infinity());
    CHECK(detail::tip_cutoff(profile, 1e-9) == 0);
    const double cutoff = detail::tip_cutoff(profile, 5.0);
    CHECK(cutoff > 2);
    CHECK(cutoff < 256);
    for (const double unit : {1e-9, 1e9}) {
        Profile<double> scaled{z, unit};
        for (double& v : scaled.heights) v *= unit;
        CHECK(test::relative_error(detail::tip_cutoff(scaled, 5.0 * unit) / unit, cutoff) < 1e-14);
    }
}

TEST_CASE("Missing points drop their triples and arguments out of range are refused") {
    const Profile<double> profile{{0, 1, 0, missing, 5, 0}, 1.0};
    CHECK(*detail::min_curvature(profile, 1) == -2.0);
    CHECK(*detail::min_curvature(profile, 2) == 1.25);  // 0, 0, 5 over 2^2
    CHECK_FALSE(detail::min_curvature(profile, 3).has_value());
    CHECK(test::refusal([&] { (void)detail::min_curvature(profile, 0); }).find("step of the curvature") == 0);
    CHECK(test::refusal([&] { (void)detail::tip_cutoff(profile, 0.0); }).find("tip radius = 0") == 0);
    CHECK(test::refusal([&] { (void)detail::tip_cutoff(profile, missing); }).find("tip radius") == 0);
}

}  // namespace tip_cutoff_test
