// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The numbers of text: what the readers of fstiff share of blanks, cells and decimal numbers. All of it is internal.
///
/// Valid       finite decimal numbers; the decimal sign is the point in every locale, or the comma where a file says so
/// Accuracy    correctly rounded (tests/io/quantity_test.cpp)

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace fstiff::io::detail {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// ASCII only: the locale has no say.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

/// How many bytes the UTF-8 character takes that \p text begins with; 0 where there is none.
constexpr std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.empty()) return 0;
    const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xC2 ? 0 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    if (byte(0) == 0xE0 && byte(1) < 0xA0) return 0;  // two bytes would do
    if (byte(0) == 0xED && byte(1) > 0x9F) return 0;  // half a character of UTF-16
    return length;
}

/// \p text as a message may show it: printable whatever the file holds, no longer than \p longest characters. Letters and
/// signs of UTF-8 stay, those of an 8-bit code page (\xB5 is the micro sign) become UTF-8, all else becomes "?".
inline std::string printable(std::string_view text, std::size_t longest) {
    std::string shown;
    for (; !text.empty() && longest > 0; --longest) {
        const std::size_t length = utf8_length(text);
        const std::string_view taken = text.substr(0, std::max<std::size_t>(length, 1));
        const auto first = static_cast<unsigned char>(taken[0]);
        // controls; and the signs of U+2000 to U+206F and U+FE00 to U+FFFF, some of which hide or turn text round
        const bool hidden =
            (first == 0xC2 && length == 2 && static_cast<unsigned char>(taken[1]) < 0xA0) ||
            (length == 3 && (taken.starts_with("\xE2\x80") || taken.starts_with("\xE2\x81") || first == 0xEF));
        if (length == 1 ? first >= ' ' && first <= '~' : length > 1 && !hidden)
            shown += taken;
        else if (length == 0 && first >= 0xA0)
            shown += {static_cast<char>(0xC0 | (first >> 6)), static_cast<char>(0x80 | (first & 0x3F))};
        else
            shown += '?';
        text.remove_prefix(taken.size());
    }
    return shown;
}

/// A cell for a message: short, and printable.
inline std::string shown_cell(std::string_view cell) {
    constexpr std::size_t longest = 40;
    std::size_t characters = 0;
    for (std::string_view rest = cell; !rest.empty() && characters <= longest; ++characters)
        rest.remove_prefix(std::max<std::size_t>(utf8_length(rest), 1));
    return "\"" + printable(cell, longest) + (characters > longest ? "...\"" : "\"");
}

/// A number for a message, whatever the locale.
inline std::string number_text(double value) { return rounded_text(value, 10); }

enum class NumberStatus { ok, no_number, out_of_range };

struct LeadingNumber {
    double value{};
    std::size_t length{};  // characters taken
    NumberStatus status = NumberStatus::no_number;
};

/// The decimal number that \p text begins with, times 10^\p exponent, correctly rounded. No blanks, no "inf", no "nan".
inline LeadingNumber leading_number(std::string_view text, int exponent = 0) {
    const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t point = text.size() > sign && text[sign] == '.' ? 1 : 0;
    if (text.size() <= sign + point || !is_digit(text[sign + point])) return {};
    const std::size_t skipped = text[0] == '+' ? 1 : 0;  // read_decimal knows no "+"
    const char* const first = text.data() + skipped;
    const char* const end = text.data() + text.size();
    LeadingNumber number;
    const auto parsed = read_decimal(first, end, number.value);
    number.length = static_cast<std::size_t>(parsed.ptr - text.data());
    bool fits = parsed.ec == std::errc();
    if (fits && exponent != 0) {
        // The power of ten of the unit joins the exponent of the text, so that only one rounding happens.
        const std::string_view digits(first, number.length - skipped);
        const std::size_t e = digits.find_first_of("eE");
        int written = 0;
        if (e != std::string_view::npos) {
            const std::size_t plus = digits[e + 1] == '+' ? 1 : 0;
            std::from_chars(digits.data() + e + 1 + plus, digits.data() + digits.size(), written);
        }
        const std::string joined = std::string(digits.substr(0, e)) + "e" + std::to_string(written + exponent);
        fits = read_decimal(joined.data(), joined.data() + joined.size(), number.value).ec == std::errc();
    }
    number.status = fits ? NumberStatus::ok : NumberStatus::out_of_range;
    return number;
}

/// The power of ten of the last digit of the number that fills \p cell.
inline double last_digit_of(std::string_view cell) {
    const std::size_t e = (std::min)(cell.find_first_of("eEdD"), cell.size());
    const std::size_t point = (std::min)(cell.find_first_of(".,"), e);
    const double decimals = point < e ? static_cast<double>(e - point - 1) : 0;
    return (e < cell.size() ? leading_number(cell.substr(e + 1)).value : 0) - decimals;
}

/// The number that fills \p cell, which may have a Fortran exponent as 1.0D-02 has; none when something else does, as where
/// a point is in a number whose decimal sign is the comma: it may separate thousands. What is too small for a double counts
/// as zero; what is too large is infinite, to be refused by the caller.
inline std::optional<double> number_in(std::string_view cell, bool decimal_comma) {
    if (decimal_comma && cell.find('.') != std::string_view::npos) return std::nullopt;
    char buffer[64];
    if (cell.size() <= sizeof buffer) {
        const bool comma = decimal_comma && cell.find(',') != std::string_view::npos;
        const std::size_t exponent = cell.find_first_of("dD");
        if (comma || exponent != std::string_view::npos) {
            std::copy(cell.begin(), cell.end(), buffer);
            if (comma) std::replace(buffer, buffer + cell.size(), ',', '.');
            if (exponent != std::string_view::npos) buffer[exponent] = 'e';
            cell = {buffer, cell.size()};
        }
    }
    const LeadingNumber number = leading_number(cell);
    if (number.length != cell.size() || number.status == NumberStatus::no_number) return std::nullopt;
    if (number.status == NumberStatus::ok) return number.value;
    return last_digit_of(cell) < 0 ? 0.0 : std::numeric_limits<double>::infinity();
}

/// The words that stand for a missing point, for messages.
inline constexpr std::string_view missing_words_text = "nan, NA, N/A, BAD, No Data or ***";

/// Whether \p cell is a word that stands for a missing point: those above in any case, and their like.
inline bool is_missing_word(std::string_view cell) {
    if (cell.empty() || cell.size() > 10 || is_digit(cell.front()) || is_digit(cell.back())) return false;
    if (cell.find_first_not_of('*') == std::string_view::npos || cell == "--" || cell == "---") return true;
    const std::string word = lower_case(cell.front() == '-' || cell.front() == '+' ? cell.substr(1) : cell);
    for (const char* known : {"nan", "nan(ind)", "nan(snan)", "na", "n/a", "bad", "no data", "nodata", "no_data",
                              "null", "none", "missing", "invalid", "void"})
        if (word == known) return true;
    return false;
}

/// To how many digits the numbers of a column are printed, trailing zeros dropped or not.
class PrintedDigits {
public:
    /// \p value is what fills \p cell.
    void add(std::string_view cell, double value) {
        const double last_digit = last_digit_of(cell);
        finest_ = (std::min)(finest_, last_digit);
        if (value == 0) return;
        const double first_digit = std::floor(std::log10(std::abs(value)));
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
};

}  // namespace fstiff::io::detail
