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

/// A curve that is drawn, the place of its law and, of a law with a joint distribution, that of the distribution.
struct Chosen {
    const Curve* curve;
    std::size_t law;
    std::optional<std::size_t> peaks;
};

/// The answer, then the laws in the order of the scene, each with those of its curves that have points.
std::vector<std::vector<const Curve*>> by_law(const Results& results) {
    std::vector<std::vector<const Curve*>> laws;
    for (const Curve* curve : shown_curves(results)) {
        if (curve->states.empty()) continue;  // no pressure is within its reach
        const auto same = [&](const auto& of) { return of.front()->law == curve->law && of.front()->by.empty(); };
        const auto at = std::find_if(laws.begin(), laws.end(), same);
        if (at == laws.end())
            laws.push_back({curve});
        else
            at->push_back(curve);
    }
    while (laws.size() > most_curves) {  // the last ones go, but for the truth of the map
        const auto last =
            std::find_if(laws.rbegin(), laws.rend(), [](const auto& of) { return !is_truth(*of.front()); });
        laws.erase(std::next(last).base());
    }
    return laws;
}

/// Curves that are drawn: all, or of every law the same joint distributions, spread over the list, so that all can be
/// distinguished.
std::vector<Chosen> drawn(const Results& results) {
    const auto laws = by_law(results);
    std::size_t most = 1, longest = 1;
    for (const auto& law : laws) longest = std::max(longest, law.size());
    const auto curves_of = [&](std::size_t each) {
        std::size_t sum = 0;
        for (const auto& law : laws) sum += std::min(each, law.size());
        return sum;
    };
    while (most < longest && curves_of(most + 1) <= most_curves) ++most;
    std::vector<Chosen> chosen;
    for (std::size_t law = 0; law < laws.size(); ++law) {
        const std::size_t all = laws[law].size(), some = std::min(all, most);
        for (std::size_t k = 0; k < some; ++k) {
            const std::size_t at = some < 2 ? 0 : k * (all - 1) / (some - 1);
            const Curve* const curve = laws[law][at];
            chosen.push_back({curve, law, curve->theta ? std::optional(at) : std::nullopt});
        }
    }
    return chosen;
}

/// K that a wave of the scene's frequency can distinguish from a weld and from a gap.
std::optional<PlotWindow> ultrasonic_window(const Problem& problem) {
    if (!problem.ultrasound) return std::nullopt;
    const Waves& waves = *problem.ultrasound;
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

/// The band of the stiffness, or the error of boundary elements; a lower end below a tenth of K is drawn at 0.
void add_band(PlotLine& line, const Curve& curve, const Ends& ends) {
    const bool sampled = !curve.band.empty() && curve.band.size() == curve.states.size();
    if (!sampled && !is_truth(curve)) return;
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const double value = curve.states[i].stiffness.value, error = curve.states[i].stiffness.error;
        const parts::SampledBand<double> grid{error < 0.9 * value ? value - error : 0, value, value + error, 0};
        const auto [low, high] = ends(sampled ? curve.band[i] : grid);
        line.low.push_back(low);
        line.high.push_back(high);
    }
    line.bars = !sampled;
    line.band = sampled ? shown_band : "± error";
}

/// A panel against the pressure: \p fill gives the line of a curve its values and its band.
Panel panel_of(const Results& results, Axis axis, const std::function<void(PlotLine&, const Curve&)>& fill) {
    Panel panel{.x = {.label = "nominal pressure p", .si = "Pa"}, .y = std::move(axis), .height = 240};
    std::vector<std::pair<std::size_t, std::optional<std::size_t>>> kinds;
    for (const auto& [curve, law, peaks] : drawn(results)) {
        PlotLine line{.label = legend_of(*curve), .x = {}, .y = {}};
        for (const auto& state : curve->states) line.x.push_back(state.pressure.value);
        fill(line, *curve);
        panel.lines.push_back(std::move(line));
        kinds.emplace_back(law, peaks);
    }
    choose_look(panel.lines, kinds);
    return panel;
}

Panel reflection_panel(const Problem& problem, const Results& results, const char* title,
                       const Impedances<double>& media, double ratio) {
    const auto of = [&](double stiffness) {
        return reflection(ratio * stiffness, media, problem.ultrasound->angular());
    };
    Panel panel = quantity_panel(
        results, {.label = "|R|", .logarithmic = false},
        [&](const ContactState<double>& state) { return of(state.stiffness.value); },
        [&](const parts::SampledBand<double>& band) {
            return std::pair(of(band.high), of(band.low));
        });  // R falls with K
    panel.title = std::string(title) + ", " + rounded(problem.ultrasound->frequency / 1e6) + " MHz";
    frame_reflection(panel);
    return panel;
}

}  // namespace

std::vector<Panel> reflection_panels(const Problem& problem, const Results& results) {
    std::vector<Panel> panels;
    if (!problem.ultrasound) return panels;
    const Waves& waves = *problem.ultrasound;
    panels.push_back(reflection_panel(problem, results, "Reflection of longitudinal waves", waves.longitudinal, 1));
    if (waves.shear)
        panels.push_back(
            reflection_panel(problem, results, "Reflection of shear waves", *waves.shear, results.tangential_ratio));
    return panels;
}

