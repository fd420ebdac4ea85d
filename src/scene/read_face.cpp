// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"
#include "request/words.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/resolve.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace fstiff::scene {

std::string beside_scene(Source& source, const std::string& file) {
    return source.files.emplace_back(
        file == "-" ? file
                    : document::name_of_path(document::path_of(source.file).parent_path() / document::path_of(file)));
}

bool read_surface_option(Source& source, const Section& section, const surface::SurfaceOptionRow& row,
                         surface::SurfaceOptions& options) {
    const toml::node* const node = section.find(row.key);
    if (!node) return false;
    row.visit(options, [&](auto& to) {
        source.read(*node, section.key(row.key), to, row.field_for(surface::SurfaceKind::any));
        if constexpr (std::is_same_v<decltype(to), std::string&>)
            if (row.more.form == request::Form::file) to = beside_scene(source, to);
    });
    return true;
}

namespace {

using Measured = std::shared_ptr<const surface::MeasuredSurface>;

std::shared_ptr<const Surface<double>> found_of(const Measured& measured) { return {measured, &measured->found}; }

/// Measures or reads the files that surface.from or --surface names; messages begin with \p place.
Measured measured_from(const surface::MeasureOptions& options, const std::vector<std::string>& files, bool defaults,
                       const Place& place, const ProgressHook& progress) {
    return std::make_shared<const surface::MeasuredSurface>(detail::located(place, [&] {
        std::error_code none;
        const bool has_parts = !options.input.columns.empty() || !options.input.channels.empty();
        if (has_parts || files.size() > 1 || std::filesystem::is_directory(document::path_of(files.front()), none))
            return measure_files(options, files, progress);
        const std::string& file = files.front();
        std::string bytes = document::read_all(file);
        if (!surface::is_measured_document(bytes)) {
            surface::MeasureOptions of_file = options;
            of_file.input.file = file;
            return measure_surface(of_file, std::move(bytes), progress);
        }
        if (!defaults)
            throw domain_error(document::display_name(file) +
                               ": is the JSON of fstiff measure, measured already; give it without keys of reading");
        return surface::read_measured_document(bytes, document::display_name(file));
    }));
}

/// The files that \p from names, relative to the scene.
std::vector<std::string> files_of(Source& source, const toml::node& from, const std::string& key) {
    const auto read_one = [&](const toml::node& node, const std::string& name) {
        const std::string file = source.text(node, name);
        if (file.empty()) source.refuse(node, name, "must name a file");
        return beside_scene(source, file);
    };
    const auto* list = from.as_array();
    if (!list) return {read_one(from, key)};
    if (list->empty()) source.refuse(from, key, "is an empty list; at least one file is needed");
    std::vector<std::string> files;
    for (std::size_t i = 0; i < list->size(); ++i)
        files.push_back(read_one((*list)[i], key + "[" + std::to_string(i) + "]"));
    return files;
}

Measured read_from(Source& source, const Section& surface, const ProgressHook& progress) {
    const toml::node& from = surface.at("from");
    surface::MeasureOptions options;
    options.neighbours = source.has_band;
    options.parallel = source.parallel;
    const std::vector<std::string> files = files_of(source, from, surface.key("from"));
    bool defaults = true;
    for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
        if (read_surface_option(source, surface, row, options.input)) defaults = false;
    return measured_from(options, files, defaults, source.place(from, surface.key("from")), progress);
}

/// Puts on record what was measured of the face that the scene calls \p place.
void record_measured(Source& source, const surface::MeasuredSurface& measured, const std::string& place) {
    for (const surface::ParameterLine& line : parameter_lines(measured))
        source.record(place + "." + line.name + " (measured)", document::shortest(line.measured.value),
                      line.measured.value,
                      line.unit == "/m^2"    ? "1/m^2"
                      : line.name == "theta" ? "rad"
                                             : line.unit);
}

/// The keys of a face in \p table.
std::vector<std::string_view> keys_of_face(const toml::table& table) {
    std::vector<std::string_view> keys;
    add_keys_of(JointFace(), keys);
    for (const std::string_view key : {"from", "errors", "process", "worn", "measured"}) keys.push_back(key);
    for (const std::string_view key : bearing_keys()) keys.push_back(key);
    if (table.contains("from"))
        for (const surface::SurfaceOptionRow& row : surface::surface_option_table()) keys.push_back(row.key);
    return keys;
}

/// Puts on record what follows from numbers of other names, at the place of these, and R and D_p of the moments.
void record_following(Source& source, const Section& surface, const detail::Face& face,
                      const std::vector<Following>& following) {
    for (auto number = following.rbegin(); number != following.rend(); ++number) {
        const double value = number->name == "rms_height"     ? face.parameters.rms_height.value
                             : number->name == "rms_gradient" ? *face.rms_gradient
                                                              : number->value;
        source.inputs.insert(source.inputs.begin() + static_cast<std::ptrdiff_t>(number->place),
                             {surface.key(number->name), "of " + std::string(number->of), value,
                              number->name == "rms_height" ? "m" : "", false});
    }
    for (const auto& [follows, which] : {std::pair(face.radius_follows, Parameter::peak_radius),
                                         std::pair(face.density_follows, Parameter::peak_density)})
        if (follows)
            source.record_default(surface.key(detail::row_of(which).key), "of rms_height, rms_gradient and alpha",
                                  *face.value(which), detail::row_of(which).unit);
}

/// The face of \p face; what it lacks is refused at the key of \p surface that it follows from.
detail::Face face_of_section(const Source& source, const Section& surface, const JointFace& given) {
    try {
        return detail::face_of(given);
    } catch (const domain_error& error) {
        std::string key(error.parameter() == "bearing" ? first_bearing_key(surface)
                                                       : key_of_number(surface, error.parameter()));
        if (key.empty()) key = error.parameter();
        if (key.empty()) throw error.with_place(source.place(surface.node()));
        if (const toml::node* node = surface.find(key))
            source.refuse(*node, surface.key(key), std::string(error.reason()));
        throw domain_error(source.at(surface.node()) + ": " + surface.key(key) + ": " + std::string(error.reason()));
    }
}

/// "upper: " of the key "surface.upper.process"; empty of one face.
std::string label_of(const std::string& key) {
    const std::size_t begin = key.find('.') + 1, end = key.find('.', begin);
    return end == key.npos ? "" : key.substr(begin, end - begin) + ": ";
}

/// The process of a face by any word for it, which the record explains.
Process read_process(Source& source, const toml::node& node, const std::string& key, Scene& scene) {
    const auto* text = node.as_string();
    const auto process = text ? detail::find_process(text->get()) : std::nullopt;
    if (!process)
        source.refuse(
            node, key,
            "must be one of " + document::list_of(detail::choices<Process>()) +
                ", or another word for one of these (fstiff help processes); any other process is \"unknown\"");
    const std::string word = text->get(), name(name_of(*process));
    source.record(key, word == name ? word : word + " (" + name + ")");
    if (*process == Process::unknown && word != name)
        scene.assumptions.push_back(label_of(key) + "no ranges for \"" + document::printable(word) +
                                    "\" surfaces are known: those of an unknown process");
    return *process;
}

/// The process of \p face, whether it is worn, and what part of it was measured, of \p surface, the section \p path.
void read_origin(Source& source, const toml::table& surface, const std::string& path, JointFace& face, Scene& scene) {
    if (const toml::node* node = surface.get("process"))
        face.process = read_process(source, *node, path + ".process", scene);
    if (const toml::node* node = surface.get("worn")) source.read(*node, path + ".worn", face.worn, {});
    const toml::node* node = surface.get("measured");
    if (!node) return;
    constexpr std::array<std::string_view, 2> parts{"piece", "whole"};
    face.whole = source.choice(*node, path + ".measured", parts) == 1;
    if (!face.measured) source.refuse(*node, path + ".measured", "needs a measured map, " + path + ".from");
}

/// Reads the section \p path, the next face of \p scene.
detail::Face read_face(Source& source, const toml::table& table, const std::string& path, Scene& scene,
                       const ProgressHook& progress) {
    refuse_extremes(source, table, path);
    const Section surface(source, &table, path, keys_of_face(table));
    JointFace given;
    Measured& measured = scene.measured.emplace_back();
    if (surface.find("from")) {
        measured = read_from(source, surface, progress);
        record_measured(source, *measured, path);
        given.measured = measured_face(found_of(measured));
    }
    read_origin(source, table, path, given, scene);
    const std::vector<Following> following = read_numbers(source, surface, given);
    if (const toml::node* node = surface.find("Ra"); node && request::mean_height_of_grade(written(*node)))
        scene.assumptions.push_back(label_of(surface.key("Ra")) + "Ra " + document::shown_length(*given.mean_height) +
                                    ", of " + written(*node));
    read_errors(source, surface, given);
    read_bearing(source, surface, given);
    detail::Face face = face_of_section(source, surface, given);
    if (surface.find("Sa"))
        for (detail::Prior& prior : face.priors)
            if (prior.origin == detail::Origin::mean_height) prior.origin = detail::Origin::mean_heights;
    record_following(source, surface, face, following);
    scene.given.face = std::move(given);
    return face;
}

/// What was measured of \p file.
Measured measured_of(Source& source, const std::string& file, const ProgressHook& progress) {
    surface::MeasureOptions options;
    options.input.prefix = "fstiff measure --";  // has the options that run has not
    options.input.format_name = "fstiff measure --input-format";
    options.neighbours = source.has_band;
    options.parallel = source.parallel;
    options.neighbour_dimensions = source.needs_dimension_of_maps;
    try {
        return measured_from(options, {file}, true, {.key = "--surface"}, progress);
    } catch (const domain_error& error) {
        if (error.reason().find(options.input.prefix) == std::string_view::npos) throw;
        throw domain_error(std::string(error.what()) +
                           "; --surface reads the JSON that fstiff measure prints, [surface] takes these keys");
    }
}

}  // namespace

