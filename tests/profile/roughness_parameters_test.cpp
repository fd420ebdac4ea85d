// SPDX-License-Identifier: BSD-3-Clause
// Truth: a sine in closed form; numpy on profiles with and without missing points.
#include <fstiff/profile/roughness_parameters.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/roughness_reference.hpp"

#include <numbers>

namespace roughness_parameters_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi;

Profile<double> sine(double amplitude, std::size_t points, double waves, double offset = 0) {
    Profile<double> profile{std::vector<double>(points), 1e-7};
    for (std::size_t i = 0; i < points; ++i)
        profile.heights[i] = offset + amplitude * std::sin(2 * pi * waves * (static_cast<double>(i) + 0.25) /
                                                           static_cast<double>(points));
    return profile;
}

}  // namespace

TEST_CASE("A sine has Ra = 2A/pi, Rku = 3/2, and the slope of the seven-point formula") {
    const double offset = GENERATE(0.0, 1e-3);
    const std::size_t points = 4000;
    const auto found = roughness_parameters(sine(2e-6, points, 20, offset));
    const double rounding = 1e-13 + 1e-15 * offset / 2e-6;
    // the sum of |sin| at 200 points a wave, shifted by a quarter step, is below 2/pi by (2 pi/200)^2 times a number
    // below 1/12
    CHECK(test::relative_error(found.mean_deviation, 4e-6 / pi) < 1e-4);
    CHECK(test::relative_error(found.rms_height, 2e-6 / std::sqrt(2.0)) < rounding);
    CHECK(std::abs(found.skewness) < 1e-12 + rounding);
    CHECK(test::relative_error(found.kurtosis, 1.5) < rounding);
    const double step = 2 * pi / 200;  // of the phase
    const double response = (2 * std::sin(3 * step) - 18 * std::sin(2 * step) + 90 * std::sin(step)) / 60 / 1e-7;
    // over the whole waves but six points of 4000
    CHECK(test::relative_error(*found.rms_slope, response * 2e-6 / std::sqrt(2.0)) < 2e-3);
    CHECK(test::relative_error(response, step / 1e-7) < 1e-10);  // of sixth order
    // every section holds whole waves: the same extremes as the whole
    CHECK(test::relative_error(found.section_height, found.total_height) < rounding);
    CHECK(test::relative_error(found.total_height, 4e-6) < 2e-4);
    CHECK(test::relative_error(found.section_peak_height + found.section_pit_depth, found.section_height) < 1e-14);
}

TEST_CASE("RSm is the wavelength of a sine, and what is lower than a tenth of Rz is no element") {
    const auto wave = [](std::size_t points, double waves) {
        return *roughness_parameters(sine(2e-6, points, waves)).mean_spacing;
    };
    CHECK(test::relative_error(wave(4000, 20), 200e-7) < 1e-4);
    CHECK(test::relative_error(wave(4000, 7.3), 4000 / 7.3 * 1e-7) < 1e-4);
    auto ripple = sine(2e-6, 4000, 20);
    for (std::size_t i = 0; i < 4000; ++i) ripple.heights[i] += 0.15e-6 * std::sin(2 * pi * static_cast<double>(i) / 9);
    CHECK(test::relative_error(*roughness_parameters(ripple).mean_spacing, 200e-7) < 0.01);
    // a notch to the mean line and through it, of 0.7 % and 1.5 % of a fifth of the profile, in every second peak
    for (const auto& [points, expected] : {std::pair{6, 200e-7}, {12, 200e-7 * 20 / 30}}) {
        auto notched = sine(2e-6, 4000, 20);
        for (std::size_t peak = 50; peak < 4000; peak += 400)
            for (std::size_t i = 0; i < static_cast<std::size_t>(points); ++i) notched.heights[peak + i] = -1e-6;
        CHECK(test::relative_error(*roughness_parameters(notched).mean_spacing, expected) < 0.05);
    }
    auto hole = sine(2e-6, 4000, 20);  // elements that miss a point do not count
    for (std::size_t i = 1000; i < 1090; ++i) hole.heights[i] = std::numeric_limits<double>::quiet_NaN();
    CHECK(test::relative_error(*roughness_parameters(hole).mean_spacing, 200e-7) < 1e-3);
    Profile<double> ramp{std::vector<double>(64), 1e-7};
    for (std::size_t i = 0; i < 64; ++i) ramp.heights[i] = 1e-8 * static_cast<double>(i);
    CHECK_FALSE(roughness_parameters(ramp).mean_spacing);
}

