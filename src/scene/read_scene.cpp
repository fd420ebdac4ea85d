// SPDX-License-Identifier: BSD-3-Clause
// A scene from its text: the sections in turn, what they leave in doubt, and what is computed of them.
#include "document/file.hpp"
#include "scene/readers.hpp"

#include <fstiff/answer/concerns.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace fstiff::scene {
namespace {

/// Key that a quantity needs and the scene does not have; empty where nothing is missing.
std::string missing_for_quantities(const Scene& scene) {
    const std::tuple<bool, bool, std::string_view> needs[]{
        {scene.reflection, !scene.ultrasound, "the section ultrasound for \"reflection\""},
        {scene.shear_reflection, !scene.ultrasound, "the section ultrasound for \"shear_reflection\""},
        {scene.shear_reflection, !(scene.ultrasound && scene.ultrasound->shear),
         "ultrasound.upper.shear_impedance or shear_velocity for \"shear_reflection\""},
        {scene.joint_stiffness, !scene.nominal_area, "contact.nominal_area or contact.washer for \"joint_stiffness\""},
        {scene.thermal_conductance, !scene.conduction.thermal,
         "material.upper.thermal_conductivity for \"thermal_conductance\""},
        {scene.electrical_conductance, !scene.conduction.electrical,
         "material.upper.electrical_conductivity for \"electrical_conductance\""},
        {scene.loss_factor, !(scene.friction && scene.friction->amplitude), "friction.amplitude for \"loss_factor\""}};
    for (const auto& [asked, lacking, what] : needs)
        if (asked && lacking) return std::string(what);
    return {};
}

void read_output(Source& source, const toml::table* table, Scene& scene) {
    const auto is_written = [&](std::string_view end) {
        return std::any_of(source.inputs.begin(), source.inputs.end(), [&](const Input& input) {
            return input.given && input.key.starts_with("material.") && input.key.ends_with(end);
        });
    };
    const bool waves = scene.ultrasound.has_value(), slides = scene.friction && scene.friction->amplitude,
               heat = scene.conduction.thermal && (scene.conduction.gap || is_written(".thermal_conductivity")),
               current = scene.conduction.electrical && is_written(".electrical_conductivity");
    struct Choice {
        std::string_view name;
        bool& chosen;
        bool by_default;
    };
    const Choice choices[]{{"stiffness", scene.stiffness, true},
                           {"separation", scene.separation, true},
                           {"real_area", scene.real_area, true},
                           {"contacts", scene.contacts, true},
                           {"tangential_stiffness", scene.tangential_stiffness, waves || scene.friction},
                           {"reflection", scene.reflection, waves},
                           {"shear_reflection", scene.shear_reflection, waves && scene.ultrasound->shear},
                           {"loading_stiffness", scene.loading_stiffness, false},
                           {"joint_stiffness", scene.joint_stiffness, scene.is_joint},
                           {"approach", scene.approach, scene.is_joint},
                           {"thermal_conductance", scene.thermal_conductance, heat},
                           {"electrical_conductance", scene.electrical_conductance, current},
                           {"loss_factor", scene.loss_factor, slides}};
    static const toml::table none;
    const Section output(source, table ? *table : none, "output", {"quantities"});
    const std::string key = output.key("quantities");
    if (const auto* quantities = output.find("quantities")) {
        std::array<std::string_view, std::size(choices)> names{};
        std::transform(std::begin(choices), std::end(choices), names.begin(),
                       [](const Choice& one) { return one.name; });
        for (const auto i : source.choices(*quantities, key, names)) choices[i].chosen = true;
        if (const auto missing = missing_for_quantities(scene); !missing.empty())
            throw domain_error(source.at(*quantities) + ": " + key + ": needs " + missing);
    } else {
        std::string text;
        for (const Choice& one : choices)
            if (one.by_default) one.chosen = true, text += (text.empty() ? "" : ", ") + std::string(one.name);
        source.record_default(key, text);
    }
    scene.thermal_conductance_gap = scene.thermal_conductance && scene.conduction.gap;
    if (scene.approach && std::none_of(source.inputs.begin(), source.inputs.end(),
                                       [](const Input& input) { return input.key == "contact.seating"; }))
        source.record_default("contact.seating", "1 kPa", scene.seating, si_unit(Dimension::pressure));
}

void read_uncertainty(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, table, "uncertainty", {"samples", "seed"});
    const auto whole = [&](std::string_view name, long long most) -> std::optional<long long> {
        const toml::node* node = section.find(name);
        if (!node) return std::nullopt;
        const auto* number = node->as_integer();
        if (!number || number->get() < 0 || number->get() > most)
            source.refuse(*node, section.key(name), "must be a whole number from 0 to " + std::to_string(most));
        source.record(section.key(name), written(*node), static_cast<double>(number->get()));
        return number->get();
    };
    if (const auto samples = whole("samples", 100000)) {
        if (*samples > 0 && *samples < 20)
            source.refuse(*section.find("samples"), section.key("samples"), "must be 0 for no band, or at least 20");
        scene.samples = static_cast<int>(*samples);
    }
    if (const auto seed = whole("seed", (1LL << 53) - 1)) scene.seed = static_cast<std::uint64_t>(*seed);
}

