// SPDX-License-Identifier: BSD-3-Clause
#include "picture/panels.hpp"

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

constexpr double MPa = 1e6, GPa_per_um = 1e15;

/// Law and peak density tell themselves apart by colour and stroke: the first density solid, the second dashed.
Stroke stroke_of(const Results& results, const Curve& curve) {
    int before = 0;
    for (const Curve& other : results.curves) {
        if (&other == &curve) break;
        before += other.law == curve.law;
    }
    return before == 0 ? Stroke::solid : before % 2 == 1 ? Stroke::dashed : Stroke::dotted;
}

int colour_of(const Results& results, const Curve& curve) {
    std::vector<const Law*> laws;
    for (const Curve& other : results.curves)
        if (std::find(laws.begin(), laws.end(), other.law) == laws.end()) laws.push_back(other.law);
    return static_cast<int>(std::find(laws.begin(), laws.end(), curve.law) - laws.begin());
}

PlotLine line_of(const Results& results, const Curve& curve) {
    PlotLine line{.label = legend_of(curve), .x = {}, .y = {}};
    line.colour = colour_of(results, curve);
    line.stroke = stroke_of(results, curve);
    if (curve.states.size() == 1) line.marker = Marker::circle;
    for (const auto& state : curve.states) line.x.push_back(state.pressure.value / MPa);
    return line;
}

/// K that a wave of the scene's frequency tells from a weld and from a gap.
std::optional<PlotWindow> ultrasonic_window(const Scene& scene) {
    if (!scene.ultrasound) return std::nullopt;
    const Waves& waves = *scene.ultrasound;
    const auto range = resolvable_stiffness(waves.longitudinal, waves.angular());
    if (!range) return std::nullopt;
    return PlotWindow{"|R| " + rounded(range->min_reflection, 2) + " to " + rounded(range->max_reflection, 2) + " at " +
                          rounded(waves.frequency / 1e6, 3) + " MHz",
                      range->low / GPa_per_um, range->high / GPa_per_um, true};
}

Panel reflection_panel(const Scene& scene, const Results& results, const char* title, const Impedances<double>& media,
                       double ratio) {
    const auto of = [&](double stiffness) { return reflection(ratio * stiffness, media, scene.ultrasound->angular()); };
    Panel panel = quantity_panel(results, "|R|", false,
                                 [&](const ContactState<double>& state) { return of(state.stiffness.value); });
    panel.title = std::string(title) + ", " + rounded(scene.ultrasound->frequency / 1e6) + " MHz";
    panel.y.low = 0.0;
    panel.y.high = 1.0;
    for (std::size_t c = 0; c < results.curves.size(); ++c) {
        const Curve& curve = results.curves[c];
        if (curve.band.empty() || curve.band.size() != curve.states.size()) continue;
        for (const SampledBand<double>& band : curve.band) {  // R falls with K
            panel.lines[c].low.push_back(of(band.high));
            panel.lines[c].high.push_back(of(band.low));
        }
        panel.lines[c].band = "5 to 95 %";
    }
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
    Panel panel{.title = "Normal stiffness per nominal area",
                .x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = "K/A₀ [GPa/µm]"}};
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Curve& curve : results.curves) {
        PlotLine line = line_of(results, curve);
        for (const auto& state : curve.states) {
            line.y.push_back(state.stiffness.value / GPa_per_um);
            if (state.pressure.value > 0) low = std::min(low, state.pressure.value);
            high = std::max(high, state.pressure.value);
        }
        if (curve.band.size() == curve.states.size() && !curve.band.empty()) {
            for (const SampledBand<double>& band : curve.band) {
                line.low.push_back(band.low / GPa_per_um);
                line.high.push_back(band.high / GPa_per_um);
            }
            line.band = "5 to 95 %";
        }
        panel.lines.push_back(std::move(line));
    }
    if (const auto window = ultrasonic_window(scene)) panel.windows.push_back(*window);
    if (low < high) {
        // a straight line on logarithmic axes: two points are enough
        PlotLine reference{.label = "p/(0.48 σ)", .x = {}, .y = {}};
        for (const double p : {low, high}) {
            reference.x.push_back(p / MPa);
            reference.y.push_back(linear_stiffness(p, scene.surface.rms_height) / GPa_per_um);
        }
        reference.colour = neutral;
        reference.stroke = Stroke::dashed;
        panel.lines.push_back(std::move(reference));
    }
    return panel;
}

Panel quantity_panel(const Results& results, std::string label, bool logarithmic,
                     const std::function<double(const ContactState<double>&)>& value) {
    Panel panel{.x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = std::move(label), .logarithmic = logarithmic},
                .height = 240};
    for (const Curve& curve : results.curves) {
        PlotLine line = line_of(results, curve);
        for (const auto& state : curve.states) line.y.push_back(value(state));
        panel.lines.push_back(std::move(line));
    }
    return panel;
}

Figure results_figure(const Scene& scene, const Results& results) {
    if (!scene.needs_stiffness())
        throw domain_error(scene.file + ": output.quantities: must name \"stiffness\" for a picture of K(p)");
    Figure figure{.title = "Contact stiffness: " + scene.name, .panels = {stiffness_panel(scene, results)}};
    for (Panel& panel : reflection_panels(scene, results)) figure.panels.push_back(std::move(panel));
    figure.note =
        "fstiff " FSTIFF_VERSION ", " + scene.file + ", σ = " + rounded(scene.surface.rms_height * 1e6, 4) + " µm";
    return figure;
}

}  // namespace fstiff::cli
