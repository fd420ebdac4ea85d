// SPDX-License-Identifier: BSD-3-Clause
// Contents of headers, read by eye.
#include "io/header.hpp"
#include "io/row_layout.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace header_test {

using namespace fstiff;
using namespace fstiff::io::detail;

namespace {

NumberTable table_of(std::string_view text) { return open_table(text, "file"); }

}  // namespace

TEST_CASE("titles state units, the nearest line to the rows first", "[header]") {
    const NumberTable table = table_of("a [mm];b [mm]\nx [um];z [nm]\n1;2\n");
    const TitleUnits found = title_units(table, 2);
    CHECK(found.units == std::vector<std::string_view>{"um", "nm"});
    CHECK(found.from == "line 2");
    CHECK(title_units(table, 3).units.empty());
}

TEST_CASE("keys state sizes in m, counts and the form", "[header]") {
    const NumberTable table = table_of("Width: 10 um\nw=3 h=4\nForm: triples\n1 2\n");
    const auto entries = header_entries(table);
    const StatedGrid grid = stated_grid(entries, "", "file");
    REQUIRE(grid.width);
    CHECK(test::ulps(grid.width->value, 1e-5) <= 1);
    CHECK(grid.columns == std::size_t(3));
    CHECK(grid.rows == std::size_t(4));
    CHECK_FALSE(grid.has_size());
    CHECK(stated_form(entries) == io::MapForm::triples);
    CHECK_FALSE(stated_form(header_entries(table_of("Form: automatic\n1 2\n"))));
}

TEST_CASE("a spacing is stated with the weight of its last digit", "[header]") {
    const auto stated = stated_spacing(header_entries(table_of("Resolution,0.156 um/sample\n1\n")));
    REQUIRE(stated);
    CHECK(test::ulps(stated->value, 0.156e-6) <= 1);
    CHECK(test::ulps(stated->resolution, 1e-9) <= 2);
}

TEST_CASE("units that are given are at most as many as there is use for", "[header]") {
    CHECK(given_units("um,nm", 2, "file", "two").size() == 2);
    CHECK(given_units("", 2, "file", "two").empty());
    CHECK(test::refusal([] { (void)given_units("um,nm,m", 2, "file", "two"); }) ==
          "file: units = \"um,nm,m\": must be two");
}

}  // namespace header_test
