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

#include <fstiff/io/text_table.hpp>
#include <fstiff/profile/profile.hpp>

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
/// \throws file_error when it cannot be opened or read.
[[nodiscard]] inline DelimitedProfile read_profile(const std::filesystem::path& path,
                                                   const DelimitedOptions& options = {});

namespace detail {

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
                const std::size_t columns = columns_from(i, cells.size());
                if (columns > 4096)
                    refuse_line(name_, line, "has " + std::to_string(columns) + " columns; must be at most 4096");
                record_.columns = columns;
                values_.resize(columns);
                printed_.resize(columns);
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
        record_.separator =
            record_.columns == 1 && dialect_.separator == ' ' ? "none" : separator_name(dialect_.separator);
    }

    /// Of a table whose first row, line \p first, shows \p shown cells: its last ones may be missing, "0.5,".
    std::size_t columns_from(std::size_t first, std::size_t shown) const {
        const std::string_view line = without_comment(lines_[first].text);
        const auto written =
            dialect_.separator == ' '
                ? shown
                : static_cast<std::size_t>(std::count(line.begin(), line.end(), dialect_.separator)) + 1;
        std::size_t columns = shown;
        std::vector<std::string_view> cells;
        for (std::size_t i = first + 1; i < lines_.size() && columns < written; ++i) {
            if (is_comment(lines_[i].text)) continue;
            split_line(without_comment(lines_[i].text), dialect_.separator, cells);
            if (cells.size() <= written) columns = std::max(columns, cells.size());
        }
        return columns;
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
            "states no unit and none is given; must be given as units = \"um,nm\" (positions, heights), each one of " +
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
                refuse_file(
                    name_, "has no column of positions and no spacing is given; must be given as spacing = \"0.5 um\"");
            record_.spacing_from = "line " + std::to_string(stated->line) + " (" + stated->text + ")";
            return stated->value;
        }
        const double unit = unit_factor(record_.position_unit, Dimension::length);
        const double step = mean_step() * unit;
        record_.spacing_from = "mean step of the positions";
        if (stated) {
            const bool same = std::abs(step - stated->value) <= 1e-9 * step;
            // else rounded to its last digit
            const bool agrees = same || std::abs(step - stated->value) <= 0.6 * stated->resolution;
            if (!agrees)
                refuse_line(name_, stated->line,
                            shown_cell(stated->text) + " disagrees with the positions, whose mean step is " +
                                number_text(step) + " m; must agree, or the spacing be given");
            if (same) {
                // the same number, without the rounding of the positions
                record_.spacing_from =
                    "line " + std::to_string(stated->line) + " (" + stated->text + "), with which the positions agree";
                return stated->value;
            }
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

inline DelimitedProfile read_profile_bytes(std::string bytes, const std::string& name,
                                           const DelimitedOptions& options) {
    return DelimitedReader(text_of(std::move(bytes), name, "one or two columns of numbers"), name, options).read();
}

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
    return detail::read_profile_bytes(detail::read_bytes(input, file), file, options);
}

inline DelimitedProfile read_profile(const std::filesystem::path& path, const DelimitedOptions& options) {
    return detail::read_profile_bytes(detail::read_bytes(path, "delimited text"), path.string(), options);
}

}  // namespace fstiff::io
