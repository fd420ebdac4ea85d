// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Gaussian filter of maps, and the robust one, which ignores grooves and spikes: removes short or long waves.
///
///     low pass w_ji = sum s((l-i) dx, (k-j) dy) z_kl / sum s((l-i) dx, (k-j) dy),  high pass z - w    cut-off c
///     s(x, y) = exp(-pi (x^2 + y^2)/(a c)^2),  a = sqrt(ln 2/pi);  a wave of length l passes by exp(-ln 2 (c/l)^2)
///     robust: both sums with Tukey's weights delta_kl (math/tukey), regression of order 0
///
/// Rows and then columns are summed over the existing points: a constant is kept at the edges and at gaps, a tilt is
/// not, so remove the form first. A missing point stays missing. A point keeps its first w where less than 1 % of the
/// Gaussian weight is left.
/// Reference   ISO 16610-61:2015; ISO 16610-28:2016 (ends); ISO 16610-71:2014 (robust)
/// Units       heights, cut-off [m]
/// Valid       2 steps of the coarser side <= cut-off <= shorter side; robust: more than half of the points are surface
/// Accuracy    1e-13 of the range of the heights, robust 1e-10 of the rms height (tests/topography/
///             gaussian_map_filter_test.cpp, robust_gaussian_map_filter_test.cpp)

#include <fstiff/math/gaussian_smoother.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/math/tukey.hpp>
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/topography/height_map.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real F>
using FilteredHeights = Eigen::Array<F, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Weighted sums of every row of \p z, then of every column.
template <Real F, Real T>
void smooth_both_ways(F* z, const HeightMap<T>& map,
                      std::pair<math::GaussianSmoother<F>, math::GaussianSmoother<F>>& along) {
    constexpr std::size_t lines = math::GaussianSmoother<F>::lines;
    const auto height = static_cast<std::size_t>(map.rows()), width = static_cast<std::size_t>(map.columns());
    for (std::size_t j = 0; j < height; j += lines)
        along.first.of_lines(z + j * width, 1, width, (std::min)(lines, height - j));
    for (std::size_t i = 0; i < width; i += lines) along.second.of_lines(z + i, width, 1, (std::min)(lines, width - i));
}

/// \throws domain_error for a map out of range, or a cut-off that is not valid for it.
template <Real T>
void require_cut_off(const HeightMap<T>& map, T cutoff) {
    map.validate();
    const T shorter = (std::min)(static_cast<T>(map.columns()) * map.dx, static_cast<T>(map.rows()) * map.dy);
    require(cutoff >= 2 * (std::max)(map.dx, map.dy) * (1 - 4 * std::numeric_limits<T>::epsilon()) && cutoff <= shorter,
            "cut-off", cutoff, "at least 2 steps and at most the shorter side of the map");
}

/// Weights along x and along y.
template <Real T>
[[nodiscard]] std::pair<math::GaussianSmoother<double>, math::GaussianSmoother<double>> smoothers(
    const HeightMap<T>& map, T cutoff) {
    const auto along = [&](Eigen::Index points, T step) {
        return math::GaussianSmoother<double>(static_cast<std::size_t>(points),
                                              static_cast<double>(cutoff) / static_cast<double>(step));
    };
    return {along(map.columns(), map.dx), along(map.rows(), map.dy)};
}

/// Heights relative to their mean; 0 where a point is missing.
template <Real T>
[[nodiscard]] FilteredHeights<double> present_or_zero(const HeightMap<T>& map, const MapHeights<T>& heights) {
    FilteredHeights<double> z(map.rows(), map.columns());
    for (Eigen::Index k = 0; k < map.size(); ++k) {
        const T height = map.heights.data()[k];
        z.data()[k] = std::isnan(height) ? 0.0 : static_cast<double>(heights.in_units(height) - heights.mean);
    }
    return z;
}

/// \p map without its short waves. \throws domain_error for a cut-off or a map out of range.
template <Real T>
[[nodiscard]] HeightMap<T> gaussian_low_pass(const HeightMap<T>& map, T cutoff) {
    require_cut_off(map, cutoff);
    const MapHeights<T> heights(map);
    auto along = smoothers(map, cutoff);
    FilteredHeights<double> z = present_or_zero(map, heights);
    smooth_both_ways(z.data(), map, along);
    if (map.present() == map.size()) {  // the weights are a product as well
        std::vector<double> of_x(static_cast<std::size_t>(map.columns()), 1.0),
            of_y(static_cast<std::size_t>(map.rows()), 1.0);
        along.first(of_x);
        along.second(of_y);
        for (Eigen::Index j = 0; j < map.rows(); ++j)
            for (Eigen::Index i = 0; i < map.columns(); ++i)
                z(j, i) /= of_x[static_cast<std::size_t>(i)] * of_y[static_cast<std::size_t>(j)];
    } else {
        FilteredHeights<double> weights = map.heights.isNaN()
                                              .select(T(0), HeightMap<T>::Array::Ones(map.rows(), map.columns()))
                                              .template cast<double>();
        smooth_both_ways(weights.data(), map, along);
        z /= weights;  // of a missing point it may be 0/0, and is not used
    }
    HeightMap<T> low;
    low.dx = map.dx;
    low.dy = map.dy;
    const auto height = [&](Eigen::Index k) {  // or NaN, as in the map
        const T before = map.heights.data()[k];
        return std::isnan(before) ? before
                                  : static_cast<T>((z.data()[k] + heights.mean) * heights.unit + heights.datum);
    };
    if constexpr (std::is_same_v<double, T>) {  // into the memory of the sums
        for (Eigen::Index k = 0; k < map.size(); ++k) z.data()[k] = height(k);
        low.heights = std::move(z);
    } else {
        low.heights.resize(map.rows(), map.columns());
        for (Eigen::Index k = 0; k < map.size(); ++k) low.heights.data()[k] = height(k);
    }
    return low;
}

/// \p map without its long waves. \throws domain_error as above.
template <Real T>
[[nodiscard]] HeightMap<T> gaussian_high_pass(const HeightMap<T>& map, T cutoff) {
    HeightMap<T> high = gaussian_low_pass(map, cutoff);
    high.heights = map.heights - high.heights;
    return high;
}

/// Long waves of \p map. \throws domain_error for a cut-off or a map out of range.
template <Real T>
[[nodiscard]] math::RobustWaviness<HeightMap<T>> robust_waviness(const HeightMap<T>& map, T cutoff) {
    require_cut_off(map, cutoff);
    const MapHeights<T> scaled(map);
    auto along = smoothers(map, cutoff);
    const auto exists = [&](std::size_t k) { return !std::isnan(map.heights.data()[k]); };
    const auto z = present_or_zero(map, scaled);
    std::vector<double> sums, weights;
    const auto sum = [&](const std::vector<double>& delta, const std::vector<double>& weighted) {
        weights = delta, sums = weighted;
        smooth_both_ways(sums.data(), map, along);
        smooth_both_ways(weights.data(), map, along);
    };
    const auto means = math::robust_means(
        std::vector<double>(z.data(), z.data() + z.size()), 0.01, exists, sum,
        [&](std::size_t k) { return weights[k]; }, [&](std::size_t k) { return sums[k] / weights[k]; });
    math::RobustWaviness<HeightMap<T>> result{map, means.left_out, means.iterations, means.converged};
    for (std::size_t k = 0; k < means.waviness.size(); ++k)
        if (exists(k))
            result.waviness.heights.data()[k] =
                static_cast<T>((means.waviness[k] + scaled.mean) * scaled.unit + scaled.datum);
    return result;
}

}}}  // namespace fstiff::detail
