// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_file.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"
#include "surface/equal_heights.hpp"
#include "surface/facing.hpp"

#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/surface/moments.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fstiff::surface {

namespace {

/// Where the index of lambda_s comes from.
std::string source_of_index(const CutOffs<double>& cut_offs) {
    switch (cut_offs.index_source) {
        case IndexSource::tip: return "of a tip of " + document::shown_length(cut_offs.tip_radius);
        case IndexSource::resolution: return "of the resolution";
        case IndexSource::step: break;
    }
    return "of five steps of " + document::shown_length(cut_offs.step);
}

/// Why lambda_s is so, or why there is none; empty where it was given.
std::string why_lambda_s(const CutOffs<double>& cut_offs) {
    const std::string index = document::shown_length(cut_offs.index), why = source_of_index(cut_offs);
    switch (cut_offs.why_s) {
        case LambdaSReason::given: break;
        case LambdaSReason::by_table: return "by the table, the index " + why;
        case LambdaSReason::too_short:
            return "as measured; " + std::to_string(detail::lambda_s_of_length) + " of " + index + ", the index " +
                   why + ", do not fit the length of " + document::shown_length(cut_offs.length);
        case LambdaSReason::not_below_lambda_c:
            return "as measured; " + index + ", the index " + why + ", is not below lambda_c";
    }
    return "";
}

/// Why lambda_c is so, or why there is none; empty where it was given.
std::string why_lambda_c(const CutOffs<double>& cut_offs) {
    const std::string of_class =
        "by the table, of " + (cut_offs.spacing > 0 ? "RSm " + document::shown_length(cut_offs.spacing, 3)
                                                    : "Ra " + document::shown_length(cut_offs.mean_deviation, 3));
    const std::string length = document::shown_length(cut_offs.length);
    switch (cut_offs.why_c) {
        case CutOffReason::given: break;
        case CutOffReason::spacing:
        case CutOffReason::roughness: return of_class;
        case CutOffReason::length:
            return of_class + ", whose row is longer: the longest that fits five times into the length of " + length;
        case CutOffReason::step:
            return of_class + ", whose row is shorter: the shortest that the step and lambda_s allow";
        case CutOffReason::too_short:
            return "the length of " + length + " does not hold five of " +
                   document::shown_length(detail::cut_off_table.front().lambda_c) + ", the shortest of the table";
        case CutOffReason::too_coarse:
            return "those of the table that the length of " + length + " holds are too short for the step";
        case CutOffReason::form_alone: return "the form alone bounds the long waves";
    }
    return "";
}

/// Points to which the robust filter gave no weight.
std::string left_out(const std::optional<RobustOutcome>& robust) {
    if (!robust) return "";
    return ", " + std::to_string(robust->left_out) + " of " + std::to_string(robust->points) +
           " points without weight, " + std::to_string(robust->iterations) + " iterations" +
           (robust->converged ? "" : ", not converged");
}

}  // namespace

Instrument instrument_of(const SurfaceOptions& options) {
    const auto length = [&](const Amount& given, const char* key) {
        return given.empty() ? 0. : parse_length(given, options.name(key));
    };
    return {length(options.tip_radius, "tip_radius"), length(options.resolution, "resolution")};
}

fstiff::MeasureOptions<double> library_options(const SurfaceOptions& options) {
    fstiff::MeasureOptions<double> measuring;
    measuring.lambda_s = parse_cut_off(options.lambda_s, options.name("lambda_s"));
    measuring.lambda_c = parse_cut_off(options.lambda_c, options.name("lambda_c"));
    measuring.filter = options.filter;
    const Instrument instrument = instrument_of(options);
    measuring.tip_radius = instrument.tip_radius, measuring.resolution = instrument.resolution;
    return measuring;
}

