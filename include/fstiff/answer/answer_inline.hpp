// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/answer.hpp: inline, or compiled in fstiff::double.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/bands_inline.hpp>
#include <fstiff/answer/curves_inline.hpp>
#include <fstiff/answer/elements_inline.hpp>
#include <fstiff/answer/face_inline.hpp>
#include <fstiff/answer/laws_inline.hpp>
#include <fstiff/answer/maps_inline.hpp>
#include <fstiff/answer/problem_inline.hpp>
#include <fstiff/answer/quick_hybrids_inline.hpp>
#include <fstiff/answer/unknowns_inline.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fstiff::inline v0_1 {

namespace detail {

/// \p value of \p name, which must be above \p low and at most \p high.
FSTIFF_INLINE void require_between(const char* name, const std::optional<double>& value, double low,
                                   double high = (std::numeric_limits<double>::max)()) {
    if (value && !(*value > low && *value <= high))
        parts::refuse(
            name, *value,
            high == (std::numeric_limits<double>::max)()
                ? "finite and greater than " + parts::rounded_text(low, 6)
                : "greater than " + parts::rounded_text(low, 6) + " and at most " + parts::rounded_text(high, 6));
}

FSTIFF_INLINE void require_numbers(const JointFace& of) {
    for (const auto& [name, value] :
         {std::pair("rms_height", of.rms_height), std::pair("mean_height", of.mean_height),
          std::pair("rms_gradient", of.rms_gradient), std::pair("peak_radius", of.peak_radius),
          std::pair("peak_density", of.peak_density)})
        require_between(name, value, 0);
    require_between("alpha", of.alpha, 1.5);
    require_between("hurst", of.hurst, 0, 1);
    require_between("fractal_dimension", of.fractal_dimension, 1, greatest_dimension);
    if (of.rms_height && of.mean_height) throw domain_error("mean_height: must not be given with rms_height");
    if (!of.measured && !of.rms_height && !of.mean_height)
        throw domain_error("rms_height: is missing; a face needs it, mean_height or a measured surface");
    if (of.skewness.has_value() != of.kurtosis.has_value())
        throw domain_error("skewness: must be given with kurtosis, and kurtosis with it");
    require(of.rms_height_error >= 0 && of.rms_gradient_error >= 0, "rms_height_error", of.rms_height_error,
            "not negative, as rms_gradient_error");
}

/// The face of \p of as the contact has it.
FSTIFF_INLINE Face face_of(const JointFace& of) {
    require_numbers(of);
    Face face;
    if (of.measured) face = face_of(of.measured);
    face.process = of.process;
    if (of.rms_height) face.write(Parameter::rms_height, *of.rms_height);
    if (of.mean_height) {
        const parts::PriorRange& ratio = parts::prior_of(face.process).mean_over_rms;
        face.write(Parameter::rms_height, *of.mean_height / ratio.middle);
        face.priors.push_back({parts::Unknown::height, *of.mean_height / ratio.high, *of.mean_height / ratio.low,
                               Origin::mean_height, ratio});
    }
    const auto put = [&](const std::optional<double>& value, std::optional<double> Face::*into) {
        if (value) face.write([&](Face& one) { one.*into = value; });
    };
    put(of.rms_gradient, &Face::rms_gradient), put(of.alpha, &Face::alpha), put(of.hurst, &Face::hurst);
    const bool has_shape = of.skewness.has_value();
    if (of.rms_height || of.mean_height || of.rms_gradient || of.alpha || of.hurst || of.peak_radius ||
        of.peak_density || has_shape)
        face.write([](Face& one) { one.spectrum_of_map = one.spectrum_of_map && !one.map; });
    if (of.peak_radius) face.write(Parameter::peak_radius, *of.peak_radius);
    if (of.peak_density) face.write(Parameter::peak_density, *of.peak_density);
    face.radius_follows = !of.measured && !of.peak_radius;
    face.density_follows = !of.measured && !of.peak_density;
    if (of.fractal_dimension) {
        face.write([](Face& one) { one.parameters.dimension_window_error = 0; });
        face.write(Parameter::fractal_dimension, *of.fractal_dimension);
    }
    if (of.rms_height_error > 0) face.parameters.rms_height.error = of.rms_height_error;
    if (of.rms_gradient_error > 0) face.gradient_error = of.rms_gradient_error;
    if (has_shape) {
        const parts::HeightShape<double> shape{*of.skewness, *of.kurtosis};
        face.write([&](Face& one) { one.set_shape(shape); });
    }
    fill_unknown(face, has_shape);
    return face;
}

FSTIFF_INLINE Problem problem_of(const Joint& joint, const AnswerOptions& options) {
    for (const Body* body : {&joint.upper, &joint.lower}) {
        require_between("yield_strength", body->yield_strength, 0);
        require_between("hardness", body->hardness, 0);
    }
    require_between("nominal_area", joint.nominal_area, 0);
    require_between("gamma", options.gamma, 0, 1);
    require(options.grid >= 16 && options.grid <= 4096, "grid", options.grid, "from 16 to 4096");
    require(joint.shifts >= 1 && joint.shifts <= 1000, "shifts", joint.shifts, "from 1 to 1000");
    Problem problem;
    problem.face = face_of(joint.face);
    if (joint.other) {
        problem.faces = {problem.face, face_of(*joint.other)};
        problem.face = sum_of_faces(problem.faces[0], problem.faces[1], joint.shifts, AnswerOptions().seed);
    }
    take_bodies(joint.upper, joint.lower, problem);
    problem.nominal_area = joint.nominal_area;
    problem.law_options.gamma = options.gamma;
    problem.law_options.points = options.grid;
    problem.law_options.edges = options.edges;
    if (problem.face.has_peaks()) {
        problem.peaks = {{*problem.face.value(Parameter::theta), problem.face.value(Parameter::r), true, {}, ""}};
    } else {
        for (const double theta : {std::numbers::pi / 4, std::numbers::pi / 3})
            problem.peaks.push_back({.theta = theta});
        problem.default_peaks = true;
    }
    return problem;
}

/// \p lack as the reason of \p law.
FSTIFF_INLINE std::string reason_of(Lack lack) {
    switch (lack) {
        case Lack::nothing: break;
        case Lack::separation: return "gives no separation";
        case Lack::peaks: return "needs peak_radius and peak_density, which are not known";
        case Lack::map: return "needs a measured map";
        case Lack::sum_of_maps: return "needs two measured maps of one grid";
        case Lack::summits: return "needs summits: no point of the map is above its eight neighbours";
        case Lack::points: return "needs a map without missing points";
        case Lack::side: return "needs a map of at least 16 points a side";
        case Lack::small_map: return "needs a map of at least 4 points a side";
        case Lack::moments: return "needs a spectrum: rms_gradient and alpha, or peak_radius and peak_density";
        case Lack::range: return "needs moments in the range of double precision";
        case Lack::alpha: return "needs an alpha above 1.5, which rms_height, peak_radius and peak_density must make";
        case Lack::hardness: return "needs hardness or yield_strength of a body";
        case Lack::yield_strength: return "needs yield_strength of a body";
    }
    return "";
}

FSTIFF_INLINE std::string reason_of(const MissedPoint& missed) {
    switch (missed.why) {
        case Miss::law: return missed.reason;
        case Miss::range: return "a result is beyond the range of double precision";
        case Miss::hardness:
            return "at the hardness, " + parts::rounded_text(missed.limit, 3) +
                   " Pa, and above it everything has flowed";
        case Miss::closed: return "above " + parts::rounded_text(missed.limit, 3) + " Pa the contact is closed";
    }
    return "";
}

FSTIFF_INLINE std::vector<AssumedNumber> assumed_of(const Problem& problem, const Law& law) {
    std::vector<AssumedNumber> all;
    if (problem.face.map && problem.face.spectrum_of_map) return all;
    const std::vector<const Face*> faces = rough_faces(problem);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const Prior& one : faces[i]->priors)
            if (one.origin != Origin::measurement && is_felt(problem, {&law}, *faces[i], one.which))
                all.push_back({one.which, {one.range.low, one.range.middle, one.range.high}, i > 0});
    return all;
}

}  // namespace detail

