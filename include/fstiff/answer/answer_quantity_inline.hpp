// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The table of answer/answer_quantity.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/answer_quantity.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/tabulated/tangential_law.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// The value, or an end of its band.
enum class BandEnd { low, value, high };

/// A state of \p curve, as a quantity takes it.
struct StateOfCurve {
    const ResolvedJoint& joint;
    const LawCurve& curve;
    std::size_t i;                      ///< of the state in the curve
    const ContactState<double>& state;  ///< that of the curve, but for K at an end of its band
    BandEnd end = BandEnd::value;
};

FSTIFF_INLINE double conductance_of_gap(const Conduction& conduction, double separation) {
    return detail::gap_conductance(*conduction.gap, (std::max)(separation, 0.0)) + conduction.radiation;
}

namespace quantities {

FSTIFF_INLINE Estimate<double> scaled(const Estimate<double>& estimate, double factor) {
    return {estimate.value * factor, estimate.error * factor};
}
/// Times the nominal area.
FSTIFF_INLINE Estimate<double> of_area(const StateOfCurve& at, const Estimate<double>& estimate) {
    return scaled(estimate, at.joint.nominal_area.value_or(0));
}
FSTIFF_INLINE double ratio_of(const ResolvedJoint& joint) {  // where it is known
    return joint.upper.youngs_modulus > 0 ? tangential_ratio(joint.upper, joint.lower) : 0;
}

/// The loss factor at the tangential stiffness \p k. Of yielded contacts it has two limits, the ends; the value is
/// their mean in logarithms.
FSTIFF_INLINE double loss_of(const StateOfCurve& at, double k) {
    const double x =
        k * *at.joint.friction->amplitude / (at.joint.friction->coefficient * at.curve.states[at.i].pressure.value);
    const double elastic = detail::loss_factor(PowerUnloading<double>{at.curve.log_slopes[at.i]}, x);
    if (!flows(at.joint, *at.curve.law) || at.end == BandEnd::high) return elastic;
    const double flowed = detail::loss_factor(FlowedUnloading<double>{}, x);
    return at.end == BandEnd::low ? flowed : std::sqrt(flowed) * std::sqrt(elastic);
}
FSTIFF_INLINE Estimate<double> loss(const StateOfCurve& at) {
    const Estimate<double>& K = at.state.stiffness;
    const double ratio = ratio_of(at.joint), factor = loss_of(at, ratio * K.value);
    return {factor, std::abs(loss_of(at, ratio * (K.value + K.error)) - factor)};
}

/// |R| of waves between \p media that see \p factor K and \p film [Pa/m].
FSTIFF_INLINE Estimate<double> reflected(const StateOfCurve& at, const Impedances<double>& media, double factor,
                                         double film) {
    Estimate<double> seen = at.state.stiffness * factor;
    seen.value += film;
    return fstiff::reflection(seen, media, at.joint.ultrasound->angular());
}

/// Conductance of heat or current through the contacts and their film.
FSTIFF_INLINE Estimate<double> of_spots(const StateOfCurve& at, bool heat) {
    const Conduction& conduction = at.joint.conduction;
    const ContactState<double>& s = at.state;
    const double h = spot_conductance(s.stiffness.value, heat ? *conduction.thermal : *conduction.electrical,
                                      at.joint.effective_modulus);
    const double film =
        under_film(h, s.real_area_fraction.value, heat ? conduction.thermal_film : conduction.electrical_film);
    return {film, s.stiffness.value > 0 ? film * (s.stiffness.error / s.stiffness.value) : 0};
}
/// Conductance of the gap at the separation of \p at, with the radiation [W/(m^2 K)].
FSTIFF_INLINE double of_gap(const StateOfCurve& at) {
    return at.joint.conduction.gap ? conductance_of_gap(at.joint.conduction, at.state.separation.value) : 0;
}
/// 1/((h + \p gap) A), of the conductance \p h of the contacts.
FSTIFF_INLINE Estimate<double> resistance(const StateOfCurve& at, const Estimate<double>& h, double gap) {
    const double resistance = 1 / ((h.value + gap) * at.joint.nominal_area.value_or(0));
    return {resistance, resistance * h.error / (h.value + gap)};
}

/// The load over the real area; NaN where the law gives no area.
FSTIFF_INLINE Estimate<double> mean_on_spots(const StateOfCurve& at) {
    const Estimate<double>&p = at.state.pressure, &area = at.state.real_area_fraction;
    if (!(area.value > 0)) return {std::numeric_limits<double>::quiet_NaN(), 0};
    const double mean = p.value / area.value;
    return {mean, mean * (p.error / p.value + area.error / area.value)};
}

FSTIFF_INLINE bool conducts_heat(const ResolvedJoint& joint) {
    return joint.conduction.thermal && (joint.conduction.gap || joint.is_given.heat);
}
FSTIFF_INLINE bool conducts_current(const ResolvedJoint& joint) {
    return joint.conduction.electrical && joint.is_given.current;
}
FSTIFF_INLINE bool always(const ResolvedJoint&) { return true; }
FSTIFF_INLINE bool of_force(const ResolvedJoint& joint) { return joint.is_given.force; }
FSTIFF_INLINE bool has_form(const ResolvedJoint& joint) { return joint.flatness || joint.form; }

using enum AnswerQuantity::WithStiffness;
using Q = AnswerQuantity;
using At = const StateOfCurve&;
using OfJoint = const ResolvedJoint&;
using Number = Estimate<double>;
// clang-format off
inline constexpr std::array table{
    Q{.word = "force", .name = "force", .suffix = "_N", .unit = "N", .symbol = "F", .needs = Q::area,
      .value = [](At at) { return of_area(at, at.state.pressure); }},
    Q{.word = "pressure", .name = "pressure", .suffix = "_Pa", .unit = "Pa", .symbol = "p",
      .value = [](At at) { return at.state.pressure; }},
    Q{.word = "eta", .name = "eta", .symbol = "eta", .of_law = Quantity::separation,
      .value = [](At at) { return Number{at.state.eta, 0}; }},
    Q{.word = "separation", .place = 2, .name = "separation", .suffix = "_m", .unit = "m", .symbol = "separation",
      .of_law = Quantity::separation, .value = [](At at) { return at.state.separation; }, .is_usual = always},
    Q{.word = "approach", .place = 10, .name = "approach", .suffix = "_m", .unit = "m", .symbol = "approach",
      .of_law = Quantity::separation,
      .value = [](At at) { return Number{at.curve.separation_at_seating[at.i] - at.state.separation.value, 0}; },
      .is_usual = of_force},
    Q{.word = "stiffness", .place = 1, .name = "stiffness", .suffix = "_Pa_per_m", .unit = "Pa/m",
      .symbol = "K/A0", .of_law = Quantity::stiffness, .with_stiffness = rises,
      .value = [](At at) { return at.state.stiffness; }, .is_usual = always},
    Q{.word = "stiffness_of_faces", .place = 17, .name = "stiffness_of_faces", .suffix = "_Pa_per_m", .unit = "Pa/m",
      .symbol = "K/A0 of faces", .of_law = Quantity::stiffness, .with_stiffness = rises, .needs = Q::form,
      .value = [](At at) { return at.state.stiffness; }, .is_usual = has_form, .of_faces = true},
    Q{.word = "touching_share", .place = 18, .name = "touching_share", .symbol = "touching", .needs = Q::form,
      .value = [](At at) { return Number{at.curve.form.empty() ? 1 : at.curve.form[at.i].touching_share, 0}; },
      .is_usual = has_form},
    Q{.word = "local_pressure", .place = 19, .name = "greatest_local_pressure", .suffix = "_Pa", .unit = "Pa",
      .symbol = "greatest p", .needs = Q::form,
      .value = [](At at) {
          return Number{at.curve.form.empty() ? at.state.pressure.value
                                              : at.curve.form[at.i].greatest_local_pressure, 0}; },
      .is_usual = has_form},
    Q{.word = "joint_stiffness", .place = 9, .name = "stiffness", .suffix = "_N_per_m", .unit = "N/m",
      .symbol = "K", .of_law = Quantity::stiffness, .with_stiffness = rises, .needs = Q::area,
      .value = [](At at) { return of_area(at, at.state.stiffness); }, .is_usual = of_force},
    Q{.word = "loading_stiffness", .place = 8, .name = "loading_stiffness", .suffix = "_Pa_per_m", .unit = "Pa/m",
      .symbol = "-dp/dd", .of_law = Quantity::loading_stiffness,
      .value = [](At at) { return at.state.loading_stiffness; }},
    Q{.word = "tangential_stiffness", .place = 5, .name = "tangential_stiffness", .suffix = "_Pa_per_m",
      .unit = "Pa/m", .symbol = "Kt/A0", .of_law = Quantity::stiffness, .with_stiffness = rises,
      .needs = Q::bodies, .value = [](At at) { return scaled(at.state.stiffness, ratio_of(at.joint)); },
      .is_usual = [](OfJoint joint) { return joint.ultrasound.has_value() || joint.friction.has_value(); }},
    Q{.word = "loss_factor", .place = 13, .name = "loss_factor", .symbol = "loss factor",
      .of_law = Quantity::stiffness, .with_stiffness = rises, .needs = Q::slip | Q::bodies, .value = loss,
      .is_usual = [](OfJoint joint) { return joint.friction && joint.friction->amplitude; },
      .title = "Loss factor of a tangential cycle"},
    Q{.word = "reflection", .place = 6, .name = "reflection", .symbol = "|R|", .of_law = Quantity::stiffness,
      .with_stiffness = falls, .needs = Q::waves,
      .value = [](At at) {
          return reflected(at, at.joint.ultrasound->longitudinal, 1, at.joint.ultrasound->film_stiffness); },
      .is_usual = [](OfJoint joint) { return joint.ultrasound.has_value(); },
      .title = "Reflection of longitudinal waves", .of_faces = true},
    Q{.word = "shear_reflection", .place = 7, .name = "shear_reflection", .symbol = "shear |R|",
      .of_law = Quantity::stiffness, .with_stiffness = falls, .needs = Q::waves | Q::shear_waves | Q::bodies,
      .value = [](At at) { return reflected(at, *at.joint.ultrasound->shear, ratio_of(at.joint), 0); },
      .is_usual = [](OfJoint joint) { return joint.ultrasound && joint.ultrasound->shear; },
      .title = "Reflection of shear waves", .of_faces = true},
    Q{.word = "thermal_conductance", .place = 11, .name = "thermal_conductance", .suffix = "_W_per_m2K",
      .unit = "W/(m^2 K)", .symbol = "h", .of_law = Quantity::stiffness, .with_stiffness = rises,
      .needs = Q::heat, .value = [](At at) { return of_spots(at, true); }, .is_usual = conducts_heat,
      .title = "Thermal conductance of the contacts", .of_heat = true},
    Q{.word = "thermal_conductance_gap", .name = "thermal_conductance_gap", .suffix = "_W_per_m2K",
      .unit = "W/(m^2 K)", .symbol = "h of the gap", .of_law = Quantity::separation, .needs = Q::gap,
      .value = [](At at) { return Number{of_gap(at), 0}; }, .title = "Thermal conductance of the gap", .with = "thermal_conductance"},
    Q{.word = "electrical_conductance", .place = 12, .name = "electrical_conductance", .suffix = "_S_per_m2",
      .unit = "S/m^2", .symbol = "electrical h", .of_law = Quantity::stiffness, .with_stiffness = rises,
      .needs = Q::current, .value = [](At at) { return of_spots(at, false); }, .is_usual = conducts_current,
      .title = "Electrical conductance of the contacts"},
    Q{.word = "thermal_resistance", .place = 14, .name = "thermal_resistance", .suffix = "_K_per_W", .unit = "K/W",
      .symbol = "thermal resistance", .of_law = Quantity::stiffness, .with_stiffness = falls,
      .needs = Q::area | Q::heat,
      .value = [](At at) { return resistance(at, of_spots(at, true), of_gap(at)); },
      .is_usual = [](OfJoint joint) { return joint.nominal_area && conducts_heat(joint); }, .of_heat = true},
    Q{.word = "resistance", .place = 15, .name = "resistance", .suffix = "_ohm", .unit = "ohm",
      .symbol = "resistance", .of_law = Quantity::stiffness, .with_stiffness = falls,
      .needs = Q::area | Q::current, .value = [](At at) { return resistance(at, of_spots(at, false), 0); },
      .is_usual = [](OfJoint joint) { return joint.nominal_area && conducts_current(joint); }},
    Q{.word = "real_area", .place = 3, .name = "real_area_fraction", .symbol = "real area",
      .of_law = Quantity::real_area_fraction, .value = [](At at) { return at.state.real_area_fraction; },
      .is_usual = always},
    Q{.word = "spot_pressure", .place = 16, .name = "spot_pressure", .suffix = "_Pa", .unit = "Pa",
      .symbol = "p of the contacts", .of_law = Quantity::real_area_fraction,
      .value = mean_on_spots},
    Q{.word = "contacts", .place = 4, .name = "contacts", .suffix = "_per_m2", .unit = "1/m^2",
      .symbol = "contacts", .of_law = Quantity::contact_density,
      .value = [](At at) { return at.state.contact_density; }, .is_usual = always},
};
// clang-format on

}  // namespace quantities

