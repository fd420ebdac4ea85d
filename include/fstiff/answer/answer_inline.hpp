// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/answer.hpp for joints of numbers: fstiff/answer_inline.hpp and fstiff/implementation.hpp
/// include them.

#define FSTIFF_ANSWER_INLINE

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/answer_curve_inline.hpp>
#include <fstiff/answer/answer_of.hpp>
#include <fstiff/answer/answer_quantity_inline.hpp>
#include <fstiff/answer/bands_inline.hpp>
#include <fstiff/answer/concerns_inline.hpp>
#include <fstiff/answer/curves_inline.hpp>
#include <fstiff/answer/face_inline.hpp>
#include <fstiff/answer/formed_answer_inline.hpp>
#include <fstiff/answer/lacks_inline.hpp>
#include <fstiff/answer/law_of_answer_inline.hpp>
#include <fstiff/answer/law_rows_inline.hpp>
#include <fstiff/answer/quick_hybrids_inline.hpp>
#include <fstiff/answer/request_inline.hpp>
#include <fstiff/answer/resolve_inline.hpp>
#include <fstiff/answer/resolved_joint_inline.hpp>
#include <fstiff/answer/unknowns_inline.hpp>
#include <fstiff/asperity/material.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

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

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

FSTIFF_INLINE LawOptions law_options(const AnswerOptions& options) {
    return {.gamma = options.gamma, .points = options.grid, .edges = options.edges};
}

FSTIFF_INLINE void require_options(std::span<const double> points, const AnswerOptions& options) {
    if (points.empty()) throw domain_error("pressures: must have at least one");
    for (const double x : points)
        if (options.at_separations)
            require(std::isfinite(x), "separation", x, "finite");
        else
            require_positive("pressure", x);
    require_positive("seating", options.seating);
    require(options.samples == 0 || (options.samples >= 20 && options.samples <= 100000), "samples", options.samples,
            "0, or from 20 to 100000");
    for (const std::size_t place : options.places)
        require(place < points.size(), "places", place, "below the number of points");
}

/// The quantities of \p options, in the order of the table.
FSTIFF_INLINE std::vector<const AnswerQuantity*> quantities_of(const ResolvedJoint& joint,
                                                               const AnswerOptions& options) {
    constexpr std::array<std::string_view, 9> members{"nominal_area",       "waves",
                                                      "waves.shear",        "friction.amplitude",
                                                      "conduction.thermal", "conduction.electrical",
                                                      "conduction.gap",     "elastic constants of both bodies",
                                                      "flatness or form"};
    for (const std::string& word : options.quantities)
        if (const auto need = lack_of(quantity_called(word, "quantities"), joint); need != AnswerQuantity::nothing)
            throw domain_error(Refusal{
                .parameter = "quantities",
                .value = "\"" + word + "\"",
                .reason = "needs " + std::string(members[static_cast<std::size_t>(std::countr_zero(unsigned{need}))])});
    std::vector<const AnswerQuantity*> quantities;
    for (const AnswerQuantity& quantity : answer_quantities())
        if (options.quantities.empty()
                ? lack_of(quantity, joint) == AnswerQuantity::nothing
                : std::count(options.quantities.begin(), options.quantities.end(), quantity.word) > 0)
            quantities.push_back(&quantity);
    return quantities;
}

/// What the laws that are named must give for \p quantities of \p joint.
FSTIFF_INLINE Quantity of_laws(const ResolvedJoint& joint, const std::vector<const AnswerQuantity*>& quantities,
                               bool checked) {
    Quantity all = Quantity::pressure | Quantity::separation;
    for (const AnswerQuantity* quantity : quantities) all = all | quantity->of_law;
    if (checked) all = all | Quantity::contact_density;
    if (has(all, Quantity::contact_density) || joint.conduction.thermal_film > 0 ||
        joint.conduction.electrical_film > 0)
        all = all | Quantity::real_area_fraction;
    return all;
}

