// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One-dimensional rules of the two-dimensional kernel: the graded map, tables of nodes and weights, the errors that
/// the sums show, and the rows of constant curvature that they cover.
///
/// Reference   Trefethen and Weideman, SIAM Review 56 (2014) 385-458; Takahasi and Mori, Publ. RIMS 9 (1974) 721-741.
/// Units       dimensionless
/// Valid       up to 256 nodes of a trapezoidal rule, 64 of Legendre's
/// Accuracy    see peaks/tensor_integrals

#include <fstiff/math/quadrature.hpp>
#include <fstiff/peaks/peak_nodes.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real T>
using TensorLanes = Eigen::Array<T, 8, 1>;

/// The map x = a log(1 + exp(v)), v = y - b exp(-c y), from the whole line to x > 0.
template <Real T = double>
struct GradedMap {
    T a, b, c;
    T strip;  ///< measured: a rule of step h errs by exp(-strip/h) or more, 2 pi times the strip of analyticity

    /// A y below which x < exp(log_x), for small x.
    [[nodiscard]] T begin(T log_x) const {
        const T depth = std::log(a) - log_x;
        T y = -std::log(1 + depth / b) / c;
        for (int i = 0; i < 3; ++i) {  // Newton; v is concave: never too far right
            const T fall = b * std::exp(-c * y);
            y -= (y - fall + depth) / (1 + c * fall);
        }
        return y;
    }
    /// A y beyond which x is more than \p x, not much further.
    [[nodiscard]] T end(T x) const {
        const T v = at(x);
        return v + b * std::exp(-c * v);
    }
    /// v at \p x: less than y.
    [[nodiscard]] T at(T x) const { return x > 20 * a ? x / a : std::log(std::expm1(x / a)); }

    void map(const TensorLanes<T>& y, TensorLanes<T>& x, TensorLanes<T>& slope) const {
        const TensorLanes<T> fall = b * (-c * y).exp();
        const TensorLanes<T> v = y - fall;
        const TensorLanes<T> decay = (-v.abs()).exp();
        x = a * (v < T(-30)).select(decay, (v.max)(T(0)) + (1 + decay).log());
        slope = a * (1 + c * fall) * (v > T(0)).select(TensorLanes<T>::Ones(), decay) / (1 + decay);
    }
};
/// Map for pieces, and for the rows of a smooth law.
template <Real T>
inline constexpr GradedMap<T> plain_map{T(2.1), T(0.4), T(1.354), T(7)};
/// Map for rows across kinks and the layer of a large tan(theta): the passage of a kink at ~ 1/t, a Gaussian in 1/t,
/// allows no quicker fall towards t = 0. Found by search over kinks at 0.005/t to 2/t.
template <Real T>
inline constexpr GradedMap<T> gentle_map{T(2.5), T(0.005), T(1), T(3.3)};

/// Error of a trapezoidal rule over the whole line whose nodes were summed apart by their number modulo 8 (\p s).
///
/// The rule of step h errs by the transform of the integrand at the frequency 2 pi/h; the discrete transform of the
/// eight sums at k = 1 ... 4 is the transform at k/8 of it. From 4/8 it is extrapolated over \p falls eighths by the
/// slower of its last falls: four eighths for a smooth law, whose transform falls at least geometrically, fewer across
/// kinks, where its fall slows down. Where a kink makes it fall like a power (rough, none), the ratio of neighbours is
/// no guide, and the error is twice the size at 4/8: eight times the rest of a kink in the first derivative. \p even:
/// the nodes are those of y > 0 of an even function.
template <Real T>
EIGEN_DONT_INLINE T trapezoidal_error(TensorLanes<T> s, bool even, int falls) {
    constexpr T half_root = std::numbers::sqrt2_v<T> / 2;
    constexpr T least = (std::numeric_limits<T>::min)();
    if (even)
        s.template head<7>() =
            (s.template head<7>() + s.template head<7>().reverse().eval()) / 2;  // lane i: node 1 + i
    const T d0 = s[7] - s[3], d1 = s[0] - s[4], d2 = s[1] - s[5], d3 = s[2] - s[6];
    const T e0 = s[7] + s[3], e1 = s[0] + s[4], e2 = s[1] + s[5], e3 = s[2] + s[6];
    const auto modulus = [](T x, T y) { return std::sqrt(x * x + y * y); };
    const T at_2 = modulus(e0 - e2, e1 - e3) + least;
    const T last = std::abs((e0 + e2) - (e1 + e3));
    const T at_3 = (std::max)(modulus(d0 - half_root * (d1 - d3), d2 - half_root * (d1 + d3)), last) + least;
    const T before = (std::min)(T(1), at_3 / at_2);
    const T at_4 = (std::max)(last, at_3 * before * std::sqrt(before));  // it may vanish by accident
    const T fall = (std::min)(T(1), (std::max)(at_4 / at_3, std::sqrt(at_4 / at_2)));
    T error = 2 * at_4;
    for (int i = 0; i < falls; ++i) error *= fall;
    return error;
}

