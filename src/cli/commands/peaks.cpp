// SPDX-License-Identifier: BSD-3-Clause
// fstiff peaks: the density of peak heights and curvatures, its moments and its height marginal.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/surface_options.hpp"
#include "surface/documents.hpp"
#include "document/shown_unit.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/profile/peak_statistics.hpp>

#include <cmath>
#include <memory>
#include <optional>

namespace fstiff::cli {
namespace peaks_command {
namespace {

struct Options {
    OutputOptions output;
    std::optional<double> r, rho1, rho2;
    std::string theta;
    bool exponential = false;
    SurfaceOptions surface;
    std::string heights;
};

struct Source {
    PeakDistribution<double> density;
    std::string from;
    std::optional<SurfaceInput> input;
    std::optional<PreparedProfile<double>> levelled;
    std::optional<PeakStatistics<double>> statistics;
};

Source choose(const Options& options) {
    const bool angles = options.r || !options.theta.empty() || options.exponential;
    const bool correlations = options.rho1 || options.rho2;
    const bool file = !options.surface.file.empty();
    if (int(angles) + int(correlations) + int(file) != 1)
        throw Usage("give one of --r and --theta, --theta and --exponential, --rho1 and --rho2, --profile");
    if (correlations) {
        if (!options.rho1 || !options.rho2) throw Usage("--rho1 and --rho2 belong together; give both");
        return {PeakDistribution<double>::from_autocorrelation(*options.rho1, *options.rho2), "rho1, rho2", {}, {}, {}};
    }
    if (file) {
        SurfaceInput input = read_surface_input(options.surface);
        PreparedProfile<double> levelled = level_profile(options.surface, input);
        const auto statistics = about_file(options.surface.file, [&] { return peak_statistics(levelled.profile); });
        return {PeakDistribution<double>(statistics.r, statistics.theta), "profile", std::move(input),
                std::move(levelled), statistics};
    }
    if (options.theta.empty() || options.exponential == options.r.has_value())
        throw Usage("--theta needs one of --r and --exponential beside it");
    const double theta = io::parse_angle(options.theta, "--theta");
    if (options.exponential)
        return {PeakDistribution<double>::exponential(theta), "exponential autocorrelation", {}, {}, {}};
    return {PeakDistribution<double>(*options.r, theta), "r, theta", {}, {}, {}};
}

Numbers moments(const Source& source) {
    const auto& p = source.density;
    Numbers numbers{{"r", p.r()},
                    {"theta", p.theta()},
                    {"peak_ratio", p.peak_ratio()},
                    {"mean_height", p.mean_height()},
                    {"height_variance", p.height_variance()},
                    {"height_skewness", p.height_skewness()},
                    {"height_kurtosis", p.height_kurtosis()}};
    for (int n = 1; n <= 4; ++n) numbers.emplace_back("curvature_moment_" + std::to_string(n), p.curvature_moment(n));
    if (const auto& s = source.statistics)
        numbers.insert(numbers.end(), {{"rms_height_m", s->rms_height},
                                       {"rms_slope", s->rms_slope},
                                       {"rms_curvature_per_m", s->rms_curvature},
                                       {"rho1", s->rho1},
                                       {"rho2", s->rho2},
                                       {"counted_peak_ratio", s->counted_peak_ratio},
                                       {"peaks_per_m", s->peaks_per_length}});
    return numbers;
}

/// The points of --heights FROM,TO,COUNT, within which the density is a normal number.
std::vector<double> parse_heights(const std::string& text) {
    constexpr double farthest = 30;
    constexpr int most = 100000;
    const auto refuse = [&] {
        return Usage("--heights = \"" + text +
                     "\": must be FROM,TO,COUNT with -30 <= FROM < TO <= 30 and a COUNT from 2 to 100000");
    };
    std::vector<double> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) {
        try {
            parts.push_back(io::parse_number(part, "--heights"));
        } catch (const domain_error&) {
            throw refuse();
        }
    }
    if (parts.size() != 3 || !(parts[0] < parts[1]) || parts[0] < -farthest || parts[1] > farthest || parts[2] < 2 ||
        parts[2] > most || parts[2] != std::floor(parts[2]))
        throw refuse();
    std::vector<double> heights;
    const int count = static_cast<int>(parts[2]);
    for (int i = 0; i < count; ++i) {
        const double share = i / (parts[2] - 1);
        heights.push_back((1 - share) * parts[0] + share * parts[1]);
    }
    return heights;
}

/// The density of the height alone, at \p heights.
Rows rows_of(const Source& source, const std::vector<double>& heights) {
    std::vector<double> density;
    for (const double height : heights) density.push_back(source.density.height_marginal(height));
    Rows rows;
    rows.repeat({.key = "r", .json = false}, source.density.r(), heights.size());
    rows.repeat({.key = "theta", .json = false}, source.density.theta(), heights.size());
    rows.add({"height", "height"}, heights);
    rows.add({"density", "density", 1, 6}, density);
    return rows;
}

Json json(const Options& options, const Source& source, const std::vector<double>& heights) {
    Json document = json_document("peaks");
    document["from"] = source.from;
    document["equations"] = {{"density", "(4.4)"}, {"peak_ratio", "(4.3)"}};
    if (source.input) {
        document["source"] = json_source(options.surface, *source.input);
        document["inputs"] = json_inputs(options.surface, form_name(*source.levelled));
        document["points"] = source.input->points();
        document["missing_points"] = source.input->missing();
        document["spacing_m"] = source.levelled->profile.spacing;
        document["detrend"] = form_name(*source.levelled);
    }
    put(document, moments(source));
    if (!heights.empty()) document["heights"] = rows_of(source, heights).arrays();
    return document;
}

std::string table(const Options& options, const Source& source, const std::vector<double>& heights) {
    const auto& p = source.density;
    std::string text = "fstiff " FSTIFF_VERSION ": peak density (4.4) from " + source.from;
    if (source.input) {
        text += " " + shown_name(options.surface.file) + "\n" + source_lines(*source.input, "  file              ");
        text += "  form removed      " + form_name(*source.levelled) + "; Rq " +
                shown_length(source.levelled->rms_as_read) + " before, " + shown_length(source.levelled->rms) + " after";
        if (source.levelled->cut_offs.any()) text += "; " + sentence_of(source.levelled->cut_offs);
    }
    text += "\n  r, theta          " + rounded(p.r(), 6) + ", " + rounded(p.theta(), 6) + " rad\n";
    text += "  peaks/ordinates   " + rounded(p.peak_ratio(), 6) + " (4.3)";
    if (const auto& s = source.statistics) text += ", counted " + rounded(s->counted_peak_ratio, 6);
    text += "\n  peak height       mean " + rounded(p.mean_height()) + ", variance " + rounded(p.height_variance()) +
            ", skewness " + rounded(p.height_skewness()) + ", kurtosis " + rounded(p.height_kurtosis(), 6) +
            " (in rms heights)\n";
    text += "  peak curvature    E t^n, n = 1 to 4: ";
    for (int n = 1; n <= 4; ++n) text += (n > 1 ? ", " : "") + rounded(p.curvature_moment(n), 6);
    text += " (in rms curvatures)\n";
    if (const auto& s = source.statistics) {
        text += "  ordinates         rms height " + shown_length(s->rms_height) + ", rms slope " +
                rounded(s->rms_slope) + ", rms curvature " + rounded(s->rms_curvature * 1e-6) + " /µm, rho1 " +
                rounded(s->rho1, 6) + ", rho2 " + rounded(s->rho2, 6) + "\n";
    }
    if (!heights.empty()) text += "\n" + rows_of(source, heights).text();
    return text;
}

Report execute(const Options& options) {
    const auto heights = options.heights.empty() ? std::vector<double>{} : parse_heights(options.heights);
    const Source source = choose(options);
    return report(
        {.table = [&] { return table(options, source, heights); },
         .csv = [&] { return heights.empty() ? csv(moments(source)) : rows_of(source, heights).csv(); },
         .json = [&] { return json(options, source, heights); },
         .warnings = source.input ? reading_warnings(*source.input, "their neighbours are no peaks",
                                                     source.levelled->rms_gradient)
                                  : std::vector<std::string>(),
         .status = source.levelled && !is_plausible_gradient(source.levelled->rms_gradient) ? doubtful_result : success,
         .json_warnings = false},
        options.output.format);
}

}  // namespace
}  // namespace peaks_command

Command add_peaks(CLI::App& app) {
    using namespace peaks_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "peaks", "Density of peak heights and curvatures: parameters, moments, height marginal");
    command.option("--r", options->r,
                   "correlation r of heights and curvatures, at least 0 and less than 1; needs --theta");
    command.option("--theta", options->theta,
                   "angle theta of the sampling: a number of radians, \"pi/4\" or \"45 deg\"");
    command.flag("--exponential", options->exponential,
                 "take the r that belongs to --theta for an exponential autocorrelation");
    command.option("--rho1", options->rho1, "autocorrelation at one sampling step, with --rho2");
    command.option("--rho2", options->rho2, "autocorrelation at two sampling steps");
    command.option("--profile", options->surface.file,
                   "measured profile, as fstiff formats lists them; - is standard input");
    add_surface_options(command, options->surface, SurfaceKind::profile);
    command.option("--heights", options->heights,
                   "FROM,TO,COUNT: print a table of the probability density of the height alone (Fig. 2)");
    add_output_options(command, options->output);
    command.footer(
        "Heights are in rms heights, curvatures in rms curvatures of the ordinates.\n"
        "Example:\n  fstiff peaks --r 0.5 --theta pi/3 --heights=-4,4,9");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
