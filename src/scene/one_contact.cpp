// SPDX-License-Identifier: BSD-3-Clause
#include "scene/one_contact.hpp"

#include "scene/each_contact.hpp"
#include "document/file.hpp"

#include <fstiff/measured/uncertain_sum.hpp>

#include <optional>
#include <utility>

namespace fstiff::scene {
namespace {

[[noreturn]] void refuse_entry(const char* name, std::size_t value, const char* allowed) {
    throw no_such_entry(std::string(name) + " = " + std::to_string(value) + ": must be " + allowed);
}

OneContact contact_of(Scene of, double modulus, std::size_t law, std::size_t peaks, const ProgressHook& progress) {
    OneContact one;
    one.scene = std::make_shared<const Scene>(std::move(of));
    const Scene& kept = *one.scene;
    if (law >= kept.laws.size()) refuse_entry("law", law, "an entry of contact.laws");
    std::size_t wanted = peaks;
    for (std::size_t i = 0; i <= law; ++i) {
        const Law& one_law = *kept.laws[i];
        const std::size_t curves = one_law.has_peaks ? peaks_of(one_law, kept).size() : 1;
        if (i < law)
            wanted += curves;
        else if (peaks >= curves)
            refuse_entry("peaks", peaks, "an entry of contact.peaks, 0 without joint peaks");
    }
    for_each_contact(kept, modulus, progress, [&](const Curve& curve, const auto& make) {
        if (wanted-- == 0) one.law = curve.law, one.contact = make();
    });
    return one;
}

/// \p value, without which there is no contact with \p law.
double needed(const std::string& law, const char* name, const std::optional<double>& value) {
    if (!value) throw domain_error("law " + law + ": needs " + name);
    return *value;
}

/// Numbers as a scene with one law.
Scene scene_of(const std::string& law, const ContactNumbers& numbers, const MeasuredSurface* measured) {
    const Law* const found = find_law(law);
    if (!found) {
        const auto names = law_names();
        throw domain_error("law = \"" + law.substr(0, 40) + "\": must be one of " + list_of(names));
    }
    Scene of;
    const auto optional = [](const char* name, double value) {
        if (value == 0) return std::optional<double>();
        require_positive(name, value);
        return std::optional(value);
    };
    if (measured) {
        of.face = face_of(std::make_shared<const MeasuredSurface>(*measured));
    } else {
        numbers.surface.validate();
        of.face.parameters = parts::stated(
            RoughFace<double>{numbers.surface, {}, optional("fractal_dimension", numbers.fractal_dimension)});
        of.face.rms_gradient = optional("rms_gradient", numbers.rms_gradient);
        if (numbers.kurtosis == 0 && numbers.skewness != 0) throw domain_error("skewness: needs kurtosis");
        if (numbers.kurtosis != 0) of.face.set_shape({numbers.skewness, numbers.kurtosis});
    }
    of.yield_strength = optional("yield_strength", numbers.yield_strength);
    of.hardness = optional("hardness", numbers.hardness);
    const double poisson = found->needs_yield ? needed(law, "poisson_ratio", numbers.poisson_ratio)
                                              : numbers.poisson_ratio.value_or(0);
    require(poisson > -1 && poisson <= 0.5, "poisson_ratio", poisson, "greater than -1 and at most 0.5");
    of.softer_poisson = poisson;
    if (measured && found->has_peaks) {
        if (!of.face.has_peaks())
            throw domain_error("law " + law + ": needs r and theta of the surface: " + measured->found.why_no_peaks);
        of.peaks.push_back({.theta = *of.face.value(Parameter::theta), .r = of.face.value(Parameter::r)});
    } else if (!measured && found->has_peaks) {
        const PeakDistribution<double> peaks(needed(law, "r", numbers.r), needed(law, "theta", numbers.theta));
        of.face.write(Parameter::r, peaks.r()), of.face.write(Parameter::theta, peaks.theta());
        of.peaks.push_back({.theta = peaks.theta(), .r = peaks.r()});
    }
    if (found->needs_dimension && !of.face.dimension()) throw domain_error("law " + law + ": needs fractal_dimension");
    if (const std::string why = refusal_of(*found, of); !why.empty()) throw domain_error("law " + law + ": " + why);
    of.reading = numbers.reading;
    of.length = InteractionLength::given;
    of.given_length = numbers.interaction_length;
    of.laws.push_back(found);
    return of;
}

}  // namespace

OneContact contact_of(const std::string& law, const ContactNumbers& numbers, const MeasuredSurface* measured,
                      const ProgressHook& progress) {
    require_positive("effective_modulus", numbers.effective_modulus);
    return contact_of(scene_of(law, numbers, measured), numbers.effective_modulus, 0, 0, progress);
}

OneContact contact_of(Scene of, std::size_t law, std::size_t peaks, const ProgressHook& progress) {
    const double modulus = effective_modulus(of.upper, of.lower);
    return contact_of(std::move(of), modulus, law, peaks, progress);
}

}  // namespace fstiff::scene
