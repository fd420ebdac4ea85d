// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/concerns.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/measure/long_waves.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

FSTIFF_INLINE std::vector<Parameter> unknown_parameters(const ResolvedJoint& problem, bool of_answer) {
    const auto measured = measured_faces(problem);
    std::vector<Parameter> parameters =  // of a sum: what is unknown of one face may not matter next to the other
        problem.face.measured ? detail::unknown_parameters(*problem.face.measured, problem.face.parameters)
                              : detail::unknown_parameters(problem.face.parameters);
    if (parameters.empty() && problem.faces.size() == 2)
        for (const Face* face : measured) {
            const double share = face->parameters.rms_height.value / problem.face.parameters.rms_height.value;
            const auto own = detail::unknown_parameters(*face->measured, face->parameters);
            if (2 * share * share > 1 && std::count(own.begin(), own.end(), Parameter::rms_height) > 0)
                parameters = {Parameter::rms_height};
        }
    if (of_answer) std::erase_if(parameters, [](Parameter parameter) { return parameter != Parameter::rms_height; });
    if (const auto& gradient = problem.face.rms_gradient; gradient && problem.face.gradient_error > *gradient / 2)
        parameters.push_back(Parameter::rms_gradient);
    return parameters;
}

FSTIFF_INLINE std::vector<Check<double>> unlikely_units(const ResolvedJoint& problem,
                                                        std::span<const double> pressures) {
    std::vector<Check<double>> checks;
    double height = 0, modulus = problem.effective_modulus;
    for (const Face* face : rough_faces(problem)) height = (std::max)(height, face->parameters.rms_height.value);
    if (problem.upper.youngs_modulus > 0)
        modulus = (std::min)(problem.upper.youngs_modulus, problem.lower.youngs_modulus);
    if (constexpr double limit = detail::max_plausible_height<double>; height > limit)
        checks.push_back(detail::surface_check(Concern::height_unit, height, limit, false));
    if (constexpr double limit = detail::min_plausible_modulus<double>; modulus < limit)
        checks.push_back(detail::surface_check(Concern::modulus_unit, modulus, limit, false));
    Check<double> low{.concern = Concern::pressure_unit,
                      .limit = detail::min_plausible_pressure<double> * problem.effective_modulus};
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        if (!(pressures[i] < low.limit)) continue;
        low.least = (std::min)(low.least, pressures[i]), low.greatest = (std::max)(low.greatest, pressures[i]);
        if (low.violations++ == 0) low.first = i;
    }
    if (!low.holds()) checks.push_back(low);
    return checks;
}

FSTIFF_INLINE std::string sentence_of_unit(const Check<double>& check) {
    const auto text = [](double value) { return detail::rounded_text(value, 3); };
    const std::string value = text(check.least), wrong = ": a unit is likely wrong";
    switch (check.concern) {
        case Concern::height_unit: return "rms height " + value + " m is above 1 mm" + wrong;
        case Concern::modulus_unit: return "modulus " + value + " Pa is below 1 kPa" + wrong;
        case Concern::pressure_unit:
            return "pressure " + value + " Pa is below 1e-9 of the effective modulus, " + text(check.limit) + " Pa" +
                   wrong;
        default: return "";
    }
}

FSTIFF_INLINE bool makes_doubtful(const Check<double>& check, std::size_t points) {
    switch (check.concern) {
        case Concern::missing_points:
        case Concern::noise: return false;
        case Concern::pressure_unit: return check.violations == points;  // a curve may begin at a light load
        default: return true;
    }
}

FSTIFF_INLINE std::optional<Check<double>> beyond_comparison(const ResolvedJoint& problem, const LawCurve& curve) {
    Check<double> check{.concern = Concern::beyond_comparison,
                        .limit = detail::max_compared_flow * hardness_of(problem)};
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const double pressure = curve.states[i].pressure.value;
        if (curve.law_at(i).which != LawKind::plastic || !(pressure > check.limit)) continue;
        check.least = (std::min)(check.least, pressure), check.greatest = (std::max)(check.greatest, pressure);
        if (check.violations++ == 0) check.first = i;
    }
    return check.holds() ? std::nullopt : std::optional(check);
}

FSTIFF_INLINE std::optional<ImplausibleGradient> implausible_gradient(const ResolvedJoint& problem, const Face& face) {
    double r = 0;  // the greatest, 1/2 where none is written
    for (const Peaks& peaks : problem.peaks) r = (std::max)(r, peaks.r.value_or(0.5));
    return implausible_gradient(face, r);
}