/// Whether the separation enters what is asked of the answer or checked: mean planes cross at half of the hardness and
/// above.
FSTIFF_INLINE bool needs_separation(const ResolvedJoint& joint, std::span<const double> points,
                                    const AnswerOptions& options,
                                    const std::vector<const AnswerQuantity*>& quantities) {
    return options.at_separations || joint.face.map || joint.face.parameters.max_peak_height.value > 0 ||
           std::any_of(quantities.begin(), quantities.end(),
                       [](const auto* each) { return each->of_law == Quantity::separation; }) ||
           !(*std::max_element(points.begin(), points.end()) < hardness_of(joint) / 2);
}

/// What \p options ask of \p joint at \p points.
FSTIFF_INLINE Request request_of(const ResolvedJoint& joint, std::span<const double> points,
                                 const AnswerOptions& options, const std::vector<const AnswerQuantity*>& quantities,
                                 bool checked) {
    const auto wants = [&](std::string_view word) {
        return std::any_of(quantities.begin(), quantities.end(), [&](const auto* each) { return each->word == word; });
    };
    Request request{.points = {points.begin(), points.end()},
                    .at_separations = options.at_separations,
                    .answered = options.places,
                    .approach = wants("approach"),
                    .log_slopes = std::any_of(quantities.begin(), quantities.end(),
                                              [](const auto* each) { return (each->needs & each->slip) != 0; }),
                    .separation = needs_separation(joint, points, options, quantities),
                    .seating = options.seating,
                    .samples = options.samples,
                    .seed = options.seed,
                    .solves_map = options.solve_map,
                    .answers = !options.laws_alone,
                    .checked = checked,
                    .parallel = options.parallel};
    if (request.answered.empty())
        for (std::size_t i = 0; i < points.size(); ++i) request.answered.push_back(i);
    for (const ChosenLaw& law : options.laws)  // contacts that are there are of laws that are possible
        request.laws.push_back(checked ? &possible_law(law, joint, options.at_separations) : &law.row());
    if (!options.quantities.empty()) request.quantities = of_laws(joint, quantities, checked);
    return request;
}

/// Whether the contacts of an answer at the state \p i of \p curve are peaks, of which many have grown together.
FSTIFF_INLINE bool counts_peaks(const ResolvedJoint& joint, const LawCurve& curve, std::size_t i) {
    return !curve.by.empty() && curve.law_at(i).which != LawKind::boundary_elements && curve.rms_gradient &&
           curve.states[i].pressure.value > most_of_spots * joint.effective_modulus * *curve.rms_gradient;
}

/// The number of \p quantity at the state \p i of \p curve, with the ends of its band; none where its law has none.
FSTIFF_INLINE std::optional<AnswerPoint::Value> value_of(const AnswerQuantity& quantity, const ResolvedJoint& joint,
                                                         const LawCurve& curve, std::size_t i) {
    if (quantity.of_law != Quantity::none && !has(curve.law->quantities, quantity.of_law)) return std::nullopt;
    if (quantity.of_law == Quantity::contact_density && counts_peaks(joint, curve, i)) return std::nullopt;
    if (quantity.word == "approach" && curve.separation_at_seating.empty()) return std::nullopt;
    if ((quantity.needs & quantity.slip) != 0 && curve.log_slopes.empty()) return std::nullopt;
    const Estimate<double> value = quantity.value({joint, curve, i, curve.states[i]});
    const bool lost = quantity.word == "loading_stiffness" && value.value == 0;  // of boundary elements that yield
    if (lost || !std::isfinite(value.value)) return std::nullopt;                // as the resistance of an insulator
    AnswerPoint::Value of{&quantity, {no_number, value.value, no_number}, value.error};
    if (!quantity.follows_stiffness()) return of;
    if (curve.band.empty()) {
        of.number = {value.value, value.value, value.value};
        return of;
    }
    const auto bound = [&](double K, BandEnd end) {
        ContactState<double> state = curve.states[i];
        state.stiffness = {K, 0};
        return quantity.value({joint, curve, i, state, end}).value;
    };
    auto [low, median, high, failed] = curve.band[i];
    if (quantity.of_heat && low > 0)  // the conductivity is as good as K
        std::tie(low, high) = widened(curve.states[i].stiffness.value, low, high, joint.heat);
    if (quantity.with_stiffness == AnswerQuantity::WithStiffness::falls) std::swap(low, high);
    of.number.low = bound(low, BandEnd::low), of.number.high = bound(high, BandEnd::high);
    return of;
}

