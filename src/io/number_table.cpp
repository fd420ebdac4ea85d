// SPDX-License-Identifier: BSD-3-Clause
#include "io/number_table.hpp"

#include "io/ambiguous_signs.hpp"
#include "io/row_layout.hpp"
#include "io/zygo_xyz.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

std::string_view unquoted(std::string_view cell) {
    cell = trimmed(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    return cell;
}

void split_row(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    if (separator == ' ') {
        for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
            auto end = static_cast<std::size_t>(std::find_if(line.begin(), line.end(), is_blank) - line.begin());
            if ((line[0] == 'N' || line[0] == 'n') && lower_case(line.substr(0, 7)) == "no data") end = 7;  // one cell
            cells.push_back(unquoted(line.substr(0, end)));
            line.remove_prefix(end);
        }
        return;
    }
    while (true) {
        const std::size_t first = line.find_first_not_of(' ');
        const std::size_t quote =
            first != std::string_view::npos && line[first] == '"' ? line.find('"', first + 1) : std::string_view::npos;
        const std::size_t end =
            (std::min)(line.find(separator, quote == std::string_view::npos ? 0 : quote), line.size());
        cells.push_back(unquoted(line.substr(0, end)));
        if (end == line.size()) return;
        line.remove_prefix(end + 1);
    }
}

void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    split_row(line, separator, cells);
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
}

namespace {

/// Whether the cells are numbers, each with one decimal sign or the other, or words for missing points; words alone
/// need to be several, or letters, since a line of asterisks or dashes may be an ornament.
bool all_numbers(const std::vector<std::string_view>& cells, bool decimal_comma) {
    std::size_t numbers = 0, words = 0, ornaments = 0;
    for (const std::string_view cell : cells) {
        if (cell.empty()) continue;
        if (number_in(cell, decimal_comma) || number_in(cell, false)) {
            ++numbers;
            continue;
        }
        if (!is_missing_word(cell)) return false;
        ++words;
        ornaments += cell.front() == '-' || cell.front() == '\xE2' || (cell.front() == '*' && cells.size() == 1);
    }
    return numbers > 0 || (words > 0 && ornaments == 0);
}

/// How the line reads as a row of numbers and missing points; none when it does not.
std::optional<Dialect> dialect_of(std::string_view line) {
    std::vector<std::string_view> cells;
    std::vector<Dialect> candidates;
    if (line.find(';') != std::string_view::npos)
        candidates = {{';', false}, {';', true}};
    else if (line.find('|') != std::string_view::npos)
        candidates = {{'|', false}, {'|', true}};
    else if (line.find('\t') != std::string_view::npos && line.find(',') == std::string_view::npos)
        candidates = {{'\t', false}, {' ', false}};
    else if (line.find('\t') != std::string_view::npos)
        candidates = {{'\t', true}, {',', false}};
    else if (line.find(',') != std::string_view::npos && line.find('"') != std::string_view::npos)
        candidates = {{',', false}, {',', true}, {' ', true}};  // "0,5","1,25"
    else if (line.find(',') != std::string_view::npos)
        candidates = {{',', false}, {' ', true}};
    else
        candidates = {{' ', false}};
    // "1,5 2,5": commas inside what blanks separate are decimal; "1, 5" is not
    if (candidates.front().separator == ',' && line.find(' ') != std::string_view::npos) {
        split_line(line, ' ', cells);
        const bool listed = std::any_of(cells.begin(), cells.end(), [](auto cell) { return cell.ends_with(','); });
        if (cells.size() > 1 && !listed && all_numbers(cells, true)) return Dialect{' ', true};
    }
    for (const Dialect& dialect : candidates) {
        split_line(line, dialect.separator, cells);
        if (all_numbers(cells, dialect.decimal_comma)) return dialect;
    }
    return std::nullopt;
}

}  // namespace

std::string_view without_comment(std::string_view line) {
    for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1)) {
        const bool glued = i > 0 && std::string_view(" \t,;").find(line[i - 1]) == std::string_view::npos;
        const std::string_view word = line.substr(i, (std::min)(line.find_first_of(" \t,;\"", i), line.size()) - i);
        if (!glued && !is_missing_word(word)) return line.substr(0, i);
    }
    return line;
}

