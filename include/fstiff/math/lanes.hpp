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

    std::array<Packet, packets> p;

    Lanes() = default;
    EIGEN_ALWAYS_INLINE explicit Lanes(T value) { p.fill(Eigen::internal::pset1<Packet>(value)); }
    EIGEN_ALWAYS_INLINE explicit Lanes(const std::array<Packet, packets>& all) : p(all) {}

    /// Eight consecutive numbers from \p from, which need not be aligned.
    EIGEN_ALWAYS_INLINE static Lanes load(const T* from) {
        Lanes out;
        for (std::size_t i = 0; i < packets; ++i) out.p[i] = Eigen::internal::ploadu<Packet>(from + i * width);
        return out;
    }

    EIGEN_ALWAYS_INLINE void store(T* to) const {
        for (std::size_t i = 0; i < packets; ++i) Eigen::internal::pstoreu(to + i * width, p[i]);
    }
};

/// The Lanes whose packet i is \p packet(i). Expanded and inlined without fail: at -O2 a compiler would otherwise call a
/// function for each multiplication.
template <Real T, class F, std::size_t... I>
EIGEN_ALWAYS_INLINE Lanes<T> make_lanes(const F& packet, std::index_sequence<I...>) {
    if constexpr (Lanes<T>::width == 1) {  // no vectors (long double): a loop, for eightfold code would gain nothing
        Lanes<T> out;
        for (std::size_t i = 0; i < sizeof...(I); ++i) out.p[i] = packet(i);
        return out;
    } else {
        return Lanes<T>(std::array<typename Lanes<T>::Packet, sizeof...(I)>{packet(I)...});
    }
}

// clang-format off: one line of Eigen's packet mathematics each
#define FSTIFF_LANES(expression)                            \
    make_lanes<T>(                                          \
        [&](std::size_t i) __attribute__((always_inline)) { \
            using namespace Eigen::internal;                \
            return expression;                              \
        },                                                  \
        std::make_index_sequence<Lanes<T>::packets>{})

template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> operator+(const Lanes<T>& a, const Lanes<T>& b) {
    return FSTIFF_LANES(padd(a.p[i], b.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> operator-(const Lanes<T>& a, const Lanes<T>& b) {
    return FSTIFF_LANES(psub(a.p[i], b.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> operator*(const Lanes<T>& a, const Lanes<T>& b) {
    return FSTIFF_LANES(pmul(a.p[i], b.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> operator/(const Lanes<T>& a, const Lanes<T>& b) {
    return FSTIFF_LANES(pdiv(a.p[i], b.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> min(const Lanes<T>& a, const Lanes<T>& b) {
    return FSTIFF_LANES(pmin(a.p[i], b.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> max(const Lanes<T>& a, const Lanes<T>& b) {
    return FSTIFF_LANES(pmax(a.p[i], b.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> exp(const Lanes<T>& a) {
    return FSTIFF_LANES(pexp(a.p[i]));
}
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> sqrt(const Lanes<T>& a) {
    return FSTIFF_LANES(psqrt(a.p[i]));
}

/// a b + c
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> multiply_add(const Lanes<T>& a, const Lanes<T>& b, const Lanes<T>& c) {
    return FSTIFF_LANES(pmadd(a.p[i], b.p[i], c.p[i]));
}

/// Where a < b: \p yes, elsewhere \p no.
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> select_less(const Lanes<T>& a, const Lanes<T>& b, const Lanes<T>& yes,
                                         const Lanes<T>& no) {
    return FSTIFF_LANES(pselect(pcmp_lt(a.p[i], b.p[i]), yes.p[i], no.p[i]));
}

#undef FSTIFF_LANES
// clang-format on

// The same for one number.
template <Real T>
EIGEN_ALWAYS_INLINE T multiply_add(T a, T b, T c) {
    return a * b + c;
}

/// c[0] + c[1] u + c[2] u^2 + ...; V is T or Lanes<T>. Two interleaved Horner rules in u^2, for even and odd powers: one alone
/// waits for each multiplication, and several of them fill more of the processor's queue than it has.
template <class V, Real T, std::size_t N>
EIGEN_ALWAYS_INLINE V polynomial(const std::array<T, N>& c, const V& u) {
    if constexpr (N < 3) {
        return N == 1 ? V(c[0]) : multiply_add(u, V(c[N - 1]), V(c[0]));
    } else {
        const V square = u * u;
        V high = V(c[N - 1]), low = V(c[N - 2]);  // of the powers of the parity of N-1, and of the others
        [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
            (((I % 2 == 0 ? high : low) = multiply_add(I % 2 == 0 ? high : low, square, V(c[N - 3 - I]))), ...);
        }
        (std::make_index_sequence<N - 2>{});
        return N % 2 == 0 ? multiply_add(high, u, low) : multiply_add(low, u, high);
    }
}

}  // namespace fstiff::detail
