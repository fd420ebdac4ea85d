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
/// Axis::even. For any other f, Axis::graded takes t and the excess by the map 2.1 log(1 + exp(y - 0.4 exp(-1.354 y))), which
/// falls double exponentially at 0 whatever the power there, for twice the nodes.
///
/// Each row of constant t is one loop over Eigen arrays; its window in w moves with the Gaussian in zeta. The number of nodes
/// is doubled until the tolerance is met. Rules of step h, 2h and 4h share their nodes in both directions; the error
/// estimate is the difference of the first two times its last decrease: right for geometric convergence and, unlike the
/// square, still right where a kink of f makes the convergence algebraic.
///
/// Reference   Trefethen and Weideman, SIAM Review 56 (2014) 385-458.
/// Units       dimensionless
/// Valid       theta and r that the mesh can resolve: c >= 0.1, tan(theta) <= 10; beyond, the error returned says how much is lost
/// Accuracy    1e-12 on tests/data/integrals_plain.csv (tests/contact/tensor_integrals_test.cpp)

#include <fstiff/contact/peak_sums.hpp>
#include <fstiff/core/estimate.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace fstiff {

/// How the nodes approach t = 0 and excess = 0.
enum class Axis {
    even,   ///< for half-integer powers of the excess and of t
    graded  ///< for any
};

template <Real T>
struct TensorOptions {
    T relative_tolerance = T(1e4) * std::numeric_limits<T>::epsilon();
    int most_nodes = 192;  ///< per direction; the error estimate says when they were not enough
};

namespace detail {

/// Sums of the rules of step h, 2h, 4h.
template <Real T>
using Nested = std::array<T, 3>;

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

template <Axis axis, Real T, class F>
class TensorRule {
public:
    TensorRule(const F& f, const PeakProblem<T>& problem) : f_(f), p_(problem) {}

    /// Rules with \p nodes intervals each way: by_row[i] has row step 2^i h and the finest columns, by_column the reverse.
    /// \return what the layer of width 1/k at t = 0 may hide when no row falls into it, else 0
    T evaluate(int nodes, Nested<T>& by_row, Nested<T>& by_column) const {
        by_row = by_column = {};
        T hidden = 0;
        const T begin = window_begin<axis>(p_.r * p_.eta - p_.reach * p_.c, p_.depth);
        const T step = (window_end<axis>(largest_curvature(p_)) - begin) / T(nodes);
        TensorLanes<T> y, t, slope;
        for (int i = 0; i < nodes; i += 8) {
            for (int lane = 0; lane < 8; ++lane) y[lane] = begin + T(i + 1 + lane) * step;
            map_nodes<axis>(y, t, slope);
            for (int lane = 0; lane < 8; ++lane) {
                const int j = i + 1 + lane;
                const Nested<T> row = inner(t[lane], nodes);
                const T weight = step * slope[lane] * std::erf(p_.k * t[lane]);
                if (j == 1 && p_.k * t[lane] > 1) hidden = weight * row[0];
                for (std::size_t level = 0; level < 3; ++level) {
                    by_column[level] += weight * row[level];
                    if (j % (1 << level) == 0) by_row[level] += T(1 << level) * weight * row[0];
                }
            }
        }
        return hidden;
    }

private:
    /// int f exp(-(zeta - r t)^2/(2 c^2)) dzeta/c exp((floor^2 - t^2)/2) at one t.
    Nested<T> inner(T t, int nodes) const {
        const T x = (p_.eta - p_.r * t) / p_.c;
        const T root = std::sqrt(x * x + 2 * p_.depth);
        const T furthest = x > 0 ? 2 * p_.depth / (root + x) : p_.reach - x;
        const T scale = axis == Axis::graded && x > 0 ? 1 / (1 + x / 2) : T(1);  // for x > 0 it falls as exp(-x v)
        const T begin = window_begin<axis>((-x - p_.reach) / scale, p_.depth);
        const T step = (window_end<axis>(furthest / scale) - begin) / T(nodes);
        const T z = (t - p_.r * p_.eta) / p_.c;
        const T outer = x > 0 ? -z * z / 2 : -(t - p_.floor) * (t + p_.floor) / 2;
        const T shift = x > 0 ? T(0) : x;  // the exponent is -(v + x)^2/2, plus x^2/2 for x > 0
        const T linear = x > 0 ? x : T(0);
        TensorLanes<T> numbers, y, v, slope;
        numbers << 1, 2, 3, 4, 5, 6, 7, 8;
        TensorLanes<T> total = TensorLanes<T>::Zero();
        for (int j = 0; j < nodes; j += 8) {
            y = begin + (T(j) + numbers) * step;
            map_nodes<axis>(y, v, slope);
            v *= scale;
            total += slope * (outer - (v + shift).square() / 2 - linear * v).exp() * f_((p_.c * v).eval(), t);
        }
        const T fours = total[3] + total[7];
        const T twos = fours + total[1] + total[5];
        const T all = twos + (total[0] + total[4]) + (total[2] + total[6]);
        return {step * scale * all, 2 * step * scale * twos, 4 * step * scale * fours};
    }

