// SPDX-License-Identifier: BSD-3-Clause
#include "actions/peak_density.hpp"

#include <fstiff/double/surfaces.hpp>
#include <fstiff/io/quantities.hpp>
#include "actions/measure.hpp"

#include <cmath>
#include <sstream>
#include <utility>

namespace fstiff::actions {
namespace {

/// The points of \p text, within which the density is a normal number.
std::vector<double> heights_of(const std::string& text, const std::string& name) {
    constexpr double farthest = 30;
    constexpr int most = 100000;
    const auto refuse = [&] {
        return document::option_error(
            name + " = \"" + text +
            "\": must be FROM,TO,COUNT with -30 <= FROM < TO <= 30 and a COUNT from 2 to 100000");
    };
    std::vector<double> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) {
        try {
            parts.push_back(io::parse_number(part, name));
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

PeakDensity of_profile(const surface::SurfaceOptions& options, surface::SurfaceInput input) {
    PreparedProfile<double> levelled = level_profile(options, input);
    const auto statistics = document::about_file(options.file, [&] { return peak_statistics(levelled.profile); });
    return {.density = PeakDistribution<double>(statistics.r, statistics.theta),
            .from = "profile",
            .heights = {},
            .input = std::move(input),
            .levelled = std::move(levelled),
            .statistics = statistics};
}

PeakDensity of_numbers(const PeakDensityRequest& request) {
    const auto name = [&](std::string_view key) { return surface::option_name(request.surface.prefix, key); };
    if (request.rho1 || request.rho2) {
        if (!request.rho1 || !request.rho2)
            throw document::option_error(name("rho1") + " and " + name("rho2") + " belong together; give both");
        return {PeakDistribution<double>::from_autocorrelation(*request.rho1, *request.rho2), "rho1, rho2", {}};
    }
    if (request.theta.empty() || request.exponential == request.r.has_value())
        throw document::option_error(name("theta") + " needs one of " + name("r") + " and " + name("exponential") +
                                     " too");
    const double theta = request.theta.value(io::Dimension::angle, name("theta"));
    if (request.exponential) return {PeakDistribution<double>::exponential(theta), "exponential autocorrelation", {}};
    return {PeakDistribution<double>(*request.r, theta), "r, theta", {}};
}

/// The profile that the density is of.
void add_profile(document::Document& document, const PeakDensityRequest& request, const PeakDensity& peaks) {
    const PreparedProfile<double>& levelled = *peaks.levelled;
    const std::string form = surface::form_name(levelled);
    add_source(document, request.surface, *peaks.input, form);
    document.json.update({{"points", peaks.input->points()},
                          {"missing_points", peaks.input->missing()},
                          {"spacing_m", levelled.profile.spacing},
                          {"detrend", form}});
    document.line("form removed", form + "; Rq " + document::shown_length(levelled.rms_as_read) + " before, " +
                                      document::shown_length(levelled.rms) + " after" +
                                      (levelled.cut_offs.any() ? "; " + surface::sentence_of(levelled.cut_offs) : ""));
    add_reading(document, *peaks.input, "their neighbours are no peaks", levelled.rms_gradient);
}

/// r, theta, the moments, and what was counted.
void add_moments(document::Document& document, const PeakDistribution<double>& p,
                 const std::optional<PeakStatistics<double>>& counted) {
    document.facts("r, theta", {{"r", p.r(), "", 1, "", 6}, {"theta", p.theta(), ", ", 1, " rad", 6}});
    document.facts("peaks/ordinates",
                   {{"peak_ratio", p.peak_ratio(), "", 1,
                     " (4.3)" + (counted ? ", counted " + document::rounded(counted->counted_peak_ratio, 6) : ""), 6}});
    document.facts("peak height", {{"mean_height", p.mean_height(), "mean "},
                                   {"height_variance", p.height_variance(), ", variance "},
                                   {"height_skewness", p.height_skewness(), ", skewness "},
                                   {"height_kurtosis", p.height_kurtosis(), ", kurtosis ", 1, " (in rms heights)", 6}});
    std::vector<document::Fact> curvature;
    for (int n = 1; n <= 4; ++n)
        curvature.push_back({"curvature_moment_" + std::to_string(n), p.curvature_moment(n),
                             n == 1 ? "E t^n, n = 1 to 4: " : ", ", 1, n == 4 ? " (in rms curvatures)" : "", 6});
    document.facts("peak curvature", curvature);
    if (!counted) return;
    const document::ShownUnit height = document::unit_of_length(counted->rms_height);
    document.facts("ordinates",
                   {{"rms_height_m", counted->rms_height, "rms height ", height.factor, " " + std::string(height.name)},
                    {"rms_slope", counted->rms_slope, ", rms slope "},
                    {"rms_curvature_per_m", counted->rms_curvature, ", rms curvature ", 1e-6, " /µm"},
                    {"rho1", counted->rho1, ", rho1 ", 1, "", 6},
                    {"rho2", counted->rho2, ", rho2 ", 1, "", 6},
                    {"counted_peak_ratio", counted->counted_peak_ratio},
                    {"peaks_per_m", counted->peaks_per_length}});
}

}  // namespace

PeakDensity peak_density_of(const PeakDensityRequest& request, std::optional<surface::SurfaceInput> input) {
    const auto name = [&](std::string_view key) { return surface::option_name(request.surface.prefix, key); };
    std::vector<double> heights;
    if (!request.heights.empty()) heights = heights_of(request.heights, name("heights"));
    const bool angles = request.r || !request.theta.empty() || request.exponential;
    const bool correlations = request.rho1 || request.rho2;
    const bool measured = input || !request.surface.file.empty();
    if (int(angles) + int(correlations) + int(measured) != 1)
        throw document::option_error("give one of " + name("r") + " and " + name("theta") + ", " + name("theta") +
                                     " and " + name("exponential") + ", " + name("rho1") + " and " + name("rho2") +
                                     ", " + std::string(request.profile));
    if (measured && !input) input = read_surface_input(request.surface);
    PeakDensity peaks = measured ? of_profile(request.surface, std::move(*input)) : of_numbers(request);
    peaks.heights = std::move(heights);
    return peaks;
}

document::Document document_of(const PeakDensityRequest& request, std::optional<surface::SurfaceInput> input) {
    const PeakDensity peaks = peak_density_of(request, std::move(input));
    document::Document document("peaks", 18);
    document.json["from"] = peaks.from;
    document.json["equations"] = {{"density", "(4.4)"}, {"peak_ratio", "(4.3)"}};
    document.title("peak density (4.4) from " + peaks.from +
                   (peaks.input ? " " + document::shown_name(request.surface.file) : ""));
    if (peaks.input) add_profile(document, request, peaks);
    add_moments(document, peaks.density, peaks.statistics);
    if (peaks.heights.empty()) return document;
    document.line();
    document::Rows rows;
    rows.repeat({.key = "r", .json = false}, peaks.density.r(), peaks.heights.size());
    rows.repeat({.key = "theta", .json = false}, peaks.density.theta(), peaks.heights.size());
    rows.add({"height", "height"}, peaks.heights);
    rows.add({"density", "density", 1, 6}, peaks.heights,
             [&](double height) { return peaks.density.height_marginal(height); });
    document.table(std::move(rows), {.key = "heights"});
    return document;
}

}  // namespace fstiff::actions
