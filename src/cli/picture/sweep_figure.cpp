// SPDX-License-Identifier: BSD-3-Clause
#include "picture/sweep_figure.hpp"

#include "document/shown_unit.hpp"
#include "picture/panels.hpp"
#include "sweep/rows.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/math/statistics.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace fstiff::cli {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr std::uint64_t most_places = 200, most_lines = 8;

/// Candidates for the horizontal axis or for separate lines: an axis of the grid, or the points of a scene.
struct Dimension {
    std::size_t axis = none;  ///< none: the points
    std::uint64_t count = 1;
    bool numeric = true;
    [[nodiscard]] bool is_points() const { return axis == none; }
};

/// The \p i-th of \p most places that are drawn of \p count, the ends included.
std::uint64_t drawn_place(std::uint64_t i, std::uint64_t count, std::uint64_t most) {
    const double share = static_cast<double>(i) * static_cast<double>(count - 1) / static_cast<double>(most - 1);
    return static_cast<std::uint64_t>(share);
}

/// Whether \p place is drawn of \p count: all are, or \p most of them.
bool is_drawn(std::uint64_t place, std::uint64_t count, std::uint64_t most) {
    if (count <= most) return place < count;
    const std::uint64_t before = drawn_place(place, most, count);
    return drawn_place(before, count, most) == place || drawn_place(before + 1, count, most) == place;
}

using CurveKey = std::tuple<std::string, std::optional<double>, std::optional<double>>;

/// Layout of the picture of a grid.
struct Layout {
    std::optional<Dimension> x, lines;
    std::uint64_t points = 1;
    std::vector<CurveKey> curves;  ///< in the order of the scene
    bool pools = false;            ///< several scenes fall on one place
};

Layout layout_of(const sweep::Grid& grid, const std::string& file) {
    Layout layout;
    std::uint64_t first = 0;
    bool any = false;
    sweep::for_each_row(file, [&](const sweep::Row& row) {
        if (any && row.index != first) return false;
        first = row.index;
        any = true;
        layout.points = std::max<std::uint64_t>(layout.points, row.point + 1);
        const CurveKey curve{std::string(row.law), row.theta, row.r};
        if (std::find(layout.curves.begin(), layout.curves.end(), curve) == layout.curves.end())
            layout.curves.push_back(curve);
        return true;
    });
    std::vector<Dimension> all;
    if (layout.points > 1) all.push_back({none, layout.points, true});
    for (std::size_t i = 0; i < grid.axes.size(); ++i)
        if (!grid.axes[i].drawn && grid.axes[i].count() > 1)
            if (grid.mode == sweep::Mode::product || all.empty() || all.back().is_points())  // others go with the first
                all.push_back({i, grid.axes[i].count(), !grid.axes[i].is_text()});
    std::stable_sort(all.begin(), all.end(), [](const Dimension& a, const Dimension& b) { return a.count > b.count; });
    const auto x = std::find_if(all.begin(), all.end(), [](const Dimension& dimension) { return dimension.numeric; });
    if (x != all.end()) {
        layout.x = *x;
        all.erase(x);
    }
    if (!all.empty()) {
        layout.lines = all.front();
        all.erase(all.begin());
    }
    layout.pools = grid.samples > 1 || std::any_of(all.begin(), all.end(),
                                                   [](const Dimension& dimension) { return !dimension.is_points(); });
    return layout;
}

std::string value_text(const sweep::Grid& grid, const Dimension& dimension, const std::vector<sweep::Value>& values,
                       const sweep::Row& row) {
    if (dimension.is_points()) return "p = " + rounded(row.pressure / 1e6, 3) + " MPa";
    const sweep::Axis& axis = grid.axes[dimension.axis];
    const sweep::Value& value = values[dimension.axis];
    if (axis.is_text()) return axis.texts[value.place];
    const double x = value.number;
    return shown_key(axis.key) + " = " +
           (axis.unit == "m"    ? shown_length(x, 3)
            : axis.unit == "Pa" ? unit_of_pressure(x)(x, 3)
                                : rounded(x, 3) + (axis.unit.empty() ? "" : " " + axis.unit));
}

/// K of the scenes that fall on one place of one line.
using Cells = std::map<std::uint64_t, std::pair<double, std::vector<double>>>;  // place: x, K

struct Series {
    std::string label;
    std::size_t curve;
    std::optional<std::size_t> place;  ///< among the lines of a curve
    Cells cells;
};

PlotLine line_of_cells(Series& series) {
    PlotLine line{.label = series.label, .x = {}, .y = {}};
    const bool one = std::all_of(series.cells.begin(), series.cells.end(),
                                 [](const auto& cell) { return cell.second.second.size() == 1; });
    for (auto& [place, cell] : series.cells) {
        auto& [x, values] = cell;
        std::sort(values.begin(), values.end());
        const std::span<const double> sorted(values);
        line.x.push_back(x);
        line.y.push_back(math::sorted_quantile(sorted, 0.5));
        if (one) continue;
        line.low.push_back(math::sorted_quantile(sorted, 0.05));
        line.high.push_back(math::sorted_quantile(sorted, 0.95));
    }
    if (!one) line.band = shown_band;
    if (line.x.size() == 1) line.marker = Marker::circle;
    return line;
}

/// The share of scenes below K.
PlotLine distribution_of(Series& series) {
    std::vector<double> values;
    for (const auto& [place, cell] : series.cells) values.insert(values.end(), cell.second.begin(), cell.second.end());
    std::sort(values.begin(), values.end());
    PlotLine line{.label = series.label, .x = {}, .y = {}};
    const std::size_t count = std::min<std::size_t>(values.size(), most_places);
    for (std::size_t k = 0; k < count; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        line.x.push_back(math::sorted_quantile(std::span<const double>(values), share));
        line.y.push_back(share);
    }
    return line;
}

