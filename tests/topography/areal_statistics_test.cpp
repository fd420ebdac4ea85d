// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <array>
#include <numbers>

namespace areal_statistics_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

HeightMap<double> gaussian(std::size_t columns, std::size_t rows, double shortest, std::uint64_t seed,
                           double spacing = 1e-6) {
    return self_affine_map<double>({.hurst = 0.8,
                                    .rms = 1e-6,
                                    .longest_wavelength = 4 * shortest,
                                    .shortest_wavelength = shortest,
                                    .exact_rms = false,
                                    .seed = seed},
                                   columns, rows, spacing, spacing);
}

/// Largest relative difference of two results; lengths of \p b in another unit.
double difference(const ArealStatistics<double>& a, const ArealStatistics<double>& b, double unit = 1) {
    double worst = a.summits == b.summits && a.inner == b.inner ? 0 : HUGE_VAL;
    const auto compare = [&](double x, double y) { worst = std::max(worst, test::relative_error(y, x)); };
    compare(a.rms_height * unit, b.rms_height);
    compare(a.m0 * unit * unit, b.m0);
    compare(a.m2, b.m2);
    compare(a.m4 / unit / unit, b.m4);
    compare(a.nayak, b.nayak);
    compare(a.rms_gradient, b.rms_gradient);
    compare(a.summit_density / unit / unit, b.summit_density);
    compare(a.summit_curvature / unit, b.summit_curvature);
    compare(a.summit_height * unit, b.summit_height);
    return worst;
}

}  // namespace

TEST_CASE("Cosines have the summits and curvatures of the closed form") {
    // z = A cos cos with a crest on every 20th column and every 16th row: the finite differences in closed form
    constexpr double height = 1e-7, dx = 1e-6, dy = 2e-6;
    HeightMap<double> map{HeightMap<double>::Array(8 * 16 + 1, 6 * 20 + 1), dx, dy};
    constexpr double pi2 = 2 * std::numbers::pi;
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i)
            map.heights(j, i) = height * std::cos(pi2 * static_cast<double>(i % 20) / 20) *
                                std::cos(pi2 * static_cast<double>(j % 16) / 16);
    const auto s = detail::areal_statistics(map);
    // crests of both cosines inside the border, 5 x 7, and troughs of both, 6 x 8
    CHECK(s.summits == 5 * 7 + 6 * 8);
    CHECK(s.inner == 119 * 127);
    CHECK(test::relative_error(s.summit_density, 83 / (119 * 127 * dx * dy)) <= 1e-15);
    const double bend_x = 2 * height * (1 - std::cos(pi2 / 20)) / dx / dx;
    const double bend_y = 2 * height * (1 - std::cos(pi2 / 16)) / dy / dy;
    CHECK(test::relative_error(s.summit_curvature, (bend_x + bend_y) / 2) <= 1e-13);
    CHECK(std::abs(s.summit_height + s.mean_height - height) <= 1e-14 * height);
    // Along x: mean sin^2 over 120 steps of whole periods is 1/2; mean cos^2 over 129 rows of 8 periods and one crest
    // is (64 + 1)/129. Second differences: inner points, 119 of 120 of the periods, a crest left out.
    const double slope_x = 2 * height * std::sin(pi2 / 40) / dx;
    CHECK(test::relative_error(s.m2_x, slope_x * slope_x / 2 * 65 / 129) <= 1e-13);
    CHECK(test::relative_error(s.m4_x, bend_x * bend_x * 59 / 119 * 65 / 129) <= 1e-13);
    const double slope_y = 2 * height * std::sin(pi2 / 32) / dy;
    CHECK(test::relative_error(s.m2_y, slope_y * slope_y / 2 * 61 / 121) <= 1e-13);
    CHECK(test::relative_error(s.m4_y, bend_y * bend_y * 63 / 127 * 61 / 121) <= 1e-13);
    CHECK(s.m2 == (s.m2_x + s.m2_y) / 2);
    CHECK(s.m4 == (s.m4_x + s.m4_y) / 2);
    CHECK(test::relative_error(s.rms_gradient * s.rms_gradient, s.m2_x + s.m2_y) <= 1e-15);
}

