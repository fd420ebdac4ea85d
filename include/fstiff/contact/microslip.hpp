// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Microslip and loss at one pressure, without a table of the law: from p, K and the fall of K with p.
///
///     x = k K s/(mu p)                        tangential displacement s over what slips, k = K_t/K
///     q = mu p (1 - P),  dq/ds = -k K P'       P(x): the load left when the contact is parted by x p/K, over p
///     W = (4 mu^2 p^2/(k K)) [(1 + P) x - 2 I],  I: integral of P from 0 to x;  loss factor W/(pi q s)
///     K ~ p^m below p     P = [1 - (1 - m) x]^(1/(1-m));  m = 1/3 one sphere, 1 far from both ends of the load
///     spots that flowed   P = (2/pi) [acos y - y sqrt(1 - y^2)],  y = pi x/4: equal ones, under the hardness all over
///
/// Reference   contact/tangential_law.hpp; P of a flowed spot: Popov, Hess, Method of Dimensionality Reduction (2015),
///             ch. 2; derivation: docs/theory.md, section 12
/// Units       dimensionless
/// Valid       x >= 0, 0 <= m < 2; beyond full slip P = 0. Like bodies, Coulomb friction
/// Accuracy    1e-13; with m between 0.6 p and p the loss factor of three laws is within 3 % of that of the law itself,
///             x from 0.01 to 1, 0.1 to 100 MPa (tests/contact/microslip_test.cpp)

#include <fstiff/core/concepts.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fstiff::inline v0_1::parts {

/// K ~ p^growth while the contact opens.
template <Real T>
struct PowerUnloading {
    T growth;

    [[nodiscard]] T load(T x) const { return std::exp(log_load(x)); }
    [[nodiscard]] T work(T x) const { return -std::expm1((2 - growth) * log_load(x)) / (2 - growth); }
    [[nodiscard]] T bend(T x) const { return growth * std::exp((2 * growth - 1) * log_load(x)); }

private:
    [[nodiscard]] T log_load(T x) const {
        const T rest = 1 - growth;
        return std::abs(rest) < T(1e-8) ? -x : std::log1p(-(std::min)(rest * x, T(1))) / rest;
    }
};

/// Equal circular spots that flowed under one pressure. They lose far less than elastic ones while little slips, as x^2
/// against x. Neighbours of other sizes and elastic spots between them lose more: a contact that flowed is between the
/// two, for x >= 0.3 within a factor of 2 of their geometric mean (boundary elements:
/// tests/halfspace/unloading_test.cpp).
template <Real T>
struct FlowedUnloading {
    [[nodiscard]] T load(T x) const {
        const T y = part(x);
        return 2 / pi * (std::acos(y) - y * std::sqrt(1 - y * y));
    }
    [[nodiscard]] T work(T x) const {
        const T y = part(x), root = std::sqrt(1 - y * y);
        return 8 / (pi * pi) * (y * std::acos(y) - root + 1 - (1 - root * root * root) / 3);
    }
    [[nodiscard]] T bend(T x) const {
        const T y = part(x);
        return y < 1 ? pi / 4 * y / std::sqrt(1 - y * y) : T(0);
    }

private:
    static constexpr T pi = std::numbers::pi_v<T>;
    [[nodiscard]] static T part(T x) { return (std::min)(pi / 4 * x, T(1)); }
};

/// Loss factor of a cycle between -x and x, \p x >= 0.
template <Real T, class Unloading>
[[nodiscard]] T loss_factor(const Unloading& contact, T x) {
    x = (std::min)(x, T(1e15));  // all slips long before
    const T load = contact.load(x);
    T excess = (1 + load) * x - 2 * contact.work(x);
    if (x < T(0.1)) {  // which cancels: the integral of t (x - t) P'' by four points of Gauss
        constexpr T abscissas[] = {T(0.86113631159405257522), T(0.33998104358485626480)},
                    weights[] = {T(0.34785484513745385737), T(0.65214515486254614263)};
        excess = 0;
        for (int i = 0; i < 2; ++i)
            for (const T side : {T(-1), T(1)}) {
                const T t = x / 2 * (1 + side * abscissas[i]);
                excess += x / 2 * weights[i] * t * (x - t) * contact.bend(t);
            }
    }
    const T slipped = (1 - load) * x;
    return slipped > 0 ? 4 / std::numbers::pi_v<T> * excess / slipped : T(0);
}

}  // namespace fstiff::inline v0_1::parts
