// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint as it is given becomes a ResolvedJoint: what is written counts before what was measured, and that before a
/// prior. Functions of answer/resolve.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/joint_fields.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/resolve.hpp>
#include <fstiff/halfspace/joint_form.hpp>

#include <fstiff/answer/unknowns.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

using Given = std::optional<double>;

/// \throws domain_error where one is out of range, or two are the same number in several ways.
FSTIFF_INLINE void require_numbers(const JointFace& spec) {
    using Errors = JointFace::Errors;
    std::string_view height, gradient;
    each_field(spec, [&](std::string_view name, const Given& value, const NumberFacts& facts) {
        if (!value) return;
        for (const auto& [error, first] : {std::pair(&Errors::height, &height), {&Errors::gradient, &gradient}}) {
            if (facts.error != error) continue;
            if (!first->empty())
                throw domain_error(
                    Refusal{.parameter = name, .reason = "must not be given with " + std::string(*first)});
            *first = name;
        }
        facts.require(name, *value);
    });
    if (!spec.measured && !spec.rms_height && !spec.mean_height)
        throw domain_error(Refusal{.parameter = "rms_height",
                                   .reason = "is missing; a face needs it, mean_height or a measured surface"});
    if (spec.skewness.has_value() != spec.kurtosis.has_value())
        throw domain_error(Refusal{.parameter = spec.skewness ? "kurtosis" : "skewness",
                                   .reason = "is missing; skewness and kurtosis belong together"});
    if (spec.skewness && spec.bearing)
        throw domain_error(Refusal{.parameter = "bearing", .reason = "must not be given with skewness"});
    if (!spec.skewness) return;
    const double least = *spec.skewness * *spec.skewness + 1;  // of any distribution
    require(*spec.kurtosis >= least, "kurtosis", *spec.kurtosis,
            "from skewness^2 + 1, here " + rounded_text(least, 3) + ", to 100");
}

/// \throws domain_error for an error out of range, or of a number that is not there.
FSTIFF_INLINE void require_errors(const JointFace& spec, const Face& face) {
    const auto check = [](std::string_view name, const Given& error, bool known) {
        if (!error) return;
        const std::string what = "error of " + std::string(name);
        if (!known) throw domain_error(Refusal{.parameter = what, .reason = "needs the number"});
        require(*error >= 0 && std::isfinite(*error), what, *error, "finite and not negative");
    };
    check("the height", spec.errors.height, true);
    check("the gradient", spec.errors.gradient,
          spec.rms_gradient || spec.profile_gradient || spec.profile_spacing || (spec.measured && face.rms_gradient));
    each_field(spec, [&](std::string_view name, const Given& value, const NumberFacts& facts) {
        if (facts.row)
            check(name, spec.errors.*facts.error,
                  value.has_value() || (spec.measured && face.parameters.find(facts.row->parameter)));
    });
}

/// A gradient of the range \p range, which is from \p origin.
FSTIFF_INLINE void take_gradient(const PriorRange& range, Origin origin, Face& face) {
    face.write([&](Face& f) {
        f.rms_gradient = range.middle, f.gradient_error = 0;
        f.gradient_growth = origin == Origin::spacing ? growth_of_spacing : 0;
    });
    if (range.low < range.high) face.priors.push_back({Unknown::gradient, range.low, range.high, origin, range});
}

/// The height and the gradient of \p spec, and the errors that they are given.
FSTIFF_INLINE void take_height_and_gradient(const JointFace& spec, Face& face) {
    const ProcessPrior prior = detail::prior_of(face.process, face.worn);
    if (spec.rms_height) face.write(Parameter::rms_height, *spec.rms_height);
    if (spec.mean_height) {
        const PriorRange& ratio = prior.mean_over_rms;
        face.write(Parameter::rms_height, *spec.mean_height / ratio.middle);
        face.priors.push_back({Unknown::height, *spec.mean_height / ratio.high, *spec.mean_height / ratio.low,
                               Origin::mean_height, ratio});
    }
    const PriorRange of_slope = detail::gradient_of_slope(prior);
    const auto times = [](const PriorRange& a, const PriorRange& b) {
        const auto side = [&](double PriorRange::*end) {  // independent factors
            return std::hypot(std::log(a.*end / a.middle), std::log(b.*end / b.middle));
        };
        const double middle = a.middle * b.middle;
        return PriorRange{middle * std::exp(-side(&PriorRange::low)), middle,
                          middle * std::exp(side(&PriorRange::high))};
    };
    if (const Given& slope = spec.rms_gradient) take_gradient({*slope, *slope, *slope}, Origin::slope, face);
    if (const Given& slope = spec.profile_gradient)
        take_gradient(times({*slope, *slope, *slope}, of_slope), Origin::slope, face);
    if (spec.profile_spacing)
        take_gradient(times(slope_of_spacing(face.parameters.rms_height.value, *spec.profile_spacing), of_slope),
                      Origin::spacing, face);
}

