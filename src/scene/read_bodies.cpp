// SPDX-License-Identifier: BSD-3-Clause
// The sections [material] and [ultrasound] of a scene.
#include "scene/readers.hpp"

#include "document/shown_unit.hpp"

#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/resolve.hpp>
#include <fstiff/asperity/hardness.hpp>
#include <fstiff/io/quantities.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

namespace fstiff::scene {
namespace {

const std::vector<std::string_view>& body_keys() {
    static const auto keys = [] {
        std::vector<std::string_view> all{"name"};
        add_keys_of(fstiff::Body(), all);
        return all;
    }();
    return keys;
}

/// Refuses a key of a body in [material] itself, naming the section that takes it.
void refuse_keys_of_body(const Source& source, const toml::table& material) {
    for (const auto& [key, node] : material) {
        if (key.str() == "upper" || key.str() == "lower") continue;
        const std::string_view meant = request::meant_key(key.str(), std::array<std::string_view, 2>{"upper", "lower"});
        const std::string_view of_body = request::meant_key(key.str(), body_keys());
        if (!meant.empty() || of_body.empty()) continue;
        const auto name = material["upper"].value<std::string>();
        throw domain_error(source.at(node) + ": material." + std::string(key.str()) +
                           ": is a key of a body; write [material.upper] with " +
                           (name && of_body != "name" ? "name = \"" + *name + "\" and " : "") + std::string(of_body));
    }
}

/// A body of [material].
struct ReadBody {
    fstiff::Body body{};
    bool gives_heat = false, gives_current = false;  ///< conductivities are written, and not of the name alone
    const NamedMaterial* name = nullptr;
};

const NamedMaterial& named_material(Source& source, const toml::node& node, const std::string& key) {
    const std::string name = source.text(node, key);
    if (const auto* material = find_material(name)) return *material;
    source.refuse(node, key, request::unknown_material(name, "a section with youngs_modulus and poisson_ratio"));
}

/// "240 HV", "180 HBW", "60 HRC" or "HV 240", of a body with the modulus \p modulus [Pa], as a pressure [Pa]; none:
/// \p text is a pressure.
std::optional<double> indentation_pressure(std::string_view text, double modulus, const std::string& key) {
    const auto trim = [](std::string_view part) {
        const std::size_t first = part.find_first_not_of(" \t"), last = part.find_last_not_of(" \t");
        return first == std::string_view::npos ? std::string_view() : part.substr(first, last - first + 1);
    };
    text = trim(text);
    const std::size_t scale_begin = text.find('H');
    if (scale_begin == std::string_view::npos) return std::nullopt;
    std::size_t end = scale_begin;
    while (end < text.size() && text[end] >= 'A' && text[end] <= 'Z') ++end;
    const std::string_view scale = text.substr(scale_begin, end - scale_begin),
                           before = trim(text.substr(0, scale_begin)),
                           after = trim(text.substr(end));  // the load, or the number of "HV 240"
    const bool load = !before.empty() && after.find_first_not_of("0123456789./ ") == std::string_view::npos;
    if (!load && !before.empty()) return std::nullopt;
    const double number = io::parse_number(before.empty() ? after : before, key);
    if (scale == "HV" || scale == "HK") return number * detail::vickers_pressure;
    if (scale == "HB" || scale == "HBW" || scale == "HBS")
        return number * detail::vickers_over_brinell(modulus) * detail::vickers_pressure;
    if (scale == "HRC") return detail::vickers_of_rockwell(number) * detail::vickers_pressure;
    return std::nullopt;
}

/// The hardness of \p body, whose modulus is \p modulus [Pa], as a pressure [Pa].
std::optional<double> read_hardness(Source& source, const Section& body, double modulus) {
    const toml::node* node = body.find("hardness");
    if (!node) return std::nullopt;
    const std::string text = node->value_or(std::string()), key = body.key("hardness");
    if (text == "infinite") {
        source.record(key, text);
        return std::numeric_limits<double>::infinity();
    }
    std::optional<double> pressure;
    try {
        pressure = indentation_pressure(text, modulus, key);
        if (pressure && !(*pressure > 0)) throw domain_error("must be greater than 0");
    } catch (const domain_error&) {
        source.refuse(
            *node, key,
            "must be a pressure such as \"2 GPa\", \"200 HV\", \"190 HBW\", HRC from 20 to 68, or \"infinite\" "
            "for a body that never yields");
    }
    if (!pressure) return body.positive("hardness", Dimension::pressure);
    source.record(key, text, *pressure, "Pa");
    return pressure;
}

/// A name, or a section that may begin from one: what else it holds replaces the values of the name.
ReadBody read_material(Source& source, const toml::node& node, const std::string& key) {
    if (!node.is_string() && !node.is_table())
        source.refuse(node, key, "must be the name of a material, such as \"steel\", or a section of keys");
    const Section body(source, node.as_table(), key, body_keys());
    ReadBody read;
    if (const toml::node* name = node.is_string() ? &node : body.find("name"))
        read.name = &named_material(source, *name, node.is_string() ? key : body.key("name"));
    if (read.name) read.body = body_of(*read.name);
    if (!read.name && !body.find("youngs_modulus"))
        static_cast<void>(
            body.at("youngs_modulus", "is missing; add name = \"steel\" or another material, or give it"));
    each_field(read.body, [&](std::string_view name, auto& value, const NumberFacts& facts) {
        constexpr bool required = std::is_same_v<decltype(value), double&>;
        if constexpr (!required)
            if (name == "hardness") return void(value = read_hardness(source, body, read.body.elastic.youngs_modulus));
        if (read_number(source, body, name, value, facts)) return;
        if constexpr (required) {
            if (!read.name) static_cast<void>(body.at(name));
            source.record_default(body.key(name), "of " + std::string(read.name->name), value, facts.unit);
        }
    });
    if (body.find("thermal_conductivity")) read.body.thermal_range.reset();
    read.gives_heat = body.find("thermal_conductivity"), read.gives_current = body.find("electrical_conductivity");
    return read;
}

/// Warns of a hardness or a yield strength that no material has, likely for a unit.
void warn_of_strength(const ReadBody& body, const char* name, Scene& scene) {
    const auto &yield = body.body.yield_strength, &hardness = body.body.hardness;
    const std::string place = std::string("material.") + name;
    const auto warn = [&](const char* key, double value, const char* limit, double most, const char* why) {
        scene.warnings.push_back(place + key + " = " + document::with_unit(value, "Pa", 3) + limit +
                                 document::with_unit(most, "Pa", 3) + why);
    };
    const double E = body.body.elastic.youngs_modulus;
    if (hardness && std::isfinite(*hardness) && *hardness > E / 10 && E > 15e9)
        warn(".hardness", *hardness, " is above a tenth of the modulus, ", E / 10, ": a unit is likely wrong");
    else if (hardness && std::isfinite(*hardness) && *hardness > E / 5)
        warn(".hardness", *hardness, " is above a fifth of the modulus, ", E / 5, ": a unit is likely wrong");
    if (yield && *yield > E / 10)
        warn(".yield_strength", *yield, " is above a tenth of the modulus, ", E / 10, ": a unit is likely wrong");
    if (hardness && yield && *hardness < *yield)
        warn(".hardness", *hardness, " is below the yield strength, ", *yield,
             "; a hardness is about 2.8 times the yield strength");
}

/// "205 GPa, nu 0.3".
std::string shown(const Material<double>& material) {
    return document::rounded(material.youngs_modulus / 1e9) + " GPa, nu " + document::rounded(material.poisson_ratio);
}

}  // namespace

void read_materials(Source& source, const toml::table* table, Scene& scene) {
    static const toml::table steel{{"upper", "steel"}};
    const bool assumed = !table || table->empty();
    if (table) refuse_keys_of_body(source, *table);
    const Section material(source, assumed ? &steel : table, "material", {"upper", "lower"});
    const ReadBody upper =
        read_material(source, material.at("upper", "is missing; the scene needs it"), material.key("upper"));
    const toml::node* second = material.find("lower");
    const ReadBody lower = second ? read_material(source, *second, material.key("lower")) : upper;
    if (!second) source.record_default("material.lower", "as material.upper");
    scene.upper_name = upper.name, scene.lower_name = lower.name;
    scene.given.upper = upper.body, scene.given.lower = lower.body;
    scene.joint.is_given.heat = upper.gives_heat || lower.gives_heat;
    scene.joint.is_given.current = upper.gives_current || lower.gives_current;
    warn_of_strength(upper, "upper", scene);
    if (second) warn_of_strength(lower, "lower", scene);
    if (!assumed) return;
    for (Input& input : source.inputs)
        if (input.key == "material.upper") input.given = false;
    scene.assumptions.push_back("both bodies steel, " + shown(upper.body.elastic));
}

namespace {

/// The impedances of a body, of longitudinal waves and, where it is known, of shear waves.
struct Body {
    double impedance = 0;
    std::optional<double> shear_impedance;
    bool is_shear_usual = false;  ///< by the name of the material
};

/// \p name, or the product of density and \p velocity, which is \p usual where it is not there; none: no velocity.
std::optional<double> read_impedance(Source& source, const Section& body, std::string_view name,
                                     std::string_view velocity, std::optional<double> density,
                                     std::optional<double> usual) {
    if (body.find(name)) {
        (void)body.one_of(std::array{name, velocity});
        return body.positive(name, Dimension::impedance);
    }
    const auto written = body.optional_positive(velocity, Dimension::velocity);
    const auto speed = written ? written : usual;
    if (!speed) return std::nullopt;
    if (!density) static_cast<void>(body.at("density", "is missing; " + body.key(velocity) + " needs it"));
    const double product = *density * *speed;
    if (!(product > 0) || !std::isfinite(product))
        source.refuse(written ? *body.find(velocity) : *body.find("density"), body.key(written ? velocity : "density"),
                      "must make an impedance density * velocity in the range of double precision");
    return product;
}

/// The body \p side of [ultrasound]; \p table is null where it is not there. Its missing values are those of
/// \p material, called \p name, unless it gives its impedance itself.
Body read_body(Source& source, const toml::table* table, const std::string& side, fstiff::Body material,
               const NamedMaterial* name, Scene& scene) {
    const Section body(source, table, "ultrasound." + side,
                       {"impedance", "density", "velocity", "shear_impedance", "shear_velocity"});
    if (body.find("impedance")) material = {};
    const std::string of = name ? std::string(name->name) : "material." + side;
    std::string taken;
    const auto usual = [&](const char* what, double value, std::string_view unit) {
        source.record_default(body.key(what), "of " + of, value, unit);
        taken +=
            (taken.empty() ? "" : ", ") + std::string(what) + " " + document::rounded(value) + " " + std::string(unit);
        return value;
    };
    auto density = body.optional_positive("density", Dimension::density);
    if (!density && material.density) density = usual("density", *material.density, "kg/m^3");
    const auto velocity = [&](const char* what, const char* other, const std::optional<double>& value) {
        const bool is_usual = value && !body.find(what) && !body.find(other);
        return is_usual ? std::optional(usual(what, *value, "m/s")) : std::nullopt;
    };
    const auto impedance = read_impedance(source, body, "impedance", "velocity", density,
                                          velocity("velocity", "impedance", material.velocity));
    if (!impedance)
        throw domain_error(source.at(body.node()) + ": " + body.key("impedance") +
                           ": is missing; the scene needs it, or " + body.key("density") + " and " +
                           body.key("velocity"));
    const auto usual_shear = velocity("shear_velocity", "shear_impedance", material.shear_velocity);
    const auto shear = read_impedance(source, body, "shear_impedance", "shear_velocity", density, usual_shear);
    if (!taken.empty()) scene.assumptions.push_back("ultrasound." + side + " as " + of + ": " + taken);
    return {*impedance, shear, usual_shear.has_value()};
}

}  // namespace

void read_ultrasound(Source& source, const toml::table& table, Scene& scene) {
    const Section section(source, &table, "ultrasound", {"frequency", "film_stiffness", "upper", "lower"});
    UltrasonicWaves waves;
    static_cast<void>(section.at("frequency"));
    read_numbers_of(source, section, waves);
    if (!std::isfinite(waves.angular()) || waves.angular() == 0)
        section.refuse("frequency", "must be in the range of double precision");
    const toml::table *first = section.find_subtable("upper"), *second = section.find_subtable("lower");
    if (!first && !scene.given.upper.density) static_cast<void>(section.subtable("upper"));  // which refuses it
    Body upper = read_body(source, first, "upper", scene.given.upper, scene.upper_name, scene);
    Body lower = upper;
    const auto waves_of = [](const fstiff::Body& body) {
        return std::tuple(body.density, body.velocity, body.shear_velocity);
    };
    if (second || (scene.given.lower.density && waves_of(scene.given.lower) != waves_of(scene.given.upper))) {
        lower = read_body(source, second, "lower", scene.given.lower, scene.lower_name, scene);
        if (upper.is_shear_usual && !lower.shear_impedance) upper.shear_impedance.reset();
        if (lower.is_shear_usual && !upper.shear_impedance) lower.shear_impedance.reset();
        if (upper.shear_impedance.has_value() != lower.shear_impedance.has_value())
            throw domain_error(source.at(table) + ": ultrasound." + (upper.shear_impedance ? "lower" : "upper") +
                               ".shear_impedance: is missing; shear waves need that of both sides");
    } else {
        source.record_default("ultrasound.lower", "as ultrasound.upper");
    }
    waves.longitudinal = {upper.impedance, lower.impedance};
    if (upper.shear_impedance) waves.shear = {*upper.shear_impedance, *lower.shear_impedance};
    scene.given.waves = waves;
}

namespace {

/// What [gap] holds next to the numbers of Conduction.
struct Gap {
    std::string medium{};
    std::optional<double> accommodation{}, temperature{}, emissivity{};

