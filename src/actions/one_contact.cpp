// SPDX-License-Identifier: BSD-3-Clause
#include "actions/one_contact.hpp"

#include "document/file.hpp"

#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/resolve.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/math/difference.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace fstiff::actions {
namespace {

[[noreturn]] void refuse_entry(const char* name, std::size_t value, const char* allowed) {
    throw no_such_entry(std::string(name) + " = " + std::to_string(value) + ": must be " + allowed);
}

OneContact only_contact(std::shared_ptr<const detail::ResolvedJoint> problem, const detail::Law& law, std::size_t peaks,
                        const ProgressHook& progress) {
    OneContact single{.problem = std::move(problem), .law = &law};
    for_each_contact(*single.problem, {&law}, progress, [&](const detail::ContactOfLaw& law_contact) {
        if (peaks-- == 0) single.contact = law_contact.make();
    });
    return single;
}

/// A number of a contact and the open interval in which it has a meaning.
struct Number {
    const char* name;
    double* value;
    double low = 0, high = std::numeric_limits<double>::infinity();
};

constexpr double most = std::numeric_limits<double>::infinity();

/// The numbers that are known.
std::vector<Number> known_numbers(Joint& joint) {
    std::vector<Number> numbers;
    const auto add = [&](const char* name, std::optional<double>& value, double low = 0, double high = most) {
        if (value) numbers.push_back({name, &*value, low, high});
    };
    JointFace& face = joint.face;
    add("rms_height", face.rms_height), add("peak_radius", face.peak_radius), add("peak_density", face.peak_density);
    add("max_peak_height", face.max_peak_height), add("rms_gradient", face.rms_gradient);
    add("fractal_dimension", face.fractal_dimension, 1, detail::greatest_dimension);
    add("skewness", face.skewness, -most), add("kurtosis", face.kurtosis, 1);
    add("r", face.r, 0, 1), add("theta", face.theta, 0, std::numbers::pi / 2);
    add("effective_modulus", joint.effective_modulus);
    add("yield_strength", joint.upper.yield_strength), add("hardness", joint.upper.hardness);
    if (!std::isnan(joint.upper.elastic.poisson_ratio))
        numbers.push_back({"poisson_ratio", &joint.upper.elastic.poisson_ratio, -1, 0.5});
    if (joint.interaction.length > 0) numbers.push_back({"interaction_length", &joint.interaction.length});
    return numbers;
}

/// df/dx where \p x lies in \p of: central, and inwards from an end.
template <class F>
double difference(const Number& number, double x, const F& f) {
    if (x <= number.low || x >= number.high) {
        const double h = x <= number.low ? 1e-3 : -1e-3;
        return (-137 * f(x) + 300 * f(x + h) - 300 * f(x + 2 * h) + 200 * f(x + 3 * h) - 75 * f(x + 4 * h) +
                12 * f(x + 5 * h)) /
               (60 * h);
    }
    const double scale = x == 0 ? 1 : std::abs(x), h = 4e-3 * std::min({scale, x - number.low, number.high - x});
    return math::central_difference([&](double change) { return f(x + change); }, h);
}

/// \p joint resolved; its one body has no name in refusals.
detail::ResolvedJoint problem_of_one(const Joint& joint) {
    try {
        return detail::problem_of(joint, {});
    } catch (const domain_error& error) {
        constexpr std::string_view body = "upper.";
        const std::string_view name = error.parameter();
        throw name.starts_with(body) ? error.with_parameter(std::string(name.substr(body.size()))) : error;
    }
}

}  // namespace

const ChosenLaw& law_called(const std::string& name) {
    for (const ChosenLaw& law : detail::all_laws())
        if (law.row().name == name) return law;
    throw domain_error("law = \"" + name.substr(0, 40) + "\": must be one of " +
                       document::list_and_suggestion(name, detail::law_names()));
}

OneContact make_contact(const std::string& law, Joint joint, const ProgressHook& progress) {
    const detail::Law* const named = &law_called(law).row();
    const std::string name = "law " + law + ": needs ";
    if (named->needs_yield && std::isnan(joint.upper.elastic.poisson_ratio)) throw domain_error(name + "poisson_ratio");
    const bool has_radius = joint.face.measured || (joint.face.peak_radius && joint.face.peak_density);
    if (!has_radius && (named->needs_radius() || !joint.face.rms_gradient))
        throw domain_error(name + "peak_radius and peak_density" + (named->needs_radius() ? "" : ", or rms_gradient"));
    if (JointFace& face = joint.face; face.peak_radius && face.peak_density && !face.skewness && !face.bearing)
        face.skewness = 0, face.kurtosis = 3;
    auto problem = std::make_shared<detail::ResolvedJoint>(problem_of_one(joint));
    if (named->has_peaks && named->needs_radius() && problem->default_peaks)  // others have r from the spectrum
        throw domain_error(
            name + "r and theta" +
            (joint.face.measured ? " of the surface: " + joint.face.measured->surface().why_no_peaks : ""));
    require_possible(*named, *problem);
    if (problem->hardness_range && detail::depends_on_hardness(*problem, {named}))
        throw domain_error(name + "hardness or yield_strength");
    return only_contact(std::move(problem), *named, 0, progress);
}

OneContact make_contact(const scene::Scene& scene, std::size_t law, std::size_t peaks, const ProgressHook& progress) {
    if (law >= scene.laws.size()) refuse_entry("law", law, "an entry of contact.laws");
    const detail::Law& chosen = *scene.laws[law];
    if (peaks >= (chosen.has_peaks ? peaks_of(chosen, scene.joint).size() : 1))
        refuse_entry("peaks", peaks, "an entry of contact.peaks, 0 without joint peaks");
    return only_contact(std::make_shared<const detail::ResolvedJoint>(scene.joint), chosen, peaks, progress);
}

std::map<std::string, double> sensitivity_of(const std::string& law, Joint joint, double pressure) {
    detail::require_positive("pressure", pressure);
    const auto stiffness = [&] {
        const OneContact contact = make_contact(law, joint);
        const auto point = contact.contact->at_pressures(std::span(&pressure, 1), Quantity::stiffness).front();
        if (!point.ok()) throw domain_error("pressure: " + point.reason);
        return point.state.stiffness.value;
    };
    std::vector<Number> numbers = known_numbers(joint);
    numbers.push_back({"pressure", &pressure});
    std::map<std::string, double> slopes;
    for (const Number& number : numbers) {
        const double x = *number.value;
        slopes[number.name] = difference(number, x, [&](double changed) {
            *number.value = changed;
            return stiffness();
        });
        *number.value = x;
    }
    return slopes;
}

}  // namespace fstiff::actions
