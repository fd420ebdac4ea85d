// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Bearing curve (Abbott-Firestone): the height above which a given share of a profile or map lies.
///
///     z(s)   with   number of heights above z(s) = s N,  s = 0 ... 1
///
/// z(0) is the highest point, z(1) the lowest. The curve is the bearing area for a map and the bearing length for a
/// profile; both are equal for an isotropic surface.
///
/// Reference   Abbott, Firestone, Mech. Eng. 55 (1933) 569; ISO 21920-2 and ISO 25178-2 (material ratio)
/// Units       heights in any unit, shares from 0 to 1
/// Valid       heights finite, or NaN where a point is missing; at least one exists
/// Accuracy    each height is one of the given heights: number s N from above, the lowest at s = 1
///             (tests/surface/bearing_curve_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/statistics.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Heights by the share of the points above them.
template <Real T = double>
struct MaterialRatioCurve {
    std::vector<T> share;   ///< of the points above the height, from 0 to 1
    std::vector<T> height;  ///< falls with the share

    [[nodiscard]] std::size_t size() const { return share.size(); }
};

/// Curve of \p heights at \p steps + 1 equal steps of the share. \throws domain_error when no height exists, or for 0
/// steps.
template <Real T>
[[nodiscard]] MaterialRatioCurve<T> bearing_curve(std::span<const T> heights, std::size_t steps = 200) {
    detail::require(steps >= 1, "steps of a bearing curve", steps, "at least 1");
    std::vector<T> sorted;
    sorted.reserve(heights.size());
    std::copy_if(heights.begin(), heights.end(), std::back_inserter(sorted), [](T z) { return !std::isnan(z); });
    detail::require(!sorted.empty(), "heights of a bearing curve", sorted.size(), "at least 1");
    math::sort_falling<T>(sorted, std::identity());
    MaterialRatioCurve<T> curve;
    for (std::size_t k = 0; k <= steps; ++k) {
        curve.share.push_back(static_cast<T>(k) / static_cast<T>(steps));
        curve.height.push_back(sorted[(std::min)(sorted.size() - 1, k * sorted.size() / steps)]);
    }
    return curve;
}

}}  // namespace fstiff
