// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Robust Gaussian filter of maps: a map without its long waves, undisturbed by grooves and spikes.
///
///     w_ji = sum s((l-i) dx, (k-j) dy) delta_kl z_kl / sum s((l-i) dx, (k-j) dy) delta_kl        regression of order 0
///
/// s are the weights of topography/gaussian_map_filter, delta Tukey's (math/tukey), 0 for a missing point. Remove the
/// form first: a tilt is drawn inwards. A point with less than 1 % of the Gaussian weight left keeps its first w.
///
/// Reference   ISO 16610-71:2014 (order 0)
/// Units       heights, cut-off [m]
/// Valid       as topography/gaussian_map_filter; more than half of the points are surface
/// Accuracy    1e-10 of the rms height against the double sums (tests/topography/robust_gaussian_map_filter_test.cpp)

#include <fstiff/math/tukey.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>

namespace fstiff {

/// The long waves of \p map. \throws domain_error for a cut-off or a map out of range.
template <Real T>
[[nodiscard]] RobustWaviness<HeightMap<T>> robust_waviness(const HeightMap<T>& map, T cutoff) {
    using F = Accumulator<T>;
    detail::require_cut_off(map, cutoff);
    const detail::MapHeights<T> scaled(map);
    auto [along_x, along_y] = detail::smoothers(map, cutoff);
    const auto exists = [&](std::size_t k) { return !std::isnan(map.heights.data()[k]); };
    const auto z = detail::present_or_zero(map, scaled);
    std::vector<F> sums, weights;
    const auto sum = [&](const std::vector<F>& delta, const std::vector<F>& weighted) {
        weights = delta, sums = weighted;
        detail::smooth_both_ways(sums.data(), map.rows(), map.columns(), along_x, along_y);
        detail::smooth_both_ways(weights.data(), map.rows(), map.columns(), along_x, along_y);
    };
    const auto found = detail::robust_means(
        std::vector<F>(z.data(), z.data() + z.size()), F(0.01), exists, sum,
        [&](std::size_t k) { return weights[k]; }, [&](std::size_t k) { return sums[k] / weights[k]; });
    RobustWaviness<HeightMap<T>> result{map, found.left_out, found.iterations, found.converged};
    for (std::size_t k = 0; k < found.waviness.size(); ++k)
        if (exists(k))
            result.waviness.heights.data()[k] =
                static_cast<T>((found.waviness[k] + scaled.mean) * scaled.unit + scaled.datum);
    return result;
}

/// \p map without them. \throws domain_error as above.
template <Real T>
[[nodiscard]] HeightMap<T> robust_high_pass(const HeightMap<T>& map, T cutoff) {
    HeightMap<T> high = robust_waviness(map, cutoff).waviness;
    high.heights = map.heights - high.heights;
    return high;
}

}  // namespace fstiff
