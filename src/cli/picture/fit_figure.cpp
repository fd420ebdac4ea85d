// SPDX-License-Identifier: BSD-3-Clause
#include "picture/figures.hpp"

#include "picture/panels.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace fstiff::cli {
namespace {

/// \p points from the least pressure on.
std::vector<std::size_t> rising(const std::vector<MeasuredPoint>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a].pressure < points[b].pressure; });
    return order;
}

/// The measured points and, where they have errors, a bar through each.
void draw_measured(Panel& panel, const MeasuredCurve& curve, double factor) {
    PlotLine measured{.label = "measured", .x = {}, .y = {}};
    measured.colour = neutral;
    measured.stroke = Stroke::none;
    measured.marker = Marker::circle;
    for (const std::size_t i : rising(curve.points)) {
        const MeasuredPoint& point = curve.points[i];
        measured.x.push_back(point.pressure / 1e6);
        measured.y.push_back(point.value * factor);
        if (!curve.has_errors) continue;
        PlotLine bar{.label = "", .x = {}, .y = {}};
        bar.colour = neutral;
        for (const double end : {std::max(point.value - point.error, point.value / 10), point.value + point.error}) {
            bar.x.push_back(point.pressure / 1e6);
            bar.y.push_back(end * factor);
        }
        panel.lines.push_back(std::move(bar));
    }
    if (curve.has_errors) measured.label += ", ± standard error";
    panel.lines.push_back(std::move(measured));
}

/// The fitted model from the least pressure to the greatest, many points, so that it is smooth.
PlotLine model_line(const Problem& problem, const Fits& fits, const Fit& fit, double factor) {
    const auto order = rising(fit.points);
    const double least = fit.points[order.front()].pressure, greatest = fit.points[order.back()].pressure;
    std::vector<double> pressures, loads;
    for (int k = 0; k <= 100; ++k) {
        pressures.push_back(least * std::pow(greatest / least, k / 100.0));
        loads.push_back(std::max(pressures.back() + fit.found.all.offset, 1e-6 * pressures.back()));
    }
    PlotLine line{.label = legend_of(fit.law->name, fit.theta, fit.r), .x = {}, .y = {}};
    const auto states = fitted_points(problem, fit, loads);
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (!states[k].ok()) continue;
        const double stiffness = states[k].state.stiffness.value;
        const auto& wave = fits.wave;
        const double value =
            wave ? reflection(wave->stiffness_ratio * stiffness, wave->media, wave->angular_frequency) : stiffness;
        line.x.push_back(pressures[k] / 1e6);
        line.y.push_back(value * factor);
    }
    return line;
}

}  // namespace

Figure fit_figure(const Scene& scene, const MeasuredCurve& curve, const Fits& fits) {
    const double factor = curve.is_reflection ? 1 : unit_of_stiffness.factor;
    Panel above{.title = curve.is_reflection ? "Reflection: measured points and fitted models"
                                             : "Stiffness: measured points and fitted models",
                .x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = curve.is_reflection ? "|R|" : "K/A₀ [GPa/µm]", .logarithmic = !curve.is_reflection},
                .height = 300};
    Panel below{.title = "Residuals",
                .x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = curve.has_errors ? "(model - measured)/error" : "(model - measured)/scatter",
                      .logarithmic = false},
                .windows = {{.label = "±2", .low = -2, .high = 2, .of_y = true}},
                .height = 180,
                .legend = false};
    draw_measured(above, curve, factor);
    double widest = 3;
    constexpr std::array<Marker, 4> markers{Marker::square, Marker::triangle, Marker::diamond, Marker::cross};
    int colour = 0;
    for (const Fit& fit : fits.fits) {
        if (fit.found.status == math::FitStatus::singular) continue;
        PlotLine model = model_line(scene, fits, fit, factor);
        PlotLine residual{.label = model.label, .x = {}, .y = {}};
        residual.colour = model.colour = colour;
        residual.stroke = Stroke::none;
        residual.marker = markers[static_cast<std::size_t>(colour) % markers.size()];
        for (const std::size_t i : rising(fit.points)) {
            residual.x.push_back(fit.points[i].pressure / 1e6);
            residual.y.push_back(fit.found.residuals[i]);
            widest = std::max(widest, 1.1 * std::abs(fit.found.residuals[i]));
        }
        above.lines.push_back(std::move(model));
        below.lines.push_back(std::move(residual));
        ++colour;
    }
    below.y.low = -widest;
    below.y.high = widest;
    Figure figure{.title = "Parameters of " + scene.name + " from " + shown_file(curve.name), .panels = {above}};
    if (!below.lines.empty()) figure.panels.push_back(std::move(below));
    figure.note = "fstiff " FSTIFF_VERSION_TEXT ", " + scene.file + ", " + curve.name;
    return figure;
}

}  // namespace fstiff::cli