/// Warning about a Hurst exponent and a fractal dimension that contradict each other.
void warn_of_hurst(const Face& face, const std::string& path, std::vector<std::string>& warnings) {
    const auto& dimension = face.parameters.fractal_dimension;
    if (!face.hurst || !dimension) return;
    const double of_dimension = 2 - dimension->value, error = dimension->error;
    if (std::abs(*face.hurst - of_dimension) <= std::max(0.05, 2 * error)) return;
    warnings.push_back(path + ".hurst = " + shortest(*face.hurst) + " contradicts the fractal dimension " +
                       rounded(dimension->value) + ", of which H = 2 - D is " + rounded(of_dimension, 3) +
                       ": hybrid and persson take hurst, the fractal laws D");
}

/// Warns of rms gradients that no surface has, unless the warnings of what was measured do.
void warn_of_gradients(Scene& scene) {
    constexpr std::array<std::string_view, 4> origins{
        "measured", "rms_gradient", "implied by peak_radius and peak_density", "implied by rms_height and peak_radius"};
    for (const auto& [name, face, file] : named_faces(scene)) {
        const bool told = face->measured && std::count(face->measured->concerns.begin(), face->measured->concerns.end(),
                                                       MeasuredConcern::implausible_gradient) > 0;
        const auto wrong = told ? std::nullopt : implausible_gradient(scene, *face);
        const std::string line =
            wrong ? gradient_warning(wrong->value, origins[static_cast<std::size_t>(wrong->of)]) : "";
        if (told || !line.empty()) scene.implausible = true;
        if (!line.empty()) scene.warnings.push_back((scene.faces.empty() ? "" : std::string(name) + ": ") + line);
    }
}

}  // namespace

Scene read_scene(const std::string& text, const SceneSource& from) {
    Scene scene = read_table(parse_scene(text, from.name), from, text == builtin_scene);
    scene.sha256 = sha256(text);
    return scene;
}

namespace {

/// Whether a law of \p root takes D of a map, or what Persson's theory takes of its numbers.
bool needs_dimension_of_maps(const toml::table& root) {
    const toml::array* names = root["contact"]["laws"].as_array();
    if (!names || root["persson"]["spectrum"]) return true;
    return std::any_of(names->begin(), names->end(), [](const toml::node& name) {
        const Law* law = find_law(name.value_or(std::string_view()));
        return !law || law->needs_dimension;
    });
}

/// The key of \p which in a scene, and its value in \p face.
std::pair<std::string_view, double> key_and_value(const Face& face, parts::Unknown which) {
    using parts::Unknown;
    switch (which) {
        case Unknown::height: return {"rms_height", face.parameters.rms_height.value};
        case Unknown::gradient: return {"rms_gradient", *face.rms_gradient};
        case Unknown::alpha: return {"alpha", *face.alpha};
        case Unknown::hurst: return {"hurst", hurst_exponent(face)};
        case Unknown::hardness: break;  // of no face
        case Unknown::skewness: return {"skewness", face.shape.skewness};
        case Unknown::kurtosis: return {"kurtosis", face.shape.kurtosis};
    }
    return {};
}

/// Puts on record the numbers that \p scene does not give, and that a law of it depends on.
void take_assumed_numbers(Source& source, Scene& scene) {
    if (scene.hardness_range && feels_hardness(scene, scene.laws)) {
        source.record_default("material.hardness", "assumed", scene.hardness_range->middle, "Pa");
        scene.assumptions.push_back(phrase_of_hardness(scene));
    }
    const bool one_face = scene.faces.empty();
    const std::vector<NamedFace> faces = named_faces(scene);
    for (const auto& [place, prior] : felt_priors(scene, scene.laws)) {
        if (prior->origin == Origin::measurement) continue;
        const NamedFace& of = faces[place];
        const auto [end, value] = key_and_value(*of.face, prior->which);
        const std::string key = "surface." + (one_face ? "" : std::string(of.name) + ".") + std::string(end);
        if (std::none_of(source.inputs.begin(), source.inputs.end(),
                         [&](const Input& input) { return input.key == key; }))
            source.record_default(key, "assumed", value);
        scene.assumptions.push_back((one_face ? "" : std::string(of.name) + ": ") + phrase_of(*prior, *of.face));
    }
}

}  // namespace

