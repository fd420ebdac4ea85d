// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The sums of the contact integrals over the nodes of peak_nodes.hpp: inner moments, erf, and the error of the rule.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.5)-(4.9).
/// Accuracy    see contact_integrals.hpp

#include <fstiff/core/error.hpp>
#include <fstiff/math/gaussian_moment.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/peaks/peak_nodes.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// J of up to four powers a = 0, 1/2, 1, 3/2 at once, without the factor c^a/(2 theta) exp(-floor^2/2), by a
/// trapezoidal rule of step h, and the relative error that its nodes show.
template <Real T>
struct PeakSums {
    std::array<T, 4> value{};
    std::array<T, 4> relative_error{};
    int nodes{};
};

/// x^(1/8) for x >= 0 within 10 %, by an eighth of the bits of x: three roots would take as long as two dozen nodes.
template <Real T>
EIGEN_ALWAYS_INLINE T rough_eighth_root(T x) {
    constexpr std::uint64_t one = std::bit_cast<std::uint64_t>(1.0);
    return static_cast<T>(
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(static_cast<double>(x)) / 8 + one / 8 * 7));
}

/// Sums of the eight rules of step 8h times \p step, and the error of the trapezoidal rule relative to each.
///
/// The rule of step h errs by the Fourier transform of the integrand at the frequency 2 pi/h, and sums[m] holds the
/// rule of step 8h shifted by m h: the discrete transform of the eight at k = 1, 2 and 3 is the transform of the
/// integrand at k/8 of that frequency. It falls geometrically or faster, and its modulus, unlike the difference of two
/// rules, seldom vanishes by accident; so it is extrapolated from 3/8 to 1 by its fall from 2/8 or, where that is more,
/// from 1/8, with half of one of the five steps left out to be on the safe side. What is cut off beyond the first and
/// the last node falls faster than geometrically: less than the two outermost terms.
template <Real T>
PeakSums<T> finish(const std::array<math::Lanes<T, 4>, 8>& sums, const math::Lanes<T, 4>& first,
                   const math::Lanes<T, 4>& last, T step, int nodes) {
    using V = math::Lanes<T, 4>;
    const V half_root = V::all(std::numbers::sqrt2_v<T> / 2);
    std::array<V, 4> odd, even;
    for (std::size_t i = 0; i < 4; ++i) {
        odd[i] = sums[i] - sums[i + 4];
        even[i] = sums[i] + sums[i + 4];
    }
    const auto squares = [](const V& x, const V& y) { return multiply_add(x, x, y * y); };
    const V difference = half_root * (odd[1] - odd[3]), sum = half_root * (odd[1] + odd[3]);
    const V at_1 = squares(odd[0] + difference, odd[2] + sum);
    const V at_2 = squares(even[0] - even[2], even[1] - even[3]);
    const V at_3 = squares(odd[0] - difference, odd[2] - sum);
    const V total = (even[0] + even[2]) + (even[1] + even[3]);
    // powers that are not asked for are 0 throughout: the least number keeps 0/0 out
    const V one = V::all(T(1)), least = V::all((std::numeric_limits<T>::min)());
    const V quotient = at_3 / (at_2 + least);
    const V fall_4 = smaller(smaller(quotient * quotient, at_3 / (at_1 + least)), one);  // over four eighths
    T fall[4];
    fall_4.store(fall);
    for (T& factor : fall) factor = detail::rough_eighth_root(factor);  // over half an eighth
    const V error = (multiply_add(sqrt(at_3), fall_4 * V::load(fall), first + last)) / larger(total, least);
    PeakSums<T> out;
    out.nodes = nodes;
    (V::all(step) * total).store(out.value.data());
    (error + error).store(out.relative_error.data());
    return out;
}

/// Powers that are asked for: minus_two_b[i] is -2b (0, 1 or 2) for a = i/2, or absent.
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

