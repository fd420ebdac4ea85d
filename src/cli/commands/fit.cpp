// SPDX-License-Identifier: BSD-3-Clause
// fstiff fit: fractal dimension D and roughness G of a measured profile or map, with errors, and its other statistics.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/progress.hpp"
#include "input/surface_options.hpp"
#include "scene/shown_unit.hpp"
#include "scene/surface_instances.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/measured/measured_concerns.hpp>
#include <fstiff/measured/sections.hpp>
#include <fstiff/profile/all_lags.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/spectral_moments.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include <cmath>
#include <memory>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    SurfaceOptions surface;
    std::string window;
    StructureConvention convention = StructureConvention::exact;
    std::uint64_t seed = FractalFitOptions<double>{}.seed;
    int resamples = FractalFitOptions<double>{}.resamples;
    bool all_lags = false;
};

using Strings = std::vector<std::string>;

/// What one profile gives. Of the parts that need more than the fit does, the reason where there is none.
struct ProfileResult {
    PreparedProfile levelled;
    FractalFit<double> fit;
    std::optional<SpectralFit<double>> spectrum;
    std::optional<SpectralMoments<double>> moments;
    std::optional<PeakStatistics<double>> peaks;
    std::string no_spectrum, no_moments, no_peaks;
    StructureFunction<double> structure;  ///< that is shown
};

struct MapResult {
    PreparedMap levelled;
    DirectionalFit<double> fit;
};

FractalFitOptions<double> fit_options(const Options& options) {
    FractalFitOptions<double> how;
    if (!options.window.empty()) how.window = parse_window(options.window, "--window");
    how.convention = options.convention;
    how.seed = options.seed;
    how.resamples = options.resamples;
    if (!options.surface.tip_radius.empty()) how.tip_radius = parse_length(options.surface.tip_radius, "--tip-radius");
    if (!options.surface.resolution.empty()) how.resolution = parse_length(options.surface.resolution, "--resolution");
    return how;
}

/// Runs \p call into \p result, or keeps why it cannot.
template <class Result, class Call>
void attempt(std::optional<Result>& result, std::string& refusal, const Call& call) {
    try {
        result = call();
    } catch (const domain_error& error) {
        refusal = error.what();
    }
}

ProfileResult fit_profile(const Options& options, const SurfaceInput& input) {
    FractalFitOptions<double> how = fit_options(options);
    how.progress = progress_bar();
    ProfileResult result;
    result.levelled = level_profile(options.surface, input);
    const Profile<double>& profile = result.levelled.profile;
    how.lambda_s = result.levelled.cut_offs.lambda_s.value_or(0);
    result.fit = about_file(options.surface.file, [&] { return fit_fractal(result.levelled, how); });
    attempt(result.spectrum, result.no_spectrum, [&] {
        const PowerSpectrum<double> spectrum = power_spectrum(result.levelled.of_structure());
        std::optional<WavelengthWindow<double>> window;  // without the waves below lambda_s
        if (const auto shortest = result.levelled.cut_offs.lambda_s; shortest && *shortest > 16 * profile.spacing)
            window = {*shortest, 2 * numbers::pi_v<double> / spectrum.step / 8};
        const SpectralFit<double> fit = fit_spectrum(spectrum, window);
        require(fit.dimension > 1 && fit.dimension < 2, "D of the power spectrum", fit.dimension,
                "between 1 and 2: over these wavelengths the profile is not self-affine");
        return fit;
    });
    attempt(result.moments, result.no_moments, [&] { return spectral_moments(profile); });
    attempt(result.peaks, result.no_peaks, [&] { return peak_statistics(profile); });
    result.structure = options.all_lags ? structure_function_at_all_lags(result.levelled.of_structure())
                                        : result.fit.structure_function;
    return result;
}

MapResult fit_map(const Options& options, SurfaceInput& input) {
    if (options.all_lags) throw Usage("--all-lags is for profiles; must not be given for a map");
    FractalFitOptions<double> how = fit_options(options);
    how.progress = progress_bar();
    MapResult result;
    result.levelled = level_map_of(options.surface, input);
    how.lambda_s = result.levelled.cut_offs.lambda_s.value_or(0);
    about_file(options.surface.file, [&] {
        result.fit = fit_directions<double>(result.levelled, how);
        if (!result.fit.x && !result.fit.y)
            throw domain_error("no direction of the map allows a fit; along x: " + result.fit.why_no_fit_x +
                               "; along y: " + result.fit.why_no_fit_y);
    });
    return result;
}

