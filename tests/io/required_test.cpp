// SPDX-License-Identifier: BSD-3-Clause
// Truth: what the comments of the header allow.
#include "io/required.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <limits>

namespace required_test {

using namespace fstiff::io::detail;
using test::refused_for;

TEST_CASE("Counts, steps, units and numbers of a file are taken, or refused by their name") {
    CHECK(require_count("a.x", "rows", 1) == 1);
    CHECK(require_count("a.x", "rows", 4294967295.0) == 4294967295);
    CHECK(require_count("a.x", "tags", 0, 0) == 0);
    for (const double value : {0.0, -1.0, 1.5, 4294967296.0, std::numeric_limits<double>::quiet_NaN()})
        CHECK(refused_for("must be a whole number from 1 to 4294967295",
                          [&] { (void)require_count("a.x", "rows", value); }));
    CHECK(require_step("a.x", "dx", 1e-300) == 1e-300);
    for (const double value : {0.0, -1.0, std::numeric_limits<double>::infinity()})
        CHECK(refused_for("must be finite and greater than 0", [&] { (void)require_step("a.x", "dx", value); }));
    CHECK(require_length_unit("a.x", "unit of z", "um") == 1e-6);
    CHECK(refused_for("a.x: unit of z = \"V\": must be a unit of length: m",
                      [] { (void)require_length_unit("a.x", "unit of z", "V"); }));
    CHECK(stated_number("a.x", "dx", "0.1") == 0.1);
    CHECK(refused_for("a.x: dx", [] { (void)stated_number("a.x", "dx", "far"); }));
}

TEST_CASE("Memory is taken for heights that a file can hold") {
    fstiff::io::RawMap map;
    CHECK(allocate_stored(map, 3, 4, 2, 24, "a.x") == 0);
    CHECK(allocate_stored(map, 3, 4, 2, 27, "a.x") == 3);
    CHECK((map.rows == 3 && map.columns == 4 && map.heights.size() == 12));
    for (const std::size_t side : {std::size_t(4), std::size_t(4294967295)})
        CHECK(refused_for("heights of 2 bytes, but holds 24 bytes of them; must hold all",
                          [&] { (void)allocate_stored(map, side, side, 2, 24, "a.x"); }));
    allocate_text(map, 2, 3, 11, "a.x");
    CHECK(map.heights.size() == 6);
    const std::string_view two = "must hold all, 2 a row at least";
    CHECK(refused_for(two, [&] { allocate_text(map, 2, 3, 10, "a.x"); }));
    CHECK(refused_for(two, [&] { allocate_text(map, 9, 1, 100, "a.x"); }));
}

}  // namespace required_test
