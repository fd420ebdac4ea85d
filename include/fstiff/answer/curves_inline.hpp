// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/curves.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/bands.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/request.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

inline constexpr Quantity of_answer = Quantity::pressure | Quantity::separation | Quantity::stiffness |
                                      Quantity::real_area_fraction | Quantity::contact_density |
                                      Quantity::loading_stiffness;

/// The greatest pressure [Pa] below \p pressure at which \p contact has a state, to 1e-6; 0 where it has none.
FSTIFF_INLINE double reach_of(const AnyContact& contact, double pressure) {
    const auto has_state = [&](double p) {
        return contact.at_pressures(std::span(&p, 1), Quantity::stiffness).front().ok();
    };
    double low = pressure, high = pressure;
    for (double step = 2; !has_state(low); step *= step)
        if (high = low, low /= step; !(low > 0)) return 0;
    while (high > (1 + 1e-6) * low)
        if (const double middle = std::sqrt(low) * std::sqrt(high); has_state(middle))
            low = middle;
        else
            high = middle;
    return low;
}

/// Replaces the reason of a law that has no state at a pressure above its states by the limit, where this is known.
FSTIFF_INLINE void find_limit(const ResolvedJoint& problem, const Request& request, const AnyContact& contact,
                              LawCurve& curve) {
    if (request.at_separations || !curve.law->varies || !curve.law->holds_when_crowded) return;
    double greatest = 0;
    for (const auto& state : curve.states) greatest = (std::max)(greatest, state.pressure.value);
    const auto is_above = [&](const MissedPoint& missed) {
        return missed.why != Miss::range && request.points[missed.place] > greatest;
    };
    double first = std::numeric_limits<double>::infinity();
    for (const MissedPoint& missed : curve.missed)
        if (is_above(missed)) first = (std::min)(first, request.points[missed.place]);
    if (!std::isfinite(first)) return;
    const double reach = reach_of(contact, first), hardness = hardness_of(problem);
    if (!(reach > 0)) return;
    const bool flowed = curve.law->needs_hardness && reach > 0.999 * hardness;
    for (MissedPoint& missed : curve.missed) {
        if (!is_above(missed)) continue;
        missed.why = flowed ? Miss::hardness : Miss::closed;
        missed.limit = flowed ? hardness : reach;
    }
}

/// Puts \p points of \p contact into \p curve, as states or as what the law does not reach. A gradient so small that p*
/// is beyond the range of double precision is as good as unknown.
FSTIFF_INLINE void take_points(const ResolvedJoint& problem, const Request& request, LawCurve& curve,
                               const AnyContact& contact, const std::vector<ContactPoint<double>>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].ok()) {
            curve.states.push_back(points[i].state);
            curve.places.push_back(i);
        } else {
            const bool law = points[i].status == PointStatus::out_of_reach;
            curve.missed.push_back({i, law ? Miss::law : Miss::range, points[i].reason});
        }
    }
    find_limit(problem, request, contact, curve);
    const auto has_p_star = [&](const ContactState<double>& state) {
        return std::isfinite(
            detail::dimensionless_pressure(state.pressure.value, problem.effective_modulus, *curve.rms_gradient));
    };
    if (curve.rms_gradient && !std::all_of(curve.states.begin(), curve.states.end(), has_p_star))
        curve.rms_gradient.reset();
}

/// d log K/d log p of \p curve, which has its states, over the pressures below each: what the loss factor takes of the
/// law. None where \p contact has no K there.
FSTIFF_INLINE void add_log_slopes(const AnyContact& contact, LawCurve& curve) {
    constexpr double share = 0.6;
    std::vector<double> pressures;
    for (const ContactState<double>& state : curve.states) pressures.push_back(share * state.pressure.value);
    const auto points = points_of({.points = pressures}, *curve.law, contact, Quantity::stiffness);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double ratio = curve.states[i].stiffness.value / points[i].state.stiffness.value;
        if (!points[i].ok() || !(ratio > 0)) return curve.log_slopes.clear();
        curve.log_slopes.push_back(std::clamp(std::log(ratio) / -std::log(share), 0.0, 1.9));
    }
}

