// SPDX-License-Identifier: BSD-3-Clause
// Grids of Surfer in its three forms, of tools/make_surface_samples.py.
#include "support/samples.hpp"

namespace surfer_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;
using test::replaced;

namespace {

const test::FormReader read{io::SurfaceFormat::surfer, {.units = "m,um"}};
const test::RefusalOf refusal(read);
std::string text() { return test::sample("surfer/text.grd"); }
std::string six() { return test::sample("surfer/six.grd"); }
std::string seven() { return test::sample("surfer/seven.grd"); }
std::string real(double value) { return test::bytes_of(value); }

constexpr std::size_t grid = 20;  // byte of the fields of the section GRID

}  // namespace

TEST_CASE("The three forms of Surfer hold the same map in the units of the options") {
    for (const std::string& file : {text(), six(), seven()}) {
        const io::Reading found = read(file);
        CHECK(test::ulps(found.map.dx, 0.5) <= 1);
        CHECK(test::ulps(found.map.dy, 0.25) <= 1);
        CHECK(test::ulps(found.map.at(2, 3), 29e-6) <= 1);
        CHECK(std::isnan(found.map.at(1, 2)));
        CHECK(found.record.said("units") == "x and y in m, heights in um, from options");
        CHECK(contains(refusal(file, {}),
                       "states no units and none are given; must be given as units = \"um,nm\" (x and y"));
    }
    CHECK(read(text()).record.said("form") == "grid of Surfer 6, text");
    CHECK(read(seven()).record.said("form") == "grid of Surfer 7");
}

TEST_CASE("Blanks of Surfer are missing however they are written") {
    for (const char* blank : {"1.70141E+38", "1.7014118346046923e+38", "1.71041e38"})
        CHECK(std::isnan(read(replaced(text(), "1.70141e+038", blank)).map.at(1, 2)));
    // version 1 of the form 7 takes all that is as large, version 2 what is equal
    const std::string other = put(seven(), seven().size() - 8, real(2e30));
    CHECK(read(other, {.units = "m", .missing = "none"}).record.missing == 1);
    CHECK(read(put(other, 8, little(1, 4))).record.missing == 2);
    CHECK(read(six(), {.units = "m", .missing = "29"}).record.missing == 2);
    CHECK(contains(refusal(replaced(text(), "1.70141e+038", "-9999")), "far outside the others"));
}

TEST_CASE("A grid of Surfer of one row is a profile") {
    const io::Reading found = read("DSAA\n20 1\n0 9.5\n3 3\n0 1\n0 1 0 1 0 1 0 1 0 1 0 1 0 1 0 1 0 1 0 1");
    CHECK((found.map.rows == 1 && found.map.columns == 20 && test::ulps(found.map.dx, 0.5) <= 1));
}

TEST_CASE("Grids of Surfer that cannot be meant are refused with what is allowed") {
    CHECK(contains(refusal("DSA"), "does not begin as a grid of Surfer"));
    CHECK(contains(refusal("DSAA\n4 3\n0 1"), "ends within its header"));
    CHECK(contains(refusal(replaced(text(), "4 3", "4 x")), "has \"x\" within its header; must be a number"));
    CHECK(contains(refusal(replaced(text(), "4 3", "4 -3")), "rows = -3: must be a whole number"));
    CHECK(contains(refusal(replaced(text(), "4 3", "4294967295 4294967295")), "declares 4294967295 x 4294967295"));
    CHECK(contains(refusal(replaced(text(), "4 3", "4 4")), "ends within its heights"));
    CHECK(contains(refusal(replaced(text(), "10.0 11.5", "11.5 10.0")), "step of x = -0.5: must be finite"));
    CHECK(read(text() + "1 2").record.said("trailer") == "3 bytes, not read");
    CHECK(contains(refusal(put(six(), 4, little(-1, 2))), "declares 65535 x 3 heights"));
    CHECK(contains(refusal(put(six(), 6, little(0, 2))), "points of a row x rows = 4 x 0"));
    CHECK(contains(refusal(put(six(), 32, real(std::nan("")))), "step of y = nan"));
    CHECK(contains(refusal(put(seven(), grid, little(-1, 4))), "declares 4 x 4294967295 heights"));
    CHECK(contains(refusal(put(seven(), 16, little(-1, 4))), "ends within section \"GRID\""));
    CHECK(contains(refusal(replaced(seven(), "GRID", "grid")), "has a section DATA before its section GRID"));
    CHECK(contains(refusal(put(seven(), grid + 24, real(0))), "step of x = 0"));
}

}  // namespace surfer_test
