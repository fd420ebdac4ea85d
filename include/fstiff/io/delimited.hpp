// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a profile from delimited text, and records every decision it took about the file.
///
/// Rows are separated by line ends (LF, CR LF, CR CR LF, CR), columns by comma, semicolon, tab or blanks. The decimal
/// sign is the point, or the comma where the comma does not separate columns. One column holds heights; two hold
/// positions and heights; more need DelimitedOptions::column. Lines before the first row of numbers are the header,
/// lines that begin with "#", "%", "!", "//" or ";" comments; both are searched for units, from the first row upwards:
/// "x [um]; z [nm]", "Lateral um,Raw Micrometer", "x (µm)", or the bare units. An empty cell is a missing point.
/// Positions may fall (the profile is turned round) but must be equally spaced, as far as the digits they are printed
/// with can tell; where all steps but one or two are the same, a row is missing.
///
/// Nothing is guessed: without a unit, without a spacing, or with a cell that is no number, the file is refused.
///
/// Units       profile in m; DelimitedOptions::units are the file's
/// Valid       16 points at least, of heights that vary; lines up to 2^20 characters, files up to 2^30
/// Accuracy    heights within 1 ulp of the printed number (tests/io/delimited_test.cpp)

#include <fstiff/io/quantity.hpp>
#include <fstiff/profile/profile.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <istream>
#include <limits>
#include <optional>
#include <vector>

namespace fstiff::io {

struct DelimitedOptions {
    std::optional<double> spacing{};  ///< [m]; replaces the positions of the file
    std::string units{};              ///< "um,nm" (positions, heights) or "um" (both); replaces those of the header
    std::size_t column = 0;           ///< of the heights, counted from 1; 0: the last of one or two columns
};

/// What was decided about a file, and why.
struct DelimitedRecord {
    std::string name;
    std::string separator;  ///< "comma", "semicolon", "tab", "blanks" or "none" (one column)
    bool decimal_comma{};
    std::size_t lines{};
    std::size_t header_lines{};     ///< before the first row of numbers, blank lines and comments included
    std::size_t columns{};          ///< that hold something
    std::size_t height_column{};    ///< counted from 1
    std::size_t position_column{};  ///< counted from 1; 0: none used
    std::string position_unit;      ///< as written; empty when no positions are used
    std::string height_unit;        ///< as written
    std::string units_from;         ///< "line 28" or "options"
    std::string spacing_from;       ///< where the spacing comes from
    bool reversed{};                ///< positions fell: the heights were turned round
    std::size_t points{};
    std::size_t missing{};

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

struct DelimitedProfile {
    Profile<double> profile;
    DelimitedRecord record;
};

/// Reads all of \p input; \p name stands for it in messages.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] inline DelimitedProfile read_profile(std::istream& input, std::string_view name,
                                                   const DelimitedOptions& options = {});

/// Reads the file \p path.
/// \throws domain_error also when it cannot be opened.
[[nodiscard]] inline DelimitedProfile read_profile(const std::filesystem::path& path,
                                                   const DelimitedOptions& options = {});

namespace detail {

[[noreturn]] inline void refuse_file(const std::string& name, const std::string& reason) {
    throw domain_error(name + ": " + reason);
}
[[noreturn]] inline void refuse_line(const std::string& name, std::size_t line, const std::string& reason) {
    throw domain_error(name + ", line " + std::to_string(line) + ": " + reason);
}

/// A cell for a message: short, and printable whatever the file holds.
inline std::string shown_cell(std::string_view cell) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (const char c : cell.substr(0, longest)) text += (c >= ' ' && c <= '~') ? c : '?';
    return text + (cell.size() > longest ? "...\"" : "\"");
}

/// A number for a message, whatever the locale.
inline std::string number_text(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 10).ptr};
}

inline std::string read_all(std::istream& input, const std::string& name) {
    constexpr std::size_t most = std::size_t(1) << 30;
    std::string text;
    std::vector<char> chunk(std::size_t(1) << 16);
    while (input.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), input.gcount() > 0) {
        const std::string_view part(chunk.data(), static_cast<std::size_t>(input.gcount()));
        if (part.find('\0') != std::string_view::npos)
            refuse_file(
                name,
                "is binary, or UTF-16 (it holds NUL bytes); must be delimited text in UTF-8 or an 8-bit code page");
        text += part;
        if (text.size() > most) refuse_file(name, "is longer than 2^30 bytes; must be shorter");
    }
    if (input.bad()) refuse_file(name, "cannot be read to its end; must be a readable file");
    if (text.empty()) refuse_file(name, "is empty; must be delimited text with one or two columns of numbers");
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // byte order mark
    return text;
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