void take_surface(Source& source, const SceneSource& from, const toml::table* surface, Scene& scene) {
    const Measured measured = from.measured ? std::make_shared<const surface::MeasuredSurface>(*from.measured)
                                            : measured_of(source, from.surface, from.progress);
    source.record("surface.from", from.measured ? measured->file + " (measured before)"
                                                : document::display_name(from.surface) + " (--surface)");
    record_measured(source, *measured, "surface");
    JointFace given{.measured = measured_face(found_of(measured))};
    if (surface) read_origin(source, *surface, "surface", given, scene);
    scene.joint.face = detail::face_of(given);
    scene.measured = {measured};
}

void read_surface(Source& source, const toml::table& table, Scene& scene, const ProgressHook& progress) {
    if (!table.contains("upper") && !table.contains("lower")) {
        scene.joint.face = read_face(source, table, "surface", scene, progress);
        source.record("surface.lower", "smooth (default): [surface] alone is one rough face");
        return;
    }
    const Section surface(source, &table, "surface", {"upper", "lower", "shifts"});
    if (!surface.find("upper") || !surface.find("lower")) {
        const char* there = surface.find("upper") ? "upper" : "lower";
        scene.joint.face = read_face(source, surface.subtable(there), surface.key(there), scene, progress);
        source.record_default(surface.key(surface.find("upper") ? "lower" : "upper"), "smooth");
        return;
    }
    for (const char* name : {"upper", "lower"})
        scene.joint.faces.push_back(read_face(source, surface.subtable(name), surface.key(name), scene, progress));
    const detail::Face &upper = scene.joint.faces.front(), &lower = scene.joint.faces.back();
    const std::string no_sum = no_sum_of_maps(upper, lower);
    scene.shifts = 4;
    if (const toml::node* node = surface.find("shifts")) {
        source.read(*node, surface.key("shifts"), scene.shifts, {.low = 1, .high = 1000});
        if (!no_sum.empty()) surface.refuse("shifts", "needs two maps of one grid: " + no_sum);
    } else if (no_sum.empty()) {
        source.record_default(surface.key("shifts"), "4", 4);
    }
    scene.joint.face =
        source.located(table, [&] { return detail::sum_of_faces(upper, lower, scene.shifts, scene.seed); });
    for (const detail::ParameterRow& row : detail::surface_parameter_table)
        if (const auto value = scene.joint.face.value(row.parameter))
            source.record(surface.key(row.key) + " (of the sum)", document::shortest(*value), *value, row.unit);
    if (upper.map && lower.map && !no_sum.empty())
        scene.warnings.push_back("the sum of the two maps, which laws of a map need, is not computed: " + no_sum);
}

}  // namespace fstiff::scene
