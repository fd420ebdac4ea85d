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

/// Reads the rows of a table, with what their cells show of digits and signs.
class RowReader {
public:
    RowReader(NumberTable& table, const std::string& name, RowEnds ends)
        : table_(table), name_(name), may_be_short_(ends == RowEnds::may_be_short) {}

    void read() {
        const Line& first = table_.lines[table_.first];
        split(first);
        const std::size_t shown = table_.columns;
        table_.columns = may_be_short_ ? widest_row(table_) : cells_.size();
        if (may_be_short_ && table_.columns > max_short_row_columns)
            refuse_line(name_, first.number,
                        {"has ", table_.columns, " columns; must be at most ", max_short_row_columns});
        prepare(first);
        for (std::size_t i = table_.first; i < table_.lines.size(); ++i)
            if (i == table_.first || !is_comment(table_.lines[i].text)) read(table_.lines[i]);
        if (!may_be_short_ && last_cells_ == 0 && shown < table_.columns && table_.columns > 1) drop_last_column();
        refuse_double_comma(table_, name_);
        refuse_split_thousands(table_, name_);
    }

private:
    void split(const Line& line) {
        (may_be_short_ ? split_line : split_row)(without_comment(line.text), table_.dialect.separator, cells_);
    }

    void prepare(const Line& first) {
        table_.wholes.resize(table_.columns);
        table_.signs.resize(table_.columns);
        table_.printed.resize(may_be_short_ ? table_.columns : std::min<std::size_t>(table_.columns, 16));
        text_.assign(table_.columns, '?');
        const std::string_view last = table_.lines.back().text;
        const auto bytes = static_cast<std::size_t>(last.data() + last.size() - first.text.data());
        const std::size_t rows = table_.lines.size() - table_.first;
        table_.values.reserve((std::min)(rows * table_.columns, bytes + rows));  // a cell, or its separator, is a byte
    }

    void read(const Line& line) {
        const char separator = table_.dialect.separator;
        split(line);
        if (cells_.empty()) return;
        // with blanks between them, an empty cell cannot be seen
        const bool padded = may_be_short_ && separator != ' ' && cells_.size() < table_.columns;
        const bool whole = padded || cells_.size() == table_.columns;
        for (std::size_t c = 0; c < cells_.size(); ++c)
            if (const double value = number(c, line.number, whole); whole) table_.values.push_back(value);
        if (!whole)
            refuse_line(name_, line.number,
                        {"has ", cells_.size(), " columns; must be ", table_.columns, " as in line ",
                         table_.lines[table_.first].number,
                         separator == ',' && cells_.size() > 1 ? without_points(table_) : ""});
        if (!cells_.back().empty()) ++last_cells_;
        cells_.resize(table_.columns);
        for (std::size_t c = 0; c < table_.columns && (separator == ' ' || separator == ','); ++c)
            table_.signs[c].add_pair(c > 0 ? cells_[c - 1] : "", cells_[c], separator, line.number);
        table_.row_lines.push_back(line.number);
        table_.values.resize(table_.rows() * table_.columns, std::numeric_limits<double>::quiet_NaN());
    }

    /// The number in column \p c; NaN where it is missing. A row that is not \p whole is refused and shows nothing.
    double number(std::size_t c, std::size_t line, bool whole) {
        const std::string_view cell = cells_[c];
        const auto number = number_in(cell, table_.dialect.decimal_comma);
        if (!number && (cell.empty() || is_missing_word(cell) || table_.missing.has_word(cell) || holds_words(c)))
            return std::numeric_limits<double>::quiet_NaN();
        const double value = require_number(number, cell, table_, line, name_);
        if (!whole || table_.missing.has(value)) return value;
        table_.wholes[c].add(cell, value);
        if (c < table_.printed.size()) table_.printed[c].add(cell, value);
        if (table_.thousands.empty()) table_.signs[c].add(cell, value, line, table_.dialect.decimal_comma ? "," : ".");
        return value;
    }

    /// Whether column \p c holds words, or has some next to rows that have nothing there.
    bool holds_words(std::size_t c) {
        if (table_.holds_words(c)) return true;
        if (!may_be_short_ || table_.dialect.separator == ' ' || c >= text_.size()) return false;
        if (text_[c] == '?') text_[c] = is_text_column(table_, c) ? 'y' : 'n';
        return text_[c] == 'y';
    }

    /// A separator at the end of every line makes no column.
    void drop_last_column() {
        const std::size_t old = table_.columns--;
        for (std::size_t r = 1; r < table_.rows(); ++r)
            std::copy_n(table_.values.data() + r * old, table_.columns, table_.values.data() + r * table_.columns);
        table_.values.resize(table_.rows() * table_.columns);
    }

    NumberTable& table_;
    const std::string& name_;
    const bool may_be_short_;
    std::vector<std::string_view> cells_{};
    std::size_t last_cells_ = 0;  // rows with something in their last cell
    std::vector<char> text_{};    // whether a column is one; '?' until it is sought
};

}  // namespace

void read_rows(NumberTable& table, const std::string& name, RowEnds ends) { RowReader(table, name, ends).read(); }

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
