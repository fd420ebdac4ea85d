// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/answer_curve.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/band_parts.hpp>
#include <fstiff/answer/curves.hpp>

#include <fstiff/answer/band.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/earlier_load.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

FSTIFF_INLINE bool is_map(const Face& face) { return face.map && face.spectrum_of_map; }

FSTIFF_INLINE double noise_of(const Face& face, Edges edges) {
    return is_map(face) && face.filtered && face.map->spectra ? face.map->noise(edges) : 0;
}

FSTIFF_INLINE double measured_side(const ResolvedJoint& problem) {
    double least = 0;
    for (const Face* face : measured_faces(problem)) {
        const double size = face->measured->size, side = face->measured->is_profile ? size : std::sqrt(size);
        if (side > 0) least = least > 0 ? (std::min)(least, side) : side;
    }
    return least;
}

/// Whether the contact is the measured map: it is the whole face, or the nominal area is no larger.
FSTIFF_INLINE bool is_map_itself(const ResolvedJoint& problem) {
    return is_map(problem.face) &&
           (problem.nominal_area ? *problem.nominal_area <= (1 + 1e-6) * problem.face.map->maps.front()->area()
                                 : problem.face.whole);
}

/// The area [m^2] on which contacts are counted: the nominal one, else a square as long as what was measured; 0: not
/// known.
FSTIFF_INLINE double counted_area(const ResolvedJoint& problem) {
    return problem.nominal_area ? *problem.nominal_area : std::pow(measured_side(problem), 2);
}

/// Uncertainty of \p value by \p band, with its \p parts where they are known.
FSTIFF_INLINE void take_band(Causes<double>& causes, double value, const SampledBand<double>& band,
                             const BandParts<double>* parts, bool sampled) {
    const auto put = [&](Cause cause, double low, double high) {
        causes[static_cast<std::size_t>(cause)] = {low, high};
    };
    if (parts) {
        if (sampled)
            put(Cause::measurement, -std::hypot(parts->errors_low, parts->window_low),
                std::hypot(parts->errors_high, parts->window_high));
        put(Cause::cut_offs, parts->scale_low, parts->scale_high);
        put(Cause::shape, parts->shape_low, parts->shape_high);
        put(Cause::prior, parts->prior_low, parts->prior_high);
        const BandPart<double>& hardness = parts->part_of(Unknown::hardness);
        put(Cause::hardness, hardness.low, hardness.high);
    } else if (sampled && band.low > 0) {
        put(Cause::measurement, (std::min)(0.0, std::log(band.low / value)),
            (std::max)(0.0, std::log(band.high / value)));
    }
}

/// Uncertainty of a profile of a face with a lay: the length of the ridges if it is across the lay, else the profile
/// across.
FSTIFF_INLINE CauseSpread<double> of_lay(const ResolvedJoint& problem) {
    constexpr double softer = 4, stiffer = 2, heavy = 1.5;  // along and across turned, milled, planed and ground maps
    if (has_lay(problem)) return {-std::log(heavy), std::log(detail::lay_factor)};
    for (const Face* face : measured_faces(problem))
        if (face->measured->is_profile && detail::prior_of(face->process).has_lay)
            return {-std::log(softer), std::log(stiffer)};
    return {};
}

/// The shape of the heights of \p face; where it is open, the one of its prior that is farthest from Gaussian.
FSTIFF_INLINE HeightShape<double> farthest_shape(const Face& face) {
    HeightShape<double> shape = face.shape;
    for (const Prior& prior : face.priors)
        if (prior.which == Unknown::skewness)
            for (const double end : {prior.low, prior.high})
                if (std::abs(end) > std::abs(shape.skewness)) shape = with_value(face.shape, prior.which, end);
    return shape;
}

