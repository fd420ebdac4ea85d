// SPDX-License-Identifier: BSD-3-Clause
#include "actions/fractal.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/double/surfaces.hpp>
#include "actions/measure.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/measure/concerns.hpp>
#include <fstiff/measure/sections.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include <cmath>

namespace fstiff::actions {

using document::Document, document::Json, surface::SurfaceInput;

namespace {

using Strings = std::vector<std::string>;

/// Why a fit is flagged as curved.
std::string curved_sentence(const FractalFit<double>& fit) {
    const std::string slopes = "the local slope of the structure function " +
                               (fit.slope_longest < fit.slope_shortest - 0.3
                                    ? "falls from " + document::rounded(fit.slope_shortest, 3) + " to " +
                                          document::rounded(fit.slope_longest, 3) + " over the window"
                                    : "varies between " + document::rounded(fit.min_slope, 3) + " and " +
                                          document::rounded(fit.max_slope, 3) + " over the window") +
                               (fit.min_slope < 0.2 ? ": a part of it is a plateau" : "");
    for (const auto& beside : fit.neighbours)
        if (beside.disagrees)
            return slopes + "; " + (beside.half ? "its half" : "next to it the window") + " of " +
                   document::shown_length(beside.window.from, 3) + " to " +
                   document::shown_length(beside.window.to, 3) +
                   " gives D = " + document::rounded(beside.dimension, 3) + ", which differs by " +
                   document::rounded(std::abs(beside.difference), 2) + " where sampling explains " +
                   document::rounded(beside.difference_error, 2) +
                   ": this is not a single power law, and D is a mean over it";
    return slopes + ": this is not a single power law, and D is a mean over it";
}

std::string sentence(MeasuredConcern concern, const FractalFit<double>& fit, std::string_view prefix) {
    switch (concern) {
        case MeasuredConcern::curved: return curved_sentence(fit);
        case MeasuredConcern::saturated:
            return "the structure function is nearly flat (slope " + document::rounded(fit.flattest_slope, 2) +
                   ") at a lag of " + document::shown_length(fit.flattest_lag, 3) +
                   ", shorter than the window: the roughness has saturated there, and D is that of the waviness; " +
                   std::string(prefix) + "window looks elsewhere";
        case MeasuredConcern::roughness_uncertain:
            return "G is known to no better than a factor of 10: D is close to 1, where G hardly matters";
        default:
            return "the window reaches beyond a tenth of the cut-off, where S has lost some of what the filter took";
    }
}

void put_fit(Json& document, const FractalFit<double>& fit) {
    document["fractal_dimension"] = fit.fractal.dimension;
    document["fractal_dimension_error"] = fit.dimension_error;
    document["fractal_dimension_sampling_error"] = fit.sampling_dimension_error;
    document["fractal_dimension_window_error"] = fit.window_dimension_error;
    Json beside = Json::array();
    for (const auto& neighbour : fit.neighbours)
        beside.push_back({{"window_m", Json(std::vector<double>{neighbour.window.from, neighbour.window.to})},
                          {"half", neighbour.half},
                          {"fractal_dimension", neighbour.dimension},
                          {"difference", neighbour.difference},
                          {"difference_error", neighbour.difference_error},
                          {"disagrees", neighbour.disagrees}});
    document["neighbouring_windows"] = std::move(beside);
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
    document["window_begins"] = detail::describe(fit.begins);
    document["window_ends"] = detail::describe(fit.ends);
    document["reliable_from_m"] = fit.reliable_from;
    document["lags_in_window"] = fit.lags;
    document["slope_at_window_ends"] = Json(std::vector<double>{fit.slope_shortest, fit.slope_longest});
    document["slope_range_in_window"] = Json(std::vector<double>{fit.min_slope, fit.max_slope});
    document["curved"] = fit.curved;
    document["after_plateau"] = fit.after_plateau;
    document["log_periodic_terms"] = fit.log_periodic;
    document["finite_band_terms"] = fit.finite_band;
    document["bootstrap_seed"] = fit.seed;
    document["second_differences"] = lag_rows(fit, fit.second_differences).arrays();
    document["fitted"] = lag_rows(fit, fit.fitted).arrays();
}

Document begun(const FractalOptions& options, const SurfaceInput& input, const std::string& kind,
               const std::string& form) {
    Document document("fit");
    document.title("fractal fit of " + kind + document::shown_name(options.surface.file));
    add_source(document, options.surface, input, form);
    document.json["inputs"].update({{"window", options.surface.window.text("m")},
                                    {"tip_radius", options.surface.tip_radius.text("m")},
                                    {"resolution", options.surface.resolution.text("m")},
                                    {"seed", options.seed},
                                    {"resamples", options.resamples},
                                    {"convention", name_of(options.convention)}});
    document.json["equations"] = {{"structure_function", "(2.8)"},
                                  {"fit", "(2.5), of second differences"},
                                  {"constant", "(2.4), convention " + std::string(name_of(options.convention))},
                                  {"peak_ratio", "(4.3)"}};
    return document;
}

/// G with its error, two digits where it is not known to a factor of two, and the convention that it has.
std::string roughness_text(const FractalOptions& options, const FractalFit<double>& fit) {
    const Measurement<double> g{fit.fractal.roughness, fit.roughness_error};
    return "G = " + document::rounded(g.value, detail::is_known(g) ? 5 : 2) + " m +- " + document::rounded(g.error, 2) +
           " m   (convention " + std::string(name_of(options.convention));
}

std::string window_line(const FractalFit<double>& fit) {
    return document::shown_length(fit.window.from) + " to " + document::shown_length(fit.window.to) + " (" +
           (fit.automatic_window ? "automatic" : "given") + ", " + std::to_string(fit.lags) + " lags; local slope " +
           document::rounded(fit.slope_shortest, 3) + " to " + document::rounded(fit.slope_longest, 3) + ")";
}

std::string window_reason(const FractalFit<double>& fit) {
    return "begins " + std::string(detail::describe(fit.begins)) + ", ends " + std::string(detail::describe(fit.ends)) +
           (fit.reliable_from > 0 ? "; lags below " + document::shown_length(fit.reliable_from) + " are left out" : "");
}

std::string errors_line(const FractalOptions& options, const FractalFit<double>& fit) {
    return "errors of D: window " + document::rounded(fit.window_dimension_error, 2) + ", sampling " +
           document::rounded(fit.sampling_dimension_error, 2) + "; of that model " +
           document::rounded(fit.model_dimension_error, 2) +
           (options.resamples > 0
                ? ", block bootstrap " + document::rounded(fit.bootstrap_dimension_error, 2) + " (" +
                      std::to_string(options.resamples) + " resamples, seed " + std::to_string(options.seed) + ")"
                : ", no bootstrap");
}

std::string note_of(const FractalFit<double>& fit) {
    return "D = " + document::shortest(fit.fractal.dimension) + " +- " + document::rounded(fit.dimension_error, 2) +
           ", G = " + document::shortest(fit.fractal.roughness) + " m +- " + document::rounded(fit.roughness_error, 2) +
           " m";
}

Strings warnings_of(const FractalOptions& options, const ProfileFractal& result) {
    Strings sentences;
    for (const MeasuredConcern concern : detail::concerns_of<double>(result.fit, result.levelled, result.spectrum))
        sentences.push_back(concern == MeasuredConcern::spectrum_differs
                                ? "D from the power spectrum, " + document::rounded(result.spectrum->dimension, 4) +
                                      ", is another one: over its wavelengths the profile follows another law"
                                : sentence(concern, result.fit, options.surface.prefix));
    return sentences;
}

Strings warnings_of(const FractalOptions& options, const DirectionalFit<double>& fit) {
    Strings sentences;
    for (const auto* along : {&fit.x, &fit.y})
        if (*along)
            for (const MeasuredConcern concern : detail::concerns_of(**along))
                sentences.push_back((along == &fit.x ? "along x: " : "along y: ") +
                                    sentence(concern, **along, options.surface.prefix));
    if (!fit.x) sentences.push_back("along x: no fit: " + fit.why_no_fit_x);
    if (!fit.y) sentences.push_back("along y: no fit: " + fit.why_no_fit_y);
    if (fit.anisotropic())
        sentences.push_back(
            "the map is anisotropic: " +
            (fit.x && fit.y ? "D along x less D along y is " + document::rounded(fit.dimension_difference, 3) + " +- " +
                                  document::rounded(fit.dimension_difference_error, 2) + ", "
                            : std::string()) +
            "ln S along x less ln S along y " + document::rounded(fit.log_level_difference, 3) + " +- " +
            document::rounded(fit.log_level_difference_error, 2) + "; one D and one G do not describe it");
    return sentences;
}

/// Adds what the file has beyond D and G: D by other ways, moments and peaks.
void add_others(Document& document, const ProfileFractal& result) {
    const auto refuse = [&](const char* key, const char* label, const std::string& why) {
        document.json[key] = {{"refused", why}};
        document.line(label, "none: " + why);
    };
    const std::string by_line = "  D by ordinary least squares " + document::rounded(result.fit.line_dimension);
    if (const auto& s = result.spectrum) {
        document.json["power_spectrum"] = {{"fractal_dimension", s->dimension},
                                           {"fractal_dimension_error", s->dimension_error},
                                           {"wavelengths_m", Json(std::vector<double>{s->window.from, s->window.to})}};
        document.line(by_line + "; by the power spectrum " + document::rounded(s->dimension) + " +- " +
                      document::rounded(s->dimension_error, 2) + " (wavelengths " +
                      document::shown_length(s->window.from, 4) + " to " + document::shown_length(s->window.to, 4) +
                      ")");
    } else {
        document.json["power_spectrum"] = {{"refused", result.no_spectrum}};
        document.line(by_line + "; by the power spectrum none: " + result.no_spectrum);
    }
    if (const auto& m = result.moments)
        document.facts("moments",
                       {{"m0_m2", m->m0, "m0 ", 1e12, " µm²"},
                        {"m2", m->m2, ", m2 "},
                        {"m4_per_m2", m->m4, ", m4 ", 1e-12, " /µm²"},
                        {"nayak_alpha", m->bandwidth(), ", Nayak's alpha "}},
                       "spectral_moments");
    else
        refuse("spectral_moments", "moments", result.no_moments);
    if (const auto& p = result.peaks)
        document.facts("peaks",
                       {{"rms_height_m", p->rms_height},
                        {"rms_slope", p->rms_slope, "sigma_m "},
                        {"rms_curvature_per_m", p->rms_curvature, ", sigma_kappa ", 1e-6, " /µm"},
                        {"r", p->r, ", r "},
                        {"theta", p->theta, ", theta "},
                        {"counted_peak_ratio", p->counted_peak_ratio, "; peaks/ordinates counted ", 1, "", 4},
                        {"peak_ratio", p->peak_ratio(), ", theta/pi ", 1, " (4.3)", 4}},
                       "peak_statistics");
    else
        refuse("peak_statistics", "peaks", result.no_peaks);
}

Document of_profile(const FractalOptions& options, const SurfaceInput& input) {
    const ProfileFractal result = fractal_of_profile(options, input);
    const FractalFit<double>& fit = result.fit;
    const PreparedProfile<double>& levelled = result.levelled;
    const std::string form = surface::form_name(levelled);
    Document document = begun(options, input, "", form);
    Json& json = document.json;
    put_fit(json, fit);
    put_cut_offs(json, levelled.cut_offs);
    document.line("profile", "spacing " + document::shown_length(levelled.profile.spacing) + ", length " +
                                 document::shown_length(levelled.profile.length()));
    add_heights(document, "Rq", levelled,
                form + (levelled.cutoff ? ", cut-off " + document::shown_length(*levelled.cutoff) : ""));
    json["points"] = input.points();
    json["missing_points"] = input.missing();
    json["spacing_m"] = levelled.profile.spacing;
    document.line("window", window_line(fit));
    document.line("", window_reason(fit) + "\n");
    document.line("  D = " + document::rounded(fit.fractal.dimension) + " +- " +
                  document::rounded(fit.dimension_error, 2) +
                  "   (regression alone, too small: " + document::rounded(fit.regression_dimension_error, 2) + ")");
    document.line("  " + roughness_text(options, fit) + "; ln G +- " + document::rounded(fit.log_roughness_error, 2) +
                  ")");
    document.line("  " + errors_line(options, fit));
    add_others(document, result);
    document.line();
    document.table(lag_rows(fit, fit.structure_function), {.key = "structure_function", .thinned = "lags"});
    document.notes = {note_of(fit)};
    document.warnings = warnings_of(options, result);
    add_reading(document, input, "their pairs are left out", levelled.rms_gradient);
    return document;
}

/// D and G along \p name, or why there is none.
Json add_direction(Document& document, const FractalOptions& options, const std::string& name,
                   const std::optional<FractalFit<double>>& fit, const std::string& refusal) {
    const std::string along = "  along " + name + "  ", indent(11, ' ');
    if (!fit) {
        document.line(along + "no fit");
        return {{"refused", refusal}};
    }
    document.line(along + "D = " + document::rounded(fit->fractal.dimension) + " +- " +
                  document::rounded(fit->dimension_error, 2) + " (ordinary least squares " +
                  document::rounded(fit->line_dimension) + " +- " +
                  document::rounded(fit->regression_dimension_error, 2) + ", too small)");
    document.line(indent + roughness_text(options, *fit) + ")");
    document.line(indent + "window " + window_line(*fit));
    document.line(indent + window_reason(*fit));
    document.notes.push_back("along " + name + ": " + note_of(*fit));
    document.csv([fit = *fit, name] { return lag_rows(fit, fit.structure_function, name); });
    Json values;
    put_fit(values, *fit);
    values["structure_function"] = lag_rows(*fit, fit->structure_function).arrays();
    return values;
}

/// The fits along x and along y, one of them at least.
DirectionalFit<double> directions_of(const FractalOptions& options, const PreparedMap<double>& levelled) {
    FractalFitOptions<double> fitting = fit_options(options);
    fitting.progress = options.progress;
    fitting.lambda_s = levelled.cut_offs.lambda_s.value_or(0);
    return document::about_file(options.surface.file, [&] {
        DirectionalFit<double> fit = detail::fit_directions<double>(levelled, fitting);
        if (!fit.x && !fit.y)
            throw domain_error("no direction of the map allows a fit; along x: " + fit.why_no_fit_x +
                               "; along y: " + fit.why_no_fit_y);
        return fit;
    });
}

Document of_map(const FractalOptions& options, SurfaceInput& input) {
    const PreparedMap<double> levelled = level_map_of(options.surface, input);
    const DirectionalFit<double> fit = directions_of(options, levelled);
    Document document = begun(options, input, "the map ", surface::form_name(levelled));
    Json& json = document.json;
    add_grid(document, input, levelled);
    add_heights(document, "Sq", levelled, surface::form_name(levelled));
    const ArealStatistics<double>& a = levelled.areal;
    document.facts("moments",
                   {{"m0_m2", a.m0},
                    {"m2", a.m2, "m2 "},
                    {"m2_x", a.m2_x, " (x "},
                    {"m2_y", a.m2_y, ", y ", 1, ")"},
                    {"m4_per_m2", a.m4, ", m4 ", 1e-12, " /µm²"},
                    {"m4_x_per_m2", a.m4_x},
                    {"m4_y_per_m2", a.m4_y},
                    {"nayak_alpha", a.nayak, ", Nayak's alpha "},
                    {"rms_gradient", a.rms_gradient}},
                   "areal");
    document.facts("summits",
                   {{"summits", a.summits, ""},
                    {"summit_density_per_m2", a.summit_density, ", density ", 1e-6, " /mm²"},
                    {"summit_curvature_per_m", a.summit_curvature, ", mean curvature ", 1e-6, " /µm\n"},
                    {"summit_height_m", a.summit_height}},
                   "areal");
    json["x"] = add_direction(document, options, "x", fit.x, fit.why_no_fit_x);
    json["y"] = add_direction(document, options, "y", fit.y, fit.why_no_fit_y);
    json["anisotropic"] = fit.anisotropic();
    json["fractal_dimension_difference"] = fit.dimension_difference;
    json["fractal_dimension_difference_error"] = fit.dimension_difference_error;
    json["log_structure_difference"] = fit.log_level_difference;
    json["log_structure_difference_error"] = fit.log_level_difference_error;
    document.warnings = warnings_of(options, fit);
    add_reading(document, input, "they enter no difference", a.rms_gradient);
    return document;
}

}  // namespace

FractalFitOptions<double> fit_options(const FractalOptions& options) {
    FractalFitOptions<double> fitting;
    const surface::SurfaceOptions& surface = options.surface;
    if (!surface.window.empty()) fitting.window = surface::parse_window(surface.window, surface.name("window"));
    fitting.convention = options.convention;
    fitting.seed = options.seed;
    fitting.resamples = options.resamples;
    const surface::Instrument instrument = instrument_of(surface);
    fitting.tip_radius = instrument.tip_radius, fitting.resolution = instrument.resolution;
    return fitting;
}

ProfileFractal fractal_of_profile(const FractalOptions& options, const SurfaceInput& input) {
    FractalFitOptions<double> fitting = fit_options(options);
    fitting.progress = options.progress;
    ProfileFractal result;
    result.levelled = level_profile(options.surface, input);
    const Profile<double>& profile = result.levelled.profile;
    fitting.lambda_s = result.levelled.cut_offs.lambda_s.value_or(0);
    result.fit = document::about_file(options.surface.file, [&] { return fit_fractal(result.levelled, fitting); });
    result.no_spectrum = detail::fit_or_reason(result.spectrum, [&] {
        const PowerSpectrum<double> spectrum = power_spectrum(result.levelled.of_structure());
        std::optional<LengthRange<double>> window;  // without the waves below lambda_s
        if (const auto shortest = result.levelled.cut_offs.lambda_s; shortest && *shortest > 16 * profile.spacing)
            window = {*shortest, 2 * std::numbers::pi_v<double> / spectrum.step / 8};
        const detail::SpectralFit<double> fit = detail::fit_spectrum(spectrum, window);
        detail::require(fit.dimension > 1 && fit.dimension < 2, "D of the power spectrum", fit.dimension,
                        "between 1 and 2: over these wavelengths the profile is not self-affine");
        return fit;
    });
    result.no_moments = detail::fit_or_reason(result.moments, [&] { return detail::spectral_moments(profile); });
    result.no_peaks = detail::fit_or_reason(result.peaks, [&] { return peak_statistics(profile); });
    return result;
}

document::Rows lag_rows(const FractalFit<double>& fit, const StructureFunction<double>& s,
                        const std::string& direction) {
    const auto used = [&](double lag) { return lag >= fit.window.from && lag <= fit.window.to; };
    document::Rows rows;
    if (!direction.empty()) rows.repeat({.key = "direction", .json = false}, direction, s.size());
    rows.add({"lag_m", "lag [µm]", 1e6}, s.lag);
    rows.add({"value_m2", "S [µm²]", 1e12}, s.value);
    rows.add({"pairs", "pairs"}, s.pairs);
    rows.add({.key = "in_window", .json = false}, s.lag, [&](double lag) { return used(lag) ? 1 : 0; });
    rows.add({"", "window"}, s.lag, [&](double lag) { return used(lag) ? "*" : ""; });
    return rows;
}

Document document_of(const FractalOptions& options, std::optional<SurfaceInput> given) {
    (void)fit_options(options);  // their errors are reported before the file is read
    SurfaceInput input = input_of(options.surface, std::move(given));
    return input.surface.is_profile() ? of_profile(options, input) : of_map(options, input);
}

}  // namespace fstiff::actions
