// SPDX-License-Identifier: BSD-3-Clause
#include "io/ambiguous_signs.hpp"

#include "io/unequal_steps.hpp"
#include "io/word_columns.hpp"

#include <algorithm>

namespace fstiff::inline v0_1::io::detail {

bool has_both_signs(std::string_view cell) {
    return cell.find_first_of(".,") != cell.find_last_of(".,") &&
           cell.find_first_not_of("+-0123456789.,") == std::string_view::npos;
}

namespace {

/// Whether a cell of \p table has \p sign between thousands.
bool has_grouped_cell(const NumberTable& table, std::string_view sign) {
    std::vector<std::string_view> cells;
    return std::any_of(table.lines.begin() + static_cast<std::ptrdiff_t>(table.first), table.lines.end(),
                       [&](const Line& line) {
                           split_line(line.text, table.dialect.separator, cells);
                           return std::any_of(cells.begin(), cells.end(),
                                              [&](std::string_view cell) { return is_grouped(cell, sign); });
                       });
}

/// The way out where \p cell has separators of thousands, or others have with the decimal \p sign; else empty.
std::string way_out(const NumberTable& table, std::string_view cell, std::string_view decimal) {
    std::string_view sign = thousands_sign_of(cell);
    if (sign.empty() && has_grouped_cell(table, decimal)) sign = decimal;
    if (sign.empty()) return "";
    return ", or with those that are " + given_as(table.names, "thousands", "\"" + std::string(sign) + "\"");
}

}  // namespace

void refuse_sign(const NumberTable& table, const std::string& name, std::size_t line, std::string_view cell,
                 bool comma) {
    refuse_line(name, line,
                {shown_cell(cell), " is not a number where the decimal sign is the ", comma ? "comma" : "point",
                 "; allowed are numbers with one decimal sign, without separators of thousands",
                 way_out(table, cell, comma ? "," : ".")});
}

void refuse_grouped_row(const NumberTable& table, const std::string& name, const Line& line) {
    std::vector<std::string_view> cells;
    const auto is_cell = [](std::string_view cell) {
        return cell.empty() || number_in(cell, true) || number_in(cell, false) || is_missing_word(cell) ||
               !thousands_sign_of(cell).empty();
    };
    for (const char separator : {';', '\t', ',', ' '}) {
        split_line(line.text, separator, cells);
        const auto grouped =
            std::find_if(cells.begin(), cells.end(), [](auto cell) { return !thousands_sign_of(cell).empty(); });
        if (grouped == cells.end() || !std::all_of(cells.begin(), cells.end(), is_cell)) continue;
        const std::string_view sign = thousands_sign_of(*grouped);
        refuse_sign(table, name, line.number, *grouped,
                    sign == "." || (sign != "," && grouped->find(',') != sign.npos));
    }
}

void refuse_blank_groups(const NumberTable& table, const std::string& name, const Line& line, Dialect dialect) {
    if (dialect.separator != ' ' || !dialect.decimal_comma || !table.thousands.empty()) return;
    std::vector<std::string_view> cells;
    split_line(line.text, ',', cells);
    const auto is_cell = [](std::string_view cell) { return is_grouped(cell, " ") || number_in(cell, false); };
    // between decimal commas, blanks would leave whole numbers in the first and the last column alone
    if (cells.size() < 4 || !is_grouped(cells.front(), " ") || !is_grouped(cells.back(), " ")) return;
    if (std::all_of(cells.begin(), cells.end(), is_cell)) refuse_sign(table, name, line.number, cells.front(), true);
}

namespace {

/// Whether every second comma alone is followed by a blank, as in "0,5, 9,8".
bool has_alternate_blanks(std::string_view line) {
    std::size_t commas = 0;
    for (std::size_t i = line.find(','); i != std::string_view::npos; i = line.find(',', i + 1), ++commas)
        if ((i + 1 < line.size() && line[i + 1] == ' ') != (commas % 2 == 1)) return false;
    return commas > 2;
}

/// Whether the line above the rows has two titles or more between commas, and the rows have more cells; those of R may,
/// whose first is a name in quotes.
bool has_fewer_titles(const NumberTable& table) {
    if (table.lines[table.first].text.find('"') != std::string_view::npos) return false;
    const auto cells = cells_above(table.lines, table.first, ',');
    return cells.size() > 1 && cells.size() < table.columns && std::any_of(cells.begin(), cells.end(), names_something);
}

bool has_points(const NumberTable& table) {
    return has_points(std::span(table.lines).subspan(table.first), table.dialect.separator);
}

}  // namespace

std::string without_points(const NumberTable& table) {
    return has_points(table) ? "" : " (a comma cannot be the decimal sign and separate the columns)";
}

namespace {

/// What rows between commas show of decimal commas, where each number would be two cells.
class DoubleCommas {
public:
    explicit DoubleCommas(const NumberTable& table) : table_(table) {}

