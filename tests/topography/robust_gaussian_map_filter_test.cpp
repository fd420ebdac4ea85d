// SPDX-License-Identifier: BSD-3-Clause
// The robust filter of maps against the double sums of its definition, and its purpose.
#include <fstiff/topography/gaussian_map_filter.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <random>

namespace robust_gaussian_map_filter_test {

using namespace fstiff;

namespace {

HeightMap<double> rough(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    HeightMap<double> map{HeightMap<double>::Array(rows, columns), 1e-6, 1.5e-6};
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i)
            map.heights(j, i) = 1e-8 * (normal(random) + 5 * std::sin(0.1 * static_cast<double>(i + j)));
    return map;
}

HeightMap<double>::Array slow(const HeightMap<double>& map, double cutoff) {
    using Array = HeightMap<double>::Array;
    const double factor = std::pow(3.14159265358979323846, 2) / std::log(2.) / (cutoff * cutoff);
    const Eigen::Index n = map.size(), columns = map.columns();
    Array delta = map.heights.isNaN().select(0., Array::Ones(map.rows(), columns)), wave = map.heights, first;
    double previous = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
        std::vector<double> residuals;
        Array weight(map.rows(), columns);
        for (Eigen::Index p = 0; p < n; ++p) {
            if (std::isnan(map.heights.data()[p])) continue;
            double w = 0, z = 0;
            for (Eigen::Index q = 0; q < n; ++q) {
                if (delta.data()[q] == 0) continue;
                const double x = static_cast<double>(p % columns - q % columns) * map.dx;
                const double y = static_cast<double>(p / columns - q / columns) * map.dy;
                const double s = std::exp(-factor * (x * x + y * y)) * delta.data()[q];
                w += s;
                z += s * map.heights.data()[q];
            }
            weight.data()[p] = w;
            if (iteration == 0 || w >= 0.01 * first.data()[p]) wave.data()[p] = z / w;
            residuals.push_back(std::abs(map.heights.data()[p] - wave.data()[p]));
        }
        if (iteration == 0) first = weight;
        std::sort(residuals.begin(), residuals.end());
        const std::size_t m = residuals.size();
        const double c = 3 / 0.67448975019608174320 * (residuals[m / 2] + residuals[(m - 1) / 2]) / 2;
        if (std::abs(c - previous) <= 1e-4 * c) break;
        previous = c;
        for (Eigen::Index k = 0; k < n; ++k) {
            const double r = (map.heights.data()[k] - wave.data()[k]) / c;
            delta.data()[k] = std::abs(r) < 1 ? (1 - r * r) * (1 - r * r) : 0;
        }
    }
    return wave;
}

}  // namespace

TEST_CASE("The robust waviness of a map is that of the double sums, with spikes, a hole and missing points") {
    HeightMap<double> map = rough(32, 45, 3);
    for (Eigen::Index k = 5; k < map.size(); k += 23) map.heights.data()[k] += 3e-7;
    map.heights.block(10, 10, 6, 8) -= 1e-6;
    for (Eigen::Index k = 11; k < map.size(); k += 37) map.heights.data()[k] = std::nan("");
    const double size = rms_height(map);
    for (const double cutoff : {8e-6, 20e-6}) {
        const auto found = detail::robust_waviness(map, cutoff);
        CHECK(found.converged);
        const auto expected = slow(map, cutoff);
        for (Eigen::Index k = 0; k < map.size(); ++k) {
            REQUIRE(std::isnan(found.waviness.heights.data()[k]) == std::isnan(map.heights.data()[k]));
            if (!std::isnan(expected.data()[k]))
                REQUIRE(std::abs(found.waviness.heights.data()[k] - expected.data()[k]) < 1e-10 * size);
        }
    }
}

TEST_CASE("Grooves on a tenth of a map move the Gaussian mean surface, and not the robust one") {
    const HeightMap<double> clean = rough(100, 100, 9);
    HeightMap<double> struck = clean;
    for (Eigen::Index j = 0; j < 100; j += 10) struck.heights.row(j) -= 1e-6;
    const auto rms = [](const HeightMap<double>::Array& a) { return std::sqrt(a.square().mean()); };
    const auto robust = detail::robust_waviness(struck, 30e-6);
    const double moved = rms(robust.waviness.heights - detail::robust_waviness(clean, 30e-6).waviness.heights);
    CHECK(robust.left_out >= 1000);
    const double moved_gaussian =
        rms(detail::gaussian_low_pass(struck, 30e-6).heights - detail::gaussian_low_pass(clean, 30e-6).heights);
    CHECK(moved_gaussian > 9e-8);  // a tenth of the depth
    CHECK(moved < moved_gaussian / 40);
    CHECK_THROWS_AS(detail::robust_waviness(clean, 1e-6), domain_error);
}

}  // namespace robust_gaussian_map_filter_test
