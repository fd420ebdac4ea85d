// SPDX-License-Identifier: BSD-3-Clause
#include "scene/measured_surface.hpp"

#include "scene/surface_instances.hpp"

#include <fstiff/measured/measured_concerns.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace fstiff::scene {
namespace {

FractalFitOptions<double> fit_options(const MeasureOptions& options) {
    const std::string prefix(options.input.prefix);
    FractalFitOptions<double> fit;
    if (!options.tip_radius.empty())
        fit.tip_radius = parse_length(options.tip_radius, prefix + (prefix.empty() ? "tip_radius" : "tip-radius"));
    if (!options.resolution.empty()) fit.resolution = parse_length(options.resolution, prefix + "resolution");
    if (!options.window.empty()) fit.window = parse_window(options.window, prefix + "window");
    return fit;
}

std::string um(double length) { return rounded(length * 1e6) + " µm"; }

/// What was decided beside the reading of the file.
void describe(MeasuredSurface& surface, const SurfaceParameters<double>& found, const std::string& form, double before,
              double after, const MeasureOptions& options) {
    auto& said = surface.decisions;
    const bool profile = surface.kind == "profile";
    said.push_back("rms height " + um(before) + " as read, " + um(after) + " without its form (" + form + ")");
    if (profile)
        said.push_back("taken for isotropic: R and D_p from the triples and the " +
                       std::to_string(found.peaks_counted) + " peaks of the profile");
    else
        said.push_back(
            "R and D_p from " + std::to_string(found.peaks_counted) +
            (options.peaks == PeakSource::summits ? " summits" : " islands at the level where there are most"));
    if (found.fractal_dimension)
        said.push_back("D and G from lags of " + um(found.window.from) + " to " + um(found.window.to) +
                       (options.window.empty() ? " (automatic)" : " (given)"));
    said.push_back("errors by " + std::to_string(options.resamples) + " resamples of " +
                   (profile ? "blocks of " + um(found.block_length) : std::to_string(found.blocks) + " tiles") +
                   ", seed " + std::to_string(options.seed));

    auto& warned = surface.warnings;
    if (!found.why_no_dimension.empty())
        warned.push_back("no D and G, and no fractal law without one given: " + found.why_no_dimension);
    else if (found.curved)
        warned.push_back("the structure function is no single power law over the window: D is a mean over it");
    if (!found.why_no_peaks.empty()) warned.push_back("no r and theta: " + found.why_no_peaks);
    const auto percent = [](const Measurement<double>& one) {
        return std::to_string(std::lround(100 * one.error / one.value)) + " % only";
    };
    for (const MeasuredConcern concern : concerns_of(found)) switch (concern) {
            case MeasuredConcern::anisotropic:
                warned.push_back("the map differs along x and y; the models take it for isotropic");
                break;
            case MeasuredConcern::few_peaks:
                warned.push_back("R and D_p come from " + std::to_string(found.peaks_counted) +
                                 " peaks only; their errors are rough");
                break;
            case MeasuredConcern::radius_uncertain:
                warned.push_back("R is known to " + percent(found.peak_radius));
                break;
            case MeasuredConcern::density_uncertain:
                warned.push_back("D_p is known to " + percent(found.peak_density));
                break;
            default:  // said before
                break;
        }
}

std::shared_ptr<const MapOfSurface> map_of_surface(const HeightMap<double>& map) {
    return std::make_shared<const MapOfSurface>(
        MapOfSurface{std::make_shared<const HeightMap<double>>(map), summits_of(map),
                     map.present() == map.size() ? map_spectrum(map) : SpectrumShells<double>{}});
}

}  // namespace

