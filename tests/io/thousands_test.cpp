// SPDX-License-Identifier: BSD-3-Clause
// Separators of thousands. Truth: the heights that the texts are made of, whole nanometres without any separator.
#include "io/thousands.hpp"
#include "support/texts.hpp"

namespace thousands_test {

using namespace fstiff;
using io::SurfaceOptions;
using test::Cell, test::lines, test::refused, test::replaced, test::TextRow;

namespace {

/// From 711 to 1289, on both sides of 1000.
double height(int i) { return 1000 + (i * i * 37 + i * 11) % 579 - 289; }
std::string digits(int i) { return std::to_string(static_cast<int>(height(i))); }
void check(const std::vector<TextRow>& table) { test::check_texts(table, height); }
const SurfaceOptions comma{.thousands = ","};

/// \p number with \p sign between its thousands.
std::string grouped(double number, const std::string& sign) {
    std::string digits = std::to_string(static_cast<int>(number));
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, sign);
    return digits;
}
Cell by(const std::string& sign, double more = 0) {
    return [sign, more](int i) { return grouped(height(i) + more, sign); };
}

/// 40 rows of a position and a height.
std::string rows(const std::string& s, const Cell& z) {
    return "x [um]" + s + "z [nm]\n" + test::rows("{i}" + s + "{z}\n", 40, z);
}
const test::Decision read{.dx = 1e-6, .unit = 1e-9, .size = 40}, any{.dx = 1e-6, .size = 40};

}  // namespace

TEST_CASE("A number is grouped in threes from its end", "[thousands]") {
    using namespace fstiff::io::detail;
    for (const char* cell : {"1,234", "-12,345", "+123,456", "1,234,567", "1,234.5", "1,234."})
        CHECK(thousands_sign_of(cell) == ",");
    CHECK(thousands_sign_of("1.234,5") == ".");
    CHECK(thousands_sign_of("1'234.5") == "'");
    CHECK(thousands_sign_of("1\xE2\x80\x99"
                            "234") == "'");
    for (const char* blank : {" ", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "\xA0"})
        CHECK(thousands_sign_of("12" + std::string(blank) + "345,5") == " ");
    for (const char* cell :
         {"", "123", "0,123", "1234,567", "1,23", "1,2345", "1,234,56", "1,234e3", "1,234,", "1.234.5"})
        CHECK(thousands_sign_of(cell).empty());
}

