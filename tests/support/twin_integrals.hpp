// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// J[a,b] by other ways than contact_integral(): in two dimensions, and by the paper's rule.

#include <fstiff/math/quadrature.hpp>
#include <fstiff/peaks/contact_integrals.hpp>
#include <fstiff/peaks/tensor_integrals.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace test {

/// J[a,b] in two dimensions: the slow twin of contact_integral. \throws domain_error as contact_integral.
template <fstiff::Real T>
[[nodiscard]] fstiff::Estimate<T> tensor_integral(T a, T b, const fstiff::PeakDistribution<T>& peaks, T eta,
                                                  const fstiff::TensorOptions<T>& options = {}) {
    static_cast<void>(fstiff::detail::one_power(a, b));
    const auto monomial = [a, b](const fstiff::detail::TensorLanes<T>& excess, T t) -> fstiff::detail::TensorLanes<T> {
        const T power_of_t = b == 0 ? T(1) : b == T(-0.5) ? 1 / std::sqrt(t) : 1 / t;
        if (a == 0) return fstiff::detail::TensorLanes<T>::Constant(power_of_t);
        if (a == T(0.5)) return power_of_t * excess.sqrt();
        if (a == T(1)) return power_of_t * excess;
        return power_of_t * excess * excess.sqrt();
    };
    const bool even = a != std::floor(a) && b != std::floor(b);
    const fstiff::Estimate<T> scaled =
        even ? fstiff::detail::scaled_tensor_integral<fstiff::NodeClustering::even>(monomial, peaks, eta, options)
             : fstiff::detail::scaled_tensor_integral<fstiff::NodeClustering::graded>(monomial, peaks, eta, options);
    const T scale = fstiff::math::gaussian((std::max)(eta, T(0)));
    return {scaled.value * scale, scaled.error * scale + std::numeric_limits<T>::denorm_min(), scaled.evaluations};
}

template <std::size_t N, fstiff::Real T>
T box_rule(T a, T b, const fstiff::PeakDistribution<T>& peaks, T eta) {
    const auto& rule = fstiff::math::GaussLegendre<T, N>::get();
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

/// J[a,b] by the paper's rule, for comparison only: 50 x 50 Gauss-Legendre points on 0 <= t <= 8, eta <= zeta <=
/// max(eta, 0) + 8 (remark below eq. (4.3); the box is this project's). 1e-5 to 2e-3 on tests/data/integrals_plain.csv,
/// no digit for r near 1 or theta near pi/2; the error covers the difference from contact_integral().
/// \throws domain_error as contact_integral.
template <fstiff::Real T>
[[nodiscard]] fstiff::Estimate<T> paper_integral(T a, T b, const fstiff::PeakDistribution<T>& peaks, T eta) {
    static_cast<void>(fstiff::detail::one_power(a, b));
    fstiff::detail::require(std::abs(eta) <= T(1e6), "eta", eta, "a number between -1e6 and 1e6");
    const T value = box_rule<50>(a, b, peaks, eta);
    const T coarse = box_rule<25>(a, b, peaks, eta);
    const T own = std::abs(value - coarse) + (T(2e-10) + 100 * std::numeric_limits<T>::epsilon()) * value;
    const fstiff::Estimate<T> truth = fstiff::contact_integral(a, b, peaks, eta);
    return {value, (std::max)(own, std::abs(value - truth.value) + truth.error), 2500 + 625};
}

}  // namespace test
