// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"
#include "support/surfaces.hpp"

#include <functional>
#include <sstream>

namespace map_text_test {

using namespace fstiff;
using io::SurfaceOptions;

namespace {

constexpr test::FileReader read{};
const test::RefusalOf refusal(read);
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr int columns = 5, rows = 4;
/// In eighths: exact in binary, so that a factor of a power of ten rounds once.
double height(int i, int j) { return ((7 * (columns * j + i)) % 20 - 3) / 8.0; }

using Cell = std::function<std::string(int, int)>;
std::string plain(int i, int j) {
    std::ostringstream text;
    text << height(i, j);
    return text.str();
}
std::string matrix(const std::string& separator, const Cell& cell = plain, const std::string& end = "\n") {
    std::string text;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) text += cell(i, j) + (i + 1 < columns ? separator : end);
    return text;
}
std::string with_commas(std::string text) {
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}
const std::string gwyddion = "# Channel: z\n# Width: 10 um\n# Height: 800 nm\n# Value units: nm\n";

void check_map(const io::Surface& found, double dx, double dy, double unit) {
    REQUIRE(found.map().rows() == rows);
    REQUIRE(found.map().columns() == columns);
    CHECK(test::ulps(found.map().dx, dx) <= 1);
    CHECK(test::ulps(found.map().dy, dy) <= 1);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) REQUIRE(found.map().heights(j, i) == height(i, j) * unit);
}

}  // namespace

TEST_CASE("A matrix has its size and units from a Gwyddion header, however mixed") {
    // 1 ulp: width and count are each rounded once
    check_map(read(gwyddion + matrix("\t")), 10e-6 / 5, 800e-9 / 4, 1e-9);
    const auto found = read("# Width: 0.01 mm\n# Height: 8 \xC2\xB5m\n# Value units: \xB5m\n" + matrix(" "));
    check_map(found, 2e-6, 2e-6, 1e-6);
    CHECK(found.record.sentences().size() == 6);
    CHECK(found.record.format == io::SurfaceFormat::matrix);
}

TEST_CASE("A matrix has its pitch and a height factor from a header of keys") {
    const std::string header =
        "h=4 w=5\npixel size=3.5e-007 m\ndata unit=rad\nheight conversion factor (-> m)=2.5e-008\n";
    check_map(read(header + matrix(" ", plain, " \n")), 3.5e-7, 3.5e-7, 2.5e-8);
    check_map(read("dx: 1 um\ndy: 2 um\nunit: nm\n" + matrix(",")), 1e-6, 2e-6, 1e-9);
    CHECK(has(refusal("h=9 w=5\n" + header.substr(8) + matrix(" ")), "line 1: states 9 rows where there are 4"));
    CHECK(has(refusal("pixel size=1 um\ndata unit=rad\n" + matrix(" ")), "no height conversion factor"));
    CHECK(has(refusal("pixel size=1 um\ndata unit=nm\nheight conversion factor (-> m)=2e-8\n" + matrix(" ")),
              "disagrees"));
    CHECK(has(refusal("pixel size=1 um\npixel pitch=2 um\nunit=nm\n" + matrix(" ")), "disagrees with line 1"));
    CHECK(has(refusal("dx=1 um\ndy=1 um\nwidth=9 um\nunit=nm\n" + matrix(" ")), "disagrees with the spacing"));
}

