// SPDX-License-Identifier: BSD-3-Clause
// The sections [material] and [ultrasound] of a scene.
#include "scene/readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

}  // namespace

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

namespace {

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

}  // namespace

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

}  // namespace fstiff::scene
