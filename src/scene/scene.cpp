// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene.hpp"

#include "document/file.hpp"
#include "scene/law_options.hpp"
#include "scene/range.hpp"
#include "scene/read_face.hpp"
#include "scene/read_table.hpp"
#include "scene/source.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/surface/fractal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <string_view>

namespace fstiff::scene {
namespace {

/// What decides which body is the softer one.
struct Strength {
    std::optional<double> yield, hardness;
    double poisson = 0;
    /// Hardness, given or by Tabor's factor; infinite where nothing is known.
    [[nodiscard]] double resistance() const {
        return hardness ? *hardness : yield ? 2.8 * *yield : std::numeric_limits<double>::infinity();
    }
};

Material<double> read_material(Source& source, const Section& body, Strength& strength) {
    Material<double> material{};
    material.youngs_modulus = body.positive("youngs_modulus", Dimension::pressure);
    const toml::node& nu = body.at("poisson_ratio");
    material.poisson_ratio = source.number(nu, body.key("poisson_ratio"));
    try {
        (void)effective_modulus(material, material);
    } catch (const domain_error& error) {
        throw error.with_parameter(body.key(error.parameter())).with_place(source.place(nu));
    }
    strength = {body.optional_positive("yield_strength", Dimension::pressure),
                body.optional_positive("hardness", Dimension::pressure), material.poisson_ratio};
    return material;
}

void read_materials(Source& source, const toml::table& table, Scene& scene) {
    const Section material(source, table, "material", {"upper", "lower"});
    const std::initializer_list<std::string_view> keys{"youngs_modulus", "poisson_ratio", "yield_strength", "hardness"};
    std::array<Strength, 2> of;
    const auto read = [&](const char* name, Strength& strength) {
        return read_material(source, Section(source, material.subtable(name), "material." + std::string(name), keys),
                             strength);
    };
    scene.upper = read("upper", of[0]);
    scene.lower = material.find("lower") ? read("lower", of[1]) : scene.upper;
    if (!material.find("lower")) of[1] = of[0];
    const Strength& softer = of[of[1].resistance() < of[0].resistance() ? 1 : 0];
    scene.softer_poisson = softer.poisson;
    scene.hardness = softer.hardness;
    for (const Strength& one : of)
        if (one.yield)
            scene.yield_strength = scene.yield_strength ? std::min(*scene.yield_strength, *one.yield) : *one.yield;
    if (!material.find("lower")) source.record("material.lower", "as material.upper (default)");
}

/// The impedances of a body, of longitudinal waves and, where it is known, of shear waves.
struct Body {
    double impedance = 0;
    std::optional<double> shear_impedance;
};

/// \p name, or the product of density and \p velocity; none: neither is there.
std::optional<double> read_impedance(Source& source, const Section& body, std::string_view name,
                                     std::string_view velocity, std::optional<double> density) {
    if (body.find(name)) {
        if (body.find(velocity))
            throw domain_error(source.at(*body.find(velocity)) + ": " + body.key(velocity) +
                               ": must not stand beside " + body.key(name) + "; give one of the two");
        return body.positive(name, Dimension::impedance);
    }
    const auto speed = body.optional_positive(velocity, Dimension::velocity);
    if (!speed) return std::nullopt;
    const std::string why = "is missing; " + body.key(velocity) + " needs it";
    if (!density) static_cast<void>(body.at("density", why));
    const double product = *density * *speed;
    if (!(product > 0) || !std::isfinite(product))
        source.refuse(*body.find(velocity), body.key(velocity),
                      "must make an impedance density * velocity in the range of double precision");
    return product;
}

Body read_body(Source& source, const Section& body) {
    const auto density = body.optional_positive("density", Dimension::density);
    const auto impedance = read_impedance(source, body, "impedance", "velocity", density);
    if (!impedance)
        throw domain_error(source.at(body.node()) + ": " + body.key("impedance") +
                           ": is missing; the scene needs it, or " + body.key("density") + " and " +
                           body.key("velocity"));
    return {*impedance, read_impedance(source, body, "shear_impedance", "shear_velocity", density)};
}

void read_ultrasound(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, table, "ultrasound", {"frequency", "upper", "lower"});
    const std::initializer_list<std::string_view> keys{"impedance", "density", "velocity", "shear_impedance",
                                                       "shear_velocity"};
    Waves waves;
    waves.frequency = section.positive("frequency", Dimension::frequency);
    if (!std::isfinite(waves.angular()) || waves.angular() == 0)
        source.refuse(section.at("frequency"), section.key("frequency"), "must be in the range of double precision");
    const Body upper = read_body(source, Section(source, section.subtable("upper"), "ultrasound.upper", keys));
    Body lower = upper;
    if (section.find("lower")) {
        lower = read_body(source, Section(source, section.subtable("lower"), "ultrasound.lower", keys));
        if (upper.shear_impedance.has_value() != lower.shear_impedance.has_value())
            throw domain_error(source.at(table) + ": ultrasound." + (upper.shear_impedance ? "lower" : "upper") +
                               ".shear_impedance: is missing; shear waves need that of both sides");
    } else {
        source.record("ultrasound.lower", "as ultrasound.upper (default)");
    }
    waves.longitudinal = {upper.impedance, lower.impedance};
    if (upper.shear_impedance) waves.shear = {*upper.shear_impedance, *lower.shear_impedance};
    scene.ultrasound = waves;
}

/// A list of quantities, or { from, to, count, spacing }. Pressures are positive; separations may have either sign.
std::vector<double> read_points(Source& source, const toml::node& node, const std::string& key, Dimension dimension) {
    const bool pressures = dimension == Dimension::pressure;
    const auto one = [&](const toml::node& item, const std::string& item_key) {
        return pressures ? source.positive(item, item_key, dimension) : source.quantity(item, item_key, dimension);
    };
    if (const auto* list = node.as_array()) {
        if (list->empty()) source.refuse(node, key, "is an empty list; at least one value is needed");
        std::vector<double> points;
        for (std::size_t i = 0; i < list->size(); ++i)
            points.push_back(one((*list)[i], key + "[" + std::to_string(i) + "]"));
        return points;
    }
    if (!node.is_table())
        source.refuse(node, key, "must be a list of quantities or a table { from, to, count, spacing }");

    constexpr long long most = 100000;
    constexpr std::array<std::string_view, 2> spacings{"log", "linear"};
    const Section range(source, *node.as_table(), key, {"from", "to", "count", "spacing"});
    const double from = one(range.at("from"), range.key("from"));
    const double to = one(range.at("to"), range.key("to"));
    const toml::node& count_node = range.at("count");
    const auto* count = count_node.as_integer();
    if (!count || count->get() < 2 || count->get() > most)
        source.refuse(count_node, range.key("count"), "must be a whole number from 2 to " + std::to_string(most));
    source.record(range.key("count"), written(count_node), static_cast<double>(count->get()));
    if (!(from < to)) source.refuse(range.at("to"), range.key("to"), "must be greater than " + range.key("from"));
    const bool log =
        range.find("spacing") ? source.choice(*range.find("spacing"), range.key("spacing"), spacings) == 0 : pressures;
    if (!range.find("spacing")) source.record(range.key("spacing"), std::string(spacings[log ? 0 : 1]) + " (default)");
    if (log && !(from > 0))
        source.refuse(range.at("from"), range.key("from"), "must be greater than 0 for spacing = \"log\"");

    const Range spaced{from, to, static_cast<std::uint64_t>(count->get()), log};
    std::vector<double> points;
    for (std::uint64_t i = 0; i < spaced.count; ++i) points.push_back(spaced.at(i));
    return points;
}

/// The peak density of [surface].
Peaks peaks_of_surface(const Scene& scene, const Place& where) {
    return {*scene.theta, scene.r, true, where, "surface."};
}

Peaks read_one_peaks(Source& source, const toml::node& node, const std::string& path, const Scene& scene) {
    if (node.is_string() && written(node) == "surface") {
        if (!scene.r)
            source.refuse(node, path,
                          "needs surface.r and surface.theta" +
                              (scene.measured ? ", which were not found: " + scene.measured->peaks_refusal : ""));
        source.record(path, "surface");
        return peaks_of_surface(scene, source.place(node));
    }
    if (!node.is_table())
        source.refuse(node, path, "must be a table such as { theta = \"pi/4\", r = \"exponential\" }, or \"surface\"");
    const Section section(source, *node.as_table(), path, {"theta", "r"});
    Peaks peaks;
    peaks.where = source.place(node);
    peaks.key = path + ".";

    peaks.theta = read_angle(source, section.at("theta"), section.key("theta"));
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
    if (!node) return source.record(key, "none (default)");
    if (node->is_string()) {
        if (written(*node) != "none") source.refuse(*node, key, allowed);
        return source.record(key, "none");
    }
    if (!node->is_table()) source.refuse(*node, key, allowed);
    const Section table(source, *node->as_table(), key, {"reading", "length"});
    scene.reading = source.choice<InteractionReading>(table.at("reading"), table.key("reading"));

    const toml::node* length = table.find("length");
    const std::string text = length && length->is_string() ? written(*length) : length ? "" : "nominal";
    if (const auto by = find_named<InteractionLength>(text)) {
        scene.length = *by;
        source.record(table.key("length"), length ? text : "nominal (default)");
    } else {
        scene.length = InteractionLength::given;
        scene.given_length = source.positive(*length, table.key("length"), Dimension::length);
    }
    if (scene.reading != InteractionReading::none && scene.length == InteractionLength::nominal && !scene.nominal_area)
        throw domain_error(source.at(*node) + ": " + contact.key("nominal_area") +
                           ": is missing; interaction length \"nominal\" is its square root");
}

void read_laws(Source& source, const Section& root, const Section& contact, Scene& scene, bool replaced) {
    std::vector<const Law*> chosen;
    if (const auto* node = contact.find("laws")) {
        const auto names = law_names();
        for (const auto i : source.choices(*node, contact.key("laws"), names)) chosen.push_back(&laws()[i]);
    } else {
        if (scene.fractal_dimension) chosen.push_back(find_law("fractal"));
        chosen.insert(chosen.end(), {find_law("hertz"), find_law("greenwood_williamson")});
        source.record(contact.key("laws"), scene.fractal_dimension ? "fractal, hertz, greenwood_williamson (default)"
                                                                   : "hertz, greenwood_williamson (default)");
    }
    const auto lacks = [&](const Law* law) { return law->needs_dimension && !scene.fractal_dimension; };
    if (!measured_faces(scene).empty() && (source.builtin || !contact.find("laws")) &&
        !std::count(chosen.begin(), chosen.end(), find_law("hybrid"))) {
        if (const std::string why = no_spectrum(scene); why.empty())
            chosen.insert(chosen.begin(), find_law("hybrid"));
        else
            scene.warnings.push_back("law hybrid is not computed: " + why);
    }
    if (replaced && !std::all_of(chosen.begin(), chosen.end(), lacks)) {
        if (std::erase_if(chosen, lacks) > 0) scene.warnings.push_back("no fractal law is computed, for want of D");
    }
    for (const Law* law : chosen) {
        if (lacks(law))
            throw domain_error(source.at(*contact.find("laws")) + ": surface.fractal_dimension: is missing; law \"" +
                               std::string(law->name) + "\" needs it" +
                               (scene.measured && !scene.measured->fractal_refusal.empty()
                                    ? "; it was not found: " + scene.measured->fractal_refusal
                                    : ""));
        if (const std::string why = refusal_of(*law, scene); !why.empty())
            throw domain_error((contact.find("laws") ? source.at(*contact.find("laws")) : source.file) + ": " +
                               contact.key("laws") + ": \"" + std::string(law->name) + "\" " + why);
        scene.laws.push_back(law);
        if (!is_shared(law->which)) read_law_options(source, root, law->which, scene);
    }
}

void read_peaks(Source& source, const Section& contact, Scene& scene, bool replaced) {
    const toml::node* peaks = contact.find("peaks");
    if (scene.r && (replaced || !peaks)) {
        scene.peaks.push_back(peaks_of_surface(scene, {.file = source.file}));
        source.record(contact.key("peaks"), replaced ? "surface (--surface)" : "surface (default)");
    } else if (peaks) {
        if (peaks->is_string())
            scene.peaks.push_back(read_one_peaks(source, *peaks, contact.key("peaks"), scene));
        else if (!peaks->is_array() || peaks->as_array()->empty())
            source.refuse(*peaks, contact.key("peaks"),
                          "must be \"surface\" or a list of tables such as { theta = \"pi/4\", r = \"exponential\" }");
        else
            for (std::size_t i = 0; i < peaks->as_array()->size(); ++i)
                scene.peaks.push_back(read_one_peaks(source, (*peaks->as_array())[i],
                                                     contact.key("peaks") + "[" + std::to_string(i) + "]", scene));
    } else {
        for (const char* theta : {"pi/4", "pi/3"})
            scene.peaks.push_back(
                {io::parse_angle(theta, "theta"), std::nullopt, false, {.file = source.file}, "contact.peaks."});
        scene.default_peaks = true;
        const bool isotropic = has_isotropic_peaks(scene);
        source.record(contact.key("peaks"), isotropic ? "theta = 0.001, r = 1/sqrt(alpha), of fractal laws theta = pi/4 "
                                                        "and pi/3, r = exponential (default)"
                                                      : "theta = pi/4 and pi/3, r = exponential (default)");
    }
}

void read_contact(Source& source, const Section& root, Scene& scene, bool replaced) {
    std::vector<std::string_view> keys{"nominal_area", "pressures", "separations", "laws", "peaks", "interaction"};
    for (const LawName law : laws_with_options()) keys.push_back(name_of(law));
    const Section contact(source, root.subtable("contact"), "contact", keys);
    scene.nominal_area = contact.optional_positive("nominal_area", Dimension::area);

    const toml::node* pressures = contact.find("pressures");
    const toml::node* separations = contact.find("separations");
    if (pressures && separations)
        throw domain_error(source.at(*separations) + ": " + contact.key("separations") +
                           ": must not stand beside contact.pressures; give one of the two");
    scene.at_separations = separations != nullptr;
    const toml::node& points =
        separations ? *separations
                    : contact.at("pressures", "is missing; the scene needs contact.pressures or contact.separations");
    const std::string key = contact.key(separations ? "separations" : "pressures");
    scene.points = read_points(source, points, key, separations ? Dimension::length : Dimension::pressure);
    scene.points_where = source.at(points) + ": " + key + ": ";

    read_laws(source, root, contact, scene, replaced);
    read_peaks(source, contact, scene, replaced);
    read_interaction(source, contact, scene);
}

void read_output(Source& source, const toml::table* table, Scene& scene) {
    constexpr std::array<std::string_view, 8> names{"stiffness",        "separation",           "real_area",
                                                    "contacts",         "tangential_stiffness", "reflection",
                                                    "shear_reflection", "loading_stiffness"};
    const std::array<bool*, 8> flags{&scene.stiffness,        &scene.separation,           &scene.real_area,
                                     &scene.contacts,         &scene.tangential_stiffness, &scene.reflection,
                                     &scene.shear_reflection, &scene.loading_stiffness};
    static const toml::table none;
    const Section output(source, table ? *table : none, "output", {"quantities"});
    const bool shear = scene.ultrasound && scene.ultrasound->shear;
    if (const auto* quantities = output.find("quantities")) {
        const std::string key = output.key("quantities");
        for (const auto i : source.choices(*quantities, key, names)) *flags[i] = true;
        if ((scene.reflection || scene.shear_reflection) && !scene.ultrasound)
            throw domain_error(source.at(*quantities) + ": " + key + ": needs the section ultrasound for " +
                               (scene.reflection ? "\"reflection\"" : "\"shear_reflection\""));
        if (scene.shear_reflection && !shear)
            throw domain_error(source.at(*quantities) + ": " + key +
                               ": needs ultrasound.upper.shear_impedance or shear_velocity for \"shear_reflection\"");
    } else {
        const std::size_t count = shear ? 7 : scene.ultrasound ? 6 : 4;
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            *flags[i] = true;
            text += (i ? ", " : "") + std::string(names[i]);
        }
        source.record(output.key("quantities"), text + " (default)");
    }
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

/// Of a Hurst exponent and a fractal dimension that do not belong together.
void warn_of_hurst(const Face& face, const std::string& path, std::vector<std::string>& warnings) {
    if (!face.hurst || !face.fractal_dimension) return;
    const double of_dimension = 2 - *face.fractal_dimension;
    const double error = face.uncertain.error[index_of(Parameter::fractal_dimension)];
    if (std::abs(*face.hurst - of_dimension) <= std::max(0.05, 2 * error)) return;
    warnings.push_back(path + ".hurst = " + shortest(*face.hurst) + " contradicts the fractal dimension " +
                       rounded(*face.fractal_dimension) + ", of which H = 2 - D is " + rounded(of_dimension, 3) +
                       ": hybrid and persson take hurst, the fractal laws D");
}

/// Warns of rms gradients that no surface has, unless the warnings of what was measured do.
void warn_of_gradients(Scene& scene) {
    double r = 0;  // the greatest, 1/2 where none is written
    for (const Peaks& peaks : scene.peaks) r = std::max(r, peaks.r.value_or(0.5));
    const auto warn = [&](const Face& face, const std::string& place) {
        const bool told = face.measured && std::count(face.measured->concerns.begin(), face.measured->concerns.end(),
                                                      MeasuredConcern::implausible_gradient) > 0;
        const std::string line = told ? "" : gradient_warning(face, r);
        if (told || !line.empty()) scene.implausible = true;
        if (!line.empty()) scene.warnings.push_back(place + line);
    };
    if (scene.faces.empty()) return warn(scene, "");
    warn(scene.faces[0], "upper: ");
    warn(scene.faces[1], "lower: ");
}

}  // namespace

