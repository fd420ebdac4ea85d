// SPDX-License-Identifier: BSD-3-Clause
// fstiff report: a scene and all that follows from it, on one page that needs nothing else.
#include "commands/commands.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "picture/page.hpp"
#include "picture/panels.hpp"
#include "scene/results.hpp"
#include "scene/surface_instances.hpp"

#include <fstiff/contact/validity.hpp>
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
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string folder;
};

using Rows = std::vector<std::vector<std::string>>;
constexpr double um = 1e-6;

std::string with_error(double value, double error, int digits = 5) {
    return rounded(value, digits) + (error > 0 ? " ± " + rounded(error, 2) : "");
}

/// A long profile keeps the least and greatest height of every one of \p parts stretches; missing points leave gaps.
Panel profile_panel(const Profile<double>& profile) {
    constexpr std::size_t parts = 1000;
    Panel panel{.title = "Measured profile, without its form",
                .x = {.label = "x [mm]", .logarithmic = false},
                .y = {.label = "height [µm]", .logarithmic = false},
                .height = 200,
                .legend = false};
    PlotLine line{.label = "height", .x = {}, .y = {}};
    const auto add = [&](std::size_t i) {
        line.x.push_back(static_cast<double>(i) * profile.spacing * 1e3);
        line.y.push_back(profile.heights[i] / um);
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
    const double x = static_cast<double>(map.columns()) * map.dx * 1e3,
                 y = static_cast<double>(map.rows()) * map.dy * 1e3;
    const double scale = std::min(480 / x, 480 / y);

    Panel heights{
        .title = "Measured map, without its form",
        .x = {.label = "x [mm]", .logarithmic = false, .low = 0.0, .high = x},
        .y = {.label = "y [mm]", .logarithmic = false, .low = 0.0, .high = y},
        .image = PlotImage{heat_map_png(shades, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)), 0,
                           x, 0, y},
        .width = std::max(60.0, scale * x),
        .height = std::max(60.0, scale * y)};
    std::vector<unsigned char> bar;
    for (int k = 0; k < 255; ++k) bar.push_back(static_cast<unsigned char>(k));
    Panel colours{.x = {.label = "height [µm]", .logarithmic = false, .low = low / um, .high = high / um},
                  .y = {.label = "", .logarithmic = false, .low = 0.0, .high = 1.0, .ticks = false},
                  .image = PlotImage{heat_map_png(bar, 255, 1), low / um, high / um, 0, 1},
                  .width = 480,
                  .height = 18};
    return {heights, colours};
}

/// Height against the share of the surface that stands above it.
Panel bearing_panel(std::span<const double> heights) {
    Panel panel{.title = "Bearing curve",
                .x = {.label = "bearing area [%]", .logarithmic = false, .low = 0.0, .high = 100.0},
                .y = {.label = "height [µm]", .logarithmic = false},
                .height = 240,
                .legend = false};
    PlotLine line{.label = "height", .x = {}, .y = {}};
    const BearingCurve<double> curve = bearing_curve(heights);
    for (std::size_t k = 0; k < curve.size(); ++k) {
        line.x.push_back(100 * curve.share[k]);
        line.y.push_back(curve.height[k] / um);
    }
    panel.lines.push_back(std::move(line));
    return panel;
}

void add_structure(Panel& panel, const FractalFit<double>& fit, const std::string& of) {
    const auto& s = fit.structure_function;
    PlotLine measured{.label = "S" + of, .x = {}, .y = {}};
    measured.colour = static_cast<int>(panel.lines.size()) / 2;
    measured.stroke = Stroke::none;
    measured.marker = Marker::circle;
    PlotLine fitted{.label = "D = " + with_error(fit.fractal.dimension, fit.dimension_error, 4), .x = {}, .y = {}};
    fitted.colour = measured.colour;
    fitted.stroke = Stroke::dashed;
    fitted.sets_range = false;
    double last = 0;
    for (std::size_t k = 0; k < s.size(); ++k) {
        if (last > 0 && s.lag[k] < 1.08 * last) continue;  // about as many as can be told apart
        last = s.lag[k];
        measured.x.push_back(s.lag[k] / um);
        measured.y.push_back(s.value[k] / (um * um));
        fitted.x.push_back(s.lag[k] / um);
        fitted.y.push_back(structure_function_at(s.lag[k], fit.fractal) / (um * um));
    }
    panel.lines.push_back(std::move(measured));
    panel.lines.push_back(std::move(fitted));
    panel.windows.push_back({"window of the fit" + of, fit.window.from / um, fit.window.to / um});
}

