// SPDX-License-Identifier: BSD-3-Clause
#include "actions/one_contact.hpp"

#include "document/file.hpp"

#include <fstiff/answer/problem.hpp>

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

OneContact only_contact(std::shared_ptr<const detail::Problem> problem, const detail::Law& law, std::size_t peaks,
                        const ProgressHook& progress) {
    OneContact one{.problem = std::move(problem), .law = &law};
    for_each_contact(*one.problem, {&law}, progress, [&](const detail::ContactOfLaw& of) {
        if (peaks-- == 0) one.contact = of.make();
    });
    return one;
}

/// A number of a contact and the open interval in which it has a meaning.
struct Number {
    const char* name;
    double* value;
    double low = 0, high = std::numeric_limits<double>::infinity();
};

constexpr double most = std::numeric_limits<double>::infinity();

/// The numbers that are known.
std::vector<Number> known_numbers(Joint& of) {
    std::vector<Number> all;
    const auto add = [&](const char* name, std::optional<double>& value, double low = 0, double high = most) {
        if (value) all.push_back({name, &*value, low, high});
    };
    JointFace& face = of.face;
    add("rms_height", face.rms_height), add("peak_radius", face.peak_radius), add("peak_density", face.peak_density);
    add("max_peak_height", face.max_peak_height), add("rms_gradient", face.rms_gradient);
    add("fractal_dimension", face.fractal_dimension, 1, detail::greatest_dimension);
    add("skewness", face.skewness, -most), add("kurtosis", face.kurtosis, 1);
    add("r", face.r, 0, 1), add("theta", face.theta, 0, std::numbers::pi / 2);
    add("effective_modulus", of.effective_modulus);
    add("yield_strength", of.upper.yield_strength), add("hardness", of.upper.hardness);
    if (!std::isnan(of.upper.elastic.poisson_ratio))
        all.push_back({"poisson_ratio", &of.upper.elastic.poisson_ratio, -1, 0.5});
    if (of.interaction.length > 0) all.push_back({"interaction_length", &of.interaction.length});
    return all;
}

/// df/dx where \p x lies in \p of: central, and inwards from an end.
template <class F>
double difference(const Number& of, double x, const F& f) {
    if (x <= of.low || x >= of.high) {
        const double h = x <= of.low ? 1e-3 : -1e-3;
        return (-137 * f(x) + 300 * f(x + h) - 300 * f(x + 2 * h) + 200 * f(x + 3 * h) - 75 * f(x + 4 * h) +
                12 * f(x + 5 * h)) /
               (60 * h);
    }
    const double scale = x == 0 ? 1 : std::abs(x), h = 2e-3 * std::min({scale, x - of.low, of.high - x});
    return (45 * (f(x + h) - f(x - h)) - 9 * (f(x + 2 * h) - f(x - 2 * h)) + (f(x + 3 * h) - f(x - 3 * h))) / (60 * h);
}

}  // namespace

OneContact contact_of(const std::string& law, Joint joint, const ProgressHook& progress) {
    const detail::Law* const found = detail::find_law(law);
    if (!found) {
        const auto names = detail::law_names();
        throw domain_error("law = \"" + law.substr(0, 40) + "\": must be one of " + document::list_of(names));
    }
    const std::string name = "law " + law + ": needs ";
    if (found->needs_yield && std::isnan(joint.upper.elastic.poisson_ratio)) throw domain_error(name + "poisson_ratio");
    const bool has_radius = joint.face.measured || (joint.face.peak_radius && joint.face.peak_density);
    if (!has_radius && (found->needs_radius() || !joint.face.rms_gradient))
        throw domain_error(name + "peak_radius and peak_density" + (found->needs_radius() ? "" : ", or rms_gradient"));
    if (JointFace& face = joint.face; face.peak_radius && face.peak_density && !face.skewness && !face.bearing)
        face.skewness = 0, face.kurtosis = 3;
    auto problem = std::make_shared<detail::Problem>(detail::problem_of(joint, {}));
    if (found->has_peaks && problem->default_peaks)
        throw domain_error(name + "r and theta" +
                           (joint.face.measured ? " of the surface: " + joint.face.measured->why_no_peaks : ""));
    (void)detail::possible_law(found->which, *problem);
    if (problem->hardness_range && detail::feels_hardness(*problem, {found}))
        throw domain_error(name + "hardness or yield_strength");
    return only_contact(std::move(problem), *found, 0, progress);
}

OneContact contact_of(const scene::Scene& of, std::size_t law, std::size_t peaks, const ProgressHook& progress) {
    if (law >= of.laws.size()) refuse_entry("law", law, "an entry of contact.laws");
    const detail::Law& one = *of.laws[law];
    if (peaks >= (one.has_peaks ? peaks_of(one, of).size() : 1))
        refuse_entry("peaks", peaks, "an entry of contact.peaks, 0 without joint peaks");
    return only_contact(std::make_shared<const detail::Problem>(of), one, peaks, progress);
}

std::map<std::string, double> sensitivity_of(const std::string& law, Joint joint, double pressure) {
    detail::require_positive("pressure", pressure);
    const auto stiffness = [&] {
        const OneContact one = contact_of(law, joint);
        const auto point = one.contact->at_pressures(std::span(&pressure, 1), Quantity::stiffness).front();
        if (!point.ok()) throw domain_error("pressure: " + point.reason);
        return point.state.stiffness.value;
    };
    std::vector<Number> all = known_numbers(joint);
    all.push_back({"pressure", &pressure});
    std::map<std::string, double> slopes;
    for (const Number& number : all) {
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