FSTIFF_INLINE const AnswerQuantity* find_quantity(std::string_view word) {
    const auto all = answer_quantities();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.word == word; });
    return found == all.end() ? nullptr : &*found;
}

FSTIFF_INLINE const AnswerQuantity& quantity_called(std::string_view word, std::string_view name) {
    if (const AnswerQuantity* found = find_quantity(word)) return *found;
    std::string words;
    for (const AnswerQuantity& each : answer_quantities())
        words += (words.empty() ? "" : ", ") + std::string(each.word);
    throw domain_error(Refusal{.parameter = std::string(name),
                               .value = "\"" + std::string(word.substr(0, 40)) + "\"",
                               .allowed = "one of " + words});
}

FSTIFF_INLINE AnswerQuantity::Need lack_of(const AnswerQuantity& quantity, const ResolvedJoint& joint) {
    const auto has = [&](AnswerQuantity::Need need) {
        switch (need) {
            case AnswerQuantity::area: return joint.nominal_area.has_value();
            case AnswerQuantity::waves: return joint.ultrasound.has_value();
            case AnswerQuantity::shear_waves: return joint.ultrasound && joint.ultrasound->shear;
            case AnswerQuantity::slip: return joint.friction && joint.friction->amplitude;
            case AnswerQuantity::heat: return joint.conduction.thermal.has_value();
            case AnswerQuantity::current: return joint.conduction.electrical.has_value();
            case AnswerQuantity::gap: return joint.conduction.gap.has_value();
            case AnswerQuantity::form: return quantities::has_form(joint);
            case AnswerQuantity::bodies: return joint.upper.youngs_modulus > 0;
            case AnswerQuantity::nothing: break;
        }
        return true;
    };
    for (unsigned bit = 1; bit <= AnswerQuantity::form; bit *= 2)
        if (const auto need = static_cast<AnswerQuantity::Need>(bit); (quantity.needs & bit) != 0 && !has(need))
            return need;
    return AnswerQuantity::nothing;
}

}  // namespace detail

FSTIFF_INLINE std::span<const AnswerQuantity> answer_quantities() { return detail::quantities::table; }

FSTIFF_INLINE std::string AnswerQuantity::key(std::string_view part) const {
    return std::string(name).append(part).append(suffix);
}

}}  // namespace fstiff
