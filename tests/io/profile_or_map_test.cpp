// SPDX-License-Identifier: BSD-3-Clause
// A map of one row is a profile.
#include "io/profile_or_map.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace profile_or_map_test {

using namespace fstiff;
using namespace fstiff::io::detail;

namespace {

HeightMap<double> map_of(Eigen::Index rows, Eigen::Index columns) {
    HeightMap<double> map;
    map.heights.resize(rows, columns);
    for (Eigen::Index i = 0; i < map.size(); ++i) map.heights.data()[i] = static_cast<double>(i * i % 7);
    return map;
}

}  // namespace

TEST_CASE("one row without dy takes dx, more rows need a dy", "[profile_or_map]") {
    HeightMap<double> row = map_of(1, 20);
    set_spacings(row, 2e-6, 0, "file");
    CHECK((row.dx == 2e-6 && row.dy == 2e-6));
    HeightMap<double> map = map_of(3, 4);
    set_spacings(map, 2e-6, 3e-6, "file");
    CHECK(map.dy == 3e-6);
    CHECK(test::refusal([&] { set_spacings(map, 2e-6, 0, "file"); }).find("file: ") == 0);
}

TEST_CASE("one row is a profile of 16 points at least, more rows are a map", "[profile_or_map]") {
    HeightMap<double> row = map_of(1, 20);
    set_spacings(row, 2e-6, 0, "file");
    const io::ProfileOrMap profile = as_surface(row, "file");
    REQUIRE(profile.index() == 0);
    CHECK(std::get<0>(profile).spacing == 2e-6);
    CHECK(std::get<0>(profile).heights[3] == 2);
    CHECK(as_surface(map_of(3, 4), "file").index() == 1);
    HeightMap<double> few = map_of(1, 5);
    set_spacings(few, 2e-6, 0, "file");
    CHECK(test::refusal([&] { (void)as_surface(few, "file"); }).find("file: ") == 0);
}

}  // namespace profile_or_map_test
