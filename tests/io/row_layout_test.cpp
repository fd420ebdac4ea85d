// SPDX-License-Identifier: BSD-3-Clause
// Truth: the heights that the texts are made of (tests/support/texts.hpp).
#include "io/row_layout.hpp"

#include "support/catch.hpp"
#include "support/texts.hpp"

namespace {

using fstiff::io::SurfaceFormat;
using fstiff::io::SurfaceOptions;
using test::Decision;
using test::height_text;
using test::map;
using test::matrix;
using test::profile;
using test::refused;
using test::rows;
using test::TextRow;
using test::triples;
using test::with_commas;

void check(const std::vector<TextRow>& texts) {
    for (const TextRow& row : texts) test::check_text(row);
}

const std::string titles = "x [um];z [um]\n", plain = titles + rows("{x};{z}\n");

Decision um(std::vector<std::string> says = {}) { return profile(0.5e-6, 1e-6, std::move(says)); }

/// \p text with \p cell in the row of the point 7.
std::string with_word(const std::string& pattern, const std::string& from, const std::string& cell) {
    return test::lines(20, [&](int i) {
        const std::string number = std::to_string(i), x = std::to_string(i / 2) + (i % 2 ? ".5" : ".0");
        std::string row = test::all_replaced(test::all_replaced(pattern, "{i}", number), "{x}", x);
        row = test::all_replaced(row, i == 7 ? from : "\x01", cell);
        return test::all_replaced(row, "{z}", height_text(i));
    });
}

}  // namespace

TEST_CASE("Columns of words are left out, wherever they are and whatever separates them") {
    const std::string stamp = "2024-05-03T10:00:{i}", names = "P{i}";
    for (const std::string s : {";", ",", "\t", " ", " | "}) {
        CAPTURE(s);
        check({
            {"names", "name" + s + "x[um]" + s + "z[um]\n" + rows(names + s + "{x}" + s + "{z}\n"),
             um({"\nread as: heights [um] in column 3, positions [um] in column 2; separator: ",
                 "; column 1 of words not used\n"})},
            {"clock times first", "t" + s + "x[um]" + s + "z[um]\n" + rows("10:00:{i}.5" + s + "{x}" + s + "{z}\n"),
             um()},
            {"stamps last", "x[um]" + s + "z[um]" + s + "t\n" + rows("{x}" + s + "{z}" + s + stamp + "\n"), um()},
            {"words on both sides",
             "n" + s + "x[um]" + s + "q" + s + "z[um]" + s + "r\n" +
                 rows(names + s + "{x}" + s + "ok" + s + "{z}" + s + "good\n"),
             um({"; columns 1, 3, 5 of words not used\n"})},
            {"chosen",
             rows(names + s + "{x}" + s + "{z}\n"),
             um(),
             {.format = SurfaceFormat::profile, .units = "um", .column = 3, .x_column = 2}},
            {"triples",
             "p" + s + "x[um]" + s + "y[um]" + s + "z[um]\n" + triples("a" + s + "{i}" + s + "{j}" + s + "{z}\n"),
             map(1e-6, 1e-6, 1e-6)},
        });
    }
    check({
        {"decimal commas and a clock", "Zeit;Weg [um];H\xC3\xB6he [um]\n" + with_commas(rows("10:00:{i};{x};{z}\n")),
         um()},
        {"date and clock", rows("2024-05-03 10:00:{i} {x} {z}\n"), um(), {.units = "um"}},
        {"quoted", "\"name\",\"x [um]\",\"z [um]\"\n" + rows("\"a, b\",{x},{z}\n"), um()},
        {"one column of heights", "name;z [um]\n" + rows("P{i};{z}\n"), profile(2e-6, 1e-6), {.spacing = 2e-6}},
    });
}

TEST_CASE("A word among the numbers of a column is refused, since it may mark a missing point") {
    const std::string text = "name;x [um];z [um]\n" + with_word("P{i};{x};{z}\n", "{z}", "over");
    Decision missing = um();
    missing.missing = {7};
    check({
        {"a word", text, refused("line 9: \"over\" is not a number", "missing = \"WORD\"")},
        {"given", text, missing, {.missing = "over"}},
        {"known", "name;x [um];z [um]\n" + with_word("P{i};{x};{z}\n", "{z}", "?"), missing},
    });
}