void require_cut_offs(const SurfaceOptions& options, const fstiff::MeasureOptions<double>& given, double step,
                      double length) {
    const auto refused = detail::refused_cut_off(given, step, length);
    if (!refused) return;
    const std::string short_name = options.name("lambda_s"), long_name = options.name("lambda_c");
    const std::string& name = refused->long_waves ? long_name : short_name;
    const std::string quoted =
        name + " = \"" + (refused->long_waves ? options.lambda_c : options.lambda_s).text("m") + "\"";
    const int steps = refused->long_waves ? detail::min_steps_of_lambda_c : detail::min_steps_of_lambda_s;
    switch (refused->why) {
        case detail::CutOffRefusal::below_steps:
            throw domain_error(quoted + " cannot be held by this file, whose points are " +
                               document::shown_length(step) + " apart: must be at least " + std::to_string(steps) +
                               " steps, " + document::shown_length(refused->limit));
        case detail::CutOffRefusal::above_length:
            throw domain_error(quoted + ": must be at most the length of the surface, " +
                               document::shown_length(length));
        case detail::CutOffRefusal::not_below_lambda_c:
            throw domain_error(name + " = " + document::shown_length(refused->given) + ": must be less than " +
                               long_name + ", " + document::shown_length(refused->limit));
    }
}

std::string sentence_of(const CutOffs<double>& cut_offs) {
    const std::string why_s = why_lambda_s(cut_offs), why_c = why_lambda_c(cut_offs);
    const std::string s = why_s.empty() ? "" : why_s + "; ", c = why_c.empty() ? "" : why_c + "; ";
    const auto &lambda_s = cut_offs.lambda_s, &lambda_c = cut_offs.lambda_c;
    return (lambda_s
                ? "lambda_s " + document::shown_length(*lambda_s) + " (" + s + "Gaussian, after the form was removed)"
                : "lambda_s none (" + (why_s.empty() ? "as measured" : why_s) + ")") +
           ", " +
           (lambda_c ? "lambda_c " + document::shown_length(*lambda_c) + " (" + c +
                           (cut_offs.filter == CutOffFilter::robust ? "robust Gaussian" : "Gaussian") + ", after " +
                           (lambda_s ? "lambda_s" : "the form was removed") + left_out(cut_offs.robust) + ")"
                     : "lambda_c none" + (why_c.empty() ? "" : " (" + why_c + ")"));
}

namespace {

/// The form called \p name; \p more follows the choices in the refusal.
template <detail::NamedEnum FormOf>
FormOf form_of(const SurfaceOptions& options, std::string_view name, std::string_view what,
               const std::string& more = "") {
    if (const auto form = detail::find_named<FormOf>(name)) return *form;
    throw document::option_error(options.name("detrend") + " = \"" + std::string(name) + "\": of a " +
                                 std::string(what) + " must be one of " + detail::choices_text<FormOf>() + more);
}

/// The radius of \p options, 0 where there is none. \throws option_error for one without its \p round form,
/// domain_error for one that is not above half of \p side [m].
double radius_of_form(const SurfaceOptions& options, bool round, double side) {
    if (options.radius.empty()) return 0;
    if (!round)
        throw document::option_error(options.name("radius") + " belongs to " + options.name("detrend") +
                                     " circle, sphere or cylinder; must not be given without it");
    const double radius = parse_length(options.radius, options.name("radius"));
    if (!(radius > side / 2))
        throw domain_error({.parameter = options.name("radius"),
                            .value = document::shown_length(radius),
                            .allowed = "more than half of the side of the surface, " + document::shown_length(side)});
    return radius;
}

void refuse_cutoff(const SurfaceOptions& options) {
    if (!options.cutoff.empty())
        throw document::option_error(options.name("cutoff") + " belongs to " + options.name("detrend") +
                                     " gaussian, of a profile; must not be given without it");
}

}  // namespace

std::size_t SurfaceInput::points() const {
    if (dropped) return dropped->points;
    return surface.is_profile() ? surface.profile().size() : static_cast<std::size_t>(surface.map().size());
}

std::size_t SurfaceInput::missing() const {
    if (dropped) return dropped->missing;
    return points() -
           (surface.is_profile() ? surface.profile().present() : static_cast<std::size_t>(surface.map().present()));
}

HeightMap<double> SurfaceInput::take_map() {
    dropped = Counts{points(), missing()};
    return std::move(std::get<1>(surface.data));
}

