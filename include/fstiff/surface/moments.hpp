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
#include <limits>
#include <numbers>
#include <optional>

// Roughness parameters of one nominally flat surface, as in Table 1 of the reference paper.
//
// Units       SI
// Valid       every length and density finite and > 0; max_peak_height 0 when it is not known

namespace fstiff::inline v0_1 {

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

}  // namespace fstiff::inline v0_1

// Two rough faces as one: the contact of both is that of their sum with a smooth face.
//
//     m0, m2, m4      add, and with them sigma^2, g^2, and 1/R^2 by eq. (4.10)
//     D_p             m4/(6 pi sqrt(3) m2), where m4 and m2 of each face are those of its R and D_p
//     R_p             R_p + R_p: upper bound of the sum
//     r, theta        sigma_m^2 = r sigma sigma_kappa adds, r = sigma_m^2/(sigma sigma_kappa),
//                     sin^2(theta) = mean of sin^2(theta), weighted by sigma_m^2
//     D, G            S(tau) adds: the power law tangent to the sum at tau = D_p^(-1/2), the distance of the peaks
//
// Assumes independent heights and isotropic faces sampled at one step. Derivation: docs/theory-surface.md.
// Reference   Nayak (1971); Greenwood, Tripp, Proc. Inst. Mech. Eng. 185 (1970) 625; Buczkowski et al. (2014)
// Units       SI
// Valid       parameters in the range of Roughness, Fractal and PeakDistribution
// Accuracy    1e-13; a face 1e9 times lower leaves the other unchanged (tests/surface/two_faces_test.cpp)

namespace fstiff::inline v0_1 {

namespace detail {

/// Parameters of one face.
template <Real T = double>
struct RoughFace {
    Roughness<T> roughness{};
    SpectralMoments<T> moments{};                               ///< of the spectrum; else those of R and D_p
    std::optional<T> fractal_dimension{}, fractal_roughness{};  ///< G [m]
    std::optional<T> r{}, theta{};                              ///< both or none [1, rad]

    /// Whether R and D_p are known; else they are 0.
    [[nodiscard]] bool has_peaks() const { return roughness.peak_radius != T(0) && roughness.peak_density != T(0); }
};

/// Whether G, which exceeds every range of numbers as D -> 1, is finite and positive.
template <Real T>
[[nodiscard]] bool is_number(T roughness) {
    return roughness >= (std::numeric_limits<T>::min)() && roughness <= (std::numeric_limits<T>::max)();
}

/// \p face with its heights multiplied by \p factor > 0: R/factor, and G such that S grows by factor^2, or none where G
/// exceeds the range of numbers.
template <Real T>
[[nodiscard]] RoughFace<T> scaled(RoughFace<T> face, T factor) {
    const T square = factor * factor;
    face.roughness.rms_height *= factor;
    face.roughness.max_peak_height *= factor;
    face.roughness.peak_radius /= factor;
    face.moments = {face.moments.m0 * square, face.moments.m2 * square, face.moments.m4 * square};
    if (face.fractal_dimension && face.fractal_roughness) {
        *face.fractal_roughness *= std::pow(factor, 1 / (*face.fractal_dimension - 1));
        if (!is_number(*face.fractal_roughness)) face.fractal_roughness.reset();
    }
    return face;
}

/// Mean square slope of neighbours, r sigma sigma_kappa.
template <Real T>
[[nodiscard]] T slope_of_triples(const RoughFace<T>& face) {
    return *face.r * face.roughness.rms_height * std::sqrt(face.moments.m4);
}

/// R, D_p, sigma and R_p of the sum.
/// \throws domain_error naming the parameter that is out of range.
template <Real T>
[[nodiscard]] Roughness<T> sum_of_faces(const Roughness<T>& a, const Roughness<T>& b) {
    const auto moments = [](const Roughness<T>& face) {
        return moments_of_peaks(face.rms_height, face.peak_radius, face.peak_density);
    };
    const SpectralMoments<T> sum = moments(a) + moments(b);
    const bool known = a.max_peak_height > T(0) && b.max_peak_height > T(0);
    return {std::hypot(a.rms_height, b.rms_height), detail::peak_radius_of(sum), detail::peak_density_of(sum),
            known ? a.max_peak_height + b.max_peak_height : T(0)};
}

/// Share of \p a in the structure function of the sum at the distance of its peaks; in m2 where a G is not known.
template <Real T>
[[nodiscard]] T share_of_face(const RoughFace<T>& a, const RoughFace<T>& b) {
    if (!(a.fractal_dimension && a.fractal_roughness && b.fractal_dimension && b.fractal_roughness && a.has_peaks() &&
          b.has_peaks()))
        return a.moments.m2 / (a.moments.m2 + b.moments.m2);
    const T lag = 1 / std::sqrt(sum_of_faces(a.roughness, b.roughness).peak_density);
    const auto s = [&](const RoughFace<T>& face) {
        return structure_function_at(lag, Fractal<T>{*face.fractal_dimension, *face.fractal_roughness});
    };
    return s(a) / (s(a) + s(b));
}

/// Sum of two faces. Parameters that one face has not (R and D_p; D; r and theta) are missing in the sum, as is a G
/// beyond the range of numbers.
/// \throws domain_error naming the parameter that is out of range.
template <Real T>
[[nodiscard]] RoughFace<T> sum_of_faces(const RoughFace<T>& a, const RoughFace<T>& b) {
    const bool peaks = a.has_peaks() && b.has_peaks();
    const T rms_height = std::hypot(a.roughness.rms_height, b.roughness.rms_height);
    RoughFace<T> sum{peaks ? sum_of_faces(a.roughness, b.roughness) : Roughness<T>{rms_height}, a.moments + b.moments};
    if (a.fractal_dimension && b.fractal_dimension) {
        const T share = detail::share_of_face(a, b);
        const T dimension = share * *a.fractal_dimension + (1 - share) * *b.fractal_dimension;
        sum.fractal_dimension = dimension;
        if (peaks && a.fractal_roughness && b.fractal_roughness) {
            const T lag = 1 / std::sqrt(sum.roughness.peak_density);
            const T s = detail::structure_function_at(lag, Fractal<T>{*a.fractal_dimension, *a.fractal_roughness}) +
                        detail::structure_function_at(lag, Fractal<T>{*b.fractal_dimension, *b.fractal_roughness});
            const T roughness = lag * std::exp(detail::log_fractal_roughness(dimension, lag, s));
            if (detail::is_number(roughness)) sum.fractal_roughness = roughness;
        }
    }
    if (a.r && a.theta && b.r && b.theta) {
        const T slope_a = detail::slope_of_triples(a), slope_b = detail::slope_of_triples(b), slope = slope_a + slope_b;
        const T sine_a = std::sin(*a.theta), sine_b = std::sin(*b.theta);
        sum.r = slope / (sum.roughness.rms_height * std::sqrt(sum.moments.m4));
        sum.theta = std::asin(std::sqrt((slope_a / slope) * sine_a * sine_a + (slope_b / slope) * sine_b * sine_b));
    }
    return sum;
}

}  // namespace detail

}  // namespace fstiff::inline v0_1
