// SPDX-License-Identifier: BSD-3-Clause
// Maps from text, as tables of texts (support/texts.hpp).
#include "support/texts.hpp"

namespace map_text_test {

using namespace fstiff;
using namespace test;
using io::SurfaceFormat;
using io::SurfaceOptions;

namespace {

const std::string gwyddion = "# Channel: z\n# Width: 10 um\n# Height: 800 nm\n# Value units: nm\n";
const std::string blanks = matrix(" "), tabs = matrix("\t"), commas = matrix(",");
const Decision map_in_nm = map(2e-6, 200e-9, 1e-9);

/// The heights, with \p word where \p where(column, row).
template <class Where>
Cell with(const std::string& word, const Where& where) {
    return [word, where](int i) { return where(i % 5, i / 5) ? word : height_text(i); };
}

}  // namespace

TEST_CASE("A matrix has its size and units from a header or from options") {
    const std::string keys = "pixel size=3.5e-007 m\ndata unit=rad\nheight conversion factor (-> m)=2.5e-008\n" +
                             matrix(" ", height_text, " \n");
    const SurfaceOptions steps{.units = "nm", .dx = 1e-6, .dy = 2e-6};
    check_texts({
        {"Gwyddion", gwyddion + tabs, map_in_nm},
        {"mixed units", "# Width: 0.01 mm\n# Height: 8 \xC2\xB5m\n# Value units: \xB5m\n" + blanks,
         map(2e-6, 2e-6, 1e-6, {"format: matrix"})},
        {"pitch and factor", "h=4 w=5\n" + keys, map(3.5e-7, 3.5e-7, 2.5e-8)},
        {"dx and dy", "dx: 1 um\ndy: 2 um\nunit: nm\n" + commas, map(1e-6, 2e-6, 1e-9)},
        {"9 rows", "h=9 w=5\n" + keys, refused("line 1: states 9 rows where there are 4")},
        {"no factor", "pixel size=1 um\ndata unit=rad\n" + blanks,
         refused("states \"rad\" as the unit of the values, which is of no length")},
        {"unit and factor", "pixel size=1 um\ndata unit=nm\nheight conversion factor (-> m)=2e-8\n" + blanks,
         refused("disagrees")},
        {"two pitches", "pixel size=1 um\npixel pitch=2 um\nunit=nm\n" + blanks, refused("disagrees with line 1")},
        {"pitch and width", "dx=1 um\ndy=1 um\nwidth=9 um\nunit=nm\n" + blanks, refused("disagrees with the spacing")},
        {"negative width", "# Width: -3 um\n# Height: 1 um\n" + blanks, refused("must be greater than 0")},
        {"two widths", "# Width: 3 um\n# Width: 4 um\n" + blanks, refused("disagrees with line 1")},
        {"width without a unit", "Width: 10\nHeight: 8\nunit: nm\n" + blanks, refused("line 1: \"width\" has no unit")},
        {"its unit", "Width: 10\nHeight: 8\n" + blanks, map(2e-6, 2e-6, 1e-9), {.units = "um,nm"}},
        {"no size", blanks, refused("dx and dy (between points) or width and height"), {.units = "nm"}},
        {"no dy", blanks, refused("states no dy and no height"), {.units = "nm", .dx = 1e-6}},
        {"no unit", blanks, refused("units = \"UNIT\""), {.dx = 1e-6, .dy = 1e-6}},
        {"dx and width", blanks, refused("both given"), {.units = "nm", .dx = 1e-6, .dy = 1e-6, .width = 1e-6}},
        {"negative dx", blanks, refused("dx = -1e-06: must be"), {.units = "nm", .dx = -1e-6, .dy = 1e-6}},
        {"furlongs", blanks, refused("furlong"), {.units = "furlong", .dx = 1e-6, .dy = 1e-6}},
        {"steps", blanks, map(1e-6, 2e-6, 1e-9), steps},
        {"lengths", blanks, map(1e-6, 2e-6, 1e-9), {.units = "nm", .width = 5e-6, .height = 8e-6}},
        {"commas in lengths", "# Breite: 10,0 um\n# H\xC3\xB6he: 800,00 nm\n# Einheiten: nm\n" + tabs, map_in_nm},
        {"commas before three digits",
         "# Breite: 10,000 um\n# H\xF6he: 800,000 nm\n# Einheiten: nm\n" + with_commas(tabs), map_in_nm},
        {"which may separate thousands", "# Breite: 10,000 um\n# H\xF6he: 800,000 nm\n# Einheiten: nm\n" + tabs,
         refused("states no dx and no width")},
    });
    CHECK(read_text("# Width: 0.01 mm\n# Height: 8 um\n# Value units: um\n" + blanks).record.sentences().size() == 6);
}

TEST_CASE("Exports of Keyence, SPIP and Zygo are understood") {
    const std::string keyence =
        "\"Measured date\",\"2026-01-01 12:00:00\"\n\"XY Calibration\",\"350\",\"nm\"\n"
        "\"Horizontal\",\"5\"\n\"Vertical\",\"4\"\n\"Unit\",\"um\"\n\n\"Height\"\n";
    const std::string quoted = matrix(",", [](int i) { return '"' + height_text(i) + '"'; });
    const std::string german =
        "\"Messdatum\";\"01.01.2026\"\n\"XY-Kalibrierung\";\"350,0\";\"nm\"\n\"Horizontal\";\"5\"\n"
        "\"Vertikal\";\"4\"\n\"Einheit\";\"Mikrometer\"\n\"H\xC3\xB6he\"\n";
    const Decision pixels = map(350e-9, 350e-9, 1e-6);
    const auto with = [&](const std::string& from, const std::string& to) {
        return replaced(keyence, from, to) + quoted;
    };
    check_texts({
        {"Keyence", keyence + quoted, pixels},
        {"Keyence, no quotes", keyence + commas, pixels},
        {"Keyence, a pixel", with("\"nm\"", "\"nm/pixel\""), pixels},
        {"Keyence, German", german + with_commas(matrix(";")), pixels},
        {"Keyence, Justierung", with("XY Calibration", "XY-Justierung"), pixels},
        {"Keyence, Kalibrierung", with("XY Calibration", "XY-Kalibrierung"), pixels},
        {"Keyence, 6 columns", with("\"5\"", "\"6\""), refused("line 3: states 6 columns where there are 5")},
        {"Keyence, 9 rows", with("\"4\"", "\"9\""), refused("line 4: states 9 rows where there are 4")},
        {"Keyence, V", with("\"um\"", "\"V\""),
         refused("states \"V\" as the unit of the values, which is of no length")},
        {"Keyence, s", with("\"nm\"", "\"s\""), refused("states no dx and no width")},
    });
    const std::string spip =
        "# File Format = ASCII\n# x-pixels = 5\n# y-pixels = 4\n# x-length = 10000\n# y-length = 800\n";
    check_texts({
        {"SPIP", spip + "# z-unit = um\n# Start of Data:\n" + tabs,
         map(2e-6, 200e-9, 1e-6, {"width of line 4 (in nm, as SPIP writes it)"})},
        {"SPIP, counts", spip + "# Bit2nm = 0.5\n" + tabs, map(2e-6, 200e-9, 0.5e-9)},
        {"SPIP, counts of 1", spip + "# Bit2nm = 1\n# z-unit = um\n" + tabs, map(2e-6, 200e-9, 1e-6)},
        {"SPIP, units", spip + "# x-unit = um\n# z-unit = nm\n" + tabs, map(2e-3, 200e-9, 1e-9)},
        {"SPIP, both", spip + "# Bit2nm = 0.5\n# z-unit = um\n" + tabs, refused("heights may be in either")},
        {"SPIP, unit given",
         spip + "# Bit2nm = 0.5\n# z-unit = um\n" + tabs,
         map(2e-6, 200e-9, 1e-9, {}, {"states um for the heights; the option is used"}),
         {.units = "nm"}},
        {"SPIP, counts of 0", spip + "# Bit2nm = 0\n" + tabs, refused("Bit2nm \"0\"; must be a number greater than 0")},
        {"not SPIP", "# x-length = 1000\n# y-length = 800\n# z-unit = um\n" + tabs,
         refused("\"x-length\" has no unit")},
    });
    const std::string head =
        "Zygo XYZ Data File - Format 1\n0 3 0 0 \"Tue Aug 25 16:59:23 2026\"\n0 0 5 4 1 255\n10 20 5 "
        "4\n\"\"\n\"\"\n\"\"\n"
        "0 0 6.328e-07 0.5 1 0 5.5e-05 1787677163\n3 2 0 0 0 666666 0 \"\"\n0 0 1 33 0 0 0.1 60.4318 2 50\n"
        "0 1 100 0 0 0 0 0 0 0\n0 \"\"\n1 5 0\n#\n";
    const std::string zygo = head + triples("1{i}\t2{j} {z}\n") + "#\n";
    const std::string unstated = "Zygo XYZ states no unit of its heights, which are taken for um";
    Decision one_missing = map(5.5e-5, 5.5e-5, 1e-6, {"format: triples"}, {unstated});
    one_missing.missing = {0};
    check_texts({
        {"Zygo", zygo, map(5.5e-5, 5.5e-5, 1e-6, {"format: triples"}, {unstated})},
        {"Zygo, unit given", zygo, map(5.5e-5, 5.5e-5, 1e-9), {.units = "nm"}},
        {"Zygo, missing", replaced(zygo, "10\t20 -0.3", "10 20 No Data"), one_missing},
        {"Zygo, no pixel", replaced(zygo, "5.5e-05", "0"), refused("line 8: states no size of a pixel")},
        {"Zygo, no points", head.substr(0, head.size() - 2), refused("not a row of numbers")},
    });
}

TEST_CASE("Every separator and decimal sign gives the same matrix") {
    for (const std::string& text : {commas, matrix(";"), matrix("\t", height_text, "\t\n"), with_commas(matrix(";")),
                                    with_commas(tabs), with_commas(matrix("  ")), matrix(" ", height_text, "\r\n")})
        check_text({"matrix", gwyddion + text, map_in_nm});
}

TEST_CASE("Bad text is refused with the line and the cell") {
    check_texts({
        {"a word", gwyddion + "1 2 3\n4 five 6\n", refused("line 6: \"five\" is not a number")},
        {"a short row", gwyddion + "1 2 3 4\n5 6 7\n", refused("line 6: has 3 columns; must be 4 as in line 5")},
        {"a short row, commas", gwyddion + "1,2,3,4\n5,6,7\n", refused("line 6: has 3 columns")},
        {"1e999", gwyddion + "1 2 3 4\n5 6 7 1e999\n", refused("beyond the range")},
        {"infinite", gwyddion + "1 2 3 4\n5 6 7 infinite\n", refused("\"infinite\" is not a number")},
        {"constant", gwyddion + "1 1 1 1\n1 1 1 1\n", refused("constant height")},
        {"one row", gwyddion + "1 2 3 4\n", refused("at least 2 a side")},
        {"empty", "", refused("is empty")},
        {"a header alone", "# Width: 1 um\n", refused("not a row of numbers")},
        {"NUL", std::string("1 2\0 3\n", 7), refused("NUL")},
    });
}

TEST_CASE("Triples give the grid back in whatever order the points come") {
    std::vector<std::string> points;  // y falls: the map has y rising
    for (int i = 0; i < 20; ++i)
        points.push_back(std::to_string(i % 5 * 5) + "," + std::to_string(10 - 2 * (i / 5)) + "," +
                         height_text(i % 5 + 5 * (3 - i / 5)) + "\n");
    SECTION("x fastest") {}
    SECTION("y fastest") {
        std::stable_sort(points.begin(), points.end(),
                         [](const auto& a, const auto& b) { return std::stoi(a) < std::stoi(b); });
    }
    SECTION("backwards") { std::reverse(points.begin(), points.end()); }
    SECTION("in no order") {
        for (std::size_t k = 0; k < points.size(); ++k) std::swap(points[k], points[(k * 7 + 3) % points.size()]);
    }
    std::string text = "x [um],y [mm],z [nm]\n";
    for (const std::string& point : points) text += point;
    check_text({"triples", text, map(5e-6, 2e-3, 1e-9, {"format: triples"})});
}

TEST_CASE("Points that triples do not hold are missing, and positions lie on their grid within their digits") {
    std::string text = "x [um] y [um] z [um]\n", rounded = text;
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i)
            if (i != 3 && !(i == 1 && j == 4))
                text += std::to_string(i / 2.0) + " " + std::to_string(j) + " " + height_text(6 * j + i) + "\n";
    for (int i = 0; i < 150; ++i) {
        char line[64];
        std::snprintf(line, sizeof line, "%.2f %.1f %s\n", i % 30 / 3.0, i / 30 * 0.5, height_text(i).c_str());
        rounded += line;
    }
    check_texts({
        {"holes", text, {.dx = 0.5e-6, .unit = 1e-6, .size = 36, .rows = 6, .missing = {3, 9, 15, 21, 25, 27, 33}}},
        {"both ends rounded to 0.005",
         rounded,
         {.dx = 1e-6 / 3, .dx_error = 0.01 / (29 / 3.0), .unit = 1e-6, .size = 150, .rows = 5}},
    });
}

