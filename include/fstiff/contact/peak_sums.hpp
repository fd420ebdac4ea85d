// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The trapezoidal rules behind contact_integrals.hpp: three substitutions that make the integrand over the curvature t smooth.
///
///     J[a,b] = c^a/(2 theta) int_0^inf t^b erf(k t) exp(-t^2/2) F_a(x(t)) dt,   x = (eta - r t)/c,  k = tan(theta)/sqrt 2
///
/// Where the integrand lives: for x > 0 it is exp(-eta^2/2) times a Gaussian in t of mean r eta and width c times an algebraic
/// function of x; for x < 0 it is exp(-t^2/2) |x|^a. It has a branch point at t = 0, a layer of width 1/k there, and turns on
/// within c/r of t = eta/r. Every rule is a trapezoidal rule over the whole line in y, so that it converges geometrically, and
/// holds the rule of twice the step within itself, whose difference is the error estimate. exp(-eta^2/2) is taken out where
/// eta > 0: nothing over- or underflows and the far tail keeps its relative accuracy.
///
///     smooth      t = 2.1 log(1 + exp(y - 0.4 exp(-1.354 y)))   from tables; linear for large t, double exponential at t = 0
///     graded      t = s exp(y - exp(-y))                        all scales from s = min(1, 1/k, c + max(0, -eta)) to 1 alike
///     separated   x = -(3 y + exp(y)), t = (eta - c x)/r        the Gaussian clear of t = 0: linear across it, graded beyond
///                                                               the turn-on; x as variable cancels nothing as c -> 0
///
/// The constants of the smooth map were found by search: 32 nodes for 3e-13 on all four integrals, -3 <= eta <= 4,
/// r <= 0.82, pi/4 <= theta <= pi/3.
///
/// Reference   Trefethen and Weideman, SIAM Review 56 (2014) 385-458 (trapezoidal rule); Takahasi and Mori, Publ. RIMS 9
///             (1974) 721-741 (double exponential substitution).
/// Accuracy    see contact_integrals.hpp

#include <fstiff/core/concepts.hpp>
#include <fstiff/math/error_function.hpp>
#include <fstiff/math/gaussian_moment.hpp>
#include <fstiff/peaks/peak_density.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fstiff {

