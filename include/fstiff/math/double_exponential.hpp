// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Integrals of functions of eight numbers at once over an interval or a half line, whatever the powers at their ends.
///
///     interval    x = a + (b-a)/(1 + exp(-pi sinh y))        tanh-sinh
///     half line   x = a + size exp(y - exp(-y))              for integrands that fall as fast as exp(-x/size)
///
/// both by the trapezoidal rule in y, whose step is halved until two results agree.
///
/// Reference   Takahasi and Mori, Publ. RIMS 9 (1974) 721-741.
/// Valid       integrands that are smooth within, and integrable at the ends
/// Accuracy    relative_tolerance, aimed at; the error returned is the last difference of two steps and the rounding

#include <fstiff/math/quadrature.hpp>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace math {

/// The sum over j of map(j step) -> {x, dx/dy}, from y = \p low to \p high, of \p f, refined until it settles.
template <Real T, class F, class Map>
Estimate<T> double_exponential(const F& f, const Map& map, T low, T high, T relative_tolerance) {
    using Eight = Eigen::Array<T, 8, 1>;
    Estimate<T> out;
    T step = (high - low) / 32, previous = 0;
    for (int level = 0; level < 7; ++level, step /= 2) {
        T sum = 0, size = 0;
        for (T from = low; from < high; from += 8 * step) {
            Eight x, slope;
            for (Eigen::Index i = 0; i < 8; ++i) {
                const auto [node, derivative] = map(from + T(i) * step);
                x[i] = node;
                slope[i] = from + T(i) * step < high ? derivative : T(0);
            }
            const Eight term = f(x) * slope;
            sum += term.sum();
            size += term.abs().sum();
            out.evaluations += 8;
        }
        out.value = sum * step;
        out.error = std::abs(out.value - previous) + 8 * std::numeric_limits<T>::epsilon() * size * step;
        if (level > 0 && out.error <= relative_tolerance * std::abs(out.value)) break;
        previous = out.value;
    }
    return out;
}

template <Real T, class F>
Estimate<T> integral_over_interval(const F& f, T a, T b, T relative_tolerance) {
    const auto map = [=](T y) {
        const T e = std::exp(-std::numbers::pi_v<T> * std::abs(std::sinh(y)));  // small end's share: e/(1+e)
        const T share = e / (1 + e);
        return std::pair(y < 0 ? a + (b - a) * share : b - (b - a) * share,
                         (b - a) * std::numbers::pi_v<T> * std::cosh(y) * share / (1 + e));
    };
    const T end = std::asinh(-std::log(std::numeric_limits<T>::epsilon()) / std::numbers::pi_v<T> + 1);
    return double_exponential(f, map, -end, end, relative_tolerance);
}

/// \p reach: beyond a + reach the integrand is 0.
template <Real T, class F>
Estimate<T> integral_over_half_line(const F& f, T a, T size, T reach, T relative_tolerance) {
    const auto map = [=](T y) {
        const T fall = std::exp(-y);
        const T x = size * std::exp(y - fall);
        return std::pair(a + x, x * (1 + fall));
    };
    const T low = -std::log(-std::log(std::numeric_limits<T>::epsilon()) + 3);
    return double_exponential(f, map, low, std::log(reach / size) + size / reach, relative_tolerance);
}

}}}  // namespace fstiff::math