Panel structure_panel() {
    return {.title = "Structure function (2.8)", .x = {.label = "lag τ [µm]"}, .y = {.label = "S [µm²]"}};
}

/// The profile, its bearing curve and structure function. \returns its peak statistics for a table.
Rows profile_part(Page& page, const MeasuredSurface& surface, const std::string& shown) {
    Rows peaks{{"peak statistics", "value"}};
    const Profile<double>& profile = surface.profile->profile;
    page.figure({.title = shown, .panels = {profile_panel(profile), bearing_panel(profile.heights)}},
                "Profile, and its height against the share of it that stands above.");
    if (surface.profile_fit) {
        Panel panel = structure_panel();
        add_structure(panel, *surface.profile_fit, "");
        page.figure({.title = shown, .panels = {panel}}, "Structure function, its fit and the window.");
    } else {
        page.paragraph("No structure function is fitted: " + surface.fractal_refusal);
    }
    try {
        const PeakStatistics<double> s = peak_statistics(profile);
        peaks.insert(peaks.end(), {{"r (4.1)", rounded(s.r)},
                                   {"θ (4.3) [rad]", rounded(s.theta)},
                                   {"θ/π, peaks expected over ordinates", rounded(s.peak_ratio())},
                                   {"peaks counted over ordinates", rounded(s.counted_peak_ratio)},
                                   {"peaks per length [1/mm]", rounded(s.peaks_per_length * 1e-3)},
                                   {"autocorrelation at one sample", rounded(s.rho1)},
                                   {"autocorrelation at two samples", rounded(s.rho2)},
                                   {"rms slope of neighbours", rounded(s.rms_slope)},
                                   {"rms curvature σ_κ of triples [1/mm]", rounded(s.rms_curvature * 1e-3)}});
    } catch (const domain_error& error) {
        page.paragraph("No peak statistics: " + std::string(error.what()));
    }
    return peaks;
}

void islands_figure(Page& page, const MeasuredSurface& surface, const std::string& shown) {
    try {
        const IslandCurve<double> curve = surface.islands ? *surface.islands : island_curve(surface.map->map);
        Panel islands{.title = "Islands",
                      .x = {.label = "bearing area [%]", .logarithmic = false, .low = 0.0, .high = 100.0},
                      .y = {.label = "density [1/mm²]", .logarithmic = false, .low = 0.0},
                      .height = 240,
                      .legend = false};
        PlotLine line{.label = "islands", .x = {}, .y = {}};
        for (std::size_t k = 0; k < curve.size(); ++k) {
            line.x.push_back(100 * curve.bearing_area[k]);
            line.y.push_back(curve.density[k] * 1e-6);
        }
        islands.lines.push_back(std::move(line));
        page.figure({.title = shown, .panels = {islands}}, "Islands above a cut, against the bearing area there.");
    } catch (const domain_error& error) {
        page.paragraph("No islands: " + std::string(error.what()));
    }
}

/// The map, its bearing curve, structure functions and islands. \returns its summits for a table.
Rows map_part(Page& page, const MeasuredSurface& surface, const std::string& shown) {
    Rows peaks{{"peak statistics", "value"}};
    const HeightMap<double>& map = surface.map->map;
    std::vector<Panel> panels = map_panels(map);
    panels.push_back(bearing_panel({map.heights.data(), static_cast<std::size_t>(map.size())}));
    page.figure({.title = shown, .panels = panels},
                "Map, the heights of its colours, and height against the share of the map that stands above.");
    if (surface.map_fit) {
        const DirectionalFit<double>& fit = *surface.map_fit;
        Panel panel = structure_panel();
        if (fit.x) add_structure(panel, *fit.x, " along x");
        if (fit.y) add_structure(panel, *fit.y, " along y");
        for (const auto& [direction, refusal] : {std::pair("x", fit.why_no_fit_x), std::pair("y", fit.why_no_fit_y)})
            if (!refusal.empty()) page.paragraph("No fit along " + std::string(direction) + ": " + refusal);
        if (!panel.lines.empty())
            page.figure({.title = shown, .panels = {panel}},
                        "Structure functions along both directions, their fits and windows.");
    } else {
        page.paragraph("No structure function is fitted: " + surface.fractal_refusal);
    }
    const ArealStatistics<double>& a = surface.map->areal;
    peaks.insert(peaks.end(), {{"summits [1/mm²]", rounded(a.summit_density * 1e-6)},
                               {"mean curvature of the summits [1/mm]", rounded(a.summit_curvature * 1e-3)},
                               {"mean height of the summits [µm]", rounded(a.summit_height / um)},
                               {"rms gradient", rounded(a.rms_gradient)},
                               {"α = m0 m4/m2²", rounded(a.nayak)}});
    islands_figure(page, surface, shown);
    return peaks;
}