namespace detail {

/// J of up to four powers a = 0, 1/2, 1, 3/2 at once, without the factor c^a/(2 theta) exp(-floor^2/2), by a trapezoidal rule
/// of step h, and the relative error that its nodes tell of.
template <Real T>
struct PeakSums {
    std::array<T, 4> value{};
    std::array<T, 4> relative_error{};
    int nodes{};
};

/// Sum of the lanes, and the error of the trapezoidal rule relative to it.
///
/// The rule of step h errs by the Fourier transform of the integrand at the frequency 2 pi/h, and lane m of the eight holds
/// the rule of step 8h shifted by m h: the discrete transform of the lanes at k = 2 and 3 is the transform of the integrand at
/// k/8 of that frequency. It falls geometrically, and its modulus, unlike the difference of two rules, has no accidental
/// zeros; so it is extrapolated from 2/8 and 3/8 to 1, with half of one of the five steps left out to be on the safe side. What is cut
/// off beyond the first and the last node falls faster than geometrically: it is less than the two outermost terms.
template <Real T>
void finish_sum(const Lanes<T>& lanes, const Lanes<T>& first, const Lanes<T>& last, T step, T& value, T& relative_error) {
    std::array<T, Lanes<T>::size> s, begin, end;
    lanes.store(s.data());
    first.store(begin.data());
    last.store(end.data());
    constexpr T half_root = std::numbers::sqrt2_v<T> / 2;
    const std::array<T, 4> odd{s[0] - s[4], s[1] - s[5], s[2] - s[6], s[3] - s[7]};
    const std::array<T, 4> even{s[0] + s[4], s[1] + s[5], s[2] + s[6], s[3] + s[7]};
    const auto square = [](T x, T y) { return x * x + y * y; };
    const T at_2 = square(even[0] - even[2], even[1] - even[3]);
    const T at_3 = square(odd[0] + half_root * (odd[3] - odd[1]), odd[2] - half_root * (odd[1] + odd[3]));
    const T total = (even[0] + even[2]) + (even[1] + even[3]);
    const T ratio = at_2 > 0 ? std::min(at_3 / at_2, T(1)) : T(1);
    value = step * total;
    relative_error = total > 0 ? (2 * std::sqrt(at_3 * std::sqrt(ratio)) * ratio * ratio + 2 * (begin.front() + end.back())) / total : T(0);
}

/// What is asked for: minus_two_b[i] is -2b (0, 1 or 2) for a = i/2, or absent.
inline constexpr int absent = -1;
using PowerSet = std::array<int, 4>;

/// minus_two_b of one integral. \throws domain_error for powers that are not offered.
template <Real T>
PowerSet one_power(T a, T b) {
    require(a == T(0) || a == T(0.5) || a == T(1) || a == T(1.5), "a", a, "0, 1/2, 1 or 3/2");
    require(b == T(0) || b == T(-0.5) || b == T(-1), "b", b, "0, -1/2 or -1");
    PowerSet set{absent, absent, absent, absent};
    set[static_cast<std::size_t>(2 * a)] = static_cast<int>(-2 * b);
    return set;
}

/// One evaluation: the parameters that all nodes share.
template <Real T>
struct PeakProblem {
    T r, theta, eta;
    PowerSet minus_two_b;
    T depth;  ///< -log of what may be neglected
    T c = std::sqrt((1 - r) * (1 + r));
    T k = std::tan(theta) / std::numbers::sqrt2_v<T>;
    T floor = std::max(eta, T(0));    ///< exp(-floor^2/2) is taken out of every node: the rest is of order 1
    T reach = std::sqrt(2 * depth);  ///< exp(-reach^2/2) may be neglected

    /// Below it erf(k t)/(2 theta) is t/sqrt(2 pi) to the last digit, while erf(k t) might underflow.
    static inline const T least_theta = std::sqrt(std::numeric_limits<T>::epsilon()) / 100;

    PeakProblem(const PeakDensity<T>& peaks, T at_eta, const PowerSet& powers, T neglect_depth)
        : r(peaks.r()), theta(std::max(peaks.theta(), least_theta)), eta(at_eta), minus_two_b(powers), depth(neglect_depth) {}
};

/// Adds eight nodes at a time to the sums.
template <Real T>
class PeakAccumulator {
public:
    using V = Lanes<T>;
    explicit PeakAccumulator(const PeakProblem<T>& problem) : p_(problem) { sum_.fill(V(T(0))); }

