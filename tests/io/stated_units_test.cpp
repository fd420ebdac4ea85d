// SPDX-License-Identifier: BSD-3-Clause
// Units as instruments and programs state them. Truth: the numbers of the text times the unit that is meant.
#include <fstiff/io/units.hpp>

#include "support/texts.hpp"

namespace stated_units_test {

using namespace fstiff;
using namespace test;

namespace {

const std::string points = rows("{x};{z}\n"), tabs = matrix("\t");

}  // namespace

TEST_CASE("Units are understood in capitals, other languages and powers of ten", "[units]") {
    check_texts({
        {"capitals", "x [MM];z [UM]\n" + points, profile(0.5e-3, 1e-6)},
        {"Russian", "x [\xD0\xBC\xD0\xBC];z [\xD0\xBC\xD0\xBA\xD0\xBC]\n" + points, profile(0.5e-3, 1e-6)},
        {"Russian, CP1251", "x [\xEC\xEC];z [\xED\xEC]\n" + points, profile(0.5e-3, 1e-9)},
        {"Chinese", "x [\xE3\x8E\x9C];z [\xE5\xBE\xAE\xE7\xB1\xB3]\n" + points, profile(0.5e-3, 1e-6)},
        {"a power of ten", "x (um);z (10^-6 m)\n" + points, profile(0.5e-6, 1e-6)},
        {"given", points, profile(0.5e-6, 1e-8), {.units = "um,10 nm"}},
        {"after a number of the column", "x1_mm;z1_nm\n" + points, profile(0.5e-3, 1e-9)},
        {"one column", "\"z [10^-6 m]\"\n" + rows("{z}\n"), {.dx = 0.5e-6, .unit = 1e-6}, {.spacing = 0.5e-6}},
        {"above a unit of something else", "Distance z Quality\nmm nm %\n" + rows("{x} {z} 9{i}.5\n"),
         profile(0.5e-3, 1e-9)},
        {"no unit next to others", "Distance;z;valid\nmm;nm;-\n" + rows("{x};{z};{i}.5\n"), profile(0.5e-3, 1e-9)},
        {"above a remark", "t x z\n[s] [mm] [nm]\n# measured twice\n" + rows("{i}.5 {x} {z}\n"), profile(0.5e-3, 1e-9)},
        {"below a section",
         "z-unit: nm\n[Data]\nz\n" + rows("{z}\n"),
         {.dx = 0.5e-6, .unit = 1e-9},
         {.spacing = 0.5e-6}},
        {"inches", "x / in;z [um]\n" + points, profile(0.5 * 25.4e-3, 1e-6)},
        {"a cut-off is no unit", "x [um];R (0.1 mm)\n" + points, refused("")},
    });
    for (const std::string unit : {"x10 nm", "10 nm", "x 10nm", "\xC3\x97\x31\x30 nm", "10^-8 m", "1e-8 m", "0.01 um",
                                   "10\xE2\x81\xBB\xE2\x81\xB8 m", "10**-8 m"})
        check_text({unit, "x [um];z [" + unit + "]\n" + points, profile(0.5e-6, 1e-8)});
    for (const char* unit : {"2.5 mm", "1 mm", "x3 nm", "10", "x10", "10^ m"})
        CHECK_FALSE(io::is_unit(unit, io::Dimension::length));
}

TEST_CASE("A factor next to a unit is never dropped", "[units]") {
    for (const std::string z : {"z [um] (x100)", "z [um] x100", "z (um) [\xC3\x97\x31\x30\x30]", "z [um] (10^-3)"})
        check_texts({{z, "x [um];" + z + "\n" + points, refused("which is not understood")},
                     {z, "x [um]\t" + z + "\n" + rows("{x}\t{z}\n"), refused("")}});
    const std::string nova = "NX = 5\nNY = 4\nScale X = 0.1\nScale Y = 0.2\nUnit X = um\nUnit Data = nm\n";
    const Decision unknown = refused("not whether the heights are to be multiplied");
    check_texts({
        {"unit given", "x [um];z [um] (x100)\n" + points, profile(0.5e-6, 1e-6, {}, {""}), {.units = "um"}},
        {"of data", nova + "Scale Data = 2\n" + tabs, unknown},
        {"in the header", "# factor: 0.001\nx [um];z [um]\n" + points, unknown},
        {"needed", nova + "Scale Data = 10\nDataScaleNeeded = yes\n" + tabs, map(0.1e-6, 0.2e-6, 1e-8)},
        {"not needed", nova + "Scale Data = 10\nDataScaleNeeded = no\n" + tabs, map(0.1e-6, 0.2e-6, 1e-9)},
    });
}

TEST_CASE("A key and its value are no titles", "[units]") {
    const std::string blanks = rows("{x} 2.5 {z}\n"), head = "x-unit: mm\nz-unit: nm\n";
    for (const std::string& line : {"Stylus radius=2 um\n", "Stylus radius: 2 um\n", "Speed = 0,5 mm/s\n"})
        check_texts({{"above", line + head + blanks, profile(0.5e-3, 1e-9)},
                     {"below", head + line + blanks, profile(0.5e-3, 1e-9)}});
    check_texts({{"z before x", "# x-unit: mm\n# z-unit: nm\n" + rows("{z} {x}\n"), profile(0.5e-3, 1e-9)},
                 {"no unit", "Radius=2 um\nx z\n" + rows("{x} {z}\n"), refused("\"UNIT,UNIT\"")}});
}

TEST_CASE("A unit that is not understood is named", "[units]") {
    check_texts({
        {"raw", "x [um];z [raw]\n" + points, refused("line 1: states the unit \"raw\" for the heights")},
        {"px", "x [px];z [um]\n" + points,
         refused("line 1: states the unit \"px\" for the positions", "units = \"UNIT,um\"")},
        {"foo", "# Z unit: foo\n" + points, refused("line 1: states the unit \"foo\" for the heights")},
        {"none", "# Width: 48\n# Height: 32\n# Value units: um\n" + tabs, refused("units = \"UNIT,um\"")},
    });
}

TEST_CASE("The header states units of the axes and the heights, which must agree with the titles", "[units]") {
    const std::string attocube = "# x-pixels: 5\n# y-pixels: 4\n# x-length: 10\n# y-length: 0.8\n# x-unit: um\n";
    const std::string nova =
        "File Format = ASCII\nNX = 5\nNY = 4\nScale X = 0.1\nScale Y = 0.2\nUnit X = um\n"
        "Unit Y = \nUnit Data = nm\nScale Data = 1\nDataScaleNeeded = no\n";
    const Decision mm_um = profile(0.5e-3, 1e-6);
    check_texts({
        {"attocube", attocube + "# y-unit: um\n# z-unit: nm\n" + tabs, map(2e-6, 0.2e-6, 1e-9)},
        {"Nova", nova + tabs, map(0.1e-6, 0.2e-6, 1e-9)},
        {"keys", "# X unit: mm\n# Z unit: um\n" + points, mm_um},
        {"keys above titles", "Unit X = mm\nUnit Z = um\nx;z\n" + points, mm_um},
        {"a key and a title", "# Z unit: um\nx [mm];z\n" + points, mm_um},
        {"German", "Einheit x: mm\nEinheit z: um\n" + points, mm_um},
        {"one key", "# Z unit: um\n" + points, refused("states no unit of the positions")},
        {"another unit", "Unit;nm\nx [um];z [um]\n" + points,
         refused("line 1: states nm, and line 2 um for the heights")},
        {"another unit of z", "# Z unit: nm\nx [um];z [um]\n" + points, refused("must be one unit")},
        {"two in a title", "x [um];z [um] (nm)\n" + points, refused("which is not understood")},
        {"that of the positions", "Unit;mm\nx [mm];z [um]\n" + points, mm_um},
        {"keys of columns in another order", "# x-unit: mm\n# z-unit: um\n" + rows("{z} {x}\n"), mm_um},
        {"what is above keys is no title", "Date = today\n# x-unit = mm\n# z-unit = um\n" + rows("{x} 0.{i} {z}\n"),
         refused("has 3 columns")},
        {"a radius is no title", "Stylus radius=2 nm\nx-unit=mm\nz-unit=um\n" + rows("{x} 0 {z}\n"), mm_um},
        {"another spelling", "# Z unit: \xC2\xB5m\nx [mm];z [um]\n" + points, mm_um},
    });
}

TEST_CASE("Each column of triples has the unit of its title or else of the header, which must agree", "[units]") {
    const std::string points = triples("{i};{j};{z}\n"), units = "# X unit: mm\n# Z unit: um\n";
    const Decision mm_um = map(1e-3, 1e-3, 1e-6);
    check_texts({
        {"titles", "x [mm];y [mm];z [um]\n" + points, mm_um},
        {"keys", units + points, mm_um},
        {"both", units + "x [mm];y [mm];z\n" + points, mm_um},
        {"another unit of z", units + "x [mm];y [mm];z [nm]\n" + points, refused("line 2: states um, and line 3 nm")},
        {"another unit of x", units + "x [um];y [mm];z [um]\n" + points, refused("line 1: states mm, and line 3 um")},
        {"no unit of y", "x [mm];y;z [um]\n" + points, refused("states no unit of y", "\"mm,um\"")},
        {"not understood", units + "x [mm];y [mm];z [raw]\n" + points,
         refused("states the unit \"raw\" for the heights")},
    });
}

}  // namespace stated_units_test
