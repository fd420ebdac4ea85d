// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/resolved_joint.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/asperity/hardness.hpp>
#include <fstiff/asperity/plastic_laws.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff { inline namespace v0_1 { namespace detail {

FSTIFF_INLINE PeakDistribution<double> peak_density(const Peaks& peaks) {
    try {
        return peaks.r ? PeakDistribution<double>(*peaks.r, peaks.theta)
                       : PeakDistribution<double>::exponential(peaks.theta);
    } catch (const domain_error& error) {
        throw error.with_parameter(peaks.key + std::string(error.parameter())).with_place(peaks.where);
    }
}

FSTIFF_INLINE std::vector<const Face*> rough_faces(const ResolvedJoint& problem) {
    if (problem.faces.empty()) return {&problem.face};
    return {&problem.faces[0], &problem.faces[1]};
}

FSTIFF_INLINE std::vector<const Face*> measured_faces(const ResolvedJoint& problem) {
    std::vector<const Face*> faces = rough_faces(problem);
    std::erase_if(faces, [](const Face* face) { return !face->measured; });
    return faces;
}

FSTIFF_INLINE bool is_of_traces(const ResolvedJoint& problem) {
    const std::vector<const Face*> faces = measured_faces(problem);
    return !faces.empty() &&
           std::all_of(faces.begin(), faces.end(), [](const Face* face) { return face->measured->is_profile; });
}

FSTIFF_INLINE bool has_lay(const ResolvedJoint& problem) {
    const std::vector<const Face*> measured = measured_faces(problem);
    return std::any_of(measured.begin(), measured.end(),
                       [](const Face* face) { return detail::is_profile_with_lay(*face->measured); });
}

FSTIFF_INLINE std::optional<double> gradient(const ResolvedJoint& problem) {
    const Face& face = problem.face;
    if (face.map && face.spectrum_of_map && face.map->spectra)
        return face.map->height_factor * face.map->spectra->shells(problem.law_options.edges).rms_gradient();
    if (face.has_own_gradient()) return face.rms_gradient;
    if (face.has_peaks())
        if (const auto of_own = detail::rms_gradient(
                face.roughness(), PeakDistribution(face.parameters.r->value, face.parameters.theta->value)))
            return of_own;
    if (face.rms_gradient) return face.rms_gradient;
    if (lack_of_spectrum(face) == Lack::nothing) return std::sqrt(2 * spectral_moments(face).m2);
    std::optional<double> of_peaks;
    for (const Peaks& peaks : problem.peaks)
        if (const auto gradient = detail::rms_gradient(face.roughness(), peak_density(peaks))) of_peaks = gradient;
    return of_peaks;
}

FSTIFF_INLINE Interaction<double> interaction(const ResolvedJoint& problem) {
    Interaction<double> result;
    result.reading = problem.reading;
    if (result.reading != InteractionReading::none)
        result.length = problem.length == Joint::InteractionLength::nominal
                            ? detail::interaction_length_of_area(*problem.nominal_area)
                        : problem.length == Joint::InteractionLength::peak_spacing
                            ? detail::interaction_length_of_peaks(problem.face.parameters.peak_density.value)
                            : problem.given_length;
    return result;
}

/// The hardness of \p body [Pa]: given, by Tabor's factor 2.8 (1951), or its range.
FSTIFF_INLINE PriorRange hardness_of(const Body& body) {
    const auto known = [](double value) { return PriorRange{value, value, value}; };
    if (body.hardness) return known(*body.hardness);
    if (body.yield_strength) return known(detail::hardness_over_yield_strength<double> * *body.yield_strength);
    return body.hardness_range.value_or(detail::hardness_of_elastic(body.elastic));
}
/// Of the bodies of one material it is one number.
FSTIFF_INLINE PriorRange softer_hardness(const Body& upper, const Body& lower) {
    const auto a = hardness_of(upper), b = hardness_of(lower);
    const bool same = a.low == b.low && a.middle == b.middle && a.high == b.high;
    return same ? a : detail::softer(a, b);
}

/// The hardness of the joint, \p range, whose softer body is \p softer.
FSTIFF_INLINE void take_hardness(const Body& softer, const PriorRange& range, ResolvedJoint& problem) {
    problem.hardness = softer.hardness, problem.hardness_range.reset();
    if (range.low < range.high)
        problem.hardness.reset(), problem.hardness_range = range;
    else if (!std::isfinite(range.middle))
        problem.hardness = range.middle;
}

FSTIFF_INLINE void take_bodies(const Body& upper, const Body& lower, const std::optional<double>& modulus,
                               ResolvedJoint& problem) {
    if (modulus) {
        Body of_contact = upper;  // two bodies of one metal
        of_contact.elastic = {2 * (1 - 0.3 * 0.3) * *modulus, 0.3};
        problem.effective_modulus = *modulus;
        problem.softer_poisson = upper.elastic.poisson_ratio;
        problem.yield_strength = upper.yield_strength;
        return take_hardness(upper, hardness_of(of_contact), problem);
    }
    problem.effective_modulus = effective_modulus(upper.elastic, lower.elastic);
    problem.upper = upper.elastic, problem.lower = lower.elastic;
    const Body& softer = hardness_of(lower).middle < hardness_of(upper).middle ? lower : upper;
    problem.softer_poisson = softer.elastic.poisson_ratio;
    take_hardness(softer, softer_hardness(upper, lower), problem);
    for (const Body* body : {&upper, &lower})
        if (body->yield_strength)
            problem.yield_strength =
                (std::min)(problem.yield_strength.value_or(*body->yield_strength), *body->yield_strength);
}

FSTIFF_INLINE double hardness_of(const ResolvedJoint& problem) {
    if (problem.hardness_range) return problem.hardness_range->middle;
    return problem.hardness.value_or(detail::hardness_over_yield_strength<double> * problem.yield_strength.value_or(0));
}

FSTIFF_INLINE double hardness_of_material(const ResolvedJoint& problem) {
    const double hardness = problem.hardness_range ? problem.hardness_range->middle : problem.hardness.value_or(0);
    return std::isfinite(hardness) ? hardness : 0;
}

FSTIFF_INLINE std::optional<double> relative_hardness(const ResolvedJoint& problem) {
    const std::optional<double> g = gradient(problem);
    if (!g) return std::nullopt;
    const double relative = hardness_of(problem) / (problem.effective_modulus * *g);
    return relative > 0 && std::isfinite(relative) ? std::optional(relative) : std::nullopt;
}

FSTIFF_INLINE bool flows(const ResolvedJoint& problem, const Law& law) {
    return law.needs_hardness || law.needs_yield || (law.needs_whole_map && problem.law_options.hardness > 0);
}

}}}  // namespace fstiff::detail
