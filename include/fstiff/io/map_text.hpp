// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a height map from delimited text, and records every decision it took about the file.
///
/// Two forms. A *matrix* has a row of the map a line, its size and units in a header of "key: value" or "key = value"
/// lines, with or without a comment sign: Gwyddion's "# Width: 10 um", "# Height: 5 um", "# Value units: m"; "dx",
/// "pixel size" and the like; "h=305 w=75" is compared with what is there; heights in another unit (rad) need a
/// "height conversion factor (-> m)". *Triples* have x, y and z a line, in any order of the points; the grid is
/// recovered from the coordinates, x and y rise in the map, and points that are not there are missing.
/// Exports of Keyence ("XY Calibration","277.8","nm"), of SPIP ("# x-length = 2000", in nm, "# Bit2nm = 0.5") and of
/// Gwyddion in other languages are matrices too (<fstiff/io/header_words.hpp>).
/// Three columns are triples where x and y form a grid, a matrix where the header states a size; otherwise the form
/// must be given. Missing points are empty cells, "nan", "NA", "N/A", "BAD", "No Data", "***" and the number that the
/// header ("NODATA_value -9999") or the options name. Rows of a matrix keep the order of the file.
///
/// Nothing is guessed: without units, without a physical size, or with points off the grid, the file is refused.
///
///     dx = width / columns,    dy = height / rows               a point stands for a cell, as in Gwyddion
///
/// Units       map in m; MapTextOptions::units are the file's
/// Valid       2 points a side at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    heights and a stated pitch within 1 ulp of the printed number (tests/io/map_text_test.cpp)

#include <fstiff/io/header.hpp>
#include <fstiff/io/regular_grid.hpp>
#include <fstiff/topography/height_map.hpp>

namespace fstiff::io {

/// What the text of a map does not say itself.
struct MapTextOptions {
    MapForm form = MapForm::automatic;
    std::optional<double> dx{}, dy{};         ///< of a matrix, between points [m]; replace the header's
    std::optional<double> width{}, height{};  ///< of a matrix, columns dx and rows dy [m]; replace the header's
    std::string units{};                      ///< "um,nm" (x and y, heights), "um,um,nm" or "um" (all)
    std::string missing{};                    ///< stands for missing points: "-9999", "void", both, or "none"
    OptionNames names{};                      ///< for messages
};

/// What was decided about a file, and why.
struct MapTextRecord : TextRecord {
    MapForm form{};
    std::string form_from;  ///< why it is triples, or a matrix
    std::string units;      ///< of x and y (where the file needs them) and of the heights
    std::string size_from;  ///< where dx and dy come from
    std::size_t columns{}, rows{};

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// A map, and how its text was taken.
struct MapFromText {
    HeightMap<double> map;
    MapTextRecord record;
};

/// Reads all of \p input; \p name stands for it in messages.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] inline MapFromText read_map(std::istream& input, std::string_view name,
                                          const MapTextOptions& options = {});

/// Reads the file \p path. \throws file_error when it cannot be opened or read.
[[nodiscard]] inline MapFromText read_map(const std::filesystem::path& path, const MapTextOptions& options = {});

namespace detail {

inline constexpr TableRules map_rules{.holds = "rows of numbers"};

/// Everything that reading one map needs to pass between its steps, each of them done once. The text must outlive it.
class MapTextReader {
public:
    MapTextReader(std::string_view text, std::string name)
        : name_(std::move(name)), table_(open_table(text, name_, map_rules)), entries_(header_entries(table_)) {}

    /// The columns of the first row; of all rows once they are read.
    const NumberTable& opened() const { return table_; }
    const std::vector<HeaderEntry>& entries() const { return entries_; }
    /// Reads the rows, once.
    const NumberTable& table(std::string_view missing = {}) {
        if (table_.row_lines.empty()) table_.missing = stated_missing(entries_, missing, name_);
        if (table_.row_lines.empty()) read_rows(table_, name_, map_rules);
        return table_;
    }
    /// The grid of the first two columns, sought once.
    const std::optional<Grid>& grid() {
        if (!grid_) grid_ = grid_of(table());
        return *grid_;
    }
    /// The same lines as a table of other rules, whose rows are yet to be read.
    NumberTable reopened(const TableRules& rules) && {
        NumberTable table;
        table.lines = std::move(table_.lines);
        table.line_count = table_.line_count;
        find_first_row(table, name_, rules);
        return table;
    }

