// SPDX-License-Identifier: BSD-3-Clause
#include "io/profile_text.hpp"

#include "io/ambiguous_signs.hpp"
#include "io/height_sense.hpp"
#include "io/readers.hpp"
#include "io/row_layout.hpp"
#include "io/unequal_steps.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// Decisions, for the record.
struct ProfileNotes {
    std::size_t height_column{};    // counted from 1
    std::size_t position_column{};  // counted from 1; 0: none used
    std::string position_unit;      // as written; empty when no positions are used
    std::string height_unit;        // as written
    std::string units_from;         // "line 28" or "options"
    std::string spacing_from;
    bool reversed{};  // positions fell: the heights were turned round
};

/// Everything that reading one profile needs to pass between its steps. The text must outlive it.
class ProfileTextReader {
public:
    ProfileTextReader(NumberTable table, std::string name, const SurfaceOptions& options)
        : name_(std::move(name)), options_(options), table_(std::move(table)) {}

    Reading read() {
        take_rows_above(table_);
        table_.missing = given_missing(options_.missing, name_);
        settle_lone_commas(table_);
        entries_ = header_entries(table_, true);
        table_.missing = stated_missing(entries_, options_.missing, name_);
        read_rows(table_, name_, RowEnds::may_be_short);
        choose_columns();
        choose_units();
        RawMap row;
        row.rows = 1;
        row.heights = column(notes_.height_column);
        mark_missing(row.heights.data(), row.heights.size(), table_.missing,
                     table_.wholes[notes_.height_column - 1].value(), name_, options_.names, notes_.height_unit,
                     [&](std::size_t i) { return table_.row_lines[i]; });
        std::vector<std::size_t> used{notes_.height_column - 1};
        if (notes_.position_column != 0) used.push_back(notes_.position_column - 1);
        refuse_thousands(table_, used, false, name_);
        const double scale = factor_of_heights(entries_, options_, name_, record_);
        const double unit = unit_factor(notes_.height_unit, Dimension::length) * scale;
        record_.resolution = table_.printed[notes_.height_column - 1].resolution() * unit;
        for (double& z : row.heights) z *= unit;
        turn_over(row, written_titles(table_)[notes_.height_column - 1], entries_, name_, record_);
        row.dx = row.dy = spacing();
        if (resampled_) resample(row.heights);
        if (notes_.reversed) std::reverse(row.heights.begin(), row.heights.end());
        row.columns = row.heights.size();
        if (present(row) < 16) refuse_file(name_, {"holds ", present(row), " points; must be at least 16"});
        fstiff::detail::located({.file = name_}, [&] { validate_map(row, 16); });
        describe(row);
        return {std::move(row), std::move(record_)};
    }

private:
    void describe(const RawMap& row) {
        const auto column = [](const std::string& unit, std::size_t number) {
            return (unit.empty() ? "" : " [" + printable(unit, 16) + "]") + " in column " + std::to_string(number);
        };
        std::string roles = "heights" + column(notes_.height_unit, notes_.height_column);
        if (notes_.position_column != 0)
            roles += ", positions" + column(notes_.position_unit, notes_.position_column) +
                     (notes_.reversed ? ", which fall: turned round" : "");
        table_.say_layout(record_, roles + columns_.left_out(table_), true);
        const std::string positions =
            notes_.position_unit.empty() ? "" : ", positions in " + printable(notes_.position_unit, 16);
        record_.note("units",
                     "heights in " + printable(notes_.height_unit, 16) + positions + ", from " + notes_.units_from);
        record_.note("spacing", "from " + notes_.spacing_from);
        record_.say_points_of_profile(row, table_.missing.note());
    }

    /// \p number counted from 1.
    std::vector<double> column(std::size_t number) const {
        std::vector<double> values(table_.rows());
        for (std::size_t r = 0; r < values.size(); ++r) values[r] = table_.at(r, number - 1);
        return values;
    }

    void choose_columns() {
        columns_ = profile_columns(table_, name_,
                                   {.column = options_.column,
                                    .x_column = options_.x_column,
                                    .spacing = options_.spacing.has_value(),
                                    .names = options_.names});
        notes_.height_column = columns_.heights;
        notes_.position_column = options_.spacing ? 0 : columns_.positions;
    }