/// The checks of \p curve that mean something of its law.
FSTIFF_INLINE std::vector<Check<double>> checks_of(const ResolvedJoint& problem, const LawCurve& curve,
                                                   Quantity quantities) {
    std::vector<Check<double>> checks =
        detail::check_curve<double>(curve.states,
                                    {.effective_modulus = problem.effective_modulus,
                                     .rms_gradient = curve.rms_gradient,
                                     .max_peak_height = problem.face.parameters.max_peak_height.value,
                                     .nominal_area = problem.nominal_area,
                                     .yield_strength = problem.yield_strength},
                                    quantities);
    const bool of_grid = !curve.law->varies || (problem.face.map && problem.face.map->maps.size() > 1);
    std::erase_if(checks, [&](const Check<double>& check) {
        return (check.concern == Concern::interacting_asperities && curve.law->holds_when_crowded) ||
               (check.concern == Concern::not_converged && of_grid);  // the error is that of the grid or shifts
    });
    return checks;
}

/// \p curve with its states by \p contact, and what else \p request asks for, but no band.
FSTIFF_INLINE LawCurve curve_of(const ResolvedJoint& problem, const Request& request, LawCurve curve,
                                const AnyContact& contact, Quantity quantities, const ProgressHook& progress) {
    const Quantity given =
        static_cast<Quantity>(static_cast<unsigned>(quantities) & static_cast<unsigned>(curve.law->quantities));
    take_points(problem, request, curve, contact, points_of(request, *curve.law, contact, given, progress));
    if (request.approach) add_seating(request, contact, curve);
    if (request.log_slopes) add_log_slopes(contact, curve);
    if (!request.checked) return curve;
    curve.checks = checks_of(problem, curve, given);
    std::vector<double> etas;
    for (const auto& state : curve.states) etas.push_back(state.eta);
    curve.means = contact.means_at(etas);
    return curve;
}

FSTIFF_INLINE bool has_states(const std::vector<LawCurve>& curves) {
    return std::any_of(curves.begin(), curves.end(), [](const LawCurve& curve) { return !curve.states.empty(); });
}

/// The curves of \p request, whose laws are named, with their bands.
FSTIFF_INLINE void add_curves(const ResolvedJoint& problem, const Request& request, Quantity quantities,
                              const ProgressHook& progress, const std::vector<MadeContact>* contacts,
                              std::vector<LawCurve>& curves, std::size_t& failed) {
    std::size_t count = 0;
    for (const Law* law : request.laws) count += law->has_peaks ? peaks_of(*law, problem).size() : 1;
    ProgressHook of_all;  // one bar for the points of all curves
    if (progress)
        of_all = [&](std::string_view part, std::size_t done, std::size_t total) {
            progress(part, curves.size() * total + done, count * total);
        };
    const std::optional<double> slope = gradient(problem);
    if (request.parallel && request.samples > 0 && problem.face.map) make_contacts(problem, request);
    if (contacts)
        for (const auto& [curve, contact] : *contacts)
            curves.push_back(curve_of(problem, request, curve, *contact, quantities, of_all));
    else
        for_each_contact(problem, request.laws, {}, [&](const ContactOfLaw& recipe) {
            curves.push_back(curve_of(problem, request, {recipe.law, recipe.theta, recipe.r, slope}, *recipe.make(),
                                      quantities, of_all));
        });
    if (detail::has(quantities, Quantity::stiffness) && request.samples > 0 &&
        (problem.face.has_errors() || problem.hardness_range) && has_states(curves))
        failed = (std::max)(failed, add_bands(problem, request, curves, progress));
}

FSTIFF_INLINE void add_answer(ResolvedJoint problem, Request request, const ProgressHook& progress,
                              const std::vector<MadeContact>* contacts, Curves& result) {
    request.laws = {&law_of_answer(problem, request.at_separations)};
    std::vector<MadeContact> made;  // those of a map are made in parts
    if (!contacts && !is_map(problem.face)) made = contacts_of(problem, request.laws), contacts = &made;
    std::vector<LawCurve> curves;
    const Quantity quantities = request.separation ? of_answer : without(of_answer, Quantity::separation);
    add_curves(problem, request, quantities, progress, contacts, curves, result.failed);
    result.answer = std::move(curves.front());
    const AnyContact* const contact = is_map(problem.face) ? nullptr : contacts->front().contact.get();
    result.facts = make_answer(problem, request, *result.answer, contact, progress);
    if (problem.form) add_form(problem, request, contacts, result);
}

