// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_text.hpp"

#include "io/ambiguous_signs.hpp"
#include "io/map_steps.hpp"
#include "io/matrix_unit.hpp"
#include "io/readers.hpp"
#include "io/zygo_xyz.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

struct MapNotes {
    std::string units, units_from;  // of x and y (where the file needs them) and of the heights
    std::string size_from;          // where dx and dy come from
    std::string columns;  // which columns are used, or what the axes are; empty where all are heights or triples
    std::string columns_key = "columns";
};

/// Everything that reading one map needs to pass between its steps. The text must outlive it.
class MapTextReader : public MapTable {
public:
    MapTextReader(MapTable table, SurfaceFormat form, const SurfaceOptions& options)
        : MapTable(std::move(table)), triples_(form == SurfaceFormat::triples), options_(options) {}

    Reading read() {
        table(options_.missing);
        given_units_ =
            given_units(options_.units, 3, name_, "one unit, or \"um,nm\" (x and y, heights), or \"um,um,nm\"");
        if (given_units_.size() > 1) lateral_unit_ = given_units_.front();
        stated_ = stated_grid(entries_, lateral_unit_, name_);
        warn_of_lengths();
        RawMap map = triples_ ? triples() : matrix();
        fstiff::detail::located({.file = name_}, [&] { validate_map(map, 2); });
        describe(map);
        return {std::move(map), std::move(record_)};
    }

private:
    void describe(const RawMap& map) {
        table_.say_layout(record_, (triples_ ? "points: " : "matrix: ") + notes_.units);
        record_.note("units", notes_.units + ", from " + notes_.units_from);
        record_.note("spacing", "from " + notes_.size_from);
        record_.note_points(map, table_.missing.note());
        if (!notes_.columns.empty()) record_.note(notes_.columns_key, notes_.columns);
    }

    static constexpr std::array<const char*, 3> axis_names{"x", "y", "the heights"};

    /// Puts on record which columns of the file are used, unless all are.
    void note_columns() {
        std::string used, left;
        for (std::size_t c = 1; c <= titles_.size(); ++c) {
            std::string& list = std::count(columns_.begin(), columns_.end(), c) > 0 ? used : left;
            list += (list.empty() ? "" : ", ") + std::to_string(c);
        }
        if (!left.empty() && triples_) used = "x, y and heights in " + used;
        if (!left.empty()) notes_.columns = used + "; left out: " + left;
    }

    /// Columns of the file, counted from 0, without that of an axis.
    std::vector<std::size_t> used_columns() const {
        std::vector<std::size_t> used;
        for (const std::size_t c : columns_)
            if (!axes_ || c > 1) used.push_back(c - 1);
        return used;
    }

    RawMap triples() {
        if ((options_.grid && table_.columns > 3) || begins_with_triples()) keep_columns({0, 1, height_column()});
        note_columns();
        if (table_.columns != 3) refuse_file(name_, {"has ", table_.columns, " columns; triples must have 3: x, y, z"});
        const bool pixels = counts_pixels();
        if (gives_size(options_) && !pixels)
            refuse_file(name_, {"holds x, y, z triples, whose size is in the file; dx, dy, width and height must not "
                                "be given"});
        for (std::size_t r = 0; r < table_.rows(); ++r)
            if (std::isnan(table_.at(r, 0)) || std::isnan(table_.at(r, 1)))
                refuse_line(name_, table_.row_lines[r], {"has no position; x and y must be finite decimal numbers"});
        const bool on_grid = !options_.grid && grid().has_value();
        if (!on_grid) refuse_thousands(table_, used_columns(), false, name_);
        const auto units = is_zygo() ? units_of_zygo()
                           : pixels  ? units_of_pixels(grid()->x.count, grid()->y.count)
                                     : units_of_triples();
        if (!on_grid && !options_.grid)
            refuse_file(name_, {"has x and y that lie on no regular grid; must be a raster of equal steps, a tenth of "
                                "which is there, or be put on one by ",
                                proposed_grid(cloud(units, unit_names_), name_, options_.names)});
        RawMap map;
        std::vector<double> z(table_.rows());
        for (std::size_t r = 0; r < z.size(); ++r) z[r] = table_.at(r, 2);
        mark_missing(z.data(), z.size(), table_.missing, table_.wholes[columns_[2] - 1].value(), name_, options_.names,
                     height_unit_, [&](std::size_t r) { return table_.row_lines[r]; });
        refuse_thousands(table_, used_columns(), false, name_);
        for (std::size_t r = 0; r < z.size(); ++r) table_.values[3 * r + 2] = z[r];
        if (!pixels) notes_.size_from = on_grid ? "steps of x and y" : "grid of the options";
        if (on_grid)
            put_on_grid(map, units);
        else
            map = gridded(cloud(units, unit_names_), name_, options_, record_);
        turn_over(map, written_[columns_[2] - 1], entries_, name_, record_);
        return map;
    }

