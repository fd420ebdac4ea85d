// SPDX-License-Identifier: BSD-3-Clause
#include "io/profile_text.hpp"

namespace fstiff::io {

namespace detail {

namespace {

/// Everything that reading one profile needs to pass between its steps. The text must outlive it.
class ProfileTextReader {
public:
    ProfileTextReader(NumberTable table, std::string name, const ProfileTextOptions& options)
        : name_(std::move(name)), options_(options), table_(std::move(table)) {}

    ProfileFromText read() {
        settle_lone_commas();
        entries_ = header_entries(table_);
        table_.missing = stated_missing(entries_, options_.missing, name_);
        if (!table_.missing.from.empty())
            record_.missing_from = table_.missing.text() + ", from " + table_.missing.from;
        read_rows(table_, name_, profile_rules);
        record_.name = name_;
        table_.describe(record_);
        record_.columns = table_.columns;
        if (table_.columns == 1 && table_.dialect.separator == ' ') record_.separator = "none";
        choose_columns();
        choose_units();
        ProfileFromText result;
        result.profile.heights = column(record_.height_column);
        mark_missing(result.profile.heights.data(), result.profile.size(), table_.missing, name_, options_.names,
                     record_.height_unit, [&](std::size_t i) { return table_.row_lines[i]; });
        const double unit = unit_factor(record_.height_unit, Dimension::length);
        record_.resolution = table_.printed[record_.height_column - 1].resolution() * unit;
        for (double& z : result.profile.heights) z *= unit;
        result.profile.spacing = spacing();
        if (resampled_) resample(result.profile.heights);
        if (record_.reversed) std::reverse(result.profile.heights.begin(), result.profile.heights.end());
        record_.points = result.profile.size();
        record_.missing = record_.points - result.profile.present();
        if (result.profile.present() < 16)
            refuse_file(name_, {"holds ", result.profile.present(), " points; must be at least 16"});
        located({.file = name_}, [&] { result.profile.validate(16); });
        result.record = record_;
        return result;
    }

private:
    /// \p number counted from 1.
    std::vector<double> column(std::size_t number) const {
        std::vector<double> values(table_.rows());
        for (std::size_t r = 0; r < values.size(); ++r) values[r] = table_.at(r, number - 1);
        return values;
    }

    /// In "0,12" the comma may separate two columns or be decimal. It separates, unless no row holds a point and the
    /// columns that it would separate could not be equally spaced positions and heights.
    void settle_lone_commas() {
        const std::vector<Line>& lines = table_.lines;
        if (table_.dialect.separator != ',') return;
        // titles that the comma separates, each with its unit, settle it
        if (table_.first > 0 && !units_in(lines[table_.first - 1].text, 2, ',').empty()) return;
        std::optional<double> before, step;
        bool positions = true;
        for (std::size_t i = table_.first; i < lines.size(); ++i) {
            if (is_comment(lines[i].text)) continue;
            const std::string_view line = without_comment(lines[i].text);
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
        if (positions) return;
        table_.dialect = {' ', true};
        table_.columns = 1;
    }

    void choose_columns() {
        columns_ = profile_columns(table_, name_,
                                   {.column = options_.column,
                                    .x_column = options_.x_column,
                                    .spacing = options_.spacing.has_value(),
                                    .names = options_.names});
        record_.height_column = columns_.heights;
        record_.position_column = options_.spacing ? 0 : columns_.positions;
        record_.index_column = columns_.first_index();
    }

    void choose_units() {
        const std::size_t position = record_.position_column;
        const auto given =
            given_units(options_.units, 2, name_, "one unit, or two such as \"um,nm\" (positions, heights)");
        const TitleUnits found = columns_.units(table_, position != 0);
        const auto above = [&](std::size_t column) {
            return column == 0 ? std::string_view() : found.units[column - 1];
        };
        if (!given.empty()) {
            record_.height_unit = given.back();
            if (position != 0) record_.position_unit = given.front();
            record_.units_from = "options";
            if (!found.units.empty()) {
                warn_of_unit(above(record_.height_column), record_.height_unit, found.from, "the heights");
                warn_of_unit(above(position), record_.position_unit, found.from, "the positions");
            } else if (const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                                       [](const HeaderEntry& one) {
                                                           return is_height_unit_key(one.key) &&
                                                                  is_unit(one.value, Dimension::length);
                                                       });
                       entry != entries_.end())
                warn_of_unit(entry->value, record_.height_unit, "line " + std::to_string(entry->line), "the heights");
            if (given.size() == 2) unit_of_positions_ = given.front();
            return;
        }
        if (!found.units.empty()) {
            record_.height_unit = above(record_.height_column);
            record_.position_unit = above(position);
            unit_of_positions_ = above(columns_.positions);
            record_.units_from = found.from;
            return;
        }
        if (const HeaderEntry* unit = stated_height_unit(entries_, name_).unit;
            position == 0 && unit && is_unit(unit->value, Dimension::length)) {
            record_.height_unit = unit->value;
            record_.units_from = "line " + std::to_string(unit->line);
            return;
        }
        refuse_file(name_,
                    {"states no unit and none is given; must be ", given_as(options_.names, "units", "\"um,nm\""),
                     " (positions, heights), each one of ", accepted_units(Dimension::length)});
    }