TEST_CASE("A paraboloid has the moments of the closed form, m4 and Nayak's alpha with them") {
    // z = (p x^2 + q y^2)/2 at x/dx = -3 to 3, y/dy = -4 to 4: second differences are p and q everywhere, first ones p
    // dx and q dy times half-odd numbers, whose mean squares are 35/12 and 21/4; i^2 has the variances 12 and 308/9
    constexpr double p = 3e4, q = 7e4, dx = 1e-6, dy = 2e-6;
    HeightMap<double> map{HeightMap<double>::Array(9, 7), dx, dy};
    for (Eigen::Index j = 0; j < 9; ++j)
        for (Eigen::Index i = 0; i < 7; ++i) {
            const double x = dx * static_cast<double>(i - 3), y = dy * static_cast<double>(j - 4);
            map.heights(j, i) = (p * x * x + q * y * y) / 2;
        }
    const double a = p * dx * dx / 2, b = q * dy * dy / 2;
    const double m0 = a * a * 12 + b * b * 308 / 9, m4 = (p * p + q * q) / 2;
    const double m2 = (p * p * dx * dx * 35 / 12 + q * q * dy * dy * 21 / 4) / 2;
    const auto s = detail::areal_statistics(map);
    CHECK(test::relative_error(s.m0, m0) <= 1e-13);
    CHECK(test::relative_error(s.m2, m2) <= 1e-13);
    CHECK(test::relative_error(s.m4_x, p * p) <= 1e-13);
    CHECK(test::relative_error(s.m4_y, q * q) <= 1e-13);
    CHECK(test::relative_error(s.m4, m4) <= 1e-13);
    CHECK(test::relative_error(s.nayak, m0 * m4 / (m2 * m2)) <= 1e-13);
    CHECK(s.summits == 0);
}

TEST_CASE("Slopes along x are the structure functions of the rows, whatever is missing") {
    auto map = gaussian(80, 60, 6e-6, 3);
    for (Eigen::Index k = 0; k < map.size(); k += 7 + k % 5) map.heights.data()[k] = missing;
    const auto s = detail::areal_statistics(map);
    long double sum = 0, pairs = 0;
    for (Eigen::Index j = 0; j < map.rows(); ++j) {
        const Profile<double> row{{map.heights.row(j).begin(), map.heights.row(j).end()}, map.dx};
        const std::size_t lag = 1;
        const auto f = structure_function(row, std::span<const std::size_t>(&lag, 1));
        sum += static_cast<long double>(f.value[0]) * static_cast<long double>(f.pairs[0]);
        pairs += static_cast<long double>(f.pairs[0]);
    }
    CHECK(test::relative_error(s.m2_x, static_cast<double>(sum / pairs) / map.dx / map.dx) <= 1e-13);
    CHECK(s.inner < 58 * 78 / 2);
}

