// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How far the elastic multi-asperity models may be believed.
///
///     psi   = (E/H) sqrt(sigma/R),  H = 2.8 Y         plasticity index: peaks yield at any load where it exceeds about 1
///     p*    = p/(E g_rms)                             pressure over what closes the gaps; models of independent peaks hold
///                                                     for p* <= 0.01 or so (docs/errata.md tells against which truth)
///     g_rms = sqrt(2 r sigma sigma_kappa)             rms gradient of an isotropic surface of the density (4.4)
///     sigma R D_p >= 0.0249                           on an isotropic Gaussian surface: 0.02036 sqrt(alpha), alpha >= 1.5
///
/// Reference   Greenwood, Williamson, Proc. R. Soc. Lond. A 295 (1966) 300-319 (psi); Greenwood, Proc. R. Soc. Lond. A 393
///             (1984) 133-157 (r = sigma_m^2/(sigma sigma_kappa), sigma_m the slope of a profile).
/// Units       SI; the numbers returned are dimensionless

#include <fstiff/contact/rough_contact.hpp>

#include <cmath>
#include <optional>

namespace fstiff {

template <Real T>
inline constexpr T minimum_gaussian_product = T(0.0249);  ///< least sigma R D_p of an isotropic Gaussian surface

template <Real T>
inline constexpr T largest_dimensionless_pressure = T(0.01);  ///< p* above which independent peaks are in doubt

/// psi for the yield strength Y [Pa] of the softer body. \throws domain_error naming what is not positive.
template <Real T>
[[nodiscard]] T plasticity_index(const Roughness<T>& surface, T effective_modulus, T yield_strength) {
    surface.validate();
    require_positive("effective_modulus", effective_modulus);
    require_positive("yield_strength", yield_strength);
    return effective_modulus / (T(2.8) * yield_strength) * std::sqrt(surface.rms_height / surface.peak_radius);
}

/// g_rms of the surface; none for r = 0, where the slopes are of another scale than heights and curvatures.
template <Real T>
[[nodiscard]] std::optional<T> rms_gradient(const Roughness<T>& surface, const PeakDensity<T>& peaks,
                                            CurvatureScale scale = {}) {
    if (peaks.r() == 0) return std::nullopt;
    return std::sqrt(2 * peaks.r() * surface.rms_height * rms_curvature(surface, peaks, scale));
}

/// p* = p/(E g_rms).
template <Real T>
[[nodiscard]] T dimensionless_pressure(T pressure, T effective_modulus, T rms_gradient) {
    return pressure / (effective_modulus * rms_gradient);
}

}  // namespace fstiff