FSTIFF_INLINE CauseSpread<double> law_error(const ResolvedJoint& problem, LawKind law, const AnswerReason& reason,
                                            double grid) {
    LawErrorQuestion<double> question{.law = law, .known = known_as(problem)};
    if (reason.p_star) question.p_star = *reason.p_star, question.hardness = relative_hardness(problem).value_or(0);
    question.alpha_known = !problem.face.is_open(Unknown::alpha);
    question.shape_known = !problem.face.is_open(Unknown::skewness);
    const HeightShape<double> shape = farthest_shape(problem.face);
    if (const auto& heights = problem.face.heights; heights && heights->kurtosis.value != 0)
        question.skewness = heights->skewness, question.kurtosis = heights->kurtosis;
    else if (question.known == KnownAs::numbers || question.known == KnownAs::height)
        question.skewness = {shape.skewness, 0}, question.kurtosis = {shape.kurtosis, 0};
    if (const Measurement<double>& height = problem.face.parameters.rms_height; height.value > 0)
        question.long_waves = height.error / height.value;
    const CauseSpread<double> error = detail::law_error(question);
    return {-std::hypot(error.low, grid), std::hypot(error.high, grid)};
}

FSTIFF_INLINE KnownAs known_as(const ResolvedJoint& problem) {
    if (is_map(problem.face)) return KnownAs::map;
    if (!measured_faces(problem).empty()) return KnownAs::trace;
    constexpr double spread_of_height = 4;  // of a gradient by the height alone, 95 % over 5 %; all else gives less
    for (const Prior& prior : problem.face.priors)
        if (prior.which == Unknown::gradient && prior.high > spread_of_height * prior.low) return KnownAs::height;
    return KnownAs::numbers;
}

/// \p from with the weight 1 - \p weight, and \p to.
FSTIFF_INLINE CauseSpread<double> toward(const CauseSpread<double>& from, const CauseSpread<double>& to,
                                         double weight) {
    return {std::lerp(from.low, to.low, weight), std::lerp(from.high, to.high, weight)};
}

/// What one shift of two maps has over the mean of those that were computed, whose scatter is in \p K.
FSTIFF_INLINE CauseSpread<double> scatter_of_shifts(const ResolvedJoint& problem, const Estimate<double>& K) {
    const auto shifts = static_cast<double>(problem.face.map->maps.size());
    const double t = math::student_quantile(math::normal_95<double>, static_cast<int>(shifts) - 1),
                 scatter = t * std::sqrt(1 + 1 / shifts) * K.error / K.value;
    return {-scatter, scatter};
}

/// Takes \p to with its weight into the state \p i of \p curve, K and the loading stiffness by their logarithms, and
/// its causes into \p reason.
FSTIFF_INLINE void hand_over(const ResolvedJoint& problem, const Solved& to, std::size_t i, LawCurve& curve,
                             AnswerReason& reason) {
    ContactState<double>& from = curve.states[i];
    const auto take = [&](Estimate<double> ContactState<double>::*member) {
        Estimate<double>& estimate = from.*member;
        const Estimate<double>& other = to.state.*member;
        if (!(to.weight < 1 && estimate.value > 0 && other.value > 0)) return void(estimate = other);
        estimate.value *= std::pow(other.value / estimate.value, to.weight);
        estimate.error = std::lerp(estimate.error, other.error, to.weight);
    };
    const bool scatters = is_map_itself(problem) && problem.face.map->maps.size() > 1;  // by scatter_of_shifts()
    const double grid = scatters ? 0 : to.state.stiffness.error / to.state.stiffness.value;
    const auto error = law_error(problem, LawKind::boundary_elements, reason, std::isfinite(grid) ? grid : 0);
    auto& law = reason.causes[static_cast<std::size_t>(Cause::law)];
    auto& cut_offs = reason.causes[static_cast<std::size_t>(Cause::cut_offs)];
    law = toward(law, error, to.weight);
    cut_offs = toward(cut_offs, {to.cut_offs.low, std::hypot(cut_offs.high, to.cut_offs.high)}, to.weight);
    reason.causes[static_cast<std::size_t>(Cause::noise)] = {0, to.weight * to.noise};
    take(&ContactState<double>::stiffness);
    take(&ContactState<double>::loading_stiffness);
    take(&ContactState<double>::real_area_fraction);
    if (to.state.contact_density.value > 0) take(&ContactState<double>::contact_density);
    from.separation.value = std::lerp(from.separation.value, to.state.separation.value, to.weight);
    if (!curve.separation_at_seating.empty() && to.separation_at_seating)
        curve.separation_at_seating[i] =
            std::lerp(curve.separation_at_seating[i], *to.separation_at_seating, to.weight);
}