bool in_window(const FractalFit<double>& fit, double lag) { return lag >= fit.window.from && lag <= fit.window.to; }

/// Why a fit is flagged as curved.
std::string curved_sentence(const FractalFit<double>& fit) {
    const std::string slopes =
        "the local slope of the structure function " +
        (fit.slope_longest < fit.slope_shortest - 0.3 ? "falls from " + rounded(fit.slope_shortest, 3) + " to " +
                                                            rounded(fit.slope_longest, 3) + " over the window"
                                                      : "varies between " + rounded(fit.min_slope, 3) + " and " +
                                                            rounded(fit.max_slope, 3) + " over the window") +
        (fit.min_slope < 0.2 ? ": a part of it is a plateau" : "");
    for (const auto& beside : fit.neighbours)
        if (beside.disagrees)
            return slopes + "; " + (beside.half ? "its half" : "beside it the window") + " of " +
                   shown_length(beside.window.from, 3) + " to " + shown_length(beside.window.to, 3) +
                   " gives D = " + rounded(beside.dimension, 3) + ", which differs by " +
                   rounded(std::abs(beside.difference), 2) + " where sampling explains " +
                   rounded(beside.difference_error, 2) + ": this is no single power law, and D is a mean over it";
    return slopes + ": this is no single power law, and D is a mean over it";
}

std::string sentence(MeasuredConcern concern, const FractalFit<double>& fit) {
    switch (concern) {
        case MeasuredConcern::curved:
            return curved_sentence(fit);
        case MeasuredConcern::saturated:
            return "the structure function is nearly flat (slope " + rounded(fit.flattest_slope, 2) + ") at a lag of " +
                   shown_length(fit.flattest_lag, 3) +
                   ", shorter than the window: the roughness has saturated there, and D is that of the waviness; "
                   "--window looks elsewhere";
        case MeasuredConcern::roughness_uncertain:
            return "G is known to no better than a factor of 10: D is close to 1, where G hardly matters";
        default:
            return "the window reaches beyond a tenth of the cut-off, where S has lost some of what the filter took";
    }
}

void warn_of_fit(Strings& all, const FractalFit<double>& fit, const std::string& where) {
    for (const MeasuredConcern concern : concerns_of(fit)) all.push_back(where + sentence(concern, fit));
}

Strings warnings(const SurfaceInput& input, const ProfileResult& result) {
    Strings all;
    for (const MeasuredConcern concern : concerns_of<double>(result.fit, result.levelled, result.spectrum))
        all.push_back(concern == MeasuredConcern::spectrum_differs
                          ? "D from the power spectrum, " + rounded(result.spectrum->dimension, 4) +
                                ", is another one: over its wavelengths the profile follows another law"
                          : sentence(concern, result.fit));
    for (std::string& line : reading_warnings(input, "their pairs are left out")) all.push_back(std::move(line));
    return all;
}

Strings warnings(const SurfaceInput& input, const MapResult& result) {
    Strings all;
    if (result.fit.x) warn_of_fit(all, *result.fit.x, "along x: ");
    if (result.fit.y) warn_of_fit(all, *result.fit.y, "along y: ");
    if (!result.fit.x) all.push_back("along x: no fit: " + result.fit.why_no_fit_x);
    if (!result.fit.y) all.push_back("along y: no fit: " + result.fit.why_no_fit_y);
    if (result.fit.anisotropic())
        all.push_back("the map is anisotropic: " +
                      (result.fit.x && result.fit.y
                           ? "D along x less D along y is " + rounded(result.fit.dimension_difference, 3) + " +- " +
                                 rounded(result.fit.dimension_difference_error, 2) + ", "
                           : std::string()) +
                      "ln S along x less ln S along y " + rounded(result.fit.log_level_difference, 3) + " +- " +
                      rounded(result.fit.log_level_difference_error, 2) + "; one D and one G do not describe it");
    for (std::string& line : reading_warnings(input, "they enter no difference")) all.push_back(std::move(line));
    return all;
}