template <Real T = double>
struct LegendreNodes {
    int count;
    const T *node, *weight;

    template <std::size_t N>
    static LegendreNodes nodes() {
        const auto& rule = math::GaussLegendre<T, N>::get();
        return {static_cast<int>(N), rule.node.data(), rule.weight.data()};
    }
    static LegendreNodes at_least(int n) {
        if (n <= 16) return n <= 8 ? nodes<8>() : nodes<16>();
        if (n <= 32) return n <= 24 ? nodes<24>() : nodes<32>();
        if (n <= 48) return n <= 40 ? nodes<40>() : nodes<48>();
        return n <= 56 ? nodes<56>() : nodes<64>();
    }
};

/// The error of a Legendre rule of n nodes from the \p terms that it sums: their Legendre coefficients fall from n/2 to
/// n, and at least as far again to 2n: as for a power, further for smooth functions.
template <Real T>
EIGEN_DONT_INLINE T legendre_error(const std::array<TensorLanes<T>, 8>& terms, int n) {
    const T* node = LegendreNodes<T>::at_least(n).node;
    const auto blocks = static_cast<std::size_t>(n / 8);
    std::array<TensorLanes<T>, 8> before, now;
    for (std::size_t b = 0; b < blocks; ++b) {
        before[b].setZero();
        now[b].setOnes();
    }
    T middle = 0, end = 0;
    for (int k = 0; k < n; ++k) {
        T coefficient = 0;
        for (std::size_t b = 0; b < blocks; ++b) {
            coefficient += (terms[b] * now[b]).sum();
            const TensorLanes<T> next =
                (T(2 * k + 1) * TensorLanes<T>::Map(node + 8 * b) * now[b] - T(k) * before[b]) / T(k + 1);
            before[b] = now[b];
            now[b] = next;
        }
        if (k == n / 2 - 1 || k == n / 2) middle = (std::max)(middle, T(2 * k + 1) * std::abs(coefficient));
        if (k >= n - 2) end = (std::max)(end, T(2 * k + 1) * std::abs(coefficient));
    }
    return 2 * end * (std::min)(T(1), end / (middle + (std::numeric_limits<T>::min)()));
}

/// Nodes, weights and sums of one rule, in blocks of eight.
template <Real T = double>
struct TensorTable {
    static constexpr int max_nodes = 256;
    int nodes = 0;
    bool legendre = false;
    T min_error = 0;  ///< loss by the map, relative to the sum of the moduli
    std::array<TensorLanes<T>, max_nodes / 8> x, weight;
    std::array<TensorLanes<T>, 8> sums;  ///< of a trapezoidal rule only the first: nodes apart by their number modulo 8

    [[nodiscard]] std::size_t blocks() const { return static_cast<std::size_t>(nodes + 7) / 8; }

    /// The trapezoidal rule, y = begin + j step, j = 1, 2, ...; \p map(y, x, dx/dy).
    template <class Map>
    void trapezoidal(T begin, T step, int count, const Map& map) {
        nodes = count;
        legendre = false;
        min_error = 0;
        TensorLanes<T> y = begin + step * TensorLanes<T>::LinSpaced(1, 8);
        for (std::size_t b = 0; b < blocks(); ++b, y += 8 * step) {
            map(y, x[b], weight[b]);
            weight[b] *= step;
        }
        sums[0].setZero();
    }
    EIGEN_DONT_INLINE void squares(T begin, T step, int count) {
        trapezoidal(begin, step, count, [](const auto& y, auto& node, auto& slope) {
            node = y.square();
            slope = 2 * y;
        });
    }
    EIGEN_DONT_INLINE void line(T step, int count) {
        trapezoidal(T(0), step, count, [](const auto& y, auto& node, auto& slope) {
            node = y;
            slope.setOnes();
        });
    }
    EIGEN_DONT_INLINE void graded(const GradedMap<T>& map, T begin, T step, int count) {
        trapezoidal(begin, step, count, [&](const auto& y, auto& node, auto& slope) { map.map(y, node, slope); });
        min_error = 6 * std::exp(-map.strip / step);
    }

