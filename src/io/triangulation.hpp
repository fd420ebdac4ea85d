// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Delaunay triangulation of points of the plane, by division in halves across x and y in turn.
///
/// Positions are whole numbers, so that the side of a line and the inside of a circle are exact: collinear points,
/// points of a raster (four on each circle) and long thin clouds need no care of the caller.
///
/// Reference   Guibas, Stolfi, ACM Trans. Graphics 4 (1985) 74-123; halves across both axes: Dwyer, Algorithmica 2
///             (1987) 137-151
/// Units       none
/// Valid       distinct points, at most 2^28, of coordinates from 0 to 2^26
/// Accuracy    exact (tests/io/triangulation_test.cpp); time O(n log n)

#include <array>
#include <cstdint>
#include <vector>

namespace fstiff::inline v0_1::io::detail {

struct GridPoint {
    std::int32_t x{}, y{};
    bool operator==(const GridPoint&) const = default;
};

inline constexpr std::int32_t most_grid_position = std::int32_t(1) << 26;

/// Indices of three points, counterclockwise.
using Triangle = std::array<std::uint32_t, 3>;

/// The triangles of \p points, which cover their convex hull; none of points on one line.
[[nodiscard]] std::vector<Triangle> delaunay(const std::vector<GridPoint>& points);

}  // namespace fstiff::inline v0_1::io::detail