    static std::string line(std::size_t number) { return "line " + std::to_string(number); }
    static bool is_length(const HeaderEntry* entry) { return entry && is_unit(entry->value, Dimension::length); }

    void choose_units() {
        const std::size_t position = notes_.position_column;
        const auto titles = titles_above(table_);
        refuse_no_length(titles, notes_.height_column, name_);
        refuse_no_length(titles, position, name_);
        if (titles.empty()) refuse_no_length(entries_, name_);
        const auto written = written_titles(table_);
        check_factor(written[notes_.height_column - 1], true, options_, name_, record_);
        if (position != 0) check_factor(written[position - 1], false, options_, name_, record_);
        const auto given =
            given_units(options_.units, 2, name_, "one unit, or two such as \"um,nm\" (positions, heights)");
        const TitleUnits found = columns_.units(table_, position != 0);
        const auto above = [&](std::size_t column) {
            return column == 0 ? std::string_view() : found.units[column - 1];
        };
        const HeaderEntry* const positions = stated_axis_unit(entries_);
        if (!given.empty()) return take_given_units(given, found, titles);
        if (!found.units.empty()) {
            notes_.height_unit = above(notes_.height_column);
            notes_.position_unit = above(position);
            unit_of_positions_ = above(columns_.positions);
            notes_.units_from = found.from;
            for (const HeaderEntry& entry : entries_)
                if (is_height_unit_key(entry.key)) refuse_other_unit(&entry, notes_.height_unit, "heights");
            refuse_other_unit(position == 0 ? nullptr : positions, notes_.position_unit, "positions");
            return;
        }
        // each from its title, or else from the header
        const HeaderEntry* const heights = stated_height_unit(entries_, name_).unit;
        const auto choose = [&](std::size_t column, const HeaderEntry* entry, std::string& unit) {
            if (column == 0) return;
            std::string from;
            if (column <= titles.size() && !titles[column - 1].unit.empty())
                unit = titles[column - 1].unit, from = line(titles[column - 1].line);
            else if (is_length(entry) && (column > titles.size() || titles[column - 1].unread.empty()))
                unit = entry->value, from = line(entry->line);
            if (from.empty() || from == notes_.units_from) return;
            notes_.units_from += (notes_.units_from.empty() ? "" : " and ") + from;
        };
        choose(notes_.height_column, heights, notes_.height_unit);
        choose(position, positions, notes_.position_unit);
        require_unit_of(notes_.height_column, notes_.height_unit, heights, titles, "heights");
        require_unit_of(position, notes_.position_unit, positions, titles, "positions");
        unit_of_positions_ = notes_.position_unit;
    }

    /// Takes the units of options, with a warning where the file states another.
    void take_given_units(const std::vector<std::string_view>& given, const TitleUnits& found,
                          const std::vector<ColumnTitle>& titles) {
        const std::size_t position = notes_.position_column;
        const auto above = [&](std::size_t column) {
            return column == 0 ? std::string_view() : found.units[column - 1];
        };
        notes_.height_unit = given.back();
        if (position != 0) notes_.position_unit = given.front();
        notes_.units_from = "options";
        if (!found.units.empty()) {
            warn_of_unit(above(notes_.height_column), notes_.height_unit, found.from, "the heights");
            warn_of_unit(above(position), notes_.position_unit, found.from, "the positions");
        } else if (const auto entry = std::find_if(
                       entries_.begin(), entries_.end(),
                       [&](const HeaderEntry& one) { return is_height_unit_key(one.key) && is_length(&one); });
                   entry != entries_.end()) {
            warn_of_unit(entry->value, notes_.height_unit, line(entry->line), "the heights");
        }
        if (notes_.height_column <= titles.size())
            if (const ColumnTitle& title = titles[notes_.height_column - 1];
                title.unread.find('[') == 0 && record_.warnings.empty())  // else its factor was reported
                record_.warnings.push_back(contradiction(options_.names, "units", shown_cell(options_.units),
                                                         line(title.line) + ", which states " + title.unread));
        if (given.size() == 2) unit_of_positions_ = given.front();
    }

