// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Moments of a Gaussian beyond a threshold: the inner integral of every contact quantity.
///
///     F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv = Gamma(a+1) exp(-x^2/4) D_{-a-1}(x)          F_a' = -a F_{a-1}
///
/// D is Whittaker's parabolic cylinder function. Short polynomials (tools/make_gaussian_moment_table.py) cover eighths
/// of the octaves of |x| + 2; from |x| = 30 on, 1/x^2 is the variable. No recurrence: it cancels for x > 0.
///
/// Reference   NIST Digital Library of Mathematical Functions, 12.5.1
/// Units       dimensionless
/// Valid       a in {-1/2, 0, 1/2, 1, 3/2, 5/2}; any x that is a number: underflows to 0 for x > 38 (double). float is
///             computed in double
/// Accuracy    6 epsilon relative; 1 epsilon is typical (tests/math/gaussian_moment_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/gaussian_moment_table.hpp>
#include <fstiff/math/lanes.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace fstiff { inline namespace v0_1 { namespace math {

/// The pieces of the tables: eighths of the octaves of |x| + 2 for |x| < moment_far, and one beyond; for x < 0 too.
inline constexpr int moment_far = 30, pieces_a_side = 33;

EIGEN_ALWAYS_INLINE bool is_near(double x) { return std::abs(x) < moment_far; }

/// Place of a number that is_near: found from the bits of |x| + 2, without a branch.
struct NearPiece {
    double s;  ///< |x| less the middle of the piece
    std::int64_t piece;

    EIGEN_ALWAYS_INLINE explicit NearPiece(double x) {
        constexpr int eighths = 3, rest = 52 - eighths;  // of the 52 binary digits of a double
        const double size = std::abs(x);
        const auto upper = std::bit_cast<std::int64_t>(size + 2) >> rest;
        const double middle = std::bit_cast<double>((upper << rest) | (std::int64_t{1} << (rest - 1))) - 2;
        s = size - middle;
        piece = upper - (std::int64_t{1024} << eighths) + (x < 0 ? pieces_a_side : 0);
    }
};

/// Half-integer powers v^(TwiceA/2), given v and its square root.
template <int TwiceA>
double half_power(double v, double root) {
    if constexpr (TwiceA < 0) return 1 / half_power<-TwiceA>(v, root);
    if constexpr (TwiceA == 0) return 1;
    if constexpr (TwiceA == 1) return root;
    if constexpr (TwiceA > 1) return v * half_power<TwiceA - 2>(v, root);
}

/// The four polynomials of a piece at s, by their first \p terms.
template <int terms>
EIGEN_ALWAYS_INLINE Lanes<double, 4> moment_polynomials(std::int64_t piece, double s) {
    static_assert(terms % 2 == 0 && terms <= MomentTable::terms);
    using V = Lanes<double, 8>;  // even and odd powers side by side
    const double* c = MomentTable::main + piece * MomentTable::terms * 4;
    const V square = V::all(s * s);
    V pair = V::load_aligned(c + terms * 4 - 8);
    for (int n = terms - 4; n >= 0; n -= 2) pair = multiply_add(pair, square, V::load_aligned(c + n * 4));
    return pair.fold(s);
}

/// The four moments for |x| >= moment_far.
EIGEN_DONT_INLINE inline Lanes<double, 4> far_moments(double x) {
    const double size = std::abs(x), root = std::sqrt(size);
    double power[4] = {1, root, size, size * root};
    if (x > 0)
        for (double& term : power) term = 1 / (term * size);
    return moment_polynomials<MomentTable::terms>(x > 0 ? pieces_a_side - 1 : 2 * pieces_a_side - 1, 1 / size / size) *
           Lanes<double, 4>::load(power);
}

