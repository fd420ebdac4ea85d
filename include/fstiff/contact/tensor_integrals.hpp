// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Integrals over the peaks in two dimensions, for any function of height and curvature: the kernel for asperity laws that are
/// no power laws.
///
///     I[f](eta) = int_0^inf int_eta^inf f(zeta - eta, t) p_peak(zeta, t) dzeta dt
///
/// With t = s^2 and zeta = eta + c w^2 and an f that is a half-integer power in both (Hertz: excess^(3/2) t^(-1/2)) the
/// integrand is even and entire in s and in w, and the plain trapezoidal rule over (0, inf)^2 converges geometrically:
/// Axis::even. For any other smooth f, Axis::graded takes t and the excess by the map 2.1 log(1 + exp(y - 0.4 exp(-1.354 y))),
/// which falls double exponentially at 0 whatever the power there, for twice the nodes. A law with a kink at a known excess
/// (f.critical(t), see KinkedLaw) is split there, the finite part taken by the tanh-sinh rule, and converges as fast; one
/// whose kink is not known is for Axis::rough: algebraic convergence, and an error estimate that does not hope for more.
///
/// Each row of constant t is one loop over Eigen arrays; its window in w moves with the Gaussian in zeta. Nodes are added
/// until the tolerance is met: the error estimate is that of TensorSums.
///
/// Reference   Trefethen and Weideman, SIAM Review 56 (2014) 385-458; Takahasi and Mori, Publ. RIMS 9 (1974) 721-741.
/// Units       dimensionless
/// Valid       theta and r that the mesh can resolve: c >= 0.1, tan(theta) <= 10; beyond, the error returned says how much is lost
/// Accuracy    1e-12 on tests/data/integrals_plain.csv (tests/contact/tensor_integrals_test.cpp)

#include <fstiff/contact/peak_sums.hpp>
#include <fstiff/core/estimate.hpp>
#include <fstiff/core/numbers.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>

namespace fstiff {

/// How the nodes approach t = 0 and excess = 0.
enum class Axis {
    even,    ///< for half-integer powers of the excess and of t
    graded,  ///< for any that is smooth, or whose kink is known
    rough    ///< for any: as graded, with an error estimate for algebraic convergence
};

/// A law that says at which excess it has a kink, given the curvature t.
template <class F, class T>
concept KinkedLaw = requires(const F& f, T t) {
    { f.critical(t) } -> std::convertible_to<T>;
};

template <Real T>
struct TensorOptions {
    T relative_tolerance = T(1e4) * std::numeric_limits<T>::epsilon();
    int most_nodes = 192;  ///< per direction, taken in eights; the error estimate says when they were not enough
};

namespace detail {

template <Real T>
using TensorLanes = Eigen::Array<T, 8, 1>;

/// A node on one axis and dx/dy there, for y = j step, j = 1, 2, ...
template <Axis axis, Real T>
void map_nodes(const TensorLanes<T>& y, TensorLanes<T>& x, TensorLanes<T>& slope) {
    if constexpr (axis == Axis::even) {
        x = y.square();
        slope = 2 * y;
    } else {
        const TensorLanes<T> fall = T(0.4) * (T(-1.354) * y).exp();
        const TensorLanes<T> v = y - fall;
        const TensorLanes<T> small = (-v.abs()).exp();
        x = T(2.1) * (v.max(T(0)) + (1 + small).log());
        x = (v < T(-30)).select(T(2.1) * small, x);
        slope = T(2.1) * (1 + T(1.354) * fall) * (v > T(0)).select(TensorLanes<T>::Ones(), small) / (1 + small);
    }
}

/// The y where a window that begins or ends at \p x does, or a little outside; \p depth as in PeakProblem.
template <Axis axis, Real T>
T window_begin(T x, T depth) {
    if constexpr (axis == Axis::even) return std::sqrt(std::max(x, T(0)));
    const T left = -std::log((depth + 2) / T(0.4)) / T(1.354);
    return x > 0 ? std::max(left, std::log(std::expm1(x / T(2.1)))) : left;
}
template <Axis axis, Real T>
T window_end(T x) {
    if constexpr (axis == Axis::even) return std::sqrt(x);
    const T y = x > T(20) ? x / T(2.1) : std::log(std::expm1(x / T(2.1)));
    return y + T(0.4) * std::exp(T(-1.354) * y);
}

/// Trapezoidal sums over one direction, apart by the number of the node modulo 8, and the error of their rule.
///
/// The rule of step h errs by the transform of the integrand at the frequency 2 pi/h; the discrete transform of the eight
/// sums at k = 1 ... 4 is the transform at k/8 of it. From 4/8 it is extrapolated by its last falls: to their fourth power
/// for the geometric convergence of a smooth law. Where a kink makes it fall like a power (rough), the ratio of neighbours
/// says little, and twice the size at 4/8 stands: eight times what a kink in the first derivative leaves.
template <Real T>
struct TensorSums {
    TensorLanes<T> even = TensorLanes<T>::Zero();     ///< nodes j h, j > 0, of integrands that go on evenly to j < 0
    TensorLanes<T> shifted = TensorLanes<T>::Zero();  ///< nodes of windows that begin elsewhere