    MapFromText read(const MapTextOptions& options) {
        options_ = options;
        record_.name = name_;
        table(options_.missing).describe(record_);
        if (!table_.missing.from.empty())
            record_.missing_from = table_.missing.text() + ", from " + table_.missing.from;
        given_units_ =
            given_units(options_.units, 3, name_, "one unit, or \"um,nm\" (x and y, heights), or \"um,um,nm\"");
        if (given_units_.size() > 1) lateral_unit_ = given_units_.front();
        stated_ = stated_grid(entries_, lateral_unit_, name_);
        choose_form();
        MapFromText result;
        result.map = record_.form == MapForm::triples ? triples() : matrix();
        located({.file = name_}, [&] { result.map.validate(2); });
        record_.columns = static_cast<std::size_t>(result.map.columns());
        record_.rows = static_cast<std::size_t>(result.map.rows());
        record_.missing = static_cast<std::size_t>(result.map.size() - result.map.present());
        result.record = record_;
        return result;
    }

private:
    bool size_given() const { return options_.dx || options_.dy || options_.width || options_.height; }

    void choose_form() {
        record_.form = options_.form;
        record_.form_from = "options";
        if (options_.form != MapForm::automatic) return;
        record_.form = MapForm::matrix;
        if (table_.columns != 3) {
            record_.form_from = std::to_string(table_.columns) + " columns";
            return;
        }
        if (const auto form = stated_form(entries_)) {
            record_.form = *form;
            record_.form_from = "the header";
            return;
        }
        const bool sized = size_given() || stated_.has_size();
        if (grid().has_value() == sized)
            refuse_file(name_,
                        {"has three columns, ",
                         (sized ? "of which two form a grid, and a stated size: may be x, y, z triples or a "
                                  "matrix; must be told which"
                                : "of which the first two form no regular grid, and no stated size: is "
                                  "neither x, y, z triples nor a matrix; must be told which"),
                         " by ", options_.names.format_as("triples"), " or ", options_.names.format_as("matrix")});
        record_.form = grid() ? MapForm::triples : MapForm::matrix;
        record_.form_from = grid() ? "three columns, the first two of which form a grid" : "a size is stated";
    }

    HeightMap<double> triples() {
        if (table_.columns != 3) refuse_file(name_, {"has ", table_.columns, " columns; triples must have 3: x, y, z"});
        if (size_given())
            refuse_file(name_, {"holds x, y, z triples, whose size is in the file; dx, dy, width and height must not "
                                "be given"});
        for (std::size_t r = 0; r < table_.rows(); ++r)
            if (std::isnan(table_.at(r, 0)) || std::isnan(table_.at(r, 1)))
                refuse_line(name_, table_.row_lines[r], {"has no position; x and y must be finite decimal numbers"});
        if (!grid())
            refuse_file(name_, {"has x and y that lie on no regular grid; must be a raster of equal steps in x and in "
                                "y, of which a tenth of the points at least is there"});
        const GridAxis &x = grid()->x, &y = grid()->y;
        const std::vector<std::string> axes = units_of_triples();
        const double x_unit = unit_factor(axes[0], Dimension::length);
        const double y_unit = unit_factor(axes[1], Dimension::length);
        const double z_unit = unit_factor(axes[2], Dimension::length);
        HeightMap<double> map;
        std::vector<double> z(table_.rows());
        for (std::size_t r = 0; r < z.size(); ++r) z[r] = table_.at(r, 2);
        mark_missing(z.data(), z.size(), table_.missing, name_, options_.names, printable(axes[2], 16),
                     [&](std::size_t r) { return table_.row_lines[r]; });
        for (std::size_t r = 0; r < z.size(); ++r) table_.values[3 * r + 2] = z[r];
        record_.resolution = table_.printed[2].resolution() * z_unit;
        map.heights = heights_on(*grid(), table_, name_) * z_unit;
        record_.size_from = "steps of x and y";
        map.dx = step_of(x, x_unit, stated_.dx);
        map.dy = step_of(y, y_unit, stated_.dy);
        return map;
    }

    /// The step of an axis [m]; as stated in the header when both agree, without the rounding of the positions.
    double step_of(const GridAxis& axis, double unit, const std::optional<StatedGrid::Length>& stated) {
        const double step = axis.step * unit;
        if (!stated) return step;
        if (!(std::abs(step - stated->value) <= 0.01 * step))
            refuse_line(name_, stated->line,
                        {stated->value, " m disagrees with the positions, whose step is ", step, " m; must agree"});
        if (!(std::abs(step - stated->value) <= 1e-9 * step)) return step;
        record_.size_from = "line " + std::to_string(stated->line) + ", with which the steps of x and y agree";
        return stated->value;
    }