TEST_CASE("A matrix without a physical size or a unit is refused with the option that resolves it") {
    CHECK(has(refusal(matrix(" ")), "dx and dy (between points) or width and height"));
    CHECK(has(refusal(matrix(" "), {.units = "nm", .dx = 1e-6}), "states no dy and no height"));
    CHECK(has(refusal(matrix(" "), {.dx = 1e-6, .dy = 1e-6}), "units = \"UNIT\""));
    CHECK(has(refusal("Width: 10\nHeight: 8\nunit: nm\n" + matrix(" ")), "line 1: \"width\" has no unit"));
    CHECK(has(refusal(matrix(" "), {.units = "nm", .dx = 1e-6, .dy = 1e-6, .width = 1e-6}), "both given"));
    CHECK(has(refusal(matrix(" "), {.units = "nm", .dx = -1e-6, .dy = 1e-6}), "dx = -1e-06: must be"));
    CHECK(has(refusal(matrix(" "), {.units = "furlong", .dx = 1e-6, .dy = 1e-6}), "furlong"));
    check_map(read(matrix(" "), {.units = "nm", .dx = 1e-6, .dy = 2e-6}), 1e-6, 2e-6, 1e-9);
    check_map(read(matrix(" "), {.units = "nm", .width = 5e-6, .height = 8e-6}), 1e-6, 2e-6, 1e-9);
    check_map(read("Width: 10\nHeight: 8\n" + matrix(" "), {.units = "um,nm"}), 2e-6, 2e-6, 1e-9);
}

TEST_CASE("An export of Keyence has its pitch, counts and unit in quoted cells") {
    const std::string header =
        "\"Measured date\",\"2026-01-01 12:00:00\"\n\"XY Calibration\",\"350\",\"nm\"\n"
        "\"Horizontal\",\"5\"\n\"Vertical\",\"4\"\n\"Unit\",\"um\"\n\n\"Height\"\n";
    const Cell quoted = [](int i, int j) { return '"' + plain(i, j) + '"'; };
    check_map(read(header + matrix(",", quoted)), 350e-9, 350e-9, 1e-6);
    check_map(read(header + matrix(",")), 350e-9, 350e-9, 1e-6);
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = header;
        changed.replace(changed.find(from), from.size(), to);
        return changed + matrix(",", quoted);
    };
    check_map(read(with("\"nm\"", "\"nm/pixel\"")), 350e-9, 350e-9, 1e-6);
    check_map(read(with("XY Calibration", "XY-Justierung")), 350e-9, 350e-9, 1e-6);
    check_map(read(with("XY Calibration", "XY-Kalibrierung")), 350e-9, 350e-9, 1e-6);
    const std::string german =
        "\"Messdatum\";\"01.01.2026\"\n\"XY-Kalibrierung\";\"350,0\";\"nm\"\n\"Horizontal\";\"5\"\n"
        "\"Vertikal\";\"4\"\n\"Einheit\";\"Mikrometer\"\n\"H\xC3\xB6he\"\n";
    check_map(read(german + with_commas(matrix(";"))), 350e-9, 350e-9, 1e-6);
    CHECK(has(refusal(with("\"5\"", "\"6\"")), "line 3: states 6 columns where there are 5"));
    CHECK(has(refusal(with("\"4\"", "\"9\"")), "line 4: states 9 rows where there are 4"));
    CHECK(has(refusal(with("\"um\"", "\"V\"")), "\"V\" is not a unit of length"));
    CHECK(has(refusal(with("\"nm\"", "\"s\"")), "states no dx and no width"));
}

TEST_CASE("An export of SPIP has its lengths in nm, and its heights in a unit or in counts of so many nm") {
    const std::string header =
        "# File Format = ASCII\n# x-pixels = 5\n# y-pixels = 4\n# x-length = 10000\n# y-length = 800\n";
    const auto found = read(header + "# z-unit = um\n# Start of Data:\n" + matrix("\t"));
    check_map(found, 2e-6, 200e-9, 1e-6);
    CHECK(has(test::said(found, "spacing"), "width of line 4 (in nm, as SPIP writes it)"));
    check_map(read(header + "# Bit2nm = 0.5\n" + matrix("\t")), 2e-6, 200e-9, 0.5e-9);
    check_map(read(header + "# Bit2nm = 1\n# z-unit = um\n" + matrix("\t")), 2e-6, 200e-9, 1e-6);
    check_map(read(header + "# x-unit = um\n# z-unit = nm\n" + matrix("\t")), 2e-3, 200e-9, 1e-9);
    CHECK(has(refusal(header + "# Bit2nm = 0.5\n# z-unit = um\n" + matrix("\t")), "heights may be in either"));
    check_map(read(header + "# Bit2nm = 0.5\n# z-unit = um\n" + matrix("\t"), {.units = "nm"}), 2e-6, 200e-9, 1e-9);
    CHECK(has(refusal(header + "# Bit2nm = 0\n" + matrix("\t")), "Bit2nm \"0\"; must be a number greater than 0"));
    CHECK(has(refusal("# x-length = 1000\n# y-length = 800\n# z-unit = um\n" + matrix("\t")),
              "\"x-length\" has no unit"));
}

