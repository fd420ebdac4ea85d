// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The answer of a joint whose faces are not flat: the law of the faces under the local pressures of its form.
///
///     K of the joint          halfspace/formed_joint, at the value and at both ends of the band of the faces
///     form not known          low end: faces in series with a crown of the height F, F/b by the process
///     form by its height      -0.5 (1 - k) to 1.3 (1 - k)^1.5 of ln K, k: K of the crown over that of the faces
///
/// Reference   Johnson, Contact Mechanics (1985), section 4.2 (contact of a crown); F/b of joints of metals, half of
///             them held back: docs/published.md; other shapes by boundary elements of the form
/// Units       SI; b half the side of the nominal area, or half the width of a ring [m]
/// Valid       pressures; F, b > 0

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/halfspace/formed_joint.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The law of an answer over ln p as FormedJoint takes it, from a table at equal steps.
class LawOfFaces {
public:
    /// \p curve has two states at least, whose pressures rise.
    explicit LawOfFaces(const LawCurve& curve) {
        std::vector<std::pair<double, double>> stiffness, loading;
        for (const ContactState<double>& state : curve.states) {
            const double x = std::log(state.pressure.value), K = state.stiffness.value;
            stiffness.emplace_back(x, std::log(K));
            loading.emplace_back(x, std::log(state.loading_stiffness.value > 0 ? state.loading_stiffness.value : K));
        }
        const RisingCurve of_stiffness(stiffness), of_loading(loading);
        first_ = stiffness.front().first;
        const double length = stiffness.back().first - first_;
        const auto last = static_cast<std::size_t>(std::ceil(length / most_step));
        step_ = length / static_cast<double>(last);
        double closure = 0;
        for (std::size_t i = 0; i <= last; ++i) {
            const double x = first_ + step_ * static_cast<double>(i);
            if (i > 0) closure += of_loading.fall(x - step_, x);
            table_.push_back({closure, std::exp(of_stiffness.at(x)), std::exp(of_loading.at(x))});
        }
    }
    /// The same with K, and as much -dp/dd, \p factor times as great, and K alone \p flattened times more: by an
    /// earlier load, which leaves the closure of the first one.
    [[nodiscard]] LawOfFaces times(double factor, double flattened) const {
        LawOfFaces other = *this;
        other.factor_ *= factor, other.flattened_ *= flattened;
        return other;
    }
    [[nodiscard]] LocalContact operator()(double p) const {
        const double place = (std::log(p) - first_) / step_, last = static_cast<double>(table_.size() - 1),
                     inside = std::clamp(place, 0.0, last);
        const auto i = static_cast<std::size_t>((std::min)(inside, last - 1));
        const LocalContact &a = table_[i], &b = table_[i + 1];
        const double t = inside - static_cast<double>(i),
                     from = step_ * std::exp(first_ + step_ * static_cast<double>(i)),
                     left = from / a.loading_stiffness, right = from * std::exp(step_) / b.loading_stiffness,
                     rise = b.closure - a.closure;
        LocalContact at{a.closure + t * (left + t * (3 * rise - 2 * left - right + t * (left + right - 2 * rise))),
                        std::exp(std::lerp(std::log(a.stiffness), std::log(b.stiffness), t)),
                        std::exp(std::lerp(std::log(a.loading_stiffness), std::log(b.loading_stiffness), t))};
        if (place != inside) {  // K goes on in proportion to p
            const double ratio = std::exp(step_ * (place - inside)), end = p / ratio;
            at.closure += end / at.loading_stiffness * std::log(ratio);
            at.stiffness *= ratio, at.loading_stiffness *= ratio;
        }
        return {at.closure / factor_, at.stiffness * factor_ * flattened_, at.loading_stiffness * factor_};
    }

private:
    static constexpr double most_step = 0.1;
    std::vector<LocalContact> table_{};
    double first_ = 0, step_ = 0, factor_ = 1, flattened_ = 1;
};

/// Half the width of the faces [m]: of the ring, or of the square with the nominal area.
FSTIFF_INLINE double half_width(const ResolvedJoint& problem) {
    return problem.ring ? (problem.ring->outer - problem.ring->inner) / 4 : std::sqrt(*problem.nominal_area) / 2;
}

/// K of faces with the stiffness \p K [Pa/m] under \p pressure [Pa] whose gap is a crown of the height \p flatness [m]
/// over the half width \p b [m], by a patch of Hertz in series, over \p K.
FSTIFF_INLINE double share_of_crown(double K, double pressure, double flatness, double b, double effective_modulus) {
    const double x =
        std::cbrt(0.92 * (pressure / effective_modulus) * (b / flatness));  // of the half width that touches
    if (!(x < 1)) return 1;
    const double patch = 2 * effective_modulus / (std::numbers::pi * b) * x / ((1 - x) * std::sqrt(1 - x));
    return 1 / (1 + K / patch);
}

