// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A map without its long waves by the robust Gaussian filter of maps, which grooves and spikes do not draw towards them.
///
///     w_ji = sum s((l-i) dx, (k-j) dy) delta_kl z_kl / sum s((l-i) dx, (k-j) dy) delta_kl         regression of order 0
///     s: weights of topography/gaussian_map_filter, delta: Tukey's of z - w (math/tukey), all 1 at first; again until their
///     scale changes by less than 1e-4
///
/// With delta = 1 this is the filter of topography/gaussian_map_filter. Like it, it draws a tilt at the edges inwards:
/// remove the form first. Missing points have the weight 0 and stay missing. A point around which less than 1 % of the
/// Gaussian weight is left keeps its first w. More than half of the points must be surface.
///
/// Reference   ISO 16610-71:2014 (order 0)
/// Units       heights, cut-off [m]
/// Valid       2 steps of the coarser side <= cut-off <= the shorter side; maps as HeightMap::validate
/// Accuracy    1e-10 of the rms height against the double sums (tests/topography/robust_gaussian_map_filter_test.cpp)

#include <fstiff/math/tukey.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>

namespace fstiff {

/// What the robust filter says are the long waves of a map.
template <Real T = double>
struct RobustMapWaviness {
    HeightMap<T> waviness;
    std::size_t left_out{};  ///< points of weight 0
    int iterations{};
    bool converged{};  ///< false: the scale of the weights still changed after 100 iterations
};

/// The long waves of \p map. \throws domain_error for a cut-off or a map out of range.
template <Real T>
[[nodiscard]] RobustMapWaviness<T> robust_waviness(const HeightMap<T>& map, T cutoff);

/// \p map without them. \throws domain_error as above.
template <Real T>
[[nodiscard]] HeightMap<T> robust_high_pass(const HeightMap<T>& map, T cutoff);

template <Real T>
RobustMapWaviness<T> robust_waviness(const HeightMap<T>& map, T cutoff) {
    using F = Accumulator<T>;
    using Array = detail::FilteredHeights<F>;
    detail::require_cut_off(map, cutoff);
    const detail::MapHeights<T> scaled(map);
    auto [along_x, along_y] = detail::smoothers(map, cutoff);
    const Array z = detail::present_or_zero(map, scaled);
    Array delta =
        map.heights.isNaN().select(T(0), HeightMap<T>::Array::Ones(map.rows(), map.columns())).template cast<F>();
    RobustMapWaviness<T> result;
    Array wave = Array::Zero(map.rows(), map.columns()), full;
    std::vector<F> residuals;
    F previous = 0;
    for (;; ++result.iterations) {
        Array heights = z * delta, weights = delta;
        detail::smooth_both_ways(heights, along_x, along_y);
        detail::smooth_both_ways(weights, along_x, along_y);
        if (result.iterations == 0) full = weights;
        residuals.clear();
        for (Eigen::Index k = 0; k < map.size(); ++k) {
            if (std::isnan(map.heights.data()[k])) continue;
            if (weights.data()[k] >= F(0.01) * full.data()[k]) wave.data()[k] = heights.data()[k] / weights.data()[k];
            residuals.push_back(std::abs(z.data()[k] - wave.data()[k]));
        }
        const F c = tukey_factor<F> * median(residuals);
        result.converged = std::abs(c - previous) <= F(1e-4) * c;
        if (result.converged || c == F(0) || result.iterations == 100) break;
        previous = c;
        for (Eigen::Index k = 0; k < map.size(); ++k)
            delta.data()[k] = std::isnan(map.heights.data()[k]) ? F(0) : tukey_weight(z.data()[k] - wave.data()[k], c);
    }
    result.waviness = map;
    for (Eigen::Index k = 0; k < map.size(); ++k) {
        if (std::isnan(map.heights.data()[k])) continue;
        result.waviness.heights.data()[k] = static_cast<T>((wave.data()[k] + scaled.mean) * scaled.unit + scaled.datum);
        if (delta.data()[k] == F(0)) ++result.left_out;
    }
    return result;
}

template <Real T>
HeightMap<T> robust_high_pass(const HeightMap<T>& map, T cutoff) {
    HeightMap<T> high = robust_waviness(map, cutoff).waviness;
    high.heights = map.heights - high.heights;
    return high;
}

}  // namespace fstiff
