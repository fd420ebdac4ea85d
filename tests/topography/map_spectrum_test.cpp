// SPDX-License-Identifier: BSD-3-Clause
// Truth: maps of few waves, whose spectrum is known; Parseval's sum; sums of cosines written out; the mirrored map
// written out.
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace map_spectrum_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi;

HeightMap<double> random_map(Eigen::Index rows, Eigen::Index columns, double dx = 1e-6, double dy = 1.5e-6) {
    HeightMap<double> map;
    map.dx = dx;
    map.dy = dy;
    map.heights = 3e-6 + 1e-7 * Eigen::ArrayXXd::Random(rows, columns);
    return map;
}

/// A map of waves longer than the map: 0.37 of one along x, 0.81 along y, and a tilt.
HeightMap<double> long_waved_map(Eigen::Index rows, Eigen::Index columns) {
    HeightMap<double> map = random_map(rows, columns);
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(columns);
            const double y = static_cast<double>(j) / static_cast<double>(rows);
            map.heights(j, i) += 2e-6 * std::sin(2 * pi * 0.37 * x + 1) + 1e-6 * std::cos(2 * pi * 0.81 * y) + 5e-7 * x;
        }
    return map;
}

/// Sq, summed in another order and precision.
double rms_of(const HeightMap<double>& map) {
    const auto z = map.heights.cast<long double>().eval();
    return static_cast<double>(std::sqrt((z - z.mean()).square().mean()));
}

/// The map and its mirror images, which repeat themselves.
HeightMap<double> with_mirror_images(const HeightMap<double>& map) {
    HeightMap<double> whole = map;
    whole.heights.resize(2 * map.rows(), 2 * map.columns());
    whole.heights << map.heights, map.heights.rowwise().reverse(), map.heights.colwise().reverse(),
        map.heights.reverse();
    return whole;
}

/// The shells by the definition, one wave and one point after the other.
SpectrumShells<double> slow_spectrum(const HeightMap<double>& map) {
    const Eigen::Index rows = map.rows(), columns = map.columns();
    const double width = static_cast<double>(columns) * map.dx, height = static_cast<double>(rows) * map.dy;
    std::map<long, SpectrumShells<double>::Shell> shells;
    double squares = 0;
    for (Eigen::Index l = 0; l < rows; ++l)
        for (Eigen::Index k = 0; k < columns; ++k) {
            if (k + l == 0) continue;
            double h = 0;
            for (Eigen::Index j = 0; j < rows; ++j)
                for (Eigen::Index i = 0; i < columns; ++i)
                    h += map.heights(j, i) *
                         std::cos(pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) /
                                  static_cast<double>(columns)) *
                         std::cos(pi * static_cast<double>(l) * (static_cast<double>(j) + 0.5) /
                                  static_cast<double>(rows));
            h /= static_cast<double>(map.size());
            const double square = h * h * (k > 0 ? 2 : 1) * (l > 0 ? 2 : 1);
            const double q = pi * std::hypot(static_cast<double>(k) / width, static_cast<double>(l) / height);
            auto& shell = shells[std::lround(q / pi * std::max(width, height) * (1 + 1e-12))];
            shell.q2_h2 += q * q * square;
            shell.q_h2 += q * square;
            squares += square;
        }
    SpectrumShells<double> spectrum;
    for (const auto& [i, shell] : shells) spectrum.shells.push_back(shell);
    spectrum.rms_height = std::sqrt(squares);
    return spectrum;
}

void check_same(const SpectrumShells<double>& a, const SpectrumShells<double>& b, double tolerance) {
    CHECK(test::relative_error(a.rms_height, b.rms_height) < tolerance);
    REQUIRE(a.shells.size() == b.shells.size());
    double worst = 0;
    for (std::size_t k = 0; k < a.shells.size(); ++k)
        worst = std::max({worst, test::relative_error(a.shells[k].q2_h2, b.shells[k].q2_h2),
                          test::relative_error(a.shells[k].q_h2, b.shells[k].q_h2)});
    CHECK(worst < tolerance);
}

}  // namespace

