// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --show spectrum: the power spectral density or the autocorrelation of a measured profile or map.
#include "surface/spectrum.hpp"
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "picture/plot.hpp"
#include "picture/scale.hpp"

#include <fstiff/core/version.hpp>

#include <memory>

namespace fstiff::cli {
namespace spectrum_command {
namespace {

struct Options {
    OutputOptions output;
    SpectrumRequest request;
    std::string picture;
};

std::string title_of(const SpectrumRequest& request) {
    return std::string(request.of == SpectrumKind::psd ? "power spectral density" : "autocorrelation function") +
           " of " + shown_name(request.surface.file);
}

std::string table(const SpectrumRequest& request, const SurfaceInput& input, const Spectrum& result) {
    std::string text =
        "fstiff " FSTIFF_VERSION_TEXT ": " + title_of(request) + "\n" + source_lines(input, "  file     ");
    text += std::string(input.surface.is_profile() ? "  Rq       " : "  Sq       ") + shown_length(result.rms_as_read) +
            " as read, " + shown_length(result.rms) + " after removal of the form (" + result.form + ")\n";
    text += "  cut-offs " + sentence_of(result.cut_offs) + "\n";
    text += "  scale    " + result.convention + "\n  by       " + result.source + "\n\n";
    constexpr std::size_t shown = 24;
    const Rows rows = rows_of(result);
    const std::size_t step = (rows.size() + shown - 1) / shown;
    text += rows.text([&](std::size_t i) { return i % step == 0; });
    if (step > 1)
        text += "  every " + std::to_string(step) + ". of " + std::to_string(rows.size()) +
                " rows; all with --format csv\n";
    return text;
}

/// Means over shares of 2 % of q, so that a long spectrum can be seen.
SpectrumCurve thinned(const SpectrumCurve& curve) {
    SpectrumCurve few = curve;
    few.x.clear();
    few.y.clear();
    for (std::size_t i = 0; i < curve.x.size();) {
        double x = 0, y = 0;
        std::size_t end = i;
        for (; end < curve.x.size() && curve.x[end] <= 1.02 * curve.x[i]; ++end) {
            x += curve.x[end];
            y += curve.y[end];
        }
        few.x.push_back(x / static_cast<double>(end - i));
        few.y.push_back(y / static_cast<double>(end - i));
        i = end;
    }
    return few;
}

/// The same horizontal axis in all panels.
void share_x(Figure& figure) {
    Range range;
    for (const Panel& panel : figure.panels)
        for (const PlotLine& line : panel.lines)
            for (const double x : line.x) range.add(x, panel.x.logarithmic);
    if (range.low < range.high && figure.panels.size() > 1)
        for (Panel& panel : figure.panels) panel.x.low = range.low, panel.x.high = range.high;
}

Figure figure_of(const SpectrumRequest& request, const Spectrum& result) {
    const bool psd = request.of == SpectrumKind::psd;
    Figure figure{.title = (psd ? "Power spectral density of " : "Autocorrelation function of ") +
                           shown_file(display_name(request.surface.file)),
                  .panels = {},
                  .note = "fstiff " FSTIFF_VERSION_TEXT ", " + sentence_of(result.cut_offs) +
                          (psd ? "; " + window_of(request) + "; means over 2 % of q" : "")};
    const auto begin_panel = [&](const std::string& title, const std::string& label) {
        figure.panels.push_back(psd ? Panel{.title = title, .x = {.label = "q [rad/µm]"}, .y = {.label = label}}
                                    : Panel{.title = title,
                                            .x = {.label = "lag", .logarithmic = false, .si = "m"},
                                            .y = {.label = label, .logarithmic = false}});
    };
    const bool map = result.curves.size() > 1;
    for (std::size_t k = 0; k < result.curves.size(); ++k) {
        const SpectrumCurve curve = psd ? thinned(result.curves[k]) : result.curves[k];
        // C(q) in m^4 and the sections in m^3 do not share an axis
        if (k == 0) begin_panel(map && psd ? "All directions" : "", psd ? curve.shown : "A");
        if (k == 1 && psd) begin_panel("Sections", "C of a section [µm³]");
        PlotLine line{.label = map ? curve.label : "", .x = curve.x, .y = curve.y};
        for (std::size_t i = 0; psd && i < line.x.size(); ++i) {
            line.x[i] *= curve.x_factor;
            line.y[i] *= curve.factor;
        }
        figure.panels.back().lines.push_back(std::move(line));
    }
    share_x(figure);
    if (!psd) {
        std::vector<PlotLine>& lines = figure.panels.back().lines;
        double end = 0;
        for (const PlotLine& line : lines) end = std::max(end, line.x.back());
        lines.push_back({.label = std::string("0.2, which gives ") + (map ? "Sal and Str" : "Ral"),
                         .x = {0, end},
                         .y = {0.2, 0.2},
                         .colour = neutral,
                         .stroke = Stroke::dashed});
    }
    return figure;
}

Report execute(const Options& options) {
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const SpectrumRequest& request = options.request;
    const SurfaceInput input = read_surface_input(request.surface);
    const Spectrum spectrum = spectrum_of(request, input);
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(figure_of(request, spectrum), options.picture);
    Report made = report(
        answer_of(request, input, spectrum), [&] { return table(request, input, spectrum); },
        [&] { return rows_of(spectrum).csv(); }, options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace spectrum_command

Command add_spectrum(Arguments& command) {
    using namespace spectrum_command;
    auto options = std::make_shared<Options>();
    command.option("file", options->request.surface.file,
                   {.help = "profile or map, as fstiff formats lists them; - is standard input", .required = true});
    command.fields(options->request);
    add_surface_options(command, options->request.surface);
    add_output_options(command, options->output);
    add_picture_option(command, options->picture, "draw the curves");
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
