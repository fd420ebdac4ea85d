// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Height maps of a function of the place.
#include <fstiff/topography/height_map.hpp>

namespace test {

/// \p z(x, y) on \p rows x \p columns points, \p dx and \p dy apart, the first of which is at 0, 0 [m].
fstiff::HeightMap<double> map_of(Eigen::Index rows, Eigen::Index columns, double dx, double dy, const auto& z) {
    fstiff::HeightMap<double> map{fstiff::HeightMap<double>::Array(rows, columns), dx, dy};
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i)
            map.heights(j, i) = z(static_cast<double>(i) * dx, static_cast<double>(j) * dy);
    return map;
}

}  // namespace test