/// A light load, K there, and the upper end of the error of the law alone; each is computed when it is first asked for.
struct LightLoad {
    double pressure = 0;
    std::optional<double> log_high{}, log_stiffness{};  ///< ln of end over K, and of K; -infinity: there is no K
};

/// The state \p i of \p curve with the waves that the measurement has not, which raise sigma and the gap by 1/\p
/// factor and leave the gradient: at one pressure K is less by the factor.
FSTIFF_INLINE void lower_by_long_waves(double factor, std::size_t i, LawCurve& curve) {
    if (factor == 1) return;
    ContactState<double>& state = curve.states[i];
    for (Estimate<double>* K : {&state.stiffness, &state.loading_stiffness}) K->value *= factor, K->error *= factor;
    state.separation.value /= factor;
    if (i < curve.separation_at_seating.size()) curve.separation_at_seating[i] /= factor;
}

/// K of the law of \p curve at the greatest pressure that \p problem has carried [Pa/m]; 0: the peaks do not yield, or
/// it has none. \p contact is that of the law, null of a map.
FSTIFF_INLINE double stiffness_at_greatest(const ResolvedJoint& problem, const LawCurve& curve, bool flows,
                                           const AnyContact* contact) {
    if (!problem.greatest_pressure || !flows) return 0;
    std::vector<MadeContact> made;
    if (!contact) made = contacts_of(problem, {curve.law}), contact = made.front().contact.get();
    const double p = (std::min)(*problem.greatest_pressure, 0.95 * hardness_of(problem));
    const auto point = contact->at_pressures(std::span(&p, 1), Quantity::stiffness).front();
    return point.ok() ? point.state.stiffness.value : 0;
}

/// Takes the state \p i of \p curve after the greatest pressure, if that is greater: what yielded then stays. K is that
/// of boundary elements as far as \p solved has it, else of the law of earlier loads with its error, from \p greatest,
/// K at the greatest pressure [Pa/m].
FSTIFF_INLINE void take_earlier_load(const ResolvedJoint& problem, double greatest, const Solved& solved, std::size_t i,
                                     LawCurve& curve, AnswerReason& reason) {
    ContactState<double>& state = curve.states[i];
    const double K = state.stiffness.value;
    if (!(greatest > 0 && state.pressure.value < *problem.greatest_pressure)) return;
    const double by_law =
        greatest > K
            ? std::log(greatest / K * stiffness_after_load(K / greatest, relative_hardness(problem).value_or(0)))
            : 0;
    const double weight = solved.earlier_load ? solved.weight : 0,
                 change = std::lerp(by_law, solved.earlier_load.value_or(0), weight);
    if (!(change > 0)) return;
    const double after = K * std::exp(change);
    state.stiffness = {after, state.stiffness.error * after / K};
    state.loading_stiffness.value = after;
    const double error = 0.2 * (1 - weight);  // 5 and 95 % of ln K about that law
    CauseSpread<double>& law = reason.causes[static_cast<std::size_t>(Cause::law)];
    law = {-std::hypot(law.low, error), std::hypot(law.high, error)};
}

/// The upper ends that the error of a law gives under light loads: it grows towards them, of bounded heights faster
/// than K falls, but what K is not above under more pressure it is not above under less.
class LightEnds {
public:
    /// \p contact is that of the law of \p curve; null of a map, which has no such ends.
    LightEnds(const ResolvedJoint& problem, const LawCurve& curve, const AnyContact* contact)
        : problem_(problem),
          law_(curve.law->which),
          contact_(contact),
          rises_(curve.law->holds_when_crowded && !problem.face.bearing) {
        if (!contact || !curve.rms_gradient) return;
        constexpr int count = 48, a_decade = 8;
        closing_ = problem.effective_modulus * *curve.rms_gradient;
        for (int k = count; k >= 0; --k)
            loads_.push_back({law_error_pressures.front() * std::pow(10.0, -double(k) / a_decade) * closing_});
        const double beyond = problem.face.bearing ? 300 : 4;  // K of bounded heights rises slowly
        const auto is_light = [&](const auto& state) { return state.pressure.value < beyond * loads_.back().pressure; };
        if (std::none_of(curve.states.begin(), curve.states.end(), is_light)) loads_.clear();
    }

