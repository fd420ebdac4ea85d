// SPDX-License-Identifier: BSD-3-Clause
#include "surface/measured_surface.hpp"

#include "document/shown_unit.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/measured/band_parts.hpp>

#include <algorithm>
#include <utility>
#include <variant>

namespace fstiff::scene {
namespace {

bool has(const std::vector<MeasuredConcern>& concerns, MeasuredConcern one) {
    return std::find(concerns.begin(), concerns.end(), one) != concerns.end();
}

Measurement<double> of(const UncertainSurface<double>& surface, Parameter which) {
    return {surface.value[index_of(which)], surface.error[index_of(which)]};
}

double gradient_of(const PreparedProfile<double>& profile) { return profile.rms_gradient; }
double gradient_of(const PreparedMap<double>& map) { return map.areal.rms_gradient; }

/// What was decided beside the reading of the file, and what is in doubt about \p found.
template <class Prepared>
void describe(MeasuredSurface& surface, const Surface<double>& found, const Prepared& prepared,
              const MeasureOptions& options) {
    auto& said = surface.decisions;
    const bool profile = surface.kind == "profile";
    said.push_back("rms height " + shown_length(prepared.rms_as_read) + " as read, " + shown_length(prepared.rms) +
                   " without its form (" + form_name(prepared) + ")");
    said.push_back(sentence_of(surface.cut_offs));
    if (profile)
        said.push_back("taken for isotropic: R and D_p from the triples and the " +
                       std::to_string(found.peaks_counted) + " peaks of the profile");
    else
        said.push_back(
            "R and D_p from " + std::to_string(found.peaks_counted) +
            (options.input.peaks == PeakSource::summits ? " summits" : " islands at the level where there are most"));
    if (found.fractal_dimension)
        said.push_back("D and G from lags of " + shown_length(found.window.from) + " to " +
                       shown_length(found.window.to) + (options.input.window.empty() ? " (automatic)" : " (given)"));
    said.push_back(
        "errors by " + std::to_string(options.resamples) + " resamples of " +
        (profile ? "blocks of " + shown_length(found.block_length) : std::to_string(found.blocks) + " tiles") +
        ", seed " + std::to_string(options.seed));

    auto& warned = surface.warnings;
    if (!found.why_no_dimension.empty())
        warned.push_back("no D and G, and no fractal law without one given: " + found.why_no_dimension);
    else if (found.curved)
        warned.push_back("the structure function is no single power law over the window: D is a mean over it");
    if (!found.why_no_peaks.empty()) warned.push_back("no r and theta: " + found.why_no_peaks);
    const bool lay = has(surface.concerns, MeasuredConcern::lay);
    if (has(surface.concerns, MeasuredConcern::anisotropic) && !lay)
        warned.push_back("the map differs along x and y; the models take it for isotropic");
    if (lay)
        warned.push_back(
            profile ? "the profile repeats itself every " + shown_length(found.repetition.period) +
                          " (autocorrelation " + rounded(found.repetition.correlation, 2) + "): the face has a lay, and a profile cannot show how far its ridges reach; K may be up to " +
                          rounded(lay_factor) + " times higher; measure a map"
                    : "the face has a lay (Str " + rounded(found.texture_aspect_ratio, 2) +
                          "): laws over a distribution of peaks take it for isotropic; hybrid and boundary_elements "
                          "take the map as it is");
    if (has(surface.concerns, MeasuredConcern::long_waves))
        warned.push_back(shown_percent(found.long_wave_share) +
                         " of the mean square height are waves longer than an eighth of the " + surface.kind +
                         ": sigma is that of this length, and a longer one may have more; K goes about as 1/sigma");
    for (std::string& line : peak_warnings(surface.concerns, found.peaks_counted, surface.parameters))
        warned.push_back(std::move(line));
    if (has(surface.concerns, MeasuredConcern::implausible_gradient))
        warned.push_back(gradient_warning(gradient_of(prepared), "measured"));
    if (is_mostly_waviness(prepared))
        warned.push_back("lambda_c " + shown_length(*surface.cut_offs.lambda_c) + ", chosen by the table, leaves " +
                         shown_percent(prepared.rms / prepared.rms_levelled) + " of the rms height of " +
                         shown_length(prepared.rms_levelled) +
                         ": R, D_p and K are those of the short waves alone; lambda_c none keeps the long ones");
}

}  // namespace

std::vector<std::string> peak_warnings(const std::vector<MeasuredConcern>& concerns, std::size_t peaks,
                                       const UncertainSurface<double>& values) {
    std::vector<std::string> lines;
    const auto add_percent = [&](MeasuredConcern concern, Parameter which) {
        const auto one = of(values, which);
        if (has(concerns, concern) && is_known(one))  // what is not known to a factor of two is named below
            lines.push_back(std::string(row_of(which).symbol) + " is known to " +
                            shown_percent(one.error / one.value) + " only");
    };
    if (has(concerns, MeasuredConcern::few_peaks))
        lines.push_back("R and D_p come from " + std::to_string(peaks) + " peaks only; their errors are rough");
    add_percent(MeasuredConcern::radius_uncertain, Parameter::peak_radius);
    add_percent(MeasuredConcern::density_uncertain, Parameter::peak_density);
    if (has(concerns, MeasuredConcern::no_densest_level))
        lines.push_back(
            "the islands are densest at the highest or the lowest level: this is no maximum, and the pair R, D_p "
            "represents nothing");
    if (has(concerns, MeasuredConcern::parameter_unknown)) {
        const bool long_waves = has(concerns, MeasuredConcern::long_waves);
        std::string names;
        for (const ParameterRow& row : std::span(parameter_table).first<surface_parameter_count>())
            if (values.known[index_of(row.parameter)] && !is_known(of(values, row.parameter)) &&
                !(long_waves && (row.parameter == Parameter::rms_height || row.parameter == Parameter::r)))
                names += (names.empty() ? "" : ", ") + std::string(row.symbol) + " (" +
                         shown_percent(values.error[index_of(row.parameter)] / values.value[index_of(row.parameter)]) +
                         ")";
        lines.push_back(names + ": not known to a factor of two; a result that rests on it, and its band, is in doubt");
    }
    return lines;
}

std::vector<Parameter> unknown_parameters(const MeasuredSurface& surface, const UncertainSurface<double>& used) {
    const bool no_pair = has(surface.concerns, MeasuredConcern::no_densest_level);
    const bool long_waves = has(surface.concerns, MeasuredConcern::long_waves);
    std::vector<Parameter> all;
    for (std::size_t i = 0; i < surface_parameter_count; ++i) {
        const Parameter which = parameter_table[i].parameter;
        const bool of_pair = which == Parameter::peak_radius || which == Parameter::peak_density;
        if (long_waves && (which == Parameter::rms_height || which == Parameter::r)) continue;  // said by itself
        if (used.known[i] &&
            (!is_known(of(used, which)) || (no_pair && of_pair && used.value[i] == surface.parameters.value[i])))
            all.push_back(which);
    }
    return all;
}

bool is_profile_with_lay(const MeasuredSurface& surface) {
    return surface.kind == "profile" && has(surface.concerns, MeasuredConcern::lay);
}

bool is_doubtful(const MeasuredSurface& surface) {
    return has(surface.concerns, MeasuredConcern::implausible_gradient) || is_profile_with_lay(surface) ||
           !unknown_parameters(surface, surface.parameters).empty();
}

namespace {

/// \throws option_error, domain_error for options that do not fit the kind of the surface.
void refuse_options(const MeasureOptions& options, const Instrument& instrument, bool profile) {
    const std::string file = display_name(options.input.file);
    if (profile && options.input.peaks == PeakSource::summits)
        throw option_error(options.input.name("peaks") + " = \"summits\" is for a map; " + file +
                           " holds a profile, whose R and D_p come from its curvature and its peaks");
    if (!profile && instrument.tip_radius > 0)
        throw domain_error(file +
                           ": is a map, whose lags cannot be freed of the tip; must be told by the resolution instead");
}

/// The options of the library for \p options and \p input.
fstiff::MeasureOptions<double> library_options(const MeasureOptions& options, const SurfaceInput& input,
                                               const ProgressHook& progress) {
    const bool profile = input.surface.is_profile();
    const Instrument instrument = instrument_of(options.input);
    std::optional<LagWindow<double>> window;
    if (!options.input.window.empty()) window = parse_window(options.input.window, options.input.name("window"));
    refuse_options(options, instrument, profile);
    fstiff::MeasureOptions<double> how =
        profile ? options_for_profile(options.input, input) : options_for_map(options.input, input);
    how.window = window;
    how.peaks = options.input.peaks;
    how.resamples = static_cast<std::size_t>(options.resamples);
    how.seed = options.seed;
    how.neighbours = options.neighbours;
    how.neighbour_dimensions = profile || options.neighbour_dimensions;
    how.keep_maps = options.keep_maps;
    how.progress = progress;
    return how;
}

/// What is known of a surface once it is read.
MeasuredSurface surface_as_read(const MeasureOptions& options, const SurfaceInput& input) {
    MeasuredSurface surface;
    surface.file = display_name(options.input.file);
    surface.sha256 = input.sha256;
    surface.how = std::make_shared<const MeasureOptions>(options);
    surface.kind = input.surface.is_profile() ? "profile" : "map";
    surface.decisions = input.surface.record.sentences();
    surface.warnings = reading_warnings(input, "what needs them is left out");
    return surface;
}

/// \p found, which was read as \p read says, with its sentences and its neighbours.
MeasuredSurface with_sentences(const MeasuredSurface& read, Surface<double>&& found, MeasureOptions options) {
    MeasuredSurface surface = read;
    surface.profile = found.profile;
    surface.map = found.map;
    surface.measured_size = found.size;
    surface.cut_offs = found.cut_offs;
    surface.concerns = found.concerns;
    surface.peaks = found.peaks_counted;
    surface.parameters = uncertain(found);
    if (surface.profile) describe(surface, found, *surface.profile, options);
    if (surface.map) describe(surface, found, *surface.map, options);
    surface.heights = found.heights;
    surface.shape_share = found.shape_share;
    surface.max_peak_height = found.max_peak_height;
    surface.dimension_window_error = found.dimension_window_error;
    surface.widest_band = found.widest_band;
    surface.fractal_roughness = found.fractal_roughness;
    surface.fractal_refusal = found.why_no_dimension;
    surface.peaks_refusal = found.why_no_peaks;
    surface.profile_fit = std::move(found.profile_fit);
    surface.map_fit = std::move(found.map_fit);
    if (found.islands) surface.islands = std::move(found.islands->curve);
    options.resamples = 2;  // as measure() takes of them
    for (Surface<double>& neighbour : found.neighbours)
        surface.neighbours.push_back(with_sentences(read, std::move(neighbour), options));
    return surface;
}

}  // namespace

MeasuredSurface measure_surface(const MeasureOptions& options, std::string bytes, const ProgressHook& progress) {
    SurfaceInput input = read_surface_input(options.input, std::move(bytes));
    if (input.surface.is_profile()) return measure_surface(options, input, progress);
    const auto how = library_options(options, input, progress);
    const MeasuredSurface read = surface_as_read(options, input);
    return with_sentences(
        read, about_file(options.input.file, [&] { return measure(input.take_map(), how); }), options);
}

MeasuredSurface measure_surface(const MeasureOptions& options, const SurfaceInput& input,
                                const ProgressHook& progress) {
    const auto how = library_options(options, input, progress);
    const MeasuredSurface read = surface_as_read(options, input);
    return with_sentences(read, about_file(options.input.file, [&] {
                              return std::visit([&](const auto& heights) { return measure(heights, how); },
                                                input.surface.data);
                          }),
                          options);
}

double MeasuredSurface::size() const {
    double size = measured_size;
    for (const MeasuredSurface& part : parts) size += part.size();
    return size;
}

std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface) {
    const bool profile = surface.kind == "profile";
    const auto& p = surface.parameters;
    const auto unknown = unknown_parameters(surface, p);
    const auto line = [&](Parameter which, std::string unit, std::string how) {
        return ParameterLine{std::string(row_of(which).key), std::move(unit), of(p, which), std::move(how),
                             std::count(unknown.begin(), unknown.end(), which) == 0};
    };
    std::vector<ParameterLine> lines{
        line(Parameter::rms_height, "m", "root of the mean square about the mean"),
        line(Parameter::peak_radius, "m", profile ? "3 sqrt(pi)/(8 sigma_kappa), (4.10)" : "mean of the peaks"),
        line(Parameter::peak_density, "/m^2",
             profile ? "2 pi/(3 sqrt 3) n^2, n peaks per length" : "peaks over the area")};
    const auto add = [&](const char* name, const Measurement<double>& one, const char* how) {
        lines.push_back({name, "m", one, how, is_known(one)});
    };
    if (surface.max_peak_height.value > 0)
        add("max_peak_height", surface.max_peak_height, "highest point; the error is a lower bound");
    if (p.known[index_of(Parameter::fractal_dimension)])
        lines.push_back(line(Parameter::fractal_dimension, "",
                             profile ? "structure function, (2.5)" : "structure functions along x and y, (2.5)"));
    if (surface.fractal_roughness) add("fractal_roughness", *surface.fractal_roughness, "the same");
    if (p.known[index_of(Parameter::r)]) {
        lines.push_back(line(Parameter::r, "", "triples of neighbours, (4.1)"));
        lines.push_back(line(Parameter::theta, "", "triples of neighbours, (4.3) [rad]"));
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