    std::vector<std::string> units_of_triples() {
        std::vector<std::string> axes;
        if (!given_units_.empty()) {
            axes = {std::string(given_units_.front()), std::string(given_units_.front()),
                    std::string(given_units_.back())};
            if (given_units_.size() == 3) axes[1] = given_units_[1];
            record_.units_from = "options";
        }
        if (axes.empty()) {
            const TitleUnits found = title_units(table_, 3);
            axes.assign(found.units.begin(), found.units.end());
            record_.units_from = found.from;
        }
        if (axes.empty())
            refuse_file(name_,
                        {"states no units and none are given; must be ", options_.names.given_as("units", "\"um,nm\""),
                         " (x and y, heights), each one of ", accepted_units(Dimension::length)});
        record_.units = "x in " + printable(axes[0], 16) + ", y in " + printable(axes[1], 16) + ", heights in " +
                        printable(axes[2], 16);
        return axes;
    }

    HeightMap<double> matrix() {
        HeightMap<double> map;
        const std::size_t columns = table_.columns, rows = table_.rows();
        if (columns < 2 || rows < 2)
            refuse_file(name_, {"is a matrix of ", columns, " x ", rows, " points; must have at least 2 a side"});
        check_count("columns", stated_.columns, stated_.columns_line, columns);
        check_count("rows", stated_.rows, stated_.rows_line, rows);
        map.dx = spacing("dx", "width", options_.dx, options_.width, stated_.dx, stated_.width, columns);
        map.dy = spacing("dy", "height", options_.dy, options_.height, stated_.dy, stated_.height, rows);
        const double unit = value_unit();
        mark_missing(table_.values.data(), table_.values.size(), table_.missing, name_, options_.names, height_unit_,
                     [&](std::size_t i) { return table_.row_lines[i / columns]; });
        for (const PrintedDigits& printed : table_.printed)
            record_.resolution = (std::max)(record_.resolution, printed.resolution() * unit);
        map.heights = table_.values.take(rows, columns);
        map.heights *= unit;
        return map;
    }

    void check_count(const char* what, const std::optional<std::size_t>& stated, std::size_t line,
                     std::size_t there) const {
        if (stated && *stated != there)
            refuse_line(name_, line, {"states ", *stated, " ", what, " where there are ", there, "; must agree"});
    }

    double spacing(const std::string& step, const std::string& whole, const std::optional<double>& given_step,
                   const std::optional<double>& given_whole, const std::optional<StatedGrid::Length>& stated_step,
                   const std::optional<StatedGrid::Length>& stated_whole, std::size_t count) {
        const auto points = static_cast<double>(count);
        const auto note = [&](const std::string& from) {
            record_.size_from += (record_.size_from.empty() ? "" : ", ") + from;
        };
        if (given_step && given_whole)
            refuse_file(name_, {step, " and ", whole, " are both given; must be one of them"});
        if (given_step || given_whole) {
            located({.file = name_},
                    [&] { require_positive(given_step ? step : whole, *(given_step ? given_step : given_whole)); });
            note((given_step ? step : whole) + " of the options");
            return given_step ? *given_step : *given_whole / points;
        }
        if (stated_step) {
            // also with points - 1 steps, which some programs take for the width
            if (stated_whole && std::abs(stated_whole->value - stated_step->value * (points - 0.5)) >
                                    0.51 * stated_step->value + 0.01 * stated_whole->value)
                refuse_line(name_, stated_whole->line,
                            {"states a ", whole, " that disagrees with the spacing of line ", stated_step->line,
                             "; must agree, or ", step, " be given"});
            note(step + " of line " + std::to_string(stated_step->line));
            return stated_step->value;
        }
        if (stated_whole) {
            note(whole + " of line " + std::to_string(stated_whole->line) + stated_whole->unit_from);
            return stated_whole->value / points;
        }
        if (!stated_.without_unit.empty())
            refuse_line(name_, stated_.without_unit_line,
                        {shown_cell(stated_.without_unit), " has no unit; must be ",
                         options_.names.given_as("units", "\"um,nm\""), " (lengths, heights), or dx and dy be given"});
        refuse_file(name_, {"is a matrix that states no physical size, and none is given; must be ",
                            options_.names.given_steps(), " (between points) or width and height (of the map)"});
    }

    /// One unit of the heights [m].
    double value_unit() {
        if (!given_units_.empty()) {
            height_unit_ = given_units_.back();
            record_.units = "heights in " + height_unit_;
            record_.units_from = "options";
            return unit_factor(given_units_.back(), Dimension::length);
        }
        const auto [unit, factor] = stated_height_unit(entries_, name_);
        if (factor) return conversion_factor(*factor, unit);
        if (const HeaderEntry* const count = find_entry(entries_, "bit2nm")) return nanometres_of_count(*count, unit);
        if (!unit)
            refuse_file(name_,
                        {"states no unit of the heights and none is given; must be ",
                         options_.names.given_as("units", "\"nm\""), ", one of ", accepted_units(Dimension::length)});
        if (!is_unit(unit->value, Dimension::length))
            refuse_line(name_, unit->line,
                        {shown_cell(unit->value),
                         " is no unit of length, and no height conversion factor is stated; must be one of ",
                         accepted_units(Dimension::length)});
        height_unit_ = printable(unit->value, 16);
        record_.units = "heights in " + height_unit_;
        record_.units_from = "line " + std::to_string(unit->line);
        return unit_factor(unit->value, Dimension::length);
    }