    [[nodiscard]] T total() const { return even.sum() + shifted.sum(); }

    /// \p falls: over how many eighths to extrapolate.
    [[nodiscard]] T error(int falls) const {
        constexpr T half_root = numbers::sqrt2_v<T> / 2;
        const auto extrapolated = [falls](const TensorLanes<T>& s, bool with_sine) {
            // lane i holds node 1 + i: differences and sums of opposite lanes
            const T d0 = s[7] - s[3], d1 = s[0] - s[4], d2 = s[1] - s[5], d3 = s[2] - s[6];
            const T e0 = s[7] + s[3], e1 = s[0] + s[4], e2 = s[1] + s[5], e3 = s[2] + s[6];
            const auto modulus = [with_sine](T x, T y) { return with_sine ? std::sqrt(x * x + y * y) : std::abs(x); };
            const T at_1 = modulus(d0 + half_root * (d1 - d3), d2 + half_root * (d1 + d3));
            const T at_2 = modulus(e0 - e2, e1 - e3);
            const T at_4 = std::abs((e0 + e2) - (e1 + e3));
            const T at_3 = std::max(modulus(d0 - half_root * (d1 - d3), d2 - half_root * (d1 + d3)),
                                    at_4);  // one may vanish by accident
            constexpr T least = std::numeric_limits<T>::min();
            const T fall = std::min(
                T(1), std::max({at_4 / (at_3 + least), at_3 / (at_2 + least), std::sqrt(at_3 / (at_1 + least))}));
            T last = 2 * std::max(at_4, at_3 * fall);
            for (int i = 0; i < falls; ++i) last *= fall;
            return last;
        };
        return extrapolated(even, false) + extrapolated(shifted, true);
    }
};

template <Axis axis, Real T, class F>
class TensorRule {
public:
    TensorRule(const F& f, const PeakProblem<T>& problem) : f_(f), p_(problem) {}

    /// The rule with \p nodes intervals each way, a multiple of 8.
    /// \return what the layer of width 1/k at t = 0 may hide when no row falls into it, else 0
    T evaluate(int nodes, TensorSums<T>& rows, TensorSums<T>& columns) const {
        rows = columns = {};
        T hidden = 0;
        const T begin = window_begin<axis>(p_.r * p_.eta - p_.reach * p_.c, p_.depth);
        const T step = (window_end<axis>(largest_curvature(p_)) - begin) / T(nodes);
        TensorLanes<T> t, slope, erf, weight, of_row;
        for (int i = 0; i < nodes; i += 8) {
            map_nodes<axis, T>(begin + (T(i) + numbers()) * step, t, slope);
            erf_of_eight(t.data(), p_.k, erf.data());
            weight = step * slope * erf;
            for (int lane = 0; lane < 8; ++lane) of_row[lane] = inner(t[lane], weight[lane], nodes, columns);
            (axis == Axis::even && begin == 0 ? rows.even : rows.shifted) += of_row;
            if (i == 0 && p_.k * t[0] > 1) hidden = of_row[0];
        }
        return hidden;
    }

private:
    static TensorLanes<T> numbers() { return (TensorLanes<T>() << 1, 2, 3, 4, 5, 6, 7, 8).finished(); }