TEST_CASE("A comma in the lengths of a header is decimal unless it may separate thousands") {
    const std::string lengths = "# Breite: 10,0 um\n# H\xC3\xB6he: 800,00 nm\n# Einheiten: nm\n";
    check_map(read(lengths + matrix("\t")), 2e-6, 200e-9, 1e-9);
    const std::string three = "# Breite: 10,000 um\n# H\xF6he: 800,000 nm\n# Einheiten: nm\n";
    check_map(read(three + with_commas(matrix("\t"))), 2e-6, 200e-9, 1e-9);
    CHECK(has(refusal(three + matrix("\t")), "states no dx and no width"));
}

TEST_CASE("Options replace the header of a matrix") {
    check_map(read(gwyddion + matrix("\t"), {.units = "mm", .dx = 3e-6, .dy = 4e-6}), 3e-6, 4e-6, 1e-3);
}

TEST_CASE("Every separator and decimal sign gives the same matrix") {
    check_map(read(gwyddion + matrix(",")), 2e-6, 200e-9, 1e-9);
    check_map(read(gwyddion + matrix(";")), 2e-6, 200e-9, 1e-9);
    check_map(read(gwyddion + matrix("\t", plain, "\t\n")), 2e-6, 200e-9, 1e-9);
    check_map(read(gwyddion + with_commas(matrix(";"))), 2e-6, 200e-9, 1e-9);
    check_map(read(gwyddion + with_commas(matrix("\t"))), 2e-6, 200e-9, 1e-9);
    check_map(read(gwyddion + with_commas(matrix("  "))), 2e-6, 200e-9, 1e-9);
    check_map(read(gwyddion + matrix(" ", plain, "\r\n")), 2e-6, 200e-9, 1e-9);
}

TEST_CASE("Missing points of a matrix are words or empty cells, wherever they are") {
    const auto [i, j] = GENERATE(std::pair{0, 0}, std::pair{4, 0}, std::pair{4, 3}, std::pair{2, 1});
    const std::string word = GENERATE("nan", "NaN", "BAD", "");
    CAPTURE(i, j, word);
    const auto found =
        read(gwyddion + matrix(",", [&, x = i, y = j](int a, int b) { return a == x && b == y ? word : plain(a, b); }));
    CHECK(test::missing(found) == 1);
    CHECK(std::isnan(found.map().heights(j, i)));
    CHECK(found.map().heights(1, 1) == height(1, 1) * 1e-9);
    CHECK(found.map().columns() == columns);
}

TEST_CASE("Triples give the grid back in whatever order the points come") {
    std::vector<std::string> lines;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            lines.push_back(std::to_string(i * 5) + "," + std::to_string(10 - 2 * j) + "," + plain(i, rows - 1 - j));
    SECTION("x fastest") {}
    SECTION("y fastest") {
        std::stable_sort(lines.begin(), lines.end(),
                         [](const auto& a, const auto& b) { return std::stoi(a) < std::stoi(b); });
    }
    SECTION("backwards") { std::reverse(lines.begin(), lines.end()); }
    SECTION("in no order") {
        for (std::size_t k = 0; k < lines.size(); ++k) std::swap(lines[k], lines[(k * 7 + 3) % lines.size()]);
    }
    std::string text = "x [um],y [mm],z [nm]\n";
    for (const std::string& line : lines) text += line + "\n";
    const auto found = read(text);
    // written with falling y: the map has y rising
    REQUIRE(found.map().rows() == rows);
    CHECK(test::ulps(found.map().dx, 5e-6) <= 1);
    CHECK(test::ulps(found.map().dy, 2e-3) <= 1);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) REQUIRE(found.map().heights(j, i) == height(i, j) * 1e-9);
    CHECK(found.record.format == io::SurfaceFormat::triples);
}