    /// Legendre's rule on (0, 1) in u, x = u^power, or for \p ratio > 1 x = (ratio^u - 1)/(ratio - 1).
    EIGEN_DONT_INLINE void legendre_rule(int count, int power, T ratio) {
        const auto rule = LegendreNodes<T>::at_least(count);
        nodes = rule.count;
        legendre = true;
        for (std::size_t b = 0; b < blocks(); ++b) {
            const TensorLanes<T> u = (TensorLanes<T>::Map(rule.node + 8 * b) + 1) / 2;
            weight[b] = T(power) / 2 * TensorLanes<T>::Map(rule.weight + 8 * b);
            x[b] = u;
            for (int i = 1; i < power; ++i) {
                weight[b] *= u;
                x[b] *= u;
            }
            if (ratio > 1) {
                const TensorLanes<T> up = (std::log(ratio) * u).exp();
                x[b] = (up - 1) / (ratio - 1);
                weight[b] *= std::log(ratio) / (ratio - 1) * up;
            }
            sums[b].setZero();
        }
    }

    [[nodiscard]] T error(bool even, int falls) const {
        if (nodes == 0) return 0;
        if (legendre) return legendre_error(sums, nodes);
        return trapezoidal_error<T>(sums[0], even, falls) + min_error * sums[0].abs().sum();
    }
};

/// Factors of the density for eight rows, for any law.
template <Real T = double>
struct TensorRows {
    TensorLanes<T> t, weight;
    TensorLanes<T> x;                     ///< (eta - r t)/c
    TensorLanes<T> outer, shift, linear;  ///< the exponent at e = c v is outer - (v + shift)^2/2 - linear v
    TensorLanes<T> first, last;           ///< window of e; last <= 0: none
    TensorLanes<T> step;                  ///< of sqrt(e/c), for squares

    /// All but t and weight. The step is chosen for an error exp(-digits): exp(-(w^2 + x)^2/2) grows by exp(4 b^4 - 2 x
    /// b^2) (and exp(x^2/2) for x > 0) from the real axis to w + i b, so that its rule errs by that times exp(-2 pi
    /// b/step), for the best b. Beyond x^2 = 6 digits it is the Gaussian exp(-x w^2).
    EIGEN_DONT_INLINE void prepare(const PeakProblem<T>& p, T digits) {
        const TensorLanes<T> square = 2 * p.log_cutoff - (t - p.floor) * (t + p.floor);
        const TensorLanes<T> wide = p.c * (square.max)(T(0)).sqrt(), distance = p.eta - p.r * t;
        const TensorLanes<T> z = (t - p.r * p.eta) / p.c;
        x = distance / p.c;
        const auto right = (x > T(0)).eval();
        outer = right.select(-z.square() / 2, (p.floor - t) * (t + p.floor) / 2);
        shift = (x.min)(T(0));
        linear = (x.max)(T(0));
        first = ((-distance - wide).max)(T(0));
        last = right.select((2 * p.log_cutoff - z.square()) * (p.c * p.c) / (wide + distance), wide - distance);
        last = (square > T(0)).select(last, T(0));

        constexpr T least = (std::numeric_limits<T>::min)(), half_pi = std::numbers::pi_v<T> / 2;
        const TensorLanes<T> capped = (x.min)(std::sqrt(6 * digits));
        const TensorLanes<T> root = ((1 + 6 * right.template cast<T>()) * capped.square() + 12 * digits).sqrt();
        const TensorLanes<T> b2 = (capped + root) / 12;
        step = half_pi / (b2.sqrt() * (4 * b2 - capped)) * ((capped.abs() + least) / (x.abs() + least)).sqrt();
    }
};

}}}  // namespace fstiff::detail
