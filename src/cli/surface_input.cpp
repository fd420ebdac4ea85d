// SPDX-License-Identifier: BSD-3-Clause
#include "surface_input.hpp"

#include "sha256.hpp"
#include "surface_instances.hpp"

#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#ifdef FSTIFF_HAS_X3P
#include <fstiff/io/x3p.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fstiff::cli {
namespace {

/// Of a profile also: the line, then the filter of ISO 16610-21.
constexpr std::string_view gaussian = "gaussian";

/// The form called \p name; \p more stands behind the choices in the refusal.
template <NamedEnum FormOf>
FormOf form_of(const SurfaceOptions& options, std::string_view name, std::string_view what,
               const std::string& more = "") {
    if (const auto form = find_named<FormOf>(name)) return *form;
    throw Usage(std::string(options.prefix) + "detrend = \"" + std::string(name) + "\": of a " + std::string(what) +
                " must be one of " + choices_text<FormOf>() + more);
}

void refuse_cutoff(const SurfaceOptions& options) {
    if (!options.cutoff.empty())
        throw Usage(std::string(options.prefix) + "cutoff belongs to " + std::string(options.prefix) +
                    "detrend gaussian, of a profile; must not be given without it");
}

}  // namespace

double parse_length(const std::string& text, std::string_view name) {
    const double value = io::parse_quantity(text, io::Dimension::length, std::string(name));
    require_positive(std::string(name).c_str(), value);
    return value;
}

LagWindow<double> parse_window(const std::string& text, std::string_view name) {
    const auto comma = text.find(',');
    if (comma == std::string::npos)
        throw Usage(std::string(name) + " = \"" + text + "\": must be two lengths, such as \"1 um,100 um\"");
    return {parse_length(text.substr(0, comma), name), parse_length(text.substr(comma + 1), name)};
}

void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind) {
    options.prefix = "--";
    options.format_name = "--input-format";
    const bool profiles = kind != SurfaceKind::map, maps = kind != SurfaceKind::profile;
    arguments
        .option("--input-format", options.format,
                "form of the file: auto (default), profile, triples, matrix, sdf or x3p")
        .one_of(choices<io::SurfaceFormat>());
    arguments.option(
        "--units", options.units,
        "units of lengths and heights of a text, such as um,nm, or one for both; replace those of the file");
    std::vector<std::string_view> words;
    const auto allow = [&](std::span<const std::string_view> more) {
        for (const std::string_view word : more)
            if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    };
    std::string forms;
    if (profiles) {
        allow(choices<Form>());
        words.push_back(gaussian);
        forms = "; of a profile none, mean, line (default), parabola or gaussian";
        arguments.option("--spacing", options.spacing,
                         "distance of neighbouring points of a profile, such as \"0.5 um\"; replaces that of the file");
        arguments
            .option("--column", options.column,
                    "column of the heights of a profile, counted from 1; default the last of one or two")
            .between(1, 1000000);
        arguments.option("--cutoff", options.cutoff,
                         "wavelength that the Gaussian filter (ISO 16610-21) halves, such as \"0.8 mm\"");
    }
    if (maps) {
        allow(choices<MapForm>());
        forms += "; of a map none, mean, plane (default), quadratic or cubic";
        arguments.option("--dx", options.dx, "distance of neighbouring columns of a matrix; replaces that of the file");
        arguments.option("--dy", options.dy, "distance of neighbouring rows of a matrix");
        arguments.option("--width", options.width, "columns times dx of a matrix, instead of --dx");
        arguments.option("--height", options.height, "rows times dy of a matrix, instead of --dy");
    }
    arguments.option("--detrend", options.detrend, "form that is removed" + forms).one_of(words);
}

std::size_t SurfaceInput::points() const {
    return surface.is_profile() ? surface.profile().size() : static_cast<std::size_t>(surface.map().size());
}

std::size_t SurfaceInput::missing() const {
    return points() -
           (surface.is_profile() ? surface.profile().present() : static_cast<std::size_t>(surface.map().present()));
}

SurfaceInput read_surface_input(const SurfaceOptions& options) {
    return read_surface_input(options, read_all(options.file));
}

