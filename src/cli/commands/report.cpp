// SPDX-License-Identifier: BSD-3-Clause
// fstiff report: a scene and all that follows from it, on one page that needs nothing else.
#include "commands/commands.hpp"
#include "commands/scales.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "picture/page.hpp"
#include "picture/panels.hpp"
#include "picture/unit.hpp"
#include "surface/documents.hpp"
#include "scene/result_rows.hpp"
#include "scene/results.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/validity/checks.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/measured/sections.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/surface/bearing_curve.hpp>
#include <fstiff/surface/structure_constant.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/islands.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <span>

namespace fstiff::cli {
namespace report_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string folder;
};

using Rows = std::vector<std::vector<std::string>>;
constexpr double um = 1e-6;

/// A figure as wide as a phone can show, with its legend below.
void show(Page& page, std::vector<Panel> panels, std::string_view caption = "", std::vector<std::string> verdict = {}) {
    page.figure(narrow({.title = "", .verdict = std::move(verdict), .panels = std::move(panels)}), caption);
}

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

/// The map, and the bar that tells its colours; of a large map every point shown is the mean of a block.
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
    for (Eigen::Index j = rows; j-- > 0;)  // a picture begins at the top
        for (Eigen::Index i = 0; i < columns; ++i) {
            const double mean = means[static_cast<std::size_t>(j * columns + i)];
            shades.push_back(std::isnan(mean) ? static_cast<unsigned char>(255)
                                              : static_cast<unsigned char>(std::lround(
                                                    high > low ? 254 * ((mean - low) / (high - low)) : 127)));
        }
    const double x = static_cast<double>(map.columns()) * map.dx, y = static_cast<double>(map.rows()) * map.dy;
    const double scale = std::min(440 / x, 440 / y);

    Panel heights{
        .title = "Measured map, without its form",
        .x = {.label = "x", .logarithmic = false, .low = 0.0, .high = x, .si = "m along"},
        .y = {.label = "y", .logarithmic = false, .low = 0.0, .high = y, .si = "m along"},
        .image = PlotImage{heat_map_png(shades, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)), 0,
                           x, 0, y},
        .width = std::max(60.0, scale * x),
        .height = std::max(60.0, scale * y)};
    std::vector<unsigned char> bar;
    for (int k = 0; k < 255; ++k) bar.push_back(static_cast<unsigned char>(k));
    Panel colours{.x = {.label = "height", .logarithmic = false, .low = low, .high = high, .si = "m"},
                  .y = {.label = "", .logarithmic = false, .low = 0.0, .high = 1.0, .ticks = false},
                  .image = PlotImage{heat_map_png(bar, 255, 1), low, high, 0, 1},
                  .width = 440,
                  .height = 18};
    return {heights, colours};
}

/// Height against the share of the surface that stands above it.
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
    std::vector<std::size_t> shown;  // about as many as can be told apart
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
    return std::abs(value) >= 1e6 ? rounded(value * um) + " 1/µm" : rounded(value * 1e-3) + " 1/mm";
}

