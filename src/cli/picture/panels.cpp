// SPDX-License-Identifier: BSD-3-Clause
#include "picture/panels.hpp"

#include "document/shown_unit.hpp"
#include "picture/scale.hpp"

#include <fstiff/contact/linear_law.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/ultrasound/propagation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace fstiff::cli {
namespace {

constexpr std::size_t most_curves = 8;

/// Boundary elements, whose error is that of their grid.
bool is_truth(const Curve& curve) { return curve.law->name == "boundary_elements"; }

/// The answer, then the laws in the order of the scene; of many curves the first ones, and the truth of a map.
std::vector<const Curve*> drawn(const Results& results) {
    std::vector<const Curve*> curves = shown_curves(results);
    std::erase_if(curves, [](const Curve* curve) { return curve->states.empty(); });  // no pressure is within its reach
    while (curves.size() > most_curves) {
        const auto last = std::find_if(curves.rbegin(), curves.rend(), [](const auto* of) { return !is_truth(*of); });
        curves.erase(std::next(last).base());
    }
    return curves;
}

/// "π/4", or the angle in five digits.
std::string shown_angle(double theta) {
    for (const int n : {3, 4, 5, 6, 8, 10, 12})
        if (std::abs(theta * n / std::numbers::pi - 1) < 1e-12) return "π/" + std::to_string(n);
    return rounded(theta);
}

/// "fractal, θ = π/4, r = 0", or "answer (hybrid)".
std::string legend_of(const Curve& curve) {
    if (!curve.by.empty()) return "answer (" + laws_of(curve) + ")";
    std::string text(curve.law->name);
    if (curve.theta) text += ", θ = " + shown_angle(*curve.theta) + ", r = " + rounded(*curve.r, 3);
    return text;
}

/// K that a wave of the scene's frequency can distinguish from a weld and from a gap.
std::optional<PlotWindow> ultrasonic_window(const Problem& problem) {
    if (!problem.ultrasound) return std::nullopt;
    const Waves& waves = *problem.ultrasound;
    const auto range = resolvable_stiffness(waves.longitudinal, waves.angular());
    if (!range) return std::nullopt;
    return PlotWindow{"|R| " + rounded(range->min_reflection, 2) + " to " + rounded(range->max_reflection, 2) + " at " +
                          rounded(waves.frequency / 1e6, 3) + " MHz",
                      range->low, range->high};
}

/// The frame leaves room about 0 and 1; what is all close to one of them fills it.
void frame_reflection(Panel& panel) {
    double least = 1, greatest = 0;
    for (const PlotLine& line : panel.lines)
        for (const auto* values : {&line.y, &line.low, &line.high})
            for (const double value : *values) least = std::min(least, value), greatest = std::max(greatest, value);
    const bool high = least > 0.8, low = greatest < 0.2 && greatest > 0;
    const double span = high ? std::max(1 - least, 1e-6) : low ? greatest : 1;
    panel.y.low = (high ? 1 - span : 0) - 0.04 * span;
    panel.y.high = (low ? span : 1) + 0.04 * span;
}

/// \p quantity of \p curve, with the ends of its band or, of boundary elements, with the error of K as bars.
PlotLine line_of(const Curve& curve, CurveQuantity quantity) {
    PlotLine line{.label = legend_of(curve), .x = {}, .y = {}};
    const bool of_grid = quantity == CurveQuantity::stiffness && is_truth(curve) && curve.band.empty();
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const auto at = [&](Statistic statistic) { return curve.value_at(curve.places[i], quantity, statistic); };
        const auto value = at(Statistic::value), low = at(Statistic::p05), high = at(Statistic::p95);
        if (!value) continue;
        line.x.push_back(curve.states[i].pressure.value);
        line.y.push_back(*value);
        if (low && high)
            line.low.push_back(std::min(*low, *high)), line.high.push_back(std::max(*low, *high));
        else if (const auto error = at(Statistic::error); error && of_grid)
            line.low.push_back(*error < 0.9 * *value ? *value - *error : 0), line.high.push_back(*value + *error);
    }
    if (line.low.size() != line.x.size()) line.low.clear(), line.high.clear();
    if (!line.low.empty()) line.band = of_grid ? "± error" : shown_band;
    line.bars = of_grid || line.x.size() == 1;  // where a band has no width
    return line;
}