/// The structure function \p s; \p direction of a map, else empty.
Rows rows_of(const FractalFit<double>& fit, const StructureFunction<double>& s, const std::string& direction = "") {
    std::vector<int> used;
    Strings marks;
    for (const double lag : s.lag) {
        used.push_back(in_window(fit, lag) ? 1 : 0);
        marks.push_back(used.back() ? "*" : "");
    }
    Rows rows;
    if (!direction.empty()) rows.repeat({.key = "direction", .json = false}, direction, s.size());
    rows.add({"lag_m", "lag [µm]", 1e6}, s.lag);
    rows.add({"value_m2", "S [µm²]", 1e12}, s.value);
    rows.add({"pairs", "pairs"}, s.pairs);
    rows.add({.key = "in_window", .json = false}, used);
    rows.add({"", "window"}, marks);
    return rows;
}

std::string csv(const ProfileResult& result) { return rows_of(result.fit, result.structure).csv(); }

std::string csv(const MapResult& result) {
    std::string text;
    if (const auto& x = result.fit.x) text += rows_of(*x, x->structure_function, "x").csv();
    if (const auto& y = result.fit.y) text += rows_of(*y, y->structure_function, "y").csv(text.empty());
    return text;
}

void put_fit(Json& document, const FractalFit<double>& fit) {
    document["fractal_dimension"] = fit.fractal.dimension;
    document["fractal_dimension_error"] = fit.dimension_error;
    document["fractal_dimension_sampling_error"] = fit.sampling_dimension_error;
    document["fractal_dimension_window_error"] = fit.window_dimension_error;
    Json beside = Json::array();
    for (const auto& one : fit.neighbours)
        beside.push_back({{"window_m", Json(std::vector<double>{one.window.from, one.window.to})},
                          {"half", one.half},
                          {"fractal_dimension", one.dimension},
                          {"difference", one.difference},
                          {"difference_error", one.difference_error},
                          {"disagrees", one.disagrees}});
    document["windows_beside"] = std::move(beside);
    document["fractal_dimension_model_error"] = fit.model_dimension_error;
    document["fractal_dimension_bootstrap_error"] = fit.bootstrap_dimension_error;
    document["ordinary_least_squares"] = {{"fractal_dimension", fit.line_dimension},
                                          {"fractal_dimension_error", fit.regression_dimension_error},
                                          {"note", "as if all lags were independent: the error is too small"}};
    document["fractal_dimension_regression_error"] = fit.regression_dimension_error;
    document["fractal_roughness_m"] = fit.fractal.roughness;
    document["fractal_roughness_error_m"] = fit.roughness_error;
    document["log_fractal_roughness_error"] = fit.log_roughness_error;
    document["window_m"] = Json(std::vector<double>{fit.window.from, fit.window.to});
    document["window_automatic"] = fit.automatic_window;
    document["window_begins"] = describe(fit.begins);
    document["window_ends"] = describe(fit.ends);
    document["reliable_from_m"] = fit.reliable_from;
    document["lags_in_window"] = fit.lags;
    document["slope_at_window_ends"] = Json(std::vector<double>{fit.slope_shortest, fit.slope_longest});
    document["slope_range_in_window"] = Json(std::vector<double>{fit.min_slope, fit.max_slope});
    document["curved"] = fit.curved;
    document["behind_plateau"] = fit.behind_plateau;
    document["log_periodic_terms"] = fit.log_periodic;
    document["finite_band_terms"] = fit.finite_band;
    document["bootstrap_seed"] = fit.seed;
}

Json json_start(const Options& options, const SurfaceInput& input, const std::string& form) {
    Json document = json_document("fit");
    document["source"] = json_source(options.surface, input);
    Json inputs = json_inputs(options.surface, form);
    inputs.update({{"window", options.window},
                   {"tip_radius", options.surface.tip_radius},
                   {"resolution", options.surface.resolution},
                   {"seed", options.seed},
                   {"resamples", options.resamples},
                   {"convention", name_of(options.convention)}});
    document["inputs"] = inputs;
    document["equations"] = {{"structure_function", "(2.8)"},
                             {"fit", "(2.5), of second differences"},
                             {"constant", "(2.4), convention " + std::string(name_of(options.convention))},
                             {"peak_ratio", "(4.3)"}};
    return document;
}

