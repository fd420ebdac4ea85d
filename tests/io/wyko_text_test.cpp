// SPDX-License-Identifier: BSD-3-Clause
// Exports of Wyko, written here: counts, a pixel in mm, heights in waves or nm.
#include "support/samples.hpp"

namespace wyko_text_test {

using namespace fstiff;
using io::SurfaceOptions;

namespace {

constexpr test::FileReader read{};
const test::RefusalOf refusal(read);

/// 5 points along x and 4 along y: a line for each x.
const std::string heights = "1\t2\t3\t4\n5\tBad\t7\t8\n9\t10\t11\t13\n0\t2\t1\t3\n4\t3\t2\t8\n";
std::string file(const std::string& units = "0", const std::string& rows = heights, const std::string& more = "") {
    return "Wyko ASCII Data File Format 0\t" + units +
           "\t1\nX Size\t5\nY Size\t4\nBlock Name\tType\tLength\tValue\nWavelength\t7\t4\t600\nAspect\t7\t4\t0.5\n"
           "Pixel_size\t7\t4\t0.002\nMult\t7\t4\t2\nTitle\t5\t20\tsample 1\n" +
           more + "RAW_DATA\t3\t80\n" + rows;
}

}  // namespace

TEST_CASE("Heights in waves and in nm, counts and the pixel are those of the header") {
    for (const auto& [units, step] : {std::pair{"0", 600e-9 / 2}, {"1", 1e-9}}) {
        const io::Surface found = read(file(units));
        REQUIRE(found.map().columns() == 4);
        REQUIRE(found.map().rows() == 5);
        CHECK(test::ulps(found.map().dy, 2e-6) <= 2);
        CHECK(test::ulps(found.map().dx, 1e-6) <= 2);
        CHECK(test::ulps(found.map().heights(2, 3), 13 * step) <= 2);
        CHECK(std::isnan(found.map().heights(1, 1)));
    }
    // rows along x, blanks for tabs, and another array
    std::string rows = "1 2 3 4 5\n6 7 8 9 1\n2 3 4 5 7\n6 Bad 8 9 2\nIntensity 3 80\n";
    for (int k = 0; k < 4; ++k) rows += "1 1 1 1 1\n";
    std::string blanks = file("1", rows);
    std::replace(blanks.begin(), blanks.end(), '\t', ' ');
    const io::Surface found = read(blanks);
    CHECK(found.map().columns() == 5);
    CHECK(test::ulps(found.map().dx, 2e-6) <= 2);
    CHECK(found.map().heights(3, 4) == 2 * 1e-9);
    CHECK(test::contains(found.record.sentences().back(), "other arrays: Intensity, not read"));
}

TEST_CASE("A file of Wyko that cannot be meant is refused, and no option replaces its units") {
    CHECK(test::contains(refusal(file(), {.units = "um,nm"}), "is Wyko ASCII, which states its units and steps"));
    CHECK(test::contains(refusal(file("2")),
                         "file, line 1: states the units of the heights as \"2\"; must be 0 (waves) or 1 (nm)"));
    CHECK(test::contains(refusal(file("0", "1\t2\n")), "states 5 x 4 points, but holds 2; must agree"));
    CHECK(test::contains(refusal(file("0", "1\tx\n")), "line 11: \"1?x\" is no row of heights"));
    std::string text = file();
    CHECK(test::contains(refusal(text.replace(text.find("Pixel_size"), 10, "Pixel_side")), "states no Pixel_size"));
    text = file();
    CHECK(test::contains(refusal(text.replace(text.find("0.002"), 5, "0.000")),
                         "line 7: Pixel_size \"0.000\"; must be a number"));
    CHECK(test::contains(refusal(file() + file()),
                         "holds 2 tables of numbers: 1 in nm from line 1, 2 in nm from line 16"));
    CHECK(read(file("1") + file("0"), {.channel = "1"}).map().heights(0, 0) == 1e-9);
}

}  // namespace wyko_text_test