    void each_field(auto take) {
        const Field share{.high = 1, .above_low = true};
        std::vector<std::string_view> names;
        for (const detail::NamedMedium& known : detail::named_media) names.push_back(known.name);
        take("medium", medium, Field{.words = names});
        take("accommodation", accommodation, share);
        take("emissivity", emissivity, share);
        take("temperature", temperature, request::positive(Dimension::temperature));
    }
};

}  // namespace

void read_gap(Source& source, const toml::table& table, Scene& scene) {
    Gap gap;
    GapFilling<double> filling;
    Conduction& conduction = scene.given.conduction;
    const auto fields = [&](auto take) { gap.each_field(take); };
    const auto numbers = [&](auto take) {
        each_field(filling, take);
        each_field(conduction, [&](std::string_view name, auto& value, const NumberFacts& facts) {
            if (name.ends_with("_film")) take(name, value, facts);
        });
    };
    std::vector<std::string_view> keys = request::keys_of(fields);
    numbers([&](std::string_view name, auto&, const NumberFacts&) { keys.push_back(name); });
    const Section section(source, &table, "gap", keys);
    for (const std::string_view key : {"conductivity", "temperature_jump"})
        for (const std::string_view of_gas : {"medium", "accommodation"})
            if (section.find(key) && section.find(of_gas))
                section.refuse(key, "must not be given with " + section.key(of_gas));
    section.read(fields);
    numbers([&](std::string_view name, auto& value, const NumberFacts& facts) {
        read_number(source, section, name, value, facts);
    });
    if (gap.emissivity) static_cast<void>(section.at("temperature"));
    if (!gap.medium.empty()) {
        const auto& medium = *std::find_if(detail::named_media.begin(), detail::named_media.end(),
                                           [&](const detail::NamedMedium& each) { return each.name == gap.medium; });
        filling = {medium.gas.conductivity,
                   detail::temperature_jump(medium.gas, gap.accommodation.value_or(medium.accommodation))};
    }
    if (!gap.medium.empty() || section.find("conductivity")) conduction.gap = filling;
    if (gap.emissivity) {
        conduction.radiation = detail::radiative_conductance(*gap.temperature, *gap.emissivity);
        if (!conduction.gap) conduction.gap.emplace();
    }
}

void read_friction(Source& source, const toml::table& table, Scene& scene) {
    Friction& friction = scene.given.friction.emplace();
    std::vector<std::string_view> keys;
    add_keys_of(friction, keys);
    const Section section(source, &table, "friction", keys);
    static_cast<void>(section.at("coefficient"));
    read_numbers_of(source, section, friction);
}

}  // namespace fstiff::scene
