// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A map on a regular grid from points in any order: clouds, meshes, grids whose positions scatter.
///
/// The heights are linear over the triangles of the mesh or, without a mesh, of a Delaunay triangulation. z is the
/// height. Nodes outside of all triangles are missing, and so are those in triangles with an edge above five median
/// edges, which bridge a hole. The grid has the phase of the points in x and y, so that one that scatters about equal
/// steps keeps its nodes. An outer line with more missing nodes than the one next to it is left out, once a side.
///
///     phase    x_0 = arg(sum exp(2 pi i x/h)) h/(2 pi)                            h: the step
///
/// Refused: points on one line, fewer than three, a plane tilted by more than 45 degrees, and what is no field of
/// heights: a fifth of the area steeper than 10, a hundredth of a mesh turned over, a hundredth of the points with
/// another height at the same x and y. Below that the mean of such points is taken, and the upper one of two faces.
///
/// Units       x, y, z of the file, with a factor to m each; map in m
/// Valid       at most 2^28 points and 2^26 nodes
/// Accuracy    planes within 1e-13 of their range, scipy's LinearNDInterpolator within 1e-12
///             (tests/io/gridded_test.cpp)

#include "io/reading.hpp"
#include "io/triangulation.hpp"

#include <array>

namespace fstiff::inline v0_1::io::detail {

struct PointCloud {
    std::vector<std::array<double, 3>> points{};  ///< x, y, z; NaN in one that is missing
    std::vector<Triangle> faces{};                ///< of a mesh
    std::array<double, 3> units{1, 1, 1};         ///< [m]
    std::array<std::string, 3> unit_names{};      ///< for messages
};

/// Puts \p cloud on a grid of the step \p options.grid, and notes how. \throws domain_error as above.
[[nodiscard]] RawMap gridded(PointCloud cloud, const std::string& name, const SurfaceOptions& options, Record& record);

/// The option that puts points on a grid, with their median spacing where they are a field of heights:
/// --grid "0.2 mm".
[[nodiscard]] std::string proposed_grid(PointCloud cloud, const std::string& name, const OptionNames& names);

/// A map of the points of a file that states no units: on the regular grid on which they lie, or on that of
/// \p options.grid. \throws domain_error as above, and without units or a grid.
[[nodiscard]] Reading map_of_points(PointCloud cloud, const std::string& name, const SurfaceOptions& options,
                                    Record record);

}  // namespace fstiff::inline v0_1::io::detail
