// SPDX-License-Identifier: BSD-3-Clause
#include "io/number.hpp"

#include <cfloat>
#include <cstdint>

namespace fstiff::inline v0_1::io::detail {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string printable(std::string_view text, std::size_t longest) {
    std::string shown;
    for (; !text.empty() && longest > 0; --longest) {
        const std::size_t length = utf8_length(text);
        const std::string_view taken = text.substr(0, std::max<std::size_t>(length, 1));
        const auto first = static_cast<unsigned char>(taken[0]);
        // controls; and the signs of U+2000 to U+206F, U+FE00 to U+FFFF and U+C0000 to U+FFFFF, some of which hide or
        // turn text round
        const bool hidden =
            (first == 0xC2 && length == 2 && static_cast<unsigned char>(taken[1]) < 0xA0) ||
            (length == 3 && (taken.starts_with("\xE2\x80") || taken.starts_with("\xE2\x81") || first == 0xEF)) ||
            (length == 4 && first == 0xF3);
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

std::string shown_cell(std::string_view cell) {
    constexpr std::size_t longest = 40;
    std::size_t characters = 0;
    for (std::string_view rest = cell; !rest.empty() && characters <= longest; ++characters)
        rest.remove_prefix(std::max<std::size_t>(utf8_length(rest), 1));
    return "\"" + printable(cell, longest) + (characters > longest ? "...\"" : "\"");
}

std::string number_text(double value) { return fstiff::detail::rounded_text(value, 10); }

LeadingNumber leading_number(std::string_view text, int exponent) {
    const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t point = text.size() > sign && text[sign] == '.' ? 1 : 0;
    if (text.size() <= sign + point || !is_digit(text[sign + point])) return {};
    const std::size_t skipped = text[0] == '+' ? 1 : 0;  // read_decimal takes no "+"
    const char* const first = text.data() + skipped;
    const char* const end = text.data() + text.size();
    LeadingNumber number;
    const auto parsed = fstiff::detail::read_decimal(first, end, number.value);
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
        fits =
            fstiff::detail::read_decimal(joined.data(), joined.data() + joined.size(), number.value).ec == std::errc();
    }
    number.status = fits ? NumberStatus::ok : NumberStatus::out_of_range;
    return number;
}

double last_digit_of(std::string_view cell) {
    const auto exponent =
        std::find_if(cell.begin(), cell.end(), [](char c) { return (c | 0x20) == 'e' || (c | 0x20) == 'd'; });
    const auto point = std::find_if(cell.begin(), exponent, is_decimal_sign);
    const auto decimals = static_cast<double>(point == exponent ? 0 : exponent - point - 1);
    return (exponent == cell.end() ? 0 : leading_number({exponent + 1, cell.end()}).value) - decimals;
}

namespace {

/// The number that fills \p cell where it has no exponent and at most 16 characters after its sign. Digits up to 2^53
/// and powers of ten are exact, so that their quotient is correctly rounded (Clinger, PLDI 1990, 92-101).
std::optional<double> short_number(std::string_view cell, char decimal_sign) {
    static constexpr std::array<double, 17> powers{1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                                                   1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};
    const bool is_negative = cell.starts_with('-');
    if (is_negative || cell.starts_with('+')) cell.remove_prefix(1);
    if (cell.size() >= powers.size() || FLT_EVAL_METHOD != 0) return std::nullopt;
    std::uint64_t digits = 0;
    std::size_t count = 0, before_sign = cell.size();
    for (std::size_t i = 0; i < cell.size(); ++i) {
        if (is_digit(cell[i])) {
            digits = 10 * digits + static_cast<std::uint64_t>(cell[i] - '0');
            ++count;
        } else if (cell[i] == decimal_sign && before_sign == cell.size()) {
            before_sign = i;
        } else {
            return std::nullopt;
        }
    }
    if (count == 0 || digits > std::uint64_t(1) << 53) return std::nullopt;
    const double value = static_cast<double>(digits) / powers[count - (std::min)(count, before_sign)];
    return is_negative ? -value : value;
}

}  // namespace

std::optional<double> number_in(std::string_view cell, bool decimal_comma) {
    if (const auto number = short_number(cell, decimal_comma ? ',' : '.')) return number;
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

std::size_t separator_length(std::string_view text, std::string_view sign) {
    if (text.starts_with(sign)) return 1;
    if (sign == "'") return text.starts_with("\xE2\x80\x99") ? 3 : text.starts_with('\x92') ? 1 : 0;
    if (sign != " ") return 0;
    if (text.starts_with('\xA0')) return 1;
    if (text.starts_with("\xC2\xA0")) return 2;
    for (const std::string_view blank : {"\xE2\x80\x87", "\xE2\x80\x89", "\xE2\x80\xAF"})  // figure, thin, narrow
        if (text.starts_with(blank)) return 3;
    return 0;
}

std::size_t grouped_digits(std::string_view text, std::string_view sign) {
    const auto digits_at = [&](std::size_t i) {
        const std::size_t end = (std::min)(text.find_first_not_of("0123456789", i), text.size());
        return end - (std::min)(i, end);
    };
    const std::size_t first = digits_at(0);
    if (first == 0 || first > 3 || text[0] == '0') return 0;
    std::size_t end = first;
    for (;;) {
        const std::size_t separator = separator_length(text.substr(end), sign);
        const std::size_t digits = separator == 0 ? 0 : digits_at(end + separator);
        if (digits == 0) return end == first ? 0 : end;
        if (digits != 3) return 0;
        end += separator + digits;
    }
}

bool is_grouped(std::string_view cell, std::string_view sign) {
    if (cell.starts_with('+') || cell.starts_with('-')) cell.remove_prefix(1);
    const std::size_t whole = grouped_digits(cell, sign);
    if (whole == 0) return false;
    cell.remove_prefix(whole);
    if (cell.empty()) return true;
    return (cell[0] == '.' || cell[0] == ',') && cell[0] != sign[0] &&
           cell.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

std::string_view thousands_sign_of(std::string_view cell) {
    const auto sign = std::find_if(thousands_signs.begin(), thousands_signs.end(),
                                   [&](std::string_view one) { return is_grouped(cell, one); });
    return sign == thousands_signs.end() ? std::string_view() : *sign;
}

namespace {

/// "1.#IND", "1.#QNAN0" and what its rounding makes of them ("1.#J", "1.$"), as old libraries of Microsoft print.
bool is_number_of_msvc(std::string_view word) {
    if (word == "1.$") return true;
    if (!word.starts_with("1.#")) return false;
    word.remove_prefix(3);
    const std::size_t letters = (std::min)(word.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), word.size());
    return word.find_first_not_of('0', letters) == std::string_view::npos;
}

/// "#VALUE!", "#NAME?", "#N/A" and those of other languages, "#NV", "#N/D"; "Err:502" of LibreOffice.
bool is_error_of_workbook(std::string_view word) {
    if (word.starts_with("err:")) return word.find_first_not_of("0123456789", 4) == std::string_view::npos;
    if (word.size() < 3 || word[0] != '#' || word.find_first_of(" \t") != std::string_view::npos) return false;
    return word.ends_with('!') || word.ends_with('?') || word == "#n/a" || word == "#na" || word == "#nv" ||
           word == "#n/d" || word == "#nan";
}

}  // namespace

bool is_missing_word(std::string_view cell) {
    constexpr std::size_t longest = 24;
    if (cell.empty() || cell.size() > longest) return false;
    const std::string_view bare = cell.front() == '-' || cell.front() == '+' ? cell.substr(1) : cell;
    if (!bare.empty() && is_digit(bare[0]) && !bare.starts_with("1.#") && bare != "1.$") return false;
    for (const std::string_view sign : {"*", "-", "?", "\xE2\x80\x93", "\xE2\x80\x94"})  // and both dashes of Unicode
        if (cell.starts_with(sign)) {
            std::string_view rest = cell;
            while (rest.starts_with(sign)) rest.remove_prefix(sign.size());
            if (rest.empty()) return true;
        }
    const std::string word = lower_case(bare);
    for (const char* known : {"nan", "nanq", "nans", "qnan", "snan", "inf", "infinity", "na", "n/a", "bad", "no data",
                              "nodata", "no_data", "null", "none", "missing", "invalid", "void"})
        if (word == known) return true;
    return (word.starts_with("nan(") && word.ends_with(')')) || is_number_of_msvc(word) || is_error_of_workbook(word);
}

}  // namespace fstiff::inline v0_1::io::detail
