// SPDX-License-Identifier: BSD-3-Clause
#include "surface/fractal.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"
#include "surface/documents.hpp"

#include <fstiff/measured/measured_concerns.hpp>
#include <fstiff/profile/all_lags.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include <cmath>

namespace fstiff::scene {
namespace {

using Strings = std::vector<std::string>;

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
            return slopes + "; " + (beside.half ? "its half" : "next to it the window") + " of " +
                   shown_length(beside.window.from, 3) + " to " + shown_length(beside.window.to, 3) +
                   " gives D = " + rounded(beside.dimension, 3) + ", which differs by " +
                   rounded(std::abs(beside.difference), 2) + " where sampling explains " +
                   rounded(beside.difference_error, 2) + ": this is not a single power law, and D is a mean over it";
    return slopes + ": this is not a single power law, and D is a mean over it";
}

std::string sentence(MeasuredConcern concern, const FractalFit<double>& fit, std::string_view prefix) {
    switch (concern) {
        case MeasuredConcern::curved: return curved_sentence(fit);
        case MeasuredConcern::saturated:
            return "the structure function is nearly flat (slope " + rounded(fit.flattest_slope, 2) + ") at a lag of " +
                   shown_length(fit.flattest_lag, 3) +
                   ", shorter than the window: the roughness has saturated there, and D is that of the waviness; " +
                   std::string(prefix) + "window looks elsewhere";
        case MeasuredConcern::roughness_uncertain:
            return "G is known to no better than a factor of 10: D is close to 1, where G hardly matters";
        default:
            return "the window reaches beyond a tenth of the cut-off, where S has lost some of what the filter took";
    }
}

void warn_of_fit(Strings& all, const FractalOptions& options, const FractalFit<double>& fit, const std::string& where) {
    for (const MeasuredConcern concern : concerns_of(fit))
        all.push_back(where + sentence(concern, fit, options.surface.prefix));
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
    document["window_begins"] = parts::describe(fit.begins);
    document["window_ends"] = parts::describe(fit.ends);
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

Json json_start(const FractalOptions& options, const SurfaceInput& input, const std::string& form) {
    Json document = json_document("fit");
    document["source"] = json_source(options.surface, input);
    Json inputs = json_inputs(options.surface, form);
    inputs.update({{"window", options.surface.window.text("m")},
                   {"tip_radius", options.surface.tip_radius.text("m")},
                   {"resolution", options.surface.resolution.text("m")},
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

}  // namespace

parts::FractalFitOptions<double> fit_options(const FractalOptions& options) {
    parts::FractalFitOptions<double> how;
    const SurfaceOptions& surface = options.surface;
    if (!surface.window.empty()) how.window = parse_window(surface.window, surface.name("window"));
    how.convention = options.convention;
    how.seed = options.seed;
    how.resamples = options.resamples;
    const Instrument instrument = instrument_of(surface);
    how.tip_radius = instrument.tip_radius, how.resolution = instrument.resolution;
    return how;
}

ProfileFractal fractal_of_profile(const FractalOptions& options, const SurfaceInput& input) {
    parts::FractalFitOptions<double> how = fit_options(options);
    how.progress = options.progress;
    ProfileFractal result;
    result.levelled = level_profile(options.surface, input);
    const Profile<double>& profile = result.levelled.profile;
    how.lambda_s = result.levelled.cut_offs.lambda_s.value_or(0);
    result.fit = about_file(options.surface.file, [&] { return fit_fractal(result.levelled, how); });
    result.no_spectrum = parts::fit_or_reason(result.spectrum, [&] {
        const PowerSpectrum<double> spectrum = power_spectrum(result.levelled.of_structure());
        std::optional<parts::WavelengthWindow<double>> window;  // without the waves below lambda_s
        if (const auto shortest = result.levelled.cut_offs.lambda_s; shortest && *shortest > 16 * profile.spacing)
            window = {*shortest, 2 * numbers::pi_v<double> / spectrum.step / 8};
        const parts::SpectralFit<double> fit = parts::fit_spectrum(spectrum, window);
        require(fit.dimension > 1 && fit.dimension < 2, "D of the power spectrum", fit.dimension,
                "between 1 and 2: over these wavelengths the profile is not self-affine");
        return fit;
    });
    result.no_moments = parts::fit_or_reason(result.moments, [&] { return parts::spectral_moments(profile); });
    result.no_peaks = parts::fit_or_reason(result.peaks, [&] { return peak_statistics(profile); });
    result.structure = options.all_lags ? parts::structure_function_at_all_lags(result.levelled.of_structure())
                                        : result.fit.structure_function;
    return result;
}

MapFractal fractal_of_map(const FractalOptions& options, SurfaceInput& input) {
    if (options.all_lags)
        throw option_error(options.surface.name("all_lags") + " is for profiles; must not be given for a map");
    parts::FractalFitOptions<double> how = fit_options(options);
    how.progress = options.progress;
    MapFractal result;
    result.levelled = level_map_of(options.surface, input);
    how.lambda_s = result.levelled.cut_offs.lambda_s.value_or(0);
    about_file(options.surface.file, [&] {
        result.fit = parts::fit_directions<double>(result.levelled, how);
        if (!result.fit.x && !result.fit.y)
            throw domain_error("no direction of the map allows a fit; along x: " + result.fit.why_no_fit_x +
                               "; along y: " + result.fit.why_no_fit_y);
    });
    return result;
}

Strings warnings_of(const FractalOptions& options, const SurfaceInput& input, const ProfileFractal& result) {
    Strings all;
    for (const MeasuredConcern concern : concerns_of<double>(result.fit, result.levelled, result.spectrum))
        all.push_back(concern == MeasuredConcern::spectrum_differs
                          ? "D from the power spectrum, " + rounded(result.spectrum->dimension, 4) +
                                ", is another one: over its wavelengths the profile follows another law"
                          : sentence(concern, result.fit, options.surface.prefix));
    for (std::string& line : reading_warnings(input, "their pairs are left out", result.levelled.rms_gradient))
        all.push_back(std::move(line));
    return all;
}

Strings warnings_of(const FractalOptions& options, const SurfaceInput& input, const MapFractal& result) {
    Strings all;
    if (result.fit.x) warn_of_fit(all, options, *result.fit.x, "along x: ");
    if (result.fit.y) warn_of_fit(all, options, *result.fit.y, "along y: ");
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
    for (std::string& line : reading_warnings(input, "they enter no difference", result.levelled.areal.rms_gradient))
        all.push_back(std::move(line));
    return all;
}

Rows rows_of(const FractalFit<double>& fit, const StructureFunction<double>& s, const std::string& direction) {
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

Json fractal_json(const FractalOptions& options, const SurfaceInput& input, const ProfileFractal& result) {
    Json document = json_start(options, input, form_name(result.levelled));
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

Json fractal_json(const FractalOptions& options, const SurfaceInput& input, const MapFractal& result) {
    Json document = json_start(options, input, form_name(result.levelled));
    put_grid(document, result.levelled.map, input.missing(), result.levelled.cut_offs);
    document["rms_height_m"] = result.levelled.rms;
    document["rms_height_before_detrend_m"] = result.levelled.rms_as_read;
    const parts::ArealStatistics<double>& a = result.levelled.areal;
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

}  // namespace fstiff::scene
