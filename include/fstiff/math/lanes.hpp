// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Eight numbers that are computed with at once, whatever the width of the machine's vectors.
///
/// A thin value type over Eigen's packets: one AVX-512 register, two of AVX, four of SSE2 or NEON, or eight scalars (long
/// double). The kernels of fstiff are written once against Lanes and, through the scalar overloads at the end, for single
/// numbers. Elementwise fused multiply-add where the machine has it; no heap, no branches.
///
/// Valid       float, double, long double
/// Accuracy    that of Eigen's packet functions: exp 2 ulp, sqrt and division correctly rounded

#include <fstiff/core/concepts.hpp>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <utility>

namespace fstiff::detail {

template <Real T>
struct Lanes {
    static constexpr int size = 8;
    using Packet = typename Eigen::internal::find_best_packet<T, size>::type;
    static constexpr int width = Eigen::internal::unpacket_traits<Packet>::size;
    static constexpr int packets = size / width;
    using Sequence = std::make_integer_sequence<int, packets>;

    std::array<Packet, packets> p;

    Lanes() = default;
    explicit Lanes(T value) { p.fill(Eigen::internal::pset1<Packet>(value)); }

    /// Eight consecutive numbers from \p from, which need not be aligned.
    static Lanes load(const T* from) {
        return make([&]<int I>() { return Eigen::internal::ploadu<Packet>(from + I * width); });
    }

    void store(T* to) const {
        for (std::size_t i = 0; i < packets; ++i) Eigen::internal::pstoreu(to + i * width, p[i]);
    }

    /// The Lanes whose packet I is f.operator()<I>(); expanded at compile time so that nothing is left of the loop.
    template <class F>
    static Lanes make(const F& f) {
        return expand(f, Sequence{});
    }

    friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return make([&]<int I>() { return Eigen::internal::padd(a.p[I], b.p[I]); });
    }
    friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return make([&]<int I>() { return Eigen::internal::psub(a.p[I], b.p[I]); });
    }
    friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return make([&]<int I>() { return Eigen::internal::pmul(a.p[I], b.p[I]); });
    }
    friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return make([&]<int I>() { return Eigen::internal::pdiv(a.p[I], b.p[I]); });
    }

private:
    template <class F, int... I>
    static Lanes expand(const F& f, std::integer_sequence<int, I...>) {
        Lanes out;
        ((out.p[I] = f.template operator()<I>()), ...);
        return out;
    }
};

/// a b + c
template <Real T>
Lanes<T> multiply_add(const Lanes<T>& a, const Lanes<T>& b, const Lanes<T>& c) {
    return Lanes<T>::make([&]<int I>() { return Eigen::internal::pmadd(a.p[I], b.p[I], c.p[I]); });
}

template <Real T>
Lanes<T> exp(const Lanes<T>& a) {
    return Lanes<T>::make([&]<int I>() { return Eigen::internal::pexp(a.p[I]); });
}

template <Real T>
Lanes<T> sqrt(const Lanes<T>& a) {
    return Lanes<T>::make([&]<int I>() { return Eigen::internal::psqrt(a.p[I]); });
}

template <Real T>
Lanes<T> min(const Lanes<T>& a, const Lanes<T>& b) {
    return Lanes<T>::make([&]<int I>() { return Eigen::internal::pmin(a.p[I], b.p[I]); });
}

template <Real T>
Lanes<T> max(const Lanes<T>& a, const Lanes<T>& b) {
    return Lanes<T>::make([&]<int I>() { return Eigen::internal::pmax(a.p[I], b.p[I]); });
}

/// Where a < b: \p yes, elsewhere \p no.
template <Real T>
Lanes<T> select_less(const Lanes<T>& a, const Lanes<T>& b, const Lanes<T>& yes, const Lanes<T>& no) {
    return Lanes<T>::make([&]<int I>() {
        return Eigen::internal::pselect(Eigen::internal::pcmp_lt(a.p[I], b.p[I]), yes.p[I], no.p[I]);
    });
}

// The same for one number.
template <Real T>
T multiply_add(T a, T b, T c) {
    return a * b + c;
}

/// c[0] + c[1] u + c[2] u^2 + ..., by Horner's rule; V is T or Lanes<T>.
template <class V, Real T, std::size_t N>
V polynomial(const std::array<T, N>& c, const V& u) {
    V sum = V(c[N - 1]);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((sum = multiply_add(sum, u, V(c[N - 2 - I]))), ...);
    }(std::make_index_sequence<N - 1>{});
    return sum;
}

}  // namespace fstiff::detail
