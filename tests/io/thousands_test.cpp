// SPDX-License-Identifier: BSD-3-Clause
// Separators of thousands. Truth: the heights that the texts are made of, whole nanometres without any separator.
#include "io/thousands.hpp"
#include "support/samples.hpp"
#include "support/surfaces.hpp"

namespace thousands_test {

using namespace fstiff;
using io::SurfaceOptions;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Heights from 711 to 1289, which change sign about 1000.
int height(int i) { return 1000 + (i * i * 37 + i * 11) % 579 - 289; }

/// \p number with \p sign between its thousands.
std::string grouped(int number, const std::string& sign) {
    std::string digits = std::to_string(std::abs(number));
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, sign);
    return (number < 0 ? "-" : "") + digits;
}

using Cell = std::function<std::string(int)>;
/// 40 rows of a position and a height.
std::string profile(
    const std::string& separator, const Cell& z, const Cell& x = [](int i) { return std::to_string(i); }) {
    std::string text = "x [um]" + separator + "z [nm]\n";
    for (int i = 0; i < 40; ++i) text += x(i) + separator + z(i) + "\n";
    return text;
}

constexpr test::FileReader read{};
const test::RefusalOf refusal(read);

void check_heights(const io::Surface& found, double unit = 1e-9) {
    REQUIRE(found.profile().size() == 40);
    for (int i = 0; i < 40; ++i)
        CHECK(test::relative_error(found.profile().heights[static_cast<std::size_t>(i)], height(i) * unit) < 1e-15);
}

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
    for (const char* sign : {",", ".", "'", " ", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"}) {
        const std::string text(sign), option = text[0] > 0 ? text : text == "\xE2\x80\x99" ? "'" : " ";
        for (const char* separator : {";", "\t", ",", " "}) {
            CAPTURE(text, separator);
            const std::string file = profile(separator, [&](int i) { return grouped(height(i), text); });
            if (text == separator || (text == " " && *separator != ';')) {  // columns and thousands by the same sign
                CHECK_FALSE(refusal(file).empty());
                continue;
            }
            CHECK(has(refusal(file), "thousands = \"" + option + "\""));
            if (option != " " || *separator != ' ') check_heights(read(file, {.thousands = option}));
        }
        const std::string one =
            profile(
                "", [&](int i) { return grouped(height(i), text); }, [](int) { return std::string(); })
                .replace(0, 6, "");
        CHECK_FALSE(refusal(one, {.spacing = 1e-6}).empty());
        check_heights(read(one, {.spacing = 1e-6, .thousands = option}));
        // with decimals
        const std::string point = option == "," || option == "'" ? "." : ",";
        const std::string decimals = profile(";", [&](int i) { return grouped(height(i), text) + point + "0"; });
        CHECK(has(refusal(decimals), "thousands = \"" + option + "\""));
        check_heights(read(decimals, {.thousands = option}));
    }
}

TEST_CASE("Thousands in quotes are refused between commas and read by the option", "[thousands]") {
    const auto quoted = [](int i) { return "\"" + grouped(height(i), ",") + "\""; };
    const auto where_needed = [&](int i) { return height(i) > 999 ? quoted(i) : std::to_string(height(i)); };
    for (const Cell& z : {Cell(quoted), Cell(where_needed)}) {
        CHECK(has(refusal(profile(",", z)), "thousands = \",\""));
        check_heights(read(profile(",", z), {.thousands = ","}));
    }
    // where another column has points
    const std::string halves =
        profile(",", quoted, [](int i) { return std::to_string(i / 2) + (i % 2 ? ".5" : ".0"); });
    CHECK(has(refusal(halves), "thousands = \",\""));
    check_heights(read(halves, {.thousands = ","}));
    // decimal commas in quotes
    check_heights(read(profile(",", [](int i) { return "\"" + std::to_string(height(i)) + ",0\""; })));
}

TEST_CASE("Thousands in a map are refused and read by the option", "[thousands]") {
    const SurfaceOptions options{.units = "nm", .dx = 1e-6, .dy = 1e-6};
    SurfaceOptions given = options;
    given.thousands = ",";
    std::string matrix, plain, triples, far = "x [nm];y [nm];z [nm]\n";
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) {
            const int z = height(8 * j + i);
            const std::string end = i < 7 ? "\t" : "\n";
            matrix += grouped(z, ",") + end;
            plain += std::to_string(z) + end;
            triples += std::to_string(i) + ";" + std::to_string(j) + ";" + grouped(z, ",") + "\n";
            far += grouped(250 * i, ",") + ";" + grouped(250 * j, ",") + ";" + std::to_string(z) + "\n";
        }
    const auto truth = read(plain, options).map().heights;
    CHECK(has(refusal(matrix, options), "thousands = \",\""));
    CHECK((read(matrix, given).map().heights == truth).all());
    CHECK(has(refusal(triples, {.units = "um,nm"}), "thousands = \",\""));
    CHECK((read(triples, {.units = "um,nm", .thousands = ","}).map().heights == truth).all());
    CHECK(has(refusal(far), "line 6: \"1,000\" may be a whole number"));
    const auto found = read(far, {.thousands = ","});
    CHECK((found.map().heights == truth).all());
    CHECK(test::relative_error(found.map().dx, 250e-9) < 1e-15);
}