/// The errors of \p spec in place of those of \p face.
FSTIFF_INLINE void take_errors(const JointFace& spec, Face& face) {
    require_errors(spec, face);
    each_field(spec, [&](std::string_view, const Given&, const NumberFacts& facts) {
        if (facts.row && spec.errors.*facts.error)
            face.parameters.find(facts.row->parameter)->error = *(spec.errors.*facts.error);
    });
    Measurement<double>& height = face.parameters.rms_height;
    if (spec.errors.height)
        height.error = *spec.errors.height * (height.value / spec.mean_height.value_or(height.value));
    if (spec.errors.gradient)
        face.gradient_error =
            *spec.errors.gradient * (*face.rms_gradient / (spec.profile_gradient  ? *spec.profile_gradient
                                                           : spec.profile_spacing ? *spec.profile_spacing
                                                                                  : *face.rms_gradient));
}

/// The shape of the heights of \p spec: of a bearing curve that belongs to its height.
FSTIFF_INLINE void take_shape(const JointFace& spec, Face& face) {
    if (spec.skewness) {
        const HeightShape<double> shape{*spec.skewness, (std::max)(*spec.kurtosis, least_kurtosis(*spec.skewness))};
        return face.write([&](Face& f) { f.set_shape(shape); });
    }
    if (!spec.bearing) return;
    const double rms_height = face.parameters.rms_height.value;
    const auto [mean, variance, skewness, kurtosis] = detail::normal_moments(*spec.bearing);
    const double rms = std::sqrt(variance);
    if (!(rms > rms_height / 2 && rms < rms_height * 2))  // likely for a unit
        throw domain_error(Refusal{.parameter = "bearing",
                                   .reason = "belongs to an rms height of " + detail::rounded_text(rms, 3) +
                                             " m, and rms_height is " + detail::rounded_text(rms_height, 3) +
                                             " m; both must agree within a factor of 2"});
    const auto of_rms = std::make_shared<const MaterialRatioSlope<double>>(spec.bearing->scaled(1 / rms_height));
    const HeightShape<double> shape = detail::counted_shape(skewness, kurtosis, 1.0);
    face.write([&](Face& f) { f.shape = shape, f.bearing = of_rms; });
}

/// The number of \p spec that a map has itself, so that it cannot be used next to it; empty: none.
FSTIFF_INLINE std::string_view instead_of_map(const JointFace& spec) {
    if (spec.rms_height || spec.mean_height) return "rms_height";
    if (spec.rms_gradient || spec.profile_gradient || spec.profile_spacing) return "rms_gradient";
    return spec.skewness ? "skewness" : spec.bearing ? "a bearing curve" : "";
}

FSTIFF_INLINE Face face_of(const JointFace& spec) {
    require_numbers(spec);
    Face face;
    if (spec.measured) face = spec.measured->face();
    face.process = spec.process, face.worn = spec.worn, face.whole = spec.whole;
    take_height_and_gradient(spec, face);
    const auto put = [&](const Given& value, Given Face::*into) {
        if (value) face.write([&](Face& f) { f.*into = value; });
    };
    put(spec.alpha, &Face::alpha), put(spec.hurst, &Face::hurst);
    const bool has_shape = spec.skewness || spec.bearing;
    if (const std::string_view number = instead_of_map(spec); face.map && !number.empty())
        face.write([&](Face& f) { f.spectrum_of_map = false, f.instead_of_map = number; });
    if (spec.fractal_dimension) face.write([](Face& f) { f.parameters.dimension_window_error = 0; });
    each_field(spec, [&](std::string_view, const Given& value, const NumberFacts& facts) {
        if (facts.row && value) face.write(facts.row->parameter, *value);
    });
    face.radius_follows = !spec.measured && !spec.peak_radius;
    face.density_follows = !spec.measured && !spec.peak_density;
    take_errors(spec, face);
    if (spec.max_peak_height) face.write([&](Face& f) { f.parameters.max_peak_height = {*spec.max_peak_height, 0}; });
    if (spec.fractal_roughness)
        face.write([&](Face& f) { f.parameters.fractal_roughness = {*spec.fractal_roughness, 0}; });
    if (face.parameters.r.has_value() != face.parameters.theta.has_value())
        throw domain_error(Refusal{.parameter = face.parameters.r ? "theta" : "r",
                                   .reason = "is missing; r and theta belong together"});
    take_shape(spec, face);
    if (spec.peak_heights) face.write([&](Face& f) { f.peak_heights = spec.peak_heights; });
    fill_unknown(face, has_shape);
    for (const auto& [follows, name, value] :
         {std::tuple(face.radius_follows, "peak_radius", face.parameters.peak_radius.value),
          std::tuple(face.density_follows, "peak_density", face.parameters.peak_density.value)})
        if (follows && !(value > 0 && std::isfinite(value)))  // 0 counts as not known
            throw domain_error(Refusal{.parameter = spec.alpha ? "alpha" : "rms_height",
                                       .reason = "makes, with rms_height and rms_gradient, " + std::string(name) +
                                                 " = " + detail::rounded_text(value, 6) +
                                                 ", which must be finite and greater than 0"});
    return face;
}

