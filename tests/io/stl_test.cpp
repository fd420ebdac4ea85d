// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace stl_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;
using test::replaced;

namespace {

const test::FormReader read{io::SurfaceFormat::stl, {.units = "um"}};
const test::RefusalOf refusal(read);
/// Position of corner \p corner of triangle \p triangle in a binary file.
constexpr std::size_t place(std::size_t triangle, std::size_t corner) { return 84 + 50 * triangle + 12 + 12 * corner; }

}  // namespace

TEST_CASE("Triangles without a unit are refused with the option that states it") {
    for (const char* name : {"stl/map.stl", "stl/text.stl"})
        CHECK(contains(refusal(test::sample(name), {}),
                       "states no unit and none is given; must be given as units = \"mm\""));
}

TEST_CASE("Triangles that are no height over x and y are refused in words") {
    const std::string whole = test::sample("stl/map.stl");
    CHECK(contains(refusal(put(whole, 80, little(7, 4))), "declares 7 triangles, which make 434 bytes, but has 384"));
    CHECK(contains(refusal(put(whole, 80, little(-1, 4))), "declares 4294967295 triangles"));
    CHECK(contains(refusal(put(whole, place(0, 0), little(0.0123F))), "corners lie on no regular grid"));
    CHECK(contains(refusal(put(whole, place(1, 1) + 8, little(77.0F))), "has two heights at x = "));
    CHECK(contains(refusal(put(whole, place(0, 1), little(0.0F) + little(0.25F) + little(10.0F))),
                   "has a triangle 1 over 0 x 1 cells"));
    CHECK(contains(refusal(put(whole, place(1, 1), little(std::nanf("")))), "has a triangle 2 with a corner that"));
    CHECK(contains(refusal("solid of nothing\nfacet"), "in triangle 1; must have normal there"));
    const std::string text = test::sample("stl/text.stl");
    CHECK(contains(refusal(replaced(text, "endloop", "endloup")), "has \"endloup\" in triangle 1; must have endloop"));
    CHECK(contains(refusal(replaced(text, "vertex 0.5", "vertex 0,5")), "has \"0,5\" in triangle 1; must be a number"));
    CHECK(contains(refusal(replaced(text, "endsolid", "end")), "has \"end\" after 6 triangles; must have facet or"));
    CHECK(contains(refusal(whole, {.units = "um,nm"}), "units = "));
}

TEST_CASE("A stream may be triangles while it is not longer than they are") {
    const std::string whole = test::sample("stl/map.stl");
    const auto may_begin = io::detail::reader_of(io::SurfaceFormat::stl).may_begin;
    CHECK(may_begin(whole.substr(0, 200)));
    CHECK_FALSE(read.begins(whole.substr(0, 200)));
    CHECK_FALSE(may_begin(whole + "more"));
    CHECK_FALSE(may_begin(std::string(70000, '\0')));
}

}  // namespace stl_test
