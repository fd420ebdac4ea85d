// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Heights over the triangles between points: of a mesh, or of a Delaunay triangulation.
///
/// Units       m
/// Valid       that of io/gridded.hpp

#include "io/gridded.hpp"

namespace fstiff::inline v0_1::io::detail {

struct TriangleMesh {
    std::vector<std::array<double, 3>> points;  ///< from the corner of least x and y; near ones are near in memory
    std::vector<Triangle> triangles;            ///< counterclockwise, none bridges a hole
    std::array<double, 2> corner{};
    std::array<double, 2> sides{};  ///< from there to the greatest x and y
    std::array<double, 2> phase{};  ///< mean offset of the points in x and y, modulo the step of mesh_of
    double spacing{};               ///< median length of the edges in x and y
    bool triangulated{};            ///< by Delaunay
    std::size_t repeated{};         ///< points with the x and y of another one, which are one now
    double turned_over{};           ///< share of the area of faces that look downwards
    double bridges{};               ///< share of the area of triangles that were left out
    std::size_t incomplete{};       ///< points without a position or a height
};

/// A map of a \p cloud with faces from a file of the \p form, which counts its vertices from \p first.
/// \throws domain_error for a face without a vertex, and as map_of_points does.
[[nodiscard]] Reading map_of_mesh(PointCloud cloud, const std::string& form, std::uint32_t first,
                                  const std::string& name, const SurfaceOptions& options);

/// \p step [m] is that of the phase; 0: none. \throws domain_error for points on one line and for what is no field of
/// heights.
[[nodiscard]] TriangleMesh mesh_of(PointCloud cloud, const std::string& name, double step = 0);

/// Twice the area of a triangle in x and y.
[[nodiscard]] inline double doubled_area(const std::array<double, 3>& a, const std::array<double, 3>& b,
                                         const std::array<double, 3>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// dz/dx and dz/dy of a triangle of \p area, which is doubled.
[[nodiscard]] inline std::array<double, 2> slope_of(const std::array<double, 3>& a, const std::array<double, 3>& b,
                                                    const std::array<double, 3>& c, double area) {
    const double b_z = b[2] - a[2], c_z = c[2] - a[2];
    return {(b_z * (c[1] - a[1]) - c_z * (b[1] - a[1])) / area, (c_z * (b[0] - a[0]) - b_z * (c[0] - a[0])) / area};
}

}  // namespace fstiff::inline v0_1::io::detail
