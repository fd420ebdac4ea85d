// SPDX-License-Identifier: BSD-3-Clause
#include "io/cells.hpp"

#include <algorithm>

namespace fstiff::inline v0_1::io::detail {

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

}  // namespace

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

std::string_view without_comment(std::string_view line) {
    for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1)) {
        const bool glued = i > 0 && std::string_view(" \t,;|").find(line[i - 1]) == std::string_view::npos;
        const std::string_view word = line.substr(i, (std::min)(line.find_first_of(" \t,;|\"", i), line.size()) - i);
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

}  // namespace fstiff::inline v0_1::io::detail
