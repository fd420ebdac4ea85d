// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// N numbers that are computed with at once, whatever the width of the machine's vectors: one of Eigen's packets where
/// it has one of that size, else two halves, down to single numbers. No loops, no branches, no arrays, so
/// that a compiler keeps them in registers at every level of optimisation.
///
/// Valid       float, double; N a power of two
/// Accuracy    that of Eigen's packet functions: exp and log 2 ulp, all others correctly rounded; multiply_add rounds
///             once where the machine has a fused one

#include <fstiff/core/numbers.hpp>

#include <Eigen/Core>

#include <array>

namespace fstiff { inline namespace v0_1 { namespace math {

template <Real T, int N>
using PacketOf = std::conditional_t<N == 1, T, typename Eigen::internal::find_best_packet<T, N>::type>;

template <Real T, int N, bool native = Eigen::internal::unpacket_traits<PacketOf<T, N>>::size == N>
struct Lanes;

// clang-format off: an operation a line
/// One packet.
template <Real T, int N>
struct Lanes<T, N, true> {
    PacketOf<T, N> p;

    EIGEN_ALWAYS_INLINE static Lanes all(T value) { return {Eigen::internal::pset1<PacketOf<T, N>>(value)}; }
    /// N consecutive numbers, which need not be aligned.
    EIGEN_ALWAYS_INLINE static Lanes load(const T* from) { return {Eigen::internal::ploadu<PacketOf<T, N>>(from)}; }
    /// The same, aligned to N of them.
    EIGEN_ALWAYS_INLINE static Lanes load_aligned(const T* from) {
        return {Eigen::internal::pload<PacketOf<T, N>>(from)};
    }
    EIGEN_ALWAYS_INLINE void store(T* to) const { Eigen::internal::pstoreu(to, p); }

    EIGEN_ALWAYS_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return {Eigen::internal::padd(a.p, b.p)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return {Eigen::internal::psub(a.p, b.p)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return {Eigen::internal::pmul(a.p, b.p)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return {Eigen::internal::pdiv(a.p, b.p)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes smaller(const Lanes& a, const Lanes& b) {
        return {Eigen::internal::pmin(a.p, b.p)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes larger(const Lanes& a, const Lanes& b) {
        return {Eigen::internal::pmax(a.p, b.p)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes exp(const Lanes& a) { return {Eigen::internal::pexp(a.p)}; }
    EIGEN_ALWAYS_INLINE friend Lanes log(const Lanes& a) { return {Eigen::internal::plog(a.p)}; }
    EIGEN_ALWAYS_INLINE friend Lanes sqrt(const Lanes& a) { return {Eigen::internal::psqrt(a.p)}; }
    /// a b + c
    EIGEN_ALWAYS_INLINE friend Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
        return {Eigen::internal::pmadd(a.p, b.p, c.p)};
    }
    /// The lower half plus \p s times the upper one.
    EIGEN_ALWAYS_INLINE Lanes<T, N / 2> fold(T s) const {
        alignas(64) static constexpr auto lower = [] {
            std::array<T, std::size_t{N}> mask{};
            for (std::size_t i = 0; i < mask.size() / 2; ++i) mask[i] = 1;
            return mask;
        }();
        const Lanes low = load_aligned(lower.data());
        const Lanes high = all(T(1)) - low;
        return {Eigen::internal::predux_half_dowto4((*this * multiply_add(all(s), high, low)).p)};
    }
    /// \p yes where a < b, \p no elsewhere.
    EIGEN_ALWAYS_INLINE friend Lanes select_less(const Lanes& a, const Lanes& b, const Lanes& yes, const Lanes& no) {
        if constexpr (N == 1)  // Eigen's mask of a single number is a NaN, which not every compiler setting keeps
            return a.p < b.p ? yes : no;
        else
            return {Eigen::internal::pselect(Eigen::internal::pcmp_lt(a.p, b.p), yes.p, no.p)};
    }
};

/// Two halves.
template <Real T, int N>
struct Lanes<T, N, false> {
    using Half = Lanes<T, N / 2>;
    Half low, high;

    EIGEN_ALWAYS_INLINE static Lanes all(T value) { return {Half::all(value), Half::all(value)}; }
    EIGEN_ALWAYS_INLINE static Lanes load(const T* from) { return {Half::load(from), Half::load(from + N / 2)}; }
    EIGEN_ALWAYS_INLINE static Lanes load_aligned(const T* from) {
        return {Half::load_aligned(from), Half::load_aligned(from + N / 2)};
    }
    EIGEN_ALWAYS_INLINE void store(T* to) const {
        low.store(to);
        high.store(to + N / 2);
    }

    EIGEN_ALWAYS_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return {a.low + b.low, a.high + b.high};
    }
    EIGEN_ALWAYS_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return {a.low - b.low, a.high - b.high};
    }
    EIGEN_ALWAYS_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return {a.low * b.low, a.high * b.high};
    }
    EIGEN_ALWAYS_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return {a.low / b.low, a.high / b.high};
    }
    EIGEN_ALWAYS_INLINE friend Lanes smaller(const Lanes& a, const Lanes& b) {
        return {smaller(a.low, b.low), smaller(a.high, b.high)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes larger(const Lanes& a, const Lanes& b) {
        return {larger(a.low, b.low), larger(a.high, b.high)};
    }
    EIGEN_ALWAYS_INLINE friend Lanes exp(const Lanes& a) { return {exp(a.low), exp(a.high)}; }
    EIGEN_ALWAYS_INLINE friend Lanes log(const Lanes& a) { return {log(a.low), log(a.high)}; }
    EIGEN_ALWAYS_INLINE friend Lanes sqrt(const Lanes& a) { return {sqrt(a.low), sqrt(a.high)}; }
    EIGEN_ALWAYS_INLINE friend Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
        return {multiply_add(a.low, b.low, c.low), multiply_add(a.high, b.high, c.high)};
    }
    EIGEN_ALWAYS_INLINE Half fold(T s) const { return multiply_add(high, Half::all(s), low); }
    EIGEN_ALWAYS_INLINE friend Lanes select_less(const Lanes& a, const Lanes& b, const Lanes& yes, const Lanes& no) {
        return {select_less(a.low, b.low, yes.low, no.low), select_less(a.high, b.high, yes.high, no.high)};
    }
};

}}}  // namespace fstiff::math
