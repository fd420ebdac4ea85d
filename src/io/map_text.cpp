// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_text.hpp"

#include "io/given_lengths.hpp"
#include "io/gridded.hpp"
#include "io/height_sense.hpp"
#include "io/map_steps.hpp"
#include "io/readers.hpp"
#include "io/table_units.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// Turns the numbers of a table into a map.
class MapTextReader {
public:
    MapTextReader(TextTable table, const std::string& name, const SurfaceOptions& options)
        : name_(name), options_(options), table_(std::move(table)) {}

    Reading read() {
        units_ = units_of(table_, options_, name_, record_);
        stated_ = stated_grid(table_.entries, units_.lateral, name_);
        warn_of_lengths();
        RawMap map = is_triples() ? triples() : matrix();
        fstiff::detail::located({.file = name_}, [&] { validate_map(map, 2); });
        describe(map);
        return {std::move(map), std::move(record_)};
    }

private:
    bool is_triples() const { return table_.form == SurfaceFormat::triples; }

    void describe(const RawMap& map) {
        table_.numbers.say_layout(record_, (is_triples() ? "points: " : "matrix: ") + units_.text);
        record_.note("units", units_.text + ", from " + units_.from);
        record_.note("spacing", "from " + size_from_);
        record_.note_points(map, table_.numbers.missing.note());
        if (table_.axes)
            record_.note("axes", "the first row and the first column are " + axes_note_);
        else
            note_columns();
    }

    /// Notes which columns of the file are used, unless all are.
    void note_columns() {
        std::string used, left;
        for (std::size_t c = 0; c < table_.roles.size(); ++c) {
            const Role role = table_.roles[c];
            std::string& list = role == Role::x || role == Role::y || role == Role::heights ? used : left;
            list += (list.empty() ? "" : ", ") + std::to_string(c + 1);
        }
        if (!left.empty())
            record_.note("columns", (is_triples() ? "x, y and heights in " : "") + used + "; left out: " + left);
    }

    RawMap triples() {
        const std::size_t x = *table_.column(Role::x), y = *table_.column(Role::y);
        const NumberTable& numbers = table_.numbers;
        for (std::size_t r = 0; r < numbers.rows(); ++r)
            if (std::isnan(numbers.at(r, x)) || std::isnan(numbers.at(r, y)))
                refuse_line(name_, numbers.row_lines[r], {"has no position; x and y must be finite decimal numbers"});
        if (table_.counts_pixels) {
            units_.x.factor = steps().x(table_.grid->x.count);
            units_.y.factor = steps().y(table_.grid->y.count);
        }
        const bool on_grid = !options_.grid && table_.grid;
        if (!on_grid && !options_.grid)
            refuse_file(name_, {"has x and y that lie on no regular grid; must be a raster of equal steps, a tenth of "
                                "which is there, or be put on one by ",
                                proposed_grid(cloud(column_of(numbers, *table_.column(Role::heights))), name_,
                                              options_.names)});
        const std::vector<double> heights = table_.take_heights(name_, units_.heights.name);
        if (!table_.counts_pixels) size_from_ = on_grid ? "steps of x and y" : "grid of the options";
        RawMap map = on_grid ? map_on_grid(heights) : gridded(cloud(heights), name_, options_, record_);
        turn_over(map, table_.titles[*table_.column(Role::heights)], table_.entries, name_, record_);
        return map;
    }

    /// The \p heights as a map on the grid of their x and y.
    RawMap map_on_grid(const std::vector<double>& heights) {
        const GridAxis &x = table_.grid->x, &y = table_.grid->y;
        RawMap map{
            .heights = heights_on(*table_.grid, table_.numbers, heights, name_), .rows = y.count, .columns = x.count};
        for (double& height : map.heights) height *= units_.heights.factor;
        map.dx = table_.counts_pixels ? units_.x.factor : step_of(x, units_.x.factor, stated_.dx);
        map.dy = table_.counts_pixels ? units_.y.factor : step_of(y, units_.y.factor, stated_.dy);
        record_.resolution = table_.resolution() * units_.heights.factor;
        record_.origin = {x.origin * units_.x.factor, y.origin * units_.y.factor};
        return map;
    }