/// Where the mean over the load of a law of plastic peaks is outside of \p range: "a/R = 0.5, above 0.3".
FSTIFF_INLINE std::string outside_range(const PlasticRange& range, const LoadMeans<double>& means) {
    std::string text;
    const auto add = [&](const char* name, double value, const char* side, double limit) {
        text += (text.empty() ? "" : " and ") + std::string(name) + " = " + rounded_text(value, 4) + ", " + side + " " +
                rounded_text(limit, 3);
    };
    const double s = means.interference.value, ratio = means.radius_ratio.value;
    if (s < range.least_interference) add("omega/omega_c", s, "below", range.least_interference);
    if (s > range.most_interference) add("omega/omega_c", s, "above", range.most_interference);
    if (ratio > range.most_radius_ratio) add("a/R", ratio, "above", range.most_radius_ratio);
    return text;
}

/// The state \p i of \p curve, into \p point.
FSTIFF_INLINE void take_state(const ResolvedJoint& joint, const LawCurve& curve, std::size_t i,
                              const std::vector<const AnswerQuantity*>& quantities, AnswerPoint& point) {
    const double K = curve.states[i].stiffness.value;
    point.state = curve.states[i];
    point.pressure = point.state.pressure.value;
    point.stiffness = curve.band.empty() ? WithBand{K, K, K} : WithBand{curve.band[i].low, K, curve.band[i].high};
    if (curve.faces) {
        const SampledBand<double>& band = curve.faces->band[i];
        point.faces = WithBand{band.low, curve.faces->states[i].stiffness.value, band.high};
        point.loading_of_faces = curve.faces->states[i].loading_stiffness.value;
    }
    point.law = curve.law_at(i).which;
    if (!curve.band.empty()) point.failed = curve.band[i].failed;
    if (curve.rms_gradient)
        point.p_star = dimensionless_pressure(point.pressure, joint.effective_modulus, *curve.rms_gradient);
    if (i < curve.means.size()) point.doubt = outside_range(curve.law->range, curve.means[i]);
    point.values.reserve(quantities.size());
    for (const AnswerQuantity* quantity : quantities)
        if (auto value = value_of(*quantity, joint, quantity->of_faces && curve.faces ? *curve.faces : curve, i))
            point.values.push_back(std::move(*value));
}

/// \p curve at the points of \p request, which it has a state or a reason for.
FSTIFF_INLINE void take_curve(const ResolvedJoint& joint, const LawCurve& curve, const Request& request,
                              const AnswerOptions& options, const std::vector<const AnswerQuantity*>& quantities,
                              AnswerCurve& to) {
    const auto in_pascal = [](double pressure) { return rounded_text(pressure, 3) + " Pa"; };
    to.law = curve.law->which, to.theta = curve.theta, to.r = curve.r;
    to.has_band = !curve.band.empty();
    to.no_approach = curve.no_separation_at_seating;
    to.checks = curve.checks;
    for (Check<double>& check : to.checks)
        if (!check.holds()) check.first = curve.places[check.first];
    if (auto check = beyond_comparison(joint, curve)) {
        check->first = curve.places[check->first];
        to.checks.push_back(*check);
    }
    auto missed = curve.missed.begin();
    for (std::size_t i = 0; i < curve.states.size() || missed != curve.missed.end();) {
        AnswerPoint& point = to.points.emplace_back();
        if (missed == curve.missed.end() || (i < curve.states.size() && curve.places[i] < missed->place)) {
            point.place = curve.places[i];
            take_state(joint, curve, i++, quantities, point);
            continue;
        }
        point.place = missed->place, point.miss = missed->why;
        const double asked = request.points[missed->place];
        if (request.at_separations)
            point.pressure = no_number, point.state.separation = {asked, 0};
        else
            point.pressure = asked;
        point.reason = reason_of(joint, *missed, asked, options.pressure_text ? options.pressure_text : +in_pascal);
        ++missed;
    }
}

