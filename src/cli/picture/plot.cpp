// SPDX-License-Identifier: BSD-3-Clause
// The files of a figure: the picture, its numbers as CSV, and a script of gnuplot that draws those.
#include "picture/plot.hpp"

#include "document/output.hpp"
#include "picture/drawing.hpp"
#include "picture/page.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/core/version.hpp>

#include <filesystem>

namespace fstiff::cli {
namespace {

/// In a script of gnuplot: between single quotes nothing but the quote itself means anything.
std::string for_gnuplot(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        if (c == '\'')
            result += "''";
        else
            result += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    return result + "'";
}

}  // namespace

std::string html_page(const Figure& figure) {
    Figure picture = narrow(figure);
    Page page(picture.title);
    picture.title = picture.note = "";
    page.figure(picture, figure.note);
    return page.str();
}

std::string figure_csv(const Figure& given) {
    const Figure figure = in_units(given);
    std::string text = "# fstiff " FSTIFF_VERSION ": the numbers of a picture\n" +
                       csv_line({"curve", "panel", "label", "x_quantity", "x", "y_quantity", "y", "low", "high"});
    std::size_t curve = 0;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        for (const PlotLine& line : panel.lines) {
            ++curve;
            for (std::size_t i = 0; i < line.x.size(); ++i)
                text += csv_line({std::to_string(curve), std::to_string(p + 1), line.label, panel.x.label,
                                  exact(line.x[i]), panel.y.label, exact(line.y[i]),
                                  line.low.empty() ? "" : exact(line.low[i]),
                                  line.high.empty() ? "" : exact(line.high[i])});
        }
    }
    return text;
}

std::string gnuplot_script(const Figure& given, const std::string& csv, const std::string& picture) {
    const Figure figure = in_units(given);
    double height = 40;
    for (const Panel& panel : figure.panels) height += height_of(panel);
    std::string text = "# fstiff " FSTIFF_VERSION ": draws the numbers of " + csv + " with gnuplot" +
                       "\n"
                       "set terminal svg noenhanced size 900," +
                       fixed_text(height, 0) + "\nset output " + for_gnuplot(picture) +
                       "\nset datafile separator ','\nset encoding utf8\nset grid\nset key outside right top\n"
                       "set multiplot layout " +
                       std::to_string(figure.panels.size()) + ",1 title " + for_gnuplot(printable(figure.title)) + "\n";
    for (const std::string& sentence : figure.verdict) text += "# " + printable(sentence) + "\n";
    std::size_t curve = 0;
    for (const Panel& panel : figure.panels) {
        text += "set title " + for_gnuplot(panel.title) + "\nset xlabel " + for_gnuplot(panel.x.label) +
                "\nset ylabel " + for_gnuplot(panel.y.label) + "\n";
        text += std::string(panel.x.logarithmic ? "set" : "unset") + " logscale x\n" +
                (panel.y.logarithmic ? "set" : "unset") + " logscale y\n";
        const Drawing d(panel);
        const auto range = [](const char* name, const Scale& scale) {
            return std::string("set ") + name + " [" + rounded(scale.low(), 6) + ":" + rounded(scale.high(), 6) + "]\n";
        };
        text += range("xrange", d.x_scale) + range("yrange", d.y_scale) + "unset object\n";
        for (std::size_t i = 0; i < panel.windows.size(); ++i) {
            const PlotWindow& window = panel.windows[i];
            const std::string low = shortest(window.low), high = shortest(window.high);
            text += "set object " + std::to_string(i + 1) + " rectangle from " +
                    (window.of_y ? "graph 0,first " + low + " to graph 1,first " + high
                                 : "first " + low + ",graph 0 to first " + high + ",graph 1") +
                    " fillcolor rgb '" +
                    (window.colour == next_colour ? window_colour : colour_of(window.colour)).light +
                    "' fillstyle solid 0.14 noborder behind  # " + window.label + "\n";
        }
        std::string plots;
        for (const PlotLine& line : d.lines) {
            ++curve;
            const auto column = [&](int n) {
                return "($1==" + std::to_string(curve) + "?$" + std::to_string(n) + ":NaN)";
            };
            const auto add = [&](const std::string& what) {
                plots += (plots.empty() ? "plot " : ", \\\n     ") + for_gnuplot(csv) + " skip 2 using " + what;
            };
            const std::string colour = colour_of(line.colour).light;
            if (line.bars)
                add(column(5) + ":7:8:9 with yerrorbars linecolor rgb '" + colour + "' pointtype 0 title " +
                    for_gnuplot(line.band));
            else if (!line.low.empty())
                add(column(5) + ":8:9 with filledcurves fillcolor rgb '" + colour +
                    "' fillstyle transparent solid 0.18 title " + for_gnuplot(line.band));
            const std::string dash = line.stroke == Stroke::dashed   ? " dashtype 2"
                                     : line.stroke == Stroke::dotted ? " dashtype 3"
                                                                     : "";
            const std::string with = line.stroke == Stroke::none ? "points"
                                     : line.marker == Marker::none && (line.x.size() > 2 || line.colour < 0)
                                         ? "lines"
                                         : "linespoints";
            add(column(5) + ":7 with " + with + " linecolor rgb '" + colour + "'" +
                (line.covered > 0 ? " linewidth " + std::to_string(2 + 2 * line.covered) : "") +
                (with == "points" ? "" : dash) +
                (line.label.empty()
                     ? " notitle"
                     : " title " + for_gnuplot(panel.lines[static_cast<std::size_t>(&line - d.lines.data())].label)));
        }
        text += plots.empty() ? "plot NaN notitle\n" : plots + "\n";
    }
    return text + "unset multiplot\n";
}

std::string some_of(std::size_t some, std::size_t all) {
    return some == all ? "" : std::to_string(some) + " of " + std::to_string(all) + " curves are drawn";
}

std::string shown_file(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    return name.empty() ? file : name;
}

PictureFiles::PictureFiles(const std::string& file) : picture(file) {
    const std::filesystem::path path(file);
    if (path.extension() != ".svg" && path.extension() != ".html")
        throw Usage("--plot = \"" + file +
                    "\": must end in .svg or .html; the numbers (.plot.csv) and a script (.plot.gp) are written "
                    "beside it");
    table = std::filesystem::path(path).replace_extension(".plot.csv").string();
    script = std::filesystem::path(path).replace_extension(".plot.gp").string();
}

void keep_for_picture(const std::string& file) {
    const PictureFiles names(file);
    require_writable(file);
    require_own(names.table);
    require_own(names.script);
    for (const std::string& name : names.all()) keep_for_output(name);
}

std::vector<OutputFile> figure_files(const Figure& figure, const std::string& file) {
    const PictureFiles names(file);
    const std::filesystem::path path(file);
    return {{names.picture, path.extension() == ".svg" ? svg(figure) : html_page(figure)},
            {names.table, figure_csv(figure)},
            {names.script, gnuplot_script(figure, std::filesystem::path(names.table).filename().string(),
                                          path.stem().string() + "-gnuplot.svg")}};
}

std::vector<std::string> write_figure(const Figure& figure, const std::string& file) {
    deliver(figure_files(figure, file));
    return PictureFiles(file).all();
}

}  // namespace fstiff::cli
