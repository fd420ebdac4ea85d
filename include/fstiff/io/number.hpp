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

/// \p text as a message may show it: printable whatever the file holds, no longer than \p longest.
inline std::string printable(std::string_view text, std::size_t longest) {
    std::string shown;
    for (const char c : text.substr(0, longest)) shown += c >= ' ' && c <= '~' ? c : '?';
    return shown;
}

/// A cell for a message: short, and printable.
inline std::string shown_cell(std::string_view cell) {
    constexpr std::size_t longest = 40;
    return "\"" + printable(cell, longest) + (cell.size() > longest ? "...\"" : "\"");
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
    const std::size_t e = std::min(cell.find_first_of("eE"), cell.size());
    const std::size_t point = std::min(cell.find_first_of(".,"), e);
    const double decimals = point < e ? static_cast<double>(e - point - 1) : 0;
    return (e < cell.size() ? leading_number(cell.substr(e + 1)).value : 0) - decimals;
}

/// The number that fills \p cell; none when something else does. What is too small for a double counts as zero; what is
/// too large is infinite, to be refused by the caller.
inline std::optional<double> number_in(std::string_view cell, bool decimal_comma) {
    char buffer[64];
    if (decimal_comma && cell.find(',') != std::string_view::npos) {
        if (cell.size() > sizeof buffer || cell.find('.') != std::string_view::npos) return std::nullopt;
        std::replace_copy(cell.begin(), cell.end(), buffer, ',', '.');
        cell = {buffer, cell.size()};
    }
    const LeadingNumber number = leading_number(cell);
    if (number.length != cell.size() || number.status == NumberStatus::no_number) return std::nullopt;
    if (number.status == NumberStatus::ok) return number.value;
    return last_digit_of(cell) < 0 ? 0.0 : std::numeric_limits<double>::infinity();
}

/// The words that stand for a missing point in a map.
inline bool is_missing_word(std::string_view cell) {
    const std::string word = cell.size() == 3 ? lower_case(cell) : std::string();
    return word == "nan" || word == "bad";
}

/// To how many digits the numbers of a column are printed, trailing zeros dropped or not.
class PrintedDigits {
public:
    /// \p value is what fills \p cell.
    void add(std::string_view cell, double value) {
        const double last_digit = last_digit_of(cell);
        finest_ = std::min(finest_, last_digit);
        if (value == 0) return;
        const double first_digit = std::floor(std::log10(std::abs(value)));
        largest_ = std::max(largest_, first_digit);
        significant_ = std::max(significant_, first_digit - last_digit + 1);
    }
    /// Weight of the last digit of the largest number: as many decimals, or as many significant digits, as any other.
    [[nodiscard]] double resolution() const { return std::pow(10.0, std::max(finest_, largest_ - significant_ + 1)); }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    double finest_ = infinite, largest_ = -infinite, significant_ = 0;
};

}  // namespace fstiff::io::detail