TEST_CASE("Roughness parameters are those that numpy finds") {
    for (const std::string source : {"profile_row", "profile_row_cutoff", "profile_holes"}) {
        CAPTURE(source);
        auto expected = test::roughness_reference(source);
        const bool cut = source == "profile_row_cutoff";
        const auto found = roughness_parameters(test::reference_profile(source),
                                                cut ? std::optional<double>(40.0 / 256) : std::nullopt);
        CHECK(test::relative_error(found.mean_deviation, expected.at("Ra_m")) < 1e-9);
        CHECK(test::relative_error(found.rms_height, expected.at("Rq_m")) < 1e-9);
        CHECK(test::relative_error(found.skewness, expected.at("Rsk")) < 1e-9);
        CHECK(test::relative_error(found.kurtosis, expected.at("Rku")) < 1e-9);
        CHECK(test::relative_error(found.total_height, expected.at("Rt_m")) < 1e-9);
        CHECK(test::relative_error(found.section_height, expected.at("Rz_m")) < 1e-9);
        CHECK(test::relative_error(found.section_peak_height, expected.at("Rp_m")) < 1e-9);
        CHECK(test::relative_error(found.section_pit_depth, expected.at("Rv_m")) < 1e-9);
        CHECK(test::relative_error(*found.rms_slope, expected.at("Rdq")) < 1e-9);
        CHECK(found.by_cutoff == cut);
        CHECK(found.sections == 5);
        CHECK(test::relative_error(found.section_length, cut ? 40.0 / 256 : 0.2) < 1e-15);
    }
}

TEST_CASE("Sections are those of the cut-off where it fits five times, in the middle of the profile") {
    Profile<double> profile = sine(1, 100, 10);
    profile.spacing = 1;
    profile.heights[11] = 7;   // before the middle 75
    profile.heights[12] = -4;  // not
    const auto whole = roughness_parameters(profile), middle = roughness_parameters(profile, 15.0);
    CHECK_FALSE(whole.by_cutoff);
    CHECK(whole.section_length == 20);
    CHECK(middle.by_cutoff);
    CHECK(middle.section_length == 15);
    CHECK(middle.total_height == whole.total_height);
    // the deep point is in one of five sections in both, the high one in the whole alone; the mean is that of the whole
    // profile
    CHECK(whole.section_peak_height > middle.section_peak_height + 1);
    CHECK(roughness_parameters(profile, 20.0).by_cutoff);
    CHECK_FALSE(roughness_parameters(profile, 21.0).by_cutoff);
    CHECK(roughness_parameters(profile, 21.0).section_height == whole.section_height);
}

TEST_CASE("Missing points: a section without points does not count, and a slope needs seven") {
    Profile<double> profile = sine(1, 100, 10);
    for (std::size_t i = 20; i < 40; ++i) profile.heights[i] = std::nan("");
    CHECK(roughness_parameters(profile).sections == 4);
    for (std::size_t i = 3; i < 100; i += 6) profile.heights[i] = std::nan("");
    CHECK_FALSE(roughness_parameters(profile).rms_slope);
    CHECK(roughness_parameters(profile).sections == 4);
}

TEST_CASE("The unit of length scales lengths and leaves ratios") {
    const auto profile = test::reference_profile("profile_row");
    auto small = profile;
    for (double& z : small.heights) z *= 1e-9;
    small.spacing *= 1e-9;
    const auto a = roughness_parameters(profile), b = roughness_parameters(small);
    CHECK(test::relative_error(b.mean_deviation, 1e-9 * a.mean_deviation) < 1e-14);
    CHECK(test::relative_error(b.section_height, 1e-9 * a.section_height) < 1e-14);
    CHECK(test::relative_error(*b.rms_slope, *a.rms_slope) < 1e-13);
    CHECK(test::relative_error(b.kurtosis, a.kurtosis) < 1e-13);
}

TEST_CASE("Too short profiles and impossible cut-offs are refused") {
    CHECK(test::refusal([] { (void)roughness_parameters(sine(1, 15, 2)); }).find("15 points") != std::string::npos);
    CHECK(test::refusal([] { (void)roughness_parameters(sine(1, 50, 2), -1.0); }).find("cut-off") != std::string::npos);
}

}  // namespace roughness_parameters_test