FSTIFF_INLINE void take_peaks(ResolvedJoint& problem) {
    if (problem.face.has_peaks()) {
        problem.peaks = {{*problem.face.value(Parameter::theta), problem.face.value(Parameter::r), true, {}, ""}};
        return;
    }
    for (const double theta : {std::numbers::pi / 4, std::numbers::pi / 3}) problem.peaks.push_back({.theta = theta});
    problem.default_peaks = true;
}

/// Requires every number of \p owner to be in its range.
template <class Owner>
void require_fields(const Owner& owner) {
    each_field(owner,
               [](std::string_view name, const auto& value, const NumberFacts& facts) { facts.require(name, value); });
}

FSTIFF_INLINE void require_surroundings(const Joint& joint) {
    if (joint.waves) {
        require_fields(*joint.waves);
        require_fields(joint.waves->longitudinal);
        if (joint.waves->shear) require_fields(*joint.waves->shear);
    }
    require_fields(joint.conduction);
    if (joint.conduction.gap) require_fields(*joint.conduction.gap);
    if (joint.friction) require_fields(*joint.friction);
}

/// \throws domain_error where the ring, the flatness and the form do not go together.
FSTIFF_INLINE void require_form(const Joint& joint) {
    const auto refuse = [](std::string_view parameter, const char* reason) {
        throw domain_error(Refusal{.parameter = parameter, .reason = reason});
    };
    if (joint.ring && !(joint.ring->inner >= 0 && joint.ring->outer > joint.ring->inner))
        refuse("ring", "must have 0 <= inner < outer");
    if (joint.flatness && joint.form) refuse("flatness", "must not be given with form");
    if (joint.aspect_ratio && (joint.ring || joint.form))
        refuse("aspect_ratio",
               joint.ring ? "must not be given with a ring" : "must not be given with form, which has its own");
    if (joint.aspect_ratio && !joint.nominal_area) refuse("aspect_ratio", "needs nominal_area, of which it is");
    if ((joint.flatness || joint.form) && !joint.nominal_area)
        refuse(joint.form ? "form" : "flatness", "needs nominal_area, over which it is measured");
}

/// The form of \p joint; null where it has none, or none of a height.
FSTIFF_INLINE std::shared_ptr<const JointForm> form_of(const Joint& joint) {
    if (joint.form || joint.flatness.value_or(0) == 0) return joint.form;
    const double ratio = joint.aspect_ratio.value_or(1);
    return std::make_shared<const JointForm>(
        joint.ring ? JointForm::ring(joint.ring->inner / 2, joint.ring->outer / 2, *joint.flatness)
                   : JointForm::crown(std::sqrt(*joint.nominal_area * ratio), std::sqrt(*joint.nominal_area / ratio),
                                      *joint.flatness));
}

/// Returns \p call(); its errors name the parameter as a member of \p part.
template <class Call>
auto of_part(const std::string& part, const Call& call) {
    try {
        return call();
    } catch (const domain_error& error) {
        throw error.parameter().empty() ? error : error.with_parameter(part + "." + std::string(error.parameter()));
    }
}

/// \throws domain_error naming the member of \p body; where not \p elastic, its modulus does not count, and Poisson's
/// ratio may be NaN: not known.
FSTIFF_INLINE void require_body(const Body& body, bool elastic) {
    if (elastic) (void)effective_modulus(body.elastic, body.elastic);
    each_field(body, [&](std::string_view name, const auto& value, const NumberFacts& facts) {
        if (!elastic && name == "youngs_modulus") return;
        if (!elastic && name == "poisson_ratio" && std::isnan(body.elastic.poisson_ratio)) return;
        facts.require(name, value);
    });
    if (const auto& range = body.hardness_range)
        require(range->low > 0 && range->low <= range->middle && range->middle <= range->high, "hardness_range",
                range->middle, "between its ends, which are above 0");
}

/// Gives \p conduction the conductivities of both bodies where it has none.
FSTIFF_INLINE void take_conductivities(const Body& upper, const Body& lower, Conduction& conduction) {
    const auto take = [](const Given& a, const Given& b, Given& of_both) {
        if (!of_both && a && b) of_both = joint_conductivity(*a, *b);
    };
    take(upper.thermal_conductivity, lower.thermal_conductivity, conduction.thermal);
    take(upper.electrical_conductivity, lower.electrical_conductivity, conduction.electrical);
}