TEST_CASE("What may be a number is no word") {
    check({
        {"units in the cells", titles + rows("{x} um;{z} um\n"),
         refused("line 2: \"0.0 um\" has its unit in the cell")},
        {"glued units", "x;z\n" + rows("{x}mm;{z}um\n"), refused("line 2: \"0.0mm\" has its unit in the cell")},
        {"between commas", "x,z\n" + rows("{x} um,{z} um\n"), refused("line 2: \"0.0 um\" has its unit in the cell")},
        {"code of MATLAB", "z = [\n" + rows("{x} {z};\n") + "];\n", refused("without the brackets and semicolons")},
        {"faces of a mesh", rows("f {i} 2 3\n"), refused("\"f 0 2 3\""), {.units = "um"}},
        {"a unit in one cell", titles + rows("{x} um;{z}\n"), refused("\"")},
        {"blanks between thousands", titles + rows("{i};1 07{i},0\n"), refused("thousands")},
    });
}

TEST_CASE("Lines after the rows are no rows") {
    for (const std::string end : {"EOF\n", "Ra;0.48\nRq;0.61\n", "Mean;;1.2\n", "\n[End]\n", "**end cloud\n",
                                  "20 points\n", "\nRa [um];Rq [um]\n0.48;0.61\n", "-----\nRa = 0.4 um\n",
                                  "(20 rows)\n", "\x1A", "\r\n\x1A\x1A\n", "# done\nEND\n"}) {
        CAPTURE(end);
        check({{"footer", plain + end, um()}});
    }
    check({
        {"many",
         titles + rows("{x};{z}\n", 100) + rows("n{i};0.5\n", 80),
         {.dx = 0.5e-6, .warnings = {"80 lines after the rows, from line 102 on, are not read"}, .size = 100}},
        {"more than the rows", titles + "1;2\n" + rows("n{i};0.5\n"), refused("no spacing")},
        {"a last row of missing points",
         "Width: 5 um\nHeight: 5 um\nunit: um\n" + matrix(" ") + "nan nan nan nan nan\n",
         {.dx = 1e-6, .size = 25, .rows = 5, .missing = {20, 21, 22, 23, 24}}},
        {"noted", plain + "EOF\nRa;0.4\n", um({"; 2 lines after the rows not used (\"EOF\")\n"})},
        {"with names", "n;x [um];z [um]\n" + rows("P{i};{x};{z}\n") + "Mean;4.75;0.6\nmax;9.5;1.6\n", um()},
        {"results below a blank line", "t,x [um],z [um]\n" + rows("T{i},{x},{z}\n") + "\nRa,0.48\nRq,0.61\nRz,3.1\n",
         um()},
        {"a count next to words",
         "status z[um]\n" + rows("ok {z}\n") + "Points: 20\n",
         {.dx = 0.5e-6, .unit = 1e-6},
         {.spacing = 0.5e-6}},
        {"matrix", "Width: 5 um\nHeight: 4 um\nunit: um\n" + matrix(" ") + "EOF\n", map(1e-6, 1e-6, 1e-6)},
        // rows that do not read as the others do are refused, also at the end
        {"a torn row", plain + "10.0;0.4x\n", refused("line 22: \"0.4x\"")},
        {"thousands at the end", plain + "+1,001.5;0.4\n", refused("line 22: \"+1,001.5\"")},
        {"a unit", plain + "Unit: nm\n", refused("line 22")},
        {"a scale", plain + "Z scale: 10\n", refused("line 22")},
        {"in between", plain + "EOF\n10.0;0.4\n", refused("line 22")},
    });
}

TEST_CASE("A row of heights, alone or below a row of positions, is read as a column") {
    const auto row = [](const std::string& separator, const std::string& head, const test::Cell& cell) {
        std::string text = head;
        for (int i = 0; i < 20; ++i) text += (text.empty() ? "" : separator) + cell(i);
        return text + "\n";
    };
    const auto x = [](int i) { return std::to_string(i / 2) + (i % 2 ? ".5" : ".0"); };
    for (const std::string s : {",", ";", "\t", " "}) {
        CAPTURE(s);
        check({
            {"heights",
             row(s, "", height_text),
             profile(2e-6, 1e-6, {"rows: of the file are read as columns"}),
             {.units = "um", .spacing = 2e-6}},
            {"both", row(s, "", x) + row(s, "", height_text), um(), {.units = "um"}},
            {"titled", row(s, "x[um]", x) + row(s, "z[um]", height_text), um()},
        });
    }
    const std::string two = row(",", "", height_text) + row(",", "", height_text);
    check({{"two rows of heights", two, refused("dx"), {.units = "um"}},
           {"a map of two rows",
            row(",", "", x) + row(",", "", height_text),
            {.dx = 1e-6, .dy = 1e-6, .size = 40, .rows = 2},
            {.format = SurfaceFormat::matrix, .units = "um", .dx = 1e-6, .dy = 1e-6}}});
}

