// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Tukey's weights, by which robust filters leave out what stands far from the mean line.
///
///     delta(r) = (1 - (r/c)^2)^2 for |r| < c, else 0;   c = 3 * 1.4826 median |r| = 4.4478 median |r|
///
/// c is three standard deviations of Gaussian residuals, whatever the other residuals are.
///
/// Reference   ISO 16610-31:2016, 4.3 and ISO 16610-71:2014, 4.3; Beaton, Tukey, Technometrics 16 (1974) 147
/// Units       r and c: any, the same
/// Valid       c > 0; at least one residual
/// Accuracy    2 ulp (tests/math/tukey_test.cpp)

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fstiff {

/// 3 / Phi^-1(3/4): three standard deviations over the median of the absolute values of Gaussian numbers.
template <Real T>
inline constexpr T tukey_factor = T(4.447806655516805720L);

/// delta of the residual \p r.
template <Real T>
[[nodiscard]] constexpr T tukey_weight(T r, T c) noexcept {
    const T ratio = r / c, rest = 1 - ratio * ratio;
    return rest > T(0) ? rest * rest : T(0);
}

/// The median of \p values, whose order is lost; of an even number the mean of the middle two.
/// \throws domain_error when there are none.
template <Real T>
[[nodiscard]] T median(std::vector<T>& values) {
    require(!values.empty(), "values of a median", values.size(), "at least 1");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

/// The same of eight numbers, none of them NaN, by Batcher's sorting network.
template <Real T>
[[nodiscard]] T median_of_eight(std::array<T, 8> values) {
    constexpr std::array<std::array<std::size_t, 2>, 19> pairs{{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6},
                                                               {5, 7}, {1, 2}, {5, 6}, {0, 4}, {1, 5}, {2, 6}, {3, 7},
                                                               {2, 4}, {3, 5}, {1, 2}, {3, 4}, {5, 6}}};
    for (const auto& [low, high] : pairs) {
        const T a = values[low], b = values[high];
        values[low] = (std::min)(a, b);
        values[high] = (std::max)(a, b);
    }
    return (values[3] + values[4]) / 2;
}

namespace detail {

/// The rule for spikes, of profiles and maps: marks what is farther than \p limit robust standard deviations, 1.4826 times the
/// median of |d - median d|, from the median of \p differences (NaN: none). Marks nothing where that deviation is 0: more
/// than half of the differences are equal, and rounded heights do not show their spread.
template <Real T>
[[nodiscard]] std::vector<bool> far_from_median(const std::vector<T>& differences, T limit) {
    std::vector<T> some;
    for (const T d : differences)
        if (!std::isnan(d)) some.push_back(d);
    std::vector<bool> is_far(differences.size(), false);
    if (some.empty()) return is_far;
    const T middle = median(some);
    for (T& d : some) d = std::abs(d - middle);
    const T scale = tukey_factor<T> / 3 * median(some);
    if (scale > T(0))
        for (std::size_t i = 0; i < is_far.size(); ++i) is_far[i] = std::abs(differences[i] - middle) > limit * scale;
    return is_far;
}

}  // namespace detail

}  // namespace fstiff