/// erf(k t) at the nodes.
template <Real T>
EIGEN_DONT_INLINE void erf_at(const PeakNodes<T>& nodes, T k, const math::ErfPolynomials& polynomials, T* out) {
    using V = math::Lanes<T, 8>;
    for (int i = 0; i < nodes.size(); i += 8) {
        const T* t = nodes.t() + i;
        math::erf_ascending(V::load(t) * V::all(k), k * t[0], k * t[7], polynomials).store(out + i);
    }
}

/// Sums up the integrands of a PowerSet, four side by side; absent ones are multiplied by 0.
template <Real T>
class PeakAccumulator {
public:
    using V = math::Lanes<T, 4>;

    PeakAccumulator(const PeakProblem<T>& problem, const PowerSet& minus_two_b, T tolerance)
        : k_(problem.k),
          rough_(tolerance > T(10 * math::MomentTable::cut[rough_terms])),
          polynomials_(math::ErfPolynomials::for_tolerance(static_cast<double>(tolerance))) {
        alignas(32) static constexpr T unit[4][4]{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
        for (std::size_t b = 0; b < 3; ++b) {  // in registers: a vector of what has just been stored one by one is slow
            share_[b] = V::all(T(0));
            for (std::size_t i = 0; i < 4; ++i)
                share_[b] = multiply_add(V::load(unit[i]), V::all(T(minus_two_b[i] == static_cast<int>(b))), share_[b]);
        }
        clear();
    }

    /// Begins again, at another eta.
    void clear() {
        sums_.fill(V::all(T(0)));
        first_ = last_ = V::all(T(0));
        count_ = 0;
    }

    EIGEN_DONT_INLINE void add(const PeakNodes<T>& nodes) {
        const bool kept = nodes.table() != nullptr && nodes.table() == erf_table_ && nodes.size() <= erf_size_;
        if (!kept) {
            erf_at(nodes, k_, polynomials_, erf_);
            erf_table_ = nodes.table();
            erf_size_ = nodes.size();
        }
        rough_ ? add_by<rough_terms>(nodes) : add_by<math::MomentTable::terms>(nodes);
    }

    /// Relative error of the shorter polynomials.
    [[nodiscard]] T cut() const { return rough_ ? T(math::MomentTable::cut[rough_terms] + polynomials_.error) : T(0); }
    PeakSums<T> result(T step) const { return detail::finish(sums_, first_, last_, step, count_); }

private:
    static constexpr int rough_terms = 6;

    template <int terms>
    void add_by(const PeakNodes<T>& nodes) {
        const std::array<V, 3> share = share_;
        const T *const x = nodes.x(), *const inverse_root = nodes.inverse_root(), *const mass = nodes.mass();
        for (int i = 0; i < nodes.size(); i += 8) {
            std::array<V, 8> term;
            math::scaled_moments<terms>(x + i, term);
            for (int m = 0; m < 8; ++m) {
                const V root = V::all(inverse_root[i + m]);
                const V power = multiply_add(root, multiply_add(root, share[2], share[1]), share[0]);  // t^b
                V& product = term[static_cast<std::size_t>(m)];
                product = product * (power * V::all(mass[i + m] * erf_[i + m]));
            }
            for (std::size_t m = 0; m < 8; ++m) sums_[m] = sums_[m] + term[m];
            if (count_ + i == 0) first_ = term.front();
            last_ = term.back();
        }
        count_ += nodes.size();
    }

    T k_;
    bool rough_;  ///< by the shorter polynomials
    math::ErfPolynomials polynomials_;
    int count_ = 0, erf_size_ = 0;
    const T* erf_table_ = nullptr;  ///< of the nodes at which erf_ was computed
    std::array<V, 3> share_;        ///< 1 where b = 0, -1/2, -1
    std::array<V, 8> sums_;         ///< by the number of the node modulo 8
    V first_, last_;
    alignas(64) T erf_[PeakNodes<T>::capacity];
};

}}}  // namespace fstiff::detail