namespace {

/// Whether \p bytes are a JSON document of fstiff.
bool is_document(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{' &&
           bytes.substr(first, 200).find("\"fstiff_version\"") != std::string_view::npos;
}

/// \throws option_error for parts of a file, where one surface is read.
void refuse_parts(const SurfaceOptions& options) {
    for (const auto& [key, parts] : {std::pair("columns", &options.columns), std::pair("channels", &options.channels)})
        if (!parts->empty())
            throw document::option_error(options.name(key) + " = \"" + *parts +
                                         "\": must not be given where one surface is read");
}

void clean_input(const SurfaceOptions& options, SurfaceInput& input) {
    if (options.align != LineAlignment::none && input.surface.is_profile())
        throw document::option_error(options.name("align") + " = \"" + std::string(name_of(options.align)) +
                                     "\": must be none for a profile, which is one line");
    document::about_file(options.file, [&] {
        clean(options, input.surface);
        for (const auto hints : {cleaning_hints, equal_heights_hints})
            for (std::string& hint : hints(options, input.surface))
                input.surface.record.warnings.push_back(std::move(hint));
    });
}

}  // namespace

SurfaceInput input_of(const SurfaceOptions& options, std::optional<SurfaceInput> given) {
    return given ? *std::move(given) : read_surface_input(options);
}

SurfaceInput surface_of_heights(const SurfaceOptions& options, io::ProfileOrMap heights, const std::string& origin) {
    refuse_parts(options);
    SurfaceInput input;
    std::visit([&](const auto& surface) { document::about_file(options.file, [&] { surface.validate(); }); }, heights);
    const double* const first =
        heights.index() == 0 ? std::get<0>(heights).heights.data() : std::get<1>(heights).heights.data();
    input.surface.data = std::move(heights);
    input.sha256 = document::sha256({reinterpret_cast<const char*>(first), input.points() * sizeof(double)});
    input.surface.record.name = document::display_name(options.file);
    input.surface.record.format = io::SurfaceFormat::npy;
    input.surface.record.format_from = origin;
    clean_input(options, input);
    return input;
}

SurfaceInput read_surface_input(const SurfaceOptions& options) {
    return read_surface_input(options, document::read_all(options.file));
}

SurfaceInput read_surface_input(const SurfaceOptions& options, std::string bytes) {
    refuse_parts(options);
    if (is_document(bytes))
        throw domain_error(document::display_name(options.file) +
                           ": is JSON that fstiff printed; must be a profile or a map (run --surface and surface.from "
                           "read the JSON of fstiff measure)");
    io::SurfaceOptions reading;
    reading.format = options.format;
    reading.units = options.units;
    if (!options.prefix.empty()) reading.names = {std::string(options.prefix), std::string(options.format_name), " "};
    reading.column = static_cast<std::size_t>(options.column);
    reading.x_column = static_cast<std::size_t>(options.x_column);
    const auto length = [&](const Amount& given, const char* key) {
        return given.empty() ? std::optional<double>() : parse_length(given, options.name(key));
    };
    reading.spacing = length(options.spacing, "spacing");
    reading.dx = length(options.dx, "dx");
    reading.dy = length(options.dy, "dy");
    reading.width = length(options.width, "width");
    reading.height = length(options.height, "height");
    reading.missing = options.missing;
    reading.thousands = options.thousands;
    reading.resample = options.resample;
    reading.x3p_increment = options.x3p_increment.value_or(io::X3pIncrement::apply);
    reading.channel = options.channel;
    reading.grid = length(options.grid, "grid");
    SurfaceInput input;
    read_faces(options, std::move(bytes), reading, input);
    clean_input(options, input);
    return input;
}

namespace {

/// The form of a profile that \p options name; the line before the Gaussian filter.
Form form_of_profile(const SurfaceOptions& options) {
    if (options.detrend != gaussian_form) {
        const Form form = options.detrend.empty()
                              ? Form::line
                              : form_of<Form>(options, options.detrend, "profile", ", " + std::string(gaussian_form));
        refuse_cutoff(options);
        return form;
    }
    const std::string name = options.name("cutoff"), form = options.name("detrend") + " gaussian ";
    if (options.cutoff.empty()) throw document::option_error(form + "needs " + name + ", such as \"0.8 mm\"");
    if (!options.lambda_c.empty() && options.lambda_c != Amount("none"))
        throw document::option_error(form + "has the cut-off " + name +
                                     " already; must not be given with another cut-off of long waves");
    return Form::line;
}

}  // namespace

fstiff::MeasureOptions<double> options_for_profile(const SurfaceOptions& options, const SurfaceInput& input) {
    if (!input.surface.is_profile())
        throw domain_error(document::display_name(options.file) + ": holds a map (" +
                           std::to_string(input.surface.map().columns()) + " x " +
                           std::to_string(input.surface.map().rows()) + " points); must be a profile");
    const Form form = form_of_profile(options);
    const Profile<double>& read = input.surface.profile();
    const double radius = radius_of_form(options, form == Form::circle, read.length());
    return document::about_file(options.file, [&] {
        fstiff::MeasureOptions<double> measuring = library_options(options);
        measuring.form = form;
        measuring.form_radius = radius;
        if (options.detrend == gaussian_form)
            measuring.form_cut_off = parse_length(options.cutoff, options.name("cutoff"));
        measuring.height_step = input.surface.record.resolution;
        require_cut_offs(options, measuring, read.spacing, read.length());
        return measuring;
    });
}

fstiff::MeasureOptions<double> options_for_map(const SurfaceOptions& options, const SurfaceInput& input) {
    if (input.surface.is_profile())
        throw domain_error(document::display_name(options.file) + ": holds a profile (" +
                           std::to_string(input.surface.profile().size()) + " points); must be a map");
    const MapForm form = options.detrend.empty() ? MapForm::plane : form_of<MapForm>(options, options.detrend, "map");
    refuse_cutoff(options);
    const HeightMap<double>& map = input.surface.map();
    const double shorter =
        std::min(static_cast<double>(map.columns()) * map.dx, static_cast<double>(map.rows()) * map.dy);
    const double radius = radius_of_form(options, detail::is_round(form), shorter);
    return document::about_file(options.file, [&] {
        fstiff::MeasureOptions<double> measuring = library_options(options);
        measuring.map_form = form;
        measuring.form_radius = radius;
        measuring.height_step = input.surface.record.resolution;
        require_cut_offs(options, measuring, std::max(map.dx, map.dy), shorter);
        return measuring;
    });
}

constexpr const char* upper_half = " through the points above the median";

std::string form_name(const LevelledProfile<double>& levelled) {
    return std::string(levelled.cutoff ? gaussian_form : name_of(levelled.removed)) +
           (levelled.settled ? upper_half : "");
}
std::string form_name(const LevelledMap<double>& levelled) {
    return std::string(name_of(levelled.removed)) + (levelled.settled ? upper_half : "");
}

std::string radius_clause(double radius) {
    return radius == 0
               ? ""
               : (radius < 0 ? ", hollow, of radius " : " of radius ") + document::shown_length(std::abs(radius));
}

PreparedProfile<double> level_profile(const SurfaceOptions& options, const SurfaceInput& input) {
    const auto measuring = options_for_profile(options, input);
    return document::about_file(options.file, [&] { return prepare(input.surface.profile(), measuring); });
}

PreparedMap<double> level_map(const SurfaceOptions& options, const SurfaceInput& input) {
    const auto measuring = options_for_map(options, input);
    return document::about_file(options.file, [&] { return prepare(input.surface.map(), measuring); });
}

PreparedMap<double> level_map_of(const SurfaceOptions& options, SurfaceInput& input) {
    const auto measuring = options_for_map(options, input);
    return document::about_file(options.file, [&] { return prepare(input.take_map(), measuring); });
}

std::string gradient_warning(double rms_gradient, std::string_view origin) {
    if (detail::is_plausible_gradient(rms_gradient)) return "";
    const bool flat = rms_gradient < detail::min_plausible_gradient<double>;
    return "the rms gradient" +
           (std::isfinite(rms_gradient) ? ", " + document::rounded(rms_gradient, 3) + "," : std::string()) + " is " +
           (flat ? "below 1e-06" : "above 1") + " (" + std::string(origin) + "): no rough surface is that " +
           (flat ? "flat" : "steep") + "; a unit of its lengths is likely wrong";
}

std::vector<std::string> reading_warnings(const SurfaceInput& input, std::string_view consequence,
                                          std::optional<double> rms_gradient) {
    std::vector<std::string> warnings = input.surface.record.warnings;
    if (rms_gradient && !detail::is_plausible_gradient(*rms_gradient))
        warnings.push_back(gradient_warning(*rms_gradient, "measured"));
    if (input.missing() > 0)
        warnings.push_back(std::to_string(input.missing()) + " of " + std::to_string(input.points()) +
                           " points are missing; " + std::string(consequence));
    return warnings;
}

}  // namespace fstiff::surface