inline bool all_numbers(const std::vector<std::string_view>& cells, bool decimal_comma) {
    std::size_t numbers = 0;
    for (const std::string_view cell : cells) {
        if (cell.empty()) continue;
        if (!number_in(cell, decimal_comma)) return false;
        ++numbers;
    }
    return numbers > 0;
}

/// How the line reads as a row of numbers; none when it does not.
inline std::optional<Dialect> dialect_of(std::string_view line) {
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
        if (cells.size() > 1 && all_numbers(cells, true)) return Dialect{' ', true};
    }
    for (const Dialect& dialect : candidates) {
        split_line(line, dialect.separator, cells);
        if (all_numbers(cells, dialect.decimal_comma)) return dialect;
    }
    return std::nullopt;
}

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

/// A spacing that the header states, such as "Resolution,0.156 um/sample"; with the weight of its last digit [m].
struct StatedSpacing {
    double value{}, resolution{};
    std::size_t line{};
    std::string text;
};
inline std::optional<StatedSpacing> stated_spacing(const std::vector<Line>& lines, std::size_t header) {
    for (std::size_t i = 0; i < header; ++i) {
        const std::string_view line = lines[i].text;
        const std::size_t begin = line.find_first_of(",:=;\t");
        if (begin == std::string_view::npos) continue;
        std::string title = lower_case(trimmed(line.substr(0, begin)));
        while (!title.empty() && (is_blank(title.front()) || title.front() == '#' || title.front() == '%'))
            title.erase(0, 1);
        if (title != "resolution" && title != "spacing" && title != "step" && title != "sampling interval") continue;
        std::string_view text = trimmed(line.substr(begin + 1));
        text = trimmed(text.substr(0, text.find_first_of(",;\t")));
        const std::size_t per = text.find('/');
        const LeadingNumber number = leading_number(text);
        if (number.status != NumberStatus::ok || !(number.value > 0)) continue;
        const std::string_view unit =
            trimmed(text.substr(number.length, per == std::string_view::npos ? per : per - number.length));
        if (per != std::string_view::npos && per < number.length) continue;
        if (!is_unit(unit, Dimension::length)) continue;
        const double factor = unit_factor(unit, Dimension::length);
        return StatedSpacing{number.value * factor,
                             std::pow(10.0, number_in(text.substr(0, number.length), false)->last_digit) * factor,
                             lines[i].number, std::string(text)};
    }
    return std::nullopt;
}

/// Everything that reading one file needs to pass between its steps.
class DelimitedReader {
public:
    DelimitedReader(std::string text, std::string name, const DelimitedOptions& options)
        : text_(std::move(text)), name_(std::move(name)), options_(options) {}

    DelimitedProfile read() {
        record_.name = name_;
        lines_ = lines_of(text_, name_, record_.lines);
        if (lines_.empty()) refuse_file(name_, "holds blank lines only; must hold one or two columns of numbers");
        find_first_row();
        read_rows();
        choose_columns();
        choose_units();
        DelimitedProfile result;
        result.profile.heights = heights();
        result.profile.spacing = spacing();
        if (record_.reversed) std::reverse(result.profile.heights.begin(), result.profile.heights.end());
        record_.points = result.profile.size();
        record_.missing = record_.points - result.profile.present();
        check(result.profile);
        result.record = record_;
        return result;
    }

private:
    static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

    void find_first_row() {
        for (first_ = 0; first_ < lines_.size(); ++first_) {
            if (is_comment(lines_[first_].text)) continue;
            if (const auto dialect = dialect_of(without_comment(lines_[first_].text))) {
                dialect_ = *dialect;
                record_.header_lines = lines_[first_].number - 1;
                settle_lone_commas();
                record_.decimal_comma = dialect_.decimal_comma;
                return;
            }
        }
        refuse_line(name_, lines_.front().number,
                    shown_cell(lines_.front().text) +
                        " is no row of numbers, nor is any line after it; must hold one or two columns of numbers");
    }