std::vector<Assumed> assumed(const Scene& scene) {
    std::vector<Assumed> all;
    const bool of_map = scene.map && scene.spectrum_of_map;
    if (of_map || std::none_of(scene.laws.begin(), scene.laws.end(),
                               [](const Law* law) { return law->needs_spectrum; }))
        return all;
    if (!scene.hurst) {
        const double hurst = hurst_exponent(scene), least = least_hurst(spectral_moments(scene), scene.widest_band);
        all.push_back({"hurst", "H",
                       hurst == least ? "of a band as wide as what was measured"
                       : scene.fractal_dimension ? "2 - D" : "assumed, since D is not known",
                       hurst});
    }
    if (!scene.alpha)
        all.push_back({"alpha", "alpha", scene.rms_gradient ? "of sigma, R and rms_gradient" : "of sigma, R and D_p",
                       spectral_moments(scene).bandwidth()});
    return all;
}

PeakDistribution<double> peak_density(const Peaks& peaks) {
    try {
        return peaks.r ? PeakDistribution<double>(*peaks.r, peaks.theta)
                       : PeakDistribution<double>::exponential(peaks.theta);
    } catch (const domain_error& error) {
        throw error.with_parameter(peaks.key + std::string(error.parameter())).with_place(peaks.where);
    }
}

