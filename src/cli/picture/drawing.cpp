// SPDX-License-Identifier: BSD-3-Clause
#include "picture/drawing.hpp"

#include "document/shown_unit.hpp"

#include <algorithm>

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

/// One unit for all numbers of an axis, by the rule of the tables.
void choose_unit(Panel& panel, bool of_y) {
    Axis& axis = of_y ? panel.y : panel.x;
    if (axis.si.empty()) return;
    std::vector<double> values;
    for (const PlotLine& line : panel.lines)
        if (line.colour != neutral)
            values.insert(values.end(), (of_y ? line.y : line.x).begin(), (of_y ? line.y : line.x).end());
    const ShownUnit unit = shown_unit(values, axis.si);
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

Figure in_units(Figure figure) {
    for (Panel& panel : figure.panels)
        for (const bool of_y : {false, true}) choose_unit(panel, of_y);
    return figure;
}

Drawing::Drawing(const Panel& drawn)
    : panel(drawn),
      lines(coloured(drawn)),
      x_scale(drawn.x, range_of(drawn, false)),
      y_scale(drawn.y, range_of(drawn, true)) {}

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
