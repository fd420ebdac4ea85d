// SPDX-License-Identifier: BSD-3-Clause
#include "surface/peak_density.hpp"

#include <fstiff/double/surfaces.hpp>
#include "surface/documents.hpp"

#include <cmath>
#include <sstream>
#include <utility>

namespace fstiff::scene {
namespace {

/// The points of \p text, within which the density is a normal number.
std::vector<double> heights_of(const std::string& text, const std::string& name) {
    constexpr double farthest = 30;
    constexpr int most = 100000;
    const auto refuse = [&] {
        return option_error(name + " = \"" + text +
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

PeakDensity of_profile(const SurfaceOptions& options, SurfaceInput input) {
    parts::PreparedProfile<double> levelled = level_profile(options, input);
    const auto statistics = about_file(options.file, [&] { return peak_statistics(levelled.profile); });
    return {.density = PeakDistribution<double>(statistics.r, statistics.theta),
            .from = "profile",
            .heights = {},
            .input = std::move(input),
            .levelled = std::move(levelled),
            .statistics = statistics};
}

PeakDensity of_numbers(const PeakDensityRequest& request) {
    const auto name = [&](std::string_view key) { return option_name(request.surface.prefix, key); };
    if (request.rho1 || request.rho2) {
        if (!request.rho1 || !request.rho2)
            throw option_error(name("rho1") + " and " + name("rho2") + " belong together; give both");
        return {PeakDistribution<double>::from_autocorrelation(*request.rho1, *request.rho2), "rho1, rho2", {}};
    }
    if (request.theta.empty() || request.exponential == request.r.has_value())
        throw option_error(name("theta") + " needs one of " + name("r") + " and " + name("exponential") + " too");
    const double theta = request.theta.value(io::Dimension::angle, name("theta"));
    if (request.exponential) return {PeakDistribution<double>::exponential(theta), "exponential autocorrelation", {}};
    return {PeakDistribution<double>(*request.r, theta), "r, theta", {}};
}

}  // namespace

PeakDensity peak_density_of(const PeakDensityRequest& request, std::optional<SurfaceInput> input) {
    const auto name = [&](std::string_view key) { return option_name(request.surface.prefix, key); };
    std::vector<double> heights;
    if (!request.heights.empty()) heights = heights_of(request.heights, name("heights"));
    const bool angles = request.r || !request.theta.empty() || request.exponential;
    const bool correlations = request.rho1 || request.rho2;
    const bool measured = input || !request.surface.file.empty();
    if (int(angles) + int(correlations) + int(measured) != 1)
        throw option_error("give one of " + name("r") + " and " + name("theta") + ", " + name("theta") + " and " +
                           name("exponential") + ", " + name("rho1") + " and " + name("rho2") + ", " +
                           std::string(request.profile));
    if (measured && !input) input = read_surface_input(request.surface);
    PeakDensity found = measured ? of_profile(request.surface, std::move(*input)) : of_numbers(request);
    found.heights = std::move(heights);
    return found;
}

NamedNumbers moments_of(const PeakDensity& found) {
    const auto& p = found.density;
    NamedNumbers numbers{{"r", p.r()},
                         {"theta", p.theta()},
                         {"peak_ratio", p.peak_ratio()},
                         {"mean_height", p.mean_height()},
                         {"height_variance", p.height_variance()},
                         {"height_skewness", p.height_skewness()},
                         {"height_kurtosis", p.height_kurtosis()}};
    for (int n = 1; n <= 4; ++n) numbers.emplace_back("curvature_moment_" + std::to_string(n), p.curvature_moment(n));
    if (const auto& s = found.statistics)
        numbers.insert(numbers.end(), {{"rms_height_m", s->rms_height},
                                       {"rms_slope", s->rms_slope},
                                       {"rms_curvature_per_m", s->rms_curvature},
                                       {"rho1", s->rho1},
                                       {"rho2", s->rho2},
                                       {"counted_peak_ratio", s->counted_peak_ratio},
                                       {"peaks_per_m", s->peaks_per_length}});
    return numbers;
}

Rows rows_of(const PeakDensity& found) {
    std::vector<double> density;
    for (const double height : found.heights) density.push_back(found.density.height_marginal(height));
    Rows rows;
    rows.repeat({.key = "r", .json = false}, found.density.r(), found.heights.size());
    rows.repeat({.key = "theta", .json = false}, found.density.theta(), found.heights.size());
    rows.add({"height", "height"}, found.heights);
    rows.add({"density", "density", 1, 6}, density);
    return rows;
}

Answer answer_of(const PeakDensityRequest& request, const PeakDensity& found) {
    Answer answer{json_document("peaks")};
    Json& document = answer.document;
    document["from"] = found.from;
    document["equations"] = {{"density", "(4.4)"}, {"peak_ratio", "(4.3)"}};
    if (found.input) {
        document["source"] = json_source(request.surface, *found.input);
        document["inputs"] = json_inputs(request.surface, form_name(*found.levelled));
        document["points"] = found.input->points();
        document["missing_points"] = found.input->missing();
        document["spacing_m"] = found.levelled->profile.spacing;
        document["detrend"] = form_name(*found.levelled);
        answer.warnings = reading_warnings(*found.input, "their neighbours are no peaks", found.levelled->rms_gradient);
        answer.doubtful = !parts::is_plausible_gradient(found.levelled->rms_gradient);
    }
    put(document, moments_of(found));
    if (!found.heights.empty()) document["heights"] = rows_of(found).arrays();
    return answer;
}

}  // namespace fstiff::scene
