// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What the readers of delimited text share: bytes, lines, separators, cells, titles with units. All of it is internal.
///
/// Units       as written in the file
/// Valid       lines up to 2^20 characters, files up to 2^30 bytes
/// Accuracy    numbers are correctly rounded

#include <fstiff/core/text.hpp>
#include <fstiff/io/quantity.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::io::detail {

[[noreturn]] inline void refuse_file(const std::string& name, const std::string& reason) {
    throw domain_error(name + ": " + reason);
}
[[noreturn]] inline void refuse_line(const std::string& name, std::size_t line, const std::string& reason) {
    throw domain_error(name + ", line " + std::to_string(line) + ": " + reason);
}

/// What \p call returns; a domain_error of it gets the name of the file.
template <class Call>
auto naming_file(const std::string& name, const Call& call) {
    try {
        return call();
    } catch (const domain_error& error) {
        refuse_file(name, error.what());
    }
}

/// A cell for a message: short, and printable whatever the file holds.
inline std::string shown_cell(std::string_view cell) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (const char c : cell.substr(0, longest)) text += (c >= ' ' && c <= '~') ? c : '?';
    return text + (cell.size() > longest ? "...\"" : "\"");
}

/// A number for a message, whatever the locale.
inline std::string number_text(double value) { return rounded_text(value, 10); }

/// All bytes of \p input, of which there may be 2^30.
inline std::string read_bytes(std::istream& input, const std::string& name) {
    constexpr std::size_t most = std::size_t(1) << 30;
    std::string bytes;
    std::vector<char> chunk(std::size_t(1) << 16);
    while (input.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), input.gcount() > 0) {
        bytes.append(chunk.data(), static_cast<std::size_t>(input.gcount()));
        if (bytes.size() > most) refuse_file(name, "is longer than 2^30 bytes; must be shorter");
    }
    if (input.bad()) throw file_error(name, "cannot be read to its end; must be a readable file");
    return bytes;
}

inline std::string read_bytes(const std::filesystem::path& path, std::string_view what) {
    const std::string name = path.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw file_error(name, "is a folder; must be a file of " + std::string(what));
    std::ifstream input(path, std::ios::binary);
    if (!input) throw file_error(name, "cannot be opened; must be an existing, readable file");
    return read_bytes(input, name);
}

/// \p bytes without a byte order mark, when they may be text; \p what names the text that must be there.
inline std::string text_of(std::string bytes, const std::string& name, std::string_view what) {
    if (bytes.find('\0') != std::string::npos)
        refuse_file(name,
                    "is binary, or UTF-16 (it holds NUL bytes); must be delimited text in UTF-8 or an 8-bit code page");
    if (bytes.empty()) refuse_file(name, "is empty; must be delimited text with " + std::string(what));
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
    return bytes;
}

struct Line {
    std::string_view text;  // trimmed
    std::size_t number;     // counted from 1
};

/// Lines that are not blank. \p count receives the number of all lines.
inline std::vector<Line> lines_of(std::string_view text, const std::string& name, std::size_t& count) {
    constexpr std::size_t longest = std::size_t(1) << 20;
    const char end_of_line = text.find('\n') == std::string_view::npos ? '\r' : '\n';
    std::vector<Line> lines;
    count = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(end_of_line), text.size());
        ++count;
        if (end > longest) refuse_line(name, count, "is longer than 2^20 characters; must be shorter");
        // a tab at the end of a line may be an empty cell: only blanks and carriage returns go
        std::string_view line = text.substr(0, end);
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
        if (!trimmed(line).empty()) lines.push_back({line, count});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

struct Dialect {
    char separator = ' ';  // ' ' stands for any run of blanks and tabs
    bool decimal_comma = false;
};

inline std::string_view unquoted(std::string_view cell) {
    cell = trimmed(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    return cell;
}

inline std::string separator_name(char separator) {
    return separator == ',' ? "comma" : separator == ';' ? "semicolon" : separator == '\t' ? "tab" : "blanks";
}

/// The cells of a line, empty ones included except at its end.
inline void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    if (separator == ' ') {
        for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
            const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
            cells.push_back(unquoted(line.substr(0, end)));
            line.remove_prefix(end);
        }
    } else {
        while (true) {
            const std::size_t end = std::min(line.find(separator), line.size());
            cells.push_back(unquoted(line.substr(0, end)));
            if (end == line.size()) break;
            line.remove_prefix(end + 1);
        }
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
}

/// The number that fills a cell, with the power of ten of its last digit.
struct Cell {
    double value{};
    double last_digit{};
};
/// The number that fills \p cell; none when something else does.
inline std::optional<Cell> number_in(std::string_view cell, bool decimal_comma) {
    char buffer[64];
    if (decimal_comma && cell.find(',') != std::string_view::npos) {
        if (cell.size() > sizeof buffer || cell.find('.') != std::string_view::npos) return std::nullopt;
        std::replace_copy(cell.begin(), cell.end(), buffer, ',', '.');
        cell = {buffer, cell.size()};
    }
    const LeadingNumber number = leading_number(cell);
    if (number.length != cell.size() || number.status == NumberStatus::no_number) return std::nullopt;
    const std::size_t e = std::min(cell.find_first_of("eE"), cell.size());
    const std::size_t point = std::min(cell.find('.'), e);
    double exponent = point < e ? -static_cast<double>(e - point - 1) : 0;
    if (e < cell.size()) {
        const std::string_view written = cell.substr(e + 1);
        exponent += leading_number(written).value;
    }
    // what is too small for a double counts as zero; what is too large is infinite, and refused by the caller
    const bool fits = number.status == NumberStatus::ok;
    const bool tiny = !fits && exponent < 0;
    return Cell{fits ? number.value : tiny ? 0.0 : std::numeric_limits<double>::infinity(), exponent};
}

