// SPDX-License-Identifier: BSD-3-Clause
// The files of a figure: the picture, and its numbers as CSV.
#include "picture/plot.hpp"

#include "document/output.hpp"
#include "picture/page.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>

#include <filesystem>

namespace fstiff::cli {

std::string html_page(const Figure& figure) {
    Figure picture = narrow(figure);
    Page page(picture.title);
    picture.title = picture.note = "";
    page.figure(picture, figure.note);
    return page.str();
}

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

std::string some_of(std::size_t some, std::size_t all) {
    return some == all ? "" : std::to_string(some) + " of " + std::to_string(all) + " curves are drawn";
}

std::string shown_file(const std::string& file) {
    const std::string name = name_of_path(path_of(file).filename());
    return name.empty() ? file : name;
}

PictureFiles::PictureFiles(const std::string& file) : picture(file) {
    const std::filesystem::path path = path_of(file);
    if (path.extension() != ".svg" && path.extension() != ".html")
        throw Usage("--plot = \"" + file +
                    "\": must end in .svg or .html; the numbers (.plot.csv) are written next to it");
    table = name_of_path(std::filesystem::path(path).replace_extension(".plot.csv"));
}

void keep_for_picture(const std::string& file) {
    if (file.empty()) return;
    const PictureFiles names(file);
    require_writable(file);
    require_own(names.table);
    for (const std::string& name : names.all()) keep_for_output(name);
}

std::vector<OutputFile> figure_files(const Figure& figure, const std::string& file) {
    const PictureFiles names(file);
    return {{names.picture, path_of(file).extension() == ".svg" ? svg(figure) : html_page(figure)},
            {names.table, figure_csv(figure)}};
}

std::vector<std::string> write_figure(const Figure& figure, const std::string& file) {
    deliver(figure_files(figure, file));
    return PictureFiles(file).all();
}

Report with_picture(Report report, const std::function<Figure()>& figure, const std::string& file) {
    if (!file.empty()) say_written(report, write_figure(figure(), file));
    return report;
}

}  // namespace fstiff::cli