    /// Warns where \p used is another unit than the \p stated one, where there are both.
    void warn_of_unit(std::string_view stated, std::string_view used, const std::string& from,
                      const std::string& what) {
        if (stated.empty() || used.empty() ||
            unit_factor(stated, Dimension::length) == unit_factor(used, Dimension::length))
            return;
        record_.warnings.push_back(contradiction(options_.names, "units", shown_cell(options_.units),
                                                 from + ", which states " + printable(stated, 16) + " for " + what));
    }

    /// Warns where the \p given spacing is another than that of the header, or of the positions.
    void warn_of_spacing(double given, const std::optional<StatedSpacing>& stated) {
        const auto warn = [&](const std::string& what) {
            record_.warnings.push_back(contradiction(options_.names, "spacing", number_text(given) + " m", what));
        };
        if (stated) {
            if (std::abs(given - stated->value) > 0.01 * given + 0.6 * stated->resolution)
                warn("line " + std::to_string(stated->line) + ", which states " + stated->text);
            return;
        }
        if (columns_.positions == 0 || unit_of_positions_.empty() || table_.rows() < 2) return;
        const std::size_t last = table_.rows() - 1, c = columns_.positions - 1;
        const double step = std::abs(table_.at(last, c) - table_.at(0, c)) / static_cast<double>(last) *
                            unit_factor(unit_of_positions_, Dimension::length);
        if (std::isfinite(step) && std::abs(given - step) > 0.01 * given + 0.01 * step)
            warn("column " + std::to_string(columns_.positions) + ", whose mean step is " + number_text(step) + " m");
    }

