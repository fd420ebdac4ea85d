// SPDX-License-Identifier: BSD-3-Clause
#include "io/profile_text.hpp"

#include "io/height_sense.hpp"
#include "io/readers.hpp"
#include "io/table_units.hpp"
#include "io/unequal_steps.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// Turns the numbers of a table into a profile.
class ProfileTextReader {
public:
    ProfileTextReader(TextTable table, const std::string& name, const SurfaceOptions& options)
        : name_(name), options_(options), table_(std::move(table)), heights_(*table_.column(Role::heights)) {
        if (const auto x = table_.column(Role::x)) positions_ = column_of(table_.numbers, *x);
    }

    Reading read() {
        units_ = units_of(table_, options_, name_, record_);
        RawMap row{.heights = table_.take_heights(name_, units_.heights.name), .rows = 1};
        for (double& z : row.heights) z *= units_.heights.factor;
        record_.resolution = table_.resolution() * units_.heights.factor;
        turn_over(row, table_.titles[heights_], table_.entries, name_, record_);
        row.dx = row.dy = spacing();
        if (resampled_) resample(row.heights);
        if (reversed_) std::reverse(row.heights.begin(), row.heights.end());
        row.columns = row.heights.size();
        if (present(row) < 16) refuse_file(name_, {"holds ", present(row), " points; must be at least 16"});
        fstiff::detail::located({.file = name_}, [&] { validate_map(row, 16); });
        describe(row);
        return {std::move(row), std::move(record_)};
    }

private:
    void describe(const RawMap& row) {
        const auto column = [](const LengthUnit& unit, std::size_t c) {
            return " [" + printable(unit.name, 16) + "] in column " + std::to_string(c + 1);
        };
        std::string roles = "heights" + column(units_.heights, heights_);
        if (uses_positions())
            roles += ", positions" + column(units_.x, *table_.column(Role::x)) +
                     (reversed_ ? ", which fall: turned round" : "");
        if (const auto index = table_.column(Role::index))
            roles += "; column " + std::to_string(*index + 1) + " numbers the points";
        for (const std::size_t c : table_.columns(Role::unused))
            roles += "; column " + std::to_string(c + 1) + " not used";
        table_.numbers.say_layout(record_, roles, true);
        record_.note("units", units_.text + ", from " + units_.from);
        record_.note("spacing", "from " + spacing_from_);
        record_.say_points_of_profile(row, table_.numbers.missing.note());
    }

