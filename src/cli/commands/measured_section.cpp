// SPDX-License-Identifier: BSD-3-Clause
#include "commands/measured_section.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"

#include <fstiff/measured/sections.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/surface/bearing_curve.hpp>
#include <fstiff/surface/structure_constant.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/islands.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fstiff::cli {
namespace {

/// A long profile keeps the least and greatest height of every one of \p parts stretches; missing points leave gaps.
Panel profile_panel(const Profile<double>& profile) {
    constexpr std::size_t parts = 1000;
    Panel panel{.title = "Measured profile, without its form",
                .x = {.label = "x", .logarithmic = false, .si = "m along"},
                .y = {.label = "height", .logarithmic = false, .si = "m"},
                .height = 200,
                .legend = false};
    PlotLine line{.label = "height", .x = {}, .y = {}};
    const auto add = [&](std::size_t i) {
        line.x.push_back(static_cast<double>(i) * profile.spacing);
        line.y.push_back(profile.heights[i]);
    };
    const std::size_t step = std::max<std::size_t>(1, profile.size() / parts);
    for (std::size_t from = 0; from < profile.size(); from += step) {
        const std::size_t to = std::min(from + step, profile.size());
        std::size_t least = to, greatest = to;
        for (std::size_t i = from; i < to; ++i) {
            if (std::isnan(profile.heights[i])) continue;
            if (least == to || profile.heights[i] < profile.heights[least]) least = i;
            if (greatest == to || profile.heights[i] > profile.heights[greatest]) greatest = i;
        }
        if (least == to) continue;
        add(std::min(least, greatest));
        if (least != greatest) add(std::max(least, greatest));
    }
    panel.lines.push_back(std::move(line));
    return panel;
}

/// The map and its colour bar; for a large map every point shown is the mean of a block.
std::vector<Panel> map_panels(const HeightMap<double>& map) {
    constexpr Eigen::Index most = 400;
    const Eigen::Index step_x = (map.columns() + most - 1) / most, step_y = (map.rows() + most - 1) / most;
    const Eigen::Index columns = (map.columns() + step_x - 1) / step_x, rows = (map.rows() + step_y - 1) / step_y;
    std::vector<double> means;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            double sum = 0;
            int count = 0;
            for (Eigen::Index y = j * step_y; y < std::min((j + 1) * step_y, map.rows()); ++y)
                for (Eigen::Index x = i * step_x; x < std::min((i + 1) * step_x, map.columns()); ++x)
                    if (const double z = map.heights(y, x); !std::isnan(z)) sum += z, ++count;
            const double mean = count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
            means.push_back(mean);
            if (count > 0) low = std::min(low, mean), high = std::max(high, mean);
        }
    std::vector<unsigned char> shades;
    for (const double mean : means)
        shades.push_back(static_cast<unsigned char>(
            std::isnan(mean) ? 255 : std::lround(high > low ? 254 * ((mean - low) / (high - low)) : 127)));
    const double x = static_cast<double>(map.columns()) * map.dx, y = static_cast<double>(map.rows()) * map.dy;
    const double scale = std::min(440 / x, 440 / y);

    Panel heights{
        .title = "Measured map, without its form",
        .x = {.label = "x", .logarithmic = false, .low = 0.0, .high = x, .si = "m along"},
        .y = {.label = "y", .logarithmic = false, .low = 0.0, .high = y, .si = "m along"},
        .image = PlotImage{heat_map_bmp(shades, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)), 0,
                           x, 0, y},
        .width = std::max(60.0, scale * x),
        .height = std::max(60.0, scale * y)};
    std::vector<unsigned char> bar;
    for (int k = 0; k < 255; ++k) bar.push_back(static_cast<unsigned char>(k));
    Panel colours{.x = {.label = "height", .logarithmic = false, .low = low, .high = high, .si = "m"},
                  .y = {.label = "", .logarithmic = false, .low = 0.0, .high = 1.0, .ticks = false},
                  .image = PlotImage{heat_map_bmp(bar, 255, 1), low, high, 0, 1},
                  .width = 440,
                  .height = 18};
    return {heights, colours};
}

/// Height against the share of the surface above it.
Panel bearing_panel(std::span<const double> heights) {
    Panel panel{.title = "Bearing curve",
                .x = {.label = "bearing area [%]", .logarithmic = false, .low = 0.0, .high = 100.0},
                .y = {.label = "height", .logarithmic = false, .si = "m"},
                .height = 200,
                .legend = false};
    const BearingCurve<double> curve = bearing_curve(heights);
    panel.lines.push_back(line_of(
        "height", curve.size(), [&](auto k) { return 100 * curve.share[k]; }, [&](auto k) { return curve.height[k]; }));
    return panel;
}

