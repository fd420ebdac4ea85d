// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// erf of eight numbers at once. std::erf costs ten times an exponential and Eigen has none in vectors of double.
///
///     erf(y) = y P(y^2)    0 <= y <= 5/2
///     erf(y) = Q(y), R(y)  to 9/2, to 13/2; beyond it is 1 to the last bit
///
/// Reference   P, Q and R are interpolated by tools/make_gaussian_moment_table.py.
/// Units       dimensionless
/// Valid       y >= 0, infinity included
/// Accuracy    4 epsilon relative (tests/math/gaussian_moment_test.cpp), 3e-5 by the rough polynomials

#include <fstiff/core/concepts.hpp>
#include <fstiff/math/gaussian_moment_table.hpp>
#include <fstiff/math/lanes.hpp>

#include <span>

namespace fstiff::inline v0_1::math {

/// c[0] + c[1] u + c[2] u^2 + ..., even and odd powers apart: one sum alone waits for each multiplication.
EIGEN_ALWAYS_INLINE Lanes<double, 8> polynomial(std::span<const double> c, const Lanes<double, 8>& u) {
    using V = Lanes<double, 8>;
    if (c.size() < 2) return V::all(c.front());
    const V square = u * u;
    std::size_t n = c.size() - 2;
    V high = V::all(c[n + 1]), low = V::all(c[n]);
    for (; n >= 2; n -= 2) {
        high = multiply_add(high, square, V::all(c[n - 1]));
        low = multiply_add(low, square, V::all(c[n - 2]));
    }
    V sum = multiply_add(high, u, low);
    return n == 1 ? multiply_add(sum, u, V::all(c[0])) : sum;
}

/// Polynomials for the three ranges.
struct ErfPolynomials {
    std::span<const double> inner, middle, outer;
    double error;  ///< relative, beyond the rounding

    /// The shorter ones where \p tolerance allows.
    static ErfPolynomials for_tolerance(double tolerance) {
        if (tolerance > 10 * ErfTable::rough_error)
            return {ErfTable::rough_inner, ErfTable::rough_middle, ErfTable::rough_outer, ErfTable::rough_error};
        return {ErfTable::inner, ErfTable::middle, ErfTable::outer, 0};
    }
};

/// erf of eight ascending numbers from \p first to \p last.
EIGEN_ALWAYS_INLINE Lanes<double, 8> erf_ascending(const Lanes<double, 8>& y, double first, double last,
                                                   const ErfPolynomials& by) {
    using V = Lanes<double, 8>;
    constexpr double middle = 2.5, outer = 4.5, end = 6.5;
    V value = V::all(1);
    if (first >= end) return value;
    if (last > outer) value = polynomial(by.outer, smaller(y, V::all(end)) - V::all((outer + end) / 2));
    if (last > middle && first < outer) {
        const V q = polynomial(by.middle, smaller(y, V::all(outer)) - V::all((middle + outer) / 2));
        value = select_less(y, V::all(outer), q, value);
    }
    if (first < middle) {
        const V bounded = smaller(y, V::all(middle));
        const V p =
            bounded * polynomial(by.inner, multiply_add(bounded * V::all(2 / (middle * middle)), bounded, V::all(-1)));
        value = select_less(y, V::all(middle), p, value);
    }
    return value;
}

/// out[i] = erf(k t[i]) for eight ascending t; float by way of double.
template <Real T>
EIGEN_DONT_INLINE void erf_of_eight(const T* t, T k, T* out) {
    double argument[8], value[8];
    for (int i = 0; i < 8; ++i) argument[i] = static_cast<double>(k) * static_cast<double>(t[i]);
    erf_ascending(Lanes<double, 8>::load(argument), argument[0], argument[7], ErfPolynomials::for_tolerance(0))
        .store(value);
    for (int i = 0; i < 8; ++i) out[i] = static_cast<T>(value[i]);
}

}  // namespace fstiff::inline v0_1::math
