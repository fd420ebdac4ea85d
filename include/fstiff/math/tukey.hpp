// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Robust filtering of profiles and maps: Tukey's weights, the iteration with them, and the rule for spikes.
///
///     delta(r) = (1 - (r/c)^2)^2 for |r| < c, else 0;   c = 3 * 1.4826 median |r| = 4.4478 median |r|
///
/// c is three standard deviations of Gaussian residuals, whatever the other residuals are.
///
/// Reference   ISO 16610-31:2016, 4.3 and ISO 16610-71:2014, 4.3; Beaton, Tukey, Technometrics 16 (1974) 147
/// Units       r and c: any, the same
/// Valid       c > 0; at least one residual
/// Accuracy    2 ulp of the weights (tests/math/tukey_test.cpp)

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

/// Long waves of a profile or a map by a robust filter.
template <class Surface>
struct RobustWaviness {
    Surface waviness{};
    std::size_t left_out{};  ///< points of weight 0
    int iterations{};
    bool converged{};  ///< false: the scale of the weights still changed after 100 iterations
};

/// Result of a repair: \p removed points became missing; \p missing are missing, \p longest of them in one run or hole.
struct Repair {
    std::size_t removed{}, missing{}, longest{};
};

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
    detail::require(!values.empty(), "values of a median", values.size(), "at least 1");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

/// The same for eight numbers, none of them NaN, by Batcher's sorting network.
template <Real T>
[[nodiscard]] T median_of_eight(std::array<T, 8> values) {
    // clang-format off
    constexpr std::array<std::array<std::size_t, 2>, 19> pairs{{{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6},
                                                               {5, 7}, {1, 2}, {5, 6}, {0, 4}, {1, 5}, {2, 6}, {3, 7},
                                                               {2, 4}, {3, 5}, {1, 2}, {3, 4}, {5, 6}}};
    // clang-format on
    for (const auto& [low, high] : pairs) {
        const T a = values[low], b = values[high];
        values[low] = (std::min)(a, b);
        values[high] = (std::max)(a, b);
    }
    return (values[3] + values[4]) / 2;
}

/// How far \p centre is beyond both \p a and \p b, on the side of \p sign; at most 0 where one is as far; without NaN
template <Real T>
[[nodiscard]] T beyond_both(T centre, T a, T b, T sign) {
    if (std::isnan(a)) a = b;
    if (std::isnan(b)) b = a;
    return (std::min)(sign * (centre - a), sign * (centre - b));
}

/// Whether a point that is \p inner beyond the points around it, \p outer beyond those farther away, and \p difference
/// from its neighbours is a spike of \p limit standard deviations: the top of a bump falls farther with distance.
template <Real T>
[[nodiscard]] bool has_no_foot(T inner, T outer, T difference, T limit) {
    return outer > std::abs(difference) / 2 && inner > limit / 6 * (outer - inner);
}

/// Counts the spikes among \p heights, and with \p remove makes them NaN: those whose \p differences (NaN: none) are
/// farther than \p limit robust standard deviations, 1.4826 times the median of |d - median d|, from their median, and
/// that are \p alone(place, difference).
/// Finds none where that deviation is 0, because rounded heights do not show their spread.
template <Real T, class Alone>
Repair spikes_among(T* heights, const std::vector<T>& differences, T limit, bool remove, const Alone& alone) {
    std::vector<T> finite;
    for (const T d : differences)
        if (!std::isnan(d)) finite.push_back(d);
    Repair repair;
    if (finite.empty()) return repair;
    const T middle = median(finite);
    for (T& d : finite) d = std::abs(d - middle);
    const T scale = tukey_factor<T> / 3 * median(finite);
    if (!(scale > T(0))) return repair;
    std::vector<std::size_t> spikes;
    for (std::size_t i = 0; i < differences.size(); ++i)
        if (std::abs(differences[i] - middle) > limit * scale && alone(i, differences[i])) spikes.push_back(i);
    repair.removed = spikes.size();
    if (remove)
        for (const std::size_t i : spikes) heights[i] = std::numeric_limits<T>::quiet_NaN();
    return repair;
}

/// Robust means of \p z, 0 where \p exists(i) is false. \p sum(delta, delta z) forms the weighted sums, with \p
/// weight(i) and \p value(i) as the weight left and the mean; both iterate until the scale of the weights changes by
/// less than 1e-4. A point with less than \p least_share of its first weight keeps its last mean.
template <Real F, class Exists, class Sum, class Weight, class Value>
[[nodiscard]] RobustWaviness<std::vector<F>> robust_means(const std::vector<F>& z, F least_share, const Exists& exists,
                                                          const Sum& sum, const Weight& weight, const Value& value) {
    RobustWaviness<std::vector<F>> result{.waviness = std::vector<F>(z.size())};
    std::vector<F>& wave = result.waviness;
    std::vector<F> delta(z.size()), weighted(z.size()), full(z.size()), residuals;
    for (std::size_t i = 0; i < z.size(); ++i) delta[i] = exists(i) ? F(1) : F(0);
    for (F previous = 0;; ++result.iterations) {
        for (std::size_t i = 0; i < z.size(); ++i) weighted[i] = delta[i] * z[i];
        sum(delta, weighted);
        residuals.clear();
        for (std::size_t i = 0; i < z.size(); ++i) {
            if (!exists(i)) continue;
            if (result.iterations == 0) full[i] = weight(i);
            if (weight(i) >= least_share * full[i]) wave[i] = value(i);
            residuals.push_back(std::abs(z[i] - wave[i]));
        }
        const F c = tukey_factor<F> * median(residuals);
        result.converged = std::abs(c - previous) <= F(1e-4) * c;
        if (result.converged || c == F(0) || result.iterations == 100) break;
        previous = c;
        for (std::size_t i = 0; i < z.size(); ++i) delta[i] = exists(i) ? tukey_weight(z[i] - wave[i], c) : F(0);
    }
    for (std::size_t i = 0; i < z.size(); ++i) result.left_out += exists(i) && delta[i] == F(0) ? 1u : 0u;
    return result;
}

}}}  // namespace fstiff::math
