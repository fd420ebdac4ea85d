// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Moments of a Gaussian beyond a threshold: the inner integral of every contact quantity.
///
///     F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv = Gamma(a+1) exp(-x^2/4) D_{-a-1}(x)
///     F_a'   = -a F_{a-1}
///
/// D is Whittaker's parabolic cylinder function. F_a falls as exp(-x^2/2) for x > 0 and grows as sqrt(2 pi) |x|^a for x < 0;
/// three polynomials cover the line (tools/make_gaussian_moment_table.py): in (x-4)/(x+4) for x >= 0, in x for -5 <= x <= 0
/// and in 1/x^2 below. No recurrence is used: F_{a+1} = a F_{a-1} - x F_a cancels for x > 0.
///
/// Reference   NIST Digital Library of Mathematical Functions, 12.5.1.
/// Units       dimensionless
/// Valid       a in {-1/2, 0, 1/2, 1, 3/2, 5/2}; any x that is a number: underflows to 0 for x > 38 (double)
/// Accuracy    16 epsilon relative, 80 for a = 5/2 (the worst where x is just below 0); 1 epsilon is typical
///             (tests/math/gaussian_moment_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/gaussian_moment_table.hpp>
#include <fstiff/math/lanes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fstiff {

namespace detail {

inline constexpr int moment_middle = 5;  ///< the middle polynomial reaches to x = -5

/// Half-integer powers v^(TwiceA/2), given v and its square root.
template <int TwiceA, class V>
EIGEN_ALWAYS_INLINE V half_power(const V& v, const V& root) {
    if constexpr (TwiceA == -1) return V(1) / root;
    if constexpr (TwiceA == 0) return V(1);
    if constexpr (TwiceA == 1) return root;
    if constexpr (TwiceA == 2) return v;
    if constexpr (TwiceA > 2) return v * half_power<TwiceA - 2>(v, root);
}

/// exp(x^2/2) F_a(x) for x >= 0, given 1/(x+4) and its square root.
template <int TwiceA, Real T, class V>
EIGEN_ALWAYS_INLINE V moment_right(const V& u, const V& inverse, const V& inverse_root) {
    return polynomial(MomentTable<T, TwiceA>::right, u) * half_power<TwiceA + 2>(inverse, inverse_root);
}

/// F_a(x) for -5 <= x <= 0, u = (2x+5)/5.
template <int TwiceA, Real T, class V>
EIGEN_ALWAYS_INLINE V moment_middle_range(const V& u) {
    return polynomial(MomentTable<T, TwiceA>::middle, u);
}

/// F_a(x) for x <= -5, u = 50/x^2 - 1.
template <int TwiceA, Real T, class V>
EIGEN_ALWAYS_INLINE V moment_far(const V& u, const V& magnitude, const V& root) {
    return polynomial(MomentTable<T, TwiceA>::far, u) * half_power<TwiceA>(magnitude, root);
}

/// exp(-x^2/2), without the loss of x^2 epsilon that rounding x^2 costs: x = head + tail with so few digits in head that
/// head^2 is exact. By rounding down rather than by a sum and a difference, which a compiler may contract.
template <Real T>
T gaussian(T x) {
    using Limits = std::numeric_limits<T>;
    constexpr int whole = Limits::max_exponent > 10000 ? 8 : Limits::max_exponent > 1000 ? 6 : 4;  // binary digits of x
    if (!(std::abs(x) < T(1 << whole))) return T(0);                                               // underflows before
    constexpr T grid = T(1 << (Limits::digits / 2 - whole));
    const T head = std::floor(x * grid) / grid;
    const T tail = x - head;
    return std::exp(-head * head / 2) * std::exp(-tail * (x + head) / 2);
}

/// exp(s) F_a(x) with s = x^2/2 for x >= 0 and s = 0 for x < 0: neither under- nor overflows.
template <int TwiceA, Real T>
T scaled_moment(T x) {
    if (x >= 0) {
        const T inverse = 1 / (x + 4);
        return moment_right<TwiceA, T>((x - 4) * inverse, inverse, std::sqrt(inverse));
    }
    if (x >= -T(moment_middle)) return moment_middle_range<TwiceA, T>((2 * x + 5) / 5);
    const T ratio = moment_middle / x;
    return moment_far<TwiceA, T>(2 * ratio * ratio - 1, -x, std::sqrt(-x));
}

/// Calls f.operator()<2a>() for the power \p a. \throws domain_error for a power that has no table.
template <Real T, class F>
auto with_power(T a, const F& f) {
    if (a == T(-0.5)) return f.template operator()<-1>();
    if (a == T(0)) return f.template operator()<0>();
    if (a == T(0.5)) return f.template operator()<1>();
    if (a == T(1)) return f.template operator()<2>();
    if (a == T(1.5)) return f.template operator()<3>();
    require(a == T(2.5), "a", a, "-1/2, 0, 1/2, 1, 3/2 or 5/2");
    return f.template operator()<5>();
}

}  // namespace detail

/// F_a(x). \throws domain_error for an a outside the list above or an x that is NaN.
template <Real T>
[[nodiscard]] T gaussian_moment(T a, T x) {
    require(!std::isnan(x), "x", x, "a number");
    x = std::clamp(x, -std::numeric_limits<T>::max(), std::numeric_limits<T>::max());
    return detail::with_power(
        a, [x]<int TwiceA>() { return detail::scaled_moment<TwiceA>(x) * (x > 0 ? detail::gaussian(x) : T(1)); });
}

}  // namespace fstiff
