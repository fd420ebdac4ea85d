// SPDX-License-Identifier: BSD-3-Clause
// Truth: the lower face written out with its mirror images.
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/sum_of_maps.hpp>

#include "support/catch.hpp"

namespace shifted_sum_test {

using namespace fstiff;

namespace {

HeightMap<double> map_of(Eigen::Index rows, Eigen::Index columns) {
    HeightMap<double> map;
    map.dx = 1e-6, map.dy = 2e-6;
    map.heights = Eigen::ArrayXXd::Random(rows, columns);
    return map;
}

}  // namespace

TEST_CASE("a shifted sum is that with the lower map mirrored at its edges") {
    const auto upper = map_of(5, 7), lower = map_of(5, 7);
    Eigen::ArrayXXd tiled(20, 28);  // two periods each way
    for (Eigen::Index j = 0; j < 2; ++j)
        for (Eigen::Index i = 0; i < 2; ++i) {
            tiled.block(10 * j, 14 * i, 5, 7) = lower.heights;
            tiled.block(10 * j, 14 * i + 7, 5, 7) = lower.heights.rowwise().reverse();
            tiled.block(10 * j + 5, 14 * i, 5, 7) = lower.heights.colwise().reverse();
            tiled.block(10 * j + 5, 14 * i + 7, 5, 7) = lower.heights.reverse();
        }
    for (Eigen::Index j = 0; j < 10; ++j)
        for (Eigen::Index i = 0; i < 14; ++i)
            CHECK((detail::shifted_sum(upper, lower, j - 10, i + 14).heights == upper.heights + tiled.block(j, i, 5, 7))
                      .all());
}

TEST_CASE("random shifts are those of the seed, and each other") {
    const auto upper = map_of(16, 16), lower = map_of(16, 16);
    std::uint64_t state = 7, again = 7;
    const auto first = detail::random_sum(upper, lower, state), second = detail::random_sum(upper, lower, state);
    CHECK((first.heights == detail::random_sum(upper, lower, again).heights).all());
    CHECK((second.heights == detail::random_sum(upper, lower, again).heights).all());
    CHECK(!(first.heights == second.heights).all());
}

TEST_CASE("a missing point is missing in the sum, and maps of two grids have none") {
    auto upper = map_of(8, 8), lower = map_of(8, 8);
    lower.heights(2, 3) = std::nan("");
    const auto sum = detail::shifted_sum(upper, lower, 1, 0);
    CHECK(std::isnan(sum.heights(1, 3)));
    CHECK(sum.present() == 63);
    CHECK(detail::no_sum_of(upper, map_of(8, 9)) == "the maps have 8 x 8 points and 9 x 8 points");
    lower.dy *= 1.001;
    CHECK(detail::no_sum_of(upper, lower) == "the points of the maps are not equally far apart");
    CHECK_THROWS_AS(detail::shifted_sum(upper, lower, 0, 0), domain_error);
}

}  // namespace shifted_sum_test
