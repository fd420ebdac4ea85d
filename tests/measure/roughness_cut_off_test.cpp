// SPDX-License-Identifier: BSD-3-Clause
// lambda_c by the table: chirps of known Ra, far shorter than every cut-off; and profiles of known period.
#include <fstiff/measure/cut_offs.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace roughness_cut_off_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi_v<double>;

template <class Height>
Profile<double> profile(double length, double step, const Height& height) {
    Profile<double> line;
    line.spacing = step;
    for (double x = 0; x < length * (1 - 1e-9); x += step) line.heights.push_back(height(x));
    return line;
}
Profile<double> sine(double ra, double length, double wave, double step = 0.5e-6) {
    return profile(length, step, [=](double x) { return pi / 2 * ra * std::sin(2 * pi * x / wave); });
}
/// A sine whose wavelength rises from 2/3 of \p wave to twice: it does not repeat itself. Ra is 2/pi of its amplitude.
Profile<double> chirp(double ra, double length, double step = 0.5e-6, double wave = 10e-6) {
    return profile(length, step,
                   [=](double x) { return pi / 2 * ra * std::sin(2 * pi * (1.5 * x - 0.5 * x * x / length) / wave); });
}

}  // namespace

TEST_CASE("A profile that is long enough has the lambda_c of its Ra") {
    const std::vector<std::pair<double, double>> rows{{0.015e-6, 0.08e-3}, {0.05e-6, 0.25e-3}, {1e-6, 0.8e-3},
                                                      {5e-6, 2.5e-3},      {30e-6, 8e-3},      {200e-6, 8e-3}};
    for (const auto& [ra, lambda_c] : rows) {
        CAPTURE(ra);
        const auto chosen = detail::roughness_cut_off(chirp(ra, 40e-3), 2.5e-6);
        CHECK(chosen.lambda_c == lambda_c);
        CHECK(chosen.reason == CutOffReason::roughness);
        CHECK(std::abs(chosen.mean_deviation / ra - 1) <
              0.03);  // the chirp passes all but 0.1 %; its samples are 13 to 40 a wave
    }
}

TEST_CASE("Waviness does not lengthen lambda_c, roughness that Ra(lambda_c) shows does") {
    Profile<double> wavy = chirp(0.05e-6, 8e-3);
    for (std::size_t i = 0; i < wavy.size(); ++i)
        wavy.heights[i] += 20e-6 * std::sin(2 * pi * static_cast<double>(i) / 16000);
    CHECK(detail::roughness_cut_off(wavy, 2.5e-6).lambda_c == 0.25e-3);
}

TEST_CASE("A length or a step that does not allow lambda_c is reported") {
    const auto shorter = detail::roughness_cut_off(chirp(1e-6, 1.3e-3), 2.5e-6);  // five of 0.25 mm, not of 0.8
    CHECK(shorter.lambda_c == 0.25e-3);
    CHECK(shorter.reason == CutOffReason::length);
    CHECK(detail::roughness_cut_off(chirp(1e-6, 0.4e-3), 2.5e-6).lambda_c == 0.08e-3);    // exactly five
    CHECK(detail::roughness_cut_off(chirp(1e-6, 0.398e-3), 2.5e-6).lambda_c == 0.08e-3);  // to 1 %
    const auto none = detail::roughness_cut_off(chirp(1e-6, 0.39e-3), 2.5e-6);
    CHECK_FALSE(none.lambda_c);
    CHECK(none.reason == CutOffReason::too_short);
    const auto coarse = detail::roughness_cut_off(chirp(0.015e-6, 8e-3, 2e-6, 50e-6), 10e-6);  // 30 lambda_s is 0.3 mm
    CHECK(coarse.lambda_c == 0.8e-3);
    CHECK(coarse.reason == CutOffReason::step);
    const auto hopeless = detail::roughness_cut_off(chirp(0.015e-6, 1.3e-3, 10e-6, 50e-6), 50e-6);
    CHECK_FALSE(hopeless.lambda_c);
    CHECK(hopeless.reason == CutOffReason::too_coarse);
}

TEST_CASE("A profile that repeats itself has the lambda_c of its RSm, and so its whole Ra") {
    // ISO 4288, table 3: RSm to 0.04, 0.13, 0.4, 1.3 and 4 mm
    const std::vector<std::pair<double, double>> rows{{0.02e-3, 0.08e-3}, {0.04e-3, 0.08e-3}, {0.1e-3, 0.25e-3},
                                                      {0.13e-3, 0.25e-3}, {0.2e-3, 0.8e-3},   {0.4e-3, 0.8e-3},
                                                      {0.5e-3, 2.5e-3},   {0.8e-3, 2.5e-3},   {1.3e-3, 2.5e-3},
                                                      {2e-3, 8e-3},       {4e-3, 8e-3}};
    for (const auto& [wave, lambda_c] : rows) {
        CAPTURE(wave);
        for (const double ra : {0.01e-6, 1e-6, 20e-6}) {
            const auto found = detail::roughness_cut_off(sine(ra, 48e-3, wave, 2e-6), 0.);
            CHECK(found.lambda_c == lambda_c);
            CHECK(found.reason == CutOffReason::spacing);
            CHECK(std::abs(found.spacing / wave - 1) < 0.05);
            CHECK(std::abs(found.mean_deviation / ra - 1) < 0.09);  // 2^-(2.5/1.3)^2 is 8 %
        }
    }
    const auto scallops = profile(16e-3, 5e-6, [](double x) {
        const double u = x / 0.5e-3 - std::round(x / 0.5e-3);
        return 16e-6 * u * u;
    });
    const auto of_scallops = detail::roughness_cut_off(scallops, 25e-6);
    CHECK(of_scallops.lambda_c == 2.5e-3);
    CHECK(std::abs(of_scallops.spacing / 0.5e-3 - 1) < 0.02);
}

TEST_CASE("Noise and waviness do not hide the period of a profile") {
    std::mt19937 engine(7);
    std::normal_distribution<double> noise(0, 1);
    for (const double share : {0.05, 0.2, 0.5}) {
        CAPTURE(share);
        const auto noisy = profile(
            12e-3, 2e-6, [&](double x) { return 1e-6 * (std::sin(2 * pi * x / 0.5e-3) + share * noise(engine)); });
        const auto found = detail::roughness_cut_off(noisy, 0.);
        CHECK(found.lambda_c == 2.5e-3);
        CHECK(std::abs(found.spacing / 0.5e-3 - 1) < 0.1);
    }
    const auto wavy = profile(16e-3, 2e-6, [](double x) {
        return 1e-6 * std::sin(2 * pi * x / 0.8e-3) + 3e-6 * std::sin(2 * pi * x / 16e-3);
    });
    CHECK(detail::roughness_cut_off(wavy, 0.).lambda_c == 2.5e-3);
}

TEST_CASE("A periodic profile that is too short for its lambda_c has the longest that fits five times") {
    const auto two = detail::roughness_cut_off(sine(1e-6, 5.6e-3, 0.8e-3, 2e-6), 0.);
    CHECK(two.lambda_c == 2.5e-3);
    CHECK(std::abs(two.mean_deviation / 1e-6 - 1) < 0.03);
    const auto none = detail::roughness_cut_off(sine(1e-6, 4.8e-3, 0.8e-3, 2e-6), 0.);
    CHECK(none.lambda_c == 0.8e-3);
    CHECK(none.reason == CutOffReason::length);
}

}  // namespace roughness_cut_off_test
