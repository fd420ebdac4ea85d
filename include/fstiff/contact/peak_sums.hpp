// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The sums of the contact integrals over the nodes of peak_nodes.hpp: inner moments, erf, and the error of the rule.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.5)-(4.9).
/// Accuracy    see contact_integrals.hpp

#include <fstiff/contact/peak_nodes.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/math/error_function.hpp>
#include <fstiff/math/gaussian_moment.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

/// A sum over nodes: its lanes, and its outermost terms, which bound what was cut off.
template <Real T>
struct LaneSum {
    Lanes<T> sum{T(0)}, first{T(0)}, last{T(0)};

    EIGEN_ALWAYS_INLINE void add(const Lanes<T>& term, bool is_first) {
        if (is_first) first = term;
        last = term;
        sum = sum + term;
    }
};

/// Sums of the lanes times \p step, and the error of the trapezoidal rule relative to each.
///
/// The rule of step h errs by the Fourier transform of the integrand at the frequency 2 pi/h, and lane m of the eight holds
/// the rule of step 8h shifted by m h: the discrete transform of the lanes at k = 1, 2 and 3 is the transform of the integrand
/// at k/8 of that frequency. It falls geometrically or faster, and its modulus, unlike the difference of two rules, seldom
/// vanishes by accident; so it is extrapolated from 3/8 to 1 by its fall from 2/8 or, where that is more, from 1/8, with half
/// of one of the five steps left out to be on the safe side.
/// What is cut off beyond the first and the last node falls faster than geometrically: less than the two outermost terms.
template <Real T>
PeakSums<T> finish(const std::array<LaneSum<T>, 4>& sums, T step, int nodes) {
    using Four = Eigen::Array<T, 4, 1>;
    constexpr T half_root = std::numbers::sqrt2_v<T> / 2;
    Four at_1, at_2, at_3, total, ends;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<T, Lanes<T>::size> s, begin, end;
        sums[i].sum.store(s.data());
        sums[i].first.store(begin.data());
        sums[i].last.store(end.data());
        const std::array<T, 4> odd{s[0] - s[4], s[1] - s[5], s[2] - s[6], s[3] - s[7]};
        const std::array<T, 4> even{s[0] + s[4], s[1] + s[5], s[2] + s[6], s[3] + s[7]};
        const auto square = [](T x, T y) { return x * x + y * y; };
        const auto row = static_cast<Eigen::Index>(i);
        at_1[row] = square(odd[0] + half_root * (odd[1] - odd[3]), odd[2] + half_root * (odd[1] + odd[3]));
        at_2[row] = square(even[0] - even[2], even[1] - even[3]);
        at_3[row] = square(odd[0] + half_root * (odd[3] - odd[1]), odd[2] - half_root * (odd[1] + odd[3]));
        total[row] = (even[0] + even[2]) + (even[1] + even[3]);
        ends[row] = begin.front() + end.back();
    }
    // what is not asked for is 0 throughout: the least number keeps 0/0 out
    constexpr T least = std::numeric_limits<T>::min();
    const Four ratio = (at_3 / (at_2 + least)).min((at_3 / (at_1 + least)).sqrt()).min(T(1));
    const Four error = 2 * ((at_3 * ratio.sqrt()).sqrt() * ratio.square() + ends) / total.max(least);
    PeakSums<T> out;
    out.nodes = nodes;
    Eigen::Map<Four>(out.value.data()) = step * total;
    Eigen::Map<Four>(out.relative_error.data()) = error;
    return out;
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

/// F_a(x) at eight nodes, and the exponential that goes with it: whichever of the three polynomials the ends of x call for.
template <Real T>
class MomentBlock {
public:
    using V = Lanes<T>;