    /// Refuses a unit of the header that is another than that of the title.
    void refuse_other_unit(const HeaderEntry* entry, const std::string& unit, const std::string& what) const {
        if (!is_length(entry)) return;
        const double stated = unit_factor(entry->value, Dimension::length);
        // "Unit" alone may be that of the positions
        if (stated == unit_factor(unit, Dimension::length) ||
            (!notes_.position_unit.empty() && stated == unit_factor(notes_.position_unit, Dimension::length)))
            return;
        refuse_line(name_, entry->line,
                    {"states ", printable(entry->value, 16), ", and ", notes_.units_from, " ", printable(unit, 16),
                     " for the ", what, "; must be one unit, or ", given_as(options_.names, "units", units_text())});
    }

    /// How messages call the units that are to be given: a unit that is known by its name.
    std::string units_text() const {
        if (notes_.position_column == 0) return "\"UNIT\"";
        const auto name = [](const std::string& known) { return known.empty() ? "UNIT" : printable(known, 16); };
        return "\"" + name(notes_.position_unit) + "," + name(notes_.height_unit) + "\"";
    }

    /// \throws domain_error where \p unit of a \p column that is used is not known, naming what is stated in its place.
    void require_unit_of(std::size_t column, const std::string& unit, const HeaderEntry* entry,
                         const std::vector<ColumnTitle>& titles, const std::string& what) const {
        if (column == 0 || !unit.empty()) return;
        const std::string must = "must be " + given_as(options_.names, "units", units_text()) +
                                 (notes_.position_column == 0 ? ", " : " (positions, heights), each ") + "one of " +
                                 accepted_units(Dimension::length);
        if (column <= titles.size() && !titles[column - 1].unread.empty())
            refuse_line(name_, titles[column - 1].line,
                        {"states the unit ", shown_cell(titles[column - 1].unread), " for the ", what,
                         ", which is not understood; ", must});
        if (entry && !is_length(entry))
            refuse_line(
                name_, entry->line,
                {"states the unit ", shown_cell(entry->value), " for the ", what, ", which is not understood; ", must});
        refuse_file(name_, {"states no unit of the ", what, " and none is given; ", must, of_mitutoyo()});
    }

