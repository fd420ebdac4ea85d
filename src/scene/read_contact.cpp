// SPDX-License-Identifier: BSD-3-Clause
// The section [contact] of a scene, and those of its laws.
#include "scene/law_options.hpp"
#include "scene/readers.hpp"

#include <fstiff/answer/ball.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/resolve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace fstiff::scene {

namespace {

/// The section contact.\p law, or \p law at the root where it is shared; null where there is neither. \p path is where
/// it was found.
const toml::table* section_of_law(request::Source& source, const Section& root, LawKind law, std::string& path) {
    const std::string name(name_of(law));
    const toml::node* contact = root.find("contact");
    const toml::node* within = contact && contact->is_table() ? contact->as_table()->get(name) : nullptr;
    const toml::node* at_root = is_shared(law) ? root.find(name) : nullptr;
    path = (within || !is_shared(law) ? "contact." : "") + name;
    if (within && at_root)
        throw domain_error(source.at(*at_root) + ": " + name + ": must not be given with " + path +
                           "; give one of the two");
    const toml::node* section = within ? within : at_root;
    if (!section) return nullptr;
    if (!section->is_table()) source.refuse(*section, path, "must be a section of keys");
    return section->as_table();
}

}  // namespace

void read_law_options(request::Source& source, const Section& root, LawKind law, Scene& scene) {
    std::string path;
    const toml::table* table = section_of_law(source, root, law, path);
    const auto fields = [&](auto take) { each_law_option(law, scene.joint.law_options, take); };
    const Section section(source, table, path, request::keys_of(fields));
    section.read(fields, [&](std::string_view key, const auto& to) {
        if constexpr (std::is_same_v<decltype(to), const bool&>)
            if (!is_shared(law)) source.record_default(section.key(key), to ? "1" : "0", to ? 1 : 0);
    });
    if (section.find("spectrum") && scene.joint.law_options.spectrum == detail::SpectrumSource::map &&
        !scene.joint.face.map)
        section.refuse("spectrum", "needs a map: surface.from, or --surface, must name the file of one");
}