    /// "Bit2nm = 0.5" of SPIP: nanometres of a count, where no unit is stated.
    double nanometres_of_count(const HeaderEntry& entry, const HeaderEntry* unit) {
        const auto number = number_in(entry.value, false);
        if (!number || !(*number > 0) || !std::isfinite(*number))
            refuse_line(name_, entry.line, {"Bit2nm ", shown_cell(entry.value), "; must be a number greater than 0"});
        const bool stated = unit && is_unit(unit->value, Dimension::length);
        if (stated && *number != 1)
            refuse_line(name_, entry.line,
                        {"states Bit2nm ", *number, ", line ", unit->line, " the unit ", shown_cell(unit->value),
                         ": heights may be in either; must be ", options_.names.given_as("units", "\"nm\"")});
        height_unit_ = stated ? printable(unit->value, 16) : "counts";
        record_.units = stated ? "heights in " + height_unit_ : "heights in counts of " + number_text(*number) + " nm";
        record_.units_from = "line " + std::to_string(stated ? unit->line : entry.line);
        return stated ? unit_factor(unit->value, Dimension::length) : *number * 1e-9;
    }

    /// "height conversion factor (-> m)=2.9e-8", or "... = 29 nm".
    double conversion_factor(const HeaderEntry& entry, const HeaderEntry* unit) {
        const LeadingNumber number = leading_number(entry.value);
        std::string_view to = trimmed(std::string_view(entry.value).substr(number.length));
        const std::size_t arrow = entry.key.find("->");
        if (to.empty() && arrow != std::string::npos) {
            to = std::string_view(entry.key).substr(arrow + 2);
            to = trimmed(to.substr(0, to.find(')')));
        }
        if (number.status != NumberStatus::ok || !(number.value > 0) || !is_unit(to, Dimension::length))
            refuse_line(name_, entry.line,
                        {shown_cell(entry.value),
                         " is no height conversion factor; must be a positive number with a "
                         "unit of length, such as \"(-> m)=2.9e-8\""});
        const double factor = number.value * unit_factor(to, Dimension::length);
        if (unit && is_unit(unit->value, Dimension::length) &&
            !(std::abs(factor - unit_factor(unit->value, Dimension::length)) <= 1e-6 * factor))
            refuse_line(name_, entry.line,
                        {"states a height conversion factor, line ", unit->line,
                         " a unit of length that disagrees; must agree, or units be given"});
        height_unit_ = unit ? printable(unit->value, 16) : "units";
        record_.units = "heights in " + height_unit_ + " of " + number_text(factor) + " m";
        record_.units_from = "line " + std::to_string(entry.line);
        return factor;
    }

    std::string name_;
    MapTextOptions options_;
    NumberTable table_;
    MapTextRecord record_;
    std::vector<std::string_view> given_units_;
    std::string lateral_unit_, height_unit_;
    std::vector<HeaderEntry> entries_;
    StatedGrid stated_;
    std::optional<std::optional<Grid>> grid_;  // empty until it is sought
};

inline MapFromText read_map_text(NamedBytes file, const MapTextOptions& options) {
    const std::string text = text_of(std::move(file.bytes), file.name, map_rules.holds);
    return MapTextReader(text, file.name).read(options);
}

}  // namespace detail

inline std::vector<std::string> MapTextRecord::sentences() const {
    std::vector<std::string> all = layout_sentences();
    all.insert(all.begin(), std::string("form: ") + (form == MapForm::triples ? "x, y, z triples" : "matrix") +
                                ", from " + form_from);
    all.push_back("units: " + units + ", from " + units_from);
    all.push_back("spacing: from " + size_from);
    all.push_back(points_sentence(std::to_string(columns) + " x " + std::to_string(rows)));
    return all;
}

inline MapFromText read_map(std::istream& input, std::string_view name, const MapTextOptions& options) {
    return detail::read_map_text(detail::read_bytes(input, name), options);
}

inline MapFromText read_map(const std::filesystem::path& path, const MapTextOptions& options) {
    return detail::read_map_text(detail::read_bytes(path, "delimited text"), options);
}

}  // namespace fstiff::io