    /// The rows as a map on the grid of their x and y.
    void put_on_grid(RawMap& map, const std::array<double, 3>& units) {
        const GridAxis &x = grid()->x, &y = grid()->y;
        record_.resolution = table_.printed[2].resolution() * units[2];
        map.rows = y.count, map.columns = x.count;
        map.heights = heights_on(*grid(), table_, name_);
        for (double& height : map.heights) height *= units[2];
        map.dx = counts_pixels() ? units[0] : step_of(x, units[0], stated_.dx);
        map.dy = counts_pixels() ? units[1] : step_of(y, units[1], stated_.dy);
        record_.origin = {x.origin * units[0], y.origin * units[1]};
    }

    /// The step of an axis [m]; as stated in the header when both agree, without the rounding of the positions.
    double step_of(const GridAxis& axis, double unit, const std::optional<StatedGrid::Length>& stated) {
        const double step = axis.step * unit;
        if (!stated) return step;
        if (!(std::abs(step - stated->value) <= 0.01 * step))
            refuse_line(name_, stated->line,
                        {stated->value, " m disagrees with the positions, whose step is ", step, " m; must agree"});
        if (!(std::abs(step - stated->value) <= 1e-9 * step)) return step;
        notes_.size_from = "line " + std::to_string(stated->line) + ", with which the steps of x and y agree";
        return stated->value;
    }

    /// The units of x, y and the heights [m].
    std::array<double, 3> units_of_triples() {
        for (const std::size_t column : columns_) refuse_no_length(titles_, column, name_);
        refuse_no_length(entries_, name_);
        FreeColumns free(titles_.size(), true);
        for (std::size_t k = 0; k < 3; ++k) free[columns_[k] - 1] = false;
        if (titles_.size() == 3) free.clear();
        const TitleUnits found = title_units(table_, titles_.size(), free);
        for (std::size_t k = 0; k < 3; ++k) check_factor(written_[columns_[k] - 1], k == 2, options_, name_, record_);
        const double factor = factor_of_heights(entries_, options_, name_, record_);
        std::array<std::string, 3> used, stated;
        if (!found.units.empty())
            for (std::size_t k = 0; k < 3; ++k) stated[k] = found.units[columns_[k] - 1];
        if (!given_units_.empty()) {
            used = {std::string(given_units_.front()), std::string(given_units_.front()),
                    std::string(given_units_.back())};
            if (given_units_.size() == 3) used[1] = given_units_[1];
            notes_.units_from = "options";
            for (std::size_t k = 0; k < 3 && !stated[k].empty(); ++k)
                if (unit_factor(used[k], Dimension::length) != unit_factor(stated[k], Dimension::length))
                    record_.warnings.push_back(contradiction(
                        options_.names, "units", shown_cell(options_.units),
                        found.from + ", which states " + printable(stated[k], 16) + " for " + axis_names[k]));
        } else {
            used = stated;
            notes_.units_from = found.from;
            if (used[0].empty()) units_of_header(used);
        }
        for (std::size_t k = 0; k < 3; ++k)
            if (const std::string& unread = titles_[columns_[k] - 1].unread; used[k].empty() && !unread.empty())
                refuse_line(
                    name_, titles_[columns_[k] - 1].line,
                    {"states the unit ", shown_cell(unread), " for ", axis_names[k],
                     ", which is not understood; must be ", given_as(options_.names, "units", "\"UNIT,UNIT,UNIT\""),
                     ", each one of ", accepted_units(Dimension::length)});
        if (used[0].empty())
            refuse_file(name_, {"states no units and none are given; must be ",
                                given_as(options_.names, "units", "\"UNIT,UNIT\""), " (x and y, heights), each one of ",
                                accepted_units(Dimension::length)});
        height_unit_ = printable(used[2], 16);
        notes_.units =
            "x in " + printable(used[0], 16) + ", y in " + printable(used[1], 16) + ", heights in " + height_unit_;
        return {unit_factor(used[0], Dimension::length), unit_factor(used[1], Dimension::length),
                unit_factor(used[2], Dimension::length) * factor};
    }