    static std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

    /// In "0,12" the comma may separate two columns or be decimal. It separates, unless no row holds a point and the
    /// columns that it would separate could not be equally spaced positions and heights.
    void settle_lone_commas() {
        // the first row alone may hide the decimal commas of "0 1,5" or "0;1,5"
        if (dialect_.separator != ',') {
            for (std::size_t i = first_; i < lines_.size() && !dialect_.decimal_comma; ++i) {
                const std::string_view line = without_comment(lines_[i].text);
                if (is_comment(lines_[i].text)) continue;
                if (line.find('.') != std::string_view::npos) return;
                dialect_.decimal_comma = line.find(',') != std::string_view::npos;
            }
            return;
        }
        // titles that the comma separates, each with its unit, settle it
        if (first_ > 0 && !units_in(lines_[first_ - 1].text, 2, ',').empty()) return;
        std::optional<double> before, step;
        bool positions = true;
        for (std::size_t i = first_; i < lines_.size(); ++i) {
            if (is_comment(lines_[i].text)) continue;
            const std::string_view line = without_comment(lines_[i].text);
            if (line.find_first_of(".eE \t") != std::string_view::npos ||
                std::count(line.begin(), line.end(), ',') != 1)
                return;
            const LeadingNumber number = leading_number(line);
            if (number.status != NumberStatus::ok || line[number.length] != ',' || number.length + 1 == line.size() ||
                !is_digit(line[number.length + 1]))
                return;
            if (before) {
                const double next = number.value - *before;
                positions = positions && next != 0 && (!step || next == *step);
                step = next;
            }
            before = number.value;
        }
        if (!positions) dialect_ = {' ', true};
    }

    void read_rows() {
        std::vector<std::string_view> cells;
        for (std::size_t i = first_; i < lines_.size(); ++i) {
            if (i != first_ && is_comment(lines_[i].text)) continue;
            const std::size_t line = lines_[i].number;
            split_line(without_comment(lines_[i].text), dialect_.separator, cells);
            if (cells.empty()) continue;
            if (row_lines_.empty()) {
                if (cells.size() > 4096)
                    refuse_line(name_, line, "has " + std::to_string(cells.size()) + " columns; must be at most 4096");
                record_.columns = cells.size();
                values_.resize(cells.size());
                printed_.resize(cells.size());
            }
            // with blanks between them, an empty cell cannot be seen
            const bool short_row =
                cells.size() < record_.columns && (dialect_.separator == ' ' || record_.columns == 1);
            if (cells.size() > record_.columns || short_row) {
                for (const std::string_view cell : cells)
                    if (!cell.empty()) require_number(cell, line);
                refuse_line(name_, line,
                            "has " + std::to_string(cells.size()) + " columns; must be " +
                                std::to_string(record_.columns) + " as in line " + std::to_string(row_lines_.front()));
            }
            for (std::size_t c = 0; c < record_.columns; ++c) {
                if (c >= cells.size() || cells[c].empty()) {
                    values_[c].push_back(missing);
                    continue;
                }
                const Cell number = require_number(cells[c], line);
                values_[c].push_back(number.value);
                printed_[c].add(number);
            }
            row_lines_.push_back(line);
        }
        record_.separator = record_.columns == 1 && dialect_.separator == ' ' ? "none"
                            : dialect_.separator == ','                       ? "comma"
                            : dialect_.separator == ';'                       ? "semicolon"
                            : dialect_.separator == '\t'                      ? "tab"
                                                                              : "blanks";
    }

    Cell require_number(std::string_view cell, std::size_t line) const {
        const auto number = number_in(cell, dialect_.decimal_comma);
        if (!number)
            refuse_line(name_, line,
                        shown_cell(cell) +
                            " is no number; allowed are finite decimal numbers (an empty cell is a missing point)");
        if (!std::isfinite(number->value))
            refuse_line(name_, line,
                        shown_cell(cell) + " is beyond the range of double precision; allowed are finite numbers");
        return *number;
    }

