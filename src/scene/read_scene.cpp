// SPDX-License-Identifier: BSD-3-Clause
// A scene from its text: the sections in turn, what they leave in doubt, and what is computed of them.
#include "document/file.hpp"
#include "scene/readers.hpp"

#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/unknowns.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>

namespace fstiff::scene {
namespace {

/// The key that gives \p need.
std::string_view key_of(AnswerQuantity::Need need) {
    switch (need) {
        case AnswerQuantity::area: return "contact.nominal_area or contact.washer";
        case AnswerQuantity::waves: return "the section ultrasound";
        case AnswerQuantity::shear_waves: return "ultrasound.upper.shear_impedance or shear_velocity";
        case AnswerQuantity::slip: return "friction.amplitude";
        case AnswerQuantity::heat: return "material.upper.thermal_conductivity";
        case AnswerQuantity::current: return "material.upper.electrical_conductivity";
        case AnswerQuantity::gap: return "the section gap";
        case AnswerQuantity::bodies: return "material.upper";
        case AnswerQuantity::form: return "contact.flatness or contact.form";
        case AnswerQuantity::nothing: break;
    }
    return "";
}

void read_output(Source& source, const toml::table* table, Scene& scene) {
    const Section output(source, table, "output", {"quantities"});
    const std::string key = output.key("quantities");
    const std::vector<const AnswerQuantity*> quantities = words_for_quantities();
    std::vector<std::string_view> words;
    std::string usual;
    for (const AnswerQuantity* quantity : quantities) {
        words.push_back(quantity->word);
        if (output.find("quantities") || !quantity->is_usual || !quantity->is_usual(scene.joint)) continue;
        scene.quantities.emplace(quantity->word);
        usual += (usual.empty() ? "" : ", ") + std::string(quantity->word);
    }
    if (const auto* node = output.find("quantities")) {
        for (const auto i : source.choices(*node, key, words)) scene.quantities.emplace(words[i]);
        for (const AnswerQuantity* quantity : quantities)
            if (const auto need = lack_of(*quantity, scene.joint);
                need != AnswerQuantity::nothing && scene.asks(quantity->word))
                throw domain_error(source.at(*node) + ": " + key + ": needs " + std::string(key_of(need)) + " for \"" +
                                   std::string(quantity->word) + "\"");
    } else {
        source.record_default(key, usual);
    }
    for (const AnswerQuantity& quantity : answer_quantities())
        if (scene.asks(quantity.with) && lack_of(quantity, scene.joint) == AnswerQuantity::nothing)
            scene.quantities.emplace(quantity.word);
    if (scene.asks("approach") && std::none_of(scene.inputs.begin(), scene.inputs.end(),
                                               [](const Input& input) { return input.key == "contact.seating"; }))
        source.record_default("contact.seating", "1 kPa", scene.seating, si_unit(Dimension::pressure));
}

void read_uncertainty(Source& source, const toml::table& table, Scene& scene) {
    const auto fields = [&](auto take) {
        take("samples", scene.samples, Field{.high = 100000});
        take("seed", scene.seed, Field{});
    };
    const Section section(source, &table, "uncertainty", request::keys_of(fields));
    section.read(fields);
    if (scene.samples > 0 && scene.samples < 20) section.refuse("samples", "must be 0 for no band, or at least 20");
}

/// Warning about a Hurst exponent and a fractal dimension that contradict each other.
void warn_of_hurst(const detail::Face& face, const std::string& path, std::vector<std::string>& warnings) {
    const auto& dimension = face.parameters.fractal_dimension;
    if (!face.hurst || !dimension) return;
    const double of_dimension = 2 - dimension->value, error = dimension->error;
    if (std::abs(*face.hurst - of_dimension) <= std::max(0.05, 2 * error)) return;
    warnings.push_back(path + ".hurst = " + document::shortest(*face.hurst) + " contradicts the fractal dimension " +
                       document::rounded(dimension->value) + ", of which H = 2 - D is " +
                       document::rounded(of_dimension, 3) + ": hybrid and persson take hurst, the fractal laws D");
}

/// Warns of rms gradients that no surface has, unless the warnings of what was measured do.
void warn_of_gradients(Scene& scene) {
    constexpr std::array<std::string_view, 4> origins{
        "measured", "rms_gradient", "implied by peak_radius and peak_density", "implied by rms_height and peak_radius"};
    for (const auto& [name, face, file] : scene.named_faces()) {
        const bool told = face->measured && std::count(face->measured->concerns.begin(), face->measured->concerns.end(),
                                                       MeasuredConcern::implausible_gradient) > 0;
        const auto wrong = told ? std::nullopt : implausible_gradient(scene.joint, *face);
        const std::string line =
            wrong ? surface::gradient_warning(wrong->value, origins[static_cast<std::size_t>(wrong->source)]) : "";
        if (told || !line.empty()) scene.implausible = true;
        if (!line.empty()) scene.warnings.push_back((scene.joint.faces.empty() ? "" : std::string(name) + ": ") + line);
    }
}

/// Warns of numbers that are likely in another unit; a measured height has a warning of its own.
void warn_of_units(Scene& scene) {
    const std::span<const double> pressures(scene.points.data(), scene.at_separations ? 0 : scene.points.size());
    for (const Check<double>& check : unlikely_units(scene.joint, pressures)) {
        scene.implausible = scene.implausible || detail::makes_doubtful(check, pressures.size());
        if (check.concern != Concern::height_unit || scene.measured_files().empty())
            scene.warnings.push_back(detail::sentence_of_unit(check));
    }
}

/// Whether three lines of \p text hold numbers alone, as those of a trace or a map do.
bool holds_numbers(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t begin = 0; begin < text.size() && count < 3;) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (line.find_first_of("0123456789") != std::string_view::npos &&
            line.find_first_not_of("0123456789+-.eE,; \t\r") == std::string_view::npos)
            ++count;
        begin = end + 1;
    }
    return count == 3;
}