    /// Nodes at ascending curvatures t with weights; x = (eta - r t)/c, z = (t - r eta)/c, excess = t - floor.
    /// The ends of t and x are given as numbers too: they decide which polynomials are needed.
    void add(const V& t, const V& x, const V& z, const V& excess, const V& weight, T t_first, T t_last, T x_first, T x_last) {
        const V zero{T(0)};
        const bool right = x_first >= 0;
        const bool middle = x_last < 0 && x_first > -moment_middle;
        const bool far = x_last < -moment_middle;
        const bool left = middle || far;

        // exp(-(t^2 + x^2)/2) without the factor exp(-floor^2/2); for x < 0 the moment is not scaled and x^2 stays out
        V exponent;
        if (right) exponent = z * z;
        if (left) {
            const V outer = excess * (t + V(p_.floor));
            exponent = right ? select_less(x, zero, outer, exponent) : outer;
        }
        const V g = weight * erf_ascending(V(p_.k) * t, p_.k * t_first, p_.k * t_last) * exp(exponent * V(T(-0.5)));
        const V inverse_t = V(T(1)) / t;
        const std::array<V, 3> scaled{g, g * sqrt(inverse_t), g * inverse_t};  // g t^b

        V right_inverse, right_root, right_u, middle_u, far_u, far_size, far_root;
        if (right) {
            const V clamped = max(x, zero);
            right_inverse = V(T(1)) / (clamped + V(T(4)));
            right_root = sqrt(right_inverse);
            right_u = (clamped - V(T(4))) * right_inverse;
        }
        if (middle) middle_u = multiply_add(min(max(x, V(T(-moment_middle))), zero), V(T(2) / moment_middle), V(T(1)));
        if (far) {
            far_size = max(zero - x, V(T(moment_middle)));
            far_root = sqrt(far_size);
            const V ratio = V(T(moment_middle)) / far_size;
            far_u = multiply_add(ratio + ratio, ratio, V(T(-1)));
        }
        const auto moment = [&]<int TwiceA>() {
            if (p_.minus_two_b[TwiceA] == absent) return;
            V value;
            if (right) value = moment_right<TwiceA, T>(right_u, right_inverse, right_root);
            if (middle) {
                const V m = moment_middle_range<TwiceA, T>(middle_u);
                value = right ? select_less(x, zero, m, value) : m;
            }
            if (far) {
                const V f = moment_far<TwiceA, T>(far_u, far_size, far_root);
                value = right || middle ? select_less(x, V(T(-moment_middle)), f, value) : f;
            }
            last_[TwiceA] = scaled[static_cast<std::size_t>(p_.minus_two_b[TwiceA])] * value;
            if (nodes_ == 0) first_[TwiceA] = last_[TwiceA];
            sum_[TwiceA] = sum_[TwiceA] + last_[TwiceA];
        };
        moment.template operator()<0>();
        moment.template operator()<1>();
        moment.template operator()<2>();
        moment.template operator()<3>();
        nodes_ += V::size;
    }

    /// The same for nodes given by t alone.
    void add_curvatures(const V& t, const V& weight, T t_first, T t_last, T inverse_c) {
        const T slope = -p_.r * inverse_c;
        const T start = p_.eta * inverse_c;
        add(t, multiply_add(t, V(slope), V(start)), (t - V(p_.r * p_.eta)) * V(inverse_c), t - V(p_.floor), weight, t_first,
            t_last, slope * t_first + start, slope * t_last + start);
    }

    PeakSums<T> sums(T step) const {
        PeakSums<T> out;
        out.nodes = nodes_;
        for (std::size_t i = 0; i < 4; ++i)
            if (p_.minus_two_b[i] != absent) finish_sum(sum_[i], first_[i], last_[i], step, out.value[i], out.relative_error[i]);
        return out;
    }

private:
    const PeakProblem<T>& p_;
    std::array<V, 4> sum_, first_, last_;
    int nodes_ = 0;
};

/// 0, 1, ..., 7
template <Real T>
Lanes<T> ascending() {
    static constexpr std::array<T, Lanes<T>::size> numbers{0, 1, 2, 3, 4, 5, 6, 7};
    return Lanes<T>::load(numbers.data());
}

/// The curvature beyond which the integrand is below exp(-depth) of its greatest value.
template <Real T>
T largest_curvature(const PeakProblem<T>& p) {
    const T inner = p.r * p.eta + p.reach * p.c;  // end of the Gaussian, if x > 0 up to there
    if (inner * p.r <= p.eta) return inner;
    return std::sqrt(p.floor * p.floor + 2 * p.depth);  // end of exp(-t^2/2)
}

/// Nodes and weights of the smooth map, in tables of decreasing step: they depend on nothing else.
template <Real T>
class SmoothNodes {
public:
    static constexpr std::size_t capacity = 256;
    struct Rung {
        T step;
        std::size_t count;
        std::array<T, capacity> node, weight;
    };

    static const SmoothNodes& get() {
        static const SmoothNodes nodes;
        return nodes;
    }

