// SPDX-License-Identifier: BSD-3-Clause
// The files of a figure: the picture, and its numbers as CSV.
#include "picture/plot.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>
#include "document/output.hpp"

#include <filesystem>

namespace fstiff::cli {

namespace {

std::string figure_csv(const Figure& given) {
    const Figure figure = in_units(given);
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
    const Figure drawn = figure();
    deliver({{file, svg(drawn)}, {table_of(file), figure_csv(drawn)}});
    say_written(report, {file, table_of(file)});
    return report;
}

}  // namespace fstiff::cli
