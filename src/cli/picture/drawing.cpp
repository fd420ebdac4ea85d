// SPDX-License-Identifier: BSD-3-Clause
#include "picture/drawing.hpp"

#include "document/shown_unit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fstiff::cli {
namespace {

std::vector<PlotLine> coloured(const Panel& panel) {
    std::vector<PlotLine> lines = panel.lines;
    int next = 0;
    for (PlotLine& line : lines)
        if (line.colour == next_colour) line.colour = next++;
    return lines;
}

Range range_of(const Panel& panel, bool of_y) {
    Range range;
    const bool logarithmic = (of_y ? panel.y : panel.x).logarithmic;
    for (const PlotLine& line : panel.lines) {
        for (const auto* values : {of_y ? &line.y : &line.x, of_y ? &line.low : nullptr, of_y ? &line.high : nullptr})
            if (values)
                for (const double value : *values) range.add(value, logarithmic);
    }
    return range;
}

void choose_unit(Panel& panel, bool of_y) {
    Axis& axis = of_y ? panel.y : panel.x;
    if (axis.si.empty()) return;
    Range range = range_of(panel, of_y);
    for (const auto& end : {axis.low, axis.high})
        if (end) range.add(*end, axis.logarithmic);
    const double size = !(range.low <= range.high) ? 0
                        : axis.logarithmic         ? std::sqrt(range.low) * std::sqrt(range.high)
                                                   : std::max(std::abs(range.low), std::abs(range.high));
    const ShownUnit unit = shown_unit(size, axis.si);
    const auto convert = [&](auto&... values) { ((values /= unit.size), ...); };
    for (PlotLine& line : panel.lines) {
        if (!of_y) std::for_each(line.x.begin(), line.x.end(), convert);
        if (of_y)
            for (auto* values : {&line.y, &line.low, &line.high})
                std::for_each(values->begin(), values->end(), convert);
    }
    if (of_y)
        for (PlotWindow& window : panel.windows) convert(window.low, window.high);
    else
        for (PlotChange& change : panel.changes) convert(change.x);
    if (axis.low) convert(*axis.low);
    if (axis.high) convert(*axis.high);
    axis.label = unit.heading(axis.label);
    axis.si.clear();
}

}  // namespace

void choose_look(std::vector<PlotLine>& lines,
                 const std::vector<std::pair<std::size_t, std::optional<std::size_t>>>& kinds) {
    constexpr std::size_t strokes = 3;
    std::set<std::size_t> first, second;
    for (const auto& [one, other] : kinds) {
        first.insert(one);
        if (other) second.insert(*other);
    }
    const auto place = [](const std::set<std::size_t>& all, std::size_t one) {
        return static_cast<std::size_t>(std::distance(all.begin(), all.find(one)));
    };
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto& [one, other] = kinds[k];
        const std::size_t a = place(first, one), b = other ? place(second, *other) : 0;
        std::size_t colour = k, stroke = 0;
        if (second.size() <= strokes)
            colour = a, stroke = b;
        else if (first.size() <= strokes)
            colour = other ? b : second.size() + a, stroke = other ? a : 0;
        lines[k].colour = static_cast<int>(colour);
        lines[k].stroke = static_cast<Stroke>(stroke);
    }
}

Figure in_units(Figure figure) {
    for (Panel& panel : figure.panels)
        for (const bool of_y : {false, true}) choose_unit(panel, of_y);
    return figure;
}

Drawing::Drawing(const Panel& drawn)
    : panel(drawn),
      lines(coloured(drawn)),
      x_scale(drawn.x, range_of(drawn, false)),
      y_scale(drawn.y, range_of(drawn, true)) {
    set_aside();
    tell_apart();
}

/// Lines whose points are at one place become marks with error bars, next to one another.
void Drawing::set_aside() {
    std::vector<PlotLine*> found;
    for (PlotLine& line : lines) {
        double least = std::numeric_limits<double>::infinity(), greatest = -least;
        for (std::size_t i = 0; i < line.x.size(); ++i)
            if (shows(line, i))
                least = std::min(least, place_x(line.x[i])), greatest = std::max(greatest, place_x(line.x[i]));
        if (line.stroke == Stroke::none || line.label.empty() || !(greatest - least < one_place)) continue;
        if (line.marker == Marker::none)
            line.marker = line.colour < 0                 ? Marker::cross
                          : line.stroke == Stroke::dashed ? Marker::square
                          : line.stroke == Stroke::dotted ? Marker::triangle
                                                          : Marker::circle;
        line.stroke = Stroke::none;
        line.bars = !line.low.empty();
        found.push_back(&line);
    }
    const double count = static_cast<double>(found.size()), step = std::min(16.0, panel.width / 2 / count);
    for (std::size_t k = 0; k < found.size(); ++k) found[k]->aside = step * (static_cast<double>(k) - (count - 1) / 2);
}

/// Whether \p upper hides more than half of \p lower: the two are not as far apart as they are wide.
bool Drawing::covers(const PlotLine& upper, const PlotLine& lower) const {
    if (upper.stroke == Stroke::none || lower.stroke == Stroke::none || lower.x.size() < 2 || upper.x != lower.x)
        return false;
    constexpr double width = 2;
    std::size_t seen = 0, hidden = 0;
    for (std::size_t i = 0; i < lower.x.size(); ++i) {
        if (!shows(lower, i)) continue;
        ++seen;
        if (!shows(upper, i)) continue;
        const std::size_t from = i > 0 && shows(lower, i - 1) ? i - 1 : i,
                          to = i + 1 < lower.x.size() && shows(lower, i + 1) ? i + 1 : i;
        const double along = place_x(lower.x[to]) - place_x(lower.x[from]),
                     steep = place_y(lower.y[to]) - place_y(lower.y[from]),
                     apart = std::abs(place_y(upper.y[i]) - place_y(lower.y[i]));
        hidden += apart * (from < to ? std::abs(along) / std::hypot(along, steep) : 1) < width;
    }
    return 2 * hidden > seen;
}

/// Overlapping lines: each is drawn wider and paler than those above it.
void Drawing::tell_apart() {
    for (std::size_t upper = 1; upper < lines.size(); ++upper)
        for (std::size_t lower = upper; lower-- > 0;) {
            PlotLine &under = lines[lower], &over = lines[upper];
            if (over.label.empty() || under.label.empty() || !covers(over, under)) continue;
            if (over.label == panel.lines[upper].label) over.label += " (lies on " + panel.lines[lower].label + ")";
            ++under.covered;
        }
}

std::vector<Entry> Drawing::legend() const {
    std::vector<Entry> result;
    constexpr std::size_t most = 44;  // characters of a line
    for (const PlotLine& line : lines)
        if (!line.label.empty())
            result.push_back({&line, nullptr, wrapped(line.label + (line.band.empty() ? "" : ", " + line.band), most)});
    for (const PlotWindow& window : panel.windows)
        if (!window.label.empty()) result.push_back({nullptr, &window, wrapped(window.label, most)});
    return result;
}

}  // namespace fstiff::cli