bool is_comment(std::string_view line) {
    line = trimmed(line);
    if (line.starts_with('#') && without_comment(line).empty()) return true;
    if (line.starts_with('%') || line.starts_with('!') || line.starts_with("//")) return true;
    return line.starts_with(';') && !dialect_of(line);
}

namespace {

/// Whether a row between commas has a number with a decimal comma, in quotes.
bool has_quoted_comma(const NumberTable& table) {
    std::vector<std::string_view> cells;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (table.lines[i].text.find('"') == std::string_view::npos) continue;
        split_line(table.lines[i].text, ',', cells);
        for (const std::string_view cell : cells)
            if (number_in(cell, true) && !number_in(cell, false)) return true;
    }
    return false;
}

/// Whether column \p c has words but no number from the first row on.
bool is_text_column(const NumberTable& table, std::size_t c) {
    std::vector<std::string_view> cells;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        split_line(without_comment(table.lines[i].text), table.dialect.separator, cells);
        if (c < cells.size() && (number_in(cells[c], true) || number_in(cells[c], false))) return false;
    }
    return true;
}

/// Rows directly above the first one that have words only where the rows have nothing, as next to the results of an
/// instrument, are rows.
void take_rows_above(NumberTable& table) {
    const char separator = table.dialect.separator;
    if (separator == ' ') return;
    std::vector<std::string_view> cells, row;
    split_line(without_comment(table.lines[table.first].text), separator, row);
    while (table.first > 0) {
        const std::string_view line = table.lines[table.first - 1].text;
        split_line(line, separator, cells);
        if (is_comment(line) || cells.size() != row.size()) return;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const bool number = number_in(cells[c], table.dialect.decimal_comma).has_value();
            if (number != !row[c].empty() || (!number && !is_text_column(table, c))) return;
        }
        --table.first;
    }
}

}  // namespace

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

/// The first line from \p begin on that is a row of numbers, with its dialect; the end where there is none.
std::size_t row_from(std::size_t begin, NumberTable& table, const std::string& name) {
    for (std::size_t i = begin; i < table.lines.size(); ++i) {
        const std::string_view line = table.lines[i].text;
        if (is_comment(line)) continue;
        if (const auto dialect = dialect_of(without_comment(line))) {
            refuse_blank_groups(table, name, table.lines[i], *dialect);
            table.dialect = *dialect;
            return i;
        }
        refuse_grouped_row(table, name, table.lines[i]);
    }
    return table.lines.size();
}

/// Takes for a header the rows up to one that holds nothing but the number of those after it, 16 or more, as Mitutoyo
/// and others write it below the length of a profile.
void skip_count(NumberTable& table, const std::string& name) {
    constexpr std::size_t least = 16, highest = 8;
    const std::size_t begin = table.first, end = (std::min)(begin + highest, table.lines.size());
    for (std::size_t i = begin; i < end; ++i) {
        const auto count = number_in(trimmed(table.lines[i].text), false);
        const auto most = static_cast<double>(table.lines.size() - i - 1);
        if (!count || *count < least || *count > most || 2 * *count < most) continue;
        const auto rows = std::count_if(table.lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, table.lines.end(),
                                        [](const Line& line) { return !is_comment(line.text); });
        if (static_cast<double>(rows) != *count) continue;
        table.counted = i + 1;
        table.first = row_from(i + 1, table, name);
        return;
    }
}

