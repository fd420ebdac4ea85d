// SPDX-License-Identifier: BSD-3-Clause
// Units as instruments and programs state them. Truth: the numbers of the text times the unit that is meant.
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/units.hpp>

#include "support/samples.hpp"

namespace stated_units_test {

using namespace fstiff;
using io::SurfaceOptions;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// \p head above 20 rows of a position 0.5 apart and a height from 0.1 to 0.7.
std::string profile(const std::string& head, const std::string& separator = ";") {
    std::string text = head;
    for (int i = 0; i < 20; ++i)
        text += std::to_string(i / 2) + (i % 2 ? ".5" : ".0") + separator + "0." + std::to_string(1 + i * i % 7) + "\n";
    return text;
}
std::string matrix(const std::string& head) {
    std::string text = head;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) text += std::to_string(1 + (7 * (5 * j + i)) % 9) + (i < 4 ? "\t" : "\n");
    return text;
}
constexpr test::FileReader read{};
const test::RefusalOf refusal(read);
void check_profile(const std::string& text, double lengths, double heights) {
    CAPTURE(text.substr(0, 40));
    const auto found = read(text).profile();
    CHECK(test::relative_error(found.spacing, 0.5 * lengths) < 1e-14);
    CHECK(test::relative_error(found.heights[3], 0.3 * heights) < 1e-14);
}

}  // namespace

TEST_CASE("Units are understood in capitals, other languages and powers of ten", "[units]") {
    check_profile(profile("x [MM];z [UM]\n"), 1e-3, 1e-6);
    check_profile(profile("x [\xD0\xBC\xD0\xBC];z [\xD0\xBC\xD0\xBA\xD0\xBC]\n"), 1e-3, 1e-6);  // Russian
    check_profile(profile("x [\xEC\xEC];z [\xED\xEC]\n"), 1e-3, 1e-9);                          // CP1251
    check_profile(profile("x [\xE3\x8E\x9C];z [\xE5\xBE\xAE\xE7\xB1\xB3]\n"), 1e-3, 1e-6);
    for (const char* unit : {"x10 nm", "10 nm", "x 10nm",
                             "\xC3\x97"
                             "10 nm",
                             "10^-8 m", "1e-8 m", "0.01 um", "10\xE2\x81\xBB\xE2\x81\xB8 m", "10**-8 m"})
        check_profile(profile("x [um];z [" + std::string(unit) + "]\n"), 1e-6, 1e-8);
    check_profile(profile("x (um);z (10^-6 m)\n"), 1e-6, 1e-6);
    CHECK(test::relative_error(read(profile(""), {.units = "um,10 nm"}).profile().heights[3], 0.3e-8) < 1e-14);
    for (const char* unit : {"2.5 mm", "1 mm", "x3 nm", "10", "x10", "10^ m"})
        CHECK_FALSE(io::is_unit(unit, io::Dimension::length));
    CHECK_FALSE(refusal(profile("x [um];R (0.1 mm)\n")).empty());  // a cut-off is no unit
}

TEST_CASE("A factor next to a unit is never dropped", "[units]") {
    for (const char* z : {"z [um] (x100)", "z [um] x100",
                          "z (um) [\xC3\x97"
                          "100]",
                          "z [um] (10^-3)"}) {
        CAPTURE(z);
        CHECK(has(refusal(profile("x [um];" + std::string(z) + "\n")), "which is not understood"));
        CHECK_FALSE(refusal(profile("x [um]\t" + std::string(z) + "\n", "\t")).empty());
    }
    CHECK(read(profile("x [um];z [um] (x100)\n"), {.units = "um"}).record.warnings.size() == 1);
    const std::string nova = "NX = 5\nNY = 4\nScale X = 0.1\nScale Y = 0.2\nUnit X = um\nUnit Data = nm\n";
    CHECK(has(refusal(matrix(nova + "Scale Data = 2\n")), "not whether the heights are to be multiplied"));
    CHECK(has(refusal(profile("# factor: 0.001\nx [um];z [um]\n")), "not whether the heights are to be multiplied"));
    CHECK(read(matrix(nova + "Scale Data = 10\nDataScaleNeeded = yes\n")).map().heights(0, 0) == 1e-8);
    CHECK(read(matrix(nova + "Scale Data = 10\nDataScaleNeeded = no\n")).map().heights(0, 0) == 1e-9);
}

TEST_CASE("A unit that is not understood is named", "[units]") {
    CHECK(has(refusal(profile("x [um];z [raw]\n")), "line 1: states the unit \"raw\" for the heights"));
    CHECK(has(refusal(profile("x [px];z [um]\n")), "line 1: states the unit \"px\" for the positions"));
    CHECK(has(refusal(profile("x [px];z [um]\n")), "units = \"UNIT,um\""));
    CHECK(has(refusal(profile("# Z unit: foo\n")), "line 1: states the unit \"foo\" for the heights"));
    CHECK(has(refusal(matrix("# Width: 48\n# Height: 32\n# Value units: um\n")), "units = \"UNIT,um\""));
}

TEST_CASE("The header states units of the axes and the heights", "[units]") {
    const std::string attocube = "# x-pixels: 5\n# y-pixels: 4\n# x-length: 10\n# y-length: 0.8\n# x-unit: um\n";
    const auto map = read(matrix(attocube + "# y-unit: um\n# z-unit: nm\n")).map();
    CHECK(test::relative_error(map.dx, 2e-6) < 1e-14);
    CHECK(test::relative_error(map.dy, 0.2e-6) < 1e-14);
    CHECK(map.heights(0, 0) == 1e-9);
    const auto nova = read(matrix("File Format = ASCII\nNX = 5\nNY = 4\nScale X = 0.1\nScale Y = 0.2\nUnit X = um\n"
                                  "Unit Y = \nUnit Data = nm\nScale Data = 1\nDataScaleNeeded = no\n"))
                          .map();
    CHECK(test::relative_error(nova.dx, 0.1e-6) < 1e-14);
    CHECK(test::relative_error(nova.dy, 0.2e-6) < 1e-14);
    CHECK(nova.heights(0, 0) == 1e-9);
    check_profile(profile("# X unit: mm\n# Z unit: um\n"), 1e-3, 1e-6);
    check_profile(profile("Unit X = mm\nUnit Z = um\nx;z\n"), 1e-3, 1e-6);
    check_profile(profile("# Z unit: um\nx [mm];z\n"), 1e-3, 1e-6);
    check_profile(profile("Einheit x: mm\nEinheit z: um\n"), 1e-3, 1e-6);
    CHECK(has(refusal(profile("# Z unit: um\n")), "states no unit of the positions"));
}

TEST_CASE("Two units that contradict each other are refused", "[units]") {
    CHECK(has(refusal(profile("Unit;nm\nx [um];z [um]\n")), "line 1: states nm, and line 2 um for the heights"));
    CHECK(has(refusal(profile("# Z unit: nm\nx [um];z [um]\n")), "must be one unit"));
    CHECK(has(refusal(profile("x [um];z [um] (nm)\n")), "which is not understood"));
    check_profile(profile("Unit;mm\nx [mm];z [um]\n"), 1e-3, 1e-6);  // that of the positions
    check_profile(profile("# Z unit: \xC2\xB5m\nx [mm];z [um]\n"), 1e-3, 1e-6);
}

}  // namespace stated_units_test
