// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact integrals as the paper computes them: 50 x 50 Gauss-Legendre points on a box. For comparison only.
///
/// The box is 0 <= t <= 8, eta <= zeta <= max(eta, 0) + 8; the paper does not give its own. Branch points on two sides
/// of the box make the rule converge slowly.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), remark below eq. (4.3)
/// Units       dimensionless
/// Accuracy    1e-5 to 2e-3 on tests/data/integrals_plain.csv; no digit for r near 1 or theta near pi/2. The error is
///             the greater of the difference from 25 x 25 points and that from contact_integral()
///             (tests/contact/tensor_integrals_test.cpp)

#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/peak_sums.hpp>
#include <fstiff/core/estimate.hpp>
#include <fstiff/math/gauss_legendre.hpp>

#include <cmath>

namespace fstiff {

namespace detail {

template <std::size_t N, Real T>
T box_rule(T a, T b, const PeakDistribution<T>& peaks, T eta) {
    const auto& rule = GaussLegendre<T, N>::get();
    constexpr T half = 4;
    const T half_height = half + ((std::max)(eta, T(0)) - eta) / 2;
    T sum = 0;
    for (std::size_t i = 0; i < N; ++i) {
        const T t = half * (1 + rule.node[i]);
        T row = 0;
        for (std::size_t j = 0; j < N; ++j) {
            const T excess = half_height * (1 + rule.node[j]);
            row += rule.weight[j] * std::pow(excess, a) * peaks(eta + excess, t);
        }
        sum += rule.weight[i] * std::pow(t, b) * row;
    }
    return sum * half * half_height;
}

}  // namespace detail

/// J[a,b] by the paper's rule. \throws domain_error as contact_integral.
template <Real T>
[[nodiscard]] Estimate<T> paper_integral(T a, T b, const PeakDistribution<T>& peaks, T eta) {
    static_cast<void>(detail::one_power(a, b));
    require(std::abs(eta) <= T(1e6), "eta", eta, "a number between -1e6 and 1e6");
    const T value = detail::box_rule<50>(a, b, peaks, eta);
    const T coarse = detail::box_rule<25>(a, b, peaks, eta);
    const T own = std::abs(value - coarse) + (T(2e-10) + 100 * std::numeric_limits<T>::epsilon()) * value;
    const Estimate<T> truth = contact_integral(a, b, peaks, eta);
    return {value, (std::max)(own, std::abs(value - truth.value) + truth.error), 2500 + 625};
}

}  // namespace fstiff