    void choose_columns() {
        const std::size_t columns = record_.columns;
        if (options_.column > columns)
            refuse_file(name_, "column = " + std::to_string(options_.column) + ": must be between 1 and " +
                                   std::to_string(columns));
        if (options_.column == 0 && columns > 2)
            refuse_file(name_, "has " + std::to_string(columns) +
                                   " columns; must be one of heights or two of positions and heights, or say which "
                                   "column holds the heights");
        record_.height_column = options_.column != 0 ? options_.column : columns;
        const bool has_positions = columns > 1 && record_.height_column != 1;
        record_.position_column = has_positions && !options_.spacing ? 1 : 0;
    }

    void choose_units() {
        const std::size_t position = record_.position_column;
        if (!options_.units.empty()) {
            std::vector<std::string_view> given;
            split_line(options_.units, ',', given);
            if (given.empty() || given.size() > 2)
                refuse_file(name_, "units = " + shown_cell(options_.units) +
                                       ": must be one unit, or two such as \"um,nm\" (positions, heights)");
            for (const std::string_view unit : given) require_unit(unit, Dimension::length);
            record_.height_unit = given.back();
            if (position != 0) record_.position_unit = given.front();
            record_.units_from = "options";
            return;
        }
        for (std::size_t i = first_; i-- > 0;) {
            const auto found = units_in(lines_[i].text, record_.columns, dialect_.separator);
            if (found.empty()) continue;
            record_.height_unit = found[record_.height_column - 1];
            if (position != 0) record_.position_unit = found[position - 1];
            record_.units_from = "line " + std::to_string(lines_[i].number);
            return;
        }
        refuse_file(
            name_,
            "states no unit and none is given; must be given such as \"um,nm\" (positions, heights), each one of " +
                accepted_units(Dimension::length));
    }

    std::vector<double> heights() const {
        const double unit = unit_factor(record_.height_unit, Dimension::length);
        std::vector<double> result(values_[record_.height_column - 1]);
        for (double& z : result) z *= unit;
        return result;
    }

    double spacing() {
        const auto stated = stated_spacing(lines_, first_);
        if (options_.spacing) {
            require_positive("spacing", *options_.spacing);
            record_.spacing_from = "options";
            return *options_.spacing;
        }
        if (record_.position_column == 0) {
            if (!stated)
                refuse_file(name_,
                            "has no column of positions and no spacing is given; must be given such as \"0.5 um\"");
            record_.spacing_from = "line " + std::to_string(stated->line) + " (" + stated->text + ")";
            return stated->value;
        }
        const double unit = unit_factor(record_.position_unit, Dimension::length);
        const double step = mean_step() * unit;
        record_.spacing_from = "mean step of the positions";
        if (stated) {
            const bool agrees =
                std::abs(step - stated->value) <= 0.6 * stated->resolution;  // rounded to its last digit
            if (!agrees)
                refuse_line(name_, stated->line,
                            shown_cell(stated->text) + " disagrees with the positions, whose mean step is " +
                                number_text(step) + " m; must agree, or the spacing be given");
            record_.spacing_from +=
                ", which agrees with line " + std::to_string(stated->line) + " (" + stated->text + ")";
        }
        return step;
    }

    /// Of the positions, in the file's unit, always positive.
    double mean_step() {
        const std::vector<double>& x = values_[record_.position_column - 1];
        for (std::size_t i = 0; i < x.size(); ++i)
            if (std::isnan(x[i]))
                refuse_line(name_, row_lines_[i], "has no position; allowed are finite decimal numbers");
        if (x.size() < 2) refuse_file(name_, "holds " + std::to_string(x.size()) + " points; must be at least 16");
        const double mean = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        const double printed = printed_[record_.position_column - 1].resolution();
        if (!std::isfinite(mean))
            refuse_file(name_, "holds positions beyond the range of double precision; must be finite lengths");
        // printed too coarsely, neighbours may share a position; otherwise every step goes the same way
        const double direction = mean < 0 ? -1 : 1;
        for (std::size_t i = 1; i < x.size(); ++i) {
            const double next = (x[i] - x[i - 1]) * direction;
            if (next < 0 || (next == 0 && printed < std::abs(mean)))
                refuse_line(name_, row_lines_[i],
                            "position " + number_text(x[i]) + " follows " + number_text(x[i - 1]) +
                                "; positions must rise, or fall, throughout");
        }
        if (mean == 0)
            refuse_file(name_, "has all its positions at " + number_text(x.front()) +
                                   "; positions must rise, or fall, throughout");
        // both ends of a step and both ends of the whole are rounded, or cut, to the printed digits
        const double allowed = 1.01 * printed + 0.01 * std::abs(mean);
        double worst = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            worst = std::max(worst, std::abs(x[i] - (x.front() + static_cast<double>(i) * mean)));
        if (worst > allowed || is_interrupted(x, printed)) refuse_spacing(x);
        record_.reversed = mean < 0;
        return std::abs(mean);
    }

