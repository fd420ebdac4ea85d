// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>

#include "support/accuracy.hpp"
#include "support/skip.hpp"
#include "support/surfaces.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <sstream>

namespace profile_text_test {

using namespace fstiff;
using io::SurfaceOptions;

namespace {

/// \p text read as a profile.
io::Surface read(const std::string& text, SurfaceOptions options = {}) {
    options.format = io::SurfaceFormat::profile;
    return io::read_surface(text, "file.txt", options);
}
io::Surface read(const std::filesystem::path& path, SurfaceOptions options = {}) {
    options.format = io::SurfaceFormat::profile;
    return io::read_surface(path, options);
}

std::string refusal(const std::string& text, const SurfaceOptions& options = {}) {
    return test::refusal([&] { (void)read(text, options); });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The height of row i in the file's unit: changes sign and digits, repeats after 10.
int height(int i) { return (i * 7) % 10 - 3; }

/// Rows of position i/2 and height(i)/10, written by \p row(i, "0.5", "-0.3").
using Row = std::function<std::string(const std::string&, const std::string&)>;
std::string rows(const Row& row, int count = 20) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        const int z = height(i);
        text += row(std::to_string(i / 2) + (i % 2 ? ".5" : ".0"),
                    std::string(z < 0 ? "-0." : "0.") + std::to_string(std::abs(z)));
    }
    return text;
}
std::string with_commas(std::string text) {
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

/// Checks the profile that rows() writes, with lengths in \p unit and heights in \p height_unit.
void check_rows(const io::Surface& read, double unit, double height_unit) {
    REQUIRE(read.profile().size() == 20);
    CHECK(test::ulps(read.profile().spacing, 0.5 * unit) <= 2);
    for (int i = 0; i < 20; ++i) {
        const double truth = height(i) / 10.0 * height_unit;
        REQUIRE(std::abs(read.profile().heights[static_cast<std::size_t>(i)] - truth) <= 2.3e-16 * std::abs(truth));
    }
}

}  // namespace

TEST_CASE("Comma, semicolon, tab and blanks separate columns") {
    const SurfaceOptions units{.units = "um,nm"};
    const auto comma = read(rows([](auto x, auto z) { return x + "," + z + "\n"; }), units);
    check_rows(comma, 1e-6, 1e-9);
    CHECK(has(test::said(comma, "separator"), "comma"));
    const auto spaced = read(rows([](auto x, auto z) { return x + ", " + z + "\n"; }), units);
    check_rows(spaced, 1e-6, 1e-9);
    const auto semicolon = read(rows([](auto x, auto z) { return x + ";" + z + "\n"; }), units);
    check_rows(semicolon, 1e-6, 1e-9);
    CHECK(has(test::said(semicolon, "separator"), "semicolon"));
    const auto tab = read(rows([](auto x, auto z) { return x + "\t" + z + "\n"; }), units);
    check_rows(tab, 1e-6, 1e-9);
    CHECK(has(test::said(tab, "separator"), "tab"));
    const auto blanks = read(rows([](auto x, auto z) { return "  " + x + "   " + z + "  \n"; }), units);
    check_rows(blanks, 1e-6, 1e-9);
    CHECK(has(test::said(blanks, "separator"), "blanks"));
    const auto mixed = read(rows([](auto x, auto z) { return " " + x + " \t " + z + "\t\n"; }), units);
    check_rows(mixed, 1e-6, 1e-9);
    CHECK(test::said(comma, "units").ends_with("from options"));
    CHECK(comma.profile().size() == 20);
    CHECK(test::missing(comma) == 0);
    CHECK(comma.record.details.size() == 6);
}

TEST_CASE("The decimal sign may be a comma where the comma does not separate") {
    const SurfaceOptions units{.units = "um,nm"};
    for (const std::string separator : {";", "\t", " ", "; "}) {
        CAPTURE(separator);
        const auto read_back =
            read(rows([&](auto x, auto z) { return with_commas(x) + separator + with_commas(z) + "\r\n"; }), units);
        check_rows(read_back, 1e-6, 1e-9);
        CHECK(has(test::said(read_back, "separator"), "decimal comma"));
    }
    // one column of "0,3": no equally spaced positions, so the comma is decimal
    const auto one = read(rows([](auto, auto z) { return with_commas(z) + "\n"; }), {.units = "nm", .spacing = 0.5e-6});
    check_rows(one, 1e-6, 1e-9);
    CHECK(has(test::said(one, "separator"), "none"));
    // but "1,5" with positions 0, 1, 2, ... are two columns of whole numbers
    std::string whole;
    for (int i = 0; i < 20; ++i) whole += std::to_string(i) + "," + std::to_string(std::abs(height(i))) + "\n";
    const auto two = read(whole, units);
    CHECK(has(test::said(two, "separator"), "comma"));
    CHECK(test::relative_error(two.profile().spacing, 1e-6) < 1e-15);
    // whole numbers in the first rows do not hide the decimal commas of later ones
    std::string late = "0;1\n1;2\n";
    for (int i = 2; i < 20; ++i) late += std::to_string(i) + ";1,5\n";
    CHECK(has(test::said(read(late, units), "separator"), "decimal comma"));
}

TEST_CASE("Every kind of line end, a byte order mark, comments and blank lines are understood") {
    const SurfaceOptions units{.units = "um,nm"};
    for (const std::string end : {"\n", "\r\n", "\r\r\n", "\r", "\n\n", ",,\r\n"}) {
        CAPTURE(end.size());
        check_rows(read(rows([&](auto x, auto z) { return x + "," + z + end; }), units), 1e-6, 1e-9);
    }
    const std::string plain = rows([](auto x, auto z) { return x + "," + z + "\n"; });
    check_rows(read("\xEF\xBB\xBF" + plain, units), 1e-6, 1e-9);
    check_rows(read("# one\n% two\n// three\n; four\n! five\n\n" + plain + "\n# end\n\n", units), 1e-6, 1e-9);
    check_rows(read(plain.substr(0, plain.size() - 1), units), 1e-6, 1e-9);  // no line end after the last row
    check_rows(read(rows([](auto x, auto z) { return "\"" + x + "\",\"" + z + "\"\n"; }), units), 1e-6, 1e-9);
    check_rows(read(rows([](auto x, auto z) { return x + "," + z + "  # noted\n"; }), units), 1e-6, 1e-9);
    const auto headed = read("Company\nDate,2014-01-02\nx,z\n" + plain, units);
    check_rows(headed, 1e-6, 1e-9);
    CHECK(test::said(headed, "header") == "3 lines");
}

TEST_CASE("Units are taken from the header wherever it states them, and options replace them") {
    const std::string plain = rows([](auto x, auto z) { return x + "," + z + "\n"; });
    for (const std::string header :
         {"Lateral um,Raw Nanometer", "x [um]; z [nm]", "x [um],z [nm]", "x (\xC2\xB5m),z (nm)", "x (\xB5m),z (nm)",
          "x/\xCE\xBCm,z/nm", "um,nm", "# x [um]; z [nm]", "# x (um) z (nm)", "# x in um, z in nm",
          "x [um],z [nm]\nposition,height", "\"Position (um)\",\"Height (nm)\"", "% um nm"}) {
        CAPTURE(header);
        const auto result = read(header + "\n" + plain);
        check_rows(result, 1e-6, 1e-9);
        CHECK(has(test::said(result, "units"), "from line 1"));
    }
    const auto replaced = read("x [um],z [nm]\n" + plain, {.units = "mm,um"});
    check_rows(replaced, 1e-3, 1e-6);
    CHECK(test::said(replaced, "units").ends_with("from options"));
    check_rows(read(plain, {.units = "um"}), 1e-6, 1e-6);  // one unit for both
    const std::string one = rows([](auto, auto z) { return z + "\n"; });
    check_rows(read("z [nm]\n" + one, {.spacing = 0.5e-6}), 1e-6, 1e-9);
    check_rows(read("Resolution,0.5 um/sample\nz [nm]\n" + one), 1e-6, 1e-9);
}

TEST_CASE("A file without a unit is refused, whatever looks like one") {
    const std::string plain = rows([](auto x, auto z) { return x + "," + z + "\n"; });
    for (const std::string header :
         {"", "x,z\n", "Location,0.0 um, 0.0 um\n", "Range,524 um\n", "x [s],z [V]\n", "x,z [nm]\n", "made in,um\n"}) {
        CAPTURE(header);
        const std::string text = refusal(header + plain);
        CHECK(has(text, "file.txt"));
        CHECK(has(text, "unit"));
        CHECK(has(text, "um"));
    }
    CHECK(has(refusal(plain, {.units = "um,parsec"}), "parsec"));
    CHECK(has(refusal(plain, {.units = "um,nm,mm"}), "units = "));
}

TEST_CASE("Positions printed with few digits are equally spaced within their digits") {
    // steps of 0.156 printed to 0.1: 0.0 0.2 0.3 0.5 0.6 0.8 0.9 1.1
    std::string coarse, coarser;
    for (int i = 0; i < 200; ++i) {
        char line[64];
        std::snprintf(line, sizeof line, "%.1f,%d\n", 0.15625 * i, height(i));
        coarse += line;
        std::snprintf(line, sizeof line, "%.0f,%d\n", 0.15625 * i, height(i));
        coarser += line;
    }
    const auto read_coarse = read("x [um],z [nm]\n" + coarse);
    CHECK(test::relative_error(read_coarse.profile().spacing, 0.15625e-6) < 0.1 / 31);  // both ends to 0.05 of 31
    CHECK(has(test::said(read_coarse, "spacing"), "mean step"));
    // neighbours that share a printed position are allowed where the step is below the last digit
    CHECK(test::relative_error(read("x [um],z [nm]\n" + coarser).profile().spacing, 0.15625e-6) < 1.0 / 31);
    const auto stated = read("Resolution,0.156 um/sample\nx [um],z [nm]\n" + coarse);
    CHECK(has(test::said(stated, "spacing"), "agrees with line 1"));
    CHECK(has(refusal("Resolution,0.3 um/sample\nx [um],z [nm]\n" + coarse), "disagrees"));
    CHECK(read("x [um],z [nm]\n" + coarse, {.spacing = 0.156e-6}).profile().spacing == 0.156e-6);
}

TEST_CASE("Unequal steps are seen through the digits, and a missing row in whole steps too") {
    // x of each of 200 rows, as a printf format and a function of the row
    const auto text = [](const char* format, auto&& position) {
        std::string rows = "x [um],z [nm]\n";
        for (int i = 0; i < 200; ++i) {
            char line[64];
            std::snprintf(line, sizeof line, format, static_cast<double>(position(i)));
            rows += line + ("," + std::to_string(height(i))) + "\n";
        }
        return rows;
    };
    // trailing zeros dropped: 29, 30.5, 31.5 ... are printed to a tenth; a row is missing in 0, 1, 2, 4, 5
    const std::string shifted = refusal(text("%g", [](int i) { return i < 30 ? i : i + 0.5; }));
    CHECK(has(shifted, "line 32"));
    CHECK(has(shifted, "30.5"));
    for (const char* format : {"%.0f", "%.1f", "%.3f", "%g"})
        for (const int missing : {1, 3, 100, 197}) {
            const std::string gap = refusal(text(format, [missing](int i) { return i < missing ? i : i + 1; }));
            INFO(format << ' ' << missing << ' ' << gap);
            CHECK(has(gap, "line " + std::to_string(missing + 2)));
            CHECK(has(gap, "equally spaced"));
        }
    // rounded equal steps are no gap: decimals, six significant digits, powers of ten
    for (const char* format : {"%.0f", "%.1f", "%g", "%.4e"})
        for (const double step : {0.15625, 1.03, 7.77}) {
            INFO(format << ' ' << step);
            const auto result = read(text(format, [step](int i) { return step * i; }));
            CHECK(test::relative_error(result.profile().spacing, step * 1e-6) < 1 / (199 * step));
        }
}

TEST_CASE("Falling positions turn the profile round") {
    std::string text = "x [um],z [nm]\n";
    for (int i = 0; i < 20; ++i) text += std::to_string(19 - i) + ".0," + std::to_string(height(i)) + "\n";
    const auto result = read(text);
    CHECK(has(test::said(result, "columns"), "falling: turned round"));
    CHECK(test::relative_error(result.profile().spacing, 1e-6) < 1e-15);
    CHECK(std::abs(result.profile().heights.front() - height(19) * 1e-9) < 1e-24);
}

TEST_CASE("An empty cell is a missing point") {
    std::string text = "x [um],z [nm]\n";
    for (int i = 0; i < 30; ++i)
        text += std::to_string(i) + ".0," + (i % 5 == 2 ? "" : std::to_string(height(i))) + "\n";
    const auto result = read(text);
    CHECK(result.profile().size() == 30);
    CHECK(test::missing(result) == 6);
    CHECK(std::isnan(result.profile().heights[7]));
    CHECK_FALSE(std::isnan(result.profile().heights[8]));
}

TEST_CASE("A column may be chosen among many, and more than two need a choice") {
    const std::string text = rows([](auto x, auto z) { return x + ",9," + z + ",8\n"; });
    CHECK(has(refusal(text, {.units = "um,nm"}), "4 columns"));
    check_rows(read(text, {.units = "um,nm", .column = 3}), 1e-6, 1e-9);
    check_rows(read(text, {.units = "nm", .spacing = 0.5e-6, .column = 3}), 1e-6, 1e-9);
    CHECK(has(refusal(text, {.units = "um,nm", .column = 5}), "column = 5: must be between 1 and 4"));
    CHECK(has(refusal(text, {.units = "um,nm", .column = 1}), "spacing"));
    const auto two =
        read(rows([](auto x, auto z) { return z + "," + x + "\n"; }), {.units = "nm", .spacing = 0.5e-6, .column = 1});
    check_rows(two, 1e-6, 1e-9);
}

TEST_CASE("Bad input is refused in one sentence with file and line and value and allowed range") {
    const SurfaceOptions units{.units = "um,nm"};
    const std::string plain = rows([](auto x, auto z) { return x + "," + z + "\n"; });
    CHECK(has(refusal(""), "file.txt: is empty"));
    CHECK(has(refusal("\n \r\n\t\n"), "blank lines"));
    CHECK(has(refusal(std::string("1,2\n\0", 5)), "binary"));
    CHECK(has(refusal("only words\nand more\n"), "line 1: \"only words\""));
    for (const std::string word : {"word", "infinite", "1.0#x", "1.0x", "0x10", "1e", "--1", "1 2"}) {
        CAPTURE(word);
        const std::string text = refusal(plain + "10.0," + word + "\n", units);
        CHECK(has(text, "file.txt, line 21: "));
        CHECK(has(text, "\"" + word + "\""));
        CHECK(has(text, "allowed"));
    }
    CHECK(has(refusal(plain + "10.0,1e400\n", units), "line 21: \"1e400\" is beyond"));
    CHECK(has(refusal(plain + "10.0,1,2\n", units), "line 21: has 3 columns; must be 2 as in line 1"));
    CHECK(has(refusal(plain + "9.0,1\n", units), "line 21: position 9 um follows 9.5 um"));
    CHECK(has(refusal(plain + "9.5,1\n", units), "line 21: position 9.5 um follows 9.5 um"));
    CHECK(has(refusal(plain + "11.0,1\n", units),
              "line 21: position 11 um is a step of 1.5 um where the usual one is 0.5 um"));
    CHECK(has(refusal(plain + ",1\n", units), "line 21: has no position"));
    CHECK(has(refusal(rows([](auto x, auto) { return x + ",1.5\n"; }), units), "constant height"));
    CHECK(has(refusal(rows([](auto x, auto z) { return x + "," + z + "\n"; }, 15), units),
              "15 points; must be at least 16"));
    CHECK(has(refusal("1,2\n", units), "1 points"));
    CHECK(has(refusal(rows([](auto, auto z) { return z + "\n"; }), units), "no spacing"));
    CHECK(has(refusal(rows([](auto, auto z) { return z + "\n"; }), {.units = "nm", .spacing = -1.0}), "spacing = -1"));
    const std::string missing = test::refusal([] { (void)read(std::filesystem::path("no/such/file.csv")); });
    CHECK(has(missing, "file.csv: cannot be opened"));
    CHECK(has(test::refusal([] { (void)read(std::filesystem::temp_directory_path()); }), "folder"));
    // the excerpt of a file in a message is short and printable
    const std::string strange = refusal(plain + "10.0," + std::string(5000, '\x1b') + "\n", units);
    CHECK(strange.size() < 300);
    CHECK(strange.find('\x1b') == std::string::npos);
    CHECK(has(refusal(std::string((1 << 20) + 1, '1') + "\n", units), "longer than"));
}

TEST_CASE("No damaged file makes the reader crash or hang or return a NaN") {
    // every prefix of a file, and the file with each byte replaced by one of a few nasty ones
    const std::string file = "# made up\r\nx (\xB5m);z (nm)\r\n" +
                             rows([](auto x, auto z) { return with_commas(x + ";" + z) + ";;\r\r\n"; });
    const auto try_it = [](const std::string& text) {
        try {
            const auto result = read(text);
            REQUIRE(result.profile().present() >= 16);
            REQUIRE(result.profile().spacing > 0);
            for (const double z : result.profile().heights) REQUIRE_FALSE(std::isinf(z));
        } catch (const domain_error& error) {
            REQUIRE(has(error.what(), "file.txt"));
        }
    };
    for (std::size_t n = 0; n <= file.size(); ++n) try_it(file.substr(0, n));
    for (const char c : {'\n', '\r', ';', ',', '.', ' ', '\t', '"', 'e', '-', '9', '#', '[', '\xFF', '(', '/'})
        for (std::size_t n = 0; n < file.size(); ++n) {
            std::string damaged = file;
            damaged[n] = c;
            try_it(damaged);
        }
}

TEST_CASE("Real stylus files are read as their owners describe them") {
    const std::filesystem::path folder = FSTIFF_SURFACES;
    if (!std::filesystem::exists(folder)) SKIP_CASE("there is no folder of measured surfaces " + folder.string());
    const auto dektak = read(folder / "dektak-1.csv");
    CHECK(dektak.profile().size() == 9600);
    CHECK(test::relative_error(dektak.profile().spacing, 1500e-6 / 9600) <
          1e-4);  // 1500 um, in steps printed as 0.156 um
    CHECK(test::relative_error(dektak.profile().heights.front(), -0.00933e-6) < 1e-15);
    CHECK(test::relative_error(dektak.profile().heights.back(), 16.58112e-6) < 1e-15);
    CHECK(test::said(dektak, "units").ends_with("from line 28"));
    CHECK(test::said(dektak, "header") == "28 lines");

    CHECK(has(test::refusal([&] { (void)read(folder / "opdx-3.txt"); }), "unit"));
    const auto opdx = read(folder / "opdx-3.txt", {.units = "m,m"});
    CHECK(opdx.profile().size() == 3001);
    CHECK(test::relative_error(opdx.profile().length(), 49.966689e-6) < 1e-9);
    CHECK(has(test::said(opdx, "separator"), "blanks"));

    const auto xy = read(folder / "xy-4.txt", {.units = "um,um"});
    CHECK(xy.profile().size() == 10001);
    CHECK(test::relative_error(xy.profile().spacing, 0.995613e-6 / 10000) < 1e-6);

    // maps are no profiles
    CHECK(has(test::refusal([&] { (void)read(folder / "matrix-3.txt"); }), "256 columns"));
    CHECK(has(test::refusal([&] { (void)read(folder / "nanovea_test1.txt", {.units = "mm,um"}); }), "3 columns"));
    CHECK(has(test::refusal([&] { (void)read(folder / "nanovea_test1.txt", {.units = "mm,um", .column = 3}); }),
              "line 104"));
    CHECK(has(test::refusal([&] { (void)read(folder / "x3p-2.x3p"); }), "zip archive"));
}

TEST_CASE("Missing points are words, in profiles as in maps", "[missing]") {
    for (const char* word :
         {"nan", "NaN", "-nan", "NA", "n/a", "BAD", "Bad", "No Data", "nodata", "***", "*****", ""}) {
        INFO(word);
        std::string text = "x [um];z [nm]\n";
        for (int i = 0; i < 20; ++i)
            text += std::to_string(i) + ";" + (i == 7 ? std::string(word) : std::to_string(i * i % 11)) + "\n";
        const auto found = read(text);
        CHECK(test::missing(found) == 1);
        CHECK(std::isnan(found.profile().heights[7]));
        CHECK(found.profile().heights[8] == 9 * 1e-9);
    }
}

TEST_CASE("Numbers that are none are missing as programs and workbooks print them", "[missing]") {
    const std::string plain = rows([](auto x, auto z) { return x + "," + z + "\n"; }, 16);
    for (const char* word :
         {"1.#IND",   "-1.#IND",   "-1.#IND00", "1.#QNAN",  "1.#QNAN0", "1.#SNAN", "1.#INF",       "-1.#INF00",
          "1.#J",     "1.$",       "1.#IO",     "inf",      "-INF",     "+Inf",    "Infinity",     "-inf",
          "nan(ind)", "-nan(ind)", "NaNQ",      "nan(0x8)", "#N/A",     "#VALUE!", "#DIV/0!",      "#NUM!",
          "#NV",      "#WERT!",    "#N/D",      "Err:502",  "-",        "---",     "\xE2\x80\x94", "-----"}) {
        CAPTURE(word);
        for (const std::string separator : {",", ";", "\t", " "}) {
            const auto row = [&](const std::string& x, const std::string& z) { return x + separator + z + "\n"; };
            const auto found =
                read(rows(row, 16) + row("8.0", word) + row("8.5", "0.1") + row("9.0", "0.2"), {.units = "um"});
            REQUIRE(found.profile().size() == 19);
            CHECK(std::isnan(found.profile().heights[16]));
            CHECK(test::missing(found) == 1);
            const auto first = read(row("-0.5", word) + rows(row), {.units = "um"});
            CHECK(std::isnan(first.profile().heights[0]));
        }
        // one column: a row that is missing is no comment
        const std::string one = rows([](auto, auto z) { return z + "\n"; }) + word + "\n0.5\n";
        CHECK(std::isnan(read(one, {.units = "um", .spacing = 1e-6}).profile().heights[20]));
    }
    CHECK(has(refusal("0.0,1.5#remark\n" + plain + "8.0,1.5#remark\n", {.units = "um"}),
              "\"1.5#remark\" is not a number"));
    CHECK(read(plain + "8.0,1.5 # remark\n8.5,1.5,# remark\n", {.units = "um"}).profile().heights[17] == 1.5e-6);
    CHECK(test::missing(read(plain + "8.0,inf\n", {.units = "um", .missing = "inf"})) == 1);
}

TEST_CASE("Titles after a comment sign keep their units and angstrom and exponents of Fortran are read") {
    const auto text = [](const std::string& header, const char* separator, const char* exponent) {
        std::string all = header + "\n";
        for (int i = 0; i < 20; ++i)
            all += std::to_string(i) + separator + std::to_string(i * i % 11) + ".5" + exponent + "\n";
        return all;
    };
    const auto first = read(text("#;x [\xC2\xB5m];z [\xC2\xB5m]", ";", ""));
    CHECK(test::said(first, "units").ends_with("from line 1"));
    CHECK(test::ulps(first.profile().heights[1], 1.5e-6) <= 1);
    for (const char* unit : {"A", "\xC3\x85", "\xE2\x84\xAB", "\xC5", "A\xCC\x8A", "angstrom"}) {
        INFO(unit);
        const auto found = read(text("x [nm] z [" + std::string(unit) + "]", " ", "D-02"));
        CHECK(test::ulps(found.profile().heights[3], 9.5e-12) <= 1);
        CHECK(test::ulps(found.profile().spacing, 1e-9) <= 1);
    }
    // letters above columns, and names of channels, are no units
    for (const char* header : {"A,B", "A,A", "x [um],sensor A"}) CHECK(has(refusal(text(header, ",", "")), "no unit"));
}

TEST_CASE("Unequal steps are refused with the option that resamples them") {
    // z = 3 x + 2 lies on its own straight lines: the answer is exact
    std::string text = "x [um],z [um]\n", kinked = text;
    std::vector<double> x(40);
    for (int i = 0; i < 40; ++i) {
        x[static_cast<std::size_t>(i)] = i + 0.25 * (i % 3);
        text += std::to_string(x[static_cast<std::size_t>(i)]) + "," +
                std::to_string(3 * x[static_cast<std::size_t>(i)] + 2) + "\n";
        kinked +=
            std::to_string(x[static_cast<std::size_t>(i)]) + "," + (i == 5 ? "nan" : std::to_string(i % 4)) + "\n";
    }
    CHECK(has(refusal(text), "resampled by resample = true"));
    CHECK(has(refusal(text, {.names = {.prefix = "--", .equals = " "}}), "resampled by --resample"));
    const auto found = read(text, {.resample = true});
    REQUIRE(found.profile().size() == 40);
    CHECK(test::relative_error(found.profile().spacing, x.back() / 39 * 1e-6) < 1e-14);
    for (int i = 0; i < 40; ++i)
        CHECK(test::relative_error(found.profile().heights[static_cast<std::size_t>(i)],
                                   (3 * i * x.back() / 39 + 2) * 1e-6) < 1e-13);
    CHECK(has(test::said(found, "spacing"), "unequal steps of 0.5 to 1.25 um resampled to 40 equal ones"));
    CHECK(test::missing(read(kinked, {.resample = true})) >= 1);
    // equal steps stay as they are
    const auto even =
        read("x [um],z [um]\n" + rows([](auto a, auto z) { return a + "," + z + "\n"; }), {.resample = true});
    CHECK(test::said(even, "spacing") == "from mean step of the positions");
}

TEST_CASE("A position that leaps forth is named itself instead of the one after it") {
    std::string text = "x [um],z [um]\n";
    for (int i = 0; i < 20; ++i)
        text += (i == 7 ? std::string("70") : std::to_string(i)) + "," + std::to_string(i % 3) + "\n";
    CHECK(has(refusal(text), "line 9: position 70 um is between 6 and 8 um"));
}

TEST_CASE("Exchanged columns are refused with the options that exchange them") {
    const std::string text = "z [um],x [um]\n" + rows([](auto x, auto z) { return z + "," + x + "\n"; });
    CHECK(has(refusal(text),
              "positions must rise, or fall, throughout; column 2 does in equal steps: if it holds them, "
              "give x_column = 2 and column = 1"));
    check_rows(read(text, {.column = 1, .x_column = 2}), 1e-6, 1e-6);
    const std::string neither = "x [um],z [um]\n" + rows([](auto, auto z) { return z + "," + z + "\n"; });
    CHECK(has(refusal(neither), "positions must rise, or fall, throughout"));
    CHECK_FALSE(has(refusal(neither), "column 2 does"));
}

TEST_CASE("A number that denotes missing points is reported or refused with the option that states it", "[missing]") {
    const auto text = [](const std::string& header, const std::string& missing) {
        std::string all = header + "x [um],z [nm]\n";
        for (int i = 0; i < 40; ++i)
            all += std::to_string(i) + "," + (i % 9 == 4 ? missing : std::to_string(i * i % 11)) + "\n";
        return all;
    };
    for (const char* number : {"-9999", "1e20", "-32768", "3.402823e38", "-12345"}) {
        INFO(number);
        const std::string why = refusal(text("", number));
        CHECK(has(why, "line 6: height "));
        CHECK(has(why, "and 3 times more"));
        CHECK(has(why, "0 to 9 nm"));
        CHECK(has(why, "given as missing = "));
        CHECK(test::missing(read(text("", number), {.missing = number})) == 4);
        CHECK(test::missing(read(text("", number), {.missing = "none"})) == 0);
        CHECK(test::missing(read(text("# NODATA_value " + std::string(number) + "\n", number))) == 4);
    }
    CHECK(test::missing(read(text("", "void of data"), {.missing = "VOID of data"})) == 4);
    // positions are left alone
    const auto zero = read(text("", "5"), {.missing = "5,0"});
    CHECK(zero.profile().size() == 40);
    CHECK(has(test::said(zero, "points"), "(5, 0, from options)"));
    CHECK(has(refusal(text("", "5"), {.missing = "5,"}), "missing = \"5,\": must be"));
    // a plateau adjoins the rest, steps of two heights have no rest
    CHECK(test::missing(read(text("", "10"))) == 0);
    CHECK(test::missing(read(text("", "11"))) == 0);
    std::string steps = "x [um],z [nm]\n";
    for (int i = 0; i < 40; ++i) steps += std::to_string(i) + (i / 5 % 2 ? ",500\n" : ",0\n");
    CHECK(test::missing(read(steps)) == 0);
}

TEST_CASE("A point in a number of a file with decimal commas is refused, never read as decimal", "[decimal]") {
    // heights of 5012 nm with a separator of thousands
    const auto text = [](const std::string& x, const std::string& z) {
        std::string all = "x [um];z [nm]\n";
        for (int i = 0; i < 20; ++i) all += std::to_string(i) + x + ";" + std::to_string(4 + height(i)) + z + "\n";
        return all;
    };
    for (const char* z : {".012", ".5", ".000,5", ".123.456"}) {
        CAPTURE(z);
        const std::string why = refusal(text(",0", z));
        CHECK(has(why, "line 2: \"1" + std::string(z) + "\" is not a number where the decimal sign is the comma"));
        CHECK(has(why, "without separators of thousands"));
    }
    CHECK(has(refusal(text(".0", ",012")), "is not a number where the decimal sign is the point"));
    CHECK(has(refusal(text(".0", ",000.5")), "is not a number where the decimal sign is the point"));
    CHECK(read(text(",0", ",012")).profile().size() == 20);
    CHECK(has(refusal("x [um]\tz [nm]\n0,0\t5.012\n1,0\t5.013\n"), "line 2: \"5.012\" is not a number"));
}

TEST_CASE("A comma that separates columns and is decimal is refused as such", "[decimal]") {
    std::string profile, triples, whole;
    for (int i = 0; i < 20; ++i) {
        profile += std::to_string(i / 2) + (i % 2 ? ",5" : ",0") + "," + std::to_string(height(i)) + "," +
                   std::to_string(8351 - 400 * i) + "\n";
        triples += std::to_string(i % 5) + ",0," + std::to_string(i / 5) + ",5," + std::to_string(height(i)) + ",0" +
                   std::to_string(i) + "\n";
        whole += std::to_string(10 + height(i)) + ",20," + std::to_string(height(i + 1)) + ",40\n";
    }
    for (const SurfaceOptions& options : {SurfaceOptions{.units = "um", .column = 3}, SurfaceOptions{}})
        for (const std::string& text : {profile, triples})
            CHECK(has(refusal(text, options),
                      "has commas between its columns and in its numbers; must have another "
                      "separator, or points"));
    CHECK(read(whole, {.units = "um", .spacing = 1e-6, .column = 3}).profile().size() == 20);
    CHECK(has(refusal("x [um],z [um]\n0,1\n1,2\n2,3,4\n"),
              "has 3 columns; must be 2 as in line 2 (a comma cannot be the decimal sign and separate the columns)"));
}

TEST_CASE("Heads of Hommel and Mitutoyo give the spacing and the unit", "[header]") {
    const std::string one = rows([](auto, auto z) { return z + "\n"; });
    for (const char* head : {"# Punktabstand: 0,5 um\n# Einheit: nm\n", "Pitch,0.5,um\nUnit,nm\n",
                             "Pitch;0,5;um\nEinheit;nm\n", "Messpunktabstand [\xC2\xB5m];0,500\nZ-Unit;nm\n",
                             "Pitch\t0.5\tMikrometer\nUnit\tNanometer\n", "Punktabstand = 0,0005 mm\nz [nm]\n"}) {
        CAPTURE(head);
        const auto found = read(head + one);
        check_rows(found, 1e-6, 1e-9);
        CHECK(has(test::said(found, "spacing"), "line 1"));
    }
    check_rows(read("# Punktabstand: 0,5 um\n# Einheit: nm\n" + with_commas(one)), 1e-6, 1e-9);
}

TEST_CASE("A length and the number of rows above the heights are a header", "[header]") {
    std::string heights;
    for (int i = 0; i < 20; ++i) heights += std::to_string(height(i)) + ".5\n";
    for (const std::string head : {"2.00000\n20\n", "20\n", "0.01\n2.0\n20\n"}) {
        CAPTURE(head);
        const io::Surface found = read(head + heights, {.units = "um", .spacing = 1e-7});
        CHECK(found.profile().size() == 20);
        CHECK(found.profile().heights[0] == (height(0) - 0.5) * 1e-6);
    }
    CHECK(read("21\n" + heights, {.units = "um", .spacing = 1e-7}).profile().size() == 21);
    CHECK(has(refusal("2.00000\n20\n" + heights), "would be units = um and spacing = \"0.1 mm\""));
}

TEST_CASE("Rows next to words are read by their columns, or counted in the header", "[header]") {
    std::string sheet;
    for (int i = 0; i < 20; ++i)
        sheet += (i < 3 ? "Rz 1," : ",") + std::to_string(i) + "," + std::to_string(height(i)) + "\n";
    const io::Surface found = read(sheet, {.units = "um", .column = 3, .x_column = 2});
    CHECK(found.profile().size() == 20);
    CHECK(read(sheet, {.units = "um", .spacing = 1e-6, .column = 3}).profile().size() == 20);
    std::string numbered;  // the first column has numbers too: which it is has to be chosen
    for (int i = 0; i < 20; ++i)
        numbered += (i < 3 ? "Rz 1," : "7,") + std::to_string(i) + "," + std::to_string(height(i)) + "\n";
    const auto sentences = read(numbered, {.units = "um", .spacing = 1e-6, .column = 3}).record.sentences();
    CHECK(std::any_of(sentences.begin(), sentences.end(), [](const std::string& sentence) {
        return sentence == "header: 3 lines, 3 of which hold numbers next to words and are left out";
    }));
}

TEST_CASE("A line of the header costs no more than some rows", "[header]") {
    std::string head, rows;
    for (int i = 0; i < 20000; ++i) head += "# Remark " + std::to_string(i) + " of the operator: nothing here\n";
    for (int i = 0; i < 20000; ++i) rows += std::to_string(height(i)) + ".125 " + std::to_string(i) + ".5\n";
    const auto seconds = [](const std::string& text, std::size_t column) {
        const std::clock_t begin = std::clock();
        (void)read(text, {.units = "um", .spacing = 1e-6, .column = column});
        return static_cast<double>(std::clock() - begin);
    };
    CHECK(seconds(head + rows, 1) < 30 * seconds(rows, 1));
}

TEST_CASE("Options that contradict the file are used and reported", "[contradiction]") {
    const std::string plain = rows([](auto x, auto z) { return x + "," + z + "\n"; });
    const auto warnings = [](const io::Surface& found) { return found.record.warnings; };
    const auto units = read("x [um],z [nm]\n" + plain, {.units = "mm,um"});
    check_rows(units, 1e-3, 1e-6);
    REQUIRE(warnings(units).size() == 2);
    CHECK(warnings(units)[0] ==
          "units = \"mm,um\" contradicts line 1, which states nm for the heights; the option is used");
    CHECK(warnings(units)[1] ==
          "units = \"mm,um\" contradicts line 1, which states um for the positions; the option is used");
    CHECK(warnings(read("x [um],z [nm]\n" + plain, {.units = "um,nm"})).empty());
    CHECK(warnings(read("x [\xC2\xB5m],z [nm]\n" + plain, {.units = "micrometer,nm"})).empty());
    CHECK(warnings(read(plain, {.units = "mm,um"})).empty());

    const auto spacing = read("x [um],z [nm]\n" + plain, {.spacing = 5e-6});
    CHECK(spacing.profile().spacing == 5e-6);
    REQUIRE(warnings(spacing).size() == 1);
    CHECK(warnings(spacing)[0] ==
          "spacing = 5e-06 m contradicts column 1, whose mean step is 5e-07 m; the option is used");
    CHECK(warnings(read("x [um],z [nm]\n" + plain, {.spacing = 0.5e-6})).empty());
    CHECK(warnings(read(plain, {.units = "nm", .spacing = 5e-6})).empty());  // of the positions no unit is known
    CHECK(warnings(read(plain, {.units = "um,nm", .spacing = 5e-6})).size() == 1);

    const std::string one = "Pitch,0.5,um\nUnit,nm\n" + rows([](auto, auto z) { return z + "\n"; });
    const auto stated = read(one, {.units = "um", .spacing = 1e-6, .names = {.prefix = "--", .equals = " "}});
    REQUIRE(warnings(stated).size() == 2);
    CHECK(warnings(stated)[0] ==
          "--units \"um\" contradicts line 2, which states nm for the heights; the option is used");
    CHECK(warnings(stated)[1] == "--spacing 1e-06 m contradicts line 1, which states 0.5 um; the option is used");
}

}  // namespace profile_text_test