Axis horizontal(const sweep::Grid& grid, const Dimension& x) {
    if (x.is_points()) return {.label = "p", .si = "Pa"};
    const sweep::Axis& of = grid.axes[x.axis];
    const auto numbers = [&](std::uint64_t place) { return of.range ? of.range->at(place) : of.numbers[place]; };
    double least = numbers(0), most = least;
    for (const std::uint64_t place : {of.count() - 1, of.count() / 2})
        least = std::min(least, numbers(place)), most = std::max(most, numbers(place));
    Axis axis{.label = shown_key(of.key),
              .logarithmic = least > 0 && ((of.range && of.range->log) || most > 20 * least)};
    if (of.unit == "m" || of.unit == "Pa")
        axis.si = of.unit;
    else if (!of.unit.empty())
        axis.label += " [" + of.unit + "]";
    return axis;
}

/// The lines of \p layout: of each of the first \p curves at most \p lines.
std::vector<Series> series_of(const sweep::Grid& grid, const std::string& file, const Layout& layout,
                              std::size_t curves, std::uint64_t lines) {
    const auto place_in = [](const Dimension& of, const std::vector<sweep::Value>& values, const sweep::Row& row) {
        return of.is_points() ? std::uint64_t(row.point) : values[of.axis].place;
    };
    const bool chooses_point =
        layout.points > 1 && !(layout.x && layout.x->is_points()) && !(layout.lines && layout.lines->is_points());
    const bool several = layout.curves.size() > 1;
    std::map<std::pair<std::size_t, std::uint64_t>, std::size_t> known;
    std::vector<Series> all;
    std::vector<sweep::Value> values;
    sweep::for_each_row(file, [&](const sweep::Row& row) {
        if (!row.stiffness || (chooses_point && row.point != layout.points / 2)) return true;
        grid.values(row.index, values);
        const std::uint64_t at = layout.x ? place_in(*layout.x, values, row) : 0;
        const std::uint64_t line = layout.lines ? place_in(*layout.lines, values, row) : 0;
        if (layout.x && !is_drawn(at, layout.x->count, most_places)) return true;
        if (layout.lines && !is_drawn(line, layout.lines->count, lines)) return true;
        const CurveKey key{std::string(row.law), row.theta, row.r};
        const auto curve = static_cast<std::size_t>(std::find(layout.curves.begin(), layout.curves.end(), key) -
                                                    layout.curves.begin());
        if (curve >= curves) return true;
        const auto [found, is_new] = known.try_emplace({curve, line}, all.size());
        if (is_new)
            all.push_back({(several || !layout.lines ? legend_of(row.law, row.theta, row.r) : "") +
                               (several && layout.lines ? ", " : "") +
                               (layout.lines ? value_text(grid, *layout.lines, values, row) : ""),
                           curve,
                           layout.lines ? std::optional<std::size_t>(line) : std::nullopt,
                           {}});
        auto& [x, stiffness] = all[found->second].cells[at];
        x = !layout.x ? 0 : layout.x->is_points() ? row.pressure : values[layout.x->axis].number;
        stiffness.push_back(*row.stiffness);
        return true;
    });
    if (all.empty()) throw domain_error(file + ": has no K to draw");
    return all;
}

}  // namespace

std::string shown_key(const std::string& key) {
    if (key.starts_with("contact.pressures")) return "p";
    if (key.starts_with("contact.separations")) return "separation";
    std::string text = key.substr(key.rfind('.') + 1);
    for (const char* body : {"upper", "lower"})
        if (key.find("." + std::string(body) + ".") != std::string::npos) text += std::string(", ") + body;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

Figure sweep_figure(const sweep::Grid& grid, const std::string& file) {
    const Layout layout = layout_of(grid, file);
    const std::size_t curves = layout.curves.size();
    const std::uint64_t room = std::max<std::uint64_t>(2, most_lines / std::max<std::size_t>(curves, 1));
    const std::uint64_t lines_each = layout.lines ? std::min(layout.lines->count, room) : 1;
    const std::size_t curves_drawn = std::min<std::size_t>(curves, most_lines / lines_each);
    Panel panel;
    if (layout.x) {
        panel.x = horizontal(grid, *layout.x);
        panel.y = {.label = "K/A₀", .si = "Pa/m"};
    } else {
        panel.x = {.label = "K/A₀", .logarithmic = false, .si = "Pa/m"};
        panel.y = {.label = "share of scenes below", .logarithmic = false, .low = 0.0, .high = 1.0};
    }
    std::vector<std::pair<std::size_t, std::optional<std::size_t>>> kinds;
    for (Series& series : series_of(grid, file, layout, curves_drawn, lines_each)) {
        panel.lines.push_back(layout.x ? line_of_cells(series) : distribution_of(series));
        kinds.emplace_back(series.curve, series.place);
    }
    choose_look(panel.lines, kinds);
    Figure figure{.title = "K over " + std::to_string(grid.size) + " scenes of " + shown_file(grid.file),
                  .panels = {std::move(panel)},
                  .note = "fstiff " FSTIFF_VERSION_TEXT};
    if (layout.pools && layout.x) figure.note += "; lines are medians, bands 5 to 95 % of the scenes at each place";
    const std::size_t lines_of_all = curves * (layout.lines ? layout.lines->count : 1);
    if (const std::string some = some_of(curves_drawn * lines_each, lines_of_all); !some.empty())
        figure.note += "; " + some;
    return figure;
}

}  // namespace fstiff::cli