TEST_CASE("Points off a grid, twice at a place or without a unit are refused") {
    const std::string scattered = lines(40, [](int i) {
        return std::to_string(std::sin(i)) + " " + std::to_string(std::cos(3 * i)) + " " + std::to_string(i) + "\n";
    });
    const std::string grid = lines(
        40, [](int i) { return std::to_string(i % 8) + " " + std::to_string(i / 8) + " " + height_text(i) + "\n"; });
    const SurfaceOptions um{.units = "um"}, um_triples{.format = SurfaceFormat::triples, .units = "um"};
    check_texts({
        {"scattered", scattered,
         refused("format = triples with grid, format = matrix, or format = profile with column")},
        {"scattered triples", scattered, refused("lie on no regular grid"), um_triples},
        {"no unit", grid,
         refused("states no unit of the heights and none is given", "units = \"UNIT,UNIT\" (x and y, heights)")},
        {"steps", grid, refused("format = triples or format = matrix"), {.units = "um", .dx = 1e-6, .dy = 1e-6}},
        {"other steps", "# dx: 2 um\n" + grid, refused("disagrees with the positions"), um_triples},
        {"twice", grid + "3 2 1\n", refused("line 41: repeats the point of line 20"), um},
        {"no position", grid + "nan 2 1\n", refused("line 41: has no position"), um_triples},
        {"a unit", grid, {.dx = 1e-6, .unit = 1e-6, .size = 40, .rows = 5}, um},
        {"a matrix",
         grid,
         {.size = 120, .rows = 40},
         {.format = SurfaceFormat::matrix, .units = "um", .dx = 1e-6, .dy = 1e-6}},
    });
}

