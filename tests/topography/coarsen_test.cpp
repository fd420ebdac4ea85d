// SPDX-License-Identifier: BSD-3-Clause
// Truth: block means.
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/height_map.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace coarsen_test {

using namespace fstiff;

TEST_CASE("whole ratios are block means") {
    HeightMap<double> map;
    map.dx = 1e-6;
    map.dy = 2e-6;
    map.heights = Eigen::ArrayXXd::Random(12, 20);
    const auto coarse = detail::coarsened(map, 5, 4);
    CHECK(test::ulps(coarse.dx, 4e-6) <= 1);
    CHECK(test::ulps(coarse.dy, 6e-6) <= 1);
    for (Eigen::Index j = 0; j < 4; ++j)
        for (Eigen::Index i = 0; i < 5; ++i)
            CHECK(std::abs(coarse.heights(j, i) - map.heights.block(3 * j, 4 * i, 3, 4).mean()) < 1e-15);
}

TEST_CASE("any ratio is the mean over the area: each cell first cut into as many as make the ratio whole") {
    HeightMap<double> map;
    map.dx = map.dy = 1;
    map.heights = Eigen::ArrayXXd::Random(23, 37);
    const auto coarse = detail::coarsened(map, 10);
    REQUIRE(coarse.columns() == 10);
    REQUIRE(coarse.rows() == 6);
    CHECK(test::relative_error(coarse.area(), map.area()) < 1e-15);
    CHECK(std::abs(coarse.heights.mean() - map.heights.mean()) < 1e-14);
    for (Eigen::Index j = 0; j < 6; ++j)
        for (Eigen::Index i = 0; i < 10; ++i) {
            double sum = 0;
            for (Eigen::Index y = 23 * j; y < 23 * (j + 1); ++y)
                for (Eigen::Index x = 37 * i; x < 37 * (i + 1); ++x) sum += map.heights(y / 6, x / 10);
            CHECK(std::abs(coarse.heights(j, i) - sum / (23 * 37)) < 1e-14);
        }
    CHECK((detail::coarsened(map, 40).heights == map.heights).all());
}

TEST_CASE("maps that cannot be made coarser are refused") {
    HeightMap<double> map;
    map.dx = map.dy = 1;
    map.heights = Eigen::ArrayXXd::Random(5, 5);
    CHECK(test::refusal([&] { (void)detail::coarsened(map, 6, 5); }).find("columns") == 0);
    CHECK(test::refusal([&] { (void)detail::coarsened(map, 5, 0); }).find("rows") == 0);
    CHECK(test::refusal([&] { (void)detail::coarsened(map, 0); }).find("points") == 0);
    map.heights(2, 2) = std::nan("");
    CHECK(test::refusal([&] { (void)detail::coarsened(map, 2, 2); }).find("1 missing points") != std::string::npos);
}

}  // namespace coarsen_test