    /// int f exp(-(zeta - r t)^2/(2 c^2)) dzeta/c exp((floor^2 - t^2)/2) at one t, times \p weight; its nodes go to \p columns.
    T inner(T t, T weight, int nodes, TensorSums<T>& columns) const {
        const T x = (p_.eta - p_.r * t) / p_.c;
        const T root = std::sqrt(x * x + 2 * p_.depth);
        const T furthest = x > 0 ? 2 * p_.depth / (root + x) : p_.reach - x;
        const T nearest = std::max(T(0), -x - p_.reach);
        const T z = (t - p_.r * p_.eta) / p_.c;
        const T outer = x > 0 ? -z * z / 2 : -(t - p_.floor) * (t + p_.floor) / 2;
        const T shift = x > 0 ? T(0) : x;  // the exponent is -(v + x)^2/2, plus x^2/2 for x > 0
        const T linear = x > 0 ? x : T(0);
        const auto integrand = [&](const TensorLanes<T>& v) -> TensorLanes<T> {
            return (outer - (v + shift).square() / 2 - linear * v).exp() * f_((p_.c * v).eval(), t);
        };
        T kink = 0;
        if constexpr (KinkedLaw<F, T>) kink = f_.critical(t) / p_.c;
        TensorLanes<T> below = TensorLanes<T>::Zero();
        if (kink > nearest && kink < furthest) {  // tanh-sinh from nearest to the kink
            const T end = std::asinh((p_.depth + 3) / numbers::pi_v<T>);
            const T step = 2 * end / T(nodes);
            TensorLanes<T> y = numbers() * step - end;
            for (int j = 0; j < nodes; j += 8, y += 8 * step) {
                const TensorLanes<T> rise = y.exp(), fall = 1 / rise;
                const TensorLanes<T> small =
                    (numbers::pi_v<T> / 2 * (fall - rise).abs().min(T(200))).exp().inverse();  // exp(-pi |sinh y|)
                const TensorLanes<T> share = (y < T(0)).select(small, TensorLanes<T>::Ones()) / (1 + small);
                const TensorLanes<T> slope = numbers::pi_v<T> / 2 * (rise + fall) * small / (1 + small).square();
                below += slope * integrand(nearest + (kink - nearest) * share);
            }
            below *= weight * step * (kink - nearest);
        } else {
            kink = 0;
        }
        const T start = x + kink;
        const T scale = axis != Axis::even && start > 0 ? 1 / (1 + start / 2) : T(1);  // it falls as exp(-start v)
        const T begin = window_begin<axis>((kink > 0 ? T(0) : -x - p_.reach) / scale, p_.depth);
        const T step = (window_end<axis>((furthest - kink) / scale) - begin) / T(nodes);
        TensorLanes<T> y = begin + numbers() * step;
        TensorLanes<T> v, slope, total = TensorLanes<T>::Zero();
        for (int j = 0; j < nodes; j += 8, y += 8 * step) {
            map_nodes<axis, T>(y, v, slope);
            total += slope * integrand(kink + scale * v);
        }
        total = below + weight * step * scale * total;
        (axis == Axis::even && begin == 0 ? columns.even : columns.shifted) += total;
        return total.sum();
    }