/// What is known of the answer \p curve beyond its points, into \p answer, which has them.
FSTIFF_INLINE void take_facts(const ResolvedJoint& joint, const Request& request, const LawCurve& curve,
                              const AnswerFacts& facts, Answer& answer) {
    std::size_t state = 0;
    for (AnswerPoint& point : answer.points) {
        if (!point.ok()) continue;
        const AnswerReason& reason = facts.reasons[state++];
        point.causes = reason.causes, point.contacts = reason.contacts;
        point.loading_stiffness = reason.loading_stiffness;
    }
    answer.flows = facts.flows;
    answer.of_map_itself = facts.of_map_itself;
    answer.long_waves = facts.long_waves;
    answer.relative_hardness = facts.relative_hardness;
    answer.greatest_pressure = facts.flows ? joint.greatest_pressure : std::nullopt;
    answer.rms_gradient = curve.rms_gradient;
    answer.assumed = assumed_of(joint, *curve.law);
    const std::span<const double> pressures(request.points.data(), request.at_separations ? 0 : request.points.size());
    answer.concerns = unlikely_units(joint, pressures);
    for (const Check<double>& check : concerns_of(joint, curve)) answer.concerns.push_back(check);
    answer.doubtful = std::any_of(answer.concerns.begin(), answer.concerns.end(), [&](const Check<double>& check) {
        return makes_doubtful(check, request.points.size());
    });
}

FSTIFF_INLINE AnswerPoint point_of(const ResolvedJoint& joint, const Law& law, const ContactState<double>& state,
                                   const AnswerOptions& options) {
    AnswerPoint point;
    take_state(joint, {.law = &law, .states = {state}, .places = {0}}, 0, quantities_of(joint, options), point);
    return point;
}

FSTIFF_INLINE std::optional<Answer::Next> next_of(const ResolvedJoint& joint, std::span<const double> points,
                                                  const AnswerOptions& options, const Answer& answer) {
    const Request request = request_of(joint, points, options, {}, false);
    const AnswerPoint* middle = answer.at(request.answered[request.answered.size() / 2]);
    return middle ? next_measurement(joint, request, answer, *middle) : std::nullopt;
}

FSTIFF_INLINE Answer answer_of(const ResolvedJoint& joint, std::span<const double> points, const AnswerOptions& options,
                               const std::vector<MadeContact>* contacts) {
    require_options(points, options);
    const std::vector<const AnswerQuantity*> quantities = quantities_of(joint, options);
    const Request request = request_of(joint, points, options, quantities, contacts == nullptr);
    Answer answer;
    answer.rms_height = joint.face.parameters.rms_height.value;
    answer.effective_modulus = joint.effective_modulus;
    answer.hardness = hardness_of(joint);
    answer.yield_strength = joint.yield_strength.value_or(answer.hardness / hardness_over_yield_strength<double>);
    const Curves curves = curves_of(joint, request, options.progress, contacts);
    answer.failed = curves.failed;
    for (const LawCurve& named : curves.named)
        take_curve(joint, named, request, options, quantities, answer.laws.emplace_back());
    answer.refusal = curves.no_answer;
    if (!curves.answer) return answer;
    take_curve(joint, *curves.answer, request, options, quantities, answer);
    take_facts(joint, request, *curves.answer, curves.facts, answer);
    if (options.next) answer.next = next_of(joint, points, options, answer);
    return answer;
}

}  // namespace detail

FSTIFF_INLINE Answer answer(const Joint& joint, std::span<const double> pressures, const AnswerOptions& options) {
    return detail::answer_of(detail::problem_of(joint, detail::law_options(options)), pressures, options);
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
