// SPDX-License-Identifier: BSD-3-Clause
// Cells of text. Truth: the digits are counted by eye, the numbers are those of the same literal in the compiler.
#include "io/number.hpp"

#include "support/catch.hpp"

#include <random>
#include <vector>

namespace number_test {

using namespace fstiff::io::detail;

TEST_CASE("a cell is a number when nothing else is in it", "[number]") {
    CHECK(number_in("-1.5e-3", false) == -1.5e-3);
    CHECK(number_in("+12", false) == 12.0);
    CHECK(number_in("1,5", true) == 1.5);
    CHECK(number_in("1.5", true) == std::nullopt);
    CHECK(number_in("1e-999", false) == 0.0);
    CHECK(number_in("1e999", false) == std::numeric_limits<double>::infinity());
    for (const char* cell : {"", "1,5", "1 ", "nan", "inf", "0x10", "1e", "--1"}) CHECK_FALSE(number_in(cell, false));
    CHECK_FALSE(number_in("1.5,2", true));
}

TEST_CASE("numbers of few digits are rounded as std::from_chars rounds them", "[number]") {
    std::mt19937_64 random(1);
    std::vector<std::string> cells{"9007199254740992", "9007199254740993", "-0.00", ".5", "5.", "0.3",
                                   "00000000.1000001"};
    for (int i = 0; i < 20000; ++i) {
        std::string digits = std::to_string(random() >> (random() % 60));
        digits.insert(random() % (digits.size() + 1), ".");
        cells.push_back((i % 2 == 0 ? "-" : "") + digits);
    }
    for (const std::string& cell : cells) {
        double truth = 0;
        std::from_chars(cell.data(), cell.data() + cell.size(), truth);
        const double number = number_in(cell, false).value();
        if (number != truth || std::signbit(number) != std::signbit(truth)) FAIL(cell);
        std::string comma = cell;
        std::replace(comma.begin(), comma.end(), '.', ',');
        if (number_in(comma, true) != truth) FAIL(comma);
    }
    for (const char* cell : {".", "-", "+.", "1..2", "1.2.3", "-+1"}) CHECK_FALSE(number_in(cell, false));
}

TEST_CASE("the last digit of a number has a power of ten", "[number]") {
    CHECK(last_digit_of("12") == 0);
    CHECK(last_digit_of("1.50") == -2);
    CHECK(last_digit_of("1,50") == -2);
    CHECK(last_digit_of("1.50e3") == 1);
    CHECK(last_digit_of("2E-7") == -7);
}

TEST_CASE("a column is printed to decimals or to significant digits, whichever is coarser", "[number]") {
    PrintedDigits decimals, significant;
    for (const auto& [cell, value] : {std::pair{"0.25", 0.25}, {"10.25", 10.25}, {"0.00", 0.0}})
        decimals.add(cell, value);
    CHECK(decimals.resolution() == 0.01);
    for (const auto& [cell, value] : {std::pair{"0.00125", 0.00125}, {"125", 125.0}}) significant.add(cell, value);
    CHECK(significant.resolution() == 1.0);
    std::vector<std::pair<const char*, double>> column{
        {"0.25", 0.25}, {"-10.5", -10.5}, {"0", 0.0}, {"100", 100.0}, {"2.5", 2.5}};
    std::sort(column.begin(), column.end());
    do {
        PrintedDigits digits;
        for (const auto& [cell, value] : column) digits.add(cell, value);
        CHECK(digits.resolution() == 1.0);  // 100 has as many significant digits as -10.5
    } while (std::next_permutation(column.begin(), column.end()));
}

TEST_CASE("the excerpt of a cell in a message is short and printable", "[number]") {
    CHECK(shown_cell("a\tb\x9F") == "\"a?b?\"");
    CHECK(shown_cell("\xC2\xB5m \xE2\x84\xAB") == "\"\xC2\xB5m \xE2\x84\xAB\"");  // micro, angstrom
    CHECK(shown_cell("\xB5m") == "\"\xC2\xB5m\"");                                // the same in CP1252
    CHECK(shown_cell("\xE2\x80\xAE\xC2\x85\xC2") == "\"??\xC3\x82\"");  // turns text round; a control; half a letter
    CHECK(shown_cell("\xF0\x9D\x9C\x8Em") == "\"\xF0\x9D\x9C\x8Em\"");  // a sigma of four bytes
    CHECK(shown_cell("\xF3\xA0\x80\x81") == "\"?\"");                   // a tag, which is not seen
    for (const char* none : {"\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xF0\x9D\x9C"})
        CHECK(utf8_length(none) == 0);
    CHECK(number_in("1.0D-02", false) == 0.01);
    CHECK(number_in("2,5d1", true) == 25);
    CHECK_FALSE(number_in("1D", false));
    CHECK(last_digit_of("1.50D-02") == -4);
    CHECK(shown_cell(std::string(41, 'x')) == "\"" + std::string(40, 'x') + "...\"");
    CHECK(printable("abc\n", 3) == "abc");
    CHECK(is_missing_word("BAD"));
    CHECK(is_missing_word("NaN"));
    CHECK_FALSE(is_missing_word("bads"));
}

}  // namespace number_test
