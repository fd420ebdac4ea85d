// SPDX-License-Identifier: BSD-3-Clause
#include "surface/measured_surface.hpp"

#include <fstiff/answer/band_parts.hpp>
#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"

#include <fstiff/answer/band.hpp>

#include <algorithm>
#include <utility>
#include <variant>

namespace fstiff::surface {

using document::shown_length;
namespace {

bool has(const std::vector<MeasuredConcern>& concerns, MeasuredConcern concern) {
    return std::find(concerns.begin(), concerns.end(), concern) != concerns.end();
}

double gradient_of(const PreparedProfile<double>& profile) { return profile.rms_gradient; }
double gradient_of(const PreparedMap<double>& map) { return map.areal.rms_gradient; }
double step_of(const PreparedProfile<double>& profile) { return profile.profile.spacing; }
double step_of(const PreparedMap<double>& map) { return std::max(map.map.dx, map.map.dy); }

/// The option \p key with \p value, as it is written in a scene or on a command line.
std::string option_text(const SurfaceOptions& options, std::string_view key, const std::string& value) {
    return options.name(key) + (options.prefix.empty() ? " = \"" + value + "\"" : " \"" + value + "\"");
}

/// The crop that keeps the longer part of \p parameters next to its step, which is passed along x or y.
std::string crop_at_step(const Surface<double>& parameters) {
    const PlainForm<double>& form = parameters.plain_form;
    std::vector<std::array<double, 2>> box;  // of x, and of y
    const auto add = [&](auto points, double step) { box.push_back({0, static_cast<double>(points - 1) * step}); };
    if (const auto* line = parameters.profile.get())
        add(line->profile.size(), line->profile.spacing);
    else
        add(parameters.map->map.columns(), parameters.map->map.dx),
            add(parameters.map->map.rows(), parameters.map->map.dy);
    auto& [from, to] = box[form.along_y ? 1 : 0];
    const double edge =
        std::max(0.02 * to, parameters.cut_offs.lambda_s.value_or(0));  // the place is known to one part
    (2 * form.place > to ? to : from) = form.place + (2 * form.place > to ? -edge : edge);
    std::string text;
    for (const auto& [low, high] : box)
        text += (text.empty() ? "" : ",") + shown_length(low, 6) + "," + shown_length(high, 6);
    return text;
}

/// A sentence on the parabola or the step that is most of the mean square height of \p parameters, or on a bow of a
/// plateau, and on what removes
/// it; empty where there is none.
std::string form_warning(const Surface<double>& parameters, const SurfaceOptions& options) {
    const PlainForm<double>& form = parameters.plain_form;
    const auto option = [&](std::string_view key, const std::string& value) {
        return options.name(key) + (options.prefix.empty() ? " = \"" : " \"") + value + "\"";
    };
    if (form.is_parabola())
        return document::shown_percent(form.parabola) + " of the mean square height is one " +
               (parameters.profile ? "parabola" : "quadratic surface") + "; " +
               option("detrend", parameters.profile ? "parabola" : "quadratic") + ", or of a round part " +
               (parameters.profile ? "\"circle\"" : "\"sphere\" or \"cylinder\"") + ", removes it";
    if (form.is_bow())
        return document::shown_percent(form.parabola) +
               " of the mean square height bends the plateau, so that a part of it touches first; " +
               option("detrend", parameters.profile ? "parabola" : "quadratic") +
               " removes it where it is not of the face";
    if (!form.is_step()) return "";
    const bool straight = (form.along_x || form.along_y) && options.crop.empty();
    return document::shown_percent(form.step) + " of the mean square height is one step" +
           (straight ? " at " + shown_length(form.place, 3) + "; " + option("crop", crop_at_step(parameters))
                     : "; " + options.name("crop") + " or " + options.name("mask")) +
           " keeps one side of it";
}

/// \p warning of a unit that is likely wrong, with the option that replaces it; empty for an empty one.
std::string with_units(const std::string& warning, const SurfaceOptions& options) {
    return warning.empty()
               ? ""
               : warning + "; " + options.name("units") + " replaces that of a text, .npy, .mat, X3P or Surfer file";
}

/// A sentence on lengths that no rough surface has, where its sigma is \p rms_height and its points are \p step apart;
/// empty where there are none.
std::string length_warning(double rms_height, double step, const SurfaceOptions& options) {
    if (!(rms_height > 1e-3 || step > 1e-2)) return "";
    return with_units("sigma is " + shown_length(rms_height, 3) + " and the points are " + shown_length(step, 3) +
                          " apart: a unit of its lengths is likely wrong",
                      options);
}

/// A sentence on offsets of the scan lines of a map; empty where none are seen.
std::string lines_warning(const Surface<double>& parameters, const SurfaceOptions& options) {
    if (parameters.offset_lines == ScanAxis::automatic) return "";
    return "the lines along " + std::string(name_of(parameters.offset_lines)) + " are offset from each other by " +
           shown_length(parameters.line_step, 3) +
           " rms, as by drift of a scanning probe: K may be off by a factor of two; " + options.name("align") +
           (options.prefix.empty() ? " = \"median\"" : " median") +
           " removes the offsets, and a fine lay along the lines, which looks alike";
}

/// A sentence on a round \p form of \p radius that was removed; empty for a radius of 0.
std::string flat_patch_warning(double radius, std::string_view form) {
    if (radius == 0) return "";
    return "K is that of a flat face with the roughness of this part: the contact of the " + std::string(form) +
           " itself is not in it";
}

/// Decisions after the reading of the file, and doubts about \p parameters.
template <class Prepared>
void describe(MeasuredSurface& surface, const Prepared& prepared, const MeasureOptions& options) {
    const Surface<double>& parameters = surface.found;
    auto& said = surface.decisions;
    const bool profile = surface.is_profile();
    said.push_back("rms height " + shown_length(prepared.rms_as_read) + " as read, " + shown_length(prepared.rms) +
                   " without its form (" + form_name(prepared) + radius_clause(prepared.radius) + ")");
    said.push_back(sentence_of(parameters.cut_offs));
    if (profile)
        said.push_back("taken for isotropic: R and D_p from the triples and the " +
                       std::to_string(parameters.peaks_counted) + " peaks of the profile");
    else if (parameters.why_no_density.empty())
        said.push_back(
            "R and D_p from " + std::to_string(parameters.peaks_counted) +
            (options.input.peaks == PeakSource::summits ? " summits" : " islands at the level where there are most"));
    if (parameters.fractal_dimension)
        said.push_back("D and G from lags of " + shown_length(parameters.window.from) + " to " +
                       shown_length(parameters.window.to) +
                       (options.input.window.empty() ? " (automatic)" : " (given)"));
    said.push_back("errors by " + std::to_string(options.resamples) + " resamples of " +
                   (profile ? "blocks of " + shown_length(parameters.block_length)
                            : std::to_string(parameters.blocks) + " tiles") +
                   ", seed " + std::to_string(options.seed));

    auto& warned = surface.warnings;
    if (!parameters.why_no_dimension.empty())
        warned.push_back("D and G not found (only fractal laws need them): fstiff measure --show fit gives the reason");
    else if (parameters.curved)
        warned.push_back("the structure function is not a single power law over the window: D is a mean over it");
    if (!parameters.why_no_peaks.empty()) warned.push_back("no r and theta: " + parameters.why_no_peaks);
    if (!parameters.why_no_density.empty())
        warned.push_back(std::string(profile ? "no D_p" : "no R and D_p") +
                         ", so laws over a distribution of peaks need given ones: " + parameters.why_no_density);
    const bool lay = has(parameters.concerns, MeasuredConcern::lay);
    if (has(parameters.concerns, MeasuredConcern::anisotropic) && !lay)
        warned.push_back("the map differs along x and y; the models assume an isotropic surface");
    if (lay)
        warned.push_back(
            profile
                ? "the profile repeats itself every " + shown_length(parameters.repetition.period) +
                      " (autocorrelation " + document::rounded(parameters.repetition.correlation, 2) +
                      "): the face has a lay, and a profile cannot show the length of its ridges; K may be up to " +
                      document::rounded(detail::lay_factor) + " times higher; measure a map"
                : "the face has a lay (Str " + document::rounded(parameters.texture_aspect_ratio, 2) +
                      "): laws over a distribution of peaks assume an isotropic surface; hybrid and boundary_elements "
                      "take the map as it is");
    if (has(parameters.concerns, MeasuredConcern::long_waves))
        warned.push_back(
            document::shown_percent(parameters.long_wave_share) +
            " of the mean square height is from waves longer than an eighth of the " + surface.kind +
            ": sigma is that of this length, and a longer one may have more; K is about proportional to 1/sigma");
    std::vector<std::string> of_peaks = peak_warnings(parameters.concerns, parameters.peaks_counted, parameters);
    if (!profile && has(parameters.concerns, MeasuredConcern::few_peaks)) surface.of_file.push_back(of_peaks.front());
    warned.insert(warned.end(), of_peaks.begin(), of_peaks.end());
    for (const std::string& line :
         {lines_warning(parameters, options.input), flat_patch_warning(prepared.radius, form_name(prepared)),
          form_warning(parameters, options.input), length_warning(prepared.rms, step_of(prepared), options.input),
          with_units(gradient_warning(gradient_of(prepared), "measured"), options.input)})
        if (!line.empty()) warned.push_back(line), surface.of_file.push_back(line);
}

}  // namespace

std::vector<std::string> peak_warnings(const std::vector<MeasuredConcern>& concerns, std::size_t peaks,
                                       const SurfaceParameters<double>& values) {
    std::vector<std::string> lines;
    const auto add_percent = [&](MeasuredConcern concern, Parameter which) {
        const Measurement<double>* measurement = values.find(which);
        if (has(concerns, concern) && measurement &&
            detail::is_known(*measurement))  // what is not known to a factor of two is named below
            lines.push_back(std::string(detail::row_of(which).symbol) + " is known to " +
                            document::shown_percent(measurement->error / measurement->value) + " only");
    };
    if (has(concerns, MeasuredConcern::few_peaks))
        lines.push_back("R and D_p come from " + std::to_string(peaks) + " peaks only; their errors are rough");
    add_percent(MeasuredConcern::radius_uncertain, Parameter::peak_radius);
    add_percent(MeasuredConcern::density_uncertain, Parameter::peak_density);
    if (has(concerns, MeasuredConcern::no_densest_level))
        lines.push_back(
            "the islands are densest at the highest or the lowest level: this is not a maximum, and R and D_p must not "
            "be used as a pair");
    if (has(concerns, MeasuredConcern::parameter_unknown)) {
        std::string names;
        for (const Parameter which : detail::unknown_parameters(values))
            names += (names.empty() ? "" : ", ") + std::string(detail::row_of(which).symbol) + " (" +
                     document::shown_percent(values.find(which)->error / values.find(which)->value) + ")";
        lines.push_back(names +
                        ": not known to a factor of two; a result that depends on it, and its band, are doubtful");
    }
    return lines;
}

bool is_doubtful(const MeasuredSurface& surface) {
    return has(surface.found.concerns, MeasuredConcern::implausible_gradient) ||
           detail::is_profile_with_lay(surface.found) ||
           !detail::unknown_parameters(surface.found, surface.found).empty();
}

namespace {

/// \throws option_error, domain_error for options that do not fit the kind of the surface.
void refuse_options(const MeasureOptions& options, const Instrument& instrument, bool profile) {
    const std::string file = document::display_name(options.input.file);
    if (profile && options.input.peaks == PeakSource::summits)
        throw document::option_error(options.input.name("peaks") + " = \"summits\" is for a map; " + file +
                                     " holds a profile, whose R and D_p come from its curvature and its peaks");
    if (!profile && instrument.tip_radius > 0)
        throw domain_error(file +
                           ": is a map, whose lags cannot be corrected for the tip; give the resolution instead");
}

/// The options of the library for \p options and \p input.
fstiff::MeasureOptions<double> library_options(const MeasureOptions& options, const SurfaceInput& input,
                                               const ProgressHook& progress) {
    const bool profile = input.surface.is_profile();
    const Instrument instrument = instrument_of(options.input);
    std::optional<LengthRange<double>> window;
    if (!options.input.window.empty()) window = parse_window(options.input.window, options.input.name("window"));
    refuse_options(options, instrument, profile);
    fstiff::MeasureOptions<double> measuring =
        profile ? options_for_profile(options.input, input) : options_for_map(options.input, input);
    measuring.window = window;
    measuring.peaks = options.input.peaks;
    measuring.resamples = static_cast<std::size_t>(options.resamples);
    measuring.seed = options.seed;
    measuring.neighbours = options.neighbours;
    measuring.neighbour_dimensions = profile || options.neighbour_dimensions;
    measuring.keep_maps = options.keep_maps;
    measuring.progress = progress;
    measuring.parallel = options.parallel;
    return measuring;
}

/// Measures a surface that was read.
MeasuredSurface surface_as_read(const MeasureOptions& options, const SurfaceInput& input) {
    MeasuredSurface surface;
    surface.file = document::display_name(options.input.file);
    surface.sha256 = input.sha256;
    const auto how = std::make_shared<MeasureOptions>(options);
    how->parallel = {};  // belongs to the work alone
    surface.how = how;
    surface.kind = input.surface.is_profile() ? "profile" : "map";
    surface.decisions = input.surface.record.sentences();
    surface.warnings = surface.of_file = reading_warnings(input, "results that need them are left out");
    return surface;
}

/// \p surface, in which \p parameters was found, with the sentences on it.
MeasuredSurface with_sentences(MeasuredSurface surface, Surface<double>&& parameters, const MeasureOptions& options) {
    surface.found = std::move(parameters);
    if (surface.found.profile) describe(surface, *surface.found.profile, options);
    if (surface.found.map) describe(surface, *surface.found.map, options);
    return surface;
}

}  // namespace

MeasuredSurface measure_surface(const MeasureOptions& options, std::string bytes, const ProgressHook& progress) {
    SurfaceInput input = read_surface_input(options.input, std::move(bytes));
    if (input.surface.is_profile()) return measure_surface(options, input, progress);
    const auto measuring = library_options(options, input, progress);
    const MeasuredSurface read = surface_as_read(options, input);
    return with_sentences(
        read, document::about_file(options.input.file, [&] { return measure(input.take_map(), measuring); }), options);
}

MeasuredSurface measure_surface(const MeasureOptions& options, const SurfaceInput& input,
                                const ProgressHook& progress) {
    const auto measuring = library_options(options, input, progress);
    const MeasuredSurface read = surface_as_read(options, input);
    return with_sentences(read,
                          document::about_file(options.input.file,
                                               [&] {
                                                   return std::visit(
                                                       [&](const auto& heights) { return measure(heights, measuring); },
                                                       input.surface.data);
                                               }),
                          options);
}

std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface) {
    return parameter_lines(surface, surface.found);
}