FSTIFF_INLINE std::vector<Check<double>> concerns_of(const ResolvedJoint& problem, const LawCurve& curve) {
    std::vector<Check<double>> checks;
    const auto add = [&](Concern concern, double value, double limit) {
        checks.push_back(detail::surface_check(concern, value, limit, false));
    };
    for (const Face* face : rough_faces(problem))
        if (const auto wrong = implausible_gradient(problem, *face)) {
            add(Concern::implausible_gradient, wrong->value,
                wrong->value > 1 ? detail::max_plausible_gradient<double> : detail::min_plausible_gradient<double>);
            break;
        }
    const Measurement<double>& height = problem.face.parameters.rms_height;
    for (const Parameter unknown : unknown_parameters(problem, true))
        unknown == Parameter::rms_height
            ? add(Concern::unknown_height, height.error / height.value, 0.5)
            : add(Concern::unknown_gradient, problem.face.gradient_error / *problem.face.rms_gradient, 0.5);
    if (has_lay(problem)) add(Concern::lay, detail::lay_factor, 1);
    if (problem.face.map && missing_points(*problem.face.map) > 0)
        add(Concern::missing_points, static_cast<double>(missing_points(*problem.face.map)), 0);
    if (const double noise = noise_of(problem.face, problem.law_options.edges) / height.value; noise > most_noise)
        add(Concern::noise, noise, most_noise);
    for (const Concern concern : {Concern::area_above_nominal, Concern::not_converged})
        if (const Check<double>* check = detail::find_check(curve.checks, concern); check && !check->holds()) {
            checks.push_back(*check);
            checks.back().first = curve.places[check->first];
        }
    if (auto check = beyond_comparison(problem, curve)) {
        check->first = curve.places[check->first];
        checks.push_back(*check);
    }
    if (!curve.missed.empty()) {
        Check<double> lost{.concern = Concern::no_state, .limit = curve.missed.front().limit};
        lost.violations = curve.missed.size(), lost.first = curve.missed.front().place;
        checks.push_back(lost);
    }
    return checks;
}

/// High over low of the band at the point \p place once \p unknown of the faces is known; infinite without a band.
FSTIFF_INLINE double factor_of_known(ResolvedJoint problem, Request request, std::size_t place, Unknown unknown) {
    for (Face& face : problem.faces) face = with_measured(std::move(face), unknown);
    problem.face = with_measured(std::move(problem.face), unknown);
    request.points = {request.points[place]};
    request.answered = {0};
    request.laws.clear();
    request.approach = request.log_slopes = request.checked = false;
    try {
        const LawCurve curve = *curves_of(problem, request).answer;
        if (!curve.band.empty()) return curve.band.front().high / curve.band.front().low;
    } catch (const domain_error&) {  // as where some drawn surfaces have other peaks than the rest
    }
    return std::numeric_limits<double>::infinity();
}

/// High over low of the band of \p causes.
FSTIFF_INLINE double factor_of(const Causes<double>& causes) {
    const auto [low, high] = detail::band_of(causes);
    return std::exp(high - low);
}

/// The factor that \p causes make of a profile or map four times as large: half the errors, and fewer waves that are
/// longer.
FSTIFF_INLINE double factor_of_larger(const ResolvedJoint& problem, Causes<double> causes) {
    const bool profile = measured_faces(problem).front()->measured->is_profile;
    const auto scale = [&](Cause cause, double factor) {
        auto& spread = causes[static_cast<std::size_t>(cause)];
        spread = {factor * spread.low, factor * spread.high};
    };
    scale(Cause::measurement, 0.5), scale(Cause::shape, 0.5);
    if (problem.nominal_area) {
        LongEnd<double> end = problem.face.parameters.long_end;
        end.side *= profile ? 4 : 2, end.error /= 2;
        const UnmeasuredWaves<double> longer = detail::unmeasured_waves(end, std::sqrt(*problem.nominal_area));
        causes[static_cast<std::size_t>(Cause::long_waves)] = spread_of_long_waves(longer.growth, longer.expected);
    } else {
        scale(Cause::contacts, profile ? 0.25 : 0.5);
    }
    return factor_of(causes);
}

FSTIFF_INLINE std::optional<Answer::Next> next_measurement(const ResolvedJoint& problem, const Request& request,
                                                           const Answer& answer, const AnswerPoint& point) {
    const bool map = problem.face.map && problem.face.spectrum_of_map, measured = !measured_faces(problem).empty();
    const double factor = point.stiffness.high / point.stiffness.low;
    std::optional<Answer::Next> most;
    double least = 0.95 * factor;  // nothing that narrows the factor by less
    const auto consider = [&](std::optional<Unknown> unknown, double narrowed) {
        if (narrowed < least) most = Answer::Next{unknown, point.pressure, false, factor, least = narrowed};
    };
    for (const auto unknown : {Unknown::height, Unknown::gradient, Unknown::alpha, Unknown::hurst, Unknown::skewness})
        if (!map && problem.face.is_open(unknown) && !(measured && detail::is_of_shape(unknown)))
            consider(unknown, factor_of_known(problem, request, point.place, unknown));
    const Causes<double>& causes = point.causes;
    const auto factor_without = [&](Cause cause) {
        Causes<double> others = causes;
        others[static_cast<std::size_t>(cause)] = {};
        return factor_of(others);
    };
    if (const Measurement<double>& height = problem.face.parameters.rms_height; !measured) {
        const double steep = problem.face.gradient_error / problem.face.rms_gradient.value_or(1);
        if (height.error > 0 || steep > 0)  // as they are written
            consider(steep * height.value > height.error ? Unknown::gradient : Unknown::height,
                     factor_without(Cause::measurement));
    }
    if (problem.hardness_range && depends_on_hardness(problem, {&find_law(answer.law)}))
        consider(Unknown::hardness, factor_without(Cause::hardness));
    if (const double flat = factor_without(Cause::form); flat < least && !problem.form)
        most = Answer::Next{std::nullopt, point.pressure, true, factor, least = flat};
    const bool map_is_better = causes[static_cast<std::size_t>(Cause::lay)].high > 0;
    if (measured && !answer.of_map_itself)
        consider(std::nullopt, map_is_better ? factor_without(Cause::lay) : factor_of_larger(problem, causes));
    return most;
}

}}}  // namespace fstiff::detail
