// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Gauss-Legendre nodes and weights on [-1, 1].
///
/// Roots of P_N by Newton's method from cos(pi (i + 3/4)/(N + 1/2)), weights 2/((1 - x^2) P_N'(x)^2).
///
/// Reference   Abramowitz and Stegun, 25.4.29.
/// Units       dimensionless
/// Valid       N >= 1
/// Accuracy    nodes 2 epsilon, weights 4 N epsilon relative (tests/math/gauss_legendre_test.cpp)

#include <fstiff/core/numbers.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fstiff::inline v0_1::math {

/// Nodes and weights of Gauss and Legendre's rule of N points on (-1, 1).
template <Real T, std::size_t N>
struct GaussLegendre {
    std::array<T, N> node;    ///< ascending
    std::array<T, N> weight;  ///< sums to 2

    GaussLegendre() {
        for (std::size_t i = 0; i < (N + 1) / 2; ++i) {
            T x = 2 * i + 1 == N ? T(0) : std::cos(std::numbers::pi_v<T> * (T(i) + T(0.75)) / (T(N) + T(0.5)));
            T derivative = 1;
            for (int iteration = 0; iteration < 8; ++iteration) {  // quadratic from 1e-3 or better: five would do
                T previous = 1, value = x;
                for (std::size_t n = 2; n <= N; ++n) {
                    const T next = ((2 * T(n) - 1) * x * value - (T(n) - 1) * previous) / T(n);
                    previous = value;
                    value = next;
                }
                derivative = T(N) * (previous - x * value) / ((1 - x) * (1 + x));
                x -= value / derivative;
            }
            node[N - 1 - i] = x;
            node[i] = -x;
            weight[i] = weight[N - 1 - i] = 2 / ((1 - x) * (1 + x) * derivative * derivative);
        }
    }

    static const GaussLegendre& get() {
        static const GaussLegendre rule;
        return rule;
    }
};

}  // namespace fstiff::inline v0_1::math

// Integrals of functions of eight numbers at once over an interval or a half line, whatever the powers at their ends.
//
//     interval    x = a + (b-a)/(1 + exp(-pi sinh y))        tanh-sinh
//     half line   x = a + size exp(y - exp(-y))              for integrands that fall as fast as exp(-x/size)
//
// both by the trapezoidal rule in y, whose step is halved until two results agree.
//
// Reference   Takahasi and Mori, Publ. RIMS 9 (1974) 721-741.
// Valid       integrands that are smooth within, and integrable at the ends
// Accuracy    relative_tolerance, aimed at; the error returned is the last difference of two steps and the rounding

namespace fstiff::inline v0_1::math {

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

}  // namespace fstiff::inline v0_1::math