void find_first_row(NumberTable& table, const std::string& name, const TableRules& rules) {
    const std::string wanted = "; must hold " + std::string(rules.holds);
    if (table.lines.empty()) refuse_file(name, {"holds blank lines only", wanted});
    table.first = row_from(zygo_header(table.lines), table, name);
    skip_count(table, name);
    find_words(table);
    if (table.first == table.lines.size()) refuse_units_in_cells(table, name);
    if (table.first == table.lines.size())
        refuse_line(
            name, table.lines.front().number,
            {shown_cell(table.lines.front().text), " is not a row of numbers, nor is any line after it", wanted});
    // the first row alone may hide the decimal commas of "0 1,5" or "0;1,5"
    const bool settled = table.dialect.separator == ',' || !table.words.empty();
    for (std::size_t i = table.first; i < table.lines.size() && !settled; ++i) {
        if (is_comment(table.lines[i].text)) continue;
        const std::size_t sign = without_comment(table.lines[i].text).find_first_of(".,");
        if (sign == std::string_view::npos) continue;
        table.dialect.decimal_comma = table.lines[i].text[sign] == ',';
        break;
    }
    if (table.dialect.separator == ',' && !table.dialect.decimal_comma)
        table.dialect.decimal_comma = has_quoted_comma(table);
    std::vector<std::string_view> cells;
    split_line(without_comment(table.lines[table.first].text), table.dialect.separator, cells);
    table.columns = cells.size();
    if (rules.short_rows) take_rows_above(table);
    drop_footer(table);
}

}  // namespace

NumberTable open_table(std::vector<Line> lines, const std::string& name, const TableRules& rules,
                       const SurfaceOptions& options, std::size_t before) {
    NumberTable table;
    table.names = options.names;
    table.thousands = options.thousands;
    table.lines = std::move(lines);
    table.before = before;
    find_first_row(table, name, rules);
    return table;
}

NumberTable open_table(std::string_view text, const std::string& name, const TableRules& rules) {
    std::size_t count = 0;
    return open_table(lines_of(text, name, count), name, rules);
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

void read_rows(NumberTable& table, const std::string& name, const TableRules& rules) {
    const char separator = table.dialect.separator;
    const auto split = rules.short_rows ? split_line : split_row;
    std::vector<std::string_view> cells;
    split(without_comment(table.lines[table.first].text), separator, cells);
    const std::size_t shown = table.columns;
    table.columns = rules.short_rows ? widest_row(table) : cells.size();
    if (rules.short_rows && table.columns > max_short_row_columns)
        refuse_line(name, table.lines[table.first].number,
                    {"has ", table.columns, " columns; must be at most ", max_short_row_columns});
    table.wholes.resize(table.columns);
    table.printed.resize(rules.short_rows ? table.columns : std::min<std::size_t>(table.columns, 16));
    const std::string_view last = table.lines.back().text;
    const auto bytes = static_cast<std::size_t>(last.data() + last.size() - table.lines[table.first].text.data());
    const std::size_t most_rows = table.lines.size() - table.first;
    table.values.reserve(
        (std::min)(most_rows * table.columns, bytes + most_rows));  // a cell, or its separator, is a byte
    std::size_t last_cells = 0;                                     // rows with something in their last cell
    std::vector<char> text(table.columns, '?');                     // whether a column is one; '?' until it is sought
    const auto holds_words = [&](std::size_t c) {
        if (c < table.words.size() && table.words[c]) return true;
        if (!rules.short_rows || separator == ' ' || c >= text.size()) return false;
        if (text[c] == '?') text[c] = is_text_column(table, c) ? 'y' : 'n';
        return text[c] == 'y';
    };
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (i != table.first && is_comment(table.lines[i].text)) continue;
        const std::size_t line = table.lines[i].number;
        split(without_comment(table.lines[i].text), separator, cells);
        if (cells.empty()) continue;
        // with blanks between them, an empty cell cannot be seen
        const bool padded = rules.short_rows && separator != ' ' && cells.size() < table.columns;
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
                }
            }
            if (whole) table.values.push_back(value);
        }
        if (!whole)
            refuse_line(
                name, line,
                {"has ", cells.size(), " columns; must be ", table.columns, " as in line ",
                 table.lines[table.first].number, separator == ',' && cells.size() > 1 ? without_points(table) : ""});
        if (!cells.back().empty()) ++last_cells;
        table.row_lines.push_back(line);
        table.values.resize(table.rows() * table.columns, std::numeric_limits<double>::quiet_NaN());
    }
    refuse_double_comma(table, name);
    refuse_split_thousands(table, name);
    if (!rules.short_rows && last_cells == 0 && shown < table.columns && table.columns > 1) drop_last_column(table);
}

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