std::vector<Panel> panels_after_stiffness(const Scene& scene, const Results& results) {
    std::vector<Panel> panels;
    const auto add = [&](bool asked, CurveQuantity quantity, const char* title, const char* label) {
        if (!asked) return;
        panels.push_back(panel_of(results, {.label = label}, [&](PlotLine& line, const Curve& curve) {
            for (const std::size_t place : curve.places) {
                const auto end = [&](Statistic one, std::vector<double>& to) {
                    if (const auto found = curve.value_at(place, quantity, one)) to.push_back(*found);
                };
                end(Statistic::value, line.y), end(Statistic::p05, line.low), end(Statistic::p95, line.high);
            }
            if (line.y.empty()) line.x.clear();
            if (!line.low.empty()) line.band = shown_band;
        }));
        panels.back().title = title;
    };
    add(scene.asks(CurveQuantity::loss_factor), CurveQuantity::loss_factor, "Loss factor of a tangential cycle",
        "loss factor");
    add(scene.asks(CurveQuantity::thermal_conductance), CurveQuantity::thermal_conductance,
        "Thermal conductance of the spots", "h [W/(m² K)]");
    add(scene.asks(CurveQuantity::electrical_conductance), CurveQuantity::electrical_conductance,
        "Electrical conductance of the spots", "h [S/m²]");
    return panels;
}

std::string shown_angle(double theta) {
    for (const int n : {3, 4, 5, 6, 8, 10, 12})
        if (std::abs(theta * n / std::numbers::pi - 1) < 1e-12) return "π/" + std::to_string(n);
    return rounded(theta);
}

std::string legend_of(std::string_view law, std::optional<double> theta, std::optional<double> r) {
    std::string text(law);
    if (theta) text += ", θ = " + shown_angle(*theta) + ", r = " + rounded(*r, 3);
    return text;
}

std::string legend_of(const Curve& curve) {
    if (!curve.by.empty()) return "answer (" + laws_of(curve) + ")";
    return legend_of(curve.law->name, curve.theta, curve.r);
}

Panel stiffness_panel(const Problem& problem, const Results& results) {
    Panel panel = quantity_panel(
        results, {.label = "K/A₀", .si = "Pa/m"},
        [](const ContactState<double>& state) { return state.stiffness.value; },
        [](const parts::SampledBand<double>& band) { return std::pair(band.low, band.high); });
    panel.title = "Normal stiffness per nominal area";
    panel.height = 360;
    if (const auto window = ultrasonic_window(problem)) panel.windows.push_back(*window);
    Range pressures;
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states) pressures.add(state.pressure.value, true);
    if (pressures.low <= pressures.high) {
        // a straight line on logarithmic axes: two points are enough
        PlotLine reference{.label = "p/(0.48 σ)", .x = {pressures.low}, .y = {}};
        if (pressures.low < pressures.high) reference.x.push_back(pressures.high);
        const double rms_height = problem.face.parameters.rms_height.value;
        for (const double p : reference.x) reference.y.push_back(parts::linear_stiffness(p, rms_height));
        reference.colour = neutral;
        reference.stroke = Stroke::dashed;
        panel.lines.push_back(std::move(reference));
    }
    return panel;
}

Panel quantity_panel(const Results& results, Axis axis, const std::function<double(const ContactState<double>&)>& value,
                     const Ends& ends) {
    return panel_of(results, std::move(axis), [&](PlotLine& line, const Curve& curve) {
        for (const auto& state : curve.states) line.y.push_back(value(state));
        if (ends) add_band(line, curve, ends);
    });
}

std::string left_out(const Results& results) {
    const auto all = shown_curves(results);
    const auto with_points =
        std::count_if(all.begin(), all.end(), [](const Curve* curve) { return !curve->states.empty(); });
    return some_of(drawn(results).size(), static_cast<std::size_t>(with_points));
}

Figure results_figure(const Scene& scene, const Results& results) {
    if (!scene.needs_stiffness())
        throw domain_error(scene.file + ": output.quantities: must name \"stiffness\" for a picture of K(p)");
    Figure figure{.title = "Contact stiffness: " + scene.name,
                  .explanation = results.short_explanation,
                  .panels = {stiffness_panel(scene, results)}};
    for (Panel& panel : reflection_panels(scene, results)) figure.panels.push_back(std::move(panel));
    for (Panel& panel : panels_after_stiffness(scene, results)) figure.panels.push_back(std::move(panel));
    figure.note = "fstiff " FSTIFF_VERSION_TEXT ", " + scene.file +
                  ", σ = " + with_unit(scene.face.parameters.rms_height.value, "m", 4);
    if (const std::string some = left_out(results); !some.empty())
        figure.note += "; " + some + ", fstiff run --format csv has the numbers of all";
    return figure;
}

}  // namespace fstiff::cli