FSTIFF_INLINE Answer answer(const Joint& joint, std::span<const double> pressures, const AnswerOptions& options) {
    for (const double p : pressures) require_positive("pressure", p);
    require_positive("seating", options.seating);
    require(options.samples == 0 || (options.samples >= 20 && options.samples <= 100000), "samples", options.samples,
            "0, or from 20 to 100000");
    const detail::Problem problem = detail::problem_of(joint, options);
    detail::Request request{.points = {pressures.begin(), pressures.end()},
                            .approach = true,
                            .seating = options.seating,
                            .samples = options.samples,
                            .seed = options.seed,
                            .solves_map = options.solve_map,
                            .checked = false};
    for (std::size_t i = 0; i < pressures.size(); ++i) request.answered.push_back(i);
    Answer found;
    if (pressures.empty()) return found;
    const detail::Curves curves = curves_of(problem, request, options.progress);
    const detail::LawCurve& curve = *curves.answer;
    found.points.resize(pressures.size());
    for (const detail::MissedPoint& missed : curve.missed)
        found.points[missed.place] = {.pressure = pressures[missed.place], .reason = reason_of(missed)};
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const detail::AnswerReason& reason = curves.facts.reasons[i];
        AnswerPoint& point = found.points[curve.places[i]];
        point = {.pressure = pressures[curve.places[i]],
                 .stiffness = {curve.band[i].low, curve.states[i].stiffness.value, curve.band[i].high},
                 .law = curve.law_at(i).which,
                 .causes = reason.causes,
                 .p_star = reason.p_star,
                 .contacts = reason.contacts,
                 .loading_stiffness = reason.loading_stiffness};
        if (!curve.seated.empty() && curve.has_separation(i))
            point.approach = curve.seated[i] - curve.states[i].separation.value;
    }
    found.flows = curves.facts.flows;
    found.of_map_itself = curves.facts.of_map_itself;
    found.relative_hardness = curves.facts.relative_hardness;
    found.assumed = detail::assumed_of(problem, *curve.law);
    return found;
}

FSTIFF_INLINE std::shared_ptr<const AnyContact> contact_of(const Joint& joint, LawName law,
                                                           const AnswerOptions& options) {
    struct Kept {
        detail::Problem problem;
        std::unique_ptr<AnyContact> contact;
    };
    const auto kept = std::make_shared<Kept>(Kept{detail::problem_of(joint, options), nullptr});
    const detail::Law& one = detail::find_law(law);
    const std::string name = "law " + std::string(one.name) + ": ";
    if (one.needs_dimension && !kept->problem.face.dimension()) throw domain_error(name + "needs fractal_dimension");
    if (const detail::Lack lack = lack_of(one, kept->problem); lack != detail::Lack::nothing)
        throw domain_error(name + detail::reason_of(lack));
    for_each_contact(kept->problem, {&one}, options.progress, [&](const detail::ContactOfLaw& of) {
        if (!kept->contact) kept->contact = of.make();
    });
    return {kept, kept->contact.get()};
}

}  // namespace fstiff::inline v0_1
