// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Moments of a Gaussian beyond a threshold: the inner integral of every contact quantity.
///
///     F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv = Gamma(a+1) exp(-x^2/4) D_{-a-1}(x)
///     F_a'   = -a F_{a-1}
///
/// D is Whittaker's parabolic cylinder function. F_a falls as exp(-x^2/2) for x > 0 and grows as sqrt(2 pi) |x|^a for x < 0.
/// Short polynomials cover the line piece by piece (tools/make_gaussian_moment_table.py): the pieces are eighths of the
/// octaves of |x| + 2, so that the bits of that number name its piece; from |x| = 30 on, 1/x^2 is the variable. The
/// coefficients of the four moments of a contact lie side by side, and one loop sums all four. No recurrence is used:
/// F_{a+1} = a F_{a-1} - x F_a cancels for x > 0.
///
/// Reference   NIST Digital Library of Mathematical Functions, 12.5.1.
/// Units       dimensionless
/// Valid       a in {-1/2, 0, 1/2, 1, 3/2, 5/2}; any x that is a number: underflows to 0 for x > 38 (double). float is
///             computed in double; a long double of more than 64 binary digits is refused
/// Accuracy    6 epsilon relative; 1 epsilon is typical (tests/math/gaussian_moment_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/gaussian_moment_table_extended.hpp>
#include <fstiff/math/lanes.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace fstiff {

namespace detail {

/// |x| in the middle of each piece.
inline constexpr auto moment_middles = [] {
    std::array<double, 32> middle{};
    for (std::size_t i = 0; i < middle.size(); ++i)
        middle[i] = (2 << (i / 8)) * (1 + (static_cast<double>(i % 8) + 0.5) / 8) - 2;
    return middle;
}();

/// Where x lies: the number of its piece and the variable there.
template <Real T>
struct MomentPiece {
    static_assert(std::numeric_limits<T>::digits <= 64, "the tables of fstiff hold 64 binary digits");

    T size;  ///< |x|
    T s;
    int piece;
    bool far;  ///< the polynomial is to be multiplied by |x|^a, for x > 0 by x^(-a-1)

    EIGEN_ALWAYS_INLINE explicit MomentPiece(T x) : size(std::abs(x)) {
        constexpr int eighths = 3;
        const double shifted = static_cast<double>(size) + 2;
        far = !(shifted < 32);
        piece =
            far ? 32 : static_cast<int>(std::bit_cast<std::uint64_t>(shifted) >> (52 - eighths)) - (1024 << eighths);
        s = far ? (1 / size) / size : size - static_cast<T>(moment_middles[static_cast<std::size_t>(piece)]);
        if (x < 0) piece += 33;
    }
};

/// Half-integer powers v^(TwiceA/2), given v and its square root.
template <int TwiceA, Real T>
T half_power(T v, T root) {
    if constexpr (TwiceA < 0) return 1 / half_power<-TwiceA>(v, root);
    if constexpr (TwiceA == 0) return T(1);
    if constexpr (TwiceA == 1) return root;
    if constexpr (TwiceA > 1) return v * half_power<TwiceA - 2>(v, root);
}

/// What the polynomial of a far piece is multiplied with, for a = 0, 1/2, 1, 3/2.
template <Real T>
EIGEN_DONT_INLINE Lanes<T, 4> far_powers(T size, bool right) {
    const T root = std::sqrt(size);
    T power[4] = {1, root, size, size * root};
    if (right)
        for (T& one : power) one = 1 / (one * size);
    return Lanes<T, 4>::load(power);
}

/// F_a(x) for a = 0, 1/2, 1, 3/2, times exp(x^2/2) for x >= 0: neither under- nor overflows. By the first \p terms of each
/// polynomial, an even number; MomentTable::cut[terms] bounds the relative error of leaving out the others.
template <int terms, Real T>
EIGEN_ALWAYS_INLINE Lanes<T, 4> scaled_moments(T x) {
    using V = Lanes<T, 8>;  // even and odd powers side by side
    const MomentPiece<T> at(x);
    const T* c = MomentTable<T>::main + at.piece * MomentTable<T>::terms * 4;
    const V square = V::all(at.s * at.s);
    V both = V::load_aligned(c + terms * 4 - 8);
#pragma GCC unroll 8
    for (int n = terms - 4; n >= 0; n -= 2) both = multiply_add(both, square, V::load_aligned(c + n * 4));
    Lanes<T, 4> sum = both.fold(at.s);
    if (at.far) [[unlikely]]
        sum = sum * far_powers(at.size, x >= 0);
    return sum;
}

/// F_a(x) for one a, times exp(x^2/2) for x >= 0.
template <int TwiceA, Real T>
T scaled_moment(T x) {
    if constexpr (std::same_as<T, float>) {
        return static_cast<float>(scaled_moment<TwiceA>(static_cast<double>(x)));
    } else {
        using Table = MomentTable<T>;
        constexpr bool main = TwiceA >= 0 && TwiceA <= 3;
        constexpr int stride = main ? 4 : 2, column = main ? TwiceA : TwiceA < 0 ? 0 : 1;
        const MomentPiece<T> at(x);
        const T* c = (main ? Table::main : Table::side) + (at.piece + 1) * Table::terms * stride + column;
        T sum = 0;
        for (int n = 0; n < Table::terms; ++n) sum = sum * at.s + *(c -= stride);
        return at.far ? sum * (x >= 0 ? half_power<-TwiceA - 2>(at.size, std::sqrt(at.size))
                                      : half_power<TwiceA>(at.size, std::sqrt(at.size)))
                      : sum;
    }
}

/// exp(-x^2/2), without the loss of x^2 epsilon that rounding x^2 costs: x = head + tail with so few digits in head that
/// head^2 is exact. By rounding down rather than by a sum and a difference, which a compiler may contract.
template <Real T>
T gaussian(T x) {
    using Limits = std::numeric_limits<T>;
    constexpr int whole = Limits::max_exponent > 10000 ? 8 : Limits::max_exponent > 1000 ? 6 : 4;  // binary digits of x
    if (!(std::abs(x) < T(1 << whole))) return T(0);                                               // underflows before
    constexpr T grid = T(std::int64_t{1} << (Limits::digits / 2 - whole));
    const T head = std::floor(x * grid) / grid;
    const T tail = x - head;
    return std::exp(-head * head / 2) * std::exp(-tail * (x + head) / 2);
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
