// SPDX-License-Identifier: BSD-3-Clause
#include "io/row_layout.hpp"

#include "io/ambiguous_signs.hpp"
#include "io/header.hpp"
#include "io/zygo_xyz.hpp"

#include <map>

namespace fstiff::inline v0_1::io::detail {

namespace {

bool begins_with_number(std::string_view cell) {
    const std::size_t begin = cell.find_first_not_of("+-.,'( ");
    return begin < cell.size() && is_digit(cell[begin]);
}
/// Whether \p cell is a number with a unit of length after a blank.
bool has_unit(std::string_view cell) {
    const std::size_t last = cell.find_last_of(' ');
    return last < cell.size() && is_number(trimmed(cell.substr(0, last))) &&
           is_unit(cell.substr(last + 1), Dimension::length);
}

/// Whether \p cell is a number with its unit next to it, "0.5mm".
bool has_glued_unit(std::string_view cell) {
    const std::size_t end = cell.find_first_not_of("0123456789+-.,eE");
    return end < cell.size() && is_number(cell.substr(0, end)) && is_unit(cell.substr(end), Dimension::length);
}

/// Whether \p cell is a time of the day, "10:00:01,5".
bool is_clock(std::string_view cell) {
    const std::size_t colon = cell.find(':');
    return colon > 0 && colon < 3 && cell.find_first_not_of("0123456789:.,") == cell.npos;
}

/// Whether \p cell begins a line of a Wavefront object: a vertex or a face.
bool is_of_mesh(std::string_view cell) { return cell == "v" || cell == "vn" || cell == "vt" || cell == "f"; }

/// Whether a cell that is no number may be one all the same, of another separator, with a sign between its thousands or
/// with its unit.
bool may_be_number(std::string_view cell) {
    if (is_clock(cell)) return false;
    for (std::size_t i = cell.find_first_of(",;|"); i != cell.npos; i = cell.find_first_of(",;|", i + 1))
        if (begins_with_number(cell.substr(i + 1))) return true;  // "um,-0.2748"
    if (!begins_with_number(cell)) return false;
    const bool word =
        std::any_of(cell.begin(), cell.end(), [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; });
    if (!word) return cell.find(':') == cell.npos && cell.find_first_not_of("0123456789-/.") < cell.size();
    return has_unit(cell);
}
bool is_gap(std::string_view cell) { return cell.empty() || is_missing_word(cell); }

/// Whether \p line holds digits, signs and separators alone, so that it need not be cut into cells.
bool is_plain(std::string_view line) {
    static constexpr auto plain = [] {
        std::array<bool, 256> table{};
        for (const char c : std::string_view("0123456789+-.,;| \t\reEdD\""))
            table[static_cast<unsigned char>(c)] = true;
        return table;
    }();
    return std::all_of(line.begin(), line.end(), [](char c) { return plain[static_cast<unsigned char>(c)]; });
}

/// The word of a result below a table: "Mean", "Ra".
bool is_result_word(std::string_view cell) {
    static constexpr std::array<std::string_view, 32> words{
        "mean",  "average", "avg",     "min",   "max",      "minimum",    "maximum", "std",
        "stdev", "std dev", "sd",      "sum",   "total",    "ra",         "rq",      "rz",
        "rt",    "rsm",     "rms",     "range", "count",    "median",     "p-v",     "pv",
        "mw",    "summe",   "moyenne", "media", "promedio", "mittelwert", "mittel",  "standardabweichung"};
    std::string word = lower_case(cell);
    while (!word.empty() && (word.back() == ':' || word.back() == '.')) word.pop_back();
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Rows with words in some columns, of one separator.
struct WordRows {
    char separator{};
    std::size_t first{}, rows{};
    std::vector<bool> words;
    /// Numbers there is room for: of separators, the one that finds most is the right one.
    std::size_t numbers() const {
        return rows * static_cast<std::size_t>(std::count(words.begin(), words.end(), false));
    }
};

/// The rows of the lines between \p separator; none where more than a tenth of the lines among them are none. Reading
/// refuses these by their word.
std::optional<WordRows> rows_between(const std::vector<Line>& lines, char separator) {
    std::vector<std::string_view> cells;
    std::map<std::size_t, std::size_t> mixed;  // lines with words and numbers, by their cells
    const auto split = [&](const Line& line) { split_row(without_comment(line.text), separator, cells); };
    for (const Line& line : lines) {
        if (is_plain(line.text) || is_comment(line.text)) continue;
        split(line);
        const bool number = std::any_of(cells.begin(), cells.end(), is_number);
        const auto is_word = [](std::string_view cell) { return !is_number(cell) && !is_gap(cell); };
        if (number && std::any_of(cells.begin(), cells.end(), is_word)) ++mixed[cells.size()];
    }
    if (mixed.empty()) return std::nullopt;
    const std::size_t columns = std::max_element(mixed.begin(), mixed.end(), [](const auto& a, const auto& b) {
                                    return a.second < b.second;
                                })->first;
    std::vector<std::size_t> numbers(columns), words(columns);
    for (const Line& line : lines) {
        if (is_comment(line.text)) continue;
        split(line);
        if (cells.size() != columns || std::none_of(cells.begin(), cells.end(), is_number)) continue;
        for (std::size_t c = 0; c < columns; ++c) (is_number(cells[c]) ? numbers : words)[c] += !is_gap(cells[c]);
    }
    WordRows found{.separator = separator, .words = std::vector<bool>(columns)};
    for (std::size_t c = 0; c < columns; ++c) found.words[c] = words[c] > numbers[c];
    std::size_t others = 0, between = 0;  // lines that are none since the last row, and before it
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_comment(lines[i].text)) continue;
        split(lines[i]);
        bool row = cells.size() == columns, number = false;
        for (std::size_t c = 0; row && c < columns; ++c) {
            number = number || is_number(cells[c]);
            row = found.words[c] ? !is_number(cells[c]) : is_number(cells[c]) || is_gap(cells[c]);
            if (found.words[c] && row && (may_be_number(cells[c]) || (c == 0 && is_of_mesh(cells[c]))))
                return std::nullopt;
        }
        if (!row || !number) {
            ++others;
            continue;
        }
        if (found.rows++ == 0)
            found.first = i;
        else
            between += others;
        others = 0;
    }
    const bool lying = found.rows > 0 && columns > 16 && found.words[0];  // "x [um];0;0.5;1 ..."
    if (found.rows < (lying ? 1 : 4) || 10 * between > found.rows) return std::nullopt;
    return found;
}

/// Rows of \p table as they are found without words, and whether a line that is none is among them, or more are below.
std::pair<std::size_t, bool> plain_rows(const NumberTable& table) {
    std::size_t rows = 0, others = 0;
    bool interrupted = false;
    std::vector<std::string_view> cells;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        const std::string_view line = table.lines[i].text;
        if (!is_plain(line)) {
            if (is_comment(line)) continue;
            split_row(without_comment(line), table.dialect.separator, cells);
            if (!is_row_of(table, cells)) {
                ++others;
                continue;
            }
        }
        ++rows;
        interrupted = interrupted || others > 0;
    }
    return {rows, interrupted || others > rows};
}

}  // namespace