std::string refusal_of(const Law& law, const Scene& scene) {
    if (law.needs_map && !scene.map)
        return scene.faces.empty() ? "needs a map: surface.from, or --surface, must name the file of one (the JSON of "
                                     "fstiff measure holds its numbers alone)"
                                   : "needs two maps of one grid, whose heights can be added: " +
                                         no_sum_of_maps(scene.faces.front(), scene.faces.back());
    if (law.needs_summits && scene.map->summits.front().summits.empty())
        return "needs summits: no point of the map stands above its eight neighbours";
    if (law.needs_whole_map) {
        if (const std::string missing = missing_points(*scene.map); !missing.empty())
            return "needs a map without missing points: " + missing;
        for (const auto& map : scene.map->maps)
            if (std::min(map->rows(), map->columns()) < 16) return "needs a map of at least 16 points a side";
    }
    if (law.needs_spectrum)
        if (const std::string why = no_spectrum(scene); !why.empty()) return "needs a spectrum: " + why;
    if (law.needs_hardness && !scene.hardness && !scene.yield_strength)
        return "needs material.upper.hardness or material.upper.yield_strength (hardness = 2.8 times it)";
    if (law.needs_yield && !scene.yield_strength) return "needs material.upper.yield_strength";
    return "";
}

std::vector<NamedFace> measured_faces(const Scene& scene) {
    std::vector<NamedFace> all;
    if (scene.measured) all.push_back({"surface", &scene});
    constexpr std::array<std::string_view, 2> names{"upper", "lower"};
    for (std::size_t i = 0; i < scene.faces.size(); ++i)
        if (scene.faces[i].measured) all.push_back({names[i], &scene.faces[i]});
    return all;
}

