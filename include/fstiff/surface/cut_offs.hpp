// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Longest and shortest wave of a surface with given D, G, rms height and density of islands.
///
///     sum of cosines   sigma^2 = G^(2D-2) lambda^(4-2D) / (2 (1 - gamma^-(4-2D)))          of (2.1), endless
///     Gaussian map     S(tau)  = 2 sigma^2 (pi tau/lambda)^(2H) Gamma(1-H)/Gamma(1+H)      sections, endless
///     Gaussian map     m2/m0   = 2 pi^2/lambda^2  H/(1-H)  (b^(2-2H) - 1)/(1 - b^(-2H))    b = lambda/shortest
///
/// lambda: longest wave; H = 2 - D; the map has the spectrum of self_affine_map() with LongWaves::none. The shortest
/// wave follows from m2, which decides the number of islands. Derivation: docs/theory.md, section 2.
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.1), (2.3); DLMF 10.22.43
/// Units       lengths [m], m2/m0 [1/m^2]; m2 is that of a profile
/// Valid       as Fractal; gamma > 1; 0 < H < 1
/// Accuracy    1e-13 of the formulae in double (tests/surface/cut_offs_test.cpp, also for generated surfaces)

#include <fstiff/core/error.hpp>
#include <fstiff/surface/fractal.hpp>
#include <fstiff/surface/structure_constant.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace fstiff::inline v0_1::parts {

/// Longest wave of the sum of cosines (2.1) with the rms height \p rms [m].
/// \throws domain_error naming the parameter that is out of range.
template <Real T>
[[nodiscard]] T longest_cosine(const Fractal<T>& fractal, T rms, T gamma = T(1.5)) {
    require_fractal_dimension(fractal.dimension);
    require_positive("fractal_roughness", fractal.roughness);
    require_positive("rms", rms);
    require(gamma > T(1) && gamma <= (std::numeric_limits<T>::max)(), "gamma", gamma, "finite and greater than 1");
    const T power = 4 - 2 * fractal.dimension;
    const T ratio = rms / fractal.roughness;  // lambda/G = (2 ratio^2 (1 - gamma^-power))^(1/power)
    return fractal.roughness * std::pow(2 * ratio * ratio * -std::expm1(-power * std::log(gamma)), 1 / power);
}

/// Longest wave of the Gaussian map of rms height \p rms [m] whose sections have S = C tau^(4-2D), with the exact C of
/// (2.4).
/// \throws domain_error naming the parameter that is out of range.
template <Real T>
[[nodiscard]] T longest_wave(const Fractal<T>& fractal, T rms) {
    require_positive("rms", rms);
    const T unit = fractal.roughness;  // S at the lag G is c G^2
    const T hurst = 2 - fractal.dimension;
    const T s = structure_function_at(unit, fractal) / (rms * rms);
    const T gammas = std::tgamma(1 - hurst) / std::tgamma(1 + hurst);
    return std::numbers::pi_v<T> * unit * std::pow(2 * gammas / s, 1 / (2 * hurst));
}

/// m2/m0 of a section of the Gaussian map with waves from \p shortest to \p longest.
/// \throws domain_error naming the parameter that is out of range.
template <Real T>
[[nodiscard]] T slope_ratio(T hurst, T longest, T shortest) {
    require(hurst > T(0) && hurst < T(1), "hurst", hurst, "between 0 and 1, both excluded");
    require_positive("longest", longest);
    require(shortest > T(0) && shortest < longest, "shortest", shortest, "positive and below the longest wavelength");
    const T b = std::log(longest / shortest), pi = std::numbers::pi_v<T>;
    return 2 * pi * pi / (longest * longest) * hurst / (1 - hurst) * std::expm1((2 - 2 * hurst) * b) /
           -std::expm1(-2 * hurst * b);
}

/// Shortest wave at which slope_ratio() is \p ratio [1/m^2].
/// \throws domain_error as above, and when the longest wave alone has a greater ratio, or the shortest wave is below
/// 1e-9 of it.
template <Real T>
[[nodiscard]] T shortest_wave(T hurst, T longest, T ratio) {
    require_positive("ratio", ratio);
    T low = longest * T(1e-9), high = longest * (1 - T(1e-6));  // the ratio falls as the wave grows
    require(slope_ratio(hurst, longest, low) >= ratio && slope_ratio(hurst, longest, high) <= ratio, "ratio", ratio,
            "one that waves shorter than the longest can have");
    for (int k = 0; k < 200 && high - low > 2 * std::numeric_limits<T>::epsilon() * high; ++k) {
        const T middle = std::sqrt(low * high);
        if (!(middle > low && middle < high)) break;
        (slope_ratio(hurst, longest, middle) > ratio ? low : high) = middle;
    }
    return high;
}

}  // namespace fstiff::inline v0_1::parts