    /// The coarsest rung whose step is at most \p step; the finest one when there is none.
    [[nodiscard]] const Rung& at_most(T step) const {
        for (const Rung& rung : rungs_)
            if (rung.step <= step) return rung;
        return rungs_.back();
    }

    static constexpr T scale = T(2.1);
    static constexpr T left = T(3.5);         ///< the table begins at y = -left
    static constexpr T finest = T(0.07);      ///< a step below this is not offered
    static constexpr T furthest_node = T(22);  ///< no problem that is not separated reaches further

private:
    SmoothNodes() {
        T step = 1;
        for (Rung& rung : rungs_) {
            rung.step = step;
            const int begin = 2 * static_cast<int>(std::floor(-left / (2 * step)));
            for (rung.count = 0; rung.count < capacity; ++rung.count) {
                const T y = T(begin + static_cast<int>(rung.count)) * step;
                const T fall = T(0.4) * std::exp(T(-1.354) * y);
                const T v = y - fall;
                const T small = std::exp(-std::abs(v));
                rung.node[rung.count] = std::max(scale * (std::max(v, T(0)) + std::log1p(small)), T(1e-30));  // 1/t is finite
                rung.weight[rung.count] = scale * (1 + T(1.354) * fall) * (v > 0 ? 1 : small) / (1 + small);
                if (rung.count % Lanes<T>::size == 0 && rung.node[rung.count] > furthest_node) break;
            }
            step *= T(0.8408964152537145);  // 2^(-1/4): a rung is at most 19 % finer than asked for
        }
    }