    const F& f_;
    const PeakProblem<T>& p_;
};

/// Error of the finest rule of a nested sum, see the file comment; the last factor allows for first-order convergence.
template <Real T>
T nested_error(const Nested<T>& sum) {
    const T last = std::abs(sum[0] - sum[1]);
    const T before = std::abs(sum[1] - sum[2]);
    return before > 0 ? 2 * last * std::min(last / before, T(1)) : last;
}

}  // namespace detail

/// I[f] at the separation \p eta (in rms heights), without its factor exp(-eta^2/2) where eta > 0. \p f takes an Eigen array of
/// eight excess heights zeta - eta and one curvature t, and returns the array of values. Does not allocate.
/// \throws domain_error unless |eta| <= 1e6.
template <Axis axis, Real T, class F>
[[nodiscard]] Estimate<T> scaled_tensor_integral(const F& f, const PeakDensity<T>& peaks, T eta, const TensorOptions<T>& options = {}) {
    require(std::abs(eta) <= T(1e6), "eta", eta, "a number between -1e6 and 1e6");
    const T digits = -std::log(options.relative_tolerance);
    const detail::PeakProblem<T> problem(peaks, eta, digits + 9);
    const detail::TensorRule<axis, T, F> rule(f, problem);
    detail::Nested<T> by_row, by_column;
    // 24 even or 48 graded nodes give 13 digits on plain problems; fewer digits need proportionally fewer
    int nodes = std::clamp(8 * static_cast<int>(std::ceil(digits * (axis == Axis::even ? T(0.1) : T(0.2)))), 16, options.most_nodes);
    Estimate<T> out;
    for (;; nodes = std::min(2 * nodes, options.most_nodes)) {
        const T hidden = rule.evaluate(nodes, by_row, by_column);
        const T factor = 1 / (2 * problem.theta);
        out.value = factor * by_row[0];
        out.error = factor * (detail::nested_error(by_row) + detail::nested_error(by_column) + hidden) +
                    (std::numeric_limits<T>::epsilon() * (T(16) + problem.floor + std::abs(eta) / problem.c) + T(0.03) * options.relative_tolerance) * std::abs(out.value);
        out.evaluations += nodes * nodes;
        if (out.error <= options.relative_tolerance * std::abs(out.value) || nodes >= options.most_nodes) return out;
    }
}

/// J[a,b] in two dimensions: the slow twin of contact_integral. \throws domain_error as contact_integral.
template <Real T>
[[nodiscard]] Estimate<T> tensor_integral(T a, T b, const PeakDensity<T>& peaks, T eta, const TensorOptions<T>& options = {}) {
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
