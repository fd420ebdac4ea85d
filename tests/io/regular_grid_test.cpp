// SPDX-License-Identifier: BSD-3-Clause
// Grids that are made here, with points left out and positions rounded, must be found again.
#include "io/regular_grid.hpp"

#include "io/row_layout.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace regular_grid_test {

using namespace fstiff::io::detail;

TEST_CASE("an axis is found through missing lines and rounded positions", "[regular_grid]") {
    const auto exact = axis_of({0, 1, 2, 5, 6}, 0.01);
    REQUIRE(exact);
    CHECK(exact->step == 1);
    CHECK(exact->count == 7);
    CHECK(exact->index(5) == 5);
    const auto rounded = axis_of({0.0, 0.3, 0.7, 1.0, 1.3, 1.7, 2.0}, 0.1);  // thirds
    REQUIRE(rounded);
    CHECK(test::ulps(rounded->step, 1.0 / 3) <= 4);
    CHECK_FALSE(axis_of({0, 1, 2.5, 3, 4.2}, 1e-6));
    CHECK_FALSE(axis_of({1, 1, 1}, 0.1));
}

TEST_CASE("heights go to their points, and no point is listed twice", "[regular_grid]") {
    NumberTable table = open_table("1 0 5\n0 0 4\n0 2 6\n", "file");
    read_rows(table, "file");
    const auto grid = grid_of(table);
    REQUIRE(grid);
    const auto heights = heights_on(*grid, table, column_of(table, 2), "file");
    REQUIRE(heights.size() == 4);
    CHECK(heights[0] == 4);
    CHECK(heights[1] == 5);
    CHECK(heights[2] == 6);
    CHECK(std::isnan(heights[3]));
    NumberTable twice = open_table("0 0 1\n1 0 2\n0 1 3\n1 0 4\n", "file");
    read_rows(twice, "file");
    CHECK(test::refusal([&] { (void)heights_on(*grid_of(twice), twice, column_of(twice, 2), "file"); }) ==
          "file, line 4: repeats the point of line 2, x = 1, y = 0; every point must come once");
}

}  // namespace regular_grid_test