    static std::vector<double> steps_of(const std::vector<double>& x) {
        std::vector<double> steps(x.size() - 1);
        for (std::size_t i = 0; i + 1 < x.size(); ++i) steps[i] = x[i + 1] - x[i];
        return steps;
    }

    static double median(std::vector<double> values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }

    /// 0 1 2 4 5 ...: positions printed to whole steps, of which one or two are odd, have lost a row rather than digits.
    static bool is_interrupted(const std::vector<double>& x, double printed) {
        const std::vector<double> steps = steps_of(x);
        const double usual = median(steps);
        if (printed < 0.1 * std::abs(usual) || usual == 0) return false;
        const auto odd = std::count_if(steps.begin(), steps.end(),
                                       [&](double step) { return std::abs(step - usual) > 0.5 * printed; });
        return odd == 1 || odd == 2;
    }

    /// Names the step that is furthest from the usual one.
    [[noreturn]] void refuse_spacing(const std::vector<double>& x) const {
        const std::vector<double> steps = steps_of(x);
        const double usual = median(steps);
        const auto odd = std::max_element(
            steps.begin(), steps.end(), [&](double a, double b) { return std::abs(a - usual) < std::abs(b - usual); });
        const auto row = static_cast<std::size_t>(odd - steps.begin()) + 1;
        refuse_line(name_, row_lines_[row],
                    "position " + number_text(x[row]) + " is a step of " + number_text(*odd) +
                        " where the usual one is " + number_text(usual) +
                        "; positions must be equally spaced to their printed digits");
    }

    void check(const Profile<double>& profile) const {
        if (profile.present() < 16)
            refuse_file(name_, "holds " + std::to_string(profile.present()) + " points; must be at least 16");
        try {
            profile.validate(16);
        } catch (const domain_error& error) {
            refuse_file(name_, error.what());
        }
    }

    std::string text_, name_;
    const DelimitedOptions& options_;
    DelimitedRecord record_;
    std::vector<Line> lines_;
    std::size_t first_ = 0;  // line of the first row
    Dialect dialect_;
    std::vector<std::vector<double>> values_;  // by column
    std::vector<PrintedDigits> printed_;       // by column
    std::vector<std::size_t> row_lines_;
};

}  // namespace detail

inline std::vector<std::string> DelimitedRecord::sentences() const {
    std::vector<std::string> all;
    all.push_back("separator: " + separator + ", decimal " + (decimal_comma ? "comma" : "point"));
    all.push_back("header: " + std::to_string(header_lines) + (header_lines == 1 ? " line" : " lines"));
    std::string column_text =
        "columns: " + std::to_string(columns) + ", heights in column " + std::to_string(height_column);
    if (position_column != 0) column_text += ", positions in column " + std::to_string(position_column);
    all.push_back(column_text + (reversed ? ", falling: turned round" : ""));
    all.push_back("units: heights in " + height_unit +
                  (position_unit.empty() ? "" : ", positions in " + position_unit) + ", from " + units_from);
    all.push_back("spacing: from " + spacing_from);
    all.push_back("points: " + std::to_string(points) + ", of which " + std::to_string(missing) + " missing");
    return all;
}

inline DelimitedProfile read_profile(std::istream& input, std::string_view name, const DelimitedOptions& options) {
    const std::string file(name);
    return detail::DelimitedReader(detail::read_all(input, file), file, options).read();
}

inline DelimitedProfile read_profile(const std::filesystem::path& path, const DelimitedOptions& options) {
    const std::string name = path.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        detail::refuse_file(name, "is a folder; must be a file of delimited text");
    std::ifstream input(path, std::ios::binary);
    if (!input) detail::refuse_file(name, "cannot be opened; must be an existing, readable file");
    return read_profile(input, name, options);
}

}  // namespace fstiff::io
