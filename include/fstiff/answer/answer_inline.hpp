// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/answer.hpp for joints of numbers: fstiff/answer_inline.hpp and fstiff/implementation.hpp
/// include them.

#define FSTIFF_ANSWER_INLINE

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/answer_curve_inline.hpp>
#include <fstiff/answer/bands_inline.hpp>
#include <fstiff/answer/concerns_inline.hpp>
#include <fstiff/answer/curves_inline.hpp>
#include <fstiff/answer/derived_inline.hpp>
#include <fstiff/answer/face_inline.hpp>
#include <fstiff/answer/lacks_inline.hpp>
#include <fstiff/answer/law_rows_inline.hpp>
#include <fstiff/answer/quick_hybrids_inline.hpp>
#include <fstiff/answer/request_inline.hpp>
#include <fstiff/answer/resolve_inline.hpp>
#include <fstiff/answer/resolved_joint_inline.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/answer/unknowns_inline.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>
#include <fstiff/wave/spring_interface.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff { inline namespace v0_1 {

namespace detail {

FSTIFF_INLINE std::vector<AssumedNumber> assumed_of(const ResolvedJoint& problem, const Law& law) {
    std::vector<AssumedNumber> numbers;
    if (const auto& range = problem.hardness_range; range && depends_on_hardness(problem, {&law}))
        numbers.push_back({Unknown::hardness, {range->low, range->middle, range->high}});
    for (const auto& [face, prior] : relevant_priors(problem, {&law}))
        if (const auto& [low, middle, high] = prior->range; prior->origin != Origin::measurement)
            numbers.push_back({prior->which, {low, middle, high}, face > 0});
    return numbers;
}

FSTIFF_INLINE LawOptions law_options(const AnswerOptions& options) {
    return {.gamma = options.gamma, .points = options.grid, .edges = options.edges};
}

/// What follows from K of the state \p i of \p curve, into \p point.
FSTIFF_INLINE void derive(const ResolvedJoint& problem, const LawCurve& curve, std::size_t i, AnswerPoint& point) {
    const ContactState<double>& state = curve.states[i];
    const auto put = [&](Derived quantity, std::optional<Banded>& into) {
        if (!can_derive(quantity, problem) || (quantity == Derived::loss_factor && curve.log_slopes.empty())) return;
        const auto bound = [&](double K, BandEnd end) {
            ContactState<double> other = state;
            if (end != BandEnd::value) other.stiffness = {K, 0};
            return derived(quantity, problem, curve, i, other, end).value;
        };
        const double low = falls(quantity) ? point.stiffness.high : point.stiffness.low,
                     high = falls(quantity) ? point.stiffness.low : point.stiffness.high;
        into = {bound(low, BandEnd::low), bound(point.stiffness.value, BandEnd::value), bound(high, BandEnd::high)};
    };
    put(Derived::tangential_stiffness, point.tangential_stiffness);
    put(Derived::loss_factor, point.loss_factor);
    put(Derived::reflection, point.reflection);
    put(Derived::shear_reflection, point.shear_reflection);
    put(Derived::thermal_conductance, point.thermal_conductance);
    put(Derived::electrical_conductance, point.electrical_conductance);
    if (problem.conduction.gap && detail::has(curve.law->quantities, Quantity::separation))
        point.gap_conductance = conductance_of_gap(problem.conduction, state.separation.value);
}

/// The points of \p curve at \p pressures.
FSTIFF_INLINE std::vector<AnswerPoint> points_of(const ResolvedJoint& problem, const LawCurve& curve,
                                                 std::span<const double> pressures) {
    std::vector<AnswerPoint> points(pressures.size());
    for (const MissedPoint& missed : curve.missed)
        points[missed.place] = {.pressure = pressures[missed.place],
                                .reason = reason_of(problem, missed, pressures[missed.place], [](double pressure) {
                                    return detail::rounded_text(pressure, 3) + " Pa";
                                })};
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        AnswerPoint& point = points[curve.places[i]];
        const double K = curve.states[i].stiffness.value;
        point.pressure = pressures[curve.places[i]];
        point.stiffness = curve.band.empty() ? Banded{K, K, K} : Banded{curve.band[i].low, K, curve.band[i].high};
        point.law = curve.law_at(i).which;
        if (!curve.separation_at_seating.empty())
            point.approach = curve.separation_at_seating[i] - curve.states[i].separation.value;
        derive(problem, curve, i, point);
    }
    return points;
}

FSTIFF_INLINE void require_options(std::span<const double> pressures, const AnswerOptions& options) {
    if (pressures.empty()) throw domain_error("pressures: must have at least one");
    for (const double p : pressures) require_positive("pressure", p);
    require_positive("seating", options.seating);
    require(options.samples == 0 || (options.samples >= 20 && options.samples <= 100000), "samples", options.samples,
            "0, or from 20 to 100000");
}