/// The second differences, which D and G come from, and what the fit gives for them in its window.
void add_structure(Panel& panel, const FractalFit<double>& fit, const std::string& of) {
    const auto& s = fit.second_differences;
    std::vector<std::size_t> shown;  // about as many as can be distinguished
    for (std::size_t k = 0; k < s.size(); ++k)
        if (shown.empty() || s.lag[k] >= 1.08 * s.lag[shown.back()]) shown.push_back(k);
    PlotLine measured = line_of(
        "S₂" + of, shown.size(), [&](auto k) { return s.lag[shown[k]]; }, [&](auto k) { return s.value[shown[k]]; });
    measured.colour = static_cast<int>(panel.lines.size()) / 2;
    measured.stroke = Stroke::none;
    measured.marker = measured.colour == 0 ? Marker::circle : Marker::triangle;
    PlotLine fitted = line_of(
        "D = " + with_unit(fit.fractal.dimension, "", 4, fit.dimension_error) + of, fit.fitted.size(),
        [&](auto k) { return fit.fitted.lag[k]; }, [&](auto k) { return fit.fitted.value[k]; });
    fitted.colour = measured.colour;
    panel.windows.push_back(
        {.label = "window of the fit" + of, .low = fit.window.from, .high = fit.window.to, .colour = measured.colour});
    panel.lines.push_back(std::move(measured));
    panel.lines.push_back(std::move(fitted));
}

constexpr const char* fit_caption =
    "Mean square of the second differences of the heights, and the curve fitted to it, which gives D and G; its ends "
    "bend where the waves end.";

Panel structure_panel() {
    return {.title = "Structure function of second differences",
            .x = {.label = "lag τ", .si = "m"},
            .y = {.label = "S₂", .si = "m^2"},
            .height = 300};
}

/// In 1/µm or 1/mm.
std::string per_length(double value) {
    return std::abs(value) >= 1e6 ? rounded(value * 1e-6) + " 1/µm" : rounded(value * 1e-3) + " 1/mm";
}

/// The profile, its bearing curve and structure function. \returns its peak statistics for a table.
TextRows profile_part(Page& page, const MeasuredSurface& surface) {
    TextRows peaks{{"peak statistics", "value"}};
    const Profile<double>& profile = surface.found.profile->profile;
    show(page, {profile_panel(profile)});
    show(page, {bearing_panel(profile.heights)}, "Height against the share of the profile above it.");
    if (surface.found.profile_fit) {
        Panel panel = structure_panel();
        add_structure(panel, *surface.found.profile_fit, "");
        show(page, {panel}, fit_caption);
    }
    try {
        const PeakStatistics<double> s = peak_statistics(profile);
        peaks.insert(peaks.end(), {{"r (4.1)", rounded(s.r)},
                                   {"θ (4.3) [rad]", rounded(s.theta)},
                                   {"θ/π, share of peaks that Gaussian heights would have", rounded(s.peak_ratio())},
                                   {"share of peaks counted, which differs where heights are not Gaussian",
                                    rounded(s.counted_peak_ratio)},
                                   {"peaks per length", per_length(s.peaks_per_length)},
                                   {"autocorrelation at one sample", rounded(s.rho1)},
                                   {"autocorrelation at two samples", rounded(s.rho2)},
                                   {"rms slope of neighbours", rounded(s.rms_slope)},
                                   {"rms curvature σ_κ of triples", per_length(s.rms_curvature)}});
    } catch (const domain_error& error) {
        page.paragraph("No peak statistics: " + std::string(error.what()));
    }
    return peaks;
}