namespace {

/// A list of quantities, or { from, to, count, spacing }, or one quantity, each as \p facts has it.
std::vector<double> read_values(Source& source, const toml::node& node, const std::string& key,
                                const NumberFacts& facts) {
    const auto read_one = [&](const toml::node& item, const std::string& item_key) {
        double value = 0;
        source.read(item, item_key, value, request::field_of(facts));
        return value;
    };
    std::vector<double> points;
    if (const auto* list = node.as_array()) {
        if (list->empty()) source.refuse(node, key, "is an empty list; at least one value is needed");
        for (std::size_t i = 0; i < list->size(); ++i)
            points.push_back(read_one((*list)[i], key + "[" + std::to_string(i) + "]"));
        return points;
    }
    if (!node.is_table()) return {read_one(node, key)};
    const Section section(source, node.as_table(), key, range_keys);
    const double from = read_one(section.at("from"), section.key("from")),
                 to = read_one(section.at("to"), section.key("to"));
    const Range range = read_range(source, section, from, to, facts.low == 0, 100000);
    for (std::uint64_t i = 0; i < range.count; ++i) points.push_back(range.at(i));
    return points;
}

/// The ball of \p load, and the pressures of its law.
void read_ball(const Section& contact, detail::Load&& load, Scene& scene) {
    for (const char* other : {"nominal_area", "washer", "bolt", "laws"})
        (void)contact.one_of(std::array<std::string_view, 2>{"ball_radius", other});
    try {
        scene.points = detail::ball_pressures(*load.ball_radius, scene.joint.effective_modulus, load.forces);
    } catch (const domain_error&) {
        contact.refuse("ball_radius", "must make a pressure in the range of double precision");
    }
    scene.ball = {*load.ball_radius, std::move(load.forces)};
    scene.listed = scene.solves_map = false;
}

/// The keys of the points, one of which a scene has.
std::vector<std::string_view> point_keys() {
    std::vector<std::string_view> keys;
    detail::Load load;
    detail::each_points(load,
                        [&](std::string_view name, auto&, const NumberFacts& facts) { add_keys(name, facts, keys); });
    return keys;
}

/// The pressures, separations or forces of the scene; forces over the nominal area are pressures.
void read_points(Source& source, const Section& contact, Scene& scene) {
    detail::Load load{.seating = scene.seating};
    const std::string_view chosen = contact.one_of(point_keys());
    const toml::node& node = contact.at(chosen.empty() ? "pressures" : chosen,
                                        "is missing; the scene needs contact.pressures, contact.force or "
                                        "contact.separations");
    const std::string key = contact.key(chosen);
    scene.points_where = source.at(node) + ": " + key + ": ";
    detail::each_points(load, [&](std::string_view name, std::vector<double>& points, const NumberFacts& facts) {
        if (name == chosen || facts.has_word(chosen)) points = read_values(source, node, key, facts);
    });
    scene.listed = !node.is_table();
    read_numbers_of(source, contact, load);
    scene.seating = load.seating;
    scene.at_separations = !load.separations.empty();
    if (load.ball_radius && load.forces.empty())
        contact.refuse("ball_radius", "needs contact.force, the load of the ball, in place of " + key);
    if (load.ball_radius) return read_ball(contact, std::move(load), scene);
    scene.points = scene.at_separations ? load.separations : load.pressures;
    if (load.forces.empty()) return;
    if (!scene.joint.nominal_area)
        throw domain_error(scene.points_where + "needs " + contact.key("nominal_area") + ", or " +
                           contact.key("washer") + ", over which a force is a pressure");
    scene.quantities.emplace("force");
    scene.joint.is_given.force = true;
    for (const double force : load.forces) {
        const double point = scene.points.emplace_back(force / *scene.joint.nominal_area);
        if (!(point > 0) || !std::isfinite(point))
            source.refuse(node, key,
                          "must be a pressure on " + contact.key("nominal_area") + " in the range of double precision");
    }
    scene.forces = std::move(load.forces);
}

/// The peak density of [surface].
detail::Peaks peaks_of_surface(const detail::Face& face, const Place& where) {
    return {*face.value(Parameter::theta), face.value(Parameter::r), true, where, "surface."};
}

detail::Peaks read_one_peaks(Source& source, const toml::node& node, const std::string& path,
                             const detail::Face& face) {
    if (node.is_string() && written(node) == "surface") {
        if (!face.has_peaks())
            source.refuse(node, path,
                          "needs surface.r and surface.theta" +
                              (face.measured ? ", which were not found: " + face.measured->why_no_peaks : ""));
        source.record(path, "surface");
        return peaks_of_surface(face, source.place(node));
    }
    if (!node.is_table())
        source.refuse(node, path, "must be a table such as { theta = \"pi/4\", r = \"exponential\" }, or \"surface\"");
    const Section section(source, node.as_table(), path, {"theta", "r"});
    detail::Peaks peaks;
    peaks.where = source.place(node);
    peaks.key = path + ".";

    source.read(section.at("theta"), section.key("theta"), peaks.theta, {.dimension = Dimension::angle});
    const toml::node& r = section.at("r");
    if (r.is_string() && written(r) == "exponential")
        source.record(section.key("r"), written(r));
    else if (!r.is_number())
        source.refuse(r, section.key("r"), "must be a number or \"exponential\"");
    else
        peaks.r = source.number(r, section.key("r"));
    return peaks;
}

void read_interaction(Source& source, const Section& contact, Scene& scene) {
    const toml::node* node = contact.find("interaction");
    const std::string key = contact.key("interaction");
    const std::string allowed =
        "must be \"none\" or a table such as { reading = \"effective_separation\", length = \"nominal\" }";
    if (!node) return source.record_default(key, "none");
    if (node->is_string()) {
        if (written(*node) != "none") source.refuse(*node, key, allowed);
        return source.record(key, "none");
    }
    if (!node->is_table()) source.refuse(*node, key, allowed);
    const Section table(source, node->as_table(), key, {"reading", "length"});
    source.read(table.at("reading"), table.key("reading"), scene.given.interaction.reading);

    const toml::node* length = table.find("length");
    const std::string text = length && length->is_string() ? written(*length) : length ? "" : "nominal";
    using Length = Joint::InteractionLength;
    if (const auto by = detail::find_named<Length>(text)) {
        scene.given.interaction_length = *by;
        length ? source.record(table.key("length"), text) : source.record_default(table.key("length"), "nominal");
    } else {
        scene.given.interaction.length = source.positive(*length, table.key("length"), Dimension::length);
    }
    if (scene.given.interaction.reading != InteractionReading::none &&
        scene.given.interaction_length == Length::nominal && !scene.given.nominal_area)
        throw domain_error(source.at(*node) + ": " + contact.key("nominal_area") +
                           ": is missing; interaction length \"nominal\" is its square root");
}

void read_laws(Source& source, const Section& root, const Section& contact, Scene& scene, bool replaced) {
    const toml::node* const node = contact.find("laws");
    if (!node || (node->is_string() && written(*node) == "best")) {
        scene.best = true;
        scene.laws = {&law_of_answer(scene.joint, scene.at_separations)};
        node ? source.record(contact.key("laws"), "best") : source.record_default(contact.key("laws"), "best");
        return read_law_options(source, root, scene.laws.front()->which, scene);
    }
    if (const toml::array* list = node->as_array())
        for (const toml::node& one : *list)
            if (one.is_string() && written(one) == "best")
                throw domain_error(
                    source.at(one) + ": " + contact.key("laws") +
                    ": \"best\" goes alone, as laws = \"best\"; the answer is computed next to any laws");
    std::vector<const detail::Law*> chosen;
    const auto names = detail::law_names();
    for (const auto i : source.choices(*node, contact.key("laws"), names))
        chosen.push_back(&detail::all_laws()[i].row());
    const auto lacks = [&](const detail::Law* law) { return law->needs_dimension && !scene.joint.face.dimension(); };
    if (replaced && !std::all_of(chosen.begin(), chosen.end(), lacks)) {
        if (std::erase_if(chosen, lacks) > 0)
            scene.warnings.push_back("no fractal law is computed, because D is not known");
    }
    const auto lacks_radius = [&](const detail::Law* law) {
        return law->needs_radius() && !scene.joint.face.has_radius_and_density();
    };
    if (!std::all_of(chosen.begin(), chosen.end(), lacks_radius) && std::erase_if(chosen, lacks_radius) > 0)
        scene.warnings.push_back("no law over a distribution of peaks is computed, because D_p is not known: " +
                                 scene.joint.face.parameters.why_no_density);
    const toml::node* const surface = root.find("surface");
    const bool two_faces = surface && surface->is_table() && surface->as_table()->contains("lower");
    for (const detail::Law* law : chosen) {
        if (lacks(law))
            throw domain_error(source.at(*node) + ": surface" + (two_faces ? ".upper" : "") +
                               ".fractal_dimension: is missing; law \"" + std::string(law->name) + "\" needs it" +
                               (two_faces ? " and fractal_roughness, of both faces" : "") +
                               (scene.joint.face.measured && !scene.joint.face.measured->why_no_dimension.empty()
                                    ? "; it was not found: " + scene.joint.face.measured->why_no_dimension
                                    : ""));
        if (const std::string why = scene.refusal_of(*law); !why.empty())
            throw domain_error(source.at(*node) + ": " + contact.key("laws") + ": \"" + std::string(law->name) + "\" " +
                               why);
        scene.laws.push_back(law);
        if (!is_shared(law->which)) read_law_options(source, root, law->which, scene);
    }
}

void read_peaks(Source& source, const Section& contact, Scene& scene, bool replaced) {
    const toml::node* peaks = contact.find("peaks");
    if (scene.joint.face.has_peaks() && (replaced || !peaks)) {
        take_peaks(scene.joint);
        scene.joint.peaks.front().where.file = source.file, scene.joint.peaks.front().key = "surface.";
        replaced ? source.record(contact.key("peaks"), "surface (--surface)")
                 : source.record_default(contact.key("peaks"), "surface");
    } else if (peaks) {
        if (peaks->is_string())
            scene.joint.peaks.push_back(read_one_peaks(source, *peaks, contact.key("peaks"), scene.joint.face));
        else if (!peaks->is_array() || peaks->as_array()->empty())
            source.refuse(*peaks, contact.key("peaks"),
                          "must be \"surface\" or a list of tables such as { theta = \"pi/4\", r = \"exponential\" }");
        else
            for (std::size_t i = 0; i < peaks->as_array()->size(); ++i)
                scene.joint.peaks.push_back(read_one_peaks(source, (*peaks->as_array())[i],
                                                           contact.key("peaks") + "[" + std::to_string(i) + "]",
                                                           scene.joint.face));
    } else {
        take_peaks(scene.joint);
        for (detail::Peaks& entry : scene.joint.peaks) entry.where.file = source.file, entry.key = "contact.peaks.";
        const bool isotropic = has_isotropic_peaks(scene.joint.face);
        source.record_default(contact.key("peaks"), isotropic ? "theta = 0.001, r = 1/sqrt(alpha), of fractal laws "
                                                                "theta = pi/4 and pi/3, r = exponential"
                                                              : "theta = pi/4 and pi/3, r = exponential");
    }
}

/// The keys of [contact].
std::vector<std::string_view> contact_keys() {
    std::vector<std::string_view> keys;
    add_keys_of(Joint(), keys);
    std::erase(keys, "effective_modulus");  // no key: [material] has the elastic constants
    add_keys_of(detail::Load(), keys);
    for (const std::string_view points : point_keys()) keys.push_back(points);
    keys.insert(keys.end(), {"washer", "bolt", "form", "laws", "peaks", "interaction"});
    for (const LawKind law : laws_with_options) keys.push_back(name_of(law));
    return keys;
}

}  // namespace