    bool uses_positions() const { return !options_.spacing && !positions_.empty(); }

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
        if (positions_.size() < 2) return;
        const std::size_t x = *table_.column(Role::x);
        const std::string_view unit = options_.units.empty() ? table_.titles[x].unit : units_.lateral;
        if (unit.empty()) return;
        const double step = std::abs(positions_.back() - positions_.front()) /
                            static_cast<double>(positions_.size() - 1) * unit_factor(unit, Dimension::length);
        if (std::isfinite(step) && std::abs(given - step) > 0.01 * given + 0.01 * step)
            warn("column " + std::to_string(x + 1) + ", whose mean step is " + number_text(step) + " m");
    }

    double spacing() {
        const auto stated = stated_spacing(table_.entries);
        const std::string place = stated ? "line " + std::to_string(stated->line) + " (" + stated->text + ")" : "";
        if (options_.spacing) {
            fstiff::detail::require_positive("spacing", *options_.spacing);
            warn_of_spacing(*options_.spacing, stated);
            spacing_from_ = "options";
            return *options_.spacing;
        }
        if (!uses_positions()) {
            if (!stated)
                refuse_file(name_,
                            {"has no column of positions", numbering(), " and no spacing is given; must be ",
                             given_as(options_.names, "spacing", "\"0.5 um\""), hint_of_mitutoyo(table_.numbers)});
            spacing_from_ = place;
            return stated->value;
        }
        const double step = mean_step() * units_.x.factor;
        spacing_from_ = "mean step of the positions";
        if (!stated) return step;
        const double difference = std::abs(step - stated->value);
        if (difference <= 1e-9 * step) {  // the same number, without the rounding of the positions
            spacing_from_ = place + ", with which the positions agree";
            return stated->value;
        }
        if (!(difference <= 0.6 * stated->resolution))  // rounded to its last digit
            refuse_line(name_, stated->line,
                        {shown_cell(stated->text), " disagrees with the positions, whose mean step is ", step,
                         " m; must agree, or the spacing be given"});
        spacing_from_ += ", which agrees with " + place;
        return step;
    }

    /// Why a column is not the positions, for messages; empty without one that numbers the points.
    std::string numbering() const {
        const auto index = table_.column(Role::index);
        if (!index) return "";
        const std::string column = std::to_string(*index + 1);
        return " (column " + column + " numbers the points; to use it as positions, give " +
               of_words(options_.names, "x_column") + options_.names.equals + column + ")";
    }

    /// That positions must rise, and the way out where the heights do.
    std::string must_rise() const {
        const std::string rule = "; positions must rise, or fall, throughout", column = std::to_string(heights_ + 1);
        if (!rises_evenly(table_.numbers, heights_)) return rule;
        return rule + "; column " + column + " does in equal steps: if it holds them, give " +
               of_words(options_.names, "x_column") + options_.names.equals + column + " and " +
               of_words(options_.names, "column") + options_.names.equals + std::to_string(*table_.column(Role::x) + 1);
    }

    /// Step of the positions, in the file's unit, always positive.
    double mean_step() {
        const std::vector<double>& x = positions_;
        for (std::size_t i = 0; i < x.size(); ++i)
            if (std::isnan(x[i]))
                refuse_line(name_, table_.numbers.row_lines[i],
                            {"has no position; allowed are finite decimal numbers"});
        if (x.size() < 2) refuse_file(name_, {"holds ", x.size(), " points; must be at least 16"});
        const double mean = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        const double printed = printed_step(table_.numbers, *table_.column(Role::x));
        if (!std::isfinite(mean))
            refuse_file(name_, {"holds positions beyond the range of double precision; must be finite lengths"});
        // printed too coarsely, neighbours may share a position; otherwise every step goes the same way
        const double direction = mean < 0 ? -1 : 1;
        for (std::size_t i = 1; i < x.size(); ++i) {
            const double next = (x[i] - x[i - 1]) * direction;
            // 1 30 3: without the 30, the positions go on as they should
            if (next < 0 && i > 1 && (x[i] - x[i - 2]) * direction > 0)
                refuse_line(name_, table_.numbers.row_lines[i - 1],
                            {"position ", x[i - 1], " ", units_.x.name, " is between ", x[i - 2], " and ", x[i], " ",
                             units_.x.name, must_rise()});
            if (next < 0 || (next == 0 && printed < std::abs(mean)))
                refuse_line(
                    name_, table_.numbers.row_lines[i],
                    {"position ", x[i], " ", units_.x.name, " follows ", x[i - 1], " ", units_.x.name, must_rise()});
        }
        if (mean == 0) refuse_file(name_, {"has all its positions at ", x.front(), " ", units_.x.name, must_rise()});
        // both ends of a step and both ends of the whole are rounded, or cut, to the printed digits
        const double allowed = 1.01 * printed + 0.01 * std::abs(mean);
        double worst = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            worst = (std::max)(worst, std::abs(x[i] - (x.front() + static_cast<double>(i) * mean)));
        if (worst > allowed || is_interrupted(x, printed)) {
            if (!options_.resample) refuse_spacing(x);
            resampled_ = true;
        }
        reversed_ = mean < 0;
        return std::abs(mean);
    }

    /// Names the step that is furthest from the usual one.
    [[noreturn]] void refuse_spacing(const std::vector<double>& x) const {
        const std::vector<double> steps = steps_of(x);
        const double usual = median(steps);
        const auto odd = std::max_element(
            steps.begin(), steps.end(), [&](double a, double b) { return std::abs(a - usual) < std::abs(b - usual); });
        const auto row = static_cast<std::size_t>(odd - steps.begin()) + 1;
        refuse_line(name_, table_.numbers.row_lines[row],
                    {"position ", x[row], " ", units_.x.name, " is a step of ", *odd, " ", units_.x.name,
                     " where the usual one is ", usual, " ", units_.x.name,
                     "; positions must be equally spaced to their printed digits, or be resampled by ",
                     switched_on(options_.names, "resample")});
    }

    /// Heights at equal steps from the first position to the last, by straight lines between neighbours; missing where
    /// one of them is.
    void resample(std::vector<double>& heights) {
        const std::vector<double>& x = positions_;
        const std::vector<double> steps = steps_of(x);
        const auto [least, most] = std::minmax_element(steps.begin(), steps.end(),
                                                       [](double a, double b) { return std::abs(a) < std::abs(b); });
        spacing_from_ = "interpolation: unequal steps of " + number_text(std::abs(*least)) + " to " +
                        number_text(std::abs(*most)) + " " + units_.x.name + " resampled to " +
                        std::to_string(x.size()) + " equal ones by straight lines, which lowers the finest waves";
        heights = at_equal_steps(heights, x);
    }

    const std::string& name_;
    const SurfaceOptions& options_;
    TextTable table_;
    std::size_t heights_;              // their column
    std::vector<double> positions_{};  // in the unit of the file; empty where there are none
    Units units_{};
    Record record_{};
    std::string spacing_from_{};
    bool reversed_ = false;  // positions fell: the heights are turned round
    bool resampled_ = false;
};

}  // namespace

}  // namespace detail

Reading read_profile(detail::TextTable table, const std::string& name, const SurfaceOptions& options) {
    return detail::ProfileTextReader(std::move(table), name, options).read();
}

namespace detail {

extern constexpr Reader profile_reader{.format = SurfaceFormat::profile,
                                       .endings = ".csv .txt .dat .asc ...",
                                       .holds = "text: heights, or position and height in a line",
                                       .recognised = "one or two columns, or --spacing or --column",
                                       .asks_for = "--units without a header that has them; --spacing of heights",
                                       .options = "units spacing column x-column missing thousands resample channel"};

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
