// SPDX-License-Identifier: BSD-3-Clause
// Truth: maps of few waves, whose spectrum is known; sums of variances; the relation of profile and surface; numpy.
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/roughness_reference.hpp"

#include <fstiff/synthetic/self_affine.hpp>

#include <numbers>

namespace radial_spectrum_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("A wave is in its shell and in its sections with half its squared amplitude") {
    for (const Eigen::Index columns : {64, 51}) {
        CAPTURE(columns);
        HeightMap<double> map;
        map.dx = 2e-6 / static_cast<double>(columns);
        map.dy = 2e-6 / 40;
        map.heights.resize(40, columns);
        for (Eigen::Index j = 0; j < 40; ++j)
            for (Eigen::Index i = 0; i < columns; ++i)
                map.heights(j, i) = 5e-6 + 3e-9 * std::cos(2 * pi *
                                                           (6 * static_cast<double>(i) / static_cast<double>(columns) -
                                                            8 * static_cast<double>(j) / 40));
        const auto found = radial_spectrum(map, SpectrumWindow::none);
        const double unit = 2 * pi / 2e-6, square = 9e-18 / 2;
        const std::size_t shell = 9;  // |q| = 10 units, and shells begin at 1
        CHECK(test::relative_error(found.value[shell] * static_cast<double>(found.waves[shell]) * unit * unit, square) <
              1e-12);
        CHECK(std::abs(found.wavenumber[shell] - 10 * unit) < unit / 2);
        CHECK(test::relative_error(found.along_x.value[5] * unit, square) < 1e-12);
        CHECK(test::relative_error(found.along_y.value[7] * unit, square) < 1e-12);
        CHECK(test::relative_error(found.along_x.wavenumber[5], 6 * unit) < 1e-14);
        CHECK(found.along_x.halved == (columns == 64));
        for (const std::size_t other : {3u, 6u}) CHECK(found.value[other] < 1e-20 * found.value[shell]);
    }
}

TEST_CASE("Sections along x and y add up to the variance but for the waves across them") {
    for (const Eigen::Index columns : {64, 45}) {
        HeightMap<double> map;
        map.dx = 1e-6;
        map.dy = 1.5e-6;
        map.heights = 1e-7 * Eigen::ArrayXXd::Random(38, columns);
        const auto found = radial_spectrum(map, SpectrumWindow::none);
        // the variance about the mean of each row is what the waves along x hold
        const double rows = (map.heights.colwise() - map.heights.rowwise().mean().eval()).square().mean();
        const double sides = (map.heights.rowwise() - map.heights.colwise().mean().eval()).square().mean();
        CHECK(test::relative_error(found.along_x.integral(), rows) < 1e-12);
        CHECK(test::relative_error(found.along_y.integral(), sides) < 1e-12);
    }
}

TEST_CASE("The shells of a map whose waves end early hold its variance") {
    auto map = self_affine_map<double>(
        {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = 64e-6, .shortest_wavelength = 8e-6, .seed = 3}, 256, 256,
        1e-6, 1e-6);
    const auto found = radial_spectrum(map, SpectrumWindow::none);
    double variance = 0;
    const double unit = 2 * pi / 256e-6;
    for (std::size_t k = 0; k < found.value.size(); ++k)
        variance += found.value[k] * static_cast<double>(found.waves[k]) * unit * unit;
    CHECK(test::relative_error(std::sqrt(variance), 1e-6) < 1e-12);
    CHECK(test::relative_error(std::sqrt(variance), map_spectrum(map, Edges::periodic).rms_height) < 1e-12);
}

TEST_CASE("The sections of an isotropic map are the projection of its C(q)") {
    // C_x(q) = 4 int C(q') q'/sqrt(q'^2 - q^2) dq', with C straight between the shells; a mean over twelve maps
    const std::size_t maps = 12;
    std::vector<double> value(128), section(128), wavenumber(128);
    for (std::size_t seed = 1; seed <= maps; ++seed) {
        const auto map = self_affine_map<double>(
            {.hurst = 0.7, .rms = 1e-6, .longest_wavelength = 64e-6, .shortest_wavelength = 4e-6, .seed = seed}, 256,
            256, 1e-6, 1e-6);
        const auto found = radial_spectrum(map, SpectrumWindow::none);
        for (std::size_t k = 0; k < 128; ++k) {
            value[k] += found.value[k] / maps;
            wavenumber[k] = found.wavenumber[k];
            section[k] += (found.along_x.value[k] + found.along_y.value[k]) / 2 / maps;
        }
    }
    const double unit = 2 * pi / 256e-6;
    for (const std::size_t k : {3u, 7u, 15u, 31u}) {
        const double q = static_cast<double>(k + 1) * unit;
        double sum = 0;  // q'^2 = q^2 + s^2, q' dq'/s = ds
        const auto at = [&](double s) {
            const double to = std::hypot(q, s);
            std::size_t i = 0;
            while (i + 2 < 128 && wavenumber[i + 1] < to) ++i;
            const double part = std::clamp((to - wavenumber[i]) / (wavenumber[i + 1] - wavenumber[i]), 0.0, 1.0);
            return value[i] * (1 - part) + value[i + 1] * part;
        };
        for (double s = unit / 16; s < 128 * unit; s += unit / 8) sum += 4 * at(s) * unit / 8;
        CAPTURE(k, section[k], sum);
        // 24 sections of some 50 waves each scatter by 1/sqrt(1200), and the curvature of C between the shells remains
        CHECK(test::relative_error(sum, section[k]) < 0.15);
    }
}

TEST_CASE("Spectra of maps are those that numpy finds") {
    for (const std::string source : {"map_gaussian", "map_skewed", "map_oblong"})
        for (const auto window : {SpectrumWindow::hann, SpectrumWindow::none}) {
            CAPTURE(source, name_of(window));
            const auto found = radial_spectrum(test::reference_map(source), window);
            std::size_t compared = 0;
            for (const auto& [parameter, value] : test::roughness_reference(source)) {
                const std::string end = "_" + std::string(name_of(window)) + "_";
                const auto at = parameter.find(end);
                const std::size_t k = std::stoul("0" + parameter.substr(parameter.rfind('_') + 1));
                if (parameter.starts_with("psd_x" + end))
                    CHECK(test::relative_error(found.along_x.value[k - 1], value) < 1e-9);
                if (parameter.starts_with("psd_y" + end))
                    CHECK(test::relative_error(found.along_y.value[k - 1], value) < 1e-9);
                if (parameter.starts_with("psd" + end)) CHECK(test::relative_error(found.value[k - 1], value) < 1e-9);
                if (parameter.starts_with("q_")) CHECK(test::relative_error(found.wavenumber[k - 1], value) < 1e-12);
                compared += at != std::string::npos ? 1 : 0;
            }
            CHECK(compared >= 9);
        }
}

TEST_CASE("Maps with missing points have no spectrum") {
    CHECK(test::refusal([] {
              (void)radial_spectrum(test::reference_map("map_holes"));
          }).find("missing points: must be filled") != std::string::npos);
}

}  // namespace radial_spectrum_test