MeasuredSurface measure_surface(const MeasureOptions& options, const std::string& bytes, const ProgressHook& progress) {
    SurfaceParameterOptions<double> how;
    how.fit = fit_options(options);
    how.fit.seed = how.seed = options.seed;
    how.resamples = static_cast<std::size_t>(options.resamples);
    how.progress = how.fit.progress = how.islands.progress = progress;
    how.peaks = options.peaks;
    const SurfaceInput input = read_surface_input(options.input, bytes);
    const bool profile = input.surface.is_profile();
    MeasuredSurface surface;
    surface.file = display_name(options.input.file);
    surface.sha256 = input.sha256;
    surface.kind = profile ? "profile" : "map";
    surface.decisions = input.surface.record.sentences();
    surface.warnings = reading_warnings(input, "what needs them is left out");
    if (!profile && how.fit.tip_radius > 0)
        throw domain_error(surface.file +
                           ": is a map, whose lags cannot be freed of the tip; must be told by the resolution instead");
    SurfaceParameters<double> found;
    if (profile) {
        surface.profile = std::make_shared<PreparedProfile>(level_profile(options.input, input));
        const PreparedProfile& levelled = *surface.profile;
        found = about_file(options.input.file, [&] { return surface_parameters<double>(levelled, how); });
        describe(surface, found, levelled.form, levelled.rms_as_read, levelled.rms, options);
    } else {
        surface.map = std::make_shared<PreparedMap>(level_map(options.input, input));
        const PreparedMap& levelled = *surface.map;
        found = about_file(options.input.file, [&] { return surface_parameters(levelled.map, how); });
        describe(surface, found, levelled.form, levelled.rms_as_read, levelled.rms, options);
    }
    if (profile) {
        surface.heights = height_statistics(surface.profile->profile);
    } else {
        surface.heights = height_statistics(surface.map->map);
        surface.of_map = map_of_surface(surface.map->map);
    }
    surface.profile_fit = std::move(found.profile_fit);
    surface.map_fit = std::move(found.map_fit);
    if (found.islands) surface.islands = std::move(found.islands->curve);
    surface.parameters = uncertain(found);
    surface.max_peak_height = found.max_peak_height;
    if (found.fractal_roughness) surface.fractal_roughness = found.fractal_roughness;
    surface.fractal_refusal = found.why_no_dimension;
    surface.peaks_refusal = found.why_no_peaks;
    return surface;
}

std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface) {
    const bool profile = surface.kind == "profile";
    const auto& p = surface.parameters;
    const auto of = [&](Parameter which) {
        return Measurement<double>{p.value[index_of(which)], p.error[index_of(which)]};
    };
    std::vector<ParameterLine> lines{
        {"rms_height", "m", of(Parameter::rms_height), "root of the mean square about the mean"},
        {"peak_radius", "m", of(Parameter::peak_radius),
         profile ? "3 sqrt(pi)/(8 sigma_kappa), (4.10)" : "mean of the peaks"},
        {"peak_density", "/m^2", of(Parameter::peak_density),
         profile ? "2 pi/(3 sqrt 3) n^2, n peaks per length" : "peaks over the area"}};
    if (surface.max_peak_height.value > 0)
        lines.push_back({"max_peak_height", "m", surface.max_peak_height, "highest point; the error is a lower bound"});
    if (p.known[index_of(Parameter::fractal_dimension)])
        lines.push_back({"fractal_dimension", "", of(Parameter::fractal_dimension),
                         profile ? "structure function, (2.5)" : "structure functions along x and y, (2.5)"});
    if (surface.fractal_roughness) lines.push_back({"fractal_roughness", "m", *surface.fractal_roughness, "the same"});
    if (p.known[index_of(Parameter::r)]) {
        lines.push_back({"r", "", of(Parameter::r), "triples of neighbours, (4.1)"});
        lines.push_back({"theta", "", of(Parameter::theta), "triples of neighbours, (4.3) [rad]"});
    }
    if (surface.heights) {
        const HeightStatistics<double>& heights = *surface.heights;
        lines.push_back({"rms_gradient", "", heights.rms_gradient,
                         profile ? "root of twice the mean square slope" : "neighbours along x and y"});
        lines.push_back({"skewness", "", heights.skewness, "of the heights; 0 of Gaussian ones"});
        lines.push_back({"kurtosis", "", heights.kurtosis, "of the heights; 3 of Gaussian ones"});
    }
    return lines;
}

}  // namespace fstiff::scene
