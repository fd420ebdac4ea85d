// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/concerns.hpp: inline, or compiled in fstiff::double.

#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/elements.hpp>
#include <fstiff/answer/unknowns.hpp>

#include <fstiff/measured/unmeasured_waves.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fstiff::inline v0_1::detail {

FSTIFF_INLINE std::vector<Parameter> unknown_parameters(const Problem& problem, bool of_answer) {
    std::vector<Parameter> all;
    const auto measured = measured_faces(problem);
    if (problem.face.measured)
        all = parts::unknown_parameters(*problem.face.measured, problem.face.parameters);
    else if (!measured.empty())  // of a sum: what is unknown of one face may not matter next to the other
        all = parts::unknown_parameters(problem.face.parameters);
    if (all.empty() && problem.faces.size() == 2)
        for (const Face* face : measured) {
            const double share = face->parameters.rms_height.value / problem.face.parameters.rms_height.value;
            const auto own = parts::unknown_parameters(*face->measured, face->parameters);
            if (2 * share * share > 1 && std::count(own.begin(), own.end(), Parameter::rms_height) > 0)
                all = {Parameter::rms_height};
        }
    if (of_answer) std::erase_if(all, [](Parameter one) { return one != Parameter::rms_height; });
    return all;
}

FSTIFF_INLINE std::optional<parts::Check<double>> beyond_comparison(const Problem& problem, const LawCurve& curve) {
    parts::Check<double> check{.concern = parts::Concern::beyond_comparison,
                               .limit = parts::max_compared_flow * hardness_of(problem)};
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const double pressure = curve.states[i].pressure.value;
        if (curve.law_at(i).which != LawName::plastic || !(pressure > check.limit)) continue;
        check.least = (std::min)(check.least, pressure), check.greatest = (std::max)(check.greatest, pressure);
        if (check.violations++ == 0) check.first = i;
    }
    return check.holds() ? std::nullopt : std::optional(check);
}

FSTIFF_INLINE std::optional<ImplausibleGradient> implausible_gradient(const Problem& problem, const Face& face) {
    double r = 0;  // the greatest, 1/2 where none is written
    for (const Peaks& peaks : problem.peaks) r = (std::max)(r, peaks.r.value_or(0.5));
    return implausible_gradient(face, r);
}

FSTIFF_INLINE std::vector<parts::Check<double>> concerns_of(const Problem& problem, const LawCurve& curve) {
    using parts::Concern;
    std::vector<parts::Check<double>> all;
    const auto add = [&](Concern concern, double value, double limit) {
        all.push_back(parts::surface_check(concern, value, limit, false));
    };
    for (const Face* face : rough_faces(problem))
        if (const auto wrong = implausible_gradient(problem, *face)) {
            add(Concern::implausible_gradient, wrong->value,
                wrong->value > 1 ? parts::max_plausible_gradient<double> : parts::min_plausible_gradient<double>);
            break;
        }
    const Measurement<double>& height = problem.face.parameters.rms_height;
    if (!unknown_parameters(problem, true).empty()) add(Concern::unknown_height, height.error / height.value, 0.5);
    if (has_lay(problem)) add(Concern::lay, parts::lay_factor, 1);
    if (problem.face.map && missing_points(*problem.face.map) > 0)
        add(Concern::missing_points, static_cast<double>(missing_points(*problem.face.map)), 0);
    if (const double noise = noise_of(problem.face, problem.law_options.edges) / height.value; noise > most_noise)
        add(Concern::noise, noise, most_noise);
    for (const Concern concern : {Concern::area_above_nominal, Concern::not_converged})
        if (const parts::Check<double>* check = parts::find_check(curve.checks, concern); check && !check->holds()) {
            all.push_back(*check);
            all.back().first = curve.places[check->first];
        }
    if (auto check = beyond_comparison(problem, curve)) {
        check->first = curve.places[check->first];
        all.push_back(*check);
    }
    if (!curve.missed.empty()) {
        parts::Check<double> lost{.concern = Concern::no_state, .limit = curve.missed.front().limit};
        lost.violations = curve.missed.size(), lost.first = curve.missed.front().place;
        all.push_back(lost);
    }
    return all;
}

/// High over low of the band at the point \p place once \p which of the faces is known; infinite without a band.
FSTIFF_INLINE double factor_of_known(Problem problem, Request request, std::size_t place, parts::Unknown which) {
    if (which == parts::Unknown::hardness) problem = with_hardness(std::move(problem), hardness_of(problem));
    for (Face& face : problem.faces) face = with_measured(std::move(face), which);
    problem.face = with_measured(std::move(problem.face), which);
    request.points = {request.points[place]};
    request.answered = {0};
    request.laws.clear();
    request.approach = request.growth = request.checked = false;
    try {
        const LawCurve curve = *curves_of(problem, request).answer;
        if (!curve.band.empty()) return curve.band.front().high / curve.band.front().low;
    } catch (const domain_error&) {  // as where some drawn surfaces have other peaks than the rest
    }
    return std::numeric_limits<double>::infinity();
}

/// The factor that \p reason makes of a profile or map four times as large: half the errors, and fewer waves that are
/// longer.
FSTIFF_INLINE double factor_of_larger(const Problem& problem, const AnswerReason& reason) {
    parts::Causes<double> causes = reason.causes;
    const bool profile = measured_faces(problem).front()->measured->is_profile;
    const auto scale = [&](parts::Cause cause, double by) {
        auto& one = causes[static_cast<std::size_t>(cause)];
        one = {by * one.low, by * one.high};
    };
    scale(parts::Cause::measurement, 0.5), scale(parts::Cause::shape, 0.5);
    if (problem.nominal_area) {
        parts::LongEnd<double> end = problem.face.parameters.long_end;
        end.side *= profile ? 4 : 2, end.error /= 2;
        causes[static_cast<std::size_t>(parts::Cause::long_waves)] = {
            -parts::unmeasured_waves(end, std::sqrt(*problem.nominal_area)).growth, 0};
    } else {
        scale(parts::Cause::contacts, profile ? 0.25 : 0.5);
    }
    const auto [low, high] = parts::band_of(causes);
    return std::exp(high - low);
}

FSTIFF_INLINE std::optional<NextMeasurement> next_measurement(const Problem& problem, const Request& request,
                                                              const LawCurve& answer, const AnswerFacts& facts,
                                                              std::size_t at) {
    const bool map = problem.face.map && problem.face.spectrum_of_map, measured = !measured_faces(problem).empty();
    std::optional<NextMeasurement> most;
    double least = 0.95 * (answer.band[at].high / answer.band[at].low);  // nothing that narrows the factor by less
    const auto consider = [&](std::optional<parts::Unknown> which, double factor) {
        if (factor < least) most = NextMeasurement{which, least = factor};
    };
    using parts::Unknown;
    for (const Unknown which : {Unknown::height, Unknown::gradient, Unknown::alpha, Unknown::hurst, Unknown::skewness})
        if (!map && problem.face.is_open(which) && !(measured && parts::is_of_shape(which)))
            consider(which, factor_of_known(problem, request, answer.places[at], which));
    if (problem.hardness_range && feels_hardness(problem, {answer.law}))
        consider(Unknown::hardness, factor_of_known(problem, request, answer.places[at], Unknown::hardness));
    if (measured && !facts.of_map_itself) consider(std::nullopt, factor_of_larger(problem, facts.reasons[at]));
    return most;
}

}  // namespace fstiff::inline v0_1::detail