TEST_CASE("Missing points of a matrix are words or numbers, wherever they are", "[missing]") {
    const auto missing = [](std::vector<int> points) {
        Decision expected = map_in_nm;
        expected.missing = std::move(points);
        return expected;
    };
    for (const int at : {0, 4, 19, 7})
        for (const std::string word : {"nan", "NaN", "BAD", ""})
            check_text(
                {word, gwyddion + matrix(",", [&](int i) { return i == at ? word : height_text(i); }), missing({at})});
    for (const std::string word : {"nan", "NA", "N/A", "Bad", "No Data", "***"})  // the first row is not a title
        for (const std::string separator : {",", "\t", " "})
            check_text({word, gwyddion + matrix(separator, with(word, [](int, int j) { return j == 0; })),
                        missing({0, 1, 2, 3, 4})});
    for (const std::string word : {"-1.#IND", "1.#INF", "inf", "#N/A", "#VALUE!", "nan(ind)", "---"})
        for (const std::string separator : {",", "\t", " ", ";"})
            for (const int c : {0, 2, 4})
                check_text({word,
                            gwyddion + matrix(separator, with(word, [c](int i, int j) { return i == c && j != 2; })),
                            missing({c, 5 + c, 15 + c})});
}

TEST_CASE("A number for missing points is honoured where the header names it, and else refused", "[missing]") {
    const Cell cell = with("-9999", [](int i, int j) { return (i + j) % 4 == 1; });
    const std::string esri = "ncols 5\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9999\n";
    const std::string text = gwyddion + matrix(" ", cell),
                      points = "x [um],y [um],z [nm]\n" + triples("{i},{j},{z}\n", cell);
    Decision five = map(0, 0, 1e-9);
    five.missing = {1, 5, 9, 13, 17};
    Decision said = five;
    said.dx = 2e-6, said.says = {"5 missing (-9999, from line 6)\n"};
    check_texts({
        {"ESRI", esri + matrix(" ", cell), said, {.units = "um,nm"}},
        {"no header", text, refused("line 5: height -9999 nm is here and 4 times more", "missing = \"-9999\"")},
        {"given", text, five, {.missing = "-9999"}},
        {"heights", text, map(0, 0, 0), {.missing = "none"}},
        {"triples", points, refused("line 3: height -9999 nm")},
        {"triples, given", points, five, {.missing = "-9999"}},
    });
    // a customary mark within the range of the heights, as the only number without decimals
    const Cell within = [](int i) {
        return i % 9 == 4 ? std::string("-9999") : std::to_string((i * i % 11) * 3000 - 15000) + ".0";
    };
    const SurfaceOptions steps{.dx = 1e-6, .dy = 1e-6};
    for (const auto& [whole, options, count] :
         {std::tuple("x [um],z [A]\n" + rows("{x},{z}\n", 20, within), SurfaceOptions{}, 1),
          {"x [um],y [um],z [A]\n" + triples("{i},{j},{z}\n", within), {}, 4},
          {"# Value units: A\n" + matrix("\t", within), steps, 4}}) {
        Decision expected{.rows = static_cast<std::size_t>(count)};
        SurfaceOptions given = options;
        check_text({"alone", whole,
                    refused("height -9999 A is here and 1 times more, alone without decimals among the others"),
                    given});
        given.missing = "none";
        check_text({"heights", whole, expected, given});
        given.missing = "-9999";
        expected.missing = {4, 13};
        check_text({"given", whole, expected, given});
    }
}