    std::array<Rung, 16> rungs_;
};

template <Real T>
PeakSums<T> smooth_sums(const PeakProblem<T>& p, T wanted_step) {
    using V = Lanes<T>;
    PeakAccumulator<T> sums(p);
    const auto& rung = SmoothNodes<T>::get().at_most(wanted_step);
    const T last = largest_curvature(p);
    const T inverse_c = 1 / p.c;
    for (std::size_t j = 0; j < rung.count && rung.node[j] <= last; j += V::size) {
        const V t = V::load(&rung.node[j]);
        sums.add_curvatures(t, V::load(&rung.weight[j]), rung.node[j], rung.node[j + V::size - 1], inverse_c);
    }
    return sums.sums(rung.step);
}

template <Real T>
T graded_scale(const PeakProblem<T>& p) {
    return std::min({T(1), 1 / p.k, p.c + std::max(T(0), -p.eta)});
}

template <Real T>
PeakSums<T> graded_sums(const PeakProblem<T>& p, T step) {
    using V = Lanes<T>;
    PeakAccumulator<T> sums(p);
    const T scale = graded_scale(p);
    const T ratio = largest_curvature(p) / scale;
    const T last = std::log(ratio) + 1 / ratio;  // y - exp(-y) = log(ratio)
    const T inverse_c = 1 / p.c;
    for (int j = 2 * static_cast<int>(std::floor(-std::log(p.depth + 2) / (2 * step))); T(j) * step < last; j += V::size) {
        const T y_first = T(j) * step;
        const T y_last = T(j + V::size - 1) * step;
        const V y = multiply_add(ascending<T>(), V(step), V(y_first));
        const V fall = exp(V(T(0)) - y);
        const V t = V(scale) * exp(y - fall);
        sums.add_curvatures(t, t * (fall + V(T(1))), scale * std::exp(y_first - std::exp(-y_first)),
                            scale * std::exp(y_last - std::exp(-y_last)), inverse_c);
    }
    return sums.sums(step);
}

template <Real T>
PeakSums<T> separated_sums(const PeakProblem<T>& p, T step) {
    using V = Lanes<T>;
    constexpr T slope = 3;
    PeakAccumulator<T> sums(p);
    const T high = p.c * p.eta + p.reach * p.r;
    T low = p.c * p.eta - p.reach * p.r;
    if (low < 0) {  // to the end of exp(-t^2/2) at t = hypot(eta, reach): (eta - r t)/c, without its cancellation
        const T end = std::hypot(p.eta, p.reach);
        low = (p.c * p.eta * p.c * p.eta - p.r * p.reach * p.r * p.reach) / (p.c * (p.eta + p.r * end));
    }
    const T y_high = low < 0 ? std::log(1 - low) : 1 - low / slope;
    const T c_over_r = p.c / p.r;
    const T inverse_r = 1 / p.r;
    const T distance = p.eta * (1 - p.r) * inverse_r;  // of the turn-on from t = eta
    const T least = p.c / 2;  // t at the idle end of the first eight nodes; the integrand is negligible there
    const auto x_at = [](T y) { return -(slope * y + std::exp(y)); };
    const auto t_at = [&](T x) { return std::max(least, (p.eta - p.c * x) * inverse_r); };
    for (int j = 2 * static_cast<int>(std::floor(-(high + T(0.4)) / (2 * slope * step))); T(j) * step < y_high; j += V::size) {
        const T y_first = T(j) * step;
        const T x_first = x_at(y_first);
        const T x_last = x_at(T(j + V::size - 1) * step);
        const V y = multiply_add(ascending<T>(), V(step), V(y_first));
        const V rise = exp(y);
        const V x = V(T(0)) - multiply_add(y, V(slope), rise);
        const V excess = multiply_add(x, V(-c_over_r), V(distance));
        sums.add(max(excess + V(p.eta), V(least)), x, (V(p.c * p.eta) - x) * V(inverse_r), excess,
                 (rise + V(slope)) * V(c_over_r), t_at(x_first), t_at(x_last), x_first, x_last);
    }
    return sums.sums(step);
}

/// The one place where a rule and its step are chosen, for a relative error of exp(-digits).
///
/// separated   when the Gaussian of mean r eta and width c is further from t = 0 than it reaches, so that the branch point and
///             the layer at t = 0 do not count. Step: resolves the Gaussian, which has width r in x.
/// smooth      when its step, which has to resolve the Gaussian (c) and the layer (1/k), makes it the cheaper one.
/// graded      else: c or 1/k small. Step: 3.9/(digits + 3), less where the Gaussian is narrow on the logarithmic scale.
///
/// The constants were fitted to the largest steps that reach 1e-3, 1e-8 and 3e-13 over r, theta, eta; where they are too
/// hopeful the error estimate says so.
template <Real T>
PeakSums<T> peak_sums(const PeakProblem<T>& p, T digits) {
    const T root = std::sqrt(digits);
    const T distance = p.r * p.eta / p.c;
    if (distance > p.reach + 1) return separated_sums(p, std::min(T(1.3) * p.r / root, (T(3.9) + T(0.35) * std::min(p.eta, T(3))) / (digits + 3)));

    const T strip = T(7.3) / ((digits + 3) * (1 + T(0.075) * p.k * p.k));
    const T smooth_step = std::min(strip, T(2.1) * p.c / root * (p.eta <= 0 ? T(1.5) : T(1)));
    const T narrow = std::max(distance, T(0)) * root / T(2.9);
    const T wide = (digits + 3) / T(3.9);
    const T graded_step = 1 / std::sqrt(wide * wide + narrow * narrow);

    const T smooth_cost = (SmoothNodes<T>::left + largest_curvature(p) / SmoothNodes<T>::scale) / smooth_step;
    const T graded_cost = (std::log(p.depth + 2) + std::log(largest_curvature(p) / graded_scale(p))) / graded_step;
    const bool offered = smooth_step >= SmoothNodes<T>::finest;
    return offered && smooth_cost <= T(1.2) * graded_cost ? smooth_sums(p, smooth_step) : graded_sums(p, graded_step);
}

}  // namespace detail
}  // namespace fstiff