    /// Whether they show more than the cells of whole numbers do.
    bool found() {
        std::size_t columns = 0;
        for (std::size_t c = 0; c < table_.columns; ++c) columns += !table_.holds_words(c);
        if (columns < 2 || columns % 2 != 0 || (columns == 2 && table_.words.empty())) return false;
        for (std::size_t i = table_.first; i < table_.lines.size(); ++i)
            if (!is_comment(table_.lines[i].text) && !add(without_comment(table_.lines[i].text))) return false;
        const bool titled = has_titles(table_.lines, table_.first, ',', table_.columns);
        const bool even = first_.size() >= 16 && has_equal_steps(first_, 0.01);
        // fractions of as many digits each, next to whole numbers
        const bool fixed = columns > 2 && fractions_ >= 16 && same_width_ && varied_ && !titled;
        const bool no_positions = columns == 2 && !has_equal_steps(wholes_, 0.01) && !titled;
        return zero_before_ || (columns > 2 && even) || no_positions || exponents_ || fixed ||
               (alternate_ && table_.words.empty());
    }

private:
    /// \return false for a row that has no decimal commas
    bool add(std::string_view line) {
        split_line(line, ',', cells_);
        alternate_ = alternate_ && has_alternate_blanks(line);
        std::vector<std::string_view> numbers;
        for (std::size_t c = 0; c < cells_.size(); ++c)
            if (!table_.holds_words(c)) numbers.push_back(cells_[c]);
        if (numbers.size() < 2) return false;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (numbers[k].find('.') < numbers[k].size()) return false;
            const std::size_t end = (std::min)(numbers[k].find_first_of("eEdD"), numbers[k].size());
            const std::string_view digits = numbers[k].substr(0, end);
            if (k % 2 == 0 ? end < numbers[k].size() : digits.find_first_not_of("0123456789") < digits.size())
                return false;
            varied_ = varied_ || (k % 2 == 0 && digits.size() != numbers[0].size());
            if (k % 2 == 0) continue;
            same_width_ = same_width_ && (fractions_++ == 0 || digits.size() == width_);
            width_ = digits.size();
            exponents_ = exponents_ && end < numbers[k].size();
            zero_before_ = zero_before_ || (digits.size() > 1 && digits.front() == '0');
        }
        wholes_.push_back(number_in(numbers[0], false).value_or(0));
        first_.push_back(number_in(std::string(numbers[0]) + "." + std::string(numbers[1]), false).value_or(0));
        return true;
    }

    const NumberTable& table_;
    std::vector<std::string_view> cells_{};
    bool zero_before_ = false, alternate_ = true, exponents_ = true;
    bool same_width_ = true, varied_ = false;  // of fractions, of whole numbers
    std::size_t width_{}, fractions_{};
    std::vector<double> wholes_{}, first_{};  // of the first two cells, the first alone, and both as one number
};

}  // namespace

void refuse_double_comma(const NumberTable& table, const std::string& name) {
    if (table.dialect.separator != ',') return;
    if ((has_fewer_titles(table) && !has_points(table)) || DoubleCommas(table).found())
        refuse_line(name, table.lines[table.first].number,
                    {shown_cell(table.lines[table.first].text),
                     " has commas between its columns and in its numbers; must have another separator, or points for "
                     "its decimal signs"});
}

namespace {

/// "--thousands none", for messages.
std::string none_between_thousands(const OptionNames& names) {
    return names.prefix + "thousands" + names.equals + (names.prefix.empty() ? "\"none\"" : "none");
}

}  // namespace

void refuse_split_thousands(const NumberTable& table, const std::string& name) {
    const bool blank = table.dialect.separator == ' ';
    if (!(blank || table.dialect.separator == ',') || !table.thousands.empty()) return;
    for (std::size_t c = 0; c < table.columns; ++c)
        if (const std::size_t line = table.signs[c].split_line(); line != 0)
            refuse_line(name, line,
                        {"columns ", c, " and ", c + 1, " may be one number with a ", blank ? "blank" : "comma",
                         " between its thousands; must ",
                         blank ? "be given by " + table.names.prefix + "thousands" + table.names.equals + "\" \""
                               : "have another separator of columns",
                         ", or, if they are two, be given by ", none_between_thousands(table.names)});
}

void refuse_thousands(const NumberTable& table, const std::vector<std::size_t>& columns, bool together,
                      const std::string& name) {
    if (!table.thousands.empty()) return;
    const std::string_view sign = table.dialect.decimal_comma ? "," : ".";
    std::vector<ColumnSigns> all(together ? 1 : columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) all[together ? 0 : k].add(table.signs[columns[k]]);
    const bool known =
        sign == "." || std::any_of(all.begin(), all.end(), [](const auto& one) { return one.are_decimal(); });
    for (const ColumnSigns& signs : all)
        if (signs.may_be_thousands(known))
            refuse_line(name, signs.grouped().line,
                        {shown_cell(signs.grouped().cell),
                         " may be a whole number with a separator of thousands, because "
                         "every fraction has three digits and ",
                         shown_cell(signs.whole().cell), " in line ", signs.whole().line, " has none; must be ",
                         given_as(table.names, "thousands", "\"" + std::string(sign) + "\""),
                         ", or, if it is decimal, by ", none_between_thousands(table.names)});
}

void settle_lone_commas(NumberTable& table) {
    const std::vector<Line>& lines = table.lines;
    if (table.dialect.separator != ',' || !table.words.empty()) return;
    // titles that the comma separates, each with its unit, settle it
    if (table.first > 0 && !units_in(lines[table.first - 1].text, 2, ',').empty()) return;
    std::optional<double> before, step;
    bool positions = true, decimals = true, groups = true;
    for (std::size_t i = table.first; i < lines.size(); ++i) {
        if (is_comment(lines[i].text)) continue;
        const std::string_view line = trimmed(without_comment(lines[i].text));
        if (is_missing_word(line) || table.missing.has_word(line)) {
            positions = false;
            continue;
        }
        if (line.find_first_of(". \t\"") != std::string_view::npos || line.ends_with(',')) return;
        decimals = decimals && number_in(line, true);
        groups = groups && (line.find(',') == std::string_view::npos || is_grouped(line, ","));
        if (!decimals && !groups) return;
        const auto position = number_in(line.substr(0, line.find(',')), false);
        if (before && position) {
            const double next = *position - *before;
            positions = positions && next != 0 && (!step || next == *step);
            step = next;
        }
        positions = positions && position;
        before = position;
    }
    if (positions) return;
    table.dialect = {' ', true};
    table.columns = 1;
}

}  // namespace fstiff::inline v0_1::io::detail
