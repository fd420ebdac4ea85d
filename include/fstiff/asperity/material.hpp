// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Elastic constants of the two bodies and the modulus of their contact.
///
///     1/E = (1 - nu1^2)/E1 + (1 - nu2^2)/E2                                         eq. (3.15)
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eq. (3.15).
/// Units       moduli [Pa], Poisson's ratio dimensionless
/// Valid       modulus > 0, -1 < nu <= 0.5
/// Accuracy    3 ulp (tests/asperity/material_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/surface/process_prior.hpp>

namespace fstiff { inline namespace v0_1 {

/// Elastic constants of one body.
template <Real T = double>
struct Material {
    T youngs_modulus{};  ///< E_i [Pa], > 0
    T poisson_ratio{};   ///< nu_i, in (-1, 0.5]
};

/// Effective modulus E of the contact of \p upper and \p lower [Pa].
/// \throws domain_error naming the constant that is out of range.
template <Real T>
[[nodiscard]] constexpr T effective_modulus(const Material<T>& upper, const Material<T>& lower) {
    const auto compliance = [](const Material<T>& m) {
        detail::require_positive("youngs_modulus", m.youngs_modulus);
        detail::require(m.poisson_ratio > T(-1) && m.poisson_ratio <= T(0.5), "poisson_ratio", m.poisson_ratio,
                        "greater than -1 and at most 0.5");
        return (1 - m.poisson_ratio) * (1 + m.poisson_ratio) / m.youngs_modulus;
    };
    return 1 / (compliance(upper) + compliance(lower));
}

}}  // namespace fstiff