    /// ln of the greatest end under less than \p pressure, where K is exp(\p log_stiffness); any less where none is
    /// above \p log_end.
    double greatest(double pressure, double log_stiffness, double log_end) {
        constexpr double rounding = 1e-6;
        double greatest = -std::numeric_limits<double>::infinity();
        double log_most = log_stiffness;  // of K under lighter loads
        for (auto load = loads_.rbegin(); load != loads_.rend(); ++load) {
            if (!(load->pressure < pressure)) continue;
            if (!load->log_high) load->log_high = high_at(load->pressure);
            if (rises_ && log_most + *load->log_high + rounding < (std::max)(greatest, log_end)) continue;
            if (!load->log_stiffness) load->log_stiffness = log_stiffness_at(load->pressure);
            if (std::isfinite(*load->log_stiffness)) log_most = *load->log_stiffness;
            greatest = (std::max)(greatest, *load->log_stiffness + *load->log_high);
        }
        return greatest;
    }

private:
    double high_at(double pressure) const {
        AnswerReason reason;
        reason.p_star = pressure / closing_;
        return law_error(problem_, law_, reason).high;
    }
    double log_stiffness_at(double pressure) const {
        const auto point = contact_->at_pressures(std::span(&pressure, 1), Quantity::stiffness).front();
        return point.ok() ? std::log(point.state.stiffness.value) : -std::numeric_limits<double>::infinity();
    }

    const ResolvedJoint& problem_;
    LawKind law_;
    const AnyContact* contact_;
    bool rises_;          ///< K, with the pressure: most loads cannot have the greatest end
    double closing_ = 0;  ///< E g [Pa]
    std::vector<LightLoad> loads_{};
};

FSTIFF_INLINE void make_ends_rise(const std::vector<ContactState<double>>& states,
                                  std::vector<SampledBand<double>>& bands) {
    std::vector<std::size_t> order(states.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return states[i].pressure.value < states[j].pressure.value; });
    for (std::size_t k = 1; k < order.size(); ++k)
        bands[order[k]].high = (std::max)(bands[order[k]].high, bands[order[k - 1]].high);
    for (std::size_t k = order.size(); k > 1; --k)
        bands[order[k - 2]].low = (std::min)(bands[order[k - 2]].low, bands[order[k - 1]].low);
}

FSTIFF_INLINE SampledBand<double> band_about(double K, const Causes<double>& causes) {
    constexpr double most = (std::numeric_limits<double>::max)() / 2;  // as in_range() of a state
    const CauseSpread<double> total = band_of(causes);
    return {K * std::exp(total.low), K, (std::min)(most, K * std::exp(total.high))};
}

/// The bands of an answer, with the form that is not known and without it.
class AnswerBands {
public:
    /// Adds the band of the state \p i of \p curve by the causes of \p reason, to which that of the form comes.
    void add(const ResolvedJoint& problem, std::size_t i, const LawCurve& curve, AnswerReason& reason) {
        const double K = curve.states[i].stiffness.value;
        of_faces_.push_back(band_about(K, reason.causes));
        bands_.push_back(of_faces_.back());
        const CauseSpread<double> form = spread_of_form(problem, K, curve.states[i].pressure.value);
        if (auto& waves = reason.causes[static_cast<std::size_t>(Cause::long_waves)]; form.low < waves.low) {
            waves.low = 0;  // waves as long as the face are its form
            reason.causes[static_cast<std::size_t>(Cause::form)] = form;
            bands_.back() = band_about(K, reason.causes);
            formed_ = true;
        }
    }
    /// Gives them to \p curve.
    void give(LawCurve& curve) {
        if (formed_) {
            make_ends_rise(curve.states, of_faces_);
            curve.band = std::move(of_faces_);
            curve.faces = std::make_shared<const LawCurve>(curve);
        }
        make_ends_rise(curve.states, bands_);
        curve.band = std::move(bands_);
    }

private:
    std::vector<SampledBand<double>> bands_{}, of_faces_{};
    bool formed_ = false;
};

