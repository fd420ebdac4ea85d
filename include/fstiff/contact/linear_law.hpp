// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Stiffness of elastic contact far from both ends of the load: proportional to the pressure, whatever the peaks.
///
///     K = p/(gamma sigma),  gamma = 0.48
///
/// Reference   Akarapu et al., Phys. Rev. Lett. 106 (2011) 204301; Campana et al., J. Phys. Condens. Matter 23 (2011)
///             085001
/// Units       p [Pa], sigma [m], K [Pa/m] per nominal area
/// Valid       self-affine Gaussian surfaces, elastic; p* = p/(E g_rms) from 0.008 to 0.12 (answer/checks)
/// Accuracy    a fifth of K there, a factor of 2 for p* of 0.002 to 0.25 (docs/validation.md,
///             tests/docs/validation_test.cpp)

#include <fstiff/core/error.hpp>

namespace fstiff::inline v0_1::parts {

template <Real T>
inline constexpr T linear_law_factor = T(0.48);  ///< gamma

/// K = p/(0.48 sigma) [Pa/m]. \throws domain_error unless p >= 0 and sigma > 0, both finite.
template <Real T>
[[nodiscard]] constexpr T linear_stiffness(T pressure, T rms_height) {
    require(pressure >= T(0) && pressure <= (std::numeric_limits<T>::max)(), "pressure", pressure,
            "finite and not negative");
    require_positive("rms_height", rms_height);
    return pressure / (linear_law_factor<T> * rms_height);
}

}  // namespace fstiff::inline v0_1::parts
