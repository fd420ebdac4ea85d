// SPDX-License-Identifier: BSD-3-Clause
// The files of a figure: the picture, and its numbers as CSV.
#include "picture/plot.hpp"

#include "document/shown_unit.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <filesystem>

namespace fstiff::cli {

namespace {

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

/// The values of every axis in the unit that fits their size, named in its label.
Figure in_units(Figure figure) {
    for (Panel& panel : figure.panels)
        for (const bool of_y : {false, true}) choose_unit(panel, of_y);
    return figure;
}

std::string figure_csv(const Figure& figure) {
    std::string text = "# fstiff " FSTIFF_VERSION_TEXT ": the numbers of a picture\n" +
                       csv_line({"curve", "panel", "label", "x_quantity", "x", "y_quantity", "y", "low", "high"});
    std::size_t curve = 0;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        for (const PlotLine& line : panel.lines) {
            ++curve;
            for (std::size_t i = 0; i < line.x.size(); ++i)
                text +=
                    csv_line({std::to_string(curve), std::to_string(p + 1), line.label, panel.x.label, exact(line.x[i]),
                              panel.y.label, exact(line.y[i]), line.low.empty() ? "" : exact(line.low[i]),
                              line.high.empty() ? "" : exact(line.high[i])});
        }
    }
    return text;
}

/// trace.svg to trace.plot.csv. \throws Usage unless \p file ends in .svg.
std::string table_of(const std::string& file) {
    const std::filesystem::path path = path_of(file);
    if (path.extension() != ".svg")
        throw Usage("--plot = \"" + file + "\": must end in .svg; the numbers (.plot.csv) are written next to it");
    return name_of_path(std::filesystem::path(path).replace_extension(".plot.csv"));
}

}  // namespace

void keep_for_picture(const std::string& file) {
    if (file.empty()) return;
    const std::string table = table_of(file);
    require_writable(file);
    require_own(table);
    keep_for_output(file);
    keep_for_output(table);
}

Report with_picture(Report report, const std::function<Figure()>& figure, const std::string& file) {
    if (file.empty()) return report;
    const Figure drawn = in_units(figure());
    deliver({{file, svg(drawn)}, {table_of(file), figure_csv(drawn)}});
    say_written(report, {file, table_of(file)});
    return report;
}

}  // namespace fstiff::cli
