// SPDX-License-Identifier: BSD-3-Clause
// Truth: maps of few waves, whose spectrum is known; Parseval's sum.
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

using namespace fstiff;

TEST_CASE("each wave of a periodic map is in its shell") {
    for (const Eigen::Index columns : {48, 53, 101}) {
        const Eigen::Index rows = 40;
        HeightMap<double> map;
        map.dx = 2e-6 / static_cast<double>(columns);
        map.dy = 2e-6 / static_cast<double>(rows);
        map.heights.resize(rows, columns);
        const double turn = 2 * std::numbers::pi;
        for (Eigen::Index j = 0; j < rows; ++j)
            for (Eigen::Index i = 0; i < columns; ++i) {
                const double x = static_cast<double>(i) / static_cast<double>(columns);
                const double y = static_cast<double>(j) / static_cast<double>(rows);
                map.heights(j, i) = 7e-6 + 3e-9 * std::cos(turn * 3 * x) + 2e-9 * std::sin(turn * (4 * x - 6 * y)) +
                                    1e-9 * std::cos(turn * 11 * y);
            }
        const auto spectrum = map_spectrum(map, SpectrumWindow::none);
        const double unit = turn / 2e-6;
        const struct { double waves, amplitude; } shells[] = {{3, 3e-9}, {std::hypot(4.0, 6.0), 2e-9}, {11, 1e-9}};
        CAPTURE(columns);
        double q2 = 0, h2 = 0;
        for (const auto& wave : shells) {
            q2 += std::pow(unit * wave.waves * wave.amplitude, 2) / 2;
            h2 += wave.amplitude * wave.amplitude / 2;
            bool found = false;
            for (const auto& shell : spectrum.shells)
                found =
                    found ||
                    (test::relative_error(shell.q2_h2, std::pow(unit * wave.waves * wave.amplitude, 2) / 2) < 1e-11 &&
                     test::relative_error(shell.q_h2, unit * wave.waves * std::pow(wave.amplitude, 2) / 2) < 1e-11);
            CHECK(found);
        }
        CHECK(test::relative_error(spectrum.rms_gradient(), std::sqrt(q2)) < 1e-11);
        CHECK(test::relative_error(spectrum.rms_height, std::sqrt(h2)) < 1e-12);
    }
}

TEST_CASE("the spectrum adds up to the variance, whatever the heights") {
    HeightMap<double> map;
    map.dx = 1e-6;
    map.dy = 1.5e-6;
    map.heights = 1e-7 * Eigen::ArrayXXd::Random(45, 64);
    const auto spectrum = map_spectrum(map, SpectrumWindow::none);
    const double sigma = std::sqrt((map.heights - map.heights.mean()).square().mean());
    CHECK(test::relative_error(spectrum.rms_height, sigma) < 1e-13);
    // of white heights any window leaves the same, to the scatter of 2880 numbers
    CHECK(test::relative_error(map_spectrum(map).rms_height, sigma) < 0.1);
}

TEST_CASE("Hann's window takes the step between opposite edges away") {
    HeightMap<double> map;
    map.dx = map.dy = 1e-6;
    map.heights.resize(128, 128);
    for (Eigen::Index i = 0; i < 128; ++i)  // 1.5 waves: a step of two amplitudes at the edge
        map.heights.col(i) = 1e-8 * std::cos(3 * std::numbers::pi * (static_cast<double>(i) + 0.5) / 128);
    const double truth = 1e-8 * 3 * std::numbers::pi / 128e-6 / std::sqrt(2.0);
    CHECK(map_spectrum(map, SpectrumWindow::none).rms_gradient() > 4 * truth);
    CHECK(map_spectrum(map).rms_gradient() < 1.8 * truth);
}

TEST_CASE("maps without a spectrum are refused") {
    HeightMap<double> map;
    map.dx = map.dy = 1;
    map.heights = Eigen::ArrayXXd::Random(8, 8);
    map.heights(3, 3) = std::nan("");
    CHECK(test::refusal([&] { (void)map_spectrum(map); }).find("1 missing points") != std::string::npos);
}
