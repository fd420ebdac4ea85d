// SPDX-License-Identifier: BSD-3-Clause
#include "scene/measured_surface.hpp"

#include "scene/shown_unit.hpp"
#include "scene/surface_instances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fstiff::scene {
namespace {

FractalFitOptions<double> fit_options(const MeasureOptions& options) {
    const std::string prefix(options.input.prefix);
    FractalFitOptions<double> fit;
    if (!options.input.tip_radius.empty())
        fit.tip_radius =
            parse_length(options.input.tip_radius, prefix + (prefix.empty() ? "tip_radius" : "tip-radius"));
    if (!options.input.resolution.empty())
        fit.resolution = parse_length(options.input.resolution, prefix + "resolution");
    if (!options.window.empty()) fit.window = parse_window(options.window, prefix + "window");
    return fit;
}

bool has(const std::vector<MeasuredConcern>& concerns, MeasuredConcern one) {
    return std::find(concerns.begin(), concerns.end(), one) != concerns.end();
}

Measurement<double> of(const UncertainSurface<double>& surface, Parameter which) {
    return {surface.value[index_of(which)], surface.error[index_of(which)]};
}

double gradient_of(const PreparedProfile& profile) { return profile.rms_gradient; }
double gradient_of(const PreparedMap& map) { return map.areal.rms_gradient; }

/// What was decided beside the reading of the file.
void describe(MeasuredSurface& surface, const SurfaceParameters<double>& found, const std::string& form, double before,
              double after, const MeasureOptions& options) {
    auto& said = surface.decisions;
    const bool profile = surface.kind == "profile";
    said.push_back("rms height " + shown_length(before) + " as read, " + shown_length(after) + " without its form (" +
                   form + ")");
    said.push_back(surface.cut_offs.sentence());
    if (profile)
        said.push_back("taken for isotropic: R and D_p from the triples and the " +
                       std::to_string(found.peaks_counted) + " peaks of the profile");
    else
        said.push_back(
            "R and D_p from " + std::to_string(found.peaks_counted) +
            (options.peaks == PeakSource::summits ? " summits" : " islands at the level where there are most"));
    if (found.fractal_dimension)
        said.push_back("D and G from lags of " + shown_length(found.window.from) + " to " +
                       shown_length(found.window.to) + (options.window.empty() ? " (automatic)" : " (given)"));
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
    surface.peaks = found.peaks_counted;
    surface.concerns = concerns_of(found);
    const bool lay = has(surface.concerns, MeasuredConcern::lay);
    if (has(surface.concerns, MeasuredConcern::anisotropic) && !lay)
        warned.push_back("the map differs along x and y; the models take it for isotropic");
    if (lay)
        warned.push_back(
            profile ? "the profile repeats itself every " + shown_length(found.repetition.period) + " (autocorrelation " +
                          rounded(found.repetition.correlation, 2) +
                          "): the face has a lay, and a profile cannot show how far its ridges reach; K may be up to " +
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

/// The cut-offs of the neighbours of a surface of \p step behind \p lambda_s.
std::vector<double> neighbouring_cut_offs(const std::optional<double>& lambda_s, double step) {
    if (!lambda_s) return {4 * step};
    const double root = numbers::sqrt2_v<double>;
    if (*lambda_s / root < 2 * step) return {2 * *lambda_s};
    return {*lambda_s / root, *lambda_s * root};
}

/// Finds the neighbours of \p surface, whose cut-offs are known; \p measure_one(options) measures it behind others.
template <class MeasureOne>
void add_neighbours(MeasuredSurface& surface, MeasureOptions options, double step, const MeasureOne& measure_one) {
    options.neighbours = false;
    options.resamples = 2;                       // their errors are not asked
    if (options.input.detrend != gaussian_form)  // whatever chose lambda_c, it stays
        options.input.lambda_c = surface.cut_offs.lambda_c ? exact(*surface.cut_offs.lambda_c) + " m" : "none";
    for (const double lambda_s : neighbouring_cut_offs(surface.cut_offs.lambda_s, step)) {
        options.input.lambda_s = exact(lambda_s) + " m";
        try {
            surface.neighbours.push_back(measure_one(options));
            if (!options.keep_maps) surface.neighbours.back().map.reset();
        } catch (const domain_error&) {  // too long a cut-off for the file, or too few peaks behind it
        }
    }
}

SurfaceParameterOptions<double> parameter_options(const MeasureOptions& options, const ProgressHook& progress) {
    SurfaceParameterOptions<double> how;
    how.fit = fit_options(options);
    how.fit.seed = how.seed = options.seed;
    how.resamples = static_cast<std::size_t>(options.resamples);
    how.progress = how.fit.progress = how.islands.progress = progress;
    how.peaks = options.peaks;
    return how;
}

void refuse_options_of_map(const MeasureOptions& options) {
    if (fit_options(options).tip_radius > 0)
        throw domain_error(display_name(options.input.file) +
                           ": is a map, whose lags cannot be freed of the tip; must be told by the resolution instead");
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

double length_of(const Profile<double>& profile) { return static_cast<double>(profile.size()) * profile.spacing; }
double length_of(const HeightMap<double>& map) {
    return std::max(static_cast<double>(map.columns()) * map.dx, static_cast<double>(map.rows()) * map.dy);
}
double step_of(const Profile<double>& profile) { return profile.spacing; }
double step_of(const HeightMap<double>& map) { return std::max(map.dx, map.dy); }

/// MeasuredSurface::widest_band of \p heights.
template <class Heights>
double widest_band(const Heights& heights, const CutOffs& cut_offs) {
    const double length = length_of(heights), step = step_of(heights);
    const double widest = std::min(length, cut_offs.lambda_c.value_or(length)) / std::max(2 * step, cut_offs.lambda_s.value_or(0));
    return widest > 1 ? widest : std::numeric_limits<double>::infinity();
}

/// Into \p surface what was \p found of \p levelled, whose heights are those of \p heights.
template <class Levelled, class Heights>
void store(MeasuredSurface& surface, SurfaceParameters<double> found, const Levelled& levelled, const Heights& heights,
           const MeasureOptions& options) {
    surface.parameters = uncertain(found);
    describe(surface, found, levelled.form, levelled.rms_as_read, levelled.rms, options);
    const double rms_gradient = gradient_of(levelled);
    surface.concerns = concerns_of(found, rms_gradient);
    if (has(surface.concerns, MeasuredConcern::implausible_gradient))
        surface.warnings.push_back(gradient_warning(rms_gradient, "measured"));
    if (surface.cut_offs.lambda_c && !surface.cut_offs.why_c.empty() && levelled.rms < levelled.rms_levelled / 2)
        surface.warnings.push_back(
            "lambda_c " + shown_length(*surface.cut_offs.lambda_c) + ", chosen by the table, leaves " +
            shown_percent(levelled.rms / levelled.rms_levelled) + " of the rms height of " +
            shown_length(levelled.rms_levelled) +
            ": R, D_p and K are those of the short waves alone; lambda_c none keeps the long ones");
    try {
        surface.heights = height_statistics(heights);
        ShapeOfHeights<double> shape;
        shape.add(heights);
        surface.shape_share = shape.share();
    } catch (const domain_error&) {  // too few points for a distribution: R and D_p may do without
    }
    surface.profile_fit = std::move(found.profile_fit);
    surface.map_fit = std::move(found.map_fit);
    if (found.islands) surface.islands = std::move(found.islands->curve);
    surface.max_peak_height = found.max_peak_height;
    surface.dimension_window_error = found.dimension_window_error;
    surface.widest_band = widest_band(heights, surface.cut_offs);
    if (found.fractal_roughness) surface.fractal_roughness = found.fractal_roughness;
    surface.fractal_refusal = found.why_no_dimension;
    surface.peaks_refusal = found.why_no_peaks;
}

void refuse_options_of_profile(const MeasureOptions& options) {
    if (options.peaks == PeakSource::summits)
        throw option_error(std::string(options.input.prefix) + "peaks = \"summits\" is for a map; " +
                           display_name(options.input.file) +
                           " holds a profile, whose R and D_p come from its curvature and its peaks");
}

MeasuredSurface measure_profile(const MeasureOptions& options, const SurfaceInput& input,
                                const ProgressHook& progress) {
    refuse_options_of_profile(options);
    SurfaceParameterOptions<double> how = parameter_options(options, progress);
    MeasuredSurface surface = surface_as_read(options, input);
    surface.profile = std::make_shared<PreparedProfile>(level_profile(options.input, input));
    const PreparedProfile& levelled = *surface.profile;
    surface.cut_offs = levelled.cut_offs;
    how.fit.lambda_s = surface.cut_offs.lambda_s.value_or(0);
    store(surface, about_file(options.input.file, [&] { return surface_parameters<double>(levelled, how); }), levelled,
          levelled.profile, options);
    if (options.neighbours)
        add_neighbours(surface, options, levelled.profile.spacing,
                       [&](const MeasureOptions& other) { return measure_profile(other, input, {}); });
    return surface;
}

/// Of a map, which \p prepare(options) returns behind other cut-offs. The neighbours come first: what is found of the map
/// itself needs no memory while they are.
template <class Prepare>
MeasuredSurface measure_map(const MeasureOptions& options, const SurfaceInput& input, const HeightMap<double>& steps,
                            const Prepare& prepare, const ProgressHook& progress) {
    SurfaceParameterOptions<double> how = parameter_options(options, progress);
    MeasuredSurface surface = surface_as_read(options, input);
    if (options.neighbours) {
        surface.cut_offs = map_cut_offs(options.input, steps);
        add_neighbours(surface, options, std::max(steps.dx, steps.dy),
                       [&](const MeasureOptions& other) { return measure_map(other, input, steps, prepare, {}); });
    }
    const auto levelled = std::make_shared<PreparedMap>(prepare(options.input));
    surface.cut_offs = levelled->cut_offs;
    how.fit.lambda_s = surface.cut_offs.lambda_s.value_or(0);
    SurfaceParameters<double> found =
        about_file(options.input.file, [&] { return surface_parameters<double>(*levelled, how); });
    levelled->unfiltered.reset();  // D is found
    surface.map = levelled;
    store(surface, std::move(found), *levelled, levelled->map, options);
    return surface;
}

}  // namespace

MeasuredSurface measure_surface(const MeasureOptions& options, std::string bytes, const ProgressHook& progress) {
    SurfaceInput input = read_surface_input(options.input, std::move(bytes));
    if (input.surface.is_profile()) return measure_profile(options, input, progress);
    refuse_options_of_map(options);
    const PreparedMap without_form = map_without_form(options.input, input);
    return measure_map(
        options, input, *without_form.unfiltered,
        [&](const SurfaceOptions& other) { return with_cut_offs(other, without_form); }, progress);
}

MeasuredSurface measure_surface(const MeasureOptions& options, const SurfaceInput& input,
                                const ProgressHook& progress) {
    if (input.surface.is_profile()) return measure_profile(options, input, progress);
    refuse_options_of_map(options);
    return measure_map(
        options, input, input.surface.map(), [&](const SurfaceOptions& other) { return level_map(other, input); },
        progress);
}

double MeasuredSurface::size() const {
    double size = 0;
    for (const MeasuredSurface& part : parts) size += part.size();
    if (profile) size = static_cast<double>(profile->profile.present()) * profile->profile.spacing;
    if (map) size = static_cast<double>(map->map.present()) * map->map.dx * map->map.dy;
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