Json json(const Options& options, const SurfaceInput& input, const ProfileResult& result) {
    Json document = json_start(options, input, result.levelled.form);
    put_fit(document, result.fit);
    put_cut_offs(document, result.levelled.cut_offs);
    document["rms_height_m"] = result.levelled.rms;
    document["rms_height_before_detrend_m"] = result.levelled.rms_as_read;
    document["points"] = input.points();
    document["missing_points"] = input.missing();
    document["spacing_m"] = result.levelled.profile.spacing;
    if (const auto& s = result.spectrum)
        document["power_spectrum"] = {{"fractal_dimension", s->dimension},
                                      {"fractal_dimension_error", s->dimension_error},
                                      {"wavelengths_m", Json(std::vector<double>{s->window.from, s->window.to})}};
    else
        document["power_spectrum"] = {{"refused", result.no_spectrum}};
    if (const auto& m = result.moments)
        document["spectral_moments"] = {
            {"m0_m2", m->m0}, {"m2", m->m2}, {"m4_per_m2", m->m4}, {"nayak_alpha", m->bandwidth()}};
    else
        document["spectral_moments"] = {{"refused", result.no_moments}};
    if (const auto& p = result.peaks)
        document["peak_statistics"] = {{"rms_height_m", p->rms_height},
                                       {"rms_slope", p->rms_slope},
                                       {"rms_curvature_per_m", p->rms_curvature},
                                       {"r", p->r},
                                       {"theta", p->theta},
                                       {"counted_peak_ratio", p->counted_peak_ratio},
                                       {"peak_ratio", p->peak_ratio()}};
    else
        document["peak_statistics"] = {{"refused", result.no_peaks}};
    document["structure_function"] = rows_of(result.fit, result.structure).arrays();
    return document;
}

Json json(const Options& options, const SurfaceInput& input, const MapResult& result) {
    Json document = json_start(options, input, result.levelled.form);
    const HeightMap<double>& map = result.levelled.map;
    document["columns"] = map.columns();
    document["rows"] = map.rows();
    document["dx_m"] = map.dx;
    document["dy_m"] = map.dy;
    document["missing_points"] = input.missing();
    put_cut_offs(document, result.levelled.cut_offs);
    document["rms_height_m"] = result.levelled.rms;
    document["rms_height_before_detrend_m"] = result.levelled.rms_as_read;
    const ArealStatistics<double>& a = result.levelled.areal;
    document["areal"] = {{"m0_m2", a.m0},
                         {"m2", a.m2},
                         {"m2_x", a.m2_x},
                         {"m2_y", a.m2_y},
                         {"m4_per_m2", a.m4},
                         {"m4_x_per_m2", a.m4_x},
                         {"m4_y_per_m2", a.m4_y},
                         {"nayak_alpha", a.nayak},
                         {"rms_gradient", a.rms_gradient},
                         {"summits", a.summits},
                         {"summit_density_per_m2", a.summit_density},
                         {"summit_curvature_per_m", a.summit_curvature},
                         {"summit_height_m", a.summit_height}};
    const auto direction = [&](const std::optional<FractalFit<double>>& fit, const std::string& refusal) {
        Json part;
        if (!fit) return Json{{"refused", refusal}};
        put_fit(part, *fit);
        part["structure_function"] = rows_of(*fit, fit->structure_function).arrays();
        return part;
    };
    document["x"] = direction(result.fit.x, result.fit.why_no_fit_x);
    document["y"] = direction(result.fit.y, result.fit.why_no_fit_y);
    document["anisotropic"] = result.fit.anisotropic();
    document["fractal_dimension_difference"] = result.fit.dimension_difference;
    document["fractal_dimension_difference_error"] = result.fit.dimension_difference_error;
    document["log_structure_difference"] = result.fit.log_level_difference;
    document["log_structure_difference_error"] = result.fit.log_level_difference_error;
    return document;
}

/// G with its error; two digits where it is not known to a factor of two.
std::string roughness_text(const FractalFit<double>& fit) {
    const Measurement<double> g{fit.fractal.roughness, fit.roughness_error};
    return "G = " + rounded(g.value, is_known(g) ? 5 : 2) + " m +- " + rounded(g.error, 2) + " m";
}

std::string window_line(const FractalFit<double>& fit) {
    return shown_length(fit.window.from) + " to " + shown_length(fit.window.to) + " (" +
           (fit.automatic_window ? "automatic" : "given") + ", " + std::to_string(fit.lags) + " lags; local slope " +
           rounded(fit.slope_shortest, 3) + " to " + rounded(fit.slope_longest, 3) + ")";
}

std::string window_reason(const FractalFit<double>& fit) {
    return "begins " + std::string(describe(fit.begins)) + ", ends " + std::string(describe(fit.ends)) +
           (fit.reliable_from > 0 ? "; lags below " + shown_length(fit.reliable_from) + " are left out" : "");
}