    /// The steps of x and y, which count pixels, and the unit of the heights [m].
    std::array<double, 3> units_of_pixels(std::size_t columns, std::size_t rows) {
        const ColumnTitle& heights = titles_[columns_[2] - 1];
        refuse_no_length(titles_, columns_[2], name_);
        check_factor(written_[columns_[2] - 1], true, options_, name_, record_);
        double unit = 0;
        if (given_units_.empty() && heights.has_unit) {
            height_unit_ = printable(heights.unit, 16);
            notes_.units = "x and y count pixels, heights in " + height_unit_;
            notes_.units_from = "line " + std::to_string(heights.line);
            unit = unit_factor(heights.unit, Dimension::length) * factor_of_heights(entries_, options_, name_, record_);
        } else
            unit = value_unit();
        return {steps().x(columns), steps().y(rows), unit};
    }

    /// The units of x, y and the heights by the entries of the header, where it states all.
    void units_of_header(std::array<std::string, 3>& used) {
        const HeaderEntry* const entries[] = {stated_axis_unit(entries_), stated_axis_unit(entries_, true),
                                              stated_height_unit(entries_, name_).unit};
        for (const HeaderEntry* entry : entries)
            if (!entry || !is_unit(entry->value, Dimension::length)) return;
        for (std::size_t k = 0; k < 3; ++k) used[k] = entries[k]->value;
        notes_.units_from = "lines " + std::to_string(entries[0]->line) + " and " + std::to_string(entries[2]->line);
    }

    /// Zygo's x and y are pixels; its heights are in um unless a program was set otherwise.
    std::array<double, 3> units_of_zygo() {
        const double pixel = zygo_pixel(table_.lines, name_);
        height_unit_ = given_units_.empty() ? "um" : printable(given_units_.back(), 16);
        notes_.units = "x and y in pixels of " + number_text(pixel) + " m, heights in " + height_unit_;
        notes_.units_from = given_units_.empty() ? "line 8" : "line 8 and options";
        if (given_units_.empty())
            record_.warnings.push_back(
                "Zygo XYZ states no unit of its heights, which are taken for um; another must be " +
                given_as(options_.names, "units", "\"nm\""));
        return {pixel, pixel, unit_factor(height_unit_, Dimension::length)};
    }

    RawMap matrix() {
        RawMap map;
        note_columns();
        if (axes_) take_axes();
        const std::size_t columns = table_.columns, rows = table_.rows();
        if (columns < 2 || rows < 2)
            refuse_file(name_, {"is a matrix of ", columns, " x ", rows, " points; must have at least 2 a side"});
        check_count("columns", stated_.columns, stated_.columns_line, columns);
        check_count("rows", stated_.rows, stated_.rows_line, rows);
        map.dx = steps().x(columns);
        map.dy = steps().y(rows);
        const double unit = value_unit();
        LoneWhole whole;
        for (const std::size_t c : used_columns()) whole.add(table_.wholes[c]);
        mark_missing(table_.values.data(), table_.values.size(), table_.missing, whole.value(), name_, options_.names,
                     height_unit_, [&](std::size_t i) { return table_.row_lines[i / columns]; });
        refuse_thousands(table_, used_columns(), true, name_);
        for (std::size_t c = 0; c < std::min<std::size_t>(table_.printed.size(), 3); ++c)
            record_.resolution = (std::max)(record_.resolution, table_.printed[c].resolution() * unit);
        map.rows = rows;
        map.columns = columns;
        map.heights = std::move(table_.values);
        for (double& z : map.heights) z *= unit;
        turn_over(map, {}, entries_, name_, record_);
        return map;
    }

    /// Gives the steps of the axes to what the header states, and takes them out of the table.
    void take_axes() {
        const bool numbers = lateral_unit_.empty() && axes_->stated.empty() && axes_->counted;  // of the points
        std::string unit = lateral_unit_;
        if (unit.empty() && axes_->stated.size() == 1) unit = axes_->stated.front();
        if (unit.empty() && !given_units_.empty()) unit = given_units_.front();
        if (axes_->stated.size() == 1 &&
            unit_factor(unit, Dimension::length) != unit_factor(axes_->stated.front(), Dimension::length))
            record_.warnings.push_back(contradiction(options_.names, "units", shown_cell(options_.units),
                                                     "line " + std::to_string(axes_->line) + ", which states " +
                                                         printable(axes_->stated.front(), 16) + " for the axes"));
        if (!numbers && unit.empty() && !gives_size(options_) && !stated_.has_size())
            refuse_line(name_, axes_->line,
                        {"holds positions, whose unit is ",
                         axes_->stated.empty() ? "not stated" : "stated twice, with two values", "; must be ",
                         given_as(options_.names, "units", units_text()), " (positions, heights)"});
        if (!numbers && !unit.empty()) {
            const double factor = unit_factor(unit, Dimension::length);
            set_step(stated_.dx, axes_->dx * factor, "dx of the positions in line " + std::to_string(axes_->line));
            set_step(stated_.dy, axes_->dy * factor, "dy of those in column 1");
        }
        notes_.columns_key = "axes";
        notes_.columns = "the first row and the first column are " +
                         (numbers ? std::string("numbers of the points")
                                  : "positions" + (unit.empty() ? std::string() : " in " + printable(unit, 16)));
        drop_axes(table_, *axes_);
    }

