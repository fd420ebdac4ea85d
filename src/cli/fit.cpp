// SPDX-License-Identifier: BSD-3-Clause
// fstiff fit: fractal dimension D and roughness G of a measured profile, with errors.
#include "commands.hpp"
#include "profile_options.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/profile/fractal_fit.hpp>

#include <memory>
#include <numbers>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    ProfileOptions profile;
    std::string window;
    std::string convention = "exact";
};

LagWindow<double> parse_window(const std::string& text) {
    const auto comma = text.find(',');
    if (comma == std::string::npos)
        throw Usage("--window = \"" + text + "\": must be two lengths, such as \"1 um,100 um\"");
    return {io::parse_quantity(text.substr(0, comma), io::Dimension::length, "--window"),
            io::parse_quantity(text.substr(comma + 1), io::Dimension::length, "--window")};
}

/// Below this local slope S counts as flat.
constexpr double saturated = 0.2;

bool in_window(const FractalFit<double>& fit, double lag) { return lag >= fit.window.from && lag <= fit.window.to; }

std::vector<std::string> warnings(const FractalFit<double>& fit, const Measured& measured) {
    std::vector<std::string> all;
    if (fit.curved)
        all.push_back("the local slope of S varies between " + rounded(fit.slope_least, 3) + " and " +
                      rounded(fit.slope_greatest, 3) +
                      " over the window: this is no single power law, and D is a mean over it");
    if (fit.automatic_window && fit.flattest_lag > 0 && fit.flattest_slope < saturated &&
        fit.slope_least > fit.flattest_slope + 0.5)
        all.push_back("S is nearly flat (slope " + rounded(fit.flattest_slope, 2) + ") at a lag of " +
                      rounded(fit.flattest_lag * 1e6, 3) +
                      " µm, shorter than the window: the roughness has saturated there, and D is that of the waviness; "
                      "--window looks elsewhere");
    if (fit.log_roughness_error > std::numbers::ln10)
        all.push_back("G is known to no better than a factor of 10: D is close to 1, where G hardly matters");
    if (measured.record.missing > 0)
        all.push_back(std::to_string(measured.record.missing) + " of " + std::to_string(measured.record.points) +
                      " points are missing; their pairs are left out");
    return all;
}

std::string csv(const FractalFit<double>& fit) {
    const auto& s = fit.structure_function;
    std::string text = csv_line({"lag_m", "value_m2", "pairs", "in_window"});
    for (std::size_t i = 0; i < s.size(); ++i)
        text += csv_line(
            {exact(s.lag[i]), exact(s.value[i]), std::to_string(s.pairs[i]), in_window(fit, s.lag[i]) ? "1" : "0"});
    return text;
}

std::string json(const Options& options, const Measured& measured, const FractalFit<double>& fit) {
    const auto numbers = [](const std::vector<double>& values) {
        Json list = Json::array();
        for (const double value : values) list.push_back(json_number(value));
        return list;
    };
    Json document = json_document("fit");
    document["source"] = json_source(options.profile, measured);
    document["inputs"] = {{"spacing", options.profile.spacing}, {"units", options.profile.units},
                          {"column", options.profile.column},   {"detrend", options.profile.form},
                          {"window", options.window},           {"convention", options.convention}};
    document["equations"] = {
        {"structure_function", "(2.8)"}, {"fit", "(2.5)"}, {"constant", "(2.4), convention " + options.convention}};
    document["fractal_dimension"] = json_number(fit.fractal.dimension);
    document["fractal_dimension_error"] = json_number(fit.dimension_error);
    document["fractal_dimension_regression_error"] = json_number(fit.regression_dimension_error);
    document["fractal_roughness_m"] = json_number(fit.fractal.roughness);
    document["fractal_roughness_error_m"] = json_number(fit.roughness_error);
    document["log_fractal_roughness_error"] = json_number(fit.log_roughness_error);
    document["window_m"] = numbers({fit.window.from, fit.window.to});
    document["window_automatic"] = fit.automatic_window;
    document["lags_in_window"] = fit.lags;
    document["slope_at_window_ends"] = numbers({fit.slope_shortest, fit.slope_longest});
    document["slope_range_in_window"] = numbers({fit.slope_least, fit.slope_greatest});
    document["curved"] = fit.curved;
    document["log_periodic_terms"] = fit.log_periodic;
    document["finite_band_terms"] = fit.finite_band;
    document["bootstrap_seed"] = fit.seed;
    document["rms_height_m"] = json_number(measured.rms_height);
    document["rms_height_before_detrend_m"] = json_number(measured.rms_height_as_read);
    document["points"] = measured.record.points;
    document["missing_points"] = measured.record.missing;
    document["spacing_m"] = json_number(measured.profile.spacing);
    const auto& s = fit.structure_function;
    document["structure_function"] = {{"lag_m", numbers(s.lag)}, {"value_m2", numbers(s.value)}, {"pairs", s.pairs}};
    document["warnings"] = warnings(fit, measured);
    return json_text(document);
}