/// The answer next to laws that are named. A band costs more than a curve: of many points it is of those that are
/// answered.
FSTIFF_INLINE void add_answer_to_named(const ResolvedJoint& problem, Request request, Curves& result) {
    constexpr std::size_t many = 100;
    std::vector<std::size_t> places;
    if (request.points.size() > many) {
        places = std::move(request.answered);
        std::vector<double> points;
        for (const std::size_t place : places) points.push_back(request.points[place]);
        request.points = std::move(points);
        request.answered.clear();
        for (std::size_t i = 0; i < places.size(); ++i) request.answered.push_back(i);
    }
    request.checked = false;
    const std::size_t failed = result.failed;
    try {
        add_answer(problem, std::move(request), {}, nullptr, result);
    } catch (const domain_error& error) {
        result.answer.reset();
        result.no_answer = error.what();
    }
    result.failed = failed;  // of the laws that are named
    if (places.empty() || !result.answer) return;
    for (std::size_t& place : result.answer->places) place = places[place];
    for (MissedPoint& missed : result.answer->missed) missed.place = places[missed.place];
}

FSTIFF_INLINE std::optional<std::size_t> LawCurve::state_at(std::size_t place) const {
    const auto match = std::lower_bound(places.begin(), places.end(), place);
    if (match == places.end() || *match != place) return std::nullopt;
    return static_cast<std::size_t>(match - places.begin());
}

FSTIFF_INLINE void add_seating(const Request& request, const AnyContact& contact, LawCurve& curve) {
    const auto point = contact.at_pressures(std::span(&request.seating, 1), Quantity::separation).front();
    if (point.ok())
        curve.separation_at_seating.assign(curve.states.size(), point.state.separation.value);
    else
        curve.no_separation_at_seating = point.reason;
}

FSTIFF_INLINE std::vector<MadeContact> contacts_of(const ResolvedJoint& problem, const std::vector<const Law*>& laws,
                                                   const ProgressHook& progress) {
    std::vector<MadeContact> contacts;
    const std::optional<double> slope = gradient(problem);
    for_each_contact(problem, laws, progress, [&](const ContactOfLaw& recipe) {
        contacts.push_back({{recipe.law, recipe.theta, recipe.r, slope}, recipe.make()});
    });
    return contacts;
}

FSTIFF_INLINE const Law& law_of_answer(ResolvedJoint& problem, bool at_separations) {
    if (problem.face.map && missing_points(*problem.face.map) > 0)
        problem.face.write([](Face& face) { face.spectrum_of_map = false; });
    AnswerQuestion<double> question{.known = known_as(problem)};
    const std::array choices{laws::plastic, laws::hybrid, laws::hertz, laws::greenwood_williamson};
    for (const ChosenLaw& law : choices)
        if (lack_of(law.row(), problem, at_separations) == Lack::nothing) question.available.push_back(law.which);
    const LawKind law = detail::answering_law(question);
    return std::find_if(choices.begin(), choices.end(), [&](const ChosenLaw& each) { return each.which == law; })
        ->row();
}

FSTIFF_INLINE Curves curves_of(const ResolvedJoint& problem, const Request& request, const ProgressHook& progress,
                               const std::vector<MadeContact>* contacts) {
    Curves result;
    if (request.laws.empty()) {
        add_answer(problem, request, progress, contacts, result);
        return result;
    }
    add_curves(problem, request, request.quantities, progress, contacts, result.named, result.failed);
    if (request.answers && has_states(result.named)) add_answer_to_named(problem, request, result);
    return result;
}

FSTIFF_INLINE std::string reason_of(const ResolvedJoint& problem, const MissedPoint& missed, double pressure,
                                    std::string (*text)(double pressure)) {
    std::string unit;
    for (const Check<double>& check : unlikely_units(problem, {})) unit += "; " + sentence_of_unit(check);
    switch (missed.why) {
        case Miss::none: break;
        case Miss::law: return missed.reason;
        case Miss::range: return "a result is beyond the range of double precision";
        case Miss::hardness:
            return text(pressure) + (pressure > missed.limit ? " is above the hardness (" : " reaches the hardness (") +
                   text(missed.limit) + "): the contact is closed" + unit;
        case Miss::closed:
            return "above " + text(missed.limit) + " the contact is closed and the bulk carries the load" + unit;
    }
    return "";
}

}}}  // namespace fstiff::detail
