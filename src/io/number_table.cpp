// SPDX-License-Identifier: BSD-3-Clause
#include "io/number_table.hpp"

#include "io/ambiguous_signs.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

std::size_t written_columns(const NumberTable& table) {
    std::vector<std::string_view> cells;
    split_line(without_comment(table.lines[table.first].text), table.dialect.separator, cells);
    return cells.size();
}

bool is_text_column(const NumberTable& table, std::size_t c) {
    std::vector<std::string_view> cells;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        split_line(without_comment(table.lines[i].text), table.dialect.separator, cells);
        if (c < cells.size() && is_number(cells[c])) return false;
    }
    return true;
}

void NumberTable::forget_rows() {
    values.clear(), row_lines.clear(), printed.clear(), wholes.clear(), signs.clear();
    columns = written_columns(*this);
}

std::string NumberTable::unused() const {
    std::string list, text;
    for (std::size_t c = 0; c < words.size(); ++c)
        if (words[c]) list += (list.empty() ? "" : ", ") + std::to_string(c + 1);
    if (!list.empty())
        text = "; column" + std::string(list.find(',') < list.size() ? "s " : " ") + list + " of words not used";
    if (!footer.empty())
        text += "; " + std::to_string(footer.size()) + (footer.size() == 1 ? " line" : " lines") +
                " after the rows not used (" + shown_cell(footer.front().text) + ")";
    return text;
}

void NumberTable::say_layout(Record& record, std::string roles, bool may_be_one) const {
    const char sign = dialect.separator;
    const std::string separator = may_be_one && columns == 1 && sign == ' ' ? "none"
                                  : sign == ','                             ? "comma"
                                  : sign == ';'                             ? "semicolon"
                                  : sign == '\t'                            ? "tab"
                                  : sign == '|'                             ? "bar"
                                                                            : "blanks";
    record.note("read as", std::move(roles) + "; separator: " + separator + ", decimal " +
                               (dialect.decimal_comma ? "comma" : "point") + unused());
    constexpr std::size_t many = 64;  // a table of its own, not results
    if (footer.size() > many)
        record.warnings.push_back(std::to_string(footer.size()) + " lines after the rows, from line " +
                                  std::to_string(footer.front().number) + " on, are not read");
    const std::size_t header = lines[first].number - 1 - before;  // blank lines and comments included
    std::string text = std::to_string(header) + (header == 1 ? " line" : " lines");
    if (counted != 0) text += ", the last of which is the number of rows";
    if (const std::size_t left = rows_with_words(); left != 0)
        text += ", " + std::to_string(left) + " of which hold" + (left == 1 ? "s" : "") +
                " numbers next to words and are left out";
    record.note("header", text);
}

std::size_t NumberTable::rows_with_words() const {
    std::vector<std::string_view> cells;
    std::size_t rows = 0;
    for (std::size_t i = first; i-- > 0 && !is_comment(lines[i].text); ++rows) {
        split_row(lines[i].text, dialect.separator, cells);
        const auto numbers = std::count_if(cells.begin(), cells.end(), [&](std::string_view cell) {
            return number_in(cell, dialect.decimal_comma).has_value();
        });
        if (dialect.separator == ' ' || cells.size() != columns || numbers < 2) break;
    }
    return rows;
}

namespace {

/// How many columns a table has whose rows may be short: the first one shows some, others may show more, at most as
/// many as the first one has separators for.
std::size_t widest_row(const NumberTable& table) {
    std::vector<std::string_view> cells;
    split_row(without_comment(table.lines[table.first].text), table.dialect.separator, cells);
    const std::size_t written = cells.size();
    std::size_t columns = table.columns;
    for (std::size_t i = table.first + 1; i < table.lines.size() && columns < written; ++i) {
        if (is_comment(table.lines[i].text)) continue;
        split_line(without_comment(table.lines[i].text), table.dialect.separator, cells);
        if (cells.size() <= written) columns = (std::max)(columns, cells.size());
    }
    return columns;
}

/// The \p number in a cell that is not empty. \throws domain_error naming the line where there is none.
double require_number(const std::optional<double>& number, std::string_view cell, const NumberTable& table,
                      std::size_t line, const std::string& name) {
    const bool comma = table.dialect.decimal_comma;
    if (!number && (number_in(cell, !comma) || has_both_signs(cell) || !thousands_sign_of(cell).empty()))
        refuse_sign(table, name, line, cell, comma);
    if (!number)
        refuse_line(name, line,
                    {shown_cell(cell), " is not a number; allowed are finite decimal numbers (an empty cell, ",
                     missing_words_text, " is a missing point; another word for one must be ",
                     given_as(table.names, "missing", "\"WORD\""), ")"});
    if (!std::isfinite(*number))
        refuse_line(name, line,
                    {shown_cell(cell), " is beyond the range of double precision; allowed are finite numbers"});
    return *number;
}

/// A separator at the end of every line makes no column.
void drop_last_column(NumberTable& table) {
    const std::size_t old = table.columns--;
    for (std::size_t r = 1; r < table.rows(); ++r)
        std::copy_n(table.values.data() + r * old, table.columns, table.values.data() + r * table.columns);
    table.values.resize(table.rows() * table.columns);
}

}  // namespace

