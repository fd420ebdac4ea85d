// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reasons to doubt a result: each with its numbers and its limit. answer/checks.hpp makes them.

#include <fstiff/core/numbers.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

namespace fstiff { inline namespace v0_1 {

/// Reasons to doubt a result.
enum class Concern {
    plasticity,              ///< psi above 1: the peaks yield at first loading
    gaussian_surface,        ///< sigma R D_p below what an isotropic Gaussian surface can have
    interacting_asperities,  ///< p* above 0.01
    mean_planes_crossed,     ///< the separation is below 0
    above_highest_peak,      ///< the separation is above R_p
    few_contacts,            ///< fewer than 10 on the nominal area
    area_above_nominal,      ///< the real area exceeds the nominal one
    above_hardness,          ///< the mean pressure on the real area exceeds 2.8 Y
    not_converged,           ///< the error of K is above 1e-6 K
    implausible_gradient,    ///< an rms gradient above 1 or below 1e-6: a unit of length is likely wrong
    height_unit,             ///< an rms height above 1 mm: a unit is likely wrong
    modulus_unit,            ///< a modulus below 1 kPa: the same
    pressure_unit,           ///< pressures below 1e-9 of the effective modulus: the same
    unknown_height,          ///< sigma is not known to a factor of two
    lay,                     ///< a profile across a lay does not determine K, which may be so many times higher
    missing_points,          ///< of a map, whose numbers answer in its place
    beyond_comparison,       ///< law plastic nearer to the hardness than any comparison of it
    no_state,                ///< the law does not reach a point
    noise,                   ///< of the instrument in a map, above 5 % of its rms height
    unknown_gradient         ///< the rms gradient is not known to a factor of two
};

/// The word of \p concern, as JSON has it.
[[nodiscard]] constexpr std::string_view name_of(Concern concern) {
    constexpr std::array<std::string_view, 20> names{"plasticity",
                                                     "gaussian_surface",
                                                     "interacting_asperities",
                                                     "mean_planes_crossed",
                                                     "above_highest_peak",
                                                     "few_contacts",
                                                     "area_above_nominal",
                                                     "above_hardness",
                                                     "not_converged",
                                                     "implausible_gradient",
                                                     "height_unit",
                                                     "modulus_unit",
                                                     "pressure_unit",
                                                     "unknown_height",
                                                     "lay",
                                                     "missing_points",
                                                     "beyond_comparison",
                                                     "no_state",
                                                     "noise",
                                                     "unknown_gradient"};
    return names[static_cast<std::size_t>(concern)];
}

/// One check of a surface, or of all states of a curve.
template <Real T = double>
struct Check {
    Concern concern{};
    T limit{};                                     ///< limit of the values; infinite for a hardness that is not known
    T least = std::numeric_limits<T>::infinity(),  ///< of the values; infinite when there are none
        greatest = -std::numeric_limits<T>::infinity();
    std::size_t violations{};  ///< states at which the check does not hold; 1 of a surface
    std::size_t first{};       ///< state of them; meaningless without any

    [[nodiscard]] bool holds() const { return violations == 0; }
};

}}  // namespace fstiff
