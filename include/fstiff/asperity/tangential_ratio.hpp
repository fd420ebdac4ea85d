// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Tangential over normal stiffness of elastic contacts that stick: Mindlin's ratio, as a shear wave meets it.
///
///     k_t/k_n = 2 (1-nu)/(2-nu)                                                                            like bodies
///     k_t/k_n = 2 [(1-nu1)/G1 + (1-nu2)/G2] / [(2-nu1)/G1 + (2-nu2)/G2],   G_i = E_i/(2 (1+nu_i))        unlike bodies
///
/// k_n = 2 E a and k_t = 8 a / [(2-nu1)/G1 + (2-nu2)/G2] for a circle of radius a whatever the load, so that the ratio
/// is the same for every contact of a rough surface and for their sum: K_t = ratio K of the elastic laws. A stiff body
/// against a soft one has the ratio of the soft one. The oscillations must be too small for slip, as those of
/// ultrasound.
///
/// Reference   Mindlin, J. Appl. Mech. 16 (1949) 259-268; Johnson, Contact Mechanics (1985), section 7.2.
/// Units       dimensionless
/// Valid       moduli > 0, -1 < nu <= 0.5; the ratio is between 2/3 and 4/3, from 2/3 to 1 for nu >= 0
/// Accuracy    5 ulp (tests/asperity/mindlin_test.cpp)

#include <fstiff/asperity/material.hpp>

namespace fstiff { inline namespace v0_1 {

/// K_t/K_n of contacts between \p upper and \p lower. \throws domain_error naming the constant that is out of range.
template <Real T>
[[nodiscard]] constexpr T tangential_ratio(const Material<T>& upper, const Material<T>& lower) {
    static_cast<void>(effective_modulus(upper, lower));  // checks the ranges
    // Shares of the softer body's 1/G, so that extreme moduli neither overflow nor vanish.
    const T g1 = upper.youngs_modulus / (1 + upper.poisson_ratio);
    const T g2 = lower.youngs_modulus / (1 + lower.poisson_ratio);
    const T least = g1 < g2 ? g1 : g2;
    const T w1 = least / g1, w2 = least / g2;
    return 2 * ((1 - upper.poisson_ratio) * w1 + (1 - lower.poisson_ratio) * w2) /
           ((2 - upper.poisson_ratio) * w1 + (2 - lower.poisson_ratio) * w2);
}

}}  // namespace fstiff
