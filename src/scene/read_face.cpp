// SPDX-License-Identifier: BSD-3-Clause
#include "scene/read_face.hpp"

#include "document/file.hpp"
#include "surface/surface_option_table.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace fstiff::scene {
namespace {

/// Measures or reads the files that surface.from or --surface names; messages begin with \p place.
MeasuredSurface measured_from(const MeasureOptions& options, const std::vector<std::string>& files, bool defaults,
                              const Place& place, const ProgressHook& progress) {
    return located(place, [&] {
        std::error_code none;
        if (files.size() > 1 || std::filesystem::is_directory(files.front(), none))
            return measure_files(options, files, progress);
        const std::string& file = files.front();
        std::string bytes = read_all(file);
        if (!is_measured_document(bytes)) {
            MeasureOptions of_file = options;
            of_file.input.file = file;
            return measure_surface(of_file, std::move(bytes), progress);
        }
        if (!defaults)
            throw domain_error(display_name(file) +
                               ": is the JSON of fstiff measure, measured already; must stand without keys of reading");
        return read_measured_document(bytes, display_name(file));
    });
}

/// \p file, which the scene names relative to itself; "-" is standard input.
std::string beside_scene(Source& source, const std::filesystem::path& file) {
    const std::filesystem::path scene(source.file);
    return source.files.emplace_back((file == "-" ? file : scene.parent_path() / file).string());
}

/// The files that \p from names, relative to the scene.
std::vector<std::string> files_of(Source& source, const toml::node& from, const std::string& key) {
    const auto one = [&](const toml::node& node, const std::string& name) {
        const std::string file = source.text(node, name);
        if (file.empty()) source.refuse(node, name, "must name a file");
        return beside_scene(source, file);
    };
    const auto* list = from.as_array();
    if (!list) return {one(from, key)};
    if (list->empty()) source.refuse(from, key, "is an empty list; at least one file is needed");
    std::vector<std::string> files;
    for (std::size_t i = 0; i < list->size(); ++i)
        files.push_back(one((*list)[i], key + "[" + std::to_string(i) + "]"));
    return files;
}

/// Reads one option of the surface, whose key messages call \p key.
struct OptionReader {
    Source& source;
    const toml::node& node;
    const std::string& key;
    const SurfaceOptionRow& row;