/// Whether the separation enters what is asked or checked: mean planes cross at half of the hardness and above.
FSTIFF_INLINE bool needs_separation(const ResolvedJoint& problem, std::span<const double> pressures,
                                    const AnswerOptions& options) {
    return options.approach || problem.conduction.gap || problem.face.map ||
           problem.face.parameters.max_peak_height.value > 0 ||
           !(*std::max_element(pressures.begin(), pressures.end()) < hardness_of(problem) / 2);
}

}  // namespace detail

FSTIFF_INLINE Answer answer(const Joint& joint, std::span<const double> pressures, const AnswerOptions& options) {
    detail::require_options(pressures, options);
    const detail::ResolvedJoint problem = detail::problem_of(joint, detail::law_options(options));
    detail::Request request{.points = {pressures.begin(), pressures.end()},
                            .approach = options.approach,
                            .log_slopes = can_derive(detail::Derived::loss_factor, problem),
                            .separation = needs_separation(problem, pressures, options),
                            .seating = options.seating,
                            .samples = options.samples,
                            .seed = options.seed,
                            .solves_map = options.solve_map,
                            .parallel = options.parallel};
    for (std::size_t i = 0; i < pressures.size(); ++i) request.answered.push_back(i);
    Answer answer;
    answer.rms_height = problem.face.parameters.rms_height.value;
    const detail::Curves curves = curves_of(problem, request, options.progress);
    const detail::LawCurve& curve = *curves.answer;
    answer.points = points_of(problem, curve, pressures);
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const detail::AnswerReason& reason = curves.facts.reasons[i];
        AnswerPoint& point = answer.points[curve.places[i]];
        point.causes = reason.causes, point.p_star = reason.p_star, point.contacts = reason.contacts;
        point.loading_stiffness = reason.loading_stiffness;
    }
    answer.flows = curves.facts.flows;
    answer.of_map_itself = curves.facts.of_map_itself;
    answer.relative_hardness = curves.facts.relative_hardness;
    answer.assumed = detail::assumed_of(problem, *curve.law);
    const std::vector<const detail::Face*> faces = detail::measured_faces(problem);
    answer.across_lay =
        std::any_of(faces.begin(), faces.end(), [](const auto* face) { return face->is_taken_across(); });
    answer.concerns = unlikely_units(problem, pressures);
    for (const Check<double>& check : concerns_of(problem, curve)) answer.concerns.push_back(check);
    answer.doubtful = std::any_of(answer.concerns.begin(), answer.concerns.end(), [&](const Check<double>& check) {
        return detail::makes_doubtful(check, pressures.size());
    });
    if (const auto index = curve.state_at(pressures.size() / 2); options.next && index)
        if (const auto next = next_measurement(problem, request, curve, curves.facts, *index))
            answer.next = {next->which, pressures[pressures.size() / 2],
                           curve.band[*index].high / curve.band[*index].low, next->factor};
    if (options.laws.empty()) return answer;
    for (const ChosenLaw& law : options.laws) request.laws.push_back(&detail::possible_law(law, problem));
    request.answers = request.checked = false;
    for (const detail::LawCurve& named : curves_of(problem, request, options.progress).named)
        answer.laws.push_back({named.law->which, named.theta, named.r, points_of(problem, named, pressures)});
    return answer;
}

FSTIFF_INLINE ContactLaw<double> Answer::law_at(double quantile, const LawRange<double>& range) const {
    if (!(quantile == 0.05 || quantile == 0.5 || quantile == 0.95))
        detail::refuse("quantile", quantile, 3, "0.05, 0.5 or 0.95");
    std::vector<std::pair<double, double>> logs;  // of p and K
    for (const AnswerPoint& point : points) {
        const auto& [low, value, high] = point.stiffness;
        if (point.ok())
            logs.push_back({std::log(point.pressure), std::log(quantile < 0.5 ? low : quantile > 0.5 ? high : value)});
    }
    const detail::RisingCurve curve(std::move(logs));
    curve.require_within(range.min_pressure, range.max_pressure);
    const double last = std::log(range.max_pressure);
    return ContactLaw<double>::tabulate_points(
        [&](double p) {
            const double x = std::log(p);
            return detail::LawPoint<double>{curve.fall(x, last), std::exp(curve.at(x))};
        },
        rms_height, range, 1.0);
}

FSTIFF_INLINE std::shared_ptr<const AnyContact> contact_of(const Joint& joint, const ChosenLaw& law,
                                                           const AnswerOptions& options) {
    struct Kept {
        detail::ResolvedJoint problem;
        std::unique_ptr<AnyContact> contact;
    };
    const auto kept = std::make_shared<Kept>(Kept{detail::problem_of(joint, detail::law_options(options)), nullptr});
    const detail::Law& row = detail::possible_law(law, kept->problem);
    if (kept->problem.hardness_range && depends_on_hardness(kept->problem, {&row}))
        throw domain_error("law " + std::string(row.name) + ": needs hardness or yield_strength of both bodies");
    for_each_contact(kept->problem, {&row}, options.progress, [&](const detail::ContactOfLaw& recipe) {
        if (!kept->contact) kept->contact = recipe.make();
    });
    return {kept, kept->contact.get()};
}

}}  // namespace fstiff
