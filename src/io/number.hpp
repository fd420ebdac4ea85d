// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The numbers of text: what the readers of fstiff share of blanks, cells and decimal numbers.
///
/// Valid       finite decimal numbers; the decimal sign is the point in every locale, or the comma where a file uses it
/// Accuracy    correctly rounded (tests/io/quantity_test.cpp)

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace fstiff::inline v0_1::io::detail {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_decimal_sign(char c) { return c == '.' || c == ','; }

constexpr std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// ASCII only, in every locale.
std::string lower_case(std::string_view text);

/// How many bytes the UTF-8 character takes that \p text begins with; 0 where there is none.
constexpr std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.empty()) return 0;
    const std::size_t length = byte(0) < 0x80                     ? 1
                               : byte(0) < 0xC2 || byte(0) > 0xF4 ? 0
                               : byte(0) < 0xE0                   ? 2
                               : byte(0) < 0xF0                   ? 3
                                                                  : 4;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    if (byte(0) == 0xE0 && byte(1) < 0xA0) return 0;  // two bytes would do
    if (byte(0) == 0xED && byte(1) > 0x9F) return 0;  // half a character of UTF-16
    if (byte(0) == 0xF0 && byte(1) < 0x90) return 0;  // three bytes would do
    if (byte(0) == 0xF4 && byte(1) > 0x8F) return 0;  // beyond U+10FFFF
    return length;
}

/// \p text as a message may show it: printable whatever the file holds, no longer than \p longest characters. Letters
/// and signs of UTF-8 stay, those of an 8-bit code page (\xB5 is the micro sign) become UTF-8, all else becomes "?".
std::string printable(std::string_view text, std::size_t longest);

/// A cell for a message: short, and printable.
std::string shown_cell(std::string_view cell);

/// A number for a message, whatever the locale.
std::string number_text(double value);

enum class NumberStatus { ok, no_number, out_of_range };

struct LeadingNumber {
    double value{};
    std::size_t length{};  // characters taken
    NumberStatus status = NumberStatus::no_number;
};

/// The decimal number that \p text begins with, times 10^\p exponent, correctly rounded. No blanks, no "inf", no "nan".
LeadingNumber leading_number(std::string_view text, int exponent = 0);

/// The power of ten of the last digit of the number that fills \p cell.
double last_digit_of(std::string_view cell);

/// The number that fills \p cell, which may have a Fortran exponent as 1.0D-02 has; none when something else does, as
/// where a point is in a number whose decimal sign is the comma: it may separate thousands. What is too small for a
/// double counts as zero; what is too large is infinite, to be refused by the caller.
std::optional<double> number_in(std::string_view cell, bool decimal_comma);

/// Whether a number fills \p cell, with either decimal sign.
inline bool is_number(std::string_view cell) { return number_in(cell, false) || number_in(cell, true); }

/// Separators of thousands, as an option names them: a blank is one of Unicode and of CP1252 too, an apostrophe the
/// typographic one too.
inline constexpr std::array<std::string_view, 4> thousands_signs{",", ".", "'", " "};

/// Bytes of the separator of thousands \p sign that \p text begins with; 0 where there is none.
std::size_t separator_length(std::string_view text, std::string_view sign);

/// Length of the whole digits in groups of three that \p text begins with, as 1,234,567 is; 0 where there are none.
std::size_t grouped_digits(std::string_view text, std::string_view sign);

/// Whether \p cell is a number with \p sign between its thousands, and decimals or none: -1,234.5.
bool is_grouped(std::string_view cell, std::string_view sign);

/// The separator of thousands in \p cell; empty where it is no such number. That of 1,234 is the comma.
std::string_view thousands_sign_of(std::string_view cell);

/// The words for a missing point, for messages.
inline constexpr std::string_view missing_words_text = "nan, inf, NA, N/A, #N/A, BAD, No Data, --- or ***";

/// Whether \p cell is a word for a missing point: those above in any case, and their like, as programs print a number
/// that is none (1.#IND, -nan(ind), Infinity) and workbooks a formula that fails (#VALUE!, #DIV/0!).
bool is_missing_word(std::string_view cell);

/// To how many digits the numbers of a column are printed, trailing zeros dropped or not.
class PrintedDigits {
public:
    /// \p value is what fills \p cell.
    void add(std::string_view cell, double value) {
        const double last_digit = last_digit_of(cell), size = std::abs(value);
        if (last_digit >= covered_digit_ && size <= covered_size_) return;
        covered_digit_ = last_digit, covered_size_ = size;
        finest_ = (std::min)(finest_, last_digit);
        if (value == 0) return;
        const double first_digit = std::floor(std::log10(size));
        largest_ = (std::max)(largest_, first_digit);
        significant_ = (std::max)(significant_, first_digit - last_digit + 1);
    }
    /// Weight of the last digit of the largest number: as many decimals, or as many significant digits, as any other.
    /// 0 where there is no number.
    [[nodiscard]] double resolution() const {
        return finest_ < infinite ? std::pow(10.0, (std::max)(finest_, largest_ - significant_ + 1)) : 0;
    }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    double finest_ = infinite, largest_ = -infinite, significant_ = 0;
    double covered_digit_ = infinite, covered_size_ = -1;  // of a number: another one within both changes nothing
};

}  // namespace fstiff::inline v0_1::io::detail