    PointCloud cloud(const std::vector<double>& heights) const {
        PointCloud cloud{.units = {units_.x.factor, units_.y.factor, units_.heights.factor}};
        const std::size_t x = *table_.column(Role::x), y = *table_.column(Role::y);
        for (std::size_t r = 0; r < heights.size(); ++r)
            cloud.points.push_back({table_.numbers.at(r, x), table_.numbers.at(r, y), heights[r]});
        return cloud;
    }

    /// The step of an axis [m]; as stated in the header when both agree, without the rounding of the positions.
    double step_of(const GridAxis& axis, double unit, const std::optional<StatedGrid::Length>& stated) {
        const double step = axis.step * unit;
        if (!stated) return step;
        if (!(std::abs(step - stated->value) <= 0.01 * step))
            refuse_line(name_, stated->line,
                        {stated->value, " m disagrees with the positions, whose step is ", step, " m; must agree"});
        if (!(std::abs(step - stated->value) <= 1e-9 * step)) return step;
        size_from_ = "line " + std::to_string(stated->line) + ", with which the steps of x and y agree";
        return stated->value;
    }

    RawMap matrix() {
        if (table_.axes) take_axes();
        RawMap map{.heights = {}, .rows = table_.numbers.rows(), .columns = table_.columns(Role::heights).size()};
        check_count("columns", stated_.columns, stated_.columns_line, map.columns);
        check_count("rows", stated_.rows, stated_.rows_line, map.rows);
        map.dx = steps().x(map.columns);
        map.dy = steps().y(map.rows);
        record_.resolution = table_.resolution() * units_.heights.factor;
        map.heights = table_.take_heights(name_, units_.heights.name);
        for (double& z : map.heights) z *= units_.heights.factor;
        turn_over(map, {}, table_.entries, name_, record_);
        return map;
    }

    /// Gives the steps of the axes to what the header states.
    void take_axes() {
        const MatrixAxes& axes = *table_.axes;
        const LengthUnit& unit = units_.x;
        const bool numbers = axes.counted && axes.stated.empty() && units_.lateral.empty();  // of the points
        axes_note_ = numbers ? "numbers of the points" : "positions";
        if (unit.name.empty()) return;
        axes_note_ += " in " + printable(unit.name, 16);
        set_step(stated_.dx, axes.dx * unit.factor, "dx of the positions in line " + std::to_string(axes.line));
        set_step(stated_.dy, axes.dy * unit.factor, "dy of those in column 1");
    }

    void set_step(std::optional<StatedGrid::Length>& slot, double step, const std::string& from) {
        if (slot && !(std::abs(slot->value - step) <= 0.01 * step) && !gives_size(options_))
            refuse_line(name_, slot->line,
                        {slot->value, " m disagrees with the axes, whose step is ", step, " m; must agree"});
        if (!slot) slot = StatedGrid::Length{.value = step, .line = table_.axes->line, .from = from};
    }

    /// Lengths of the header keep their own units, whatever the options are.
    void warn_of_lengths() {
        for (const auto* length : {&stated_.width, &stated_.height, &stated_.dx, &stated_.dy})
            if (!units_.lateral.empty() && *length && !(*length)->unit.empty() &&
                unit_factor((*length)->unit, Dimension::length) != unit_factor(units_.lateral, Dimension::length)) {
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
                .units = asked_units(table_, name_),
                .subject = is_triples() ? "counts pixels, of which it" : "is a matrix that",
                .from = size_from_,
                .warnings = record_.warnings};
    }

    const std::string& name_;
    const SurfaceOptions& options_;
    TextTable table_;
    StatedGrid stated_{};
    Units units_{};
    Record record_{};
    std::string size_from_{};  // where dx and dy come from
    std::string axes_note_{};
};

}  // namespace

}  // namespace detail

Reading read_map(detail::TextTable table, const std::string& name, const SurfaceOptions& options) {
    return detail::MapTextReader(std::move(table), name, options).read();
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
