// SPDX-License-Identifier: BSD-3-Clause
// Profiles from text, as tables of texts (support/texts.hpp).
#include "support/skip.hpp"
#include "support/texts.hpp"

#include <ctime>

namespace profile_text_test {

using namespace fstiff;
using namespace test;
using io::SurfaceOptions;

namespace {

io::Surface read(const std::string& text, SurfaceOptions options = {}) {
    options.format = io::SurfaceFormat::profile;
    return io::read_surface(text, "file", options);
}
io::Surface read(const std::filesystem::path& path, SurfaceOptions options = {}) {
    options.format = io::SurfaceFormat::profile;
    return io::read_surface(path, options);
}
std::string refusal_of(const std::string& text, const SurfaceOptions& options = {}) {
    return refusal([&] { (void)read(text, options); });
}
void check(std::vector<TextRow> table) {
    for (TextRow& row : table) row.options.format = io::SurfaceFormat::profile;
    check_texts(table);
}

const SurfaceOptions units{.units = "um,nm"};
const SurfaceOptions as_command{.names = {.prefix = "--", .equals = " "}};
const std::string plain = rows("{x},{z}\n"), one = rows("{z}\n"), titles = "x [um],z [nm]\n";
const Decision nm = profile(0.5e-6, 1e-9);
Decision nm_and(std::vector<std::string> says) { return profile(0.5e-6, 1e-9, std::move(says)); }

}  // namespace

TEST_CASE("Signs between columns, decimal signs and ends of lines are understood") {
    const auto commas = [](const std::string& pattern) { return with_commas(rows(pattern)); };
    check({
        {"comma", plain, nm_and({"separator: comma", "\nunits: heights in nm, positions in um, from options\n"}),
         units},
        {"comma and blank", rows("{x}, {z}\n"), nm, units},
        {"semicolon", rows("{x};{z}\n"), nm_and({"separator: semicolon"}), units},
        {"tab", rows("{x}\t{z}\n"), nm_and({"separator: tab"}), units},
        {"blanks", rows("  {x}   {z}  \n"), nm_and({"separator: blanks"}), units},
        {"blanks and tabs", rows(" {x} \t {z}\t\n"), nm, units},
        {"decimal comma", commas("{x};{z}\r\n"), nm_and({"separator: semicolon, decimal comma"}), units},
        {"decimal comma, tab", commas("{x}\t{z}\r\n"), nm_and({"decimal comma"}), units},
        {"decimal comma, blank", commas("{x} {z}\r\n"), nm_and({"decimal comma"}), units},
        {"decimal comma, both", commas("{x}; {z}\r\n"), nm_and({"decimal comma"}), units},
        {"one column: no equally spaced positions, so the comma is decimal",
         with_commas(one),
         nm_and({"separator: none"}),
         {.units = "nm", .spacing = 0.5e-6}},
        {"whole numbers with positions 0, 1, 2", rows("{i},{i}7\n"), profile(1e-6, 0, {"separator: comma"}), units},
        {"whole numbers before decimal commas",
         rows("{i};{i}\n", 2) + rows("{i};1,5\n").substr(12),
         {.dx = 1e-6, .says = {"decimal comma"}},
         units},
        {"\\r\\n", rows("{x},{z}\r\n"), nm, units},
        {"\\r\\r\\n", rows("{x},{z}\r\r\n"), nm, units},
        {"\\r", rows("{x},{z}\r"), nm, units},
        {"blank lines", rows("{x},{z}\n\n"), nm, units},
        {"empty cells", rows("{x},{z},,\r\n"), nm, units},
        {"byte order mark", "\xEF\xBB\xBF" + plain, nm, units},
        {"comments", "# one\n% two\n// three\n; four\n! five\n\n" + plain + "\n# end\n\n", nm, units},
        {"no end of the last row", plain.substr(0, plain.size() - 1), nm, units},
        {"quotes", rows("\"{x}\",\"{z}\"\n"), nm, units},
        {"notes", rows("{x},{z}  # noted\n"), nm, units},
        {"header", "Company\nDate,2014-01-02\nx,z\n" + plain, nm_and({"\nheader: 3 lines\n"}), units},
    });
    CHECK(read(plain, units).record.details.size() == 5);
}

TEST_CASE("Units are taken from the header wherever it states them, and options replace them") {
    for (const std::string header :
         {"Lateral um,Raw Nanometer", "x [um]; z [nm]", "x [um],z [nm]", "x (\xC2\xB5m),z (nm)", "x (\xB5m),z (nm)",
          "x/\xCE\xBCm,z/nm", "um,nm", "# x [um]; z [nm]", "# x (um) z (nm)", "# x in um, z in nm",
          "x [um],z [nm]\nposition,height", "\"Position (um)\",\"Height (nm)\"", "% um nm"})
        check({{header, header + "\n" + plain, nm_and({"from line 1"})}});
    check({
        {"one unit for both", plain, profile(0.5e-6, 1e-6), {.units = "um"}},
        {"one column", "z [nm]\n" + one, nm, {.spacing = 0.5e-6}},
        {"resolution", "Resolution,0.5 um/sample\nz [nm]\n" + one, nm},
        {"no unit known", plain, refused("parsec"), {.units = "um,parsec"}},
        {"three units", plain, refused("units = "), {.units = "um,nm,mm"}},
    });
    for (const std::string header :
         {"", "x,z\n", "Location,0.0 um, 0.0 um\n", "Range,524 um\n", "x [s],z [V]\n", "x,z [nm]\n", "made in,um\n"})
        check({{"no unit: " + header, header + plain, refused("file", "unit", "um")}});
}

TEST_CASE("Positions printed with few digits are equally spaced within their digits") {
    const auto text = [](const char* format) {  // steps of 0.156 printed to 0.1: 0.0 0.2 0.3 0.5 0.6 0.8 0.9 1.1
        return titles + lines(200, [&](int i) {
                   char line[64];
                   std::snprintf(line, sizeof line, format, 0.15625 * i);
                   return line + ("," + height_text(i)) + "\n";
               });
    };
    const std::string coarse = text("%.1f");
    // both ends to 0.05 of 31; neighbours may share a printed position where the step is below the last digit
    check({
        {"tenths", coarse, {.dx = 0.15625e-6, .dx_error = 0.1 / 31, .says = {"mean step"}, .size = 200}},
        {"whole", text("%.0f"), {.dx = 0.15625e-6, .dx_error = 1.0 / 31, .size = 200}},
        {"stated", "Resolution,0.156 um/sample\n" + coarse, {.says = {"agrees with line 1"}, .size = 200}},
        {"stated otherwise", "Resolution,0.3 um/sample\n" + coarse, refused("disagrees")},
        {"given", coarse, {.dx = 0.156e-6, .dx_error = 0, .size = 200}, {.spacing = 0.156e-6}},
    });
}

TEST_CASE("Unequal steps are seen through the digits, and a missing row in whole steps too") {
    // x of each of 200 rows, as a printf format and a function of the row
    const auto text = [](const char* format, auto&& position) {
        std::string rows = "x [um],z [nm]\n";
        for (int i = 0; i < 200; ++i) {
            char line[64];
            std::snprintf(line, sizeof line, format, static_cast<double>(position(i)));
            rows += line + ("," + height_text(i)) + "\n";
        }
        return rows;
    };
    // trailing zeros dropped: 29, 30.5, 31.5 ... are printed to a tenth; a row is missing in 0, 1, 2, 4, 5
    const std::string shifted = refusal_of(text("%g", [](int i) { return i < 30 ? i : i + 0.5; }));
    CHECK(contains(shifted, "line 32"));
    CHECK(contains(shifted, "30.5"));
    for (const char* format : {"%.0f", "%.1f", "%.3f", "%g"})
        for (const int missing : {1, 3, 100, 197}) {
            const std::string gap = refusal_of(text(format, [missing](int i) { return i < missing ? i : i + 1; }));
            INFO(format << ' ' << missing << ' ' << gap);
            CHECK(contains(gap, "line " + std::to_string(missing + 2)));
            CHECK(contains(gap, "equally spaced"));
        }
    // rounded equal steps are no gap: decimals, six significant digits, powers of ten
    for (const char* format : {"%.0f", "%.1f", "%g", "%.4e"})
        for (const double step : {0.15625, 1.03, 7.77}) {
            INFO(format << ' ' << step);
            const auto result = read(text(format, [step](int i) { return step * i; }));
            CHECK(relative_error(result.profile().spacing, step * 1e-6) < 1 / (199 * step));
        }
}

TEST_CASE("Columns and points of a profile are found, chosen or refused") {
    const std::string four = rows("{x},9,{z},8\n"), exchanged = "z [um],x [um]\n" + rows("{z},{x}\n");
    const auto with_cell = [](int at, const std::string& x, const std::string& z) {
        return lines(
            20, [&](int i) { return (i == at ? x : std::to_string(i)) + "," + (i == at ? z : height_text(i)) + "\n"; });
    };
    check({
        {"four columns", rows("{x},{i},{z},{z}\n"), refused("4 columns"), units},
        {"four columns, of which two hold one number", four, nm_and({"column 2 not used; column 4 not used"}), units},
        {"the third", four, nm, {.units = "um,nm", .column = 3}},
        {"the third, spacing given", four, nm, {.units = "nm", .spacing = 0.5e-6, .column = 3}},
        {"the fifth", four, refused("column = 5: must be between 1 and 4"), {.units = "um,nm", .column = 5}},
        {"the first", four, refused("spacing"), {.units = "um,nm", .column = 1}},
        {"the first of two", rows("{z},{x}\n"), nm, {.units = "nm", .spacing = 0.5e-6, .column = 1}},
        {"exchanged", exchanged, profile(0.5e-6, 1e-6, {"heights [um] in column 1, positions [um] in column 2"})},
        {"exchanged against the titles", "x [um],z [um]\n" + rows("{z},{x}\n"),
         refused("positions must rise, or fall, throughout; column 2 does in equal steps: if it holds them, "
                 "give x_column = 2 and column = 1")},
        {"exchanged, chosen", exchanged, profile(0.5e-6, 1e-6), {.column = 1, .x_column = 2}},
        {"empty cell", titles + with_cell(7, "7.0", ""), {.dx = 1e-6, .unit = 1e-9, .missing = {7}}},
        {"a position that leaps forth", titles + with_cell(7, "70", "1.0"),
         refused("line 9: position 70 um is between 6 and 8 um")},
    });
    const std::string neither = "x [um],z [um]\n" + rows("{z},{z}\n");
    check({{"neither", neither, refused("positions must rise, or fall, throughout")}});
    CHECK_FALSE(contains(refusal_of(neither), "column 2 does"));
    const auto falling =
        read(titles + lines(20, [](int i) { return std::to_string(19 - i) + ".0," + height_text(i) + "\n"; }));
    CHECK(contains(said(falling, "read as"), "which fall: turned round"));
    CHECK(relative_error(falling.profile().spacing, 1e-6) < 1e-15);
    for (int i = 0; i < 20; ++i) CHECK(falling.profile().heights[static_cast<std::size_t>(i)] == height(19 - i) * 1e-9);
}

TEST_CASE("Bad input is refused in one sentence with file and line and value and allowed range") {
    check({
        {"empty", "", refused("file: is empty")},
        {"blank", "\n \r\n\t\n", refused("blank lines")},
        {"binary", std::string("1,2\n\0", 5), refused("binary")},
        {"words", "only words\nand more\n", refused("line 1: \"only words\"")},
        {"too large", plain + "10.0,1e400\n", refused("line 21: \"1e400\" is beyond"), units},
        {"three cells", plain + "10.0,1,2\n", refused("line 21: has 3 columns; must be 2 as in line 1"), units},
        {"back", plain + "9.0,1\n", refused("line 21: position 9 um follows 9.5 um"), units},
        {"twice", plain + "9.5,1\n", refused("line 21: position 9.5 um follows 9.5 um"), units},
        {"gap", plain + "11.0,1\n",
         refused("line 21: position 11 um is a step of 1.5 um where the usual one is 0.5 um"), units},
        {"no position", plain + ",1\n", refused("line 21: has no position"), units},
        {"constant", rows("{x},1.5\n"), refused("constant height"), units},
        {"15 points", rows("{x},{z}\n", 15), refused("15 points; must be at least 16"), units},
        {"1 point", "1,2\n", refused("1 points"), units},
        {"no spacing", one, refused("no spacing"), units},
        {"negative spacing", one, refused("spacing = -1"), {.units = "nm", .spacing = -1.0}},
        {"long line", std::string((1 << 20) + 1, '1') + "\n", refused("longer than"), units},
    });
    for (const std::string word : {"word", "infinite", "1.0#x", "1.0x", "0x10", "1e", "--1", "1 2"})
        check(
            {{word, plain + "10.0," + word + "\n", refused("file, line 21: ", "\"" + word + "\"", "allowed"), units}});
    CHECK(
        contains(refusal([] { (void)read(std::filesystem::path("no/such/file.csv")); }), "file.csv: cannot be opened"));
    CHECK(contains(refusal([] { (void)read(std::filesystem::temp_directory_path()); }), "folder"));
    // the excerpt of a file in a message is short and printable
    const std::string strange = refusal_of(plain + "10.0," + std::string(5000, '\x1b') + "\n", units);
    CHECK(contains(strange, "line 21"));
    CHECK(strange.size() < 300);
    CHECK(strange.find('\x1b') == std::string::npos);
}

TEST_CASE("No damaged file makes the reader crash or hang or return a NaN") {
    // every prefix of a file, and the file with each byte replaced by one of a few nasty ones
    const std::string file = "# made up\r\nx (\xB5m);z (nm)\r\n" + with_commas(rows("{x};{z};;\r\r\n"));
    const auto try_it = [](const std::string& text) {
        try {
            const auto result = read(text);
            REQUIRE(result.profile().present() >= 16);
            REQUIRE(result.profile().spacing > 0);
            for (const double z : result.profile().heights) REQUIRE_FALSE(std::isinf(z));
        } catch (const domain_error& error) {
            REQUIRE(contains(error.what(), "file"));
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
    CHECK(relative_error(dektak.profile().spacing, 1500e-6 / 9600) < 1e-4);  // 1500 um, in steps printed as 0.156 um
    CHECK(relative_error(dektak.profile().heights.front(), -0.00933e-6) < 1e-15);
    CHECK(relative_error(dektak.profile().heights.back(), 16.58112e-6) < 1e-15);
    CHECK(said(dektak, "units").ends_with("from line 28"));
    CHECK(said(dektak, "header") == "28 lines");

    CHECK(contains(refusal([&] { (void)read(folder / "opdx-3.txt"); }), "unit"));
    const auto opdx = read(folder / "opdx-3.txt", {.units = "m,m"});
    CHECK(opdx.profile().size() == 3001);
    CHECK(relative_error(opdx.profile().length(), 49.966689e-6) < 1e-9);
    CHECK(contains(said(opdx, "read as"), "separator: blanks"));

    const auto xy = read(folder / "xy-4.txt", {.units = "um,um"});
    CHECK(xy.profile().size() == 10001);
    CHECK(relative_error(xy.profile().spacing, 0.995613e-6 / 10000) < 1e-6);

    // maps are no profiles
    CHECK(contains(refusal([&] { (void)read(folder / "matrix-3.txt"); }), "256 columns"));
    CHECK(contains(refusal([&] { (void)read(folder / "nanovea_test1.txt", {.units = "mm,um"}); }), "3 columns"));
    CHECK(contains(refusal([&] { (void)read(folder / "nanovea_test1.txt", {.units = "mm,um", .column = 3}); }),
                   "line 104"));
    CHECK(contains(refusal([&] { (void)read(folder / "x3p-2.x3p"); }), "zip archive"));
}

TEST_CASE("Missing points are words, and numbers that are none as programs and workbooks print them", "[missing]") {
    for (const std::string word :
         {"nan", "NaN", "-nan", "NA", "n/a", "BAD", "Bad", "No Data", "nodata", "***", "*****", ""})
        check({{"word " + word,
                titles + rows("{x};{z}\n", 7) + "3.5;" + word + "\n" +
                    rows("{x};{z}\n").substr(rows("{x};{z}\n", 8).size()),
                {.dx = 0.5e-6, .unit = 1e-9, .missing = {7}}}});
    for (const std::string word :
         {"1.#IND",   "-1.#IND",   "-1.#IND00", "1.#QNAN",  "1.#QNAN0", "1.#SNAN", "1.#INF",       "-1.#INF00",
          "1.#J",     "1.$",       "1.#IO",     "inf",      "-INF",     "+Inf",    "Infinity",     "-inf",
          "nan(ind)", "-nan(ind)", "NaNQ",      "nan(0x8)", "#N/A",     "#VALUE!", "#DIV/0!",      "#NUM!",
          "#NV",      "#WERT!",    "#N/D",      "Err:502",  "-",        "---",     "\xE2\x80\x94", "-----"}) {
        for (const std::string s : {",", ";", "\t", " "}) {
            const std::string above = rows("{x}" + s + "{z}\n"), row = s + word + "\n";
            check({{word,
                    above + "10.0" + row + "10.5" + s + height_text(21) + "\n",
                    {.dx = 0.5e-6, .unit = 1e-9, .size = 22, .missing = {20}},
                    units},
                   {word + " first", "-0.5" + row + above, {.dx = 0.5e-6, .size = 21, .missing = {0}}, units}});
        }
        // one column: a row that is missing is no comment
        check({{word + " alone",
                one + word + "\n" + height_text(21) + "\n",
                {.unit = 1e-9, .size = 22, .missing = {20}},
                {.units = "nm", .spacing = 1e-6}}});
    }
    check({
        {"remark in a number", "0.0,1.5#remark\n" + plain + "10.0,1.5#remark\n",
         refused("\"1.5#remark\" is not a number"), units},
        {"remark",
         plain + "10.0,-0.3 # remark\n10.5," + height_text(21) + ",# remark\n",
         {.dx = 0.5e-6, .unit = 1e-9, .size = 22},
         units},
        {"inf given", plain + "10.0,inf\n", {.size = 21, .missing = {20}}, {.units = "um", .missing = "inf"}},
    });
}

TEST_CASE("A number that denotes missing points is reported or refused with the option that states it", "[missing]") {
    const auto text = [](const std::string& missing) {
        return titles + lines(40, [&](int i) {
                   return std::to_string(i) + "," + (i % 9 == 4 ? missing : std::to_string(i * i % 11)) + "\n";
               });
    };
    const Decision whole{.dx = 1e-6, .size = 40}, four{.dx = 1e-6, .size = 40, .missing = {4, 13, 22, 31}};
    for (const std::string number : {"-9999", "1e20", "-32768", "3.402823e38", "-12345"})
        check(
            {{number, text(number), refused("line 6: height ", "and 3 times more", "0 to 9 nm", "given as missing = ")},
             {number + " given", text(number), four, {.missing = number}},
             {number + " a height", text(number), whole, {.missing = "none"}},
             {number + " in the header", "# NODATA_value " + number + "\n" + text(number), four}});
    check({
        {"words", text("void of data"), four, {.missing = "VOID of data"}},
        {"two numbers, positions left alone",
         text("5"),
         {.says = {"(5, 0, from options)"}, .size = 40, .missing = {0, 4, 7, 11, 13, 15, 18, 22, 26, 29, 31, 33, 37}},
         {.missing = "5,0"}},
        {"half an option", text("5"), refused("missing = \"5,\": must be"), {.missing = "5,"}},
        {"a plateau adjoins the rest", text("10"), whole},
        {"a plateau further up", text("11"), whole},
        {"steps of two heights have no rest",
         titles + lines(40, [](int i) { return std::to_string(i) + (i / 5 % 2 ? ",500\n" : ",0\n"); }), whole},
    });
}

TEST_CASE("Angstrom, exponents of Fortran and titles after a comment sign are read") {
    const auto text = [](const std::string& header, const std::string& s, const std::string& exponent) {
        return header + "\n" + rows("{x}" + s + "{z}" + exponent + "\n");
    };
    check({{"comment", text("#;x [\xC2\xB5m];z [\xC2\xB5m]", ";", ""), profile(0.5e-6, 1e-6, {"from line 1\n"})}});
    for (const std::string unit : {"A", "\xC3\x85", "\xE2\x84\xAB", "\xC5", "A\xCC\x8A", "angstrom"}) {
        const io::Surface found = read(text("x [nm] z [" + unit + "]", " ", "D-02"));
        CAPTURE(unit);
        CHECK(ulps(found.profile().spacing, 0.5e-9) <= 1);
        CHECK(ulps(found.profile().heights[3], height(3) * 1e-12) <= 1);
    }
    // letters above columns, and names of channels, are no units
    for (const std::string header : {"A,B", "A,A", "x [um],sensor A"})
        check({{header, text(header, ",", ""), refused("no unit")}});
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
    CHECK(contains(refusal_of(text), "resampled by resample = true"));
    CHECK(contains(refusal_of(text, as_command), "resampled by --resample"));
    const auto found = read(text, {.resample = true});
    REQUIRE(found.profile().size() == 40);
    CHECK(relative_error(found.profile().spacing, x.back() / 39 * 1e-6) < 1e-14);
    for (int i = 0; i < 40; ++i)
        CHECK(relative_error(found.profile().heights[static_cast<std::size_t>(i)], (3 * i * x.back() / 39 + 2) * 1e-6) <
              1e-13);
    CHECK(contains(said(found, "spacing"), "unequal steps of 0.5 to 1.25 um resampled to 40 equal ones"));
    CHECK(missing(read(kinked, {.resample = true})) >= 1);
    // equal steps stay as they are
    const auto even = read("x [um],z [um]\n" + plain, {.resample = true});
    CHECK(said(even, "spacing") == "from mean step of the positions");
}

TEST_CASE("Points and commas that may be decimal or separate something else are refused", "[decimal]") {
    // heights of 5012 nm with a separator of thousands
    const auto text = [](const std::string& x, const std::string& z) {
        return "x [um];z [nm]\n" + lines(20, [&](int i) {
                   return std::to_string(i) + x + ";" + std::to_string(1 + 7 * i % 10) + z + "\n";
               });
    };
    for (const std::string z : {".012", ".5", ".000,5", ".123.456"})
        check({{z, text(",0", z),
                refused("line 2: \"1" + z + "\" is not a number where the decimal sign is the comma",
                        "without separators of thousands")}});
    const std::string pairs = lines(20, [](int i) {
        return std::to_string(i / 2) + (i % 2 ? ",5" : ",0") + "," + std::to_string(7 * i % 10 - 3) + "," +
               std::to_string(8351 - 400 * i) + "\n";
    });
    const std::string three =
        triples("{i},0,{j},5,{z}\n", [](int i) { return std::to_string(7 * i % 10 - 3) + ",0" + std::to_string(i); });
    const std::string sentence =
        "has commas between its columns and in its numbers; must have another separator, or points";
    const SurfaceOptions third{.units = "um", .column = 3};
    check({
        {"decimal point", text(".0", ",012"), refused("is not a number where the decimal sign is the point")},
        {"both", text(".0", ",000.5"), refused("is not a number where the decimal sign is the point")},
        {"decimal commas", text(",0", ",012"), {.dx = 1e-6}},
        {"tabs", "x [um]\tz [nm]\n0,0\t5.012\n1,0\t5.013\n", refused("line 2: \"5.012\" is not a number")},
        {"commas of a profile", pairs, refused(sentence)},
        {"commas of a profile, column", pairs, refused(sentence), third},
        {"commas of triples", three, refused(sentence)},
        {"commas of triples, column", three, refused(sentence), third},
        {"whole numbers", rows("1{i},20,{i}7,40\n"), {.dx = 1e-6}, {.units = "um", .spacing = 1e-6, .column = 3}},
        {"three cells", "x [um],z [um]\n0,1\n1,2\n2,3,4\n",
         refused(
             "has 3 columns; must be 2 as in line 2 (a comma cannot be the decimal sign and separate the columns)")},
    });
}

TEST_CASE("A comma alone in the rows of one column is decimal, with exponents, gaps and without zeros", "[decimal]") {
    const SurfaceOptions spaced{.units = "um", .spacing = 0.5e-6},
        over{.units = "um", .spacing = 0.5e-6, .missing = "over"};
    const Decision one{.dx = 0.5e-6, .unit = 1e-6};
    const auto commas = [](const std::string& pattern, const Cell& z = height_text) {
        return with_commas(rows(pattern + "\n", 20, z));
    };
    const auto with_gap = [&](const std::string& word) {
        const std::string text = commas("{z}"), cell = with_commas(height_text(7)) + "\n";
        return replaced(text, cell, word + "\n");
    };
    const auto bare = [](int i) { return all_replaced(height_text(i), "0.", "."); };
    Decision gap = one;
    gap.missing = {7};
    check({
        {"exponents", commas("{z}E+00"), one, spaced},
        {"exponents of Fortran", commas("{z}D+00"), one, spaced},
        {"no zero before the comma", commas("{z}", bare), one, spaced},
        {"NA", with_gap("NA"), gap, spaced},
        {"---", with_gap("---"), gap, spaced},
        {"a word of the options", with_gap("over"), gap, over},
    });
}

TEST_CASE("Lines above rows are a header, also those with numbers", "[header]") {
    const SurfaceOptions given{.units = "nm", .spacing = 0.1e-6}, third{.units = "nm", .spacing = 0.5e-6, .column = 3};
    for (const std::string head : {"# Punktabstand: 0,5 um\n# Einheit: nm\n", "Pitch,0.5,um\nUnit,nm\n",
                                   "Pitch;0,5;um\nEinheit;nm\n", "Messpunktabstand [\xC2\xB5m];0,500\nZ-Unit;nm\n",
                                   "Pitch\t0.5\tMikrometer\nUnit\tNanometer\n", "Punktabstand = 0,0005 mm\nz [nm]\n"})
        check({{head, head + one, nm_and({"line 1"})}});
    for (const std::string head : {"2.00000\n20\n", "20\n", "0.01\n2.0\n20\n"})
        check({{head, head + one, profile(0.1e-6, 1e-9), given}});
    const std::string half = rows(",{x},{z}\n").substr(rows(",{x},{z}\n", 3).size());
    check({
        {"commas in both", "# Punktabstand: 0,5 um\n# Einheit: nm\n" + with_commas(one), nm},
        {"no number of rows", "21\n" + one, {.size = 21}, given},
        {"a length", "2.00000\n20\n" + one, refused("would be units = um and spacing = \"0.1 mm\"")},
        {"words next to rows", rows("Rz 1,{x},{z}\n", 3) + half, nm, {.units = "um,nm", .column = 3, .x_column = 2}},
        {"words next to rows, spacing", rows("Rz 1,{x},{z}\n", 3) + half, nm, third},
        {"the first column has numbers too: which it is has to be chosen",
         rows("Rz 1,{x},{z}\n", 3) + all_replaced(half, "\n,", "\n7,").insert(0, "7"),
         {.says = {"\nheader: 3 lines, 3 of which hold numbers next to words and are left out\n"}, .size = 17},
         third},
    });
}

TEST_CASE("The cost of a header grows as its lines", "[header]") {
    const auto seconds = [](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += "# Remark " + std::to_string(i) + " of the operator: nothing here\n";
        text += rows("{z} {x}\n");
        const std::clock_t begin = std::clock();
        (void)read(text, {.units = "um", .spacing = 1e-6, .column = 1});
        return static_cast<double>(std::clock() - begin);
    };
    CHECK(seconds(20000) < 8 * seconds(5000));  // 4 times as many; quadratic time would be 16 times
}

TEST_CASE("Options that contradict the file are used and reported", "[contradiction]") {
    const std::string pitch = "Pitch,0.5,um\nUnit,nm\n" + one;
    check({
        {"units",
         titles + plain,
         profile(0.5e-3, 1e-6, {"\nunits: heights in um, positions in mm, from options\n"},
                 {"units = \"mm,um\" contradicts line 1, which states nm for the heights; the option is used",
                  "units = \"mm,um\" contradicts line 1, which states um for the positions; the option is used"}),
         {.units = "mm,um"}},
        {"the same units", titles + plain, nm, units},
        {"another spelling", "x [\xC2\xB5m],z [nm]\n" + plain, nm, {.units = "micrometer,nm"}},
        {"no units in the file", plain, profile(0.5e-3, 1e-6), {.units = "mm,um"}},
        {"spacing",
         titles + plain,
         {.dx = 5e-6,
          .dx_error = 0,
          .warnings = {"spacing = 5e-06 m contradicts column 1, whose mean step is 5e-07 m; the option is used"}},
         {.spacing = 5e-6}},
        {"the same spacing", titles + plain, nm, {.spacing = 0.5e-6}},
        {"no unit of the positions", plain, {.dx = 5e-6}, {.units = "nm", .spacing = 5e-6}},
        {"their unit given", plain, {.warnings = {"spacing"}}, {.units = "um,nm", .spacing = 5e-6}},
        {"a stated spacing",
         pitch,
         {.dx = 1e-6,
          .warnings = {"--units \"um\" contradicts line 2, which states nm for the heights; the option is used",
                       "--spacing 1e-06 m contradicts line 1, which states 0.5 um; the option is used"}},
         {.units = "um", .spacing = 1e-6, .names = as_command.names}},
    });
}

}  // namespace profile_text_test
