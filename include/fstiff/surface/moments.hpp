// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Spectral moments of a profile of an isotropic surface, and the radius and density of its peaks.
///
///     m0 = sigma^2      m2 = g^2/2      m4 = sigma_kappa^2      alpha = m0 m4/m2^2
///     R sigma_kappa = 3 sqrt(pi)/8                               eq. (4.10) of the reference paper
///     D_p = m4/(6 pi sqrt(3) m2)                                 Nayak (1971)
///
/// Reference   Nayak, J. Lubr. Technol. 93 (1971) 398; Bush, Gibson, Thomas, Wear 35 (1975) 87; Buczkowski, Kleiber,
///             Starzynski, Arch. Mech. 66 (2014), eq. (4.10).
/// Units       m0 [m^2], m2 dimensionless, m4 [1/m^2]
/// Valid       all finite and greater than 0
/// Accuracy    4 ulp (tests/surface/moments_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/surface/fractal.hpp>

#include <cmath>
#include <numbers>

// Roughness parameters of one nominally flat surface, as in Table 1 of the reference paper.
//
// Units       SI
// Valid       every length and density finite and > 0; max_peak_height 0 when it is not known

namespace fstiff { inline namespace v0_1 {

/// A rough surface in four numbers.
template <Real T = double>
struct Roughness {
    T rms_height{};       ///< sigma = R_q [m]
    T peak_radius{};      ///< R, mean radius of curvature at the peaks [m]
    T peak_density{};     ///< D_p, peaks per nominal area [1/m^2]
    T max_peak_height{};  ///< R_p, highest peak above the mean plane [m]; 0: not known

    /// \throws domain_error naming the first parameter that is out of range.
    constexpr void validate() const {
        detail::require_positive("rms_height", rms_height);
        detail::require_positive("peak_radius", peak_radius);
        detail::require_positive("peak_density", peak_density);
        if (max_peak_height != T(0)) detail::require_positive("max_peak_height", max_peak_height);
    }
};

/// Moments of the spectrum of a profile, or of any section of an isotropic surface.
template <Real T = double>
struct SpectralMoments {
    T m0{};  ///< mean square height [m^2]
    T m2{};  ///< mean square slope of a profile: half the square of the surface's rms gradient
    T m4{};  ///< mean square curvature of a profile [1/m^2]

    /// Nayak's alpha.
    [[nodiscard]] T bandwidth() const { return (m0 / m2) * (m4 / m2); }
    /// Moments of the sum of two independent surfaces.
    [[nodiscard]] SpectralMoments operator+(const SpectralMoments& other) const {
        return {m0 + other.m0, m2 + other.m2, m4 + other.m4};
    }
};

namespace detail {

template <Real T>
inline constexpr T min_plausible_gradient = T(1e-6);  ///< rms gradient below which a unit of length is likely wrong
template <Real T>
inline constexpr T max_plausible_gradient = T(1);  ///< and above which

/// Whether \p rms_gradient [1] is plausible for a rough surface; else a unit is likely wrong. False for NaN.
template <Real T>
[[nodiscard]] constexpr bool is_plausible_gradient(T rms_gradient) {
    return rms_gradient >= min_plausible_gradient<T> && rms_gradient <= max_plausible_gradient<T>;
}

/// R sigma_kappa = 3 sqrt(pi)/8, eq. (4.10).
template <Real T>
[[nodiscard]] T radius_times_rms_curvature() {
    return 3 * std::sqrt(std::numbers::pi_v<T>) / 8;
}

/// Moments from the mean peak radius R [m] and the density of peaks D_p [1/m^2] of a surface of rms height
/// \p rms_height [m].
/// \throws domain_error unless all are finite and positive.
template <Real T>
[[nodiscard]] SpectralMoments<T> moments_of_peaks(T rms_height, T peak_radius, T peak_density) {
    require_positive("rms_height", rms_height);
    require_positive("peak_radius", peak_radius);
    require_positive("peak_density", peak_density);
    const T curvature = detail::radius_times_rms_curvature<T>() / peak_radius, m4 = curvature * curvature;
    return {rms_height * rms_height, m4 / (6 * std::numbers::pi_v<T> * std::sqrt(T(3)) * peak_density), m4};
}

/// Moments from the rms gradient g of the surface and Nayak's alpha: m2 = g^2/2, m4 = alpha m2^2/m0.
/// \throws domain_error unless all are finite and positive.
template <Real T>
[[nodiscard]] SpectralMoments<T> moments_of_gradient(T rms_height, T rms_gradient, T alpha) {
    require_positive("rms_height", rms_height);
    require_positive("rms_gradient", rms_gradient);
    require_positive("alpha", alpha);
    const T m0 = rms_height * rms_height, m2 = rms_gradient * rms_gradient / 2;
    return {m0, m2, alpha * (m2 / m0) * m2};
}

/// R [m] and D_p [1/m^2] of the peaks: the inverse of moments_of_peaks.
template <Real T>
[[nodiscard]] T peak_radius_of(const SpectralMoments<T>& moments) {
    return radius_times_rms_curvature<T>() / std::sqrt(moments.m4);
}
/// D_p [1/m^2] of an isotropic Gaussian surface of these moments, by Nayak.
template <Real T>
[[nodiscard]] T peak_density_of(const SpectralMoments<T>& moments) {
    return moments.m4 / (6 * std::numbers::pi_v<T> * std::sqrt(T(3)) * moments.m2);
}

}  // namespace detail

}}  // namespace fstiff