/// Whether \p text, which is not valid TOML, may be a measured surface: numbers, the JSON of fstiff measure, or binary.
bool is_surface(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return (first != std::string_view::npos && text[first] == '{') || text.find('\0') != std::string_view::npos ||
           holds_numbers(text);
}

/// The text of a scene as TOML. \throws domain_error for a measured surface and for a grid too, naming what reads them.
toml::table parse_scene(const std::string& text, const std::string& file) {
    toml::table table;
    try {
        table = request::parse_toml(text, file);
    } catch (const domain_error& error) {
        if (is_surface(text))
            throw domain_error(std::string(error.what()) +
                               "; a measured surface is given by --surface, or by surface.from in a scene");
        throw;
    }
    if (const toml::node* sweep = table.get("sweep"))
        throw domain_error(file + ":" + std::to_string(sweep->source().begin.line) +
                           ": sweep: is a section of a grid, which fstiff sweep reads; remove it from a scene");
    return table;
}

}  // namespace

Scene read_scene(const std::string& text, const SceneSource& from) {
    Scene scene = read_table(parse_scene(text, from.name), from, text == builtin_scene);
    scene.sha256 = document::sha256(text);
    return scene;
}

namespace {

/// Whether a law of \p root takes D of a map, or what Persson's theory takes of its numbers.
bool needs_dimension_of_maps(const toml::table& root) {
    const toml::array* names = root["contact"]["laws"].as_array();
    if (!names || root["persson"]["spectrum"]) return true;
    return std::any_of(names->begin(), names->end(), [](const toml::node& name) {
        const detail::Law* law = detail::find_law(name.value_or(std::string_view()));
        return !law || law->needs_dimension;
    });
}

/// The key of \p which in a scene, and its value in \p face.
std::pair<std::string_view, double> key_and_value(const detail::Face& face, Unknown which) {
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

/// Puts on record the numbers that \p scene does not give, and that one of \p laws of \p joint, which is that of the
/// scene, depends on. \return phrases on them.
std::vector<std::string> take_assumed(Source& source, const Scene& scene, const detail::ResolvedJoint& joint,
                                      const std::vector<const detail::Law*>& laws) {
    std::vector<std::string> phrases;
    const auto record = [&](const std::string& key, double value, std::string_view unit) {
        if (std::none_of(source.inputs.begin(), source.inputs.end(),
                         [&](const Input& input) { return input.key == key; }))
            source.record_default(key, "assumed", value, unit);
    };
    if (joint.hardness_range && depends_on_hardness(joint, laws)) {
        record("material.hardness", joint.hardness_range->middle, "Pa");
        phrases.push_back(scene.phrase_of_hardness());
    }
    const bool one_face = scene.joint.faces.empty();
    const std::vector<NamedFace> faces = scene.named_faces();
    for (const auto& [place, prior] : relevant_priors(joint, laws)) {
        if (prior->origin == detail::Origin::measurement) continue;
        const NamedFace& named = faces[place];
        const auto [end, value] = key_and_value(*named.face, prior->which);
        record("surface." + (one_face ? "" : std::string(named.name) + ".") + std::string(end), value, "");
        phrases.push_back((one_face ? "" : std::string(named.name) + ": ") + phrase_of(*prior, *named.face));
    }
    return phrases;
}

void take_assumed_numbers(Source& source, Scene& scene) {
    for (std::string& phrase : take_assumed(source, scene, scene.joint, scene.laws))
        scene.assumptions.push_back(std::move(phrase));
    if (scene.best) return;
    detail::ResolvedJoint joint = scene.joint;
    try {
        const detail::Law& law = law_of_answer(joint, scene.at_separations);
        for (std::string& phrase : take_assumed(source, scene, joint, {&law}))
            if (std::count(scene.assumptions.begin(), scene.assumptions.end(), phrase) == 0)
                scene.assumptions_of_answer.push_back(std::move(phrase));
    } catch (const domain_error&) {  // no law answers
    }
}

}  // namespace

Scene read_table(const toml::table& root, const SceneSource& from, bool builtin) {
    const std::string &file = from.name, &surface = from.surface;
    Source source{
        {file}, builtin, root["uncertainty"]["samples"].value<std::int64_t>() != 0, needs_dimension_of_maps(root)};
    source.parallel = from.parallel;
    source.in_si = from.in_si;
    Scene scene;
    scene.file = file;

    const Section top(source, &root, "",
                      {"name", "surface", "material", "contact", "persson", "boundary_elements", "ultrasound", "gap",
                       "friction", "uncertainty", "output"});
    scene.name = document::name_of_path(document::path_of(file).stem());
    if (const auto* name = top.find("name")) scene.name = source.text(*name, "name"), scene.named = true;
    const bool replaced = from.measured || !surface.empty();
    if (from.surface_of) {
        scene.joint.face = from.surface_of->joint.face;
        scene.joint.faces = from.surface_of->joint.faces;
        scene.measured = from.surface_of->measured;
        scene.shifts = from.surface_of->shifts;
    } else if (!replaced) {
        read_surface(source, top.subtable("surface"), scene, from.progress);
    } else {
        take_surface(source, from, root["surface"].as_table(), scene);
        // no longer what the scene was named for
        scene.named = false;
        const std::string& measured = scene.measured.front()->file;
        scene.name = measured.find(',') == std::string::npos
                         ? document::name_of_path(document::path_of(measured).filename())
                         : measured;
    }
    if (top.find("uncertainty")) read_uncertainty(source, top.subtable("uncertainty"), scene);
    read_materials(source, top.find_subtable("material"), scene);
    if (builtin && replaced) scene.assumptions.push_back("the material, which is the steel of the built-in scene");
    read_contact(source, top, scene, replaced);
    for (const Assumed& number : scene.assumed())
        source.record_default("surface." + std::string(number.key), number.how, number.value);
    take_assumed_numbers(source, scene);
    for (const auto& [name, face, file] : scene.measured_files()) {
        const std::string label = scene.joint.faces.empty() ? "" : std::string(name) + ": ";
        if (face->is_taken_across())
            scene.assumptions.push_back(label +
                                        "the trace across the lay, as ISO 21920 has it (along it K errs 2 to 5 times)");
        for (const std::string& warning : scene.best ? file->of_file : file->warnings)
            scene.warnings.push_back(label + warning);
    }
    for (const auto& [name, face, file] : scene.named_faces())
        warn_of_hurst(*face, (scene.joint.faces.empty() ? "" : "surface.") + std::string(name), scene.warnings);
    warn_of_gradients(scene);
    warn_of_units(scene);
    scene.inputs.swap(source.inputs);  // which quantities look at
    read_output(source, top.find_subtable("output"), scene);
    scene.inputs.insert(scene.inputs.end(), source.inputs.begin(), source.inputs.end());
    scene.files.swap(source.files);
    return scene;
}

}  // namespace fstiff::scene
