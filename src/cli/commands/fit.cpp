// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --show fit: fractal dimension D and roughness G of a measured profile or map, with errors.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"
#include "input/progress.hpp"
#include "input/surface_options.hpp"
#include "surface/fractal.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/measured/measured_concerns.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include <memory>

namespace fstiff::cli {
namespace fit_command {
namespace {

struct Options {
    OutputOptions output;
    FractalOptions fractal;
};

using Strings = std::vector<std::string>;

std::string csv(const ProfileFractal& result) { return rows_of(result.fit, result.structure).csv(); }

std::string csv(const MapFractal& result) {
    std::string text;
    if (const auto& x = result.fit.x) text += rows_of(*x, x->structure_function, "x").csv();
    if (const auto& y = result.fit.y) text += rows_of(*y, y->structure_function, "y").csv(text.empty());
    return text;
}

/// G with its error; two digits where it is not known to a factor of two.
std::string roughness_text(const FractalFit<double>& fit) {
    const Measurement<double> g{fit.fractal.roughness, fit.roughness_error};
    return "G = " + rounded(g.value, parts::is_known(g) ? 5 : 2) + " m +- " + rounded(g.error, 2) + " m";
}

std::string window_line(const FractalFit<double>& fit) {
    return shown_length(fit.window.from) + " to " + shown_length(fit.window.to) + " (" +
           (fit.automatic_window ? "automatic" : "given") + ", " + std::to_string(fit.lags) + " lags; local slope " +
           rounded(fit.slope_shortest, 3) + " to " + rounded(fit.slope_longest, 3) + ")";
}

std::string window_reason(const FractalFit<double>& fit) {
    return "begins " + std::string(parts::describe(fit.begins)) + ", ends " + std::string(parts::describe(fit.ends)) +
           (fit.reliable_from > 0 ? "; lags below " + shown_length(fit.reliable_from) + " are left out" : "");
}

std::string errors_line(const FractalOptions& options, const FractalFit<double>& fit) {
    return "errors of D: window " + rounded(fit.window_dimension_error, 2) + ", sampling " +
           rounded(fit.sampling_dimension_error, 2) + "; of that model " + rounded(fit.model_dimension_error, 2) +
           (options.resamples > 0
                ? ", block bootstrap " + rounded(fit.bootstrap_dimension_error, 2) + " (" +
                      std::to_string(options.resamples) + " resamples, seed " + std::to_string(options.seed) + ")"
                : ", no bootstrap");
}

std::string table(const FractalOptions& options, const SurfaceInput& input, const ProfileFractal& result) {
    const FractalFit<double>& fit = result.fit;
    std::string text = "fstiff " FSTIFF_VERSION_TEXT ": fractal fit of " + shown_name(options.surface.file) + "\n" +
                       source_lines(input, "  file     ");
    text += "  profile  spacing " + shown_length(result.levelled.profile.spacing) + ", length " +
            shown_length(result.levelled.profile.length()) + "\n";
    text += "  Rq       " + shown_length(result.levelled.rms_as_read) + " as read, " +
            shown_length(result.levelled.rms) + " after removal of the form (" + form_name(result.levelled) +
            (result.levelled.cutoff ? ", cut-off " + shown_length(*result.levelled.cutoff) : "") + ")\n";
    text += "  cut-offs " + sentence_of(result.levelled.cut_offs) + "\n";
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

std::string table(const FractalOptions& options, const SurfaceInput& input, const MapFractal& result) {
    const HeightMap<double>& map = result.levelled.map;
    const parts::ArealStatistics<double>& a = result.levelled.areal;
    std::string text = "fstiff " FSTIFF_VERSION_TEXT ": fractal fit of the map " + shown_name(options.surface.file) +
                       "\n" + source_lines(input, "  file     ");
    text += "  map      " + std::to_string(map.columns()) + " x " + std::to_string(map.rows()) + " points, dx " +
            shown_length(map.dx) + ", dy " + shown_length(map.dy) + "\n";
    text += "  Sq       " + shown_length(result.levelled.rms_as_read) + " as read, " +
            shown_length(result.levelled.rms) + " after removal of the form (" + form_name(result.levelled) + ")\n";
    text += "  cut-offs " + sentence_of(result.levelled.cut_offs) + "\n";
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
    return report({.table = [&] { return table(options.fractal, input, result); },
                   .csv = [&] { return csv(result); },
                   .json = [&] { return fractal_json(options.fractal, input, result); },
                   .warnings = warnings_of(options.fractal, input, result),
                   .csv_notes = std::move(summaries),
                   .status = result.doubtful() ? doubtful_result : success},
                  options.output.format);
}

std::string summary(const FractalFit<double>& fit, const std::string& where = "") {
    return where + "D = " + shortest(fit.fractal.dimension) + " +- " + rounded(fit.dimension_error, 2) +
           ", G = " + shortest(fit.fractal.roughness) + " m +- " + rounded(fit.roughness_error, 2) + " m";
}

Report execute(const Options& options) {
    FractalOptions how = options.fractal;
    (void)fit_options(how);  // their errors are reported before the file is read
    SurfaceInput input = read_surface_input(how.surface);
    how.progress = progress_bar();
    if (input.surface.is_profile()) {
        const ProfileFractal result = fractal_of_profile(how, input);
        return report_of(options, input, result, {summary(result.fit)});
    }
    const MapFractal result = fractal_of_map(how, input);
    Strings summaries;
    if (result.fit.x) summaries.push_back(summary(*result.fit.x, "along x: "));
    if (result.fit.y) summaries.push_back(summary(*result.fit.y, "along y: "));
    return report_of(options, input, result, std::move(summaries));
}

}  // namespace
}  // namespace fit_command

Command add_fit(Arguments& command) {
    using namespace fit_command;
    auto options = std::make_shared<Options>();
    command.option("profile", options->fractal.surface.file,
                   {.help = "profile or map, as fstiff formats lists them; - is standard input", .required = true});
    add_surface_options(command, options->fractal.surface);
    for (const char* key : {"window", "tip_radius", "resolution"})
        add_surface_option(command, options->fractal.surface, key);
    command.fields(options->fractal);
    add_output_options(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