TEST_CASE("Thousands are refused with the option that reads them, whatever separates columns", "[thousands]") {
    for (const std::string sign : {",", ".", "'", " ", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"}) {
        const std::string option = sign[0] > 0 ? sign : sign == "\xE2\x80\x99" ? "'" : " ";
        const SurfaceOptions given{.thousands = option};
        const test::Decision named = refused("thousands = \"" + option + "\"");
        for (const std::string s : {";", "\t", ",", " "}) {
            const std::string text = rows(s, by(sign)), name = "\"" + sign + "\" and \"" + s + "\"";
            if (sign == s || (sign == " " && s != ";")) {  // columns and thousands by the same sign
                check({{name, text, refused("")}});
                continue;
            }
            check({{name, text, named}});
            if (option != " " || s != " ") check({{name, text, read, given}});
        }
        const std::string one = "z [nm]\n" + test::rows("{z}\n", 40, by(sign));
        const std::string decimals =
            rows(";", [&](int i) { return by(sign)(i) + (option == "," || option == "'" ? ".0" : ",0"); });
        check({{sign, one, refused(""), {.spacing = 1e-6}},
               {sign, one, read, {.spacing = 1e-6, .thousands = option}},
               {sign, decimals, named},
               {sign, decimals, read, given}});
    }
}

TEST_CASE("Thousands in quotes are refused between commas and read by the option", "[thousands]") {
    const Cell quoted = [](int i) { return "\"" + by(",")(i) + "\""; };
    const Cell where_needed = [&](int i) { return height(i) > 999 ? quoted(i) : digits(i); };
    const std::string halves = "x [um],z [nm]\n" + test::rows("{x},{z}\n", 40, quoted);  // another column has points
    const test::Decision named = refused("thousands = \",\"");
    check({
        {"quoted", rows(",", quoted), named},
        {"quoted, given", rows(",", quoted), read, comma},
        {"quoted where needed", rows(",", where_needed), named},
        {"quoted where needed, given", rows(",", where_needed), read, comma},
        {"points", halves, named},
        {"points, given", halves, {.dx = 0.5e-6, .unit = 1e-9, .size = 40}, comma},
        {"decimal commas", rows(",", [](int i) { return "\"" + digits(i) + ",0\""; }), read},
    });
}

TEST_CASE("Thousands in a map are refused and read by the option", "[thousands]") {
    const SurfaceOptions steps{.units = "nm", .dx = 1e-6, .dy = 1e-6};
    const SurfaceOptions steps_comma{.units = "nm", .dx = 1e-6, .dy = 1e-6, .thousands = ","};
    const test::Decision named = refused("thousands = \",\""), grid = test::map(1e-6, 1e-6, 1e-9);
    const std::string triples = test::triples("{i};{j};{z}\n", by(","));
    const std::string far =
        "x [nm];y [nm];z [nm]\n" + lines(20, [](int i) {
            return grouped(250 * (i % 5), ",") + ";" + grouped(250 * (i / 5), ",") + ";" + digits(i) + "\n";
        });
    check({
        {"matrix", test::matrix("\t", by(",")), named, steps},
        {"matrix, given", test::matrix("\t", by(",")), grid, steps_comma},
        {"triples", triples, named, {.units = "um,nm"}},
        {"triples, given", triples, grid, {.units = "um,nm", .thousands = ","}},
        {"positions", far, refused("line 6: \"1,000\" may be a whole number")},
        {"positions, given", far, test::map(250e-9, 250e-9, 1e-9), comma},
    });
}

TEST_CASE("Lines that only a separator of thousands keeps from being rows are no header", "[thousands]") {
    const auto first = [](int number, const std::string& sign) {
        return rows(";", [=](int i) { return i < 5 ? grouped(number + i, sign) : std::to_string(900 + i); });
    };
    check({
        {"'", first(1000, "'"), refused("line 2")},
        {"no-break space", first(1000, "\xC2\xA0"), refused("line 2")},
        {"millions", first(1000000, ","), refused("line 2: \"1,000,000\"")},
    });
}

TEST_CASE("Decimals of three digits stay what they are", "[thousands]") {
    const Cell milli = [](int i) { return std::to_string(1 + i % 2) + "," + std::to_string(711 + i); };
    const Cell whole = [&](int i) { return i == 7 ? std::string("2") : milli(i); };  // stated to be what it is
    const Cell zeros = [](int i) {
        return i % 9 ? std::to_string(i % 9) + "." + std::to_string(101 + i * i % 89) : "0";
    };
    const auto thirds = [](const std::string& s, const std::string& third) {
        return rows(s, [=](int i) { return i % 3 ? std::string("1.125") : third; });
    };
    check({
        {"a whole number next to them", rows(";", whole), refused("or, if it is decimal, by thousands = \"none\"")},
        {"points", thirds("\t", "2"), any},
        {"points and 998", thirds("\t", "998"), refused("thousands")},
    });
    const io::Surface decimal = test::read_text(rows(";", milli));
    CHECK(test::relative_error(decimal.profile().heights[3], 2714 * 1e-12) < 1e-15);
    CHECK(test::contains(test::said(decimal, "read as"), "separator: semicolon, decimal comma"));
    CHECK(test::read_text(rows(";", whole), {.thousands = "none"}).profile().heights[7] == 2e-9);
    CHECK(test::read_text(rows("\t", zeros)).profile().heights[0] == 0);
    // as C prints them: a zero at the end is dropped, and a point is decimal as a rule
    for (const std::string fifth : {"0.125", "1.25", "1.5", ".125", "1.125e0"})
        check({{fifth, rows(" ", [&](int i) { return i % 5 == 0 ? fifth : i % 3 ? "1.125" : "2"; }), any}});
    // decimal commas that some heights of one column lack stay decimal
    const std::string tenths = "z [nm]\n" + test::rows("{z}\n", 40, [](int i) {
                                   const std::string text = digits(i), last = text.substr(text.size() - 1);
                                   return text.substr(0, text.size() - 1) + (last == "0" ? "" : "," + last);
                               });
    const io::Surface found = test::read_text(tenths, {.spacing = 1e-6});
    REQUIRE(found.profile().size() == 40);
    for (int i = 0; i < 40; ++i)
        CHECK(test::relative_error(found.profile().heights[static_cast<std::size_t>(i)], height(i) * 1e-10) < 1e-15);
}

TEST_CASE("A sign that may separate thousands as well as columns or decimals is refused", "[thousands]") {
    const std::string blanks = test::rows("{z},5\n", 40, by(" ", 1300));
    const std::string commas = test::rows("{i},{z}\n", 40, by(",", 1300));
    const std::string alternate = lines(64, [](int i) {  // 1593,7, 1741,7
        const std::string text = std::to_string(15000 + static_cast<int>(height(i)));
        return text.substr(0, 4) + "," + text.substr(4) + (i % 8 < 7 ? ", " : "\n");
    });
    const std::string map = lines(64, [](int i) { return by(" ", 15000)(i) + (i % 8 < 7 ? "," : "\n"); });
    const SurfaceOptions steps{.units = "nm", .dx = 1e-6, .dy = 1e-6};
    check({
        {"blanks",
         blanks,
         refused("may be one number with a blank between its thousands"),
         {.units = "nm", .spacing = 1e-6}},
        {"commas", commas, refused("have another separator of columns"), {.units = "nm", .spacing = 1e-6, .column = 3}},
        {"commas, given", commas, refused("has \",\" where it separates no thousands"), comma},
        {"15 937,17 417", map, refused("is not a number where the decimal sign is the comma", "thousands = \" \""),
         steps},
        {"1593,7, 1741,7", alternate, refused("has commas between its columns and in its numbers"), steps},
        {"no separator", "1;2\n", refused("thousands = \"comma\": must be one of"), {.thousands = "comma"}},
        {"not of thousands", rows(";", [](int i) { return std::to_string(i) + ",5"; }),
         refused("line 2: \"0;0,5\" has \",\" where it separates no thousands"), comma},
        {"binary", "aISO-1.0\n", refused("no use for thousands"), comma},
    });
    const io::Surface given = test::read_text(blanks, {.units = "nm", .spacing = 1e-6, .thousands = " "});
    CHECK(test::relative_error(given.profile().heights[2], (height(2) + 1300.5) * 1e-9) < 1e-15);
    CHECK(io::detail::without_thousands("Pitch 1,024 um, x 1,2\n1,234;-12,345.5;7\n", ",", "file") ==
          "Pitch 1024 um, x 1,2\n1234;-12345.5;7\n");
}

}  // namespace thousands_test
