// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A slow integral that takes a root at its lower end: the truth of the two-dimensional kernel in tests and benchmarks.
#include <fstiff/math/quadrature.hpp>

#include <cstddef>

namespace test {

/// int_from^to f by Gauss-Legendre panels of 20 points in u, x = from + (to - from) u^2: takes a root at the lower end.
template <class F>
double panels(double from, double to, int count, const F& f) {
    const auto& rule = fstiff::math::GaussLegendre<double, 20>::get();
    double sum = 0;
    for (int panel = 0; panel < count; ++panel)
        for (std::size_t i = 0; i < 20; ++i) {
            const double u = (panel + (1 + rule.node[i]) / 2) / count;
            sum += rule.weight[i] / count * u * f(from + (to - from) * u * u);
        }
    return sum * (to - from);
}

}  // namespace test
