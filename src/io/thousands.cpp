// SPDX-License-Identifier: BSD-3-Clause
#include "io/thousands.hpp"

#include "io/cells.hpp"
#include "io/lines.hpp"

#include <cctype>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Whether \p line holds numbers and separators alone.
bool is_row_of_numbers(std::string_view line) {
    return std::all_of(line.begin(), line.end(),
                       [](char c) {
                           return static_cast<unsigned char>(c) >= 0x80 || is_digit(c) ||
                                  std::string_view("+-.,;'\" \t\reEdD").find(c) != std::string_view::npos;
                       }) &&
           std::any_of(line.begin(), line.end(), is_digit);
}

/// The first \p sign in \p line that separates no thousands but touches a digit; npos where there is none.
std::size_t other_use(std::string_view line, std::string_view sign) {
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const std::size_t length = separator_length(line.substr(i), sign);
        const bool before = is_digit(line[i - 1]), after = i + length < line.size() && is_digit(line[i + length]);
        if (length != 0 && (sign == " " ? before && after : before || after)) return i;
    }
    return std::string_view::npos;
}

/// \p line without the separators \p sign of its thousands; with \p quoted, only in numbers between quotes.
std::string ungrouped(std::string_view line, std::string_view sign, bool quoted) {
    std::string plain;
    std::size_t number_end = std::string_view::npos;  // of the last digits
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t digits = (std::min)(line.find_first_not_of("0123456789", i), line.size()) - i;
        if (digits == 0) {
            plain += line[i++];
            continue;
        }
        const std::size_t start = i > 0 && (line[i - 1] == '-' || line[i - 1] == '+') ? i - 1 : i;
        const char before = start > 0 ? line[start - 1] : ' ';
        // "0 1 003": the first blank separates thousands or columns
        const bool joined = number_end < start && number_end + separator_length(line.substr(number_end), sign) == start;
        const bool inside =
            before == '.' || (before == ',' && sign == ",") || std::isalpha(static_cast<unsigned char>(before)) != 0;
        const std::size_t whole =
            joined || inside || (quoted && before != '"') ? 0 : grouped_digits(line.substr(i), sign);
        const std::size_t end = i + (std::max)(whole, digits);
        for (; i < end; ++i)
            if (is_digit(line[i])) plain += line[i];
        number_end = end;
    }
    return plain;
}

}  // namespace

std::string without_thousands(std::string text, const std::string& given, const std::string& name) {
    if (given.empty() || given == "none") return text;
    const auto sign = std::find(thousands_signs.begin(), thousands_signs.end(), given);
    if (sign == thousands_signs.end())
        refuse_field(name, "thousands", shown_cell(given), "one of \",\", \".\", \"'\", \" \" and none");
    std::vector<std::string_view> cells;
    std::size_t count = 0;
    const std::vector<Line> lines = lines_of(text, name, count);
    // "1,003","986": between the quotes the comma separates thousands, outside of them columns
    const bool quoted = *sign == "," && std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
        if (line.text.find('"') == std::string_view::npos) return false;
        split_line(line.text, ',', cells);
        return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return is_grouped(cell, ","); });
    });
    std::string plain;
    std::size_t taken = 0;
    for (const Line& line : lines) {
        const auto begin = static_cast<std::size_t>(line.text.data() - text.data());
        plain += text.substr(taken, begin - taken);
        const std::string row = ungrouped(line.text, *sign, quoted);
        const std::size_t other = quoted || !is_row_of_numbers(row) ? std::string::npos : other_use(row, *sign);
        if (other != std::string::npos)
            refuse_line(name, line.number,
                        {shown_cell(row), " has \"", *sign,
                         "\" where it separates no thousands; must separate them "
                         "alone, three digits each, or thousands be another"});
        plain += row;
        taken = begin + line.text.size();
    }
    return plain + text.substr(taken);
}

}  // namespace fstiff::inline v0_1::io::detail