    void operator()(std::string& to) const {
        if (row.more.form == TextForm::or_number && node.is_number()) {
            source.record(key, to = written(node));
            return;
        }
        if (row.more.form == TextForm::or_number && !node.is_string())
            source.refuse(node, key, "must be a number or a text");
        to = source.text(node, key);
        if (row.more.form == TextForm::file) to = beside_scene(source, to);
    }
    void operator()(Lengths& to) const { to = source.text(node, key); }
    void operator()(bool& to) const {
        if (!node.is_boolean()) source.refuse(node, key, "must be true or false");
        to = node.as_boolean()->get();
        source.record(key, written(node));
    }
    void operator()(double& to) const {
        const auto number = node.value<double>();
        if (!number || !(*number >= row.more.low && *number <= row.more.high))
            source.refuse(node, key, "must be a number " + row.range());
        source.record(key, written(node), to = *number);
    }
    void operator()(int& to) const {
        const auto* number = node.as_integer();
        if (!number || number->get() < row.more.low || number->get() > row.more.high)
            source.refuse(node, key, "must be a whole number " + row.range());
        to = static_cast<int>(number->get());
        source.record(key, written(node), static_cast<double>(to));
    }
    template <NamedEnum Enum>
    void operator()(Enum& to) const {
        to = source.choice<Enum>(node, key);
    }
    template <NamedEnum Enum>
    void operator()(std::optional<Enum>& to) const {
        to = source.choice<Enum>(node, key);
    }
};

MeasuredSurface read_from(Source& source, const Section& surface, const ProgressHook& progress) {
    const toml::node& from = surface.at("from");
    MeasureOptions options;
    options.neighbours = source.has_band;
    const std::vector<std::string> files = files_of(source, from, surface.key("from"));
    bool defaults = true;
    for (const SurfaceOptionRow& row : surface_option_table())
        if (const toml::node* node = surface.find(row.key)) {
            row.visit(options.input, OptionReader{source, *node, surface.key(row.key), row});
            defaults = false;
        }
    return measured_from(options, files, defaults, source.place(from, surface.key("from")), progress);
}

/// Puts on record what was measured of the face that the scene calls \p place.
void record_measured(Source& source, const MeasuredSurface& measured, const std::string& place) {
    for (const ParameterLine& line : parameter_lines(measured))
        source.record(place + "." + line.name + " (measured)", shortest(line.measured.value), line.measured.value,
                      line.unit == "/m^2"    ? "1/m^2"
                      : line.name == "theta" ? "rad"
                                             : line.unit);
}

/// One parameter of [surface], or of surface.errors.
double read_parameter(Source& source, const Section& section, const ParameterRow& row, const toml::node& node,
                      bool zero_too = false) {
    const std::string key = section.key(row.key);
    if (row.unit.empty()) return source.number(node, key);
    for (const Dimension dimension : {Dimension::length, Dimension::inverse_area})
        if (row.unit == si_unit(dimension))
            return zero_too ? source.quantity(node, key, dimension) : source.positive(node, key, dimension);
    return read_angle(source, node, key);
}

/// rms_gradient, alpha and hurst, as they are written; what was measured stays where they are not.
void read_spectrum(Source& source, const Section& surface, Face& face) {
    const auto read = [&](std::string_view name, std::optional<double>& into, double low, double high,
                          const char* range) {
        const toml::node* node = surface.find(name);
        if (!node) return;
        into = source.number(*node, surface.key(name));
        if (!(*into > low && *into <= high)) source.refuse(*node, surface.key(name), range);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    read("rms_gradient", face.rms_gradient, 0, infinity, "must be greater than 0");
    read("alpha", face.alpha, 1.5, infinity, "must be greater than 1.5, which every isotropic surface exceeds");
    read("hurst", face.hurst, 0, 1, "must be greater than 0 and at most 1");
}

/// surface.errors.rms_gradient.
void read_gradient_error(Source& source, const Section& errors, const toml::node& node, Face& face) {
    const std::string key = errors.key("rms_gradient");
    if (!face.rms_gradient)
        source.refuse(node, key, "has no value next to it; must stand next to surface.rms_gradient");
    face.gradient_error = source.number(node, key);
    if (!(face.gradient_error >= 0)) source.refuse(node, key, "must be finite and not negative");
}

/// surface.errors: standard errors of parameters that are known.
void read_errors(Source& source, const Section& surface, const toml::node& errors, Face& face) {
    UncertainSurface<double>& uncertain = face.uncertain;
    if (!errors.is_table()) source.refuse(errors, surface.key("errors"), "must be a table of standard errors");
    std::vector<std::string_view> keys{"rms_gradient"};
    for (const ParameterRow& row : std::span(parameter_table).first<surface_parameter_count>()) keys.push_back(row.key);
    const Section section(source, *errors.as_table(), surface.key("errors"), keys);
    for (const ParameterRow& row : std::span(parameter_table).first<surface_parameter_count>()) {
        const std::size_t i = index_of(row.parameter);
        const toml::node* node = section.find(row.key);
        if (!node) continue;
        const std::string key = section.key(row.key);
        if (!uncertain.known[i])
            source.refuse(*node, key, "has no value beside it; must stand beside " + surface.key(row.key));
        uncertain.error[i] = read_parameter(source, section, row, *node, true);
        if (!(uncertain.error[i] >= 0 && std::isfinite(uncertain.error[i])))
            source.refuse(*node, key, "must be finite and not negative");
        const double half = static_cast<double>(row.high.value - row.low.value) / 2;
        if (row.variation == Variation::between && uncertain.error[i] > half)
            source.refuse(*node, key,
                          "must be at most " + rounded(half, 3) + ", half the range of " + std::string(row.key));
    }
    if (const toml::node* node = section.find("rms_gradient")) read_gradient_error(source, section, *node, face);
}

/// What is written in place of what was measured of \p face holds for its \p neighbour too.
void keep_written(const Section& surface, const Face& face, Face& neighbour) {
    for (const ParameterRow& row : std::span(parameter_table).first<surface_parameter_count>())
        if (surface.find(row.key))
            neighbour.uncertain.set(row.parameter, {face.uncertain.value[index_of(row.parameter)], 0});
    neighbour.take_uncertain();
    if (!neighbour.r) neighbour.r = face.r;
    if (!neighbour.theta) neighbour.theta = face.theta;
    if (surface.find("rms_gradient")) neighbour.rms_gradient = face.rms_gradient;
    if (surface.find("alpha")) neighbour.alpha = face.alpha;
    if (has_bearing(surface)) neighbour.shape = face.shape, neighbour.bearing = face.bearing;
    neighbour.hurst = face.hurst;
    neighbour.spectrum_of_map = face.spectrum_of_map;
}

/// Reads the section \p path, a face.
Face read_face(Source& source, const toml::table& table, const std::string& path, const ProgressHook& progress) {
    Face face;
    const auto all = std::span(parameter_table).first<surface_parameter_count>();
    const std::initializer_list<std::string_view> written_keys{"from",
                                                               "rms_height",
                                                               "peak_radius",
                                                               "peak_density",
                                                               "max_peak_height",
                                                               "fractal_dimension",
                                                               "fractal_roughness",
                                                               "r",
                                                               "theta",
                                                               "rms_gradient",
                                                               "alpha",
                                                               "hurst",
                                                               "errors"};
    std::vector<std::string_view> valid(written_keys);
    for (const std::string_view key : bearing_keys()) valid.push_back(key);
    if (table.contains("from"))
        for (const SurfaceOptionRow& row : surface_option_table()) valid.push_back(row.key);
    const Section surface(source, table, path, valid);
    if (surface.find("from")) {
        face = face_of(read_from(source, surface, progress));
        record_measured(source, *face.measured, path);
    }
    read_spectrum(source, surface, face);
    for (const std::string_view key : {"rms_height", "peak_radius", "peak_density", "rms_gradient", "alpha", "hurst"})
        if (face.map && surface.find(key)) face.spectrum_of_map = false;  // numbers written by hand replace the map's
    if (face.map && has_bearing(surface)) face.spectrum_of_map = false;
    UncertainSurface<double>& uncertain = face.uncertain;
    for (const ParameterRow& row : all) {
        const std::size_t i = index_of(row.parameter);
        // R and D_p follow from the moments where these are complete
        const bool follows = row.parameter > Parameter::rms_height && face.rms_gradient && face.alpha;
        const bool needed = !face.measured && row.parameter <= Parameter::peak_density && !follows;
        const toml::node* node = needed ? &surface.at(row.key) : surface.find(row.key);
        if (!node) {
            if (!face.measured && row.parameter <= Parameter::peak_density) {
                (row.parameter == Parameter::peak_radius ? face.radius_follows : face.density_follows) = true;
                const auto moments = moments_of_gradient(uncertain.value[index_of(Parameter::rms_height)],
                                                         *face.rms_gradient, *face.alpha);
                const double value =
                    row.parameter == Parameter::peak_radius ? peak_radius_of(moments) : peak_density_of(moments);
                if (!(value > 0 && std::isfinite(value)))
                    source.refuse(surface.at("alpha"), surface.key("alpha"),
                                  "makes, with rms_height and rms_gradient, " + std::string(row.key) + " = " +
                                      shortest(value) + ", which must be finite and greater than 0");
                uncertain.set(row.parameter, {value, 0});
                source.record(surface.key(row.key), "of rms_height, rms_gradient and alpha (default)", value,
                              row.parameter == Parameter::peak_radius ? "m" : "1/m^2");
            }
            continue;
        }
        uncertain.set(row.parameter, {read_parameter(source, surface, row, *node), 0});
        if (!parameter_in_range(row.parameter, uncertain.value[i]))
            source.refuse(*node, surface.key(row.key), "must be " + row.range());
        if (row.parameter == Parameter::fractal_dimension && uncertain.value[i] > greatest_dimension)
            source.refuse(*node, surface.key(row.key),
                          "must be greater than 1 and at most " + rounded(greatest_dimension) +
                              "; K of the fractal laws goes as 1/(2 - D)");
        for (std::size_t j = 0; j < surface_parameter_count; ++j)  // written by hand: independent of what was measured
            uncertain.correlation[i][j] = uncertain.correlation[j][i] = i == j ? 1 : 0;
    }
    if (const auto* errors = surface.find("errors")) read_errors(source, surface, *errors, face);
    face.take_uncertain();
    if (const auto highest = surface.optional_positive("max_peak_height", Dimension::length))
        face.surface.max_peak_height = *highest;
    if (const auto roughness = surface.optional_positive("fractal_roughness", Dimension::length))
        face.fractal_roughness = *roughness;
    if (face.r.has_value() != face.theta.has_value())
        throw domain_error(source.at(table) + ": " + surface.key(face.r ? "theta" : "r") + ": is missing; " +
                           surface.key("r") + " and " + surface.key("theta") + " stand side by side");
    read_bearing(source, surface, face);
    if (surface.find("fractal_dimension")) face.dimension_window_error = 0;
    for (Face& neighbour : face.neighbours) keep_written(surface, face, neighbour);
    return face;
}

}  // namespace

double read_angle(Source& source, const toml::node& node, const std::string& key) {
    if (node.is_string()) {
        const double angle = source.located(node, [&] { return io::parse_angle(written(node), key); });
        source.record(key, written(node), angle, "rad");
        return angle;
    }
    if (!node.is_number())
        source.refuse(node, key, "must be a number of radians or a text such as \"pi/4\" or \"45 deg\"");
    const double angle = source.number(node, key);
    source.inputs.back().unit = "rad";
    return angle;
}

Face face_of_file(Source& source, const std::string& file, const ProgressHook& progress) {
    MeasureOptions options;
    options.input.prefix = "fstiff measure --";  // has the options that run has not
    options.input.format_name = "fstiff measure --input-format";
    options.neighbours = source.has_band;
    options.neighbour_dimensions = source.needs_dimension_of_maps;
    Face face;
    try {
        face = face_of(measured_from(options, {file}, true, {.key = "--surface"}, progress));
    } catch (const domain_error& error) {
        if (error.reason().find(options.input.prefix) == std::string_view::npos) throw;
        throw domain_error(std::string(error.what()) + "; --surface reads the JSON that fstiff measure prints");
    }
    source.record("surface.from", display_name(file) + " (--surface)");
    record_measured(source, *face.measured, "surface");
    return face;
}

Face face_in_place(Source& source, const MeasuredSurface& measured) {
    Face face = face_of(measured);
    source.record("surface.from", measured.file + " (measured before)");
    record_measured(source, measured, "surface");
    return face;
}

void read_surface(Source& source, const toml::table& table, Scene& scene, const ProgressHook& progress) {
    const auto put = [&](Face face) { static_cast<Face&>(scene) = std::move(face); };
    if (!table.contains("upper") && !table.contains("lower")) {
        put(read_face(source, table, "surface", progress));
        source.record("surface.lower", "smooth (default): [surface] alone is one rough face");
        return;
    }
    const Section surface(source, table, "surface", {"upper", "lower", "shifts"});
    if (!surface.find("upper") || !surface.find("lower")) {
        const char* there = surface.find("upper") ? "upper" : "lower";
        put(read_face(source, surface.subtable(there), surface.key(there), progress));
        source.record(surface.key(surface.find("upper") ? "lower" : "upper"), "smooth (default)");
        return;
    }
    for (const char* name : {"upper", "lower"})
        scene.faces.push_back(read_face(source, surface.subtable(name), surface.key(name), progress));
    const Face &upper = scene.faces.front(), &lower = scene.faces.back();
    const std::string no_sum = no_sum_of_maps(upper, lower);
    scene.shifts = 4;
    if (const toml::node* node = surface.find("shifts")) {
        const auto* count = node->as_integer();
        if (!count || count->get() < 1 || count->get() > 1000)
            source.refuse(*node, surface.key("shifts"), "must be a whole number from 1 to 1000");
        if (!no_sum.empty()) source.refuse(*node, surface.key("shifts"), "needs two maps of one grid: " + no_sum);
        scene.shifts = static_cast<int>(count->get());
        source.record(surface.key("shifts"), written(*node), static_cast<double>(count->get()));
    } else if (no_sum.empty()) {
        source.record(surface.key("shifts"), "4 (default)", 4);
    }
    put(source.located(table, [&] { return sum_of_faces(upper, lower, scene.shifts, scene.seed); }));
    const Face& sum = scene;
    for (const ParameterRow& row : std::span(parameter_table).first<surface_parameter_count>())
        if (sum.uncertain.known[index_of(row.parameter)]) {
            const double value = sum.uncertain.value[index_of(row.parameter)];
            source.record(surface.key(row.key) + " (of the sum)", shortest(value), value, row.unit);
        }
    if (upper.map && lower.map && !no_sum.empty())
        scene.warnings.push_back("no sum of the two maps is computed, for laws of a map: " + no_sum);
}

}  // namespace fstiff::scene
