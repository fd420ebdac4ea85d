// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The normal distribution: density, distribution and its inverse.
///
///     phi(z) = exp(-z^2/2)/sqrt(2 pi)      Phi(z) = erfc(-z/sqrt(2))/2      z = Phi^-1(p)
///
/// Reference   Wichura, Appl. Stat. 37 (1988) 477, AS 241.
/// Units       dimensionless
/// Valid       0 < p < 1
/// Accuracy    Phi^-1 to 1e-15 of itself in double (tests/math/normal_distribution_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/gaussian_moment_table.hpp>
#include <fstiff/math/lanes.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

// erf of eight numbers at once. std::erf costs ten times an exponential and Eigen has none in vectors of double.
//
//     erf(y) = y P(y^2)    0 <= y <= 5/2
//     erf(y) = Q(y), R(y)  to 9/2, to 13/2; beyond it is 1 to the last bit
//
// Reference   P, Q and R are interpolated by tools/make_gaussian_moment_table.py.
// Units       dimensionless
// Valid       y >= 0, infinity included
// Accuracy    4 epsilon relative (tests/math/gaussian_moment_test.cpp), 3e-5 by the rough polynomials

namespace fstiff { inline namespace v0_1 { namespace math {

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
                                                   const ErfPolynomials& polynomials) {
    using V = Lanes<double, 8>;
    constexpr double middle = 2.5, outer = 4.5, end = 6.5;
    V value = V::all(1);
    if (first >= end) return value;
    if (last > outer) value = polynomial(polynomials.outer, smaller(y, V::all(end)) - V::all((outer + end) / 2));
    if (last > middle && first < outer) {
        const V q = polynomial(polynomials.middle, smaller(y, V::all(outer)) - V::all((middle + outer) / 2));
        value = select_less(y, V::all(outer), q, value);
    }
    if (first < middle) {
        const V bounded = smaller(y, V::all(middle));
        const V p = bounded * polynomial(polynomials.inner,
                                         multiply_add(bounded * V::all(2 / (middle * middle)), bounded, V::all(-1)));
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

/// phi(z).
template <Real T>
[[nodiscard]] T normal_density(T z) {
    return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi_v<T>);
}

/// Phi(z): the share of normal numbers below \p z.
template <Real T>
[[nodiscard]] T normal_share(T z) {
    return std::erfc(-z / std::sqrt(T(2))) / 2;
}

/// The rational functions of AS 241: about the median, in the tails, and beyond p = 1e-11.
struct NormalTable {
    // clang-format off
    static constexpr std::array<double, 8> middle_above{
        3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3, 1.3731693765509461125e4,
        4.5921953931549871457e4, 6.7265770927008700853e4, 3.3430575583588128105e4, 2.5090809287301226727e3};
    static constexpr std::array<double, 8> middle_below{
        1, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3, 2.1213794301586595867e4,
        3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3};
    static constexpr std::array<double, 8> tail_above{
        1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0, 3.64784832476320460504e0,
        1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2,
        7.74545014278341407640e-4};
    static constexpr std::array<double, 8> tail_below{
        1, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
        1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4,
        1.05075007164441684324e-9};
    static constexpr std::array<double, 8> beyond_above{
        6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0,
        2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
        2.71155556874348757815e-5, 2.01033439929228813265e-7};
    static constexpr std::array<double, 8> beyond_below{
        1, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
        7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7,
        2.04426310338993978564e-15};
    // clang-format on

    static double ratio(const std::array<double, 8>& above, const std::array<double, 8>& below, double x) {
        double p = above[7], q = below[7];
        for (std::size_t i = 7; i-- > 0;) p = p * x + above[i], q = q * x + below[i];
        return p / q;
    }
};

/// z below which the share \p probability of normal numbers lies.
template <Real T>
[[nodiscard]] T normal_quantile(T probability) {
    using Table = NormalTable;
    const double p = static_cast<double>(probability), q = static_cast<double>(probability - T(0.5));
    double z = 0;
    if (std::abs(q) <= 0.425) {
        z = q * Table::ratio(Table::middle_above, Table::middle_below, 0.180625 - q * q);
    } else {
        const double r = std::sqrt(-std::log(q < 0 ? p : static_cast<double>(1 - probability)));
        z = r <= 5 ? Table::ratio(Table::tail_above, Table::tail_below, r - 1.6)
                   : Table::ratio(Table::beyond_above, Table::beyond_below, r - 5);
        z = q < 0 ? -z : z;
    }
    return static_cast<T>(z);
}

}}}  // namespace fstiff::math
