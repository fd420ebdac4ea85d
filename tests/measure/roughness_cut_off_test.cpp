// SPDX-License-Identifier: BSD-3-Clause
// lambda_c by the table: sines of known Ra, far shorter than every cut-off.
#include <fstiff/measure/cut_offs.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <vector>

namespace roughness_cut_off_test {

using namespace fstiff;

namespace {

/// Ra of a sine is 2/pi of its amplitude.
Profile<double> sine(double ra, double length, double step = 0.5e-6, double wave = 10e-6) {
    Profile<double> profile;
    profile.spacing = step;
    const double pi = std::numbers::pi_v<double>;
    for (double x = 0; x < length * (1 - 1e-9); x += step)
        profile.heights.push_back(pi / 2 * ra * std::sin(2 * pi * x / wave));
    return profile;
}

}  // namespace

TEST_CASE("A profile that is long enough has the lambda_c of its Ra") {
    const std::vector<std::pair<double, double>> rows{{0.015e-6, 0.08e-3}, {0.05e-6, 0.25e-3}, {1e-6, 0.8e-3},
                                                      {5e-6, 2.5e-3},      {30e-6, 8e-3},      {200e-6, 8e-3}};
    for (const auto& [ra, lambda_c] : rows) {
        CAPTURE(ra);
        const auto chosen = detail::roughness_cut_off(sine(ra, 40e-3), 2.5e-6);
        CHECK(chosen.lambda_c == lambda_c);
        CHECK(chosen.reason == CutOffReason::roughness);
        CHECK(std::abs(chosen.mean_deviation / ra - 1) <
              0.03);  // the sine passes all but 0.1 %; its samples are 20 a wave
    }
}

TEST_CASE("Waviness does not lengthen lambda_c, roughness that Ra(lambda_c) shows does") {
    Profile<double> wavy = sine(0.05e-6, 8e-3);
    for (std::size_t i = 0; i < wavy.size(); ++i)
        wavy.heights[i] += 20e-6 * std::sin(2 * std::numbers::pi_v<double> * static_cast<double>(i) / 16000);
    CHECK(detail::roughness_cut_off(wavy, 2.5e-6).lambda_c == 0.25e-3);
}

TEST_CASE("A length or a step that does not allow lambda_c is reported") {
    const auto shorter = detail::roughness_cut_off(sine(1e-6, 1.3e-3), 2.5e-6);  // five of 0.25 mm, not of 0.8
    CHECK(shorter.lambda_c == 0.25e-3);
    CHECK(shorter.reason == CutOffReason::length);
    CHECK(detail::roughness_cut_off(sine(1e-6, 0.4e-3), 2.5e-6).lambda_c == 0.08e-3);  // exactly five
    const auto none = detail::roughness_cut_off(sine(1e-6, 0.399e-3), 2.5e-6);
    CHECK_FALSE(none.lambda_c);
    CHECK(none.reason == CutOffReason::too_short);
    const auto coarse = detail::roughness_cut_off(sine(0.015e-6, 8e-3, 2e-6, 50e-6), 10e-6);  // 30 lambda_s is 0.3 mm
    CHECK(coarse.lambda_c == 0.8e-3);
    CHECK(coarse.reason == CutOffReason::step);
    const auto hopeless = detail::roughness_cut_off(sine(0.015e-6, 1.3e-3, 10e-6, 50e-6), 50e-6);
    CHECK_FALSE(hopeless.lambda_c);
    CHECK(hopeless.reason == CutOffReason::too_coarse);
}

}  // namespace roughness_cut_off_test