std::string table(const Options& options, const Measured& measured, const FractalFit<double>& fit) {
    std::string text = "fstiff " FSTIFF_VERSION ": fractal fit of " + display_name(options.profile.file) + "\n";
    for (const std::string& decision : measured.record.sentences()) text += "  file     " + decision + "\n";
    text += "  profile  spacing " + rounded(measured.profile.spacing * 1e6) + " µm, length " +
            rounded(measured.profile.length() * 1e6) + " µm\n";
    text += "  Rq       " + rounded(measured.rms_height_as_read * 1e6) + " µm as read, " +
            rounded(measured.rms_height * 1e6) + " µm after removal of the form (" + options.profile.form + ")\n";
    text += "  window   " + rounded(fit.window.from * 1e6) + " to " + rounded(fit.window.to * 1e6) + " µm (" +
            (fit.automatic_window ? "automatic" : "given") + ", " + std::to_string(fit.lags) +
            " lags; local slope of S " + rounded(fit.slope_shortest, 3) + " to " + rounded(fit.slope_longest, 3) +
            ")\n\n";
    text += "  D = " + rounded(fit.fractal.dimension) + " +- " + rounded(fit.dimension_error, 2) +
            "   (regression alone, too small: " + rounded(fit.regression_dimension_error, 2) + ")\n";
    text += "  G = " + rounded(fit.fractal.roughness) + " m +- " + rounded(fit.roughness_error, 2) +
            " m   (convention " + options.convention + "; ln G +- " + rounded(fit.log_roughness_error, 2) + ")\n\n";

    const auto& s = fit.structure_function;
    constexpr std::size_t shown = 24;
    const std::size_t step = (s.size() + shown - 1) / shown;
    TextTable rows({"lag [µm]", "S [µm²]", "pairs", "window"});
    for (std::size_t i = 0; i < s.size(); i += step)
        rows.add({rounded(s.lag[i] * 1e6), rounded(s.value[i] * 1e12), std::to_string(s.pairs[i]),
                  in_window(fit, s.lag[i]) ? "*" : ""});
    text += rows.str();
    if (step > 1)
        text +=
            "  every " + std::to_string(step) + ". of " + std::to_string(s.size()) + " lags; all with --format csv\n";
    for (const std::string& warning : warnings(fit, measured)) text += "warning: " + warning + "\n";
    return text;
}

Report execute(const Options& options) {
    FractalFitOptions<double> how;
    if (!options.window.empty()) how.window = parse_window(options.window);
    how.convention = options.convention == "paper"           ? StructureConvention::paper
                     : options.convention == "majumdar_tien" ? StructureConvention::majumdar_tien
                                                             : StructureConvention::exact;
    const Measured measured = measure(options.profile);
    const auto fit = about_file(options.profile.file, [&] { return fit_fractal(measured.profile, how); });

    Report report;
    if (options.output.format == Format::table) {
        report.document = table(options, measured, fit);
        return report;
    }
    report.document = options.output.format == Format::csv ? csv(fit) : json(options, measured, fit);
    if (options.output.format == Format::csv)
        report.diagnostics.push_back("D = " + shortest(fit.fractal.dimension) + " +- " +
                                     rounded(fit.dimension_error, 2) + ", G = " + shortest(fit.fractal.roughness) +
                                     " m +- " + rounded(fit.roughness_error, 2) + " m");
    for (const std::string& warning : warnings(fit, measured)) report.diagnostics.push_back("warning: " + warning);
    return report;
}

}  // namespace

Command add_fit(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("fit", "Fractal dimension D and roughness G of a measured profile, with errors");
    command->add_option("profile", options->profile.file, "delimited text of one or two columns; - is standard input")
        ->required();
    add_profile_options(*command, options->profile);
    command->add_option("--window", options->window,
                        "lags that are fitted, such as \"1 um,100 um\"; default automatic");
    command
        ->add_option("--convention", options->convention,
                     "constant C of eq. (2.4) that gives G: exact (default), paper or majumdar_tien")
        ->check(CLI::IsMember({"exact", "paper", "majumdar_tien"}));
    add_output_options(*command, options->output);
    command->footer(
        "The CSV is the structure function; the JSON holds everything. The example makes a random walk, D = 1.5.\n"
        "Example:\n"
        "  awk 'BEGIN { srand(1); for (i = 0; i < 4096; ++i) print z += rand() - 0.5 }' |\n"
        "      fstiff fit - --spacing \"0.5 um\" --units um");
    return {command, &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