/// The words that stand for a missing point in a map.
inline bool is_missing_word(std::string_view cell) {
    const std::string word = cell.size() == 3 ? lower_case(cell) : std::string();
    return word == "nan" || word == "bad";
}

/// Whether the cells are numbers, at least one of them; with \p words, also words for missing points.
inline bool all_numbers(const std::vector<std::string_view>& cells, bool decimal_comma, bool words = false) {
    std::size_t numbers = 0;
    for (const std::string_view cell : cells) {
        if (cell.empty()) continue;
        if (!number_in(cell, decimal_comma) && !(words && is_missing_word(cell))) return false;
        ++numbers;
    }
    return numbers > 0;
}

/// How the line reads as a row of numbers (with \p words, also of missing points); none when it does not.
inline std::optional<Dialect> dialect_of(std::string_view line, bool words = false) {
    std::vector<std::string_view> cells;
    std::vector<Dialect> candidates;
    if (line.find(';') != std::string_view::npos)
        candidates = {{';', false}, {';', true}};
    else if (line.find('\t') != std::string_view::npos && line.find(',') == std::string_view::npos)
        candidates = {{'\t', false}, {' ', false}};
    else if (line.find('\t') != std::string_view::npos)
        candidates = {{'\t', true}, {',', false}};
    else if (line.find(',') != std::string_view::npos)
        candidates = {{',', false}, {' ', true}};
    else
        candidates = {{' ', false}};
    // "1,5 2,5": commas inside what blanks separate are decimal; "1, 5" is not
    if (candidates.front().separator == ',' && line.find(' ') != std::string_view::npos) {
        split_line(line, ' ', cells);
        if (cells.size() > 1 && all_numbers(cells, true, words)) return Dialect{' ', true};
    }
    for (const Dialect& dialect : candidates) {
        split_line(line, dialect.separator, cells);
        if (all_numbers(cells, dialect.decimal_comma, words)) return dialect;
    }
    return std::nullopt;
}

inline std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

inline bool is_comment(std::string_view line) {
    line = trimmed(line);
    if (line.starts_with('#') || line.starts_with('%') || line.starts_with('!') || line.starts_with("//")) return true;
    return line.starts_with(';') && !dialect_of(line);
}

/// The length unit that a column title states, as in "x [um]", "x (um)", "x/um", "height in um", "um"; "" for none.
inline std::string_view title_unit(std::string_view title) {
    title = unquoted(title);
    const auto known = [](std::string_view text) { return is_unit(text, Dimension::length); };
    for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}, {'{', '}'}, {'<', '>'}}) {
        const std::size_t end = title.rfind(close);
        const std::size_t begin = title.substr(0, end).rfind(open);
        if (end == std::string_view::npos || begin == std::string_view::npos) continue;
        if (const auto inside = trimmed(title.substr(begin + 1, end - begin - 1)); known(inside)) return inside;
    }
    const std::size_t last = title.find_last_of(" \t/_:=");
    const std::string_view word = last == std::string_view::npos ? title : title.substr(last + 1);
    if (!known(word)) return {};
    if (last == std::string_view::npos) return word;
    const std::string_view before = trimmed(title.substr(0, last));
    // "0.0 um" is a length, no title; a bare "in" after a word is a preposition that lost its unit
    if (before.empty() || is_digit(before.back()) || word == "in") return {};
    return word;
}

/// The units of \p columns columns that \p line states; empty when it does not state them all.
inline std::vector<std::string_view> units_in(std::string_view line, std::size_t columns, char separator) {
    line = trimmed(line);
    while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '!' || line.front() == '/'))
        line.remove_prefix(1);
    std::vector<std::string_view> cells, found;
    for (const char candidate : {separator, ';', '\t', ',', ' '}) {
        split_line(line, candidate, cells);
        if (cells.size() != columns) continue;
        found.clear();
        for (const std::string_view cell : cells)
            if (const auto unit = title_unit(cell); !unit.empty()) found.push_back(unit);
        if (found.size() == columns) return found;
    }
    // "x [um] z [nm]": as many bracketed found as columns, in their order
    found.clear();
    for (std::string_view rest = line; !rest.empty();) {
        const std::size_t begin = rest.find_first_of("[(");
        if (begin == std::string_view::npos) break;
        const std::size_t end = rest.find(rest[begin] == '[' ? ']' : ')', begin);
        if (end == std::string_view::npos) break;
        const auto inside = trimmed(rest.substr(begin + 1, end - begin - 1));
        if (is_unit(inside, Dimension::length)) found.push_back(inside);
        rest.remove_prefix(end + 1);
    }
    return found.size() == columns ? found : std::vector<std::string_view>();
}

/// To how many digits the numbers of a column are printed, trailing zeros dropped or not.
class PrintedDigits {
public:
    void add(const Cell& cell) {
        finest_ = std::min(finest_, cell.last_digit);
        if (cell.value == 0) return;
        const double first_digit = std::floor(std::log10(std::abs(cell.value)));
        largest_ = std::max(largest_, first_digit);
        significant_ = std::max(significant_, first_digit - cell.last_digit + 1);
    }
    /// Weight of the last digit of the largest number: as many decimals, or as many significant digits, as any other.
    [[nodiscard]] double resolution() const { return std::pow(10.0, std::max(finest_, largest_ - significant_ + 1)); }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    double finest_ = infinite, largest_ = -infinite, significant_ = 0;
};

}  // namespace fstiff::io::detail