std::string errors_line(const Options& options, const FractalFit<double>& fit) {
    return "errors of D: window " + rounded(fit.window_dimension_error, 2) + ", sampling " +
           rounded(fit.sampling_dimension_error, 2) + "; of that model " + rounded(fit.model_dimension_error, 2) +
           (options.resamples > 0
                ? ", block bootstrap " + rounded(fit.bootstrap_dimension_error, 2) + " (" +
                      std::to_string(options.resamples) + " resamples, seed " + std::to_string(options.seed) + ")"
                : ", no bootstrap");
}

std::string table(const Options& options, const SurfaceInput& input, const ProfileResult& result) {
    const FractalFit<double>& fit = result.fit;
    std::string text = "fstiff " FSTIFF_VERSION ": fractal fit of " + display_name(options.surface.file) + "\n" +
                       source_lines(input, "  file     ");
    text += "  profile  spacing " + shown_length(result.levelled.profile.spacing) + ", length " +
            shown_length(result.levelled.profile.length()) + "\n";
    text += "  Rq       " + shown_length(result.levelled.rms_as_read) + " as read, " +
            shown_length(result.levelled.rms) + " after removal of the form (" + result.levelled.form +
            (result.levelled.form == gaussian_form ? ", cut-off " + shown_length(*result.levelled.cutoff) : "") + ")\n";
    text += "  cut-offs " + result.levelled.cut_offs.sentence() + "\n";
    text += "  window   " + window_line(fit) + "\n           " + window_reason(fit) + "\n\n";
    text += "  D = " + rounded(fit.fractal.dimension) + " +- " + rounded(fit.dimension_error, 2) +
            "   (regression alone, too small: " + rounded(fit.regression_dimension_error, 2) + ")\n";
    text += "  " + roughness_text(fit) + "   (convention " + std::string(name_of(options.convention)) + "; ln G +- " +
            rounded(fit.log_roughness_error, 2) + ")\n";
    text += "  " + errors_line(options, fit) + "\n";
    text +=
        "  D by ordinary least squares " + rounded(fit.line_dimension) + "; by the power spectrum " +
        (result.spectrum ? rounded(result.spectrum->dimension) + " +- " + rounded(result.spectrum->dimension_error, 2) +
                               " (wavelengths " + shown_length(result.spectrum->window.from, 4) + " to " +
                               shown_length(result.spectrum->window.to, 4) + ")"
                         : "none: " + result.no_spectrum) +
        "\n";
    if (const auto& m = result.moments)
        text += "  moments  m0 " + rounded(m->m0 * 1e12) + " µm², m2 " + rounded(m->m2) + ", m4 " +
                rounded(m->m4 * 1e-12) + " /µm², Nayak's alpha " + rounded(m->bandwidth()) + "\n";
    else
        text += "  moments  none: " + result.no_moments + "\n";
    if (const auto& p = result.peaks)
        text += "  peaks    sigma_m " + rounded(p->rms_slope) + ", sigma_kappa " + rounded(p->rms_curvature * 1e-6) +
                " /µm, r " + rounded(p->r) + ", theta " + rounded(p->theta) + "; peaks/ordinates counted " +
                rounded(p->counted_peak_ratio, 4) + ", theta/pi " + rounded(p->peak_ratio(), 4) + " (4.3)\n";
    else
        text += "  peaks    none: " + result.no_peaks + "\n";
    text += "\n";

    constexpr std::size_t shown = 24;
    const std::size_t size = result.structure.size(), step = (size + shown - 1) / shown;
    text += rows_of(fit, result.structure).text([&](std::size_t i) { return i % step == 0; });
    if (step > 1)
        text += "  every " + std::to_string(step) + ". of " + std::to_string(size) + " lags; all with --format csv\n";
    return text;
}