Scene read_table(const toml::table& root, const SceneSource& from, bool builtin) {
    const std::string &file = from.name, &surface = from.surface;
    Source source{
        file, {}, builtin, root["uncertainty"]["samples"].value<std::int64_t>() != 0, needs_dimension_of_maps(root)};
    Scene scene;
    scene.file = file;

    const Section top(source, root, "",
                      {"name", "surface", "material", "contact", "persson", "boundary_elements", "ultrasound", "gap",
                       "friction", "uncertainty", "output"});
    if (const auto* name = top.find("name"))
        scene.name = source.text(*name, "name");
    else
        scene.name = name_of_path(path_of(file).stem());
    const bool replaced = from.measured || !surface.empty();
    if (from.surface_of) {
        scene.face = from.surface_of->face;
        scene.faces = from.surface_of->faces;
        scene.measured = from.surface_of->measured;
        scene.shifts = from.surface_of->shifts;
    } else if (!replaced) {
        read_surface(source, top.subtable("surface"), scene, from.progress);
    } else {
        if (from.measured)
            take_surface_in_place(source, *from.measured, scene);
        else
            read_file_of_surface(source, surface, scene, from.progress);
        // no longer what the scene was named for
        const std::string& measured = scene.measured.front()->file;
        scene.name = measured.find(',') == std::string::npos ? name_of_path(path_of(measured).filename()) : measured;
    }
    if (top.find("uncertainty")) read_uncertainty(source, top.subtable("uncertainty"), scene);
    read_materials(source, top.find("material") ? &top.subtable("material") : nullptr, scene);
    if (builtin && replaced) scene.assumptions.push_back("the material, which is the steel of the built-in scene");
    read_contact(source, top, scene, replaced);
    for (const Assumed& one : assumed(scene))
        source.record_default("surface." + std::string(one.key), one.how, one.value);
    take_assumed_numbers(source, scene);
    for (const auto& [name, face, file] : measured_files(scene)) {
        const std::string of = scene.faces.empty() ? "" : std::string(name) + ": ";
        if (face->is_taken_across())
            scene.assumptions.push_back(of +
                                        "the trace across the lay, as ISO 21920 has it (along it K errs 2 to 5 times)");
        for (const std::string& warning : scene.best ? file->of_file : file->warnings)
            scene.warnings.push_back(of + warning);
    }
    for (const auto& [name, face, file] : named_faces(scene))
        warn_of_hurst(*face, (scene.faces.empty() ? "" : "surface.") + std::string(name), scene.warnings);
    warn_of_gradients(scene);
    if (top.find("gap")) read_gap(source, top.subtable("gap"), scene);
    if (top.find("friction")) read_friction(source, top.subtable("friction"), scene);
    if (top.find("ultrasound")) read_ultrasound(source, top.subtable("ultrasound"), scene);
    read_output(source, top.find("output") ? &top.subtable("output") : nullptr, scene);
    scene.inputs.swap(source.inputs), scene.files.swap(source.files);
    return scene;
}

}  // namespace fstiff::scene
