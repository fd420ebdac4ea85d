// SPDX-License-Identifier: BSD-3-Clause
// Heights of one row are a profile; the entries of its record.
#include "io/reading.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace reading_test {

using namespace fstiff;
using namespace fstiff::io::detail;

namespace {

RawMap map_of(std::size_t rows, std::size_t columns) {
    RawMap map;
    allocate(map, rows, columns);
    for (std::size_t i = 0; i < map.heights.size(); ++i) map.heights[i] = static_cast<double>(i * i % 7);
    return map;
}

}  // namespace

TEST_CASE("one row without dy takes dx, more rows need a dy", "[reading]") {
    RawMap row = map_of(1, 20);
    set_spacings(row, 2e-6, 0, "file");
    CHECK((row.dx == 2e-6 && row.dy == 2e-6));
    RawMap map = map_of(3, 4);
    set_spacings(map, 2e-6, 3e-6, "file");
    CHECK(map.dy == 3e-6);
    CHECK(test::refusal([&] { set_spacings(map, 2e-6, 0, "file"); }).find("file: ") == 0);
}

TEST_CASE("heights of one row become a profile, of more rows a map", "[reading]") {
    RawMap row = map_of(1, 20);
    set_spacings(row, 2e-6, 0, "file");
    const io::Surface profile = surface_of({row, {}});
    REQUIRE(profile.is_profile());
    CHECK(profile.profile().spacing == 2e-6);
    CHECK(profile.profile().heights == row.heights);
    CHECK_FALSE(test::refusal([&] { validate_map(row, 21); }).empty());
    RawMap map = map_of(3, 4);
    set_spacings(map, 2e-6, 3e-6, "file");
    const HeightMap<double> of_rows = surface_of({map, {}}).map();
    REQUIRE((of_rows.rows() == 3 && of_rows.columns() == 4));
    CHECK((of_rows.dx == 2e-6 && of_rows.dy == 3e-6));
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i) CHECK(of_rows.heights(j, i) == (4 * j + i) * (4 * j + i) % 7);
}

TEST_CASE("a record lists its entries in their order and counts missing points", "[reading]") {
    RawMap map = map_of(3, 4);
    map.heights[5] = std::numeric_limits<double>::quiet_NaN();
    io::Record record;
    record.note("form", "a form");
    record.note_points(map, " (note)");
    record.say_trailer(0);
    record.say_trailer(7);
    CHECK(record.sentences() == std::vector<std::string>{"form: a form", "points: 4 x 3, of which 1 missing (note)",
                                                         "trailer: 7 bytes, not read"});
    CHECK(record.missing == 1);
    CHECK(record.said("form") == "a form");
    CHECK(record.said("units").empty());
    io::Record other;
    other.say_points_of_profile(map_of(1, 20));
    CHECK(other.said("points") == "20, of which 0 missing");
}

}  // namespace reading_test
