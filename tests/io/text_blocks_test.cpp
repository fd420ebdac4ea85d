// SPDX-License-Identifier: BSD-3-Clause
// Several tables of numbers in one text: which is read, and what stays one table.
#include "support/samples.hpp"

namespace text_blocks_test {

using namespace fstiff;
using io::SurfaceOptions;

namespace {

constexpr test::FileReader read{};
const test::RefusalOf refusal(read);
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
std::string said(const io::Surface& surface) {
    std::string all;
    for (const std::string& sentence : surface.record.sentences()) all += sentence + "\n";
    return all;
}

/// Rows of a matrix of 5 columns, its first number being \p first.
std::string matrix(int first, int rows = 4) {
    std::string text;
    for (int k = 0; k < 5 * rows; ++k)
        text += std::to_string(k == 0 ? first : (k * 7) % 11) + (k % 5 == 4 ? "\n" : "\t");
    return text;
}
std::string gwyddion(const std::string& title, const std::string& unit) {
    return "# Channel: " + title + "\n# Width: 10 um\n# Height: 4 um\n# Value units: " + unit + "\n";
}
std::string trace(int first, int count = 20) {
    std::string text;
    for (int k = 0; k < count; ++k) text += (k == 0 ? std::to_string(first) : std::to_string((k * 7) % 11)) + ".5\n";
    return text;
}

}  // namespace

TEST_CASE("The only block in a unit of length is read, and the others are named") {
    const std::string height = gwyddion("Height", "nm") + matrix(3), phase = gwyddion("Phase", "deg") + matrix(4);
    for (const std::string& text : {height + phase, phase + "\n" + height, phase + height + phase}) {
        const io::Surface found = read(text);
        REQUIRE(found.map().rows() == 4);
        CHECK(found.map().heights(0, 0) == 3 * 1e-9);
        CHECK(found.map().dy == 1e-6);
        CHECK(has(said(found), "\"Height\" in nm from line "));
        CHECK(has(said(found), "\"Phase\" in deg from line "));
    }
    CHECK(has(said(read(phase + height)), "header: 4 lines"));
    CHECK(has(refusal(phase + phase), "none of heights: 1 \"Phase\" in deg from line 1, 2 \"Phase\" in deg"));
}

TEST_CASE("Of several blocks of heights the channel chooses one, and without it they are listed") {
    const std::string two = gwyddion("Forth", "nm") + matrix(3) + gwyddion("Back", "um") + matrix(4);
    CHECK(has(refusal(two),
              "file: holds 2 tables of numbers: 1 \"Forth\" in nm from line 1, 2 \"Back\" in um from line "
              "9; must be one of them, given as channel = \"1\""));
    CHECK(read(two, {.channel = "2"}).map().heights(0, 0) == 4 * 1e-6);
    CHECK(read(two, {.channel = "forth"}).map().heights(0, 0) == 3 * 1e-9);
    CHECK(has(refusal(two, {.channel = "3"}), "has no channel \"3\"; must be one of 1 \"Forth\""));
    CHECK(read(gwyddion("Forth", "nm") + matrix(3), {.channel = "Forth"}).map().rows() == 4);
    // other programs
    const std::string esri = "ncols 5\nnrows 4\ncellsize 1\nNODATA_value -9999\n";
    const SurfaceOptions in_um{.units = "um,um", .channel = "2"};
    CHECK(has(refusal(esri + matrix(3) + esri + matrix(4), {.units = "um,um"}), "holds 2 tables"));
    CHECK(read(esri + matrix(3) + esri + matrix(4), in_um).map().heights(0, 0) == 4 * 1e-6);
    const std::string german = "# Kanal: Oben\n# Breite: 10 um\n# H\xC3\xB6he: 4 um\n# Wert-Einheiten: nm\n";
    CHECK(has(refusal(german + matrix(3) + "\n" + german + matrix(4)), "1 \"Oben\" in nm"));
    const std::string spip = "# File Format = ASCII\n# x-length = 10\n# y-length = 4\n# z-unit = nm\n";
    CHECK(has(refusal(spip + matrix(3) + spip + matrix(4)), "holds 2 tables"));
    const std::string own = "# Channel: Back\n";  // the sizes and the unit are those above
    CHECK(read(gwyddion("Forth", "nm") + matrix(3) + own + matrix(4), {.channel = "Back"}).map().heights(0, 0) ==
          4 * 1e-9);
}

TEST_CASE("Blank lines and titles divide matrices, traces and triples that do not go on") {
    const SurfaceOptions sized{.units = "um,um", .dx = 1e-6, .dy = 1e-6, .channel = "2"};
    SurfaceOptions whole = sized;
    whole.channel.clear();
    CHECK(read(matrix(3) + "\n" + matrix(4), sized).map().heights(0, 0) == 4 * 1e-6);
    CHECK(has(refusal(matrix(3) + "\n\n" + matrix(4), whole), "1 in no unit from line 1, 2 in no unit from line 7"));
    const SurfaceOptions profile{.units = "um", .spacing = 1e-6, .channel = "2"};
    const std::string traces = "# Trace 1\n" + trace(1) + "# Trace 2\n" + trace(2);
    CHECK(read(traces, profile).profile().heights[0] == 2.5 * 1e-6);
    CHECK(
        has(refusal(traces, {.units = "um", .spacing = 1e-6}), "1 \"Trace 1\" in no unit from line 1, 2 \"Trace 2\""));
    CHECK(read(trace(1) + "\n" + trace(2), profile).profile().heights[0] == 2.5 * 1e-6);
    std::string pairs;
    for (int k = 0; k < 20; ++k) pairs += std::to_string(k) + ";" + std::to_string((k * 7) % 11) + "\n";
    const std::string titles = "x [um];z [um]\n";
    CHECK(has(refusal(titles + pairs + titles + pairs), "holds 2 tables of numbers: 1 in um from line 1"));
    CHECK(read(titles + pairs + titles + pairs, {.channel = "1"}).profile().size() == 20);
    std::string triples;
    for (int k = 0; k < 20; ++k)
        triples += std::to_string(k % 5) + " " + std::to_string(k / 5) + " " + std::to_string((k * 7) % 11) + "\n";
    CHECK(has(refusal(triples + "\n" + triples, {.units = "um"}), "holds 2 tables"));
    CHECK(read(triples + "\n" + triples, {.units = "um", .channel = "2"}).map().rows() == 4);
}

TEST_CASE("What goes on after a blank line or a remark is one table") {
    const SurfaceOptions sized{.units = "um,um", .dx = 1e-6, .dy = 1e-6};
    std::string spaced, scans, curves, pages;
    for (int j = 0; j < 4; ++j) spaced += matrix(j, 1) + "\n";
    CHECK(read(spaced, sized).map().rows() == 4);
    CHECK(read("# rows: 8\n" + matrix(3) + "\n" + matrix(4), sized).map().rows() == 8);
    CHECK(read(matrix(3) + "# the operator left\n" + matrix(4), sized).map().rows() == 8);
    for (int j = 0; j < 4; ++j) {  // gnuplot: a blank line, or a remark, after each scan line
        curves += "# IsoCurve " + std::to_string(j) + ", 5 points\n# x y z\n";
        for (int i = 0; i < 5; ++i) {
            const std::string row =
                std::to_string(i) + " " + std::to_string(j) + " " + std::to_string((i * j + i) % 7) + "\n";
            scans += row;
            curves += row;
        }
        scans += j < 3 ? "\n" : "\n\n";
        curves += "\n";
    }
    CHECK(read(scans, {.units = "um"}).map().rows() == 4);
    CHECK(read(curves, {.units = "um"}).map().rows() == 4);
    for (int k = 0; k < 40; ++k)  // a title on every page
        pages +=
            (k % 20 == 0 ? "# x [um];z [um]\n" : "") + std::to_string(k) + ";" + std::to_string((k * 7) % 11) + "\n";
    CHECK(read(pages).profile().size() == 40);
    CHECK(read(trace(1, 10) + "\n" + trace(2, 10), {.units = "um", .spacing = 1e-6}).profile().size() == 20);
}

TEST_CASE("Values in a unit of no length are read in no case") {
    for (const char* unit : {"deg", "V", "mV", "urad", "\xC2\xB5rad", "nA", "nm/V", "Hz", "%", "N/m", "um^2"}) {
        CAPTURE(unit);
        CHECK(has(refusal(gwyddion("Other", unit) + matrix(3), {.units = "um"}), "which is of no length"));
        std::string rows;
        for (int k = 0; k < 20; ++k) rows += std::to_string(k) + "\t" + std::to_string((k * 7) % 11) + "\n";
        CHECK(has(refusal("x (mm)\tvalue (" + std::string(unit) + ")\n" + rows, {.units = "mm,um"}),
                  "has a column 2 in \"" + std::string(unit) + "\", which is of no length"));
    }
    // units that are not understood may be replaced, names of columns are no units
    CHECK(read(gwyddion("Height", "UM") + matrix(3), {.units = "um"}).map().rows() == 4);
    std::string rows;
    for (int k = 0; k < 20; ++k) rows += std::to_string(k) + "\t" + std::to_string((k * 7) % 11) + "\t7\n";
    const std::string titles = "x [mm]\tz [um]\tslope [urad]\n";
    CHECK(read(titles + rows, {.column = 2, .x_column = 1}).profile().size() == 20);
    CHECK(has(refusal(titles + rows, {.units = "mm,um", .column = 3, .x_column = 1}), "a column 3 in \"urad\""));
    CHECK(read("x\tV\tS\n" + rows, {.units = "um", .column = 2, .x_column = 1}).profile().size() == 20);
}

}  // namespace text_blocks_test