    const F& f_;
    const PeakProblem<T>& p_;
};

}  // namespace detail

/// I[f] at the separation \p eta (in rms heights), without its factor exp(-eta^2/2) where eta > 0. \p f takes an Eigen array of
/// eight excess heights zeta - eta and one curvature t, and returns the array of values. Does not allocate.
/// \throws domain_error unless |eta| <= 1e6.
template <Axis axis, Real T, class F>
[[nodiscard]] Estimate<T> scaled_tensor_integral(const F& f, const PeakDensity<T>& peaks, T eta,
                                                 const TensorOptions<T>& options = {}) {
    require(std::abs(eta) <= T(1e6), "eta", eta, "a number between -1e6 and 1e6");
    const T digits = -std::log(options.relative_tolerance);
    const detail::PeakProblem<T> problem(peaks, eta, digits + 9);
    const detail::TensorRule<axis, T, F> rule(f, problem);
    detail::TensorSums<T> rows, columns;
    constexpr int falls = axis == Axis::rough ? 0
                          : KinkedLaw<F, T>   ? 2
                                              : 4;  // the passage of a kink is smooth, but abrupt
    // what plain problems need, more where the Gaussian is narrow or far from the separation
    const T wanted = digits * (axis == Axis::even ? T(0.1) / std::cbrt(problem.c) *
                                                        (1 + T(0.06) * std::min(std::max(T(0), -eta), T(5)))
                                                  : T(0.2));
    const int most = std::max(8, options.most_nodes / 8 * 8);
    int nodes = std::clamp(8 * static_cast<int>(std::ceil(wanted)), 8, most);
    Estimate<T> out;
    for (;;) {
        const T hidden = rule.evaluate(nodes, rows, columns);
        const T factor = 1 / (2 * problem.theta);
        out.value = factor * rows.total();
        const T rounding = std::numeric_limits<T>::epsilon() * (T(16) + problem.floor + std::abs(eta) / problem.c);
        const T error = factor * (rows.error(falls) + columns.error(falls) + hidden);
        out.error = error + (rounding + T(0.03) * options.relative_tolerance) * std::abs(out.value);
        out.evaluations += nodes * nodes;
        if (out.error <= options.relative_tolerance * std::abs(out.value) || nodes >= most) return out;
        // digits grow with the nodes
        const T reached = std::log(std::abs(out.value) / out.error);
        const T growth = reached > digits / 2 ? std::clamp(digits / reached, T(1.1), T(2)) : T(2);
        nodes = std::min(8 * static_cast<int>(std::ceil(T(nodes) * growth / 8)), most);
    }
}

/// J[a,b] in two dimensions: the slow twin of contact_integral. \throws domain_error as contact_integral.
template <Real T>
[[nodiscard]] Estimate<T> tensor_integral(T a, T b, const PeakDensity<T>& peaks, T eta,
                                          const TensorOptions<T>& options = {}) {
    static_cast<void>(detail::one_power(a, b));
    const auto monomial = [a, b](const detail::TensorLanes<T>& excess, T t) -> detail::TensorLanes<T> {
        const T power_of_t = b == 0 ? T(1) : b == T(-0.5) ? 1 / std::sqrt(t) : 1 / t;
        if (a == 0) return detail::TensorLanes<T>::Constant(power_of_t);
        if (a == T(0.5)) return power_of_t * excess.sqrt();
        if (a == T(1)) return power_of_t * excess;
        return power_of_t * excess * excess.sqrt();
    };
    const bool even = a != std::floor(a) && b != std::floor(b);
    const Estimate<T> scaled = even ? scaled_tensor_integral<Axis::even>(monomial, peaks, eta, options)
                                    : scaled_tensor_integral<Axis::graded>(monomial, peaks, eta, options);
    const T scale = detail::gaussian(std::max(eta, T(0)));
    return {scaled.value * scale, scaled.error * scale + std::numeric_limits<T>::denorm_min(), scaled.evaluations};
}

}  // namespace fstiff