Range read_range(request::Source& source, const Section& section, double from, double to, bool log,
                 std::uint64_t most) {
    constexpr std::array<std::string_view, 2> spacings{"log", "linear"};
    std::uint64_t count = 0;
    source.read(section.at("count"), section.key("count"), count, {.low = 2, .high = static_cast<double>(most)});
    if (!(from < to)) section.refuse("to", "must be greater than " + section.key("from"));
    if (const toml::node* spacing = section.find("spacing"))
        log = source.choice(*spacing, section.key("spacing"), spacings) == 0;
    else
        source.record_default(section.key("spacing"), std::string(spacings[log ? 0 : 1]));
    if (log && !(from > 0)) section.refuse("from", "must be greater than 0 for spacing = \"log\"");
    return {from, to, count, log};
}

void resolve(Scene& scene) {
    const auto is_given = scene.joint.is_given;
    scene.joint =
        with_faces(scene.given, std::move(scene.joint.face), std::move(scene.joint.faces), scene.joint.law_options);
    scene.joint.is_given = is_given;
    if (const auto spectrum = scene.joint.law_options.spectrum)
        scene.joint.face.write(
            [&](detail::Face& face) { face.spectrum_of_map = spectrum == detail::SpectrumSource::map; });
}

void read_contact(Source& source, const Section& root, Scene& scene, bool replaced) {
    for (const LawKind law : laws_with_options)
        if (is_shared(law)) read_law_options(source, root, law, scene);
    const Section contact(source, &root.subtable("contact"), "contact", contact_keys());
    const std::pair<const char*, void (*)(Source&, const toml::table&, Scene&)> sections[]{
        {"gap", read_gap}, {"friction", read_friction}, {"ultrasound", read_ultrasound}};
    for (const auto& [name, read] : sections) {
        if (!root.find(name)) continue;
        if (contact.find("ball_radius"))
            contact.refuse("ball_radius", "must not be given with the section " + std::string(name));
        read(source, root.subtable(name), scene);
    }
    read_area(source, contact, scene, replaced);
    read_form(source, contact, scene);
    read_interaction(source, contact, scene);
    resolve(scene);
    read_points(source, contact, scene);
    read_laws(source, root, contact, scene, replaced);
    for (const LawKind law : laws_with_options)  // checked, though no law of the scene takes them
        if (!is_shared(law) && contact.find(name_of(law)) &&
            std::none_of(scene.laws.begin(), scene.laws.end(),
                         [&](const detail::Law* known) { return known->which == law; }))
            read_law_options(source, root, law, scene);
    read_peaks(source, contact, scene, replaced);
}

}  // namespace fstiff::scene