TEST_CASE("A Gaussian map has the summits of Longuet-Higgins and Nayak") {
    constexpr std::size_t n = 512;
    constexpr double shortest = 16e-6;
    // The moments that finite differences have on the mean of all seeds, as sums over the spectrum written out again.
    double m0 = 0, m2 = 0, m4 = 0;
    const double side = n * 1e-6;
    for (int kx = -64; kx <= 64; ++kx)
        for (int ky = -64; ky <= 64; ++ky) {
            const double q = std::hypot(kx, ky) / side;
            if (q == 0 || q > 1.0000001 / shortest) continue;
            const double w = std::pow(std::max(q, 1 / (4 * shortest)), -3.6);
            const double s = 2 * std::sin(std::numbers::pi * kx / static_cast<double>(n)) / 1e-6;  // x alone: isotropic
            m0 += w;
            m2 += w * s * s;
            m4 += w * s * s * s * s;
        }
    m2 *= 1e-12 / m0;
    m4 *= 1e-12 / m0;
    ArealStatistics<double> mean{};
    constexpr int seeds = 6;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto s = detail::areal_statistics(gaussian(n, n, shortest, seed));
        mean.m0 += s.m0 / seeds;
        mean.m2 += s.m2 / seeds;
        mean.m4 += s.m4 / seeds;
        mean.summit_density += s.summit_density / seeds;
        mean.summit_curvature += s.summit_curvature / seeds;
        mean.summit_height += s.summit_height / seeds;
    }
    // 6 maps of 8 x 8 of the longest waves: the variance is known to sqrt(2/(6 * 2 * pi * 64)) = 3 %, m4, of waves four
    // times as short, to 1 %
    CAPTURE(mean.m0 / 1e-12, mean.m2 / m2, mean.m4 / m4);
    CHECK(test::relative_error(mean.m0, 1e-12) <= 0.1);
    CHECK(test::relative_error(mean.m2, m2) <= 0.06);
    CHECK(test::relative_error(mean.m4, m4) <= 0.04);
    const double density = mean.m4 / mean.m2 / (6 * std::numbers::pi * std::sqrt(3.0));
    const double curvature = 8 * std::sqrt(mean.m4 / std::numbers::pi) / 3;
    const double height = 4 * std::sqrt(mean.m0 / (std::numbers::pi * mean.m0 * mean.m4 / (mean.m2 * mean.m2)));
    CAPTURE(mean.summit_density / density, mean.summit_curvature / curvature, mean.summit_height / height);
    // some 6000 summits: 1 %; the eight neighbours replace a neighbourhood: 1 to 2 % more at 16 samples a wave
    CHECK(test::relative_error(mean.summit_density, density) <= 0.04);
    CHECK(test::relative_error(mean.summit_curvature, curvature) <= 0.03);
    CHECK(test::relative_error(mean.summit_height, height) <= 0.06);
}

TEST_CASE("A map turned, lifted or in another unit has the same statistics") {
    auto map = gaussian(90, 70, 8e-6, 4);
    map.dy = 1.7e-6;
    const auto here = detail::areal_statistics(map);
    const auto turned = detail::areal_statistics(HeightMap<double>{map.heights.transpose(), map.dy, map.dx});
    CHECK(difference(here, turned) <= 1e-13);
    CHECK(test::relative_error(turned.m2_x, here.m2_y) <= 1e-13);
    CHECK(test::relative_error(turned.m4_y, here.m4_x) <= 1e-13);
    for (const double unit : {1e9, 1e-9})
        CHECK(difference(here,
                         detail::areal_statistics(HeightMap<double>{map.heights * unit, map.dx * unit, map.dy * unit}),
                         unit) <= 1e-12);
    // rounded to what an offset of 1e6 times the roughness leaves, so that the lift itself loses nothing
    const HeightMap<double> rounded{(map.heights * 0x1p50).round() * 0x1p-50, map.dx, map.dy};
    CHECK(difference(detail::areal_statistics(rounded),
                     detail::areal_statistics(HeightMap<double>{rounded.heights + 1.0, map.dx, map.dy})) <= 1e-13);
}

#ifdef FSTIFF_MORE_TESTS
TEST_CASE("A map in float has the same statistics") {
    const auto map = gaussian(60, 50, 8e-6, 5);
    const auto narrow = map.heights.cast<float>().eval();
    const auto s = detail::areal_statistics(HeightMap<float>{narrow, 1e-6f, 1e-6f});
    const auto truth = detail::areal_statistics(HeightMap<double>{narrow.cast<double>(), double(1e-6f), double(1e-6f)});
    const double allowed = 10.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
    CHECK(test::relative_error(static_cast<double>(s.m4), truth.m4) <= allowed);
    CHECK(test::relative_error(static_cast<double>(s.rms_height), truth.rms_height) <= allowed);
    CHECK(test::relative_error(static_cast<double>(s.nayak), truth.nayak) <= allowed);
    CHECK(s.summits == truth.summits);
}
#endif