void measured_section(Page& page, const MeasuredSurface& surface) {
    const std::string shown = std::filesystem::path(surface.file).filename().string();
    page.heading("Measured surface");
    Rows source{{"", ""}, {"file", surface.file}, {"kind", surface.kind}, {"SHA-256", surface.sha256}};
    page.table(source);
    page.list(surface.decisions);

    Rows rows{{"parameter", "value", "error", "unit", "found by"}};
    for (const ParameterLine& line : parameter_lines(surface))
        rows.push_back({line.name, rounded(line.measured.value), rounded(line.measured.error, 2), line.unit, line.how});
    page.table(rows);
    if (!surface.fractal_refusal.empty()) page.paragraph("No D and G: " + surface.fractal_refusal);
    if (!surface.peaks_refusal.empty()) page.paragraph("No r and θ: " + surface.peaks_refusal);

    if (!surface.profile && !surface.map) {
        page.paragraph("The numbers come from the JSON of fstiff measure, which holds no heights: none are drawn.");
        return;
    }
    const Rows peaks = surface.profile ? profile_part(page, surface, shown) : map_part(page, surface, shown);
    if (peaks.size() > 1) page.table(peaks);
}

void given_section(Page& page, const Scene& scene) {
    page.heading("Surface");
    page.paragraph("The surface is given by its parameters; there is no measured profile or map to show.");
    const auto& s = scene.surface;
    const auto error = [&](Parameter which) { return scene.uncertain.error[static_cast<std::size_t>(which)]; };
    Rows rows{{"parameter", "value", "unit"}};
    rows.push_back({"rms height σ", with_error(s.rms_height / um, error(Parameter::rms_height) / um), "µm"});
    rows.push_back({"peak radius R", with_error(s.peak_radius / um, error(Parameter::peak_radius) / um), "µm"});
    rows.push_back(
        {"peak density D_p", with_error(s.peak_density * 1e-6, error(Parameter::peak_density) * 1e-6), "1/mm²"});
    if (s.max_peak_height > 0) rows.push_back({"highest peak R_p", rounded(s.max_peak_height / um), "µm"});
    if (scene.fractal_dimension)
        rows.push_back(
            {"fractal dimension D", with_error(*scene.fractal_dimension, error(Parameter::fractal_dimension)), ""});
    if (scene.fractal_roughness) rows.push_back({"fractal roughness G", rounded(*scene.fractal_roughness), "m"});
    if (scene.r) rows.push_back({"r", with_error(*scene.r, error(Parameter::r)), ""});
    if (scene.theta) rows.push_back({"θ", with_error(*scene.theta, error(Parameter::theta)), "rad"});
    page.table(rows);
}

std::string range_of(double low, double high, int digits = 3) {
    if (!(low <= high)) return "none";
    return low == high ? rounded(low, digits) : rounded(low, digits) + " to " + rounded(high, digits);
}

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
    if (!results.warnings.empty()) {
        page.paragraph("Warnings:");
        page.list(results.warnings);
    } else {
        page.paragraph("No warnings.");
    }
}