/// What the ranges of the conductivities of both bodies make of that of the joint, in logarithms.
FSTIFF_INLINE CauseSpread<double> spread_of_heat(const Body& upper, const Body& lower) {
    CauseSpread<double> spread;
    if (!upper.thermal_conductivity || !lower.thermal_conductivity) return spread;
    const double a = *upper.thermal_conductivity, b = *lower.thermal_conductivity, both = joint_conductivity(a, b);
    const auto add = [&](const Body& body, double other) {
        if (!body.thermal_range || body.thermal_range->middle != *body.thermal_conductivity) return;
        spread.low = -std::hypot(spread.low, std::log(joint_conductivity(body.thermal_range->low, other) / both));
        spread.high = std::hypot(spread.high, std::log(joint_conductivity(body.thermal_range->high, other) / both));
    };
    add(upper, b), add(lower, a);
    return spread;
}

/// The waves of \p joint, with the impedances of the bodies where none are given.
FSTIFF_INLINE UltrasonicWaves waves_of(const Joint& joint) {
    UltrasonicWaves waves = *joint.waves;
    const auto of_bodies = [&](Given Body::*velocity) -> std::optional<Impedances<double>> {
        const auto &upper = joint.upper, &lower = joint.lower;
        if (!upper.density || !lower.density || !(upper.*velocity) || !(lower.*velocity)) return std::nullopt;
        return Impedances<double>{acoustic_impedance(*upper.density, *(upper.*velocity)),
                                  acoustic_impedance(*lower.density, *(lower.*velocity))};
    };
    auto& [incident, beyond] = waves.longitudinal;
    if (incident == 0 && beyond == 0) {
        const auto own = of_bodies(&Body::velocity);
        if (!own)
            throw domain_error(Refusal{.parameter = "waves.longitudinal",
                                       .reason = "is missing; give it, or density and velocity of both bodies"});
        waves.longitudinal = *own;
        if (!waves.shear) waves.shear = of_bodies(&Body::shear_velocity);
    }
    for (const double z : {incident, beyond}) require_positive("impedance", z);
    return waves;
}

FSTIFF_INLINE ResolvedJoint problem_of(const Joint& joint, const LawOptions& options) {
    std::vector<Face> faces;
    Face face = face_of(joint.face);
    require(joint.shifts >= 1 && joint.shifts <= 1000, "shifts", joint.shifts, "from 1 to 1000");
    if (joint.other) {
        faces = {std::move(face), of_part("other", [&] { return face_of(*joint.other); })};
        face = sum_of_faces(faces[0], faces[1], joint.shifts, Request().seed);
    }
    ResolvedJoint problem = with_faces(joint, std::move(face), std::move(faces), options);
    take_peaks(problem);
    return problem;
}

FSTIFF_INLINE ResolvedJoint with_faces(const Joint& joint, Face face, std::vector<Face> faces,
                                       const LawOptions& options) {
    of_part("upper", [&] { require_body(joint.upper, !joint.effective_modulus); });
    of_part("lower", [&] { require_body(joint.lower, !joint.effective_modulus); });
    require_fields(joint);
    require(options.gamma > 0 && options.gamma <= 1, "gamma", options.gamma, "greater than 0 and at most 1");
    require(options.points >= 16 && options.points <= 4096, "grid", options.points, "from 16 to 4096");
    if (joint.interaction_length == Joint::InteractionLength::given) joint.interaction.validate();
    if (joint.interaction.reading != InteractionReading::none &&
        joint.interaction_length == Joint::InteractionLength::nominal && !joint.nominal_area)
        throw domain_error(Refusal{.parameter = "interaction_length", .reason = "needs nominal_area"});
    require_surroundings(joint);
    require_form(joint);
    ResolvedJoint problem;
    problem.face = std::move(face), problem.faces = std::move(faces);
    take_bodies(joint.upper, joint.lower, joint.effective_modulus, problem);
    problem.nominal_area = joint.nominal_area, problem.ring = joint.ring;
    problem.flatness = joint.flatness, problem.form = form_of(joint);
    problem.greatest_pressure = joint.greatest_pressure;
    problem.law_options = options;
    problem.reading = joint.interaction.reading;
    problem.length = joint.interaction_length;
    problem.given_length = joint.interaction.length;
    if (joint.waves) problem.ultrasound = waves_of(joint);
    problem.conduction = joint.conduction;
    if (!joint.conduction.thermal) problem.heat = spread_of_heat(joint.upper, joint.lower);
    take_conductivities(joint.upper, joint.lower, problem.conduction);
    problem.friction = joint.friction;
    return problem;
}

}}}  // namespace fstiff::detail
