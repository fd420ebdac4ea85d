// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What follows from K of a contact: tangential stiffness and loss, reflection, conductance of heat and current.

#include <fstiff/answer/curves.hpp>

#include <cstddef>

namespace fstiff { inline namespace v0_1 { namespace detail {

enum class Derived {
    tangential_stiffness,   ///< [Pa/m], by Mindlin's ratio
    loss_factor,            ///< [1] of a cycle of Friction::amplitude
    reflection,             ///< |R| [1] of longitudinal waves
    shear_reflection,       ///< of shear waves
    thermal_conductance,    ///< of the spots and their film [W/(m^2 K)]
    electrical_conductance  ///< [S/m^2]
};
/// The value, or an end of its band.
enum class BandEnd { low, value, high };

/// Whether \p quantity falls as K rises.
[[nodiscard]] constexpr bool falls(Derived quantity) {
    return quantity == Derived::reflection || quantity == Derived::shear_reflection;
}
/// Whether \p problem has what \p quantity needs in addition to K.
[[nodiscard]] bool can_derive(Derived quantity, const ResolvedJoint& problem);
/// \p quantity at the state \p i of \p curve with the K of \p state, which differs at an end of the band. The loss of
/// yielded spots has two limits, the ends; its value is their mean in logarithms.
[[nodiscard]] Estimate<double> derived(Derived quantity, const ResolvedJoint& problem, const LawCurve& curve,
                                       std::size_t i, const ContactState<double>& state, BandEnd end);
/// Conductance of the gap at \p separation [m], with the radiation [W/(m^2 K)].
[[nodiscard]] double conductance_of_gap(const Conduction& conduction, double separation);

}}}  // namespace fstiff::detail
