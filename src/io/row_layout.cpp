// SPDX-License-Identifier: BSD-3-Clause
#include "io/row_layout.hpp"

#include "io/ambiguous_signs.hpp"
#include "io/header.hpp"
#include "io/word_columns.hpp"
#include "io/zygo_xyz.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

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
            if (sign == std::string_view::npos || table.holds_words(c)) continue;
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
        const std::string_view line = table.lines.front().text;
        refuse_line(name, table.lines.front().number,
                    {shown_cell(line), " is not a row of numbers, nor is any line after it", wanted,
                     line.ends_with('[') ? ", without the brackets and semicolons of a program" : ""});
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

NumberTable titled_rows(std::vector<Line> lines, std::size_t first, char separator) {
    NumberTable table{.lines = std::move(lines), .first = first, .dialect = {.separator = separator}};
    while (table.first < table.lines.size() && is_comment(table.lines[table.first].text)) ++table.first;
    if (table.first == table.lines.size()) return table;
    std::vector<std::string_view> cells;
    split_row(without_comment(table.lines[table.first].text), separator, cells);
    table.words = words_in(std::span(table.lines).subspan(table.first), separator, cells.size());
    if (std::count(table.words.begin(), table.words.end(), true) == 0) table.words.clear();
    find_decimal_sign(table);
    table.columns = written_columns(table);
    drop_footer(table);
    return table;
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

}  // namespace fstiff::inline v0_1::io::detail