TEST_CASE("Points that triples do not hold are missing, and whole missing lines keep their place") {
    std::string text = "x [um] y [um] z [um]\n";
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i)
            if (i != 3 && !(i == 1 && j == 4))
                text += std::to_string(i / 2.0) + " " + std::to_string(j) + " " + std::to_string(i * j) + "\n";
    const auto found = read(text);
    REQUIRE(found.map().columns() == 6);
    CHECK(test::missing(found) == 7);
    CHECK(std::isnan(found.map().heights(2, 3)));
    CHECK(std::isnan(found.map().heights(4, 1)));
    CHECK(found.map().heights(5, 5) == 25 * 1e-6);
    CHECK(test::ulps(found.map().dx, 0.5e-6) <= 1);
}

TEST_CASE("Positions that are rounded when printed still lie on their grid") {
    std::string text = "x [um] y [um] z [um]\n";
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 30; ++i) {
            char line[64];
            std::snprintf(line, sizeof line, "%.2f %.1f %d\n", i / 3.0, j * 0.5, (i * j) % 7);
            text += line;
        }
    const auto found = read(text);
    CHECK(found.map().columns() == 30);
    // both ends are rounded to 0.005
    CHECK(test::relative_error(found.map().dx, 1e-6 / 3) <= 0.01 / (29 / 3.0));
}

TEST_CASE("Points off a grid, twice at a place or without a unit are refused") {
    std::string scattered, grid;
    for (int i = 0; i < 40; ++i)
        scattered +=
            std::to_string(std::sin(i)) + " " + std::to_string(std::cos(3 * i)) + " " + std::to_string(i) + "\n";
    for (int i = 0; i < 40; ++i)
        grid += std::to_string(i % 8) + " " + std::to_string(i / 8) + " " + std::to_string((i * i) % 11) + "\n";
    CHECK(has(refusal(scattered), "format = triples, format = matrix, or format = profile with column"));
    CHECK(has(refusal(scattered, {.format = io::SurfaceFormat::triples, .units = "um"}), "lie on no regular grid"));
    CHECK(has(refusal(grid), "states no units and none are given"));
    CHECK(has(refusal(grid, {.units = "um", .dx = 1e-6, .dy = 1e-6}), "format = triples or format = matrix"));
    CHECK(has(refusal("# dx: 2 um\n" + grid, {.format = io::SurfaceFormat::triples, .units = "um"}),
              "disagrees with the positions"));
    CHECK(has(refusal(grid + "3 2 1\n", {.units = "um"}), "line 41: repeats the point of line 20"));
    CHECK(has(refusal(grid + "nan 2 1\n", {.format = io::SurfaceFormat::triples, .units = "um"}),
              "line 41: has no position"));
    CHECK(read(grid, {.units = "um"}).map().size() == 40);
    CHECK(read(grid, {.format = io::SurfaceFormat::matrix, .units = "um", .dx = 1e-6, .dy = 1e-6}).map().columns() ==
          3);
}

TEST_CASE("Bad text is refused with the line and the cell") {
    CHECK(has(refusal(gwyddion + "1 2 3\n4 five 6\n"), "line 6: \"five\" is not a number"));
    CHECK(has(refusal(gwyddion + "1 2 3 4\n5 6 7\n"), "line 6: has 3 columns; must be 4 as in line 5"));
    CHECK(has(refusal(gwyddion + "1,2,3,4\n5,6,7\n"), "line 6: has 3 columns"));
    CHECK(has(refusal(gwyddion + "1 2 3 4\n5 6 7 1e999\n"), "beyond the range"));
    CHECK(has(refusal(gwyddion + "1 2 3 4\n5 6 7 infinite\n"), "\"infinite\" is not a number"));
    CHECK(has(refusal(gwyddion + "1 1 1 1\n1 1 1 1\n"), "constant height"));
    CHECK(has(refusal(gwyddion + "1 2 3 4\n"), "at least 2 a side"));
    CHECK(has(refusal(""), "is empty"));
    CHECK(has(refusal("# Width: 1 um\n"), "not a row of numbers"));
    CHECK(has(refusal(std::string("1 2\0 3\n", 7)), "NUL"));
    CHECK(has(refusal("# Width: -3 um\n# Height: 1 um\n" + matrix(" ")), "must be greater than 0"));
    CHECK(has(refusal("# Width: 3 um\n# Width: 4 um\n" + matrix(" ")), "disagrees with line 1"));
}