    void set_step(std::optional<StatedGrid::Length>& slot, double step, const std::string& from) {
        if (slot && !(std::abs(slot->value - step) <= 0.01 * step) && !gives_size(options_))
            refuse_line(name_, slot->line,
                        {slot->value, " m disagrees with the axes, whose step is ", step, " m; must agree"});
        if (!slot) slot = StatedGrid::Length{.value = step, .line = axes_->line, .from = from};
    }

    /// Lengths of the header keep their own units, whatever the options are.
    void warn_of_lengths() {
        for (const auto* length : {&stated_.width, &stated_.height, &stated_.dx, &stated_.dy})
            if (!lateral_unit_.empty() && *length && !(*length)->unit.empty() &&
                unit_factor((*length)->unit, Dimension::length) != unit_factor(lateral_unit_, Dimension::length)) {
                record_.warnings.push_back(options_.names.prefix + "units" + options_.names.equals +
                                           shown_cell(options_.units) + " contradicts line " +
                                           std::to_string((*length)->line) + ", which states a length in " +
                                           printable((*length)->unit, 16) + "; that length is used");
                return;
            }
    }

    void check_count(const char* what, const std::optional<std::size_t>& stated, std::size_t line,
                     std::size_t there) const {
        if (stated && *stated != there)
            refuse_line(name_, line, {"states ", *stated, " ", what, " where there are ", there, "; must agree"});
    }

    /// The steps of a matrix, or of pixels, by the options and the header.
    MapSteps steps() {
        return {.options = options_,
                .stated = stated_,
                .name = name_,
                .units = units_text(),
                .subject = triples_ ? "counts pixels, of which it" : "is a matrix that",
                .from = notes_.size_from,
                .warnings = record_.warnings};
    }

    /// How messages call the units that are to be given: that of the heights by its name where the header states it.
    std::string units_text() const {
        const HeaderEntry* const unit = stated_height_unit(entries_, name_).unit;
        const bool known = unit && is_unit(unit->value, Dimension::length);
        return "\"UNIT," + (known ? printable(unit->value, 16) : std::string("UNIT")) + "\"";
    }

    /// One unit of the heights [m].
    double value_unit() {
        const std::string_view given = given_units_.empty() ? std::string_view() : given_units_.back();
        MatrixUnit unit = matrix_unit(entries_, given, name_, options_.names);
        if (!unit.contradicted.empty())
            record_.warnings.push_back(
                contradiction(options_.names, "units", shown_cell(options_.units), unit.contradicted));
        height_unit_ = std::move(unit.shown);
        notes_.units = "heights in " + unit.text;
        notes_.units_from = std::move(unit.from);
        return unit.factor;
    }

    bool triples_;  // else a matrix
    const SurfaceOptions& options_;
    MapNotes notes_;
    Record record_;
    std::vector<std::string_view> given_units_;
    std::string lateral_unit_, height_unit_;
    std::array<std::string, 3> unit_names_;  // of x, y and the heights
    StatedGrid stated_;
};

}  // namespace

}  // namespace detail

Reading read_map(detail::MapTable table, SurfaceFormat form, const SurfaceOptions& options) {
    return detail::MapTextReader(std::move(table), form, options).read();
}

namespace detail {

extern constexpr Reader triples_reader{.format = SurfaceFormat::triples,
                                       .endings = ".xyz .csv .txt ...",
                                       .holds = "text: x, y, z in a line",
                                       .recognised = "three columns that fill a rectangular grid, or --grid",
                                       .asks_for = "--units without a header that has them, --grid of scattered points",
                                       .options = "units dx dy width height missing thousands channel grid"};

extern constexpr Reader matrix_reader{
    .format = SurfaceFormat::matrix,
    .endings = ".txt .asc .csv ...",
    .holds = "text: a row of the map in a line; exports of Gwyddion in any language, Keyence, SPIP, ESRI",
    .recognised = "four columns and more, or a size in the header or by --dx or --width",
    .asks_for = "--units, and --dx and --dy or --width and --height, without a header that has them",
    .options = "units dx dy width height missing thousands channel"};

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