std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface, const Surface<double>& parameters) {
    const bool profile = surface.is_profile();
    const auto unknown = detail::unknown_parameters(surface.found, parameters);
    const auto line = [&](Parameter which, std::string unit, std::string method) {
        return ParameterLine{std::string(detail::row_of(which).key), std::move(unit), *parameters.find(which),
                             std::move(method), std::count(unknown.begin(), unknown.end(), which) == 0};
    };
    std::vector<ParameterLine> lines{line(Parameter::rms_height, "m", "root of the mean square about the mean")};
    if (parameters.find(Parameter::peak_radius))
        lines.push_back(
            line(Parameter::peak_radius, "m", profile ? "3 sqrt(pi)/(8 sigma_kappa), (4.10)" : "mean of the peaks"));
    if (parameters.find(Parameter::peak_density))
        lines.push_back(line(Parameter::peak_density, "/m^2",
                             profile ? "2 pi/(3 sqrt 3) n^2, n peaks per length" : "peaks over the area"));
    const auto add = [&](const char* name, const Measurement<double>& measurement, const char* method) {
        lines.push_back({name, "m", measurement, method, detail::is_known(measurement)});
    };
    if (parameters.max_peak_height.value > 0)
        add("max_peak_height", parameters.max_peak_height, "highest point; the error is a lower bound");
    if (parameters.fractal_dimension)
        lines.push_back(line(Parameter::fractal_dimension, "",
                             profile ? "structure function, (2.5)" : "structure functions along x and y, (2.5)"));
    if (parameters.fractal_roughness) add("fractal_roughness", *parameters.fractal_roughness, "the same");
    if (parameters.r && parameters.theta) {
        lines.push_back(line(Parameter::r, "", "triples of neighbours, (4.1)"));
        lines.push_back(line(Parameter::theta, "", "triples of neighbours, (4.3) [rad]"));
    }
    if (parameters.heights) {
        const HeightStatistics<double>& heights = *parameters.heights;
        lines.push_back({"rms_gradient", "", heights.rms_gradient,
                         profile ? "root of twice the mean square slope" : "neighbours along x and y"});
        lines.push_back({"skewness", "", heights.skewness, "of the heights; 0 of Gaussian ones"});
        lines.push_back({"kurtosis", "", heights.kurtosis, "of the heights; 3 of Gaussian ones"});
    }
    return lines;
}

}  // namespace fstiff::surface