TEST_CASE(
    "A map of two rows whose header states its size or its form is not turned, however equal the steps of its first") {
    std::string heights;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 64; ++i) heights += std::to_string(j == 0 ? i : i % 5) + (i < 63 ? "\t" : "\n");
    const std::string size = "# Width: 64 um\n# Height: 4 um\n", unit = "# Value units: um\n";
    const Decision two_rows{.dx = 1e-6, .dy = 2e-6, .size = 128, .rows = 2, .format = SurfaceFormat::matrix};
    const auto check_rows = [&](const TextRow& row) {
        test::check_text(row, [](int i) { return static_cast<double>(i < 64 ? i : (i - 64) % 5); });
    };
    Decision in_um = two_rows;
    in_um.unit = 1e-6;
    check_rows({"as write_csv writes it", "# Form: matrix\n" + size + unit + heights, in_um});
    check_rows({"size", size + unit + heights, in_um});
    check_rows({"steps", "# dx: 1 um\n# dy: 2 um\n" + unit + heights, in_um});
    check_rows({"form", "# Form: matrix\n" + heights, two_rows, {.units = "um", .dx = 1e-6, .dy = 2e-6}});
    check_rows({"form, refused without a size", "# Form: matrix\n" + heights, refused("dx"), {.units = "um"}});
    // positions and heights of a profile
    check({{"neither", heights, {.dx = 1e-6, .size = 64}, {.units = "um"}},
           {"a step of either",
            "# Pixel size: 1 um\n" + heights,
            refused("may be a profile or a matrix"),
            {.units = "um"}},
           {"profile by the options",
            size + heights,
            {.dx = 1e-6, .size = 64},
            {.format = SurfaceFormat::profile, .units = "um"}}});
}

TEST_CASE("Tables between bars are read") {
    check({
        {"bars", "x [um] | z [um]\n" + rows("{x} | {z}\n"), um({"; separator: bar, decimal point"})},
        {"Markdown", "| x [um] | z [um] |\n|:---|---:|\n" + rows("| {x} | {z} |\n"), um()},
        {"a frame", "+----+----+\n| x [um] | z [um] |\n+====+====+\n" + rows("| {x} | {z} |\n") + "+----+----+\n",
         um()},
        {"decimal commas", with_commas("x [um] | z [um]\n" + rows("{x} | {z}\n")), um()},
        {"an error of a workbook",
         with_word("{z} | ok\n", "{z}", "#N/A"),
         {.dx = 0.5e-6, .unit = 1e-6, .missing = {7}},
         {.units = "um", .spacing = 0.5e-6}},
        {"missing points of one column",
         "| z [um] |\n|---|\n" + with_word("| {z} |\n", "| {z} |", "|---|"),
         {.dx = 0.5e-6, .unit = 1e-6, .missing = {7}},
         {.spacing = 0.5e-6}},
    });
}

TEST_CASE("Next to words, a comma is decimal or separates columns as the titles have it") {
    const auto z = with_commas(rows("P{i} {z}\n")), last = with_commas(rows("{z} ok\n"));
    const SurfaceOptions spaced{.spacing = 0.5e-6}, in_um{.units = "um", .spacing = 0.5e-6};
    const Decision one{.dx = 0.5e-6, .unit = 1e-6};
    const std::string sentence = "may have its comma between two columns or in a number";
    check({
        {"decimal", "name z[um]\n" + z, one, spaced},
        {"decimal, words last", "z [um] status\n" + last, one, spaced},
        {"columns",
         "name,z [um]\n" + rows("Sample {i},{i}\n", 20, [](int i) { return std::to_string(i); }),
         {.dx = 0.5e-6, .unit = 0},
         spaced},
        {"no title for each", "z [um]\n" + z, refused(sentence), spaced},
        {"no title", z, refused(sentence), in_um},
        {"both", "name,z [um]\n" + with_commas(rows("P{i},{z}\n")), refused("has commas between its columns and in"),
         spaced},
    });
}