void islands_figure(Page& page, const MeasuredSurface& surface) {
    try {
        const IslandCurve<double> curve =
            surface.found.islands ? surface.found.islands->curve : island_curve(surface.found.map->map);
        const std::size_t chosen = curve.representative();
        Panel density{.title = "Density of islands",
                      .x = {.label = "bearing area [%]", .logarithmic = false, .low = 0.0, .high = 100.0},
                      .y = {.label = "D_p", .logarithmic = false, .low = 0.0, .si = "1/m^2"},
                      .height = 200};
        Panel radius = density;
        radius.title = "Radius of the mean island";
        radius.y = {.label = "R", .logarithmic = false, .low = 0.0, .si = "m"};
        const auto add = [&](Panel& panel, const char* name, const std::vector<double>& values, std::string_view si) {
            const auto share = [&](auto k) { return 100 * curve.bearing_area[k]; };
            PlotLine point{.label = "level chosen: " + rounded(share(chosen), 3) + " %, " + name + " = " +
                                    with_unit(values[chosen], si, 3),
                           .x = {share(chosen)},
                           .y = {values[chosen]}};
            point.stroke = Stroke::none;
            point.marker = Marker::diamond;
            panel.lines = {line_of("islands above a level", curve.size(), share, [&](auto k) { return values[k]; }),
                           std::move(point)};
        };
        add(density, "D_p", curve.density, "1/m^2");
        add(radius, "R", curve.radius, "m");
        radius.y.high = 4 * curve.radius[chosen];  // that of the few islands at the lowest levels is of no use
        show(page, {density});
        show(page, {radius}, "Islands above a level against the bearing area there, and their radius.");
    } catch (const domain_error& error) {
        page.paragraph("No islands: " + std::string(error.what()));
    }
}

/// The map, its bearing curve, structure functions and islands. \returns its summits for a table.
TextRows map_part(Page& page, const MeasuredSurface& surface) {
    TextRows peaks{{"peak statistics", "value"}};
    const HeightMap<double>& map = surface.found.map->map;
    show(page, map_panels(map), "Map, and the heights of its colours.");
    show(page, {bearing_panel({map.heights.data(), static_cast<std::size_t>(map.size())})},
         "Height against the share of the map above it.");
    if (surface.found.map_fit) {
        const parts::DirectionalFit<double>& fit = *surface.found.map_fit;
        Panel panel = structure_panel();
        if (fit.x) add_structure(panel, *fit.x, " along x");
        if (fit.y) add_structure(panel, *fit.y, " along y");
        for (const auto& [direction, refusal] : {std::pair("x", fit.why_no_fit_x), std::pair("y", fit.why_no_fit_y)})
            if (!refusal.empty()) page.paragraph("No fit along " + std::string(direction) + ": " + refusal);
        if (!panel.lines.empty()) show(page, {panel}, fit_caption);
    }
    const parts::ArealStatistics<double>& a = surface.found.map->areal;
    peaks.insert(peaks.end(), {{"density of summits", with_unit(a.summit_density, "1/m^2")},
                               {"mean curvature of the summits", per_length(a.summit_curvature)},
                               {"mean height of the summits", with_unit(a.summit_height, "m")},
                               {"rms gradient", rounded(a.rms_gradient)},
                               {"α = m0 m4/m2²", rounded(a.nayak)}});
    islands_figure(page, surface);
    return peaks;
}

}  // namespace

void show(Page& page, std::vector<Panel> panels, std::string_view caption, std::vector<std::string> explanation) {
    page.figure(narrow({.title = "", .explanation = std::move(explanation), .panels = std::move(panels)}), caption);
}

void measured_section(Page& page, const MeasuredSurface& surface) {
    page.heading("Measured surface");
    TextRows source{{"source", "value"}, {"file", surface.file}, {"kind", surface.kind}, {"SHA-256", surface.sha256}};
    page.table(source);
    page.begin("div class=\"pair\"");
    page.list(surface.decisions);
    TextRows rows{{"parameter", "value", "found by"}};
    for (const ParameterLine& line : parameter_lines(surface))
        rows.push_back({line.name, with_unit(line.measured.value, line.unit, 5, line.measured.error), line.how});
    page.table(rows);
    page.end("div");
    if (!surface.found.why_no_dimension.empty()) page.paragraph("No D and G: " + surface.found.why_no_dimension);
    if (!surface.found.why_no_peaks.empty()) page.paragraph("No r and θ: " + surface.found.why_no_peaks);

    if (!surface.parts.empty()) return;  // which follow, each by itself
    if (!surface.found.profile && !surface.found.map) {
        page.paragraph("The numbers come from the JSON of fstiff measure, which holds no heights: none are drawn.");
        return;
    }
    page.begin("div class=\"pair\"");
    const TextRows peaks = surface.found.profile ? profile_part(page, surface) : map_part(page, surface);
    if (peaks.size() > 1) page.table(peaks);
    page.end("div");
}

}  // namespace fstiff::cli