bool is_row_of(const NumberTable& table, const std::vector<std::string_view>& cells) {
    bool number = false, gap = false;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (c < table.words.size() && table.words[c]) continue;
        if (is_number(cells[c]))
            number = true;
        else if (!is_gap(cells[c]))
            return false;
        else
            gap = gap || !cells[c].empty();
    }
    const bool ornament = cells.size() == 1 && (cells[0].front() == '-' || cells[0].front() == '*');
    return number || (gap && !ornament);
}

namespace {

/// Refuses a table without rows of numbers whose cells are numbers with their units.
void refuse_units_in_cells(const NumberTable& table, const std::string& name) {
    std::vector<std::string_view> cells;
    for (const Line& line : table.lines)
        for (const char separator : {';', '\t', '|', ','}) {
            split_row(line.text, separator, cells);
            const bool all = std::all_of(cells.begin(), cells.end(),
                                         [](std::string_view cell) { return has_unit(cell) || has_glued_unit(cell); });
            if (cells.size() < 2 || !all) continue;
            refuse_line(
                name, line.number,
                {shown_cell(cells[0]), " has its unit in the cell; must be a number, with the unit above the column"});
        }
}

/// Whether the line above \p rows has a title for each column.
bool has_titles(const std::vector<Line>& lines, const WordRows& rows) {
    if (rows.first == 0) return false;
    std::vector<std::string_view> titles;
    split_titles(without_comment_sign(lines[rows.first - 1].text, rows.separator), rows.separator, titles);
    return titles.size() == rows.words.size();
}

/// Of "P0 4805,3" the comma may separate columns, as in \p rows, or be decimal, where no number has a point: the
/// titles settle it. \throws domain_error where they do not.
WordRows settled_comma(const std::vector<Line>& lines, const WordRows& rows, const std::string& name) {
    std::vector<std::string_view> cells;
    for (std::size_t i = rows.first; i < lines.size(); ++i) {
        split_row(without_comment(lines[i].text), rows.separator, cells);
        const auto has_point = [](std::string_view cell) { return cell.find('.') < cell.size() && is_number(cell); };
        if (std::any_of(cells.begin(), cells.end(), has_point)) return rows;
    }
    auto decimal = rows_between(lines, ' ');
    if (!decimal || decimal->rows < rows.rows) return rows;
    split_row(lines[rows.first].text, ' ', cells);
    if (std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.ends_with(','); })) return rows;
    const bool separates = has_titles(lines, rows), is_decimal = has_titles(lines, *decimal);
    if (separates == is_decimal)
        refuse_line(name, lines[rows.first].number,
                    {shown_cell(lines[rows.first].text),
                     " may have its comma between two columns or in a number; must have a title above each column, "
                     "another separator, or points for its decimal signs"});
    return separates ? rows : *decimal;
}

