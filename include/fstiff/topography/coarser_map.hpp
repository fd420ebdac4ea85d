// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A map on a coarser grid: each new cell has the mean height of the area that it covers.
///
/// Units       as the map
/// Valid       maps without missing points; at most as many cells as there are points
/// Accuracy    the mean height is kept to 1e-14 of the largest (tests/topography/coarsen_test.cpp)

#include <fstiff/topography/height_map.hpp>

#include <Eigen/Core>
#include <algorithm>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Each row of \p fine on \p to longer cells, transposed: cell j of row i is in row j, column i.
template <Real T>
typename HeightMap<T>::Array coarsened_rows(const typename HeightMap<T>::Array& fine, Eigen::Index to) {
    const Eigen::Index from = fine.cols();
    const T length = T(from) / T(to);
    typename HeightMap<T>::Array coarse = HeightMap<T>::Array::Zero(to, fine.rows());
    for (Eigen::Index j = 0; j < to; ++j) {
        const T begin = T(j) * length, end = T(j + 1) * length;
        for (auto i = static_cast<Eigen::Index>(begin); i < from && T(i) < end; ++i) {
            const T share = (std::max)(T(0), (std::min)(end, T(i + 1)) - (std::max)(begin, T(i))) / length;
            for (Eigen::Index row = 0; row < fine.rows(); ++row) coarse(j, row) += share * fine(row, i);
        }
    }
    return coarse;
}

/// \p map on \p columns by \p rows cells over the same area.
/// \throws domain_error for missing points, for less than 1 cell and for more cells than points.
template <Real T>
[[nodiscard]] HeightMap<T> coarsened(const HeightMap<T>& map, Eigen::Index columns, Eigen::Index rows) {
    require(columns >= 1 && columns <= map.columns(), "columns", columns, "from 1 to those of the map");
    require(rows >= 1 && rows <= map.rows(), "rows", rows, "from 1 to those of the map");
    map.require_whole("before it is made coarser");
    HeightMap<T> coarse;
    coarse.dx = map.dx * T(map.columns()) / T(columns);
    coarse.dy = map.dy * T(map.rows()) / T(rows);
    coarse.heights = coarsened_rows<T>(coarsened_rows<T>(map.heights, columns), rows);
    return coarse;
}

/// \p map with \p points along its longer side (unchanged where it has no more), with the same aspect of the cells.
template <Real T>
[[nodiscard]] HeightMap<T> coarsened(const HeightMap<T>& map, Eigen::Index points) {
    require(points >= 1, "points", points, "at least 1");
    const Eigen::Index longer = (std::max)(map.columns(), map.rows());
    if (longer <= points) return map;
    const auto side = [&](Eigen::Index n) {
        return (std::max)(Eigen::Index(1),
                          static_cast<Eigen::Index>(std::lround(double(n) * double(points) / double(longer))));
    };
    return coarsened(map, side(map.columns()), side(map.rows()));
}

}}}  // namespace fstiff::detail