/// The profile, its bearing curve and structure function. \returns its peak statistics for a table.
Rows profile_part(Page& page, const MeasuredSurface& surface) {
    Rows peaks{{"peak statistics", "value"}};
    const Profile<double>& profile = surface.found.profile->profile;
    show(page, {profile_panel(profile)});
    show(page, {bearing_panel(profile.heights)}, "Height against the share of the profile that stands above.");
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
Rows map_part(Page& page, const MeasuredSurface& surface) {
    Rows peaks{{"peak statistics", "value"}};
    const HeightMap<double>& map = surface.found.map->map;
    show(page, map_panels(map), "Map, and the heights of its colours.");
    show(page, {bearing_panel({map.heights.data(), static_cast<std::size_t>(map.size())})},
         "Height against the share of the map that stands above.");
    if (surface.found.map_fit) {
        const DirectionalFit<double>& fit = *surface.found.map_fit;
        Panel panel = structure_panel();
        if (fit.x) add_structure(panel, *fit.x, " along x");
        if (fit.y) add_structure(panel, *fit.y, " along y");
        for (const auto& [direction, refusal] : {std::pair("x", fit.why_no_fit_x), std::pair("y", fit.why_no_fit_y)})
            if (!refusal.empty()) page.paragraph("No fit along " + std::string(direction) + ": " + refusal);
        if (!panel.lines.empty())
            show(page, {panel}, fit_caption);
    }
    const ArealStatistics<double>& a = surface.found.map->areal;
    peaks.insert(peaks.end(), {{"density of summits", with_unit(a.summit_density, "1/m^2")},
                               {"mean curvature of the summits", per_length(a.summit_curvature)},
                               {"mean height of the summits", with_unit(a.summit_height, "m")},
                               {"rms gradient", rounded(a.rms_gradient)},
                               {"α = m0 m4/m2²", rounded(a.nayak)}});
    islands_figure(page, surface);
    return peaks;
}

void measured_section(Page& page, const MeasuredSurface& surface) {
    page.heading("Measured surface");
    Rows source{{"source", "value"}, {"file", surface.file}, {"kind", surface.kind}, {"SHA-256", surface.sha256}};
    page.table(source);
    page.begin("div class=\"pair\"");
    page.list(surface.decisions);
    Rows rows{{"parameter", "value", "found by"}};
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
    const Rows peaks = surface.found.profile ? profile_part(page, surface) : map_part(page, surface);
    if (peaks.size() > 1) page.table(peaks);
    page.end("div");
}

/// Name and value with its error of what the surface is given by.
Rows surface_rows(const Scene& scene) {
    const SurfaceParameters<double>& s = scene.face.parameters;
    Rows rows;
    const auto add = [&](const char* name, const std::optional<Measurement<double>>& one, std::string_view si) {
        if (one) rows.push_back({name, with_unit(one->value, si, 4, one->error)});
    };
    add("rms height σ", s.rms_height, "m");
    add("peak radius R", s.peak_radius, "m");
    add("peak density D_p", s.peak_density, "1/m^2");
    add("fractal dimension D", s.fractal_dimension, "");
    add("r", s.r, "");
    add("θ", s.theta, "rad");
    add("fractal roughness G", s.fractal_roughness, "m");
    if (s.max_peak_height.value > 0) rows.push_back({"highest peak R_p", with_unit(s.max_peak_height.value, "m", 4)});
    return rows;
}

std::string range_of(double low, double high, int digits = 3) {
    if (!(low <= high)) return "none";
    return low == high ? rounded(low, digits) : rounded(low, digits) + " to " + rounded(high, digits);
}

constexpr std::ptrdiff_t first_warnings = 5;  ///< that stand in the answer; the others under Validity

void validity_section(Page& page, const Scene& scene, const Results& results) {
    page.heading("Validity");
    Rows rows{{"check", "value", "holds where", "verdict"}};
    if (const auto* gaussian = find_check(results.surface_checks, Concern::gaussian_surface))
        rows.push_back({"σ R D_p, that an isotropic Gaussian surface can have", rounded(gaussian->least, 3),
                        "at least " + rounded(gaussian->limit, 3),
                        gaussian->holds() ? "holds" : "does not hold: R and D_p are of islands, not summits"});
    const auto* plastic = find_check(results.surface_checks, Concern::plasticity);
    rows.push_back({"plasticity index ψ = (E/H)√(σ/R), H = 2.8 Y",
                    plastic ? rounded(plastic->least, 3) : "yield strength not given", "elastic below 1",
                    !plastic           ? "not known"
                    : plastic->holds() ? "holds"
                                       : "yields at first loading; an elastic K is that of unloading"});
    for (const Curve& curve : results.curves) {
        const std::string name = legend_of(curve);
        if (const auto* pressure = find_check(curve.checks, Concern::interacting_asperities))
            rows.push_back(
                {"p* = p/(E g_rms), " + name, range_of(pressure->least, pressure->greatest),
                 "at most " + rounded(pressure->limit, 3),
                 pressure->holds() ? "holds" : "does not hold up to the greatest pressure: K is too small there"});
        if (const auto* hardness = find_check(curve.checks, Concern::above_hardness))
            rows.push_back({"mean contact pressure [GPa], " + name,
                            range_of(hardness->least / 1e9, hardness->greatest / 1e9),
                            scene.yield_strength ? "below 2.8 Y = " + rounded(hardness->limit / 1e9, 3) + " GPa"
                                                 : "below the hardness",
                            !scene.yield_strength ? "not known"
                            : hardness->holds()   ? "holds"
                                                  : "does not hold"});
    }
    page.table(rows);
    if (results.warnings.size() > first_warnings)
        page.list({results.warnings.begin() + first_warnings, results.warnings.end()});
}

std::string body(const Material<double>& material) {
    return "E = " + with_unit(material.youngs_modulus, "Pa", 4) + ", ν = " + rounded(material.poisson_ratio, 3);
}

/// What the bodies are made of, and whether anybody said so.
std::string material_sentence(const Scene& scene) {
    const bool assumed = scene.file == "built-in scene";
    const bool alike = scene.upper.youngs_modulus == scene.lower.youngs_modulus &&
                       scene.upper.poisson_ratio == scene.lower.poisson_ratio;
    std::string text = assumed ? "Material assumed, not given: steel of the built-in scene, " : "Material: ";
    text += alike ? body(scene.upper) + " of both bodies" : body(scene.upper) + " on " + body(scene.lower);
    const auto same = [](const Input& input) { return input.key == "material.lower"; };
    if (std::any_of(scene.inputs.begin(), scene.inputs.end(), same))
        text += " (the lower is assumed to be as the upper)";
    text += scene.yield_strength ? ", yield strength " + with_unit(*scene.yield_strength, "Pa", 4)
                                 : "; no yield strength is given, so that yielding is not judged";
    return text + (assumed ? ". Give your own in a scene, section [material]." : ".");
}

/// K of \p curve at the place \p i among the points of the scene; none where the law does not reach it.
std::optional<double> stiffness_at(const Curve& curve, std::size_t i) {
    const auto at = curve.state_at(i);
    return at ? std::optional(curve.states[*at].stiffness.value) : std::nullopt;
}

/// The unit of K of the whole page.
Unit unit_of_stiffness(const Scene& scene, const Results& results) {
    std::vector<double> values;
    for (const Curve& curve : results.curves)
        for (const std::size_t i : summary_points(scene))
            if (const auto stiffness = stiffness_at(curve, i)) values.push_back(*stiffness);
    return unit_for_all("Pa/m", values);
}

/// K of every curve at the points of a summary, with its band.
Rows stiffness_rows(const Scene& scene, const Results& results, const Unit& unit) {
    const std::vector<std::size_t> points = summary_points(scene);
    Rows rows{{"K/A₀ [" + std::string(unit.name) + "]"}};
    for (const std::size_t i : points)
        rows[0].push_back(scene.at_separations ? "at d = " + with_unit(scene.points[i], "m", 3)
                                               : "at " + with_unit(scene.points[i], "Pa", 3));
    for (const Curve& curve : results.curves) {
        std::vector<std::string> row{legend_of(curve)};
        for (const std::size_t i : points) {
            const auto at = curve.state_at(i);
            const auto shown = [&](double stiffness) { return with_unit(stiffness / unit.size, "", 3); };
            row.push_back(at ? shown(curve.states[*at].stiffness.value) : "-");
            if (at && *at < curve.band.size())
                row.back() += " (" + shown(curve.band[*at].low) + " to " + shown(curve.band[*at].high) + ")";
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The first screen: surface, K, what speaks against it, and the picture.
void answer_section(Page& page, const Scene& scene, const Results& results, const Unit& unit) {
    std::string surface;
    for (const auto& [name, face] : measured_faces(scene))
        surface += (surface.empty() ? "Surface measured from " : " and ") + shown_file(face->measured->file);
    surface = surface.empty() ? "Surface as given in " + shown_file(scene.file) + ": " : surface + ": ";
    const Rows parameters = surface_rows(scene);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        surface += (i ? ", " : "") + parameters[i][0] + " = " + parameters[i][1];
    page.begin("div class=\"answer\"");
    page.begin("div");
    page.paragraph(surface + ".");
    page.paragraph(material_sentence(scene));
    Rows rows = stiffness_rows(scene, results, unit);
    constexpr std::size_t most = 7;
    const std::size_t curves = rows.size() - 1;
    if (curves > most) rows.resize(most + 1);
    page.table(rows);
    std::string about = !has_band(results)
                            ? "Without errors of the surface's parameters K has no band."
                            : "In brackets the band that holds 5 to 95 % of " + std::to_string(scene.samples) +
                                  " surfaces drawn about this one by its errors.";
    if (curves > most) about += " The first " + std::to_string(most) + " of " + std::to_string(curves) + " curves.";
    page.paragraph(about);
    const std::size_t count = results.warnings.size();
    page.begin(count == 0 ? "div class=\"verdict\"" : "div class=\"verdict warned\"");
    page.paragraph(count == 0         ? "Verdict: no check of validity speaks against these results."
                   : results.doubtful ? "Verdict: doubtful. Read the warnings before any of these numbers is used."
                                      : "Verdict: computed, but not all assumptions of the model hold.");
    page.list(results.verdict);
    const std::ptrdiff_t shown = std::min(static_cast<std::ptrdiff_t>(count), first_warnings);
    page.list({results.warnings.begin(), results.warnings.begin() + shown});
    if (static_cast<std::ptrdiff_t>(count) > shown)
        page.paragraph(std::to_string(static_cast<std::ptrdiff_t>(count) - shown) + " more under Validity.");
    page.end("div");
    page.end("div");
    Panel picture = stiffness_panel(scene, results);
    picture.y.unit = unit;
    const std::string some = left_out(results);
    show(page, {std::move(picture)}, some.empty() ? some : some + ".", results.short_verdict);
    page.end("div");
}

void other_figures(Page& page, const Scene& scene, const Results& results) {
    page.heading("Under the same pressures");
    page.begin("div class=\"pair\"");
    if (scene.ultrasound)
        for (Panel& panel : reflection_panels(scene, results))
            show(page, {std::move(panel)}, "Reflection of ultrasound by the contact, eq. (5.1).");
    std::vector<Panel> panels{quantity_panel(results, {.label = "real area / nominal"},
                                             [](const ContactState<double>& s) { return s.real_area_fraction.value; }),
                              quantity_panel(results, {.label = "contacts", .si = "1/m^2"},
                                             [](const ContactState<double>& s) { return s.contact_density.value; }),
                              quantity_panel(results, {.label = "separation", .logarithmic = false, .si = "m"},
                                             [](const ContactState<double>& s) { return s.separation.value; })};
    panels[0].title = "Real area";
    panels[1].title = "Contacts";
    panels[2].title = "Separation of the mean planes";
    for (Panel& panel : panels) show(page, {std::move(panel)});
    page.end("div");
    if (!scene.ultrasound) page.paragraph("The scene has no section [ultrasound]: no reflection is computed.");
}

/// Every number, one closed table for each curve.
void numbers_section(Page& page, const Scene& scene, const Results& results, const Unit& unit) {
    page.heading("Numbers");
    for (const Curve& curve : results.curves) {
        std::vector<std::string> header{"p [MPa]", "η", "separation [µm]",
                                        "K/A₀ [" + std::string(unit.name) + "]"};
        if (!curve.band.empty()) header.insert(header.end(), {"5 %", "95 %"});
        if (scene.ultrasound) header.push_back("|R|");
        if (scene.ultrasound && scene.ultrasound->shear) header.push_back("|R| shear");
        header.insert(header.end(), {"real area", "contacts [1/mm²]"});
        Rows rows{header};
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            const auto& s = curve.states[i];
            std::vector<std::string> row{rounded(s.pressure.value / 1e6), rounded(s.eta),
                                         rounded(s.separation.value / um), rounded(s.stiffness.value / unit.size)};
            if (!curve.band.empty())
                row.insert(row.end(), {rounded(curve.band[i].low / unit.size), rounded(curve.band[i].high / unit.size)});
            if (scene.ultrasound) {
                const Waves& w = *scene.ultrasound;
                row.push_back(rounded(reflection(s.stiffness.value, w.longitudinal, w.angular())));
                if (w.shear)
                    row.push_back(
                        rounded(reflection(results.tangential_ratio * s.stiffness.value, *w.shear, w.angular())));
            }
            row.insert(row.end(), {rounded(s.real_area_fraction.value), rounded(s.contact_density.value * 1e-6)});
            rows.push_back(std::move(row));
        }
        page.begin_details(legend_of(curve) + ": " + std::to_string(curve.states.size()) + " points");
        page.table(rows);
        page.end("details");
    }
}

void inputs_section(Page& page, const Scene& scene) {
    page.heading("Inputs");
    Rows inputs{{"key", "value", "as written"}};
    for (const Input& input : scene.inputs)
        if (!input.key.ends_with("(measured)"))  // those stand under Measured surface
            inputs.push_back({input.key, input.value ? with_unit(*input.value, input.unit) : "", input.written});
    page.table(inputs);
    if (measured_faces(scene).empty())
        page.paragraph("The surface is given by its parameters; there is no measured profile or map to show.");
}

void equations_section(Page& page, const Scene& scene, const Results& results) {
    page.heading("Equations");
    Rows rows{{"law", "load", "stiffness", "peaks"}};
    for (const Law* law : scene.laws)
        rows.push_back(
            {std::string(law->name), std::string(law->load), std::string(law->stiffness), std::string(law->peaks)});
    page.table(rows);
    std::string rest = "Effective modulus " + rounded(results.modulus / 1e9) +
                       " GPa from both bodies. Rms curvature of the peaks by (4.10). Interaction " +
                       (scene.reading == InteractionReading::none ? "left out" : "by (4.11)") + ".";
    if (scene.ultrasound)
        rest += " Reflection by (5.1); shear waves see the tangential stiffness, " + rounded(results.tangential_ratio) +
                " K by Mindlin.";
    if (has_band(results)) rest += " The band is of seed " + std::to_string(scene.seed) + ".";
    page.paragraph(rest);
    page.paragraph(
        "The numbers of the equations are those of R. Buczkowski, M. Kleiber, G. Starzyński, Normal contact stiffness "
        "of fractal rough surfaces, Arch. Mech. 66 (2014). K is the stiffness per nominal area, 1 GPa/µm = 1e15 Pa/m.");
    page.paragraph("Normal contact stiffness, computed by fstiff " FSTIFF_VERSION " from " + scene.file + ", SHA-256 " +
                   scene.sha256 + ".");
}

/// The surface behind other cut-offs, and K by them at the middle point of the scene.
void scales_section(Page& page, const Scene& scene, const Results& results, const MeasuredSurface& surface) {
    if (!surface.how || surface.how->input.file == "-" || scene.at_separations) return;
    const scene::ScalesOptions how{
        .pressure = scene.points[scene.points.size() / 2], .modulus = results.modulus, .progress = progress_bar()};
    const scene::Scales scales = scales_of(surface, read_surface_input(surface.how->input), how);
    std::vector<Panel> panels = scales_panels(scales);
    if (panels.empty()) return;
    page.heading("Influence of the cut-offs");
    for (const std::string& sentence : what_is_settled(scales)) page.paragraph(sentence_case(sentence) + ".");
    page.begin("div class=\"pair\"");
    for (Panel& panel : panels) show(page, {std::move(panel)});
    page.end("div");
    page.paragraph("K by " + scales.law + " at " + with_unit(how.pressure, "Pa") +
                   ", and the parameters of the surface, over their values at the chosen cut-offs.");
}

std::string page_of(const Scene& scene, const Results& results) {
    Page page(scene.name);
    const Unit unit = unit_of_stiffness(scene, results);
    answer_section(page, scene, results, unit);
    other_figures(page, scene, results);
    inputs_section(page, scene);
    for (const auto& [name, face] : measured_faces(scene)) {
        measured_section(page, *face->measured);
        scales_section(page, scene, results, *face->measured);
        for (const MeasuredSurface& part : face->measured->parts) measured_section(page, part);
    }
    validity_section(page, scene, results);
    numbers_section(page, scene, results, unit);
    equations_section(page, scene, results);
    return page.str();
}

Report execute(const Options& options) {
    refuse_standard_output(options.folder, "a folder");
    const std::string file = (std::filesystem::path(options.folder) / "report.html").string();
    require_own(file);
    keep_for_output(file);
    Scene scene = read_scene(options.scene);
    // of a map a report shows the truth beside the laws
    const scene::Law& elements = scene::find_law(LawName::boundary_elements);
    if (refusal_of(elements, scene).empty() && !scene.at_separations &&
        std::find(scene.laws.begin(), scene.laws.end(), &elements) == scene.laws.end())
        scene.laws.push_back(&elements);
    // a report shows everything, whatever output.quantities asks of run
    scene.stiffness = scene.separation = scene.real_area = scene.contacts = true;
    if (scene.ultrasound) {
        scene.reflection = true;
        scene.shear_reflection = scene.ultrasound->shear.has_value();
    }
    const Results results = compute(scene, progress_bar());
    const std::string document = page_of(scene, results);
    deliver({{file, page_mark + document}}, options.folder);
    Report report;
    report.status = results.doubtful ? doubtful_result : success;
    const Format format = options.output.format;
    if (format == Format::json) {
        Json answer = json_document("report");
        answer["scene"] = scene_json(scene);
        answer["files"] = {file};
        answer["warnings"] = results.warnings;
        report.document = answer.str();
    } else {
        report.document = format == Format::csv ? csv_line({"file"}) + csv_line({file})
                                                : "fstiff " FSTIFF_VERSION ": report of " +
                                                      printable(scene.name + " (" + scene.file + ")") + "\n  " +
                                                      printable(file) + "\n";
        for (const std::string& warning : results.warnings) report.diagnostics.push_back("warning: " + warning);
    }
    return report;
}

}  // namespace
}  // namespace report_command

Command add_report(CLI::App& app) {
    using namespace report_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "report", "A scene and all that follows from it as one HTML file");
    add_scene_options(
        command, options->scene,
        "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
        "profile, map, or JSON of fstiff measure, in place of the scene's [surface]; - is standard input");
    command.option("-o,--output", options->folder, "folder for report.html; made when missing")
        .type_name("FOLDER")
        .required();
    add_format_option(command, options->output);
    command.footer(
        "The page holds its pictures and opens without a network.\n"
        "Example:\n  fstiff report -o report");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
