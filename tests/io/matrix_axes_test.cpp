// SPDX-License-Identifier: BSD-3-Clause
// Matrices with positions as their first row and column, as Excel, MATLAB and pandas write them: the same map as
// without. And triples with more columns: the same map as without.
#include "support/texts.hpp"

namespace matrix_axes_test {

using namespace fstiff;
using namespace test;
using io::SurfaceOptions;

namespace {

/// The heights below and next to positions of the steps \p dx and \p dy, with \p corner where both begin.
std::string axes(const std::string& corner, double dx, double dy, const std::string& separator = ";") {
    std::ostringstream text;
    text << corner;
    for (int i = 0; i < 5; ++i) text << separator << i * dx;
    for (int i = 0; i < 20; ++i) {
        if (i % 5 == 0) text << "\n" << i / 5 * dy;
        text << separator << height_text(i);
    }
    return text.str() + "\n";
}
const std::string plain = axes("y\\x [um]", 0.5, 0.25), own_head = "dx: 2 um\ndy: 2 um\nunit: nm\n";
const Decision in_nm = map(0.5e-6, 0.25e-6, 1e-9), in_um = map(0.5e-6, 0.25e-6, 1e-6);

}  // namespace

TEST_CASE("Positions in the first row and column are the steps of a matrix, never heights", "[axes]") {
    for (const std::string corner : {"y\\x [um]", "y/x [\xC2\xB5m]", "X (um)", "\"y\\x [um]\"", "# y\\x [um]"}) {
        const std::string unit = contains(corner, "\xB5") ? "\xC2\xB5m" : "um";
        check_text({corner,
                    with_commas(axes(corner, 0.5, 0.25)),
                    map(0.5e-6, 0.25e-6, 1e-9,
                        {"matrix, from positions in the first row and the first column",
                         "\naxes: the first row and the first column are positions in " + unit + "\n"}),
                    {.units = "nm"}});
    }
    // the corner is empty, not a number, or a number, as MATLAB writes it; units by option
    for (const std::string corner : {"", "NaN", "0", "7"})
        for (const std::string separator : {";", "\t", ",", " "})
            if (!corner.empty() || separator != " ")
                check_texts({{corner, axes(corner, 0.5, 0.25, separator), in_nm, {.units = "um,nm"}},
                             {corner, axes(corner, 0.5, 0.25, separator), in_um, {.units = "um"}}});
    check_texts({
        {"blanks", axes("y\\x [um]", 0.5, 0.25, " "), in_nm, {.units = "nm"}},
        {"axes that fall", axes("", -0.5, -0.25), in_um, {.units = "um"}},
        {"a unit of the heights in the header", "Value units: nm\n" + plain, in_nm},
    });
    for (const std::string corner : {"", "Index", "0"})
        check_texts(
            {{"counts " + corner, axes(corner, 1, 1), refused("states no dx and no width"), {.units = "um"}},
             {"counts " + corner, axes(corner, 1, 1), map(2e-6, 3e-6, 1e-6), {.units = "um", .dx = 2e-6, .dy = 3e-6}}});
    check_text({"counts in um", axes("y\\x [um]", 1, 1), map(1e-6, 1e-6, 1e-9), {.units = "nm"}});
}

TEST_CASE("Axes without a unit, and one axis alone, are refused", "[axes]") {
    const std::string traces = lines(20, [](int i) {  // positions and three traces
        return std::to_string(i * 0.5) + ";" + height_text(i * i) + ";" + height_text(i) + ";" + height_text(3 * i) +
               "\n";
    });
    const SurfaceOptions size{.units = "um", .dx = 1e-6, .dy = 1e-6};
    const std::string sentence = "has a first column that rises in equal steps";
    check_texts({
        {"no unit", axes("y\\x", 0.5, 0.25),
         refused("line 1: holds positions, whose unit is not stated; must be given as units")},
        {"two units", axes("y [um]\\x [mm]", 0.5, 0.25), refused("whose unit is stated twice")},
        {"no unit of the heights", plain, refused("states no unit of the heights")},
        {"one axis", traces, refused(sentence + ", as positions do"), size},
        {"one axis and titles", "x [um];1;2;3\n" + traces, refused(sentence), size},
        {"a matrix",
         traces,
         {.size = 80, .rows = 20},
         {.format = io::SurfaceFormat::matrix, .units = "um", .dx = 1e-6, .dy = 1e-6}},
        {"a trace", traces, profile(0.5e-6, 1e-6), {.units = "um", .column = 3}},
    });
}

TEST_CASE("Options and headers that contradict the axes are used and reported", "[axes]") {
    const Decision whole{.dx = 2e-6, .dy = 2e-6, .size = 30, .rows = 5};
    check_texts({
        {"step",
         plain,
         map(2e-6, 0.25e-6, 1e-9, {},
             {"dx = 2e-06 m contradicts dx of the positions in line 1, 5e-07 m; the option is used"}),
         {.units = "nm", .dx = 2e-6}},
        {"unit",
         plain,
         map(0.5e-3, 0.25e-3, 1e-9, {}, {"units = \"mm,nm\" contradicts line 1, which states um for the axes"}),
         {.units = "mm,nm"}},
        {"the same step", plain, in_nm, {.units = "nm", .dx = 0.5e-6}},
        {"columns of the whole table", own_head + axes("0", 0.5, 0.25), whole},
        {"columns of the heights", own_head + "cols: 5\n" + axes("0", 2, 2, " "), map(2e-6, 2e-6, 1e-9)},
        {"other steps",
         own_head + "cols: 5\n" + axes("0", 0.5, 0.25),
         refused("disagrees with the axes"),
         {.units = "um,nm"}},
    });
}

TEST_CASE("The heights in columns x and y and z and more are z", "[axes]") {
    const std::string bare = triples("{i},{j},{z},10{i}\n"), head = "x [um],y [um],z [um],I";
    const Decision grid = map(1e-6, 1e-6, 1e-6);
    check_texts({
        {"no titles",
         bare,
         map(1e-6, 1e-6, 1e-6,
             {"triples, from 4 columns, the first two of which form a grid",
              "\ncolumns: x, y and heights in 1, 2, 3; left out: 4\n"}),
         {.units = "um"}},
        {"units", head + " [a.u.]\n" + bare, grid},
        {"titles", "x;y;z;intensity\n" + triples("{i};{j};{z};10{i}\n"), grid, {.units = "um"}},
        {"the title of z is where z is", "x [um],y [um],intensity,z [um]\n" + triples("{i},{j},10{i},{z}\n"), grid},
        {"or a matrix", bare, refused("may be triples or a matrix"), {.units = "um", .dx = 1e-6, .dy = 1e-6}},
        {"off the grid", head + "\n" + bare + "0.13,77.7,1,2\n", refused("lie on no regular grid")},
    });
}

}  // namespace matrix_axes_test