std::string table(const Options& options, const SurfaceInput& input, const MapResult& result) {
    const HeightMap<double>& map = result.levelled.map;
    const ArealStatistics<double>& a = result.levelled.areal;
    std::string text = "fstiff " FSTIFF_VERSION ": fractal fit of the map " + display_name(options.surface.file) +
                       "\n" + source_lines(input, "  file     ");
    text += "  map      " + std::to_string(map.columns()) + " x " + std::to_string(map.rows()) + " points, dx " +
            shown_length(map.dx) + ", dy " + shown_length(map.dy) + "\n";
    text += "  Sq       " + shown_length(result.levelled.rms_as_read) + " as read, " +
            shown_length(result.levelled.rms) + " after removal of the form (" + result.levelled.form + ")\n";
    text += "  cut-offs " + result.levelled.cut_offs.sentence() + "\n";
    text += "  moments  m2 " + rounded(a.m2) + " (x " + rounded(a.m2_x) + ", y " + rounded(a.m2_y) + "), m4 " +
            rounded(a.m4 * 1e-12) + " /µm², Nayak's alpha " + rounded(a.nayak) + "\n";
    text += "  summits  " + std::to_string(a.summits) + ", density " + rounded(a.summit_density * 1e-6) +
            " /mm², mean curvature " + rounded(a.summit_curvature * 1e-6) + " /µm\n\n";
    const auto direction = [&](const char* name, const std::optional<FractalFit<double>>& fit) {
        if (!fit) return std::string("  along ") + name + "  no fit\n";
        const std::string indent(11, ' ');
        return std::string("  along ") + name + "  D = " + rounded(fit->fractal.dimension) + " +- " +
               rounded(fit->dimension_error, 2) + " (ordinary least squares " + rounded(fit->line_dimension) + " +- " +
               rounded(fit->regression_dimension_error, 2) + ", too small)\n" + indent + roughness_text(*fit) +
               "   (convention " + std::string(name_of(options.convention)) + ")\n" + indent + "window " +
               window_line(*fit) + "\n" + indent + window_reason(*fit) + "\n";
    };
    text += direction("x", result.fit.x) + direction("y", result.fit.y);
    return text;
}

template <class Result>
// NOLINTNEXTLINE(performance-unnecessary-value-param): moved below, where clang-tidy 14 does not look
Report report_of(const Options& options, const SurfaceInput& input, const Result& result, Strings summaries) {
    return report({.table = [&] { return table(options, input, result); },
                   .csv = [&] { return csv(result); },
                   .json = [&] { return json(options, input, result); },
                   .warnings = warnings(input, result),
                   .csv_notes = std::move(summaries)},
                  options.output.format);
}

std::string summary(const FractalFit<double>& fit, const std::string& where = "") {
    return where + "D = " + shortest(fit.fractal.dimension) + " +- " + rounded(fit.dimension_error, 2) +
           ", G = " + shortest(fit.fractal.roughness) + " m +- " + rounded(fit.roughness_error, 2) + " m";
}

Report execute(const Options& options) {
    (void)fit_options(options);  // what is wrong with them is said before the file is read
    SurfaceInput input = read_surface_input(options.surface);
    if (input.surface.is_profile()) {
        const ProfileResult result = fit_profile(options, input);
        return report_of(options, input, result, {summary(result.fit)});
    }
    const MapResult result = fit_map(options, input);
    Strings summaries;
    if (result.fit.x) summaries.push_back(summary(*result.fit.x, "along x: "));
    if (result.fit.y) summaries.push_back(summary(*result.fit.y, "along y: "));
    return report_of(options, input, result, std::move(summaries));
}

}  // namespace

Command add_fit(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "fit", "Fractal dimension D and roughness G of a measured profile or map, with errors");
    command
        .option("profile", options->surface.file, "profile or map, as fstiff formats lists them; - is standard input")
        .required();
    add_surface_options(command, options->surface);
    command.option("--window", options->window,
                   "shortest and longest lag of the fit, such as \"1 um,100 um\"; the default is chosen automatically");
    command.option("--tip-radius", options->surface.tip_radius,
                   "radius of the stylus, such as \"2 um\": lags that may show it are left out (profiles)");
    command.option("--resolution", options->surface.resolution,
                   "lateral resolution of the instrument; shorter lags are left out of the fit");
    command.option("--convention", options->convention,
                   "constant C of eq. (2.4) that gives G: exact (default), paper or majumdar_tien");
    command.option("--seed", options->seed, "seed of the random numbers of the bootstrap; the default is 2014");
    command
        .option("--resamples", options->resamples,
                "number of resamples of the bootstrap; the default is 200, and 0 leaves the bootstrap out")
        .between(0, 100000);
    command.flag("--all-lags", options->all_lags, "compute the structure function at every lag (profiles only)");
    add_output_options(command, options->output);
    command.footer(
        "The CSV is the structure function; the JSON holds everything. The example makes a random walk, D = 1.5.\n"
        "Example:\n"
        "  awk 'BEGIN { srand(1); for (i = 0; i < 4096; ++i) print z += rand() - 0.5 }' |\n"
        "      fstiff fit - --spacing \"0.5 um\" --units um");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