/// Finds the columns of words, where the lines are no rows of numbers alone, and the first row.
void find_words(NumberTable& table, const std::string& name) {
    const auto [plain, interrupted] = plain_rows(table);
    if (plain > 0 && !interrupted) return;
    std::optional<WordRows> best;
    bool separated = false;  // by a sign that numbers have not
    for (const char separator : {';', '\t', '|', ',', ' '}) {
        const auto lines =
            static_cast<std::size_t>(std::count_if(table.lines.begin(), table.lines.end(), [&](const Line& line) {
                return line.text.find(separator) != std::string_view::npos;
            }));
        if (lines == 0) continue;
        if ((separator == ',' || separator == ' ') && separated) break;  // within cells
        separated = separated || (separator != ',' && 2 * lines > table.lines.size());
        auto rows = rows_between(table.lines, separator);
        if (rows && (!best || rows->numbers() > best->numbers())) best = std::move(rows);
    }
    if (!best || best->rows <= plain) return;
    if (best->separator == ',') best = settled_comma(table.lines, *best, name);
    table.first = best->first;
    table.words = best->words;
    table.dialect = {best->separator, false};
}

/// Moves the lines after the last row to NumberTable::footer.
void drop_footer(NumberTable& table) {
    std::vector<std::string_view> cells, first;
    split_row(without_comment(table.lines[table.first].text), table.dialect.separator, first);
    // a word where the first row has nothing is next to the row
    const auto is_row = [&] {
        if (cells.size() == first.size())
            for (std::size_t c = 0; c < cells.size(); ++c)
                if (first[c].empty() && !is_number(cells[c])) cells[c] = {};
        return is_row_of(table, cells);
    };
    constexpr std::size_t few = 4;  // rows of a table of results below the rows, after a blank line
    std::size_t end = table.lines.size(), below = 0;
    for (std::size_t i = end; i-- > table.first;) {
        const std::string_view line = table.lines[i].text;
        if (is_comment(line)) continue;
        split_row(without_comment(line), table.dialect.separator, cells);
        const bool result = !table.words.empty() && (std::any_of(cells.begin(), cells.end(), is_result_word) ||
                                                     (cells[0].ends_with(':') && !first[0].ends_with(':')));
        if (!result && is_row()) {
            if (++below > few) break;
            continue;
        }
        const auto filled = std::find_if(cells.begin(), cells.end(), [](auto cell) { return !cell.empty(); });
        const bool lone = cells.size() == 1 && first.size() > 1 && !is_number(cells[0]);  // "240 points"
        const bool remark = lone || (line.starts_with('(') && line.ends_with(')'));       // "(240 rows)"
        if (filled == cells.end() || (begins_with_number(*filled) && !remark)) return;
        const bool apart = i > table.first && table.lines[i].number > table.lines[i - 1].number + 1;
        if (below == 0 || apart) end = i, below = 0;
    }
    // comments next to the rows stay
    while (end < table.lines.size() && is_comment(table.lines[end].text)) ++end;
    if (end == table.lines.size() || end <= table.first || table.lines.size() - end > end - table.first) return;
    const auto after = std::span(table.lines).subspan(end);
    const std::vector<HeaderEntry> entries = header_entries(after, table.dialect, true);
    for (const HeaderEntry& entry : entries)
        if (is_height_unit_key(entry.key) || is_size_key(entry.key)) return;
    if (stated_scale(entries).entry) return;
    table.footer.assign(after.begin(), after.end());
    table.lines.resize(end);
}

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