    double spacing() {
        const auto stated = stated_spacing(entries_);
        if (options_.spacing) {
            require_positive("spacing", *options_.spacing);
            warn_of_spacing(*options_.spacing, stated);
            record_.spacing_from = "options";
            return *options_.spacing;
        }
        if (record_.position_column == 0) {
            if (!stated)
                refuse_file(name_, {"has no column of positions", numbering(), " and no spacing is given; must be ",
                                    given_as(options_.names, "spacing", "\"0.5 um\"")});
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
                            {shown_cell(stated->text), " disagrees with the positions, whose mean step is ", step,
                             " m; must agree, or the spacing be given"});
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

    /// Why a column is not the positions, for messages; empty without one that numbers the points.
    std::string numbering() const {
        if (record_.index_column == 0) return "";
        const std::string column = std::to_string(record_.index_column);
        return " (column " + column + " numbers the points; as positions it must be told by " +
               of_words(options_.names, "x_column") + options_.names.equals + column + ")";
    }

    /// Of the positions, in the file's unit, always positive.
    double mean_step() {
        const std::vector<double> x = column(record_.position_column);
        for (std::size_t i = 0; i < x.size(); ++i)
            if (std::isnan(x[i]))
                refuse_line(name_, table_.row_lines[i], {"has no position; allowed are finite decimal numbers"});
        if (x.size() < 2) refuse_file(name_, {"holds ", x.size(), " points; must be at least 16"});
        const double mean = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        const double printed = table_.printed[record_.position_column - 1].resolution();
        if (!std::isfinite(mean))
            refuse_file(name_, {"holds positions beyond the range of double precision; must be finite lengths"});
        // printed too coarsely, neighbours may share a position; otherwise every step goes the same way
        const double direction = mean < 0 ? -1 : 1;
        for (std::size_t i = 1; i < x.size(); ++i) {
            const double next = (x[i] - x[i - 1]) * direction;
            // 1 30 3: without the 30, the positions go on as they should
            if (next < 0 && i > 1 && (x[i] - x[i - 2]) * direction > 0)
                refuse_line(name_, table_.row_lines[i - 1],
                            {"position ", x[i - 1], " ", record_.position_unit, " stands between ", x[i - 2], " and ",
                             x[i], " ", record_.position_unit, "; positions must rise, or fall, throughout"});
            if (next < 0 || (next == 0 && printed < std::abs(mean)))
                refuse_line(name_, table_.row_lines[i],
                            {"position ", x[i], " ", record_.position_unit, " follows ", x[i - 1], " ",
                             record_.position_unit, "; positions must rise, or fall, throughout"});
        }
        if (mean == 0)
            refuse_file(name_, {"has all its positions at ", x.front(), " ", record_.position_unit,
                                "; positions must rise, or fall, throughout"});
        // both ends of a step and both ends of the whole are rounded, or cut, to the printed digits
        const double allowed = 1.01 * printed + 0.01 * std::abs(mean);
        double worst = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            worst = (std::max)(worst, std::abs(x[i] - (x.front() + static_cast<double>(i) * mean)));
        if (worst > allowed || is_interrupted(x, printed)) {
            if (!options_.resample) refuse_spacing(x);
            resampled_ = true;
        }
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
        refuse_line(name_, table_.row_lines[row],
                    {"position ", x[row], " ", record_.position_unit, " is a step of ", *odd, " ",
                     record_.position_unit, " where the usual one is ", usual, " ", record_.position_unit,
                     "; positions must be equally spaced to their printed digits, or be resampled by ",
                     switched_on(options_.names, "resample")});
    }

    /// Heights at equal steps from the first position to the last, by straight lines between neighbours; missing where one
    /// of them is.
    void resample(std::vector<double>& heights) {
        const std::vector<double> x = column(record_.position_column);
        const std::vector<double> steps = steps_of(x);
        const auto [least, most] = std::minmax_element(steps.begin(), steps.end(),
                                                       [](double a, double b) { return std::abs(a) < std::abs(b); });
        record_.spacing_from = "interpolation: unequal steps of " + number_text(std::abs(*least)) + " to " +
                               number_text(std::abs(*most)) + " " + record_.position_unit + " resampled to " +
                               std::to_string(x.size()) +
                               " equal ones by straight lines, which lowers the finest waves";
        const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        std::vector<double> even(heights.size());
        for (std::size_t i = 0, k = 0; i < even.size(); ++i) {
            const double at = i + 1 == even.size() ? x.back() : x.front() + static_cast<double>(i) * step;
            while (k + 2 < x.size() && (x[k + 1] - at) * step < 0) ++k;
            const double share = x[k + 1] == x[k] ? 0 : (at - x[k]) / (x[k + 1] - x[k]);
            even[i] = share <= 0   ? heights[k]
                      : share >= 1 ? heights[k + 1]
                                   : heights[k] + share * (heights[k + 1] - heights[k]);
        }
        heights = std::move(even);
    }

    std::string name_;
    const ProfileTextOptions& options_;
    NumberTable table_;
    ProfileTextRecord record_;
    std::vector<HeaderEntry> entries_;
    ProfileColumns columns_;
    std::string unit_of_positions_{};  // where it is known
    bool resampled_ = false;
};

ProfileFromText read_profile_text(NamedBytes file, const ProfileTextOptions& options) {
    const std::string text = text_of(std::move(file.bytes), file.name, profile_rules.holds);
    return ProfileTextReader(open_table(text, file.name, profile_rules), file.name, options).read();
}

}  // namespace

}  // namespace detail

std::vector<std::string> ProfileTextRecord::sentences() const {
    std::vector<std::string> all = layout_sentences();
    std::string column_text =
        "columns: " + std::to_string(columns) + ", heights in column " + std::to_string(height_column);
    if (position_column != 0) column_text += ", positions in column " + std::to_string(position_column);
    if (index_column != 0) column_text += ", column " + std::to_string(index_column) + " numbers the points";
    all.push_back(column_text + (reversed ? ", falling: turned round" : ""));
    all.push_back("units: heights in " + detail::printable(height_unit, 16) +
                  (position_unit.empty() ? "" : ", positions in " + detail::printable(position_unit, 16)) + ", from " +
                  units_from);
    all.push_back("spacing: from " + spacing_from);
    all.push_back(points_sentence(std::to_string(points)));
    return all;
}

ProfileFromText read_profile(detail::NumberTable table, const std::string& name, const ProfileTextOptions& options) {
    return detail::ProfileTextReader(std::move(table), name, options).read();
}

ProfileFromText read_profile(std::istream& input, std::string_view name, const ProfileTextOptions& options) {
    return detail::read_profile_text(detail::read_bytes(input, name), options);
}

ProfileFromText read_profile(const std::filesystem::path& path, const ProfileTextOptions& options) {
    return detail::read_profile_text(detail::read_bytes(path, "delimited text"), options);
}

}  // namespace fstiff::io
