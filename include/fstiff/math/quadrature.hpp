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
#include <array>
#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace math {

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

}}}  // namespace fstiff::math