    EIGEN_ALWAYS_INLINE explicit MomentBlock(const PeakNodes<T>& nodes)
        : x_(nodes.x),
          right_(nodes.x_first >= 0),
          middle_(nodes.x_last < 0 && -moment_middle < nodes.x_first),
          far_(nodes.x_last < -moment_middle) {
        const V zero{T(0)};
        if (right_) {
            const V clamped = max(x_, zero);
            right_inverse_ = V(T(1)) / (clamped + V(T(4)));
            right_root_ = sqrt(right_inverse_);
            right_u_ = (clamped - V(T(4))) * right_inverse_;
        }
        if (middle_)
            middle_u_ = multiply_add(min(max(x_, V(T(-moment_middle))), zero), V(T(2) / moment_middle), V(T(1)));
        if (far_) {
            far_size_ = max(zero - x_, V(T(moment_middle)));
            far_root_ = sqrt(far_size_);
            const V ratio = V(T(moment_middle)) / far_size_;
            far_u_ = multiply_add(ratio + ratio, ratio, V(T(-1)));
        }
    }

    /// exp(-t^2/2), times exp(-x^2/2) for x >= 0, without the factor exp(-floor^2/2): what moment() is to be multiplied with.
    EIGEN_ALWAYS_INLINE V gaussian(const PeakNodes<T>& nodes, T floor) const {
        V exponent{T(0)};
        if (right_) exponent = nodes.z * nodes.z;
        if (middle_ || far_) {
            const V outer = nodes.excess * (nodes.t + V(floor));
            exponent = right_ ? select_less(x_, V(T(0)), outer, exponent) : outer;
        }
        return exp(exponent * V(T(-0.5)));
    }

    /// F_a(x), for x >= 0 times exp(x^2/2).
    template <int TwiceA>
    EIGEN_ALWAYS_INLINE V moment() const {
        V value{T(0)};
        if (right_) value = moment_right<TwiceA, T>(right_u_, right_inverse_, right_root_);
        if (middle_) {
            const V m = moment_middle_range<TwiceA, T>(middle_u_);
            value = right_ ? select_less(x_, V(T(0)), m, value) : m;
        }
        if (far_) {
            const V f = moment_far<TwiceA, T>(far_u_, far_size_, far_root_);
            value = right_ || middle_ ? select_less(x_, V(T(-moment_middle)), f, value) : f;
        }
        return value;
    }

private:
    V x_;
    bool right_, middle_, far_;
    V right_inverse_, right_root_, right_u_, middle_u_, far_u_, far_size_, far_root_;
};

/// Sums up the integrands of a PowerSet.
template <Real T>
class PeakAccumulator {
public:
    using V = Lanes<T>;
    PeakAccumulator(const PeakProblem<T>& problem, const PowerSet& minus_two_b)
        : p_(problem), minus_two_b_(minus_two_b) {}

    EIGEN_ALWAYS_INLINE void add(const PeakNodes<T>& nodes) {
        const MomentBlock<T> block(nodes);
        const V erf = erf_ascending(V(p_.k) * nodes.t, p_.k * nodes.t_first, p_.k * nodes.t_last);
        const V g = nodes.weight * erf * block.gaussian(nodes, p_.floor);
        const V g_root = g * nodes.inverse_root;
        const std::array<V, 3> scaled{g, g_root, g_root * nodes.inverse_root};  // g t^b
        const auto one = [&]<int TwiceA>() __attribute__((always_inline)) {
            if (minus_two_b_[TwiceA] == absent) return;
            sums_[TwiceA].add(scaled[static_cast<std::size_t>(minus_two_b_[TwiceA])] * block.template moment<TwiceA>(),
                              nodes_ == 0);
        };
        one.template operator()<0>();
        one.template operator()<1>();
        one.template operator()<2>();
        one.template operator()<3>();
        nodes_ += V::size;
    }

    PeakSums<T> result(T step) const { return finish(sums_, step, nodes_); }

private:
    const PeakProblem<T>& p_;
    PowerSet minus_two_b_;
    std::array<LaneSum<T>, 4> sums_;
    int nodes_ = 0;
};

template <Real T>
PeakSums<T> peak_sums(const PeakProblem<T>& problem, const PowerSet& minus_two_b, T digits) {
    PeakAccumulator<T> sums(problem, minus_two_b);
    const T step = visit_nodes(problem, digits, sums);
    return sums.result(step);
}

}  // namespace detail
}  // namespace fstiff