TEST_CASE("Signs of other programs are read") {
    const std::string minus = "\xE2\x88\x92";
    const auto with_minus = [&](const std::string& text) { return test::all_replaced(text, "-", minus); };
    check({
        {"U+2212 of heights", with_minus(plain), um()},
        {"U+2212 of positions",
         titles +
             with_minus(test::lines(20, [](int i) { return std::to_string(i - 15) + ";" + height_text(i) + "\n"; })),
         profile(1e-6, 1e-6)},
        {"sep=", "sep=;\n" + plain, um()},
        {"GBK", "x [\xA6\xCCm];z [\xA6\xCCm]\n" + rows("{x};{z}\n"), um()},
        {"Shift-JIS", "x [\x83\xCAm];z [\x83\xCAm]\n" + rows("{x};{z}\n"), um()},
        {"two tabs", "n\t\tx [um]\t\tz [um]\n" + rows("{i}\t\t{x}\t\t{z}\n"), um()},
        {"a blank after the comma", "x [um], z [um]\n" + rows("{i}, {z}\n"), profile(1e-6, 1e-6)},
    });
}

TEST_CASE("Columns that hold neither positions nor heights are left out by their titles or their numbers") {
    check({
        {"time", "Time [s];x [um];z [um]\n" + rows("{i}.5;{x};{z}\n"), um({"column 1 not used"})},
        {"quality", "x [um];z [um];Quality\n" + rows("{x};{z};{i}\n"), um({"column 3 not used"})},
        {"errors", "x [um];z [um];dz [um]\n" + rows("{x};{z};0.{i}\n"), um()},
        {"one y", "x [um];y [um];z [um]\n" + rows("{x};2.5;{z}\n"), um({"column 2 not used"})},
        {"quality next to heights",
         "z [um];Quality\n" + rows("{z};{i}\n"),
         {.dx = 0.5e-6, .unit = 1e-6},
         {.spacing = 0.5e-6}},
        {"forces are no heights", "x [um];F [N]\n" + rows("{x};{z}\n"), refused("in \"N\", which is of no length")},
        {"two traces", "x [um];z1 [um];z2 [um]\n" + rows("{x};{z};{z}\n"), refused("format = profile with column")},
        {"z, x, y", "z [um];x [um];y [um]\n" + triples("{z};{i};{j}\n"), map(1e-6, 1e-6, 1e-6)},
        {"pixels and lengths", "i;j;x [um];y [um];z [um]\n" + triples("{i};{j};{i};{j}.0;{z}\n"),
         map(1e-6, 1e-6, 1e-6)},
    });
}

TEST_CASE("Pixels are no lengths: their size is asked for") {
    const std::string text = "col,row,z [um]\n" + triples("{i},{j},{z}\n");
    check({
        {"asked for", text, refused("counts pixels, of which it states no dx", "dx")},
        {"not by a unit", text, refused("counts pixels"), {.units = "um"}},
        {"given", text, map(2e-6, 3e-6, 1e-6), {.dx = 2e-6, .dy = 3e-6}},
        {"stated", "Pixel size: 2 um\n" + text, map(2e-6, 2e-6, 1e-6)},
    });
}

TEST_CASE("Heads of Nanosurf and LEXT state the size of a map") {
    check({
        {"Nanosurf", "#XRange:5e-6 m\n#YRange:4e-6 m\n#DataUnit:um\n" + matrix(" "), map(1e-6, 1e-6, 1e-6)},
        {"a resolution", "# Resolution: 2.0 um/px\n# unit: um\n" + matrix(" "), map(2e-6, 2e-6, 1e-6)},
        {"LEXT", "Width,5\nHeight,4\nX[um/pixel],2.0\nY[um/pixel],3.0\nunit,um\n" + matrix(","), map(2e-6, 3e-6, 1e-6)},
        {"scales", "XScale: 2 um/pixel\nYScale: 3 um/pixel\nunit: um\n" + matrix(" "), map(2e-6, 3e-6, 1e-6)},
    });
}

TEST_CASE("A blank line within a trace divides it only where its positions do not go on") {
    const auto with_gap = [](const std::string& text) {
        const std::size_t at = text.find("\n4.5") + 1;
        return text.substr(0, at) + "\n" + text.substr(at);
    };
    const std::string lined = "x [um];y [um];z [um]\n" + rows("{x};2.5;{z}\n");
    check({{"one trace", with_gap(lined), um()},
           {"two traces", lined + "\n" + rows("{x};2.5;{z}\n"), refused("2 tables")}});
}
