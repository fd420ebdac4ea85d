// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Gaussian map whose heights have the order of those of a map, and the bearing curve that maps it back.
///
///     h(x, y) = f(zeta(x, y))      zeta = Phi^-1((rank + 1/2)/N)       the map is sigma zeta
///
/// Equal heights stay equal: they have their mean rank.
///
/// Reference   surface/material_ratio_curve.hpp
/// Units       heights [m]
/// Valid       as HeightMap::validate; missing points stay missing
/// Accuracy    rounding (tests/topography/gaussian_order_test.cpp)

#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// A map as a Gaussian one and a bearing curve.
template <Real T = double>
struct GaussianOrder {
    HeightMap<T> map;             ///< sigma zeta [m]
    MaterialRatioSlope<T> curve;  ///< f [m]
    T rms_height{};               ///< sigma, of the map itself [m]
};

/// \throws domain_error as HeightMap::validate.
template <Real T>
[[nodiscard]] GaussianOrder<T> gaussian_order(const HeightMap<T>& map) {
    map.validate();
    std::vector<std::pair<T, Eigen::Index>> order;
    order.reserve(static_cast<std::size_t>(map.size()));
    for (Eigen::Index i = 0; i < map.size(); ++i)
        if (!std::isnan(map.heights.data()[i])) order.emplace_back(map.heights.data()[i], i);
    math::sort_falling<T>(order, [](const auto& point) { return -point.first; });  // equal ones in their order
    std::vector<T> sorted;
    sorted.reserve(order.size());
    for (const auto& [height, index] : order) sorted.push_back(height);
    const T sigma = rms_height(map);
    HeightMap<T> gaussian = map;
    auto curve = MaterialRatioSlope<T>::of_sorted(sorted, [&](std::size_t from, std::size_t to, T score) {
        for (std::size_t i = from; i < to; ++i) gaussian.heights.data()[order[i].second] = sigma * score;
    });
    return {std::move(gaussian), std::move(curve), sigma};
}

}}}  // namespace fstiff::detail
