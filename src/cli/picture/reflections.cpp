// SPDX-License-Identifier: BSD-3-Clause
// The figure of measured reflections: the check that K does not depend on the frequency, and K(p).
#include "picture/plot.hpp"

#include "document/shown_unit.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff::cli {
namespace {

using actions::CurveOfStiffness, actions::LoadOfCurve, document::ShownUnit;

constexpr std::size_t most_loads = 8;

void put(PlotLine& line, double x, double K, double error, const ShownUnit& unit) {
    line.x.push_back(x), line.y.push_back(K * unit.factor);
    line.low.push_back(error < 0.9 * K ? (K - error) * unit.factor : 0);
    line.high.push_back((K + error) * unit.factor);
}

/// The points of \p load, and the line of K by all of them.
void add_load(Panel& panel, const CurveOfStiffness& converted, const LoadOfCurve& load, const ShownUnit& unit,
              int colour) {
    const bool errors = !converted.errors.empty();
    PlotLine points{.bars = errors, .marks = true, .colour = colour}, all{.colour = colour};
    all.label = converted.curve.has_pressures ? document::with_unit(load.pressure, "Pa", 4) : "K by all frequencies";
    const auto [least, most] = std::minmax_element(converted.frequencies.begin(), converted.frequencies.end());
    for (std::size_t i = 0; i < converted.stiffness.size(); ++i) {
        const auto& K = converted.stiffness[i];
        if (K && converted.curve.points[i].pressure == load.pressure)
            put(points, converted.frequencies[i] / 1e6, K->value, K->error, unit);
    }
    for (const double frequency : {*least, *most}) put(all, frequency / 1e6, load.K.value, load.K.error, unit);
    if (!errors) points.low.clear(), points.high.clear();
    if (!(load.K.error > 0)) all.low.clear(), all.high.clear();
    if (!all.low.empty()) all.band = "± standard error";
    panel.lines.push_back(std::move(all));
    panel.lines.push_back(std::move(points));
}

Panel frequency_panel(const CurveOfStiffness& converted, const ShownUnit& unit) {
    Panel panel{.title = "Check: K of a spring does not depend on the frequency",
                .x = {"frequency f [MHz]"},
                .y = {unit.heading("K/A₀")},
                .height = 360};
    int colour = 0;
    for (const LoadOfCurve& load : converted.loads)
        if (load.points > 0 && colour < static_cast<int>(most_loads)) add_load(panel, converted, load, unit, colour++);
    return panel;
}

/// K(p): of the loads of several frequencies, else of the points.
Panel pressure_panel(const CurveOfStiffness& converted, const ShownUnit& unit) {
    Panel panel{.title = "Normal stiffness per nominal area",
                .x = {"nominal pressure p [MPa]"},
                .y = {unit.heading("K/A₀")},
                .height = 300};
    PlotLine line{.label = converted.loads.empty() ? "K" : "K by all frequencies", .bars = true, .marks = true};
    bool errors = true;
    const auto add = [&](double pressure, double K, double error) {
        errors = errors && error > 0;
        put(line, pressure / 1e6, K, error, unit);
    };
    for (const LoadOfCurve& load : converted.loads)
        if (load.points > 0) add(load.pressure, load.K.value, load.K.error);
    for (std::size_t i = 0; converted.loads.empty() && i < converted.stiffness.size(); ++i)
        if (const auto& K = converted.stiffness[i]) add(converted.curve.points[i].pressure, K->value, K->error);
    if (!errors) line.low.clear(), line.high.clear(), line.bars = false;
    if (errors) line.band = "± standard error";
    panel.lines.push_back(std::move(line));
    return panel;
}

}  // namespace

Figure reflections_figure(const actions::Reflection& reflection) {
    const CurveOfStiffness& converted = *reflection.curve;
    std::vector<double> stiffnesses;
    for (const auto& K : converted.stiffness)
        if (K) stiffnesses.push_back(K->value);
    const ShownUnit unit = document::shown_unit(stiffnesses, "Pa/m");
    Figure figure{.title = "Stiffness from the reflection of ultrasound",
                  .note = "fstiff " FSTIFF_VERSION_TEXT ", " + document::printable(converted.curve.name) +
                          ", impedances " + document::rounded(reflection.media.incident / 1e6, 4) + " and " +
                          document::rounded(reflection.media.beyond / 1e6, 4) + " MRayl"};
    figure.explanation = reflection.warnings;
    if (!converted.loads.empty()) figure.panels.push_back(frequency_panel(converted, unit));
    if (converted.curve.has_pressures) figure.panels.push_back(pressure_panel(converted, unit));
    if (converted.loads.size() > most_loads)
        figure.note += "; " + std::to_string(most_loads) + " of " + std::to_string(converted.loads.size()) +
                       " loads are drawn against the frequency";
    return figure;
}

}  // namespace fstiff::cli