void read_rows(NumberTable& table, const std::string& name, RowEnds ends) {
    const char separator = table.dialect.separator;
    const bool may_be_short = ends == RowEnds::may_be_short, may_be_thousands = table.thousands.empty();
    const std::string_view sign = table.dialect.decimal_comma ? "," : ".";
    const auto split = may_be_short ? split_line : split_row;
    std::vector<std::string_view> cells;
    split(without_comment(table.lines[table.first].text), separator, cells);
    const std::size_t shown = table.columns;
    table.columns = may_be_short ? widest_row(table) : cells.size();
    if (may_be_short && table.columns > max_short_row_columns)
        refuse_line(name, table.lines[table.first].number,
                    {"has ", table.columns, " columns; must be at most ", max_short_row_columns});
    table.wholes.resize(table.columns);
    table.signs.resize(table.columns);
    table.printed.resize(may_be_short ? table.columns : std::min<std::size_t>(table.columns, 16));
    const std::string_view last = table.lines.back().text;
    const auto bytes = static_cast<std::size_t>(last.data() + last.size() - table.lines[table.first].text.data());
    const std::size_t most_rows = table.lines.size() - table.first;
    table.values.reserve(
        (std::min)(most_rows * table.columns, bytes + most_rows));  // a cell, or its separator, is a byte
    std::size_t last_cells = 0;                                     // rows with something in their last cell
    std::vector<char> text(table.columns, '?');                     // whether a column is one; '?' until it is sought
    const auto holds_words = [&](std::size_t c) {
        if (c < table.words.size() && table.words[c]) return true;
        if (!may_be_short || separator == ' ' || c >= text.size()) return false;
        if (text[c] == '?') text[c] = is_text_column(table, c) ? 'y' : 'n';
        return text[c] == 'y';
    };
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (i != table.first && is_comment(table.lines[i].text)) continue;
        const std::size_t line = table.lines[i].number;
        split(without_comment(table.lines[i].text), separator, cells);
        if (cells.empty()) continue;
        // with blanks between them, an empty cell cannot be seen
        const bool padded = may_be_short && separator != ' ' && cells.size() < table.columns;
        const bool whole = padded || cells.size() == table.columns;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            double value = std::numeric_limits<double>::quiet_NaN();
            const auto number = number_in(cells[c], table.dialect.decimal_comma);
            if (number || !(cells[c].empty() || is_missing_word(cells[c]) || table.missing.has_word(cells[c]) ||
                            holds_words(c))) {
                value = require_number(number, cells[c], table, line, name);
                if (whole && !table.missing.has(value)) {
                    table.wholes[c].add(cells[c], value);
                    if (c < table.printed.size()) table.printed[c].add(cells[c], value);
                    if (may_be_thousands) table.signs[c].add(cells[c], value, line, sign);
                }
            }
            if (whole) table.values.push_back(value);
        }
        if (!whole)
            refuse_line(
                name, line,
                {"has ", cells.size(), " columns; must be ", table.columns, " as in line ",
                 table.lines[table.first].number, separator == ',' && cells.size() > 1 ? without_points(table) : ""});
        for (std::size_t c = 0; c < table.columns && (separator == ' ' || separator == ','); ++c)
            table.signs[c].add_pair(c > 0 && c < cells.size() ? cells[c - 1] : "", c < cells.size() ? cells[c] : "",
                                    separator, line);
        if (!cells.back().empty()) ++last_cells;
        table.row_lines.push_back(line);
        table.values.resize(table.rows() * table.columns, std::numeric_limits<double>::quiet_NaN());
    }
    if (!may_be_short && last_cells == 0 && shown < table.columns && table.columns > 1) drop_last_column(table);
    refuse_double_comma(table, name);
    refuse_split_thousands(table, name);
}

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