TEST_CASE("Options that contradict the header of a map are used and reported", "[contradiction]") {
    const std::string points = "x [um],y [um],z [nm]\n" + triples("{i},{j},{z}\n");
    check_texts({
        {"all",
         gwyddion + tabs,
         map(3e-6, 4e-7, 1e-3, {},
             {"units = \"mm\" contradicts line 4, which states nm for the heights; the option is used",
              "dx = 3e-06 m contradicts line 2, which states 1e-05 m; the option is used",
              "height = 1.6e-06 m contradicts line 3, which states 8e-07 m; the option is used"}),
         {.units = "mm", .dx = 3e-6, .height = 1.6e-6}},
        {"the same", gwyddion + tabs, map_in_nm, {.units = "nm", .dx = 2e-6}},
        {"steps",
         gwyddion + tabs,
         map(3e-6, 4e-6, 1e-3, {}, {"units", "dx", "dy"}),
         {.units = "mm", .dx = 3e-6, .dy = 4e-6}},
        {"a length",
         gwyddion + tabs,
         map(2e-6, 200e-9, 1e-9, {},
             {"units = \"m,nm\" contradicts line 2, which states a length in um; that length is used"}),
         {.units = "m,nm"}},
        {"three units", points, map(1e-6, 1e-6, 1e-9), {.units = "um,um,nm"}},
        {"heights",
         points,
         map(1e-6, 1e-6, 1e-6, {},
             {"units = \"um\" contradicts line 1, which states nm for the heights; the option is used"}),
         {.units = "um"}},
    });
}

}  // namespace map_text_test
