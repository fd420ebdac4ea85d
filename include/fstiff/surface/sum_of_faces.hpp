// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Two rough faces as one: the contact of both is that of their sum with a smooth face.
///
///     m0, m2, m4      add, and with them sigma^2, g^2, and 1/R^2 by eq. (4.10)
///     D_p             m4/(6 pi sqrt(3) m2), where m4 and m2 of each face are those of its R and D_p
///     R_p             R_p + R_p: upper bound of the sum
///     r, theta        sigma_m^2 = r sigma sigma_kappa adds, r = sigma_m^2/(sigma sigma_kappa),
///                     sin^2(theta) = mean of sin^2(theta), weighted by sigma_m^2
///     D, G            S(tau) adds: the power law tangent to the sum at tau = D_p^(-1/2), the distance of the peaks
///
/// Assumes independent heights and isotropic faces sampled at one step. Derivation: docs/theory-surface.md.
/// Reference   Nayak (1971); Greenwood, Tripp, Proc. Inst. Mech. Eng. 185 (1970) 625; Buczkowski et al. (2014)
/// Units       SI
/// Valid       parameters in the range of Roughness, Fractal and PeakDistribution
/// Accuracy    1e-13; a face 1e9 times lower leaves the other unchanged (tests/surface/two_faces_test.cpp)

#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

#include <cmath>
#include <limits>
#include <optional>

namespace fstiff { inline namespace v0_1 { namespace detail {

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

}}  // namespace fstiff