void results_section(Page& page, const Scene& scene, const Results& results) {
    page.heading("Stiffness");
    page.figure(results_figure(scene, results),
                "K per nominal area against pressure" +
                    std::string(scene.ultrasound ? ", and the reflection of ultrasound, eq. (5.1)." : "."));
    if (!scene.ultrasound) page.paragraph("The scene has no section [ultrasound]: no reflection is computed.");

    page.heading("Real area, contacts and separation");
    Figure others{.title = "Under the same pressures", .panels = {}};
    Panel area = quantity_panel(results, "real area / nominal", true,
                                [](const ContactState<double>& s) { return s.real_area_fraction.value; });
    area.title = "Real area";
    Panel contacts = quantity_panel(results, "contacts [1/mm²]", true,
                                    [](const ContactState<double>& s) { return s.contact_density.value * 1e-6; });
    contacts.title = "Contacts";
    Panel separation = quantity_panel(results, "separation [µm]", false,
                                      [](const ContactState<double>& s) { return s.separation.value / um; });
    separation.title = "Separation of the mean planes";
    others.panels = {area, contacts, separation};
    const auto has = [&](std::string_view law) {
        return std::any_of(scene.laws.begin(), scene.laws.end(), [&](const auto& one) { return one.law->name == law; });
    };
    page.figure(others, std::string("Real area, number of contacts and separation against pressure.") +
                            (has("fractal") && has("hertz")
                                 ? " fractal and hertz have one load, (3.7): here their curves lie on one another."
                                 : ""));

    page.heading("Numbers");
    for (const Curve& curve : results.curves) {
        page.paragraph(legend_of(curve));
        std::vector<std::string> header{"p [MPa]", "η", "separation [µm]", "K/A₀ [GPa/µm]"};
        if (!curve.band.empty()) header.insert(header.end(), {"5 %", "95 %"});
        if (scene.ultrasound) header.push_back("|R|");
        if (scene.ultrasound && scene.ultrasound->shear) header.push_back("|R| shear");
        header.insert(header.end(), {"real area", "contacts [1/mm²]"});
        Rows rows{header};
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            const auto& s = curve.states[i];
            std::vector<std::string> row{rounded(s.pressure.value / 1e6), rounded(s.eta),
                                         rounded(s.separation.value / um), rounded(s.stiffness.value / 1e15)};
            if (!curve.band.empty())
                row.insert(row.end(), {rounded(curve.band[i].low / 1e15), rounded(curve.band[i].high / 1e15)});
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
        page.table(rows);
    }
}

std::string page_of(const Scene& scene, const Results& results) {
    Page page(scene.name);
    page.paragraph("Normal contact stiffness, computed by fstiff " FSTIFF_VERSION " from " + scene.file + ".");
    page.heading("Inputs");
    page.table({{"scene", "SHA-256"}, {scene.file, scene.sha256}});
    Rows inputs{{"key", "written", "value", "unit"}};
    for (const Input& input : scene.inputs)
        inputs.push_back({input.key, input.written, input.value ? rounded(*input.value, 6) : "", input.unit});
    page.table(inputs);
    if (scene.measured)
        measured_section(page, *scene.measured);
    else
        given_section(page, scene);
    results_section(page, scene, results);
    validity_section(page, scene, results);

    page.heading("Equations");
    Rows rows{{"law", "load", "stiffness", "peaks"}};
    for (const ChosenLaw& chosen : scene.laws) {
        const Law& law = *chosen.law;
        rows.push_back(
            {std::string(law.name), std::string(law.load), std::string(law.stiffness), std::string(law.peaks)});
    }
    page.table(rows);
    std::string rest = "Effective modulus " + rounded(results.modulus / 1e9) +
                       " GPa from both bodies. Rms curvature of the peaks by (4.10). Interaction " +
                       (scene.reading == InteractionReading::none ? "left out" : "by (4.11)") + ".";
    if (scene.ultrasound)
        rest += " Reflection by (5.1); shear waves see the tangential stiffness, " + rounded(results.tangential_ratio) +
                " K by Mindlin.";
    if (!results.curves.front().band.empty())
        rest += " The band holds 5 to 95 % of " + std::to_string(scene.samples) +
                " surfaces drawn about this one by its errors, seed " + std::to_string(scene.seed) + ".";
    page.paragraph(rest);
    page.paragraph(
        "The numbers of the equations are those of R. Buczkowski, M. Kleiber, G. Starzyński, Normal contact stiffness "
        "of fractal rough surfaces, Arch. Mech. 66 (2014). K is the stiffness per nominal area, 1 GPa/µm = 1e15 Pa/m.");
    return page.str();
}

Report execute(const Options& options) {
    const std::string file = (std::filesystem::path(options.folder) / "report.html").string();
    require_own(file);
    keep_for_output(file);
    Scene scene = read_scene(options.scene);
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
        report.document = format == Format::csv ? csv_line({"file"}) + csv_line({"\"" + file + "\""})
                                                : "fstiff " FSTIFF_VERSION ": report of " + scene.name + " (" +
                                                      scene.file + ")\n  " + file + "\n";
        for (const std::string& warning : results.warnings) report.diagnostics.push_back("warning: " + warning);
    }
    return report;
}

}  // namespace

Command add_report(CLI::App& app) {
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