FSTIFF_INLINE CauseSpread<double> spread_of_form(const ResolvedJoint& problem, double K, double pressure) {
    if (!problem.nominal_area || problem.flatness || problem.form) return {};
    if (measured_side(problem) > 0.99 * std::sqrt(*problem.nominal_area)) return {};
    const std::vector<const Face*> faces = rough_faces(problem);
    const bool fine = std::all_of(faces.begin(), faces.end(), [](const Face* face) {
        return face->process == Process::ground || face->process == Process::lapped ||
               face->process == Process::honed || face->process == Process::polished ||
               face->process == Process::superfinished;
    });
    const double b = half_width(problem), greatest = fine ? 3e-4 : 3e-3;  // F/b, 95 %
    return {std::log(share_of_crown(K, pressure, greatest * b, b, problem.effective_modulus)), 0};
}

/// Pressures [Pa] at which the law of the faces of \p curve is taken: six a decade, from 1e-4 of the least to 1e3
/// times the greatest.
FSTIFF_INLINE std::vector<double> local_pressures(const LawCurve& curve) {
    constexpr double a_decade = 6;
    const auto by_pressure = [](const auto& a, const auto& b) { return a.pressure.value < b.pressure.value; };
    const auto [least, greatest] = std::minmax_element(curve.states.begin(), curve.states.end(), by_pressure);
    const double from = 1e-4 * least->pressure.value, decades = std::log10(1e3 * greatest->pressure.value / from);
    std::vector<double> pressures;
    for (int k = 0; k <= static_cast<int>(std::ceil(a_decade * decades)); ++k)
        pressures.push_back(from * std::pow(10.0, k / a_decade));
    return pressures;
}

/// Gives the state \p i of \p curve, with its \p reason, the form of \p problem, where the faces have the law \p law.
FSTIFF_INLINE void take_form(const ResolvedJoint& problem, const LawOfFaces& law, std::size_t i, LawCurve& curve,
                             AnswerReason& reason) {
    ContactState<double>& state = curve.states[i];  // with its K of the faces
    SampledBand<double>& band = curve.band[i];
    const double p = state.pressure.value, K = state.stiffness.value, ratio = K / law(p).stiffness;
    const bool carried = problem.greatest_pressure.value_or(0) > p && state.loading_stiffness.value == K;
    const auto solved = [&](double end) {
        const LawOfFaces at = law.times((carried ? 1 : ratio) * end / K, carried ? ratio : 1);
        return FormedJoint(*problem.form, at, problem.effective_modulus).at_pressure(p);
    };
    constexpr double most = 1e6;  // times K: an infinite end
    const double low = band.low, high = (std::min)(band.high, most * K);
    const FormedJointState value = solved(K), soft = low < K ? solved(low) : value,
                           stiff = high > K ? solved(high) : value;
    const double share = value.stiffness / K, away = (std::max)(0.0, 1 - share);
    for (CauseSpread<double>& cause : reason.causes) {
        if (low < K) cause.low *= std::log(soft.stiffness / value.stiffness) / std::log(low / K);
        if (high > K) cause.high *= std::log(stiff.stiffness / value.stiffness) / std::log(high / K);
    }
    if (problem.flatness)
        reason.causes[static_cast<std::size_t>(Cause::form)] = {-0.5 * away, 1.3 * away * std::sqrt(away)};
    state.stiffness = {value.stiffness, state.stiffness.error * share};
    state.loading_stiffness.value = carried ? value.stiffness : (std::min)(value.loading_stiffness, value.stiffness);
    if (reason.loading_stiffness) reason.loading_stiffness = state.loading_stiffness.value;
    curve.form.push_back({value.touching_share, value.greatest_pressure_over_mean * p});
    band = band_about(value.stiffness, reason.causes);
}

FSTIFF_INLINE void add_form(const ResolvedJoint& problem, const Request& request,
                            const std::vector<MadeContact>* contacts, Curves& result) {
    LawCurve& curve = *result.answer;
    if (curve.states.empty()) return;
    if (request.at_separations)
        throw domain_error(Refusal{.parameter = "flatness", .reason = "must not be given with separations"});
    curve.faces = std::make_shared<const LawCurve>(curve);
    Request local{.points = local_pressures(curve),
                  .separation = false,
                  .samples = 0,
                  .solves_map = false,
                  .checked = false,
                  .parallel = request.parallel};
    for (std::size_t i = 0; i < local.points.size(); ++i) local.answered.push_back(i);
    ResolvedJoint flat = problem;
    flat.form.reset();
    flat.flatness = 0, flat.greatest_pressure.reset();
    Curves of_faces;
    add_answer(std::move(flat), std::move(local), {}, contacts, of_faces);
    const LawOfFaces law(*of_faces.answer);
    for (std::size_t i = 0; i < curve.states.size(); ++i) take_form(problem, law, i, curve, result.facts.reasons[i]);
    make_ends_rise(curve.states, curve.band);
}

}}}  // namespace fstiff::detail
