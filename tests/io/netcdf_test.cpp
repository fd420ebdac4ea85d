// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace netcdf_test {

using namespace fstiff;
using test::big;
using test::contains;
using test::put;
using test::replaced;

namespace {

const test::FormReader read{io::SurfaceFormat::netcdf};
const test::RefusalOf refusal(read);
std::string whole() { return test::sample("netcdf/map.nc"); }
/// The sample with \p field \p after bytes after the first \p name.
std::string with(const std::string& name, std::size_t after, const std::string& field) {
    return put(whole(), whole().find(name) + name.size() + after, field);
}

}  // namespace

TEST_CASE("A map of contact.engineering is over x and y, with a mask, and rows of y") {
    CHECK(read(whole()).record.said("units") == "heights in um, x in um, y in um");
    test::check_sample(read(replaced(whole(), std::string("mask"), "musk")), 0.5e-6, 0.25e-6, 1e-6, 0);
}

TEST_CASE("Files of NetCDF that are no surface are refused with variable, value and range") {
    CHECK(contains(refusal("CDF\3"), "does not begin as a classic NetCDF file"));
    CHECK(contains(refusal(put(whole(), 8, big(9, 4))), "has a tag 9 before its dimensions; must be 10"));
    CHECK(contains(refusal(put(whole(), 12, big(-1, 4))), "has a count of 4294967295 in its header"));
    CHECK(contains(refusal(put(whole(), 12, big(2147483647, 4))), "header"));
    CHECK(contains(refusal(put(whole(), 24, big(1, 4))), "points of a row x rows = 1 x 3: must be at least 2 x 1"));
    CHECK(contains(refusal(put(whole(), 24, big(2147483647, 4))), "declares 2147483647 x 3 heights of 8 bytes"));
    CHECK(contains(refusal(replaced(whole(), "heights", "weights")), "has no variable heights"));
    CHECK(contains(refusal(with("heights", 5, big(7, 4))), "dimension of a variable = 7"));
    CHECK(contains(refusal(with("heights", 5, big(1, 4))), "heights that are not over x and y, or x"));
    CHECK(contains(refusal(with("mask", 8, big(0, 4))), "has a mask that is not over what heights are"));
    CHECK(contains(refusal(replaced(whole(), "um", "kg")), "unit of heights = \"kg\": must be a unit of length"));
    test::check_sample(read(replaced(whole(), "um", "nm")), 0.5e-6, 0.25e-6, 1e-9, 1);
    test::check_sample(read(put(whole(), 4, big(-1, 4))), 0.5e-6, 0.25e-6, 1e-6, 1);  // records not counted
    // the unit of heights is that of x where it is not stated
    test::check_sample(read(replaced(whole(), "unit", "Unit")), 0.5e-6, 0.25e-6, 1e-6, 1);
    CHECK(contains(refusal(replaced(whole(), "length", "Length")), "has no length of x"));
    CHECK(contains(refusal(with("length", 2, big(2, 4) + big(8, 4))), "length = no number: must be one number"));
    CHECK(contains(refusal(with("length", 2, big(0, 4))), "type of a number = 0: must be between 1 and 11"));
    CHECK(contains(refusal(with("length", 10, std::string(8, '\0'))), "length of x = 0: must be finite"));
    CHECK(contains(refusal(with("length", 10, "\xFF")), "length of x = "));
}

}  // namespace netcdf_test