/// F_a(x) for a = 0, 1/2, 1, 3/2, times exp(x^2/2) for x >= 0, at eight monotone x, without under- and overflow. By the
/// first \p terms of each polynomial, an even number, with a relative error of MomentTable::cut[terms].
template <int terms>
EIGEN_ALWAYS_INLINE void scaled_moments(const double* x, std::array<Lanes<double, 4>, 8>& out) {
    if (is_near(x[0]) && is_near(x[7])) {
        double s[8];
        std::int64_t piece[8];
        for (int i = 0; i < 8; ++i) {
            const NearPiece place(x[i]);
            s[i] = place.s;
            piece[i] = place.piece;
        }
        for (int i = 0; i < 8; ++i) out[static_cast<std::size_t>(i)] = moment_polynomials<terms>(piece[i], s[i]);
    } else {
        const auto at_one = [](double argument) {
            if (!is_near(argument)) return far_moments(argument);
            const NearPiece place(argument);
            return moment_polynomials<terms>(place.piece, place.s);
        };
        for (int i = 0; i < 8; ++i) out[static_cast<std::size_t>(i)] = at_one(x[i]);
    }
}

/// F_a(x) for one a, times exp(x^2/2) for x >= 0.
template <int TwiceA, Real T>
T scaled_moment(T x) {
    if constexpr (std::same_as<T, float>) {
        return static_cast<float>(scaled_moment<TwiceA>(static_cast<double>(x)));
    } else {
        using Table = MomentTable;
        constexpr bool main = TwiceA >= 0 && TwiceA <= 3;
        constexpr int stride = main ? 4 : 2, column = main ? TwiceA : TwiceA < 0 ? 0 : 1;
        const auto sum = [](std::int64_t piece, double s) {
            const double* c = (main ? Table::main : Table::side) + (piece + 1) * Table::terms * stride + column;
            double value = 0;
            for (int n = 0; n < Table::terms; ++n) value = value * s + *(c -= stride);
            return value;
        };
        if (is_near(x)) {
            const NearPiece place(x);
            return sum(place.piece, place.s);
        }
        const double size = std::abs(x);
        const double inverse_square = 1 / size / size, root = std::sqrt(size);
        return x > 0 ? sum(pieces_a_side - 1, inverse_square) * half_power<-TwiceA - 2>(size, root)
                     : sum(2 * pieces_a_side - 1, inverse_square) * half_power<TwiceA>(size, root);
    }
}

/// exp(-x^2/2), without the loss of x^2 epsilon that rounding x^2 costs: x = head + tail with so few digits in head
/// that head^2 is exact. By rounding down rather than by a sum and a difference, which a compiler may contract.
template <Real T>
T gaussian(T x) {
    using Limits = std::numeric_limits<T>;
    constexpr int bits = Limits::max_exponent > 1000 ? 6 : 4;  // binary digits of x
    if (!(std::abs(x) < T(1 << bits))) return T(0);            // underflows before
    constexpr T grid = T(std::int64_t{1} << (Limits::digits / 2 - bits));
    const T head = std::floor(x * grid) / grid;
    const T tail = x - head;
    const T d = tail * (x + head) / 2;  // at most 1e-4, in float 1/16: five terms of exp(-d)
    return std::exp(-head * head / 2) * (1 - d * (1 - d / 2 * (1 - d / 3 * (1 - d / 4))));
}

/// Calls f.operator()<2a>() for the power \p a. \throws domain_error for a power that has no table.
template <Real T, class F>
auto with_power(T a, const F& f) {
    if (a == T(-0.5)) return f.template operator()<-1>();
    if (a == T(0)) return f.template operator()<0>();
    if (a == T(0.5)) return f.template operator()<1>();
    if (a == T(1)) return f.template operator()<2>();
    if (a == T(1.5)) return f.template operator()<3>();
    detail::require(a == T(2.5), "a", a, "-1/2, 0, 1/2, 1, 3/2 or 5/2");
    return f.template operator()<5>();
}

/// F_a(x). \throws domain_error for an a outside the list above or an x that is NaN.
template <Real T>
[[nodiscard]] T gaussian_moment(T a, T x) {
    detail::require(!std::isnan(x), "x", x, "a number");
    x = std::clamp(x, -(std::numeric_limits<T>::max)(), (std::numeric_limits<T>::max)());
    return with_power(a, [x]<int TwiceA>() { return scaled_moment<TwiceA>(x) * (x > 0 ? gaussian(x) : T(1)); });
}

}}}  // namespace fstiff::math
