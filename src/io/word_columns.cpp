// SPDX-License-Identifier: BSD-3-Clause
#include "io/word_columns.hpp"

#include "io/column_titles.hpp"

#include <map>

namespace fstiff::inline v0_1::io::detail {

bool begins_with_number(std::string_view cell) {
    const std::size_t begin = cell.find_first_not_of("+-.,'( ");
    return begin < cell.size() && is_digit(cell[begin]);
}

bool is_plain(std::string_view line) {
    static constexpr auto plain = [] {
        std::array<bool, 256> table{};
        for (const char c : std::string_view("0123456789+-.,;| \t\reEdD\""))
            table[static_cast<unsigned char>(c)] = true;
        return table;
    }();
    return std::all_of(line.begin(), line.end(), [](char c) { return plain[static_cast<unsigned char>(c)]; });
}

namespace {

bool is_gap(std::string_view cell) { return cell.empty() || is_missing_word(cell); }

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

}  // namespace

bool has_points(std::span<const Line> rows, char separator) {
    std::vector<std::string_view> cells;
    return std::any_of(rows.begin(), rows.end(), [&](const Line& line) {
        if (is_comment(line.text)) return false;
        split_row(without_comment(line.text), separator, cells);
        return std::any_of(cells.begin(), cells.end(),
                           [](std::string_view cell) { return cell.find('.') < cell.size() && is_number(cell); });
    });
}

std::vector<bool> words_in(std::span<const Line> lines, char separator, std::size_t columns) {
    std::vector<std::string_view> cells;
    std::vector<std::size_t> numbers(columns), words(columns);
    for (const Line& line : lines) {
        if (is_comment(line.text)) continue;
        split_row(without_comment(line.text), separator, cells);
        if (cells.size() != columns || std::none_of(cells.begin(), cells.end(), is_number)) continue;
        for (std::size_t c = 0; c < columns; ++c) (is_number(cells[c]) ? numbers : words)[c] += !is_gap(cells[c]);
    }
    std::vector<bool> found(columns);
    for (std::size_t c = 0; c < columns; ++c) found[c] = words[c] > numbers[c];
    return found;
}

namespace {

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
    WordRows found{.separator = separator, .words = words_in(lines, separator, columns)};
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
        if (table.holds_words(c)) continue;
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

/// Of "P0 4805,3" the comma may separate columns, as in \p rows, or be decimal, where no number has a point: the
/// titles settle it. \throws domain_error where they do not.
WordRows settled_comma(const std::vector<Line>& lines, const WordRows& rows, const std::string& name) {
    if (has_points(std::span(lines).subspan(rows.first), rows.separator)) return rows;
    auto decimal = rows_between(lines, ' ');
    if (!decimal || decimal->rows < rows.rows) return rows;
    std::vector<std::string_view> cells;
    split_row(lines[rows.first].text, ' ', cells);
    if (std::any_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.ends_with(','); })) return rows;
    const auto titled = [&](const WordRows& one) {
        return has_titles(lines, one.first, one.separator, one.words.size());
    };
    const bool separates = titled(rows), is_decimal = titled(*decimal);
    if (separates == is_decimal)
        refuse_line(name, lines[rows.first].number,
                    {shown_cell(lines[rows.first].text),
                     " may have its comma between two columns or in a number; must have a title above each column, "
                     "another separator, or points for its decimal signs"});
    return separates ? rows : *decimal;
}

}  // namespace

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

}  // namespace fstiff::inline v0_1::io::detail