TEST_CASE("Points at the border next to missing ones and on plateaus are no summits") {
    HeightMap<double> map{HeightMap<double>::Array::Zero(7, 9), 1, 1};
    map.heights(0, 0) = map.heights(3, 0) = 5;  // at the border
    map.heights(2, 3) = 3;                      // a summit
    map.heights(5, 6) = map.heights(5, 7) = 2;  // a plateau
    const auto s = detail::areal_statistics(map);
    CHECK(s.summits == 1);
    CHECK(s.inner == 5 * 7);
    CHECK(s.summit_curvature == 6);  // (2 * 3 + 2 * 3)/2
    map.heights(1, 2) = missing;
    const auto holed = detail::areal_statistics(map);
    CHECK(holed.summits == 0);
    CHECK(holed.summit_density == 0);
    CHECK(holed.summit_curvature == 0);
    CHECK(holed.inner == 5 * 7 - 6);  // the hole and its neighbours of rows 1 to 2 and columns 1 to 3
}

TEST_CASE("Maps that have no statistics are refused") {
    const auto says = [](const HeightMap<double>& map) {
        return test::refusal([&] { (void)detail::areal_statistics(map); });
    };
    HeightMap<double> map{HeightMap<double>::Array::Zero(8, 8), 1e-6, 1e-6};
    CHECK(says(map).find("map of constant height") == 0);
    for (Eigen::Index i = 0; i < 8; ++i) map.heights.col(i).setConstant(static_cast<double>(i));
    CHECK(says(map).find("moment of the map = 0") == 0);
    map = gaussian(8, 8, 3e-6, 1);
    for (Eigen::Index i = 0; i < 8; i += 2) map.heights.col(i).setConstant(missing);
    CHECK(says(map).find("map has 0 triples of neighbouring points along x") == 0);
    map = gaussian(8, 8, 3e-6, 1);
    map.heights *= 1e-200;
    CHECK(says(map).find("moment of the map = ") == 0);
    map.dy = missing;
    CHECK(says(map).find("dy = ") == 0);
}

TEST_CASE("Sines have the mean square curvature of the second difference, exactly") {
    // a wave of phase k i + l j has second differences -4 sin^2(k/2) of it along x. Over whole periods of triples their
    // squares are half of that, and waves of other k do not mix: one period of the triples is two points less than the
    // map.
    struct Wave {
        double amplitude;
        int periods_x, periods_y;
    };
    constexpr double dx = 0.4e-6, dy = 0.7e-6;
    constexpr int columns = 98, rows = 74;
    const std::array<Wave, 4> waves{{{3e-7, 1, 5}, {1e-7, 7, -2}, {0.4e-7, 13, 9}, {0.1e-7, 31, 23}}};
    HeightMap<double> map{HeightMap<double>::Array::Constant(rows, columns, 2e-6), dx, dy};
    double m4_x = 0, m4_y = 0;
    const auto bend = [](double phase, double step) { return 4 * std::pow(std::sin(phase / 2), 2) / (step * step); };
    for (const Wave& wave : waves) {
        const double k = 2 * std::numbers::pi * wave.periods_x / (columns - 2);
        const double l = 2 * std::numbers::pi * wave.periods_y / (rows - 2);
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) map.heights(j, i) += wave.amplitude * std::sin(k * i + l * j + 0.3);
        m4_x += std::pow(wave.amplitude * bend(k, dx), 2) / 2;
        m4_y += std::pow(wave.amplitude * bend(l, dy), 2) / 2;
    }
    const auto found = detail::areal_statistics(map);
    CHECK(test::relative_error(found.m4_x, m4_x) <= 1e-13);
    CHECK(test::relative_error(found.m4_y, m4_y) <= 1e-13);
    CHECK(test::relative_error(found.m4, (m4_x + m4_y) / 2) <= 1e-13);
}

}  // namespace areal_statistics_test
