// SPDX-License-Identifier: BSD-3-Clause
#include "picture/panels.hpp"

#include "picture/scale.hpp"
#include "picture/unit.hpp"

#include <fstiff/contact/linear_law.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/ultrasound/resolvable_stiffness.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace fstiff::cli {
namespace {

constexpr std::size_t most_curves = 8;

/// Those that have points.
std::vector<const Curve*> drawable(const Results& results) {
    std::vector<const Curve*> curves;
    for (const Curve& curve : results.curves)
        if (!curve.states.empty()) curves.push_back(&curve);
    return curves;
}

/// Those that are drawn: all, or so many that they can be told apart, spread over the list.
std::vector<const Curve*> drawn(const Results& results) {
    const std::vector<const Curve*> all = drawable(results);
    if (all.size() <= most_curves) return all;
    std::vector<const Curve*> curves;
    for (std::size_t k = 0; k < most_curves; ++k) curves.push_back(all[k * (all.size() - 1) / (most_curves - 1)]);
    return curves;
}

/// Laws by their colours, the joint distributions of one law by their strokes; where the strokes are not enough, every
/// curve has a colour of its own.
void choose_look(std::vector<PlotLine>& lines, const std::vector<const Curve*>& curves) {
    std::vector<const Law*> laws;
    std::vector<int> same_law;
    bool enough = true;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        auto at = std::find(laws.begin(), laws.end(), curves[k]->law);
        if (at == laws.end()) {
            at = laws.insert(at, curves[k]->law);
            same_law.push_back(0);
        }
        const auto law = at - laws.begin();
        const int before = same_law[static_cast<std::size_t>(law)]++;
        enough = enough && before < 3;
        lines[k].colour = static_cast<int>(law);
        lines[k].stroke = static_cast<Stroke>(std::min(before, 2));
    }
    for (std::size_t k = 0; k < curves.size() && !enough; ++k) {
        lines[k].colour = static_cast<int>(k);
        lines[k].stroke = Stroke::solid;
    }
}

/// K that a wave of the scene's frequency tells from a weld and from a gap.
std::optional<PlotWindow> ultrasonic_window(const Scene& scene) {
    if (!scene.ultrasound) return std::nullopt;
    const Waves& waves = *scene.ultrasound;
    const auto range = resolvable_stiffness(waves.longitudinal, waves.angular());
    if (!range) return std::nullopt;
    return PlotWindow{"|R| " + rounded(range->min_reflection, 2) + " to " + rounded(range->max_reflection, 2) + " at " +
                          rounded(waves.frequency / 1e6, 3) + " MHz",
                      range->low, range->high, true};
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

Panel reflection_panel(const Scene& scene, const Results& results, const char* title, const Impedances<double>& media,
                       double ratio) {
    const auto of = [&](double stiffness) { return reflection(ratio * stiffness, media, scene.ultrasound->angular()); };
    Panel panel = quantity_panel(
        results, {.label = "|R|", .logarithmic = false},
        [&](const ContactState<double>& state) { return of(state.stiffness.value); },
        [&](const SampledBand<double>& band) { return std::pair(of(band.high), of(band.low)); });  // R falls with K
    panel.title = std::string(title) + ", " + rounded(scene.ultrasound->frequency / 1e6) + " MHz";
    frame_reflection(panel);
    return panel;
}

}  // namespace

std::vector<Panel> reflection_panels(const Scene& scene, const Results& results) {
    std::vector<Panel> panels;
    if (!scene.ultrasound) return panels;
    const Waves& waves = *scene.ultrasound;
    panels.push_back(reflection_panel(scene, results, "Reflection of longitudinal waves", waves.longitudinal, 1));
    if (waves.shear)
        panels.push_back(
            reflection_panel(scene, results, "Reflection of shear waves", *waves.shear, results.tangential_ratio));
    return panels;
}

std::string shown_angle(double theta) {
    for (const int n : {3, 4, 5, 6, 8, 10, 12})
        if (std::abs(theta * n / std::numbers::pi - 1) < 1e-12) return "π/" + std::to_string(n);
    return rounded(theta);
}

std::string legend_of(std::string_view law, std::optional<double> theta, std::optional<double> r) {
    std::string text(law);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (theta) text += ", θ = " + shown_angle(*theta) + ", r = " + rounded(*r, 3);
    return text;
}

std::string legend_of(const Curve& curve) { return legend_of(curve.law->name, curve.theta, curve.r); }

Panel stiffness_panel(const Scene& scene, const Results& results) {
    Panel panel = quantity_panel(
        results, {.label = "K/A₀", .si = "Pa/m"},
        [](const ContactState<double>& state) { return state.stiffness.value; },
        [](const SampledBand<double>& band) { return std::pair(band.low, band.high); });
    panel.title = "Normal stiffness per nominal area";
    panel.height = 360;
    if (const auto window = ultrasonic_window(scene)) panel.windows.push_back(*window);
    Range pressures;
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states) pressures.add(state.pressure.value, true);
    if (pressures.low < pressures.high) {
        // a straight line on logarithmic axes: two points are enough
        PlotLine reference{.label = "p/(0.48 σ)", .x = {pressures.low, pressures.high}, .y = {}};
        for (const double p : reference.x) reference.y.push_back(linear_stiffness(p, scene.surface.rms_height));
        reference.colour = neutral;
        reference.stroke = Stroke::dashed;
        panel.lines.push_back(std::move(reference));
    }
    return panel;
}

Panel quantity_panel(const Results& results, Axis axis, const std::function<double(const ContactState<double>&)>& value,
                     const std::function<std::pair<double, double>(const SampledBand<double>&)>& ends) {
    Panel panel{.x = {.label = "nominal pressure p", .si = "Pa"}, .y = std::move(axis), .height = 240};
    const auto curves = drawn(results);
    for (const Curve* curve : curves) {
        PlotLine line{.label = legend_of(*curve), .x = {}, .y = {}};
        for (const auto& state : curve->states) {
            line.x.push_back(state.pressure.value);
            line.y.push_back(value(state));
        }
        if (ends && !curve->band.empty() && curve->band.size() == curve->states.size()) {
            for (const SampledBand<double>& band : curve->band) {
                const auto [low, high] = ends(band);
                line.low.push_back(low);
                line.high.push_back(high);
            }
            line.band = "5 to 95 %";
        }
        panel.lines.push_back(std::move(line));
    }
    choose_look(panel.lines, curves);
    return panel;
}

std::string left_out(const Results& results) {
    const std::size_t all = drawable(results).size(), some = drawn(results).size();
    return some == all ? "" : std::to_string(some) + " of " + std::to_string(all) + " curves are drawn";
}

Figure results_figure(const Scene& scene, const Results& results) {
    if (!scene.needs_stiffness())
        throw domain_error(scene.file + ": output.quantities: must name \"stiffness\" for a picture of K(p)");
    Figure figure{.title = "Contact stiffness: " + scene.name, .panels = {stiffness_panel(scene, results)}};
    for (Panel& panel : reflection_panels(scene, results)) figure.panels.push_back(std::move(panel));
    figure.note = "fstiff " FSTIFF_VERSION ", " + scene.file + ", σ = " + with_unit(scene.surface.rms_height, "m", 4);
    if (const std::string some = left_out(results); !some.empty())
        figure.note += "; " + some + ", fstiff run --format csv has the numbers of all";
    return figure;
}

}  // namespace fstiff::cli