Scene read_scene(const std::string& text, const SceneSource& from) {
    Scene scene = read_table(parse_scene(text, from.name), from, text == builtin_scene);
    scene.sha256 = sha256(text);
    return scene;
}

/// Whether a law of \p root takes D of a map, or what Persson's theory takes of its numbers.
static bool needs_dimension_of_maps(const toml::table& root) {
    const toml::array* names = root["contact"]["laws"].as_array();
    if (!names || root["persson"]["spectrum"]) return true;
    return std::any_of(names->begin(), names->end(), [](const toml::node& name) {
        const Law* law = find_law(name.value_or(std::string_view()));
        return !law || law->needs_dimension;
    });
}

Scene read_table(const toml::table& root, const SceneSource& from, bool builtin) {
    const std::string &file = from.name, &surface = from.surface;
    Source source{file, {}, builtin, from.has_band && root["uncertainty"]["samples"].value<std::int64_t>() != 0,
                  needs_dimension_of_maps(root)};
    Scene scene;
    scene.file = file;

    const Section top(source, root, "",
                      {"name", "surface", "material", "contact", "persson", "boundary_elements", "ultrasound",
                       "uncertainty", "output"});
    if (const auto* name = top.find("name"))
        scene.name = source.text(*name, "name");
    else
        scene.name = std::filesystem::path(file).stem().string();
    const bool replaced = from.measured || !surface.empty();
    if (from.surface_of) {
        static_cast<Face&>(scene) = static_cast<const Face&>(*from.surface_of);
        scene.faces = from.surface_of->faces;
        scene.shifts = from.surface_of->shifts;
    } else if (!replaced) {
        read_surface(source, top.subtable("surface"), scene, from.progress);
    } else {
        static_cast<Face&>(scene) =
            from.measured ? face_in_place(source, *from.measured) : face_of_file(source, surface, from.progress);
        // no longer what the scene was named for
        const std::string& measured = scene.measured->file;
        scene.name =
            measured.find(',') == std::string::npos ? std::filesystem::path(measured).filename().string() : measured;
    }
    for (const auto& [name, face] : measured_faces(scene))
        for (const std::string& warning : face->measured->warnings)
            scene.warnings.push_back((scene.faces.empty() ? "" : std::string(name) + ": ") + warning);
    for (const auto& [name, face] : measured_faces(scene))
        scene.has_lay = scene.has_lay || is_profile_with_lay(*face->measured);
    if (top.find("uncertainty")) read_uncertainty(source, top.subtable("uncertainty"), scene);
    read_materials(source, top.subtable("material"), scene);
    for (const LawName law : laws_with_options())
        if (is_shared(law)) read_law_options(source, top, law, scene);
    if (scene.law_options.spectrum) scene.spectrum_of_map = scene.law_options.spectrum == SpectrumSource::map;
    read_contact(source, top, scene, replaced);
    for (const Assumed& one : assumed(scene))
        source.record("surface." + std::string(one.key), one.how + " (default)", one.value);
    if (scene.faces.empty()) warn_of_hurst(scene, "surface", scene.warnings);
    for (std::size_t i = 0; i < scene.faces.size(); ++i)
        warn_of_hurst(scene.faces[i], i == 0 ? "surface.upper" : "surface.lower", scene.warnings);
    warn_of_gradients(scene);
    if (top.find("ultrasound")) read_ultrasound(source, top.subtable("ultrasound"), scene);
    read_output(source, top.find("output") ? &top.subtable("output") : nullptr, scene);
    scene.inputs = std::move(source.inputs);
    return scene;
}

}  // namespace fstiff::scene
