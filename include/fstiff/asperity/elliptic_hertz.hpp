// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Hertz's contact of one asperity whose principal curvatures differ: load, stiffness and area of the ellipse.
///
///     F = (4/3) E (k1 k2)^(-1/4) F2^(-3/2) omega^(3/2)         F' = 2 E (k1 k2)^(-1/4) F2^(-3/2) omega^(1/2)
///     A = pi a b = pi (k1 k2)^(-1/2) (F1^2/F2) omega
///     k2/k1 = s^2 D/B,   F1^3 = (4/pi) sqrt(s B D),   F2 = (2/pi) sqrt(s) (B + D)/F1,   s = b/a
///
/// B = (E - s^2 K)/m and D = (K - E)/m are the associate complete elliptic integrals of the parameter m = 1 - s^2,
/// from the arithmetic-geometric mean; Newton's method in ln s finds s of k2/k1.
///
/// Reference   Johnson, Contact Mechanics, Cambridge (1985), eqs. (4.25)-(4.26), F1 and F2 as defined there; Fukushima,
///             J. Comput. Appl. Math. 235 (2011) 4140 (B and D); Abramowitz, Stegun (1964), 17.6 (the mean).
/// Units       curvatures [1/m], omega [m]; load/E [m^2], stiffness/E [m], area [m^2]
/// Valid       k1, k2 > 0 in either order; omega >= 0
/// Accuracy    16 ulp for k2/k1 >= 1e-4 (tests/asperity/elliptic_hertz_test.cpp)

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The ellipse of contact of two principal curvatures.
template <Real T = double>
struct HertzEllipse {
    T axis_ratio;       ///< s = b/a, 0 < s <= 1; b lies along the larger curvature
    T size_factor;      ///< F1: sqrt(a b) over that of a sphere of curvature sqrt(k1 k2) under the same load
    T approach_factor;  ///< F2: omega over that of the same sphere under the same load
};

/// B and D of the parameter 1 - s^2.
template <Real T>
struct AssociateIntegrals {
    T b, d;
};

template <Real T>
[[nodiscard]] AssociateIntegrals<T> associate_integrals(T s) {
    // c_n^2/m of the sequence a, b, c of the mean: c_0^2 = m
    T arithmetic = (1 + s) / 2, geometric = std::sqrt(s), c = (1 - s) / 2;
    T share = (1 - s) / (4 * (1 + s)), power = 1, sum = T(0.5) + share;
    while (c > std::numeric_limits<T>::epsilon() * arithmetic) {
        const T next = (arithmetic + geometric) / 2, half = c / (4 * next);
        share *= half * half;
        power *= 2;
        sum += power * share;
        c *= half;
        geometric = std::sqrt(arithmetic * geometric);
        arithmetic = next;
    }
    const T complete = std::numbers::pi_v<T> / (2 * arithmetic), d = complete * sum;
    return {complete - d, d};
}

/// Ellipse of the ratio k2/k1 \p curvature_ratio. \throws domain_error unless 0 < curvature_ratio <= 1.
template <Real T>
[[nodiscard]] HertzEllipse<T> hertz_ellipse(T curvature_ratio) {
    require(curvature_ratio > 0 && curvature_ratio <= 1, "curvature_ratio", curvature_ratio, "from above 0 to 1");
    const T target = std::log(curvature_ratio);
    T log_s = target * 2 / 3;
    for (int i = 0; i < 10; ++i) {
        const T s = std::exp(log_s), m = (1 - s) * (1 + s);
        const auto [b, d] = associate_integrals(s);
        const T slope = m < T(1e-4) ? T(1.5) : 2 - (b / d - s * s * d / b) / m;
        const T step = (2 * log_s + std::log(d / b) - target) / slope;
        log_s = (std::min)(log_s - step, T(0));
        if (std::abs(step) < std::sqrt(std::numeric_limits<T>::epsilon()) * T(0.1)) break;
    }
    const T s = std::exp(log_s), pi = std::numbers::pi_v<T>;
    const auto [b, d] = associate_integrals(s);
    const T size = std::cbrt(4 / pi * std::sqrt(s * b * d));
    return {s, size, 2 / pi * std::sqrt(s) * (b + d) / size};
}

/// One asperity of two principal curvatures.
template <Real T = double>
struct EllipticHertz {
    T load_factor;  ///< load/E over omega^(3/2) [m^(1/2)]
    T area_factor;  ///< area over omega [m]
    T axis_ratio;   ///< b/a

    [[nodiscard]] T load(T omega) const { return load_factor * omega * std::sqrt(omega); }
    [[nodiscard]] T stiffness(T omega) const { return T(1.5) * load_factor * std::sqrt(omega); }
    [[nodiscard]] T area(T omega) const { return area_factor * omega; }
};

/// Ellipse for the principal curvatures \p first, \p second [1/m], in either order. \throws domain_error unless both
/// are positive.
template <Real T>
[[nodiscard]] EllipticHertz<T> elliptic_hertz(T first, T second) {
    require_positive("curvature", first);
    require_positive("curvature", second);
    const HertzEllipse<T> ellipse = hertz_ellipse((std::min)(first, second) / (std::max)(first, second));
    const T radius = 1 / (std::sqrt(first) * std::sqrt(second)), f2 = ellipse.approach_factor;
    return {T(4) / 3 * std::sqrt(radius) / (f2 * std::sqrt(f2)),
            std::numbers::pi_v<T> * radius * ellipse.size_factor * ellipse.size_factor / f2, ellipse.axis_ratio};
}

}}}  // namespace fstiff::detail