TEST_CASE("A number for missing points is honoured where the header names it, and else refused", "[missing]") {
    const Cell cell = [](int i, int j) { return (i + j) % 4 == 1 ? std::string("-9999") : plain(i, j); };
    const std::string esri = "ncols 5\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9999\n";
    const auto found = read(esri + matrix(" ", cell), {.units = "um,nm"});
    CHECK(test::missing(found) == 5);
    CHECK(test::ulps(found.map().dx, 2e-6) <= 1);
    CHECK(has(found.record.sentences().back(), "5 missing (-9999, from line 6)"));
    CHECK(std::isnan(found.map().heights(0, 1)));
    CHECK(found.map().heights(0, 0) == height(0, 0) * 1e-9);
    CHECK(has(refusal(gwyddion + matrix(" ", cell)), "line 5: height -9999 nm is here and 4 times more"));
    CHECK(has(refusal(gwyddion + matrix(" ", cell)), "missing = \"-9999\""));
    CHECK(test::missing(read(gwyddion + matrix(" ", cell), {.missing = "-9999"})) == 5);
    CHECK(test::missing(read(gwyddion + matrix(" ", cell), {.missing = "none"})) == 0);
    std::string triples = "x [um],y [um],z [nm]\n";
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            triples += std::to_string(i) + "," + std::to_string(j) + "," + cell(i, j) + "\n";
    CHECK(has(refusal(triples), "line 3: height -9999 nm"));
    CHECK(test::missing(read(triples, {.missing = "-9999"})) == 5);
}

TEST_CASE("A customary mark within the range of the heights is refused as the only number without decimals",
          "[missing]") {
    const auto cell = [](int i) {
        return i % 9 == 4 ? std::string("-9999") : std::to_string((i * i % 11) * 3000 - 15000) + ".0";
    };
    std::string profile = "x [um],z [A]\n", triples = "x [um],y [um],z [A]\n", matrix = "# Value units: A\n";
    for (int i = 0; i < 40; ++i) {
        profile += std::to_string(i) + "," + cell(i) + "\n";
        triples += std::to_string(i % 8) + "," + std::to_string(i / 8) + "," + cell(i) + "\n";
        matrix += cell(i) + (i % 8 == 7 ? "\n" : "\t");
    }
    io::SurfaceOptions steps;
    steps.dx = steps.dy = 1e-6;
    for (const auto& [text, options] : {std::pair{profile, io::SurfaceOptions{}}, {triples, {}}, {matrix, steps}}) {
        CAPTURE(text.substr(0, 20));
        CHECK(has(refusal(text, options),
                  "height -9999 A is here and 3 times more, alone without decimals among the others"));
        io::SurfaceOptions given = options;
        given.missing = "-9999";
        CHECK(test::missing(read(text, given)) == 4);
        given.missing = "none";
        CHECK(test::missing(read(text, given)) == 0);
    }
}

TEST_CASE("Words for missing points are the same in every form of a map", "[missing]") {
    for (const char* word : {"nan", "NA", "N/A", "Bad", "No Data", "***"})
        for (const char* separator : {",", "\t", " "}) {
            INFO(word << separator);
            const Cell cell = [&](int i, int j) { return j == 0 ? std::string(word) : plain(i, j); };
            const auto found = read(gwyddion + matrix(separator, cell));  // the first row is not a title
            CHECK(found.map().rows() == rows);
            CHECK(test::missing(found) == 5);
        }
}