TEST_CASE("Lines that only a separator of thousands keeps from being rows are no header", "[thousands]") {
    for (const char* sign : {"'", "\xC2\xA0"}) {
        const auto z = [&](int i) { return i < 5 ? grouped(1000 + i, sign) : std::to_string(900 + i); };
        CHECK(has(refusal(profile(";", z)), "line 2"));
    }
    const auto millions = [](int i) { return i < 5 ? grouped(1000000 + i, ",") : std::to_string(900 + i); };
    CHECK(has(refusal(profile(";", millions)), "line 2: \"1,000,000\""));
}

TEST_CASE("Decimals of three digits stay what they are", "[thousands]") {
    const auto milli = [](int i) {
        const std::string digits = std::to_string(height(i) + 1000);
        return digits.substr(0, 1) + "," + digits.substr(1);
    };
    const auto comma = read(profile(";", milli));
    CHECK(test::relative_error(comma.profile().heights[3], (height(3) + 1000) * 1e-12) < 1e-15);
    CHECK(test::said(comma, "separator") == "semicolon, decimal comma");
    // a whole number next to them, stated to be what it is
    const auto whole = [&](int i) { return i == 7 ? std::string("2") : milli(i); };
    CHECK(has(refusal(profile(";", whole)), "or, if it is decimal, by thousands = \"none\""));
    CHECK(read(profile(";", whole), {.thousands = "none"}).profile().heights[7] == 2e-9);
    // as C prints them: a zero at the end is dropped, and a point is decimal as a rule
    for (const char* third : {"0.125", "1.25", "1.5", ".125", "1.125e0"}) {
        CAPTURE(third);
        const auto z = [&](int i) { return std::string(i % 5 == 0 ? third : i % 3 ? "1.125" : "2"); };
        CHECK(read(profile(" ", z)).profile().size() == 40);
    }
    CHECK(read(profile("\t", [](int i) { return std::string(i % 3 ? "1.125" : "2"); })).profile().size() == 40);
    CHECK(has(refusal(profile("\t", [](int i) { return std::string(i % 3 ? "1.125" : "998"); })), "thousands"));
    // bare zeros next to decimals
    CHECK(read(profile(
                   "\t",
                   [](int i) { return i % 9 ? std::to_string(i % 9) + "." + std::to_string(101 + i * i % 89) : "0"; }))
              .profile()
              .heights[0] == 0);
}

TEST_CASE("Blanks or commas that may separate thousands as well as columns are refused", "[thousands]") {
    std::string blanks, commas;
    for (int i = 0; i < 40; ++i) {
        blanks += grouped(height(i) + 1300, " ") + ",5\n";
        commas += std::to_string(i) + "," + grouped(height(i) + 1300, ",") + "\n";
    }
    const SurfaceOptions options{.units = "nm", .spacing = 1e-6};
    CHECK(has(refusal(blanks, options), "may be one number with a blank between its thousands"));
    CHECK(test::relative_error(read(blanks, {.units = "nm", .spacing = 1e-6, .thousands = " "}).profile().heights[2],
                               (height(2) + 1300.5) * 1e-9) < 1e-15);
    CHECK(has(refusal(commas, {.units = "nm", .spacing = 1e-6, .column = 3}), "have another separator of columns"));
    CHECK(has(refusal(commas, {.thousands = ","}), "has \",\" where it separates no thousands"));
}

TEST_CASE("A blank or a comma that does two things in a row of a matrix is refused", "[thousands]") {
    std::string blanks, alternate;  // 15 937,17 417 and 277,9, 286,4
    for (int r = 0; r < 8; ++r)
        for (int c = 0; c < 8; ++c) {
            const int z = 15000 + height(8 * r + c);
            blanks += grouped(z, " ") + (c < 7 ? "," : "\n");
            alternate += std::to_string(z / 10) + "," + std::to_string(z % 10) + (c < 7 ? ", " : "\n");
        }
    const SurfaceOptions map{.units = "nm", .dx = 1e-6, .dy = 1e-6};
    CHECK(has(refusal(blanks, map), "is not a number where the decimal sign is the comma"));
    CHECK(has(refusal(blanks, map), "thousands = \" \""));
    CHECK(has(refusal(alternate, map), "has commas between its columns and in its numbers"));
}

TEST_CASE("Decimal commas that some heights of one column lack stay decimal", "[thousands]") {
    std::string text = "z [nm]\n";  // 123,1 and 125
    for (int i = 0; i < 40; ++i) {
        const int z = height(i);
        text += std::to_string(z / 10) + (z % 10 ? "," + std::to_string(z % 10) : "") + "\n";
    }
    check_heights(read(text, {.spacing = 1e-6}), 1e-10);
}

TEST_CASE("The option takes a separator, and only what separates thousands goes", "[thousands]") {
    CHECK(has(refusal("1;2\n", {.thousands = "comma"}), "thousands = \"comma\": must be one of"));
    CHECK(has(refusal(profile(";", [](int i) { return std::to_string(i) + ",5"; }), {.thousands = ","}),
              "line 2: \"0;0,5\" has \",\" where it separates no thousands"));
    CHECK(io::detail::without_thousands("Pitch 1,024 um, x 1,2\n1,234;-12,345.5;7\n", ",", "file") ==
          "Pitch 1024 um, x 1,2\n1234;-12345.5;7\n");
    CHECK(has(refusal("aISO-1.0\n", {.thousands = ","}), "no use for thousands"));
}

}  // namespace thousands_test