    /// What a length and the number of points above one column of heights may mean, for messages.
    std::string of_mitutoyo() const {
        if (table_.counted < 2 || table_.columns != 1) return "";
        const auto length = number_in(table_.lines[table_.counted - 2].text, false);
        if (!length || !(*length > 0)) return "";
        const std::string step = number_text(*length / static_cast<double>(table_.rows()));
        return "; Mitutoyo writes the length in mm and the number of points above heights in um, which would be " +
               options_.names.prefix + "units" + options_.names.equals + "um and " + options_.names.prefix + "spacing" +
               options_.names.equals + "\"" + step + " mm\"";
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
            fstiff::detail::require_positive("spacing", *options_.spacing);
            warn_of_spacing(*options_.spacing, stated);
            notes_.spacing_from = "options";
            return *options_.spacing;
        }
        if (notes_.position_column == 0) {
            if (!stated)
                refuse_file(name_, {"has no column of positions", numbering(), " and no spacing is given; must be ",
                                    given_as(options_.names, "spacing", "\"0.5 um\""), of_mitutoyo()});
            notes_.spacing_from = "line " + std::to_string(stated->line) + " (" + stated->text + ")";
            return stated->value;
        }
        const double unit = unit_factor(notes_.position_unit, Dimension::length);
        const double step = mean_step() * unit;
        notes_.spacing_from = "mean step of the positions";
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
                notes_.spacing_from =
                    "line " + std::to_string(stated->line) + " (" + stated->text + "), with which the positions agree";
                return stated->value;
            }
            notes_.spacing_from +=
                ", which agrees with line " + std::to_string(stated->line) + " (" + stated->text + ")";
        }
        return step;
    }

    /// Why a column is not the positions, for messages; empty without one that numbers the points.
    std::string numbering() const {
        if (columns_.first_index() == 0) return "";
        const std::string column = std::to_string(columns_.first_index());
        return " (column " + column + " numbers the points; to use it as positions, give " +
               of_words(options_.names, "x_column") + options_.names.equals + column + ")";
    }

    std::string must_rise() const {
        return detail::must_rise(table_, notes_.height_column, notes_.position_column, options_.names);
    }

    /// Step of the positions, in the file's unit, always positive.
    double mean_step() {
        const std::vector<double> x = column(notes_.position_column);
        for (std::size_t i = 0; i < x.size(); ++i)
            if (std::isnan(x[i]))
                refuse_line(name_, table_.row_lines[i], {"has no position; allowed are finite decimal numbers"});
        if (x.size() < 2) refuse_file(name_, {"holds ", x.size(), " points; must be at least 16"});
        const double mean = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        const double printed = table_.printed[notes_.position_column - 1].resolution();
        if (!std::isfinite(mean))
            refuse_file(name_, {"holds positions beyond the range of double precision; must be finite lengths"});
        // printed too coarsely, neighbours may share a position; otherwise every step goes the same way
        const double direction = mean < 0 ? -1 : 1;
        for (std::size_t i = 1; i < x.size(); ++i) {
            const double next = (x[i] - x[i - 1]) * direction;
            // 1 30 3: without the 30, the positions go on as they should
            if (next < 0 && i > 1 && (x[i] - x[i - 2]) * direction > 0)
                refuse_line(name_, table_.row_lines[i - 1],
                            {"position ", x[i - 1], " ", notes_.position_unit, " is between ", x[i - 2], " and ", x[i],
                             " ", notes_.position_unit, must_rise()});
            if (next < 0 || (next == 0 && printed < std::abs(mean)))
                refuse_line(name_, table_.row_lines[i],
                            {"position ", x[i], " ", notes_.position_unit, " follows ", x[i - 1], " ",
                             notes_.position_unit, must_rise()});
        }
        if (mean == 0)
            refuse_file(name_, {"has all its positions at ", x.front(), " ", notes_.position_unit, must_rise()});
        // both ends of a step and both ends of the whole are rounded, or cut, to the printed digits
        const double allowed = 1.01 * printed + 0.01 * std::abs(mean);
        double worst = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            worst = (std::max)(worst, std::abs(x[i] - (x.front() + static_cast<double>(i) * mean)));
        if (worst > allowed || is_interrupted(x, printed)) {
            if (!options_.resample) refuse_spacing(x);
            resampled_ = true;
        }
        notes_.reversed = mean < 0;
        return std::abs(mean);
    }

    /// Names the step that is furthest from the usual one.
    [[noreturn]] void refuse_spacing(const std::vector<double>& x) const {
        const std::vector<double> steps = steps_of(x);
        const double usual = median(steps);
        const auto odd = std::max_element(
            steps.begin(), steps.end(), [&](double a, double b) { return std::abs(a - usual) < std::abs(b - usual); });
        const auto row = static_cast<std::size_t>(odd - steps.begin()) + 1;
        refuse_line(name_, table_.row_lines[row],
                    {"position ", x[row], " ", notes_.position_unit, " is a step of ", *odd, " ", notes_.position_unit,
                     " where the usual one is ", usual, " ", notes_.position_unit,
                     "; positions must be equally spaced to their printed digits, or be resampled by ",
                     switched_on(options_.names, "resample")});
    }

    /// Heights at equal steps from the first position to the last, by straight lines between neighbours; missing where
    /// one of them is.
    void resample(std::vector<double>& heights) {
        const std::vector<double> x = column(notes_.position_column);
        const std::vector<double> steps = steps_of(x);
        const auto [least, most] = std::minmax_element(steps.begin(), steps.end(),
                                                       [](double a, double b) { return std::abs(a) < std::abs(b); });
        notes_.spacing_from = "interpolation: unequal steps of " + number_text(std::abs(*least)) + " to " +
                              number_text(std::abs(*most)) + " " + notes_.position_unit + " resampled to " +
                              std::to_string(x.size()) + " equal ones by straight lines, which lowers the finest waves";
        heights = at_equal_steps(heights, x);
    }

    std::string name_;
    const SurfaceOptions& options_;
    NumberTable table_;
    ProfileNotes notes_;
    Record record_;
    std::vector<HeaderEntry> entries_;
    ProfileColumns columns_;
    std::string unit_of_positions_{};  // where it is known
    bool resampled_ = false;
};

}  // namespace

}  // namespace detail

Reading read_profile(detail::NumberTable table, const std::string& name, const SurfaceOptions& options) {
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