/// p* and the contacts of every state of \p curve.
FSTIFF_INLINE std::vector<AnswerReason> reasons_of(const ResolvedJoint& problem, const LawCurve& curve) {
    std::vector<AnswerReason> reasons;
    const double area = counted_area(problem);
    for (const auto& state : curve.states) {
        AnswerReason& reason = reasons.emplace_back();
        if (curve.rms_gradient)
            reason.p_star =
                detail::dimensionless_pressure(state.pressure.value, problem.effective_modulus, *curve.rms_gradient);
        if (const double contacts = area * state.contact_density.value; contacts > 0) reason.contacts = contacts;
    }
    return reasons;
}

FSTIFF_INLINE AnswerFacts make_answer(const ResolvedJoint& problem, const Request& request, LawCurve& curve,
                                      const AnyContact* contact, const ProgressHook& progress) {
    AnswerFacts facts{.reasons = reasons_of(problem, curve)};
    facts.relative_hardness = relative_hardness(problem);
    facts.flows = flows(problem, *curve.law);
    facts.of_map_itself = is_map_itself(problem);
    const double length = std::numbers::sqrt2 * problem.face.parameters.long_end.side;  // of a trace
    const UnmeasuredWaves<double> longer =
        problem.face.unmeasured(problem.nominal_area    ? std::sqrt(*problem.nominal_area)
                                : is_of_traces(problem) ? length
                                                        : 0);
    const double expected = request.at_separations ? 0 : longer.expected;
    facts.long_waves = std::exp(-expected);
    facts.waves_at_least = longer.at_least && problem.nominal_area.has_value();
    const bool solves = request.solves_map && is_map(problem.face);
    const std::vector<Solved> of_place = solves
                                             ? problem.face.map->solve(problem, request, facts.flows, curve, progress)
                                             : std::vector<Solved>(request.points.size());
    const double at_greatest = stiffness_at_greatest(problem, curve, facts.flows, contact);
    LightEnds light(problem, curve, contact);
    AnswerBands bands;
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        AnswerReason& reason = facts.reasons[i];
        const auto put = [&](Cause cause, const CauseSpread<double>& spread) {
            reason.causes[static_cast<std::size_t>(cause)] = spread;
        };
        if (i < curve.band.size())
            take_band(reason.causes, curve.states[i].stiffness.value, curve.band[i],
                      i < curve.band_parts.size() ? &curve.band_parts[i] : nullptr, !facts.of_map_itself);
        put(Cause::lay, of_lay(problem));
        if (reason.contacts && !facts.of_map_itself)
            put(Cause::contacts, detail::scatter_of_contacts(*reason.contacts));
        put(Cause::long_waves, spread_of_long_waves(longer.growth, expected));
        CauseSpread<double> of_law = law_error(problem, curve.law->which, reason);
        const double log_K = std::log(curve.states[i].stiffness.value);
        const double log_end = light.greatest(curve.states[i].pressure.value, log_K, log_K + of_law.high);
        of_law.high = (std::max)(of_law.high, log_end - log_K);
        put(Cause::law, of_law);
        const Solved& solved = of_place[curve.places[i]];
        if (solved.weight > 0) hand_over(problem, solved, i, curve, reason);
        if (facts.of_map_itself && problem.face.map->maps.size() > 1)
            put(Cause::measurement, scatter_of_shifts(problem, curve.states[i].stiffness));
        take_earlier_load(problem, at_greatest, solved, i, curve, reason);
        lower_by_long_waves(facts.long_waves, i, curve);
        const double K = curve.states[i].stiffness.value;
        double& loading = curve.states[i].loading_stiffness.value;  // K of an elastic contact, else no more
        loading = facts.flows ? (std::min)(loading, K) : K;
        if (facts.flows && loading > 0) reason.loading_stiffness = loading;
        bands.add(problem, i, curve, reason);
        curve.by.push_back(solved.weight >= 0.5 ? &laws::boundary_elements.row() : curve.law);
    }
    bands.give(curve);
    return facts;
}

}}}  // namespace fstiff::detail
