// SPDX-License-Identifier: BSD-3-Clause
// Several tables of numbers in one text: which is read, and what stays one table.
#include "support/texts.hpp"

namespace text_blocks_test {

using namespace fstiff;
using namespace test;
using io::SurfaceOptions;

namespace {

/// The heights \p k further: another table than that of k = 0.
Cell after(int k) {
    return [k](int i) { return height_text(i + k); };
}
const std::string other = matrix("\t", after(1)), tabs = matrix("\t");
const std::string trace = rows("{z}\n"), other_trace = rows("{z}\n", 20, after(1));
std::string gwyddion(const std::string& title, const std::string& unit) {
    return "# Channel: " + title + "\n# Width: 10 um\n# Height: 4 um\n# Value units: " + unit + "\n";
}
const Decision in_nm = map(2e-6, 1e-6, 1e-9), in_um = map(2e-6, 1e-6, 1e-6);

}  // namespace

TEST_CASE("The only block in a unit of length is read, and the others are named") {
    const std::string height = gwyddion("Height", "nm") + tabs, phase = gwyddion("Phase", "deg") + other;
    for (const std::string& text : {height + phase, phase + "\n" + height, phase + height + phase})
        check_text(
            {"phase", text, map(2e-6, 1e-6, 1e-9, {"\"Height\" in nm from line ", "\"Phase\" in deg from line "})});
    check_texts({
        {"header", phase + height, map(2e-6, 1e-6, 1e-9, {"header: 4 lines"})},
        {"no heights", phase + phase, refused("none of heights: 1 \"Phase\" in deg from line 1, 2 \"Phase\" in deg")},
    });
}

TEST_CASE("Of several blocks of heights the channel chooses one, and without it they are listed") {
    const std::string two = gwyddion("Forth", "nm") + other + gwyddion("Back", "um") + tabs;
    const std::string esri = "ncols 5\nnrows 4\ncellsize 1\nNODATA_value -9999\n";
    const std::string german = "# Kanal: Oben\n# Breite: 10 um\n# H\xC3\xB6he: 4 um\n# Wert-Einheiten: nm\n";
    const std::string spip = "# File Format = ASCII\n# x-length = 10\n# y-length = 4\n# z-unit = nm\n";
    const std::string twice = esri + other + esri + tabs;
    check_texts({
        {"no channel", two,
         refused("file: holds 2 tables of numbers: 1 \"Forth\" in nm from line 1, 2 \"Back\" in um from line "
                 "9; must be one of them, given as channel = \"1\"")},
        {"the second", two, in_um, {.channel = "2"}},
        {"by name", gwyddion("Forth", "nm") + tabs + gwyddion("Back", "um") + other, in_nm, {.channel = "forth"}},
        {"the third", two, refused("has no channel \"3\"; must be one of 1 \"Forth\""), {.channel = "3"}},
        {"the only one", gwyddion("Forth", "nm") + tabs, in_nm, {.channel = "Forth"}},
        {"ESRI", twice, refused("holds 2 tables"), {.units = "um,um"}},
        {"ESRI, the second", twice, map(1e-6, 1e-6, 1e-6), {.units = "um,um", .channel = "2"}},
        {"German", german + tabs + "\n" + german + other, refused("1 \"Oben\" in nm")},
        {"SPIP", spip + tabs + spip + other, refused("holds 2 tables")},
        {"the sizes and the unit are those above",
         gwyddion("Forth", "nm") + other + "# Channel: Back\n" + tabs,
         in_nm,
         {.channel = "Back"}},
    });
}

TEST_CASE("Blank lines and titles divide matrices, traces and triples that do not go on") {
    const SurfaceOptions sized{.units = "um,um", .dx = 2e-6, .dy = 1e-6};
    const SurfaceOptions second{.units = "um,um", .dx = 2e-6, .dy = 1e-6, .channel = "2"};
    const SurfaceOptions spaced{.units = "um", .spacing = 1e-6};
    const SurfaceOptions second_trace{.units = "um", .spacing = 1e-6, .channel = "2"};
    const std::string traces = "# Trace 1\n" + other_trace + "# Trace 2\n" + trace;
    const std::string titled = "x [um];z [um]\n" + rows("{x};{z}\n"), points = triples("{i} {j} {z}\n");
    check_texts({
        {"matrices", other + "\n" + tabs, in_um, second},
        {"matrices, no channel", other + "\n\n" + tabs, refused("1 in no unit from line 1, 2 in no unit from line 7"),
         sized},
        {"traces", traces, profile(1e-6, 1e-6), second_trace},
        {"traces, no channel", traces, refused("1 \"Trace 1\" in no unit from line 1, 2 \"Trace 2\""), spaced},
        {"traces, blank line", other_trace + "\n" + trace, profile(1e-6, 1e-6), second_trace},
        {"titles", titled + titled, refused("holds 2 tables of numbers: 1 in um from line 1")},
        {"titles, channel", titled + titled, profile(0.5e-6, 1e-6), {.channel = "1"}},
        {"triples", points + "\n" + points, refused("holds 2 tables"), {.units = "um"}},
        {"triples, channel", points + "\n" + points, map(1e-6, 1e-6, 1e-6), {.units = "um", .channel = "2"}},
    });
}

TEST_CASE("What goes on after a blank line or a remark is one table") {
    const SurfaceOptions sized{.units = "um,um", .dx = 2e-6, .dy = 1e-6}, um{.units = "um"};
    const SurfaceOptions spaced{.units = "um", .spacing = 1e-6};
    const Decision eight{.dx = 2e-6, .dy = 1e-6, .unit = 1e-6, .size = 40, .rows = 8}, grid = map(1e-6, 1e-6, 1e-6);
    // gnuplot: a blank line, or a remark, after each scan line
    const auto before = [](const std::string& first, const std::string& last) {
        return lines(20, [&](int i) {
            return (i % 5 ? "" : first) + std::to_string(i % 5) + " " + std::to_string(i / 5) + " " + height_text(i) +
                   (i % 5 == 4 ? last : "\n");
        });
    };
    check_texts({
        {"a blank line a row", matrix("\t", height_text, "\n\n"), in_um, sized},
        {"8 rows stated", "# rows: 8\n" + tabs + "\n" + tabs, eight, sized},
        {"a remark", tabs + "# the operator left\n" + tabs, eight, sized},
        {"scans", before("", "\n\n") + "\n", grid, um},
        {"curves", before("# IsoCurve, 5 points\n# x y z\n", "\n\n"), grid, um},
        {"a title on every page",
         lines(40,
               [](int i) {
                   return (i % 20 ? "" : "# x [um];z [um]\n") + std::to_string(i) + ";" + height_text(i) + "\n";
               }),
         {.dx = 1e-6, .unit = 1e-6, .size = 40}},
        {"short traces", rows("{z}\n", 10) + "\n" + rows("{z}\n", 10, after(10)), profile(1e-6, 1e-6), spaced},
    });
}

TEST_CASE("Values in a unit of no length are read in no case") {
    for (const std::string unit : {"deg", "V", "mV", "urad", "\xC2\xB5rad", "nA", "nm/V", "Hz", "%", "N/m", "um^2"})
        check_texts({{unit, gwyddion("Other", unit) + tabs, refused("which is of no length"), {.units = "um"}},
                     {unit,
                      "x (mm)\tvalue (" + unit + ")\n" + rows("{x}\t{z}\n"),
                      refused("has a column 2 in \"" + unit + "\", which is of no length"),
                      {.units = "mm,um"}}});
    const std::string slope = "x [mm]\tz [um]\tslope [urad]\n" + rows("{x}\t{z}\t7\n");
    check_texts({
        {"a unit that is not understood is replaced", gwyddion("Height", "UM") + tabs, in_um, {.units = "um"}},
        {"the column of heights", slope, profile(0.5e-3, 1e-6), {.column = 2, .x_column = 1}},
        {"the column of slopes",
         slope,
         refused("a column 3 in \"urad\""),
         {.units = "mm,um", .column = 3, .x_column = 1}},
        {"names of columns are no units",
         "x\tV\tS\n" + rows("{x}\t{z}\t7\n"),
         profile(0.5e-6, 1e-6),
         {.units = "um", .column = 2, .x_column = 1}},
    });
}

}  // namespace text_blocks_test
