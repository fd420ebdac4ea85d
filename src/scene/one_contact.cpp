// SPDX-License-Identifier: BSD-3-Clause
#include "scene/one_contact.hpp"

#include "document/file.hpp"

#include <fstiff/measured/uncertain_sum.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace fstiff::scene {
namespace {

[[noreturn]] void refuse_entry(const char* name, std::size_t value, const char* allowed) {
    throw no_such_entry(std::string(name) + " = " + std::to_string(value) + ": must be " + allowed);
}

/// \p value, without which there is no contact with \p law.
double needed(const std::string& law, const char* name, const std::optional<double>& value) {
    if (!value) throw domain_error("law " + law + ": needs " + name);
    return *value;
}

/// A number that is positive, or 0 where it is not known.
std::optional<double> optional(const char* name, double value) {
    if (value == 0) return {};
    require_positive(name, value);
    return value;
}

/// The face of \p numbers, to which a spectrum of \p law adds as in a scene what follows from the gradient.
Face face_of_numbers(const Law& law, const ContactNumbers& numbers) {
    Face face;
    Roughness<double> surface = numbers.surface;
    face.rms_gradient = optional("rms_gradient", numbers.rms_gradient);
    face.radius_follows = law.needs_spectrum && face.rms_gradient && surface.peak_radius == 0;
    face.density_follows = law.needs_spectrum && face.rms_gradient && surface.peak_density == 0;
    if (face.radius_follows) surface.peak_radius = 1;  // until fill_unknown()
    if (face.density_follows) surface.peak_density = 1;
    surface.validate();
    face.parameters =
        parts::stated(RoughFace<double>{surface, {}, optional("fractal_dimension", numbers.fractal_dimension)});
    if (numbers.kurtosis == 0 && numbers.skewness != 0) throw domain_error("skewness: needs kurtosis");
    if (numbers.kurtosis != 0) face.set_shape({numbers.skewness, numbers.kurtosis});
    if (face.radius_follows || face.density_follows) fill_unknown(face, numbers.kurtosis != 0);
    return face;
}

/// The joint of \p numbers for \p law; its surface is \p measured where that is given.
Problem problem_of(const Law& law, const ContactNumbers& numbers, const MeasuredSurface* measured) {
    const std::string name(law.name);
    Problem of;
    of.effective_modulus = numbers.effective_modulus;
    of.face =
        measured ? face_of(std::make_shared<const Surface<double>>(measured->found)) : face_of_numbers(law, numbers);
    of.yield_strength = optional("yield_strength", numbers.yield_strength);
    of.hardness = optional("hardness", numbers.hardness);
    const double poisson =
        law.needs_yield ? needed(name, "poisson_ratio", numbers.poisson_ratio) : numbers.poisson_ratio.value_or(0);
    require(poisson > -1 && poisson <= 0.5, "poisson_ratio", poisson, "greater than -1 and at most 0.5");
    of.softer_poisson = poisson;
    if (measured && law.has_peaks) {
        if (!of.face.has_peaks())
            throw domain_error("law " + name + ": needs r and theta of the surface: " + measured->found.why_no_peaks);
        of.peaks.push_back({.theta = *of.face.value(Parameter::theta), .r = of.face.value(Parameter::r)});
    } else if (!measured && law.has_peaks) {
        const PeakDistribution<double> peaks(needed(name, "r", numbers.r), needed(name, "theta", numbers.theta));
        of.face.write(Parameter::r, peaks.r()), of.face.write(Parameter::theta, peaks.theta());
        of.peaks.push_back({.theta = peaks.theta(), .r = peaks.r()});
    }
    if (law.needs_dimension && !of.face.dimension()) throw domain_error("law " + name + ": needs fractal_dimension");
    Scene words;  // for a refusal
    static_cast<Problem&>(words) = of;
    if (const std::string why = refusal_of(law, words); !why.empty()) throw domain_error("law " + name + ": " + why);
    of.reading = numbers.reading;
    of.length = InteractionLength::given;
    of.given_length = numbers.interaction_length;
    return of;
}

OneContact only_contact(std::shared_ptr<const Problem> problem, const Law& law, std::size_t peaks,
                        const ProgressHook& progress) {
    OneContact one{.problem = std::move(problem), .law = &law};
    for_each_contact(*one.problem, {&law}, progress, [&](const ContactOfLaw& of) {
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

/// The numbers that are known.
std::vector<Number> known_numbers(ContactNumbers& of) {
    constexpr double most = std::numeric_limits<double>::infinity();
    std::vector<Number> all{{"rms_height", &of.surface.rms_height},
                            {"peak_radius", &of.surface.peak_radius},
                            {"peak_density", &of.surface.peak_density},
                            {"max_peak_height", &of.surface.max_peak_height},
                            {"fractal_dimension", &of.fractal_dimension, 1, 2},
                            {"rms_gradient", &of.rms_gradient},
                            {"skewness", &of.skewness, -most},
                            {"kurtosis", &of.kurtosis, 1},
                            {"effective_modulus", &of.effective_modulus},
                            {"yield_strength", &of.yield_strength},
                            {"hardness", &of.hardness},
                            {"interaction_length", &of.interaction_length}};
    std::erase_if(all, [](const Number& one) { return *one.value == 0; });
    if (of.r) all.push_back({"r", &*of.r, 0, 1});
    if (of.theta) all.push_back({"theta", &*of.theta, 0, std::numbers::pi / 2});
    if (of.poisson_ratio) all.push_back({"poisson_ratio", &*of.poisson_ratio, -1, 0.5});
    return all;
}

/// df/dx where \p x lies in \p of: central, and forward from the lower end.
template <class F>
double difference(const Number& of, double x, const F& f) {
    if (x <= of.low) {
        const double h = 1e-3;
        return (-137 * f(x) + 300 * f(x + h) - 300 * f(x + 2 * h) + 200 * f(x + 3 * h) - 75 * f(x + 4 * h) +
                12 * f(x + 5 * h)) /
               (60 * h);
    }
    const double scale = x == 0 ? 1 : std::abs(x), h = 2e-3 * std::min({scale, x - of.low, of.high - x});
    return (45 * (f(x + h) - f(x - h)) - 9 * (f(x + 2 * h) - f(x - 2 * h)) + (f(x + 3 * h) - f(x - 3 * h))) / (60 * h);
}

}  // namespace

OneContact contact_of(const std::string& law, const ContactNumbers& numbers, const MeasuredSurface* measured,
                      const ProgressHook& progress) {
    require_positive("effective_modulus", numbers.effective_modulus);
    const Law* const found = find_law(law);
    if (!found) {
        const auto names = law_names();
        throw domain_error("law = \"" + law.substr(0, 40) + "\": must be one of " + list_of(names));
    }
    return only_contact(std::make_shared<const Problem>(problem_of(*found, numbers, measured)), *found, 0, progress);
}

OneContact contact_of(const Scene& of, std::size_t law, std::size_t peaks, const ProgressHook& progress) {
    if (law >= of.laws.size()) refuse_entry("law", law, "an entry of contact.laws");
    const Law& one = *of.laws[law];
    if (peaks >= (one.has_peaks ? peaks_of(one, of).size() : 1))
        refuse_entry("peaks", peaks, "an entry of contact.peaks, 0 without joint peaks");
    return only_contact(std::make_shared<const Problem>(of), one, peaks, progress);
}

std::map<std::string, double> sensitivity_of(const std::string& law, ContactNumbers numbers, double pressure) {
    require_positive("pressure", pressure);
    const auto stiffness = [&] {
        const OneContact one = contact_of(law, numbers);
        const auto point = one.contact->at_pressures(std::span(&pressure, 1), Quantity::stiffness).front();
        if (!point.ok()) throw domain_error("pressure: " + point.reason);
        return point.state.stiffness.value;
    };
    std::vector<Number> all = known_numbers(numbers);
    all.push_back({"pressure", &pressure});
    std::map<std::string, double> slopes;
    for (const Number& one : all) {
        const double x = *one.value;
        slopes[one.name] = difference(one, x, [&](double changed) {
            *one.value = changed;
            return stiffness();
        });
        *one.value = x;
    }
    return slopes;
}

}  // namespace fstiff::scene
