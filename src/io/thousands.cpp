// SPDX-License-Identifier: BSD-3-Clause
#include "io/thousands.hpp"

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

namespace {

/// What the cells of a column show of its decimal sign.
struct Signs {
    std::size_t grouped{}, whole{};  // cells like 1,003 and like 986
    bool decimal{};                  // other fractions are there
    double largest_group{}, smallest_group{std::numeric_limits<double>::infinity()};
    double largest_whole{}, sum_of_whole{};
    std::string group_cell, whole_cell;
    std::size_t group_line{}, whole_line{};

    void add(std::string_view cell, double value, std::size_t line, std::string_view sign) {
        if (is_grouped(cell, sign)) {
            if (grouped++ == 0) group_cell = cell, group_line = line;
            largest_group = (std::max)(largest_group, std::abs(value));
            smallest_group = (std::min)(smallest_group, std::abs(value));
        } else if (cell.find_first_not_of("+-0123456789") == std::string_view::npos) {
            if (whole++ == 0) whole_cell = cell, whole_line = line;
            largest_whole = (std::max)(largest_whole, std::abs(value));
            sum_of_whole += std::abs(value);
        } else {
            decimal = true;
        }
    }
    /// Whether the fractions may be thousands: next to them are whole numbers below them all. \p known: the sign is
    /// decimal elsewhere in the file, or the point, which is decimal as a rule. Then whole numbers among few fractions,
    /// and zeros, may be what they are, unless they are far above the fractions.
    bool may_be_thousands(bool known) const {
        if (decimal || grouped == 0 || whole == 0) return false;
        // some languages separate thousands from 10 000 on only
        if (!(largest_whole < 10000 && largest_whole < 1000 * smallest_group)) return false;
        const bool may_lack_zeros = grouped < 50 || largest_whole == 0;
        return !(known && may_lack_zeros && sum_of_whole <= 2 * largest_group * static_cast<double>(whole));
    }
};

}  // namespace

void refuse_thousands(const NumberTable& table, const std::vector<std::size_t>& columns, bool together,
                      const std::string& name) {
    const std::string_view sign = table.dialect.decimal_comma ? "," : ".";
    if (!table.thousands.empty()) return;
    std::vector<Signs> all(together ? 1 : columns.size());
    std::vector<std::string_view> cells;
    std::size_t r = 0;
    for (std::size_t i = table.first; i < table.lines.size() && r < table.rows(); ++i) {
        if (table.lines[i].number != table.row_lines[r]) continue;
        ++r;
        split_row(without_comment(table.lines[i].text), table.dialect.separator, cells);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            Signs& signs = all[together ? 0 : k];
            if (columns[k] >= cells.size() || signs.decimal) continue;
            const std::string_view cell = cells[columns[k]];
            const auto value = number_in(cell, table.dialect.decimal_comma);
            if (value && !table.missing.has(*value)) signs.add(cell, *value, table.lines[i].number, sign);
        }
        if (std::all_of(all.begin(), all.end(), [](const Signs& one) { return one.decimal; })) return;
    }
    const bool known = sign == "." || std::any_of(all.begin(), all.end(), [](const Signs& one) { return one.decimal; });
    for (const Signs& signs : all)
        if (signs.may_be_thousands(known))
            refuse_line(name, signs.group_line,
                        {shown_cell(signs.group_cell),
                         " may be a whole number with a separator of thousands, because "
                         "every fraction has three digits and ",
                         shown_cell(signs.whole_cell), " in line ", signs.whole_line, " has none; must be ",
                         given_as(table.names, "thousands", "\"" + std::string(sign) + "\""),
                         ", or, if it is decimal, by ", table.names.prefix, "thousands", table.names.equals,
                         table.names.prefix.empty() ? "\"none\"" : "none"});
}

}  // namespace fstiff::inline v0_1::io::detail
