// SPDX-License-Identifier: BSD-3-Clause
#include "io/number.hpp"

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

std::string number_text(double value) { return parts::rounded_text(value, 10); }

LeadingNumber leading_number(std::string_view text, int exponent) {
    const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t point = text.size() > sign && text[sign] == '.' ? 1 : 0;
    if (text.size() <= sign + point || !is_digit(text[sign + point])) return {};
    const std::size_t skipped = text[0] == '+' ? 1 : 0;  // read_decimal takes no "+"
    const char* const first = text.data() + skipped;
    const char* const end = text.data() + text.size();
    LeadingNumber number;
    const auto parsed = parts::read_decimal(first, end, number.value);
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
        fits = parts::read_decimal(joined.data(), joined.data() + joined.size(), number.value).ec == std::errc();
    }
    number.status = fits ? NumberStatus::ok : NumberStatus::out_of_range;
    return number;
}

double last_digit_of(std::string_view cell) {
    const std::size_t e = (std::min)(cell.find_first_of("eEdD"), cell.size());
    const std::size_t point = (std::min)(cell.find_first_of(".,"), e);
    const double decimals = point < e ? static_cast<double>(e - point - 1) : 0;
    return (e < cell.size() ? leading_number(cell.substr(e + 1)).value : 0) - decimals;
}

std::optional<double> number_in(std::string_view cell, bool decimal_comma) {
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

bool is_missing_word(std::string_view cell) {
    if (cell.empty() || cell.size() > 10 || is_digit(cell.front()) || is_digit(cell.back())) return false;
    if (cell.find_first_not_of('*') == std::string_view::npos || cell == "--" || cell == "---") return true;
    const std::string word = lower_case(cell.front() == '-' || cell.front() == '+' ? cell.substr(1) : cell);
    for (const char* known : {"nan", "nan(ind)", "nan(snan)", "na", "n/a", "bad", "no data", "nodata", "no_data",
                              "null", "none", "missing", "invalid", "void"})
        if (word == known) return true;
    return false;
}

}  // namespace fstiff::inline v0_1::io::detail