/// The decimal sign of the rows, which the first row alone may hide, as in "0 1,5" and "0;1,5".
void find_decimal_sign(NumberTable& table) {
    if (table.dialect.separator == ',') {
        table.dialect.decimal_comma = table.dialect.decimal_comma || has_quoted_comma(table);
        return;
    }
    std::vector<std::string_view> cells;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (is_comment(table.lines[i].text)) continue;
        split_row(without_comment(table.lines[i].text), table.dialect.separator, cells);
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const std::size_t sign = cells[c].find_first_of(".,");
            if (sign == std::string_view::npos || (c < table.words.size() && table.words[c])) continue;
            table.dialect.decimal_comma = cells[c][sign] == ',';
            return;
        }
    }
}

}  // namespace

NumberTable open_table(std::vector<Line> lines, const std::string& name, const SurfaceOptions& options,
                       std::size_t before) {
    constexpr std::string_view wanted = "; must hold rows of numbers";
    if (lines.empty()) refuse_file(name, {"holds blank lines only", wanted});
    NumberTable table{.lines = std::move(lines), .before = before};
    table.names = options.names;
    table.thousands = options.thousands;
    table.first = row_from(zygo_header(table.lines), table, name);
    skip_count(table, name);
    find_words(table, name);
    if (table.first == table.lines.size()) {
        refuse_units_in_cells(table, name);
        refuse_line(
            name, table.lines.front().number,
            {shown_cell(table.lines.front().text), " is not a row of numbers, nor is any line after it", wanted});
    }
    find_decimal_sign(table);
    table.columns = written_columns(table);
    drop_footer(table);
    return table;
}

NumberTable open_table(std::string_view text, const std::string& name) {
    std::size_t count = 0;
    return open_table(lines_of(text, name, count), name);
}

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

void drop_frame(std::vector<Line>& lines) {
    const auto is_framed = [](const Line& line) {
        return line.text.size() > 2 && line.text.front() == '|' && line.text.back() == '|';
    };
    if (2 * std::count_if(lines.begin(), lines.end(), is_framed) < static_cast<std::ptrdiff_t>(lines.size())) return;
    const auto is_rule = [](std::string_view text) {
        return (text.front() == '|' || text.front() == '+') && text.find_first_not_of("|+-=: ") == text.npos;
    };
    const auto is_row = [&](const Line& line) { return is_framed(line) && is_plain(line.text); };
    // between two rows of numbers, "| --- |" is a missing point
    std::vector<Line> kept, rules;
    for (const Line& line : lines) {
        if (is_rule(line.text)) {
            rules.push_back(line);
            continue;
        }
        const bool missing = !kept.empty() && is_row(kept.back()) && is_row(line);
        for (const Line& rule : rules)
            if (missing && rule.text.front() == '|') kept.push_back(rule);
        rules.clear();
        kept.push_back(line);
    }
    lines = std::move(kept);
    for (Line& line : lines)
        if (is_framed(line)) line.text = trimmed(line.text.substr(1, line.text.size() - 2));
}

std::optional<TurnedRows> turned_rows(const NumberTable& table) {
    constexpr std::size_t least = 16;
    std::vector<std::vector<std::string_view>> rows;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (is_comment(table.lines[i].text)) continue;
        if (rows.size() == 2) return std::nullopt;
        split_line(without_comment(table.lines[i].text), table.dialect.separator, rows.emplace_back());
    }
    if (rows.empty() || rows[0].size() < least || rows.back().size() != rows[0].size()) return std::nullopt;
    const std::size_t begin = !table.words.empty() && table.words[0] ? 1 : 0, count = rows[0].size();
    if (std::count(table.words.begin(), table.words.end(), true) != static_cast<std::ptrdiff_t>(begin)) return {};
    if (rows.size() == 2) {
        std::vector<double> x;
        for (std::size_t c = begin; c < count; ++c)
            x.push_back(number_in(rows[0][c], table.dialect.decimal_comma).value_or(HUGE_VAL));
        const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        for (std::size_t k = 0; k < x.size(); ++k)
            if (!(std::abs(x[k] - x[0] - static_cast<double>(k) * step) <= 0.6 * std::abs(step))) return std::nullopt;
    }
    std::string text;
    std::size_t line = 1;
    for (std::size_t i = 0; i < table.first; ++i) {
        for (; line < table.lines[i].number; ++line) text += '\n';
        text += table.lines[i].text;
    }
    for (std::size_t c = 0; c < count; ++c) {
        text += '\n';
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const std::string quote = rows[r][c].find(table.dialect.separator) < rows[r][c].size() ? "\"" : "";
            text += (r == 0 ? "" : std::string(1, table.dialect.separator)) + quote + std::string(rows[r][c]) + quote;
        }
    }
    return TurnedRows{text + '\n', rows.size()};
}

}  // namespace fstiff::inline v0_1::io::detail
