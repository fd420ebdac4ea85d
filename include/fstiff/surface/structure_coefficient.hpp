// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Coefficient C of the structure function S(tau) = C tau^(4-2D), and the fractal roughness G from it.
///
///     C = c(D) G^(2D-2)                                                             eq. (2.4)
///     exact           c = (2 pi)^(4-2D) g / ((4-2D) ln gamma)    mean of S over one log-period of the profile (2.1)
///     paper           c = g / (2-D)                              (2.4) as printed
///     majumdar_tien   c = g / ((4-2D) ln gamma)                  (2.4) / (2 ln gamma)
///     g = Gamma(2D-3) sin((2D-3) pi/2) = pi / (2 Gamma(4-2D) sin(pi (D-1)))         regular at D = 1.5
///
/// With `paper`, G of a true Weierstrass-Mandelbrot profile is some 3 to 5 times too large (docs/errata.md).
/// Derivation  docs/theory-surface.md
/// Reference   Buczkowski et al., Arch. Mech. 66 (2014), eqs. (2.3), (2.4); Majumdar, Tien, Wear 136 (1990)
/// Units       c dimensionless; C in m^(2D-2); G [m]; gamma dimensionless
/// Valid       1 < D < 2 (c diverges at both ends), gamma > 1
/// Accuracy    20 ulp for 1.001 <= D <= 1.999 (tests/surface/structure_constant_test.cpp)

#include <fstiff/surface/fractal.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Convention of the coefficient between S and G.
enum class StructureConvention { exact, paper, majumdar_tien };

template <>
inline constexpr auto enum_names<StructureConvention> =
    detail::name_list<StructureConvention>({{StructureConvention::exact, "exact"},
                                            {StructureConvention::paper, "paper"},
                                            {StructureConvention::majumdar_tien, "majumdar_tien"}});

namespace detail {

/// Coefficient c(D), dimensionless.
/// \throws domain_error unless 1 < D < 2 and gamma > 1.
template <Real T>
[[nodiscard]] T structure_constant(T fractal_dimension, StructureConvention convention = StructureConvention::exact,
                                   T gamma = T(1.5)) {
    require_fractal_dimension(fractal_dimension);
    require(gamma > T(1) && gamma <= (std::numeric_limits<T>::max)(), "gamma", gamma, "finite and greater than 1");
    constexpr T pi = std::numbers::pi_v<T>;
    const T above = fractal_dimension - 1, below = 2 - fractal_dimension;  // both exact
    const T g = pi / (2 * std::tgamma(2 * below) * std::sin(pi * (above < below ? above : below)));
    if (convention == StructureConvention::paper) return g / below;
    const T printed = g / (2 * below * std::log(gamma));
    return convention == StructureConvention::majumdar_tien ? printed : std::pow(2 * pi, 2 * below) * printed;
}

/// S(tau) = c G^(2D-2) tau^(4-2D) [m^2] of a surface \p fractal at the lag \p lag > 0.
/// \throws domain_error naming the argument that is out of range.
template <Real T>
[[nodiscard]] T structure_function_at(T lag, const Fractal<T>& fractal,
                                      StructureConvention convention = StructureConvention::exact, T gamma = T(1.5)) {
    require_positive("lag", lag);
    require_positive("fractal_roughness", fractal.roughness);
    const T c = structure_constant(fractal.dimension, convention, gamma);
    return c * std::pow(fractal.roughness / lag, 2 * (fractal.dimension - 1)) * lag * lag;
}

/// ln(G / lag), where S(\p lag) = \p value: the logarithm, because G itself exceeds every range of numbers as D -> 1.
/// \throws domain_error naming the argument that is out of range.
template <Real T>
[[nodiscard]] T log_fractal_roughness(T fractal_dimension, T lag, T value,
                                      StructureConvention convention = StructureConvention::exact, T gamma = T(1.5)) {
    require_positive("lag", lag);
    require_positive("structure_function", value);
    const T c = structure_constant(fractal_dimension, convention, gamma);
    return (std::log(value) - 2 * std::log(lag) - std::log(c)) / (2 * (fractal_dimension - 1));
}

/// G [m] of the surface whose structure function is \p value [m^2] at the lag \p lag [m].
/// \throws domain_error naming the argument that is out of range, or when G is no positive number of type T.
template <Real T>
[[nodiscard]] T fractal_roughness(T fractal_dimension, T lag, T value,
                                  StructureConvention convention = StructureConvention::exact, T gamma = T(1.5)) {
    const T log_ratio = log_fractal_roughness(fractal_dimension, lag, value, convention, gamma);
    const T roughness = std::exp(log_ratio) * lag;
    require(roughness >= (std::numeric_limits<T>::min)() && roughness <= (std::numeric_limits<T>::max)(),
            "fractal_dimension", fractal_dimension,
            "further from 1: the fractal roughness G is beyond the range of numbers");
    return roughness;
}

}  // namespace detail

}}  // namespace fstiff