TEST_CASE("Numbers that are none are missing in every column of a map", "[missing]") {
    for (const char* word : {"-1.#IND", "1.#INF", "inf", "#N/A", "#VALUE!", "nan(ind)", "---"})
        for (const char* separator : {",", "\t", " ", ";"})
            for (const int column : {0, 2, columns - 1}) {
                CAPTURE(word, separator, column);
                const Cell cell = [&](int i, int j) { return i == column && j != 2 ? std::string(word) : plain(i, j); };
                const auto found = read(gwyddion + matrix(separator, cell));
                CHECK(test::missing(found) == 3);
                CHECK(found.map().heights(2, column) == height(column, 2) * 1e-9);
            }
}

TEST_CASE("Options that contradict the header of a map are used and reported", "[contradiction]") {
    const auto found = read(gwyddion + matrix("\t"), {.units = "mm", .dx = 3e-6, .height = 1.6e-6});
    check_map(found, 3e-6, 4e-7, 1e-3);
    CHECK(found.record.warnings ==
          std::vector<std::string>{
              "dx = 3e-06 m contradicts line 2, which states 1e-05 m; the option is used",
              "height = 1.6e-06 m contradicts line 3, which states 8e-07 m; the option is used",
              "units = \"mm\" contradicts line 4, which states nm for the heights; the option is used"});
    CHECK(read(gwyddion + matrix("\t"), {.units = "nm", .dx = 2e-6}).record.warnings.empty());
    const auto kept = read(gwyddion + matrix("\t"), {.units = "m,nm"});
    CHECK(kept.record.warnings ==
          std::vector<std::string>{
              "units = \"m,nm\" contradicts line 2, which states a length in um; that length is used"});
    std::string triples = "x [um],y [um],z [nm]\n";
    for (int i = 0; i < 30; ++i)
        triples += std::to_string(i % 6) + "," + std::to_string(i / 6) + "," + std::to_string(i * i % 7) + "\n";
    CHECK(read(triples, {.units = "um,um,nm"}).record.warnings.empty());
    CHECK(read(triples, {.units = "um"}).record.warnings ==
          std::vector<std::string>{
              "units = \"um\" contradicts line 1, which states nm for the heights; the option is used"});
}

TEST_CASE("Zygo's XYZ text has its pixel in line 8 and heights in um", "[zygo]") {
    const std::string head =
        "Zygo XYZ Data File - Format 1\n0 3 0 0 \"Tue Aug 25 16:59:23 2026\"\n0 0 5 4 1 255\n10 20 5 "
        "4\n\"\"\n\"\"\n\"\"\n"
        "0 0 6.328e-07 0.5 1 0 5.5e-05 1787677163\n3 2 0 0 0 666666 0 \"\"\n0 0 1 33 0 0 0.1 60.4318 2 50\n"
        "0 1 100 0 0 0 0 0 0 0\n0 \"\"\n1 5 0\n#\n";
    std::string text = head;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            text += std::to_string(10 + i) + (i % 2 ? "\t" : " ") + std::to_string(20 + j) + " " + plain(i, j) + "\n";
    const auto found = read(text + "#\n");
    check_map(found, 5.5e-5, 5.5e-5, 1e-6);
    CHECK(found.record.format == io::SurfaceFormat::triples);
    REQUIRE(found.record.warnings.size() == 1);
    CHECK(has(found.record.warnings[0], "Zygo XYZ states no unit of its heights, which are taken for um"));
    const auto given = read(text, {.units = "nm"});
    check_map(given, 5.5e-5, 5.5e-5, 1e-9);
    CHECK(given.record.warnings.empty());
    const auto missing = read(head + "10 20 No Data\n" + text.substr(text.find('\n', head.size()) + 1));
    CHECK(test::missing(missing) == 1);
    std::string unknown = text;
    unknown.replace(unknown.find("5.5e-05"), 7, "0      ");
    CHECK(has(refusal(unknown), "line 8: states no size of a pixel"));
    CHECK(has(refusal(head.substr(0, head.size() - 2)), "not a row of numbers"));
}

}  // namespace map_text_test