/// \p quantity of all curves that are drawn, against the pressure, with marks at the points of \p results.
Panel panel_of(const Results& results, const Results& smooth, CurveQuantity quantity, std::string title, Axis axis) {
    Panel panel{.title = std::move(title),
                .x = {.label = "nominal pressure p", .si = "Pa"},
                .y = std::move(axis),
                .height = 240};
    const auto lines = drawn(smooth), points = drawn(results);
    for (const Curve* curve : lines) {
        panel.lines.push_back(line_of(*curve, quantity));
        panel.lines.back().colour = static_cast<int>(panel.lines.size()) - 1;
    }
    constexpr std::size_t most_marks = 12;
    if (points.empty() || points.size() != lines.size()) return panel;
    const std::size_t count = points.front()->states.size();
    if (count > most_marks || count == lines.front()->states.size()) return panel;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        PlotLine marks = line_of(*points[k], quantity);
        marks.label = "", marks.low.clear(), marks.high.clear();
        marks.colour = static_cast<int>(k);
        marks.points = true;
        panel.lines.push_back(std::move(marks));
    }
    return panel;
}

/// Where the law of the answer changes.
std::vector<PlotChange> changes_of(const Results& results) {
    std::vector<PlotChange> changes;
    if (!results.answer) return changes;
    const Curve& curve = results.answer->curve;
    for (std::size_t i = 1; i < curve.states.size(); ++i)
        if (const auto& before = curve.law_at(i - 1), &after = curve.law_at(i); &before != &after)
            changes.push_back({std::sqrt(curve.states[i - 1].pressure.value * curve.states[i].pressure.value),
                               std::string(before.name), std::string(after.name)});
    return changes;
}

/// K, with the law of light loads for comparison.
Panel stiffness_panel(const Problem& problem, const Results& results, const Results& smooth) {
    Panel panel = panel_of(results, smooth, CurveQuantity::stiffness, "Normal stiffness per nominal area",
                           {.label = "K/A₀", .si = "Pa/m"});
    panel.height = 360;
    panel.changes = changes_of(smooth);
    if (const auto window = ultrasonic_window(problem)) panel.windows.push_back(*window);
    Range pressures;
    for (const PlotLine& line : panel.lines)
        for (const double p : line.x) pressures.add(p, true);
    if (!(pressures.low <= pressures.high)) return panel;
    // a straight line on logarithmic axes: two points are enough
    PlotLine reference{.label = "p/(0.48 σ)", .x = {pressures.low}, .y = {}};
    if (pressures.low < pressures.high) reference.x.push_back(pressures.high);
    const double rms_height = problem.face.parameters.rms_height.value;
    for (const double p : reference.x) reference.y.push_back(parts::linear_stiffness(p, rms_height));
    reference.colour = neutral;
    reference.dashed = true;
    panel.lines.push_back(std::move(reference));
    return panel;
}

}  // namespace

Figure results_figure(const Scene& scene, const Results& results, const Results& smooth) {
    if (!scene.needs_stiffness())
        throw domain_error(scene.file + ": output.quantities: must name \"stiffness\" for a picture of K(p)");
    Figure figure{.title = "Contact stiffness: " + scene.name,
                  .explanation = results.short_explanation,
                  .panels = {stiffness_panel(scene, results, smooth)}};
    const auto add = [&](CurveQuantity quantity, const std::string& title, Axis axis) {
        if (scene.asks(quantity)) figure.panels.push_back(panel_of(results, smooth, quantity, title, std::move(axis)));
    };
    using enum CurveQuantity;
    const Axis amplitude{.label = "|R|", .logarithmic = false};
    const std::string waves = scene.ultrasound ? ", " + rounded(scene.ultrasound->frequency / 1e6) + " MHz" : "";
    add(reflection, "Reflection of longitudinal waves" + waves, amplitude);
    add(shear_reflection, "Reflection of shear waves" + waves, amplitude);
    for (Panel& panel : figure.panels)
        if (panel.y.label == "|R|") frame_reflection(panel);
    add(loss_factor, "Loss factor of a tangential cycle", {.label = "loss factor"});
    add(thermal_conductance, "Thermal conductance of the spots", {.label = "h [W/(m² K)]"});
    add(thermal_conductance_gap, "Thermal conductance of the gap", {.label = "h [W/(m² K)]"});
    add(electrical_conductance, "Electrical conductance of the spots", {.label = "h [S/m²]"});
    figure.note = "fstiff " FSTIFF_VERSION_TEXT ", " + scene.file +
                  ", σ = " + with_unit(scene.face.parameters.rms_height.value, "m", 4);
    const auto all = shown_curves(results);
    const auto with_points =
        std::count_if(all.begin(), all.end(), [](const Curve* curve) { return !curve->states.empty(); });
    if (with_points > static_cast<std::ptrdiff_t>(most_curves))
        figure.note += "; " + std::to_string(most_curves) + " of " + std::to_string(with_points) +
                       " curves are drawn, fstiff run --format csv has the numbers of all";
    return figure;
}

}  // namespace fstiff::cli