TEST_CASE("each wave of a periodic map is in its shell") {
    for (const Eigen::Index columns : {48, 53, 101}) {
        const Eigen::Index rows = 40;
        HeightMap<double> map;
        map.dx = 2e-6 / static_cast<double>(columns);
        map.dy = 2e-6 / static_cast<double>(rows);
        map.heights.resize(rows, columns);
        const double turn = 2 * pi;
        for (Eigen::Index j = 0; j < rows; ++j)
            for (Eigen::Index i = 0; i < columns; ++i) {
                const double x = static_cast<double>(i) / static_cast<double>(columns);
                const double y = static_cast<double>(j) / static_cast<double>(rows);
                map.heights(j, i) = 7e-6 + 3e-9 * std::cos(turn * 3 * x) + 2e-9 * std::sin(turn * (4 * x - 6 * y)) +
                                    1e-9 * std::cos(turn * 11 * y);
            }
        const auto spectrum = map_spectrum(map, Edges::periodic);
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

TEST_CASE("The spectrum adds up to the variance, whatever the heights, the longest waves and the sides") {
    for (const auto& [rows, columns] : {std::pair(45, 64), std::pair(37, 53), std::pair(101, 6), std::pair(4, 4),
                                        std::pair(5, 128), std::pair(96, 96)})
        for (const HeightMap<double>& map : {random_map(rows, columns), long_waved_map(rows, columns)})
            for (const Edges edges : {Edges::mirrored, Edges::periodic}) {
                CAPTURE(rows, columns, name_of(edges));
                CHECK(test::relative_error(map_spectrum(map, edges).rms_height, rms_of(map)) < 1e-13);
            }
}

TEST_CASE("The spectrum of a map that does not repeat itself is the sum of cosines, shell by shell") {
    for (const auto& [rows, columns] : {std::pair(12, 16), std::pair(13, 11), std::pair(7, 30), std::pair(16, 16)}) {
        CAPTURE(rows, columns);
        const HeightMap<double> map = long_waved_map(rows, columns);
        check_same(map_spectrum(map), slow_spectrum(map), 1e-11);
    }
}

TEST_CASE("The spectrum of a map is that of the map with its mirror images, which repeats itself") {
    for (const auto& [rows, columns] : {std::pair(24, 40), std::pair(31, 17)}) {
        CAPTURE(rows, columns);
        const HeightMap<double> map = long_waved_map(rows, columns), whole = with_mirror_images(map);
        auto repeated = map_spectrum(whole, Edges::periodic);
        std::erase_if(repeated.shells, [](const auto& shell) { return shell.q2_h2 < 1e-20; });  // zigzags: none
        check_same(map_spectrum(map), repeated, 1e-10);
    }
}

TEST_CASE("A spectrum depends neither on the unit of length nor on the orientation of the map") {
    const Edges edges = GENERATE(Edges::mirrored, Edges::periodic);
    for (const Eigen::Index columns : {44, 30, 53}) {  // of 30 some waves lie half way between two shells
        const HeightMap<double> map = long_waved_map(30, columns);
        CAPTURE(name_of(edges), columns);
        const auto spectrum = map_spectrum(map, edges);
        for (const double factor : {1e-9, 1e9}) {
            HeightMap<double> other = map;
            other.heights *= factor, other.dx *= factor, other.dy *= factor;
            const auto found = map_spectrum(other, edges);
            REQUIRE(found.shells.size() == spectrum.shells.size());
            double worst = test::relative_error(found.rms_height, factor * spectrum.rms_height);
            for (std::size_t k = 0; k < found.shells.size(); ++k)
                worst = std::max({worst, test::relative_error(found.shells[k].q2_h2, spectrum.shells[k].q2_h2),
                                  test::relative_error(found.shells[k].q_h2, factor * spectrum.shells[k].q_h2)});
            CHECK(worst < 1e-11);
        }
        HeightMap<double> turned = map, mirrored = map;
        turned.heights = map.heights.transpose().rowwise().reverse().eval();
        std::swap(turned.dx, turned.dy);
        mirrored.heights = map.heights.rowwise().reverse().eval();
        check_same(map_spectrum(turned, edges), spectrum, 1e-10);
        check_same(map_spectrum(mirrored, edges), spectrum, 1e-10);
    }
}

TEST_CASE("Mirror images take the step between opposite edges away, and leave sigma as it is") {
    HeightMap<double> map;
    map.dx = map.dy = 1e-6;
    map.heights.resize(128, 128);
    for (Eigen::Index i = 0; i < 128; ++i)  // 1.5 waves: a step of two amplitudes at the edge
        map.heights.col(i) = 1e-8 * std::cos(3 * pi * (static_cast<double>(i) + 0.5) / 128);
    const double truth = 1e-8 * 3 * pi / 128e-6 / std::sqrt(2.0);
    CHECK(map_spectrum(map, Edges::periodic).rms_gradient() > 4 * truth);
    CHECK(test::relative_error(map_spectrum(map).rms_gradient(), truth) < 1e-12);
    CHECK(test::relative_error(map_spectrum(map).rms_height, 1e-8 / std::sqrt(2.0)) < 1e-12);
}

TEST_CASE("maps without a spectrum are refused") {
    HeightMap<double> map;
    map.dx = map.dy = 1;
    map.heights = Eigen::ArrayXXd::Random(8, 8);
    map.heights(3, 3) = std::nan("");
    for (const Edges edges : {Edges::mirrored, Edges::periodic})
        CHECK(test::refusal([&] { (void)map_spectrum(map, edges); }).find("1 missing points") != std::string::npos);
}

}  // namespace map_spectrum_test
