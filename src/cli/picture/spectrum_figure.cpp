// SPDX-License-Identifier: BSD-3-Clause
#include "document/shown_unit.hpp"
#include "picture/figures.hpp"
#include "picture/scale.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>

namespace fstiff::cli {
namespace {

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

}  // namespace

Figure spectrum_figure(const SpectrumRequest& request, const Spectrum& spectrum) {
    const bool psd = request.of == SpectrumKind::psd;
    Figure figure{.title = (psd ? "Power spectral density of " : "Autocorrelation function of ") +
                           shown_file(display_name(request.surface.file)),
                  .panels = {},
                  .note = "fstiff " FSTIFF_VERSION_TEXT ", " + sentence_of(spectrum.cut_offs) +
                          (psd ? "; " + window_of(request) + "; means over 2 % of q" : "")};
    const auto begin_panel = [&](const std::string& title, const std::string& label) {
        figure.panels.push_back(psd ? Panel{.title = title, .x = {.label = "q [rad/µm]"}, .y = {.label = label}}
                                    : Panel{.title = title,
                                            .x = {.label = "lag", .logarithmic = false, .si = "m"},
                                            .y = {.label = label, .logarithmic = false}});
    };
    const bool map = spectrum.curves.size() > 1;
    for (std::size_t k = 0; k < spectrum.curves.size(); ++k) {
        const SpectrumCurve curve = psd ? thinned(spectrum.curves[k]) : spectrum.curves[k];
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

}  // namespace fstiff::cli