SurfaceInput read_surface_input(const SurfaceOptions& options, std::string bytes) {
    io::SurfaceOptions how;
    how.format = io::surface_format(options.format);
    how.units = options.units;
    if (!options.prefix.empty()) how.names = {std::string(options.prefix), std::string(options.format_name), " "};
    how.column = static_cast<std::size_t>(options.column);
    const auto length = [&](const std::string& text, const char* name) {
        return text.empty() ? std::optional<double>() : parse_length(text, std::string(options.prefix) + name);
    };
    how.spacing = length(options.spacing, "spacing");
    how.dx = length(options.dx, "dx");
    how.dy = length(options.dy, "dy");
    how.width = length(options.width, "width");
    how.height = length(options.height, "height");
#ifdef FSTIFF_HAS_X3P
    how.x3p = io::x3p_reader();
#endif
    SurfaceInput input;
    input.sha256 = sha256(bytes);
    input.surface = io::read_surface(std::move(bytes), display_name(options.file), how);
    return input;
}

LevelledProfile level_profile(const SurfaceOptions& options, const SurfaceInput& input) {
    if (!input.surface.is_profile())
        throw domain_error(display_name(options.file) + ": holds a map (" +
                           std::to_string(input.surface.map().columns()) + " x " +
                           std::to_string(input.surface.map().rows()) + " points); must be a profile");
    LevelledProfile result;
    result.form = options.detrend.empty() ? "line" : options.detrend;
    const bool filter = result.form == gaussian;
    const Form form =
        filter ? Form::line : form_of<Form>(options, result.form, "profile", ", " + std::string(gaussian));
    const std::string name = std::string(options.prefix) + "cutoff";
    if (!filter) refuse_cutoff(options);
    if (filter && options.cutoff.empty())
        throw Usage(std::string(options.prefix) + "detrend gaussian needs " + name + ", such as \"0.8 mm\"");
    if (filter) result.cutoff = parse_length(options.cutoff, name);
    about_file(options.file, [&] {
        const Profile<double>& read = input.surface.profile();
        result.rms_as_read = rms_height(read);
        static_cast<fstiff::LevelledProfile<double>&>(result) = level(read, form, result.cutoff);
        result.rms = rms_height(result.profile);
    });
    return result;
}

LevelledMap level_map(const SurfaceOptions& options, const SurfaceInput& input) {
    if (input.surface.is_profile())
        throw domain_error(display_name(options.file) + ": holds a profile (" +
                           std::to_string(input.surface.profile().size()) + " points); must be a map");
    LevelledMap result;
    result.form = options.detrend.empty() ? "plane" : options.detrend;
    const MapForm form = form_of<MapForm>(options, result.form, "map");
    refuse_cutoff(options);
    about_file(options.file, [&] {
        const HeightMap<double>& read = input.surface.map();
        result.map = remove_form(read, form);
        result.rms_as_read = rms_height(read);
        result.areal = areal_statistics(result.map);
        result.rms = result.areal.rms_height;
    });
    return result;
}

Json json_source(const SurfaceOptions& options, const SurfaceInput& input) {
    return {{"file", display_name(options.file)},
            {"sha256", input.sha256},
            {"format", io::surface_format_name(input.surface.record.format)},
            {"kind", input.surface.is_profile() ? "profile" : "map"},
            {"decisions", input.surface.record.sentences()}};
}

Json json_inputs(const SurfaceOptions& options, const std::string& form) {
    return {{"input_format", options.format}, {"units", options.units},   {"spacing", options.spacing},
            {"column", options.column},       {"dx", options.dx},         {"dy", options.dy},
            {"width", options.width},         {"height", options.height}, {"detrend", form},
            {"cutoff", options.cutoff}};
}

std::string source_lines(const SurfaceInput& input, std::string_view indent) {
    std::string text;
    for (const std::string& decision : input.surface.record.sentences()) text += std::string(indent) + decision + "\n";
    return text;
}

std::vector<std::string> missing_points_warning(const SurfaceInput& input, std::string_view consequence) {
    if (input.missing() == 0) return {};
    return {std::to_string(input.missing()) + " of " + std::to_string(input.points()) + " points are missing; " +
            std::string(consequence)};
}

}  // namespace fstiff::cli
