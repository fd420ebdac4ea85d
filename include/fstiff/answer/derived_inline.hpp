// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/derived.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/derived.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/tabulated/tangential_law.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Conductance of heat or current through the spots of \p s and their film.
FSTIFF_INLINE Estimate<double> conductance_of_spots(bool heat, const ResolvedJoint& problem,
                                                    const ContactState<double>& s) {
    const Conduction& conduction = problem.conduction;
    const double h = spot_conductance(s.stiffness.value, heat ? *conduction.thermal : *conduction.electrical,
                                      problem.effective_modulus);
    const double film =
        under_film(h, s.real_area_fraction.value, heat ? conduction.thermal_film : conduction.electrical_film);
    return {film, s.stiffness.value > 0 ? film * (s.stiffness.error / s.stiffness.value) : 0};
}

FSTIFF_INLINE double loss_of(const ResolvedJoint& problem, const LawCurve& curve, std::size_t i,
                             double tangential_stiffness, BandEnd end) {
    const double x = tangential_stiffness * *problem.friction->amplitude /
                     (problem.friction->coefficient * curve.states[i].pressure.value);
    const double elastic = detail::loss_factor(PowerUnloading<double>{curve.log_slopes[i]}, x);
    if (!flows(problem, *curve.law) || end == BandEnd::high) return elastic;
    const double flowed = detail::loss_factor(FlowedUnloading<double>{}, x);
    return end == BandEnd::low ? flowed : std::sqrt(flowed) * std::sqrt(elastic);
}

FSTIFF_INLINE bool can_derive(Derived quantity, const ResolvedJoint& problem) {
    const bool elastic = problem.upper.youngs_modulus > 0;
    switch (quantity) {
        case Derived::tangential_stiffness: return elastic;
        case Derived::loss_factor: return elastic && problem.friction && problem.friction->amplitude;
        case Derived::reflection: return problem.ultrasound.has_value();
        case Derived::shear_reflection: return elastic && problem.ultrasound && problem.ultrasound->shear;
        case Derived::thermal_conductance: return problem.conduction.thermal.has_value();
        case Derived::electrical_conductance: return problem.conduction.electrical.has_value();
    }
    return false;
}

FSTIFF_INLINE Estimate<double> derived(Derived quantity, const ResolvedJoint& problem, const LawCurve& curve,
                                       std::size_t i, const ContactState<double>& s, BandEnd end) {
    const double ratio =
        problem.upper.youngs_modulus > 0 ? tangential_ratio(problem.upper, problem.lower) : 0;  // where it is known
    const auto reflected = [&](const Impedances<double>& media, double factor, double film) {
        Estimate<double> seen = s.stiffness * factor;
        seen.value += film;
        return fstiff::reflection(seen, media, problem.ultrasound->angular());
    };
    const auto loss = [&](double K) { return loss_of(problem, curve, i, ratio * K, end); };
    switch (quantity) {
        case Derived::tangential_stiffness: return {ratio * s.stiffness.value, ratio * s.stiffness.error};
        case Derived::loss_factor: {
            const double factor = loss(s.stiffness.value);
            return {factor, std::abs(loss(s.stiffness.value + s.stiffness.error) - factor)};
        }
        case Derived::reflection:
            return reflected(problem.ultrasound->longitudinal, 1, problem.ultrasound->film_stiffness);
        case Derived::shear_reflection: return reflected(*problem.ultrasound->shear, ratio, 0);
        case Derived::thermal_conductance: return conductance_of_spots(true, problem, s);
        case Derived::electrical_conductance: return conductance_of_spots(false, problem, s);
    }
    return {};
}

FSTIFF_INLINE double conductance_of_gap(const Conduction& conduction, double separation) {
    return detail::gap_conductance(*conduction.gap, (std::max)(separation, 0.0)) + conduction.radiation;
}

}}}  // namespace fstiff::detail
