// SPDX-License-Identifier: BSD-3-Clause
// Holes are filled by the heights that are harmonic in five points; spikes are found where they were put.
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/map_repair.hpp>

#include "support/catch.hpp"

#include <random>

namespace repair_test {

using namespace fstiff;

TEST_CASE("A hole in a surface that is harmonic in five points is filled by that surface") {
    HeightMap<double> map{HeightMap<double>::Array(40, 50), 1e-6, 2e-6};
    for (Eigen::Index j = 0; j < 40; ++j)
        for (Eigen::Index i = 0; i < 50; ++i) {
            const double x = static_cast<double>(i) * 1e-6, y = static_cast<double>(j) * 2e-6;
            map.heights(j, i) = 1e-3 * (x + 2 * y) + 50 * (x * x - y * y) + 20 * x * y;
        }
    const auto whole = map.heights;
    map.heights.block(5, 6, 20, 17).setConstant(std::nan(""));
    map.heights.block(30, 30, 4, 4).setConstant(std::nan(""));
    map.heights(36, 3) = std::nan("");
    const auto repair = detail::fill_missing(map);
    CHECK(repair.missing == 340 + 16 + 1);
    CHECK(repair.longest == 340);
    CHECK((map.heights - whole).abs().maxCoeff() < 1e-10 * (whole.maxCoeff() - whole.minCoeff()));
}

TEST_CASE("At the edges the filled surface goes on level, and a map without heights is refused") {
    HeightMap<double> map{HeightMap<double>::Array::Constant(6, 8, std::nan("")), 1e-6, 1e-6};
    CHECK_THROWS_AS(detail::fill_missing(map), domain_error);
    map.heights.col(0).setConstant(0);
    map.heights.col(4).setConstant(4e-9);
    CHECK(detail::fill_missing(map).longest == 18);
    for (Eigen::Index i = 0; i < 8; ++i)
        CHECK((map.heights.col(i) - 1e-9 * static_cast<double>(std::min<Eigen::Index>(i, 4))).abs().maxCoeff() < 1e-21);
    CHECK(detail::fill_missing(map).missing == 0);
}

TEST_CASE("Spikes of a map are taken out, and of Gaussian roughness less than 1e-4") {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    HeightMap<double> map{HeightMap<double>::Array(300, 300), 1e-6, 1e-6};
    for (Eigen::Index k = 0; k < map.size(); ++k) map.heights.data()[k] = 1e-8 * normal(random);
    CHECK(detail::find_spikes(map, 5, false).removed < 9);
    for (Eigen::Index j = 10; j < 300; j += 30) map.heights(j, 17) = 2e-7;
    CHECK(detail::find_spikes(map, 8).removed == 10);
    for (Eigen::Index j = 10; j < 300; j += 30) CHECK(std::isnan(map.heights(j, 17)));
}

}  // namespace repair_test
