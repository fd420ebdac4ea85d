// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps that are triangles (.stl), binary and text: a height over x and y.
///
/// Binary are 80 bytes, the number of triangles (uint32), and of each triangle its normal, its three corners (x, y, z;
/// float32) and two bytes more, the least significant byte first. Text is "solid", then of each triangle
///
///     facet normal n n n   outer loop   vertex x y z   vertex x y z   vertex x y z   endloop   endfacet
///
/// The corners must lie on a regular grid of x and y, one height to a point, and each triangle within one cell of it.
/// Points of the grid without a corner are missing. Closed bodies, walls and other meshes are refused. Normals and
/// colours are not read.
///
/// Reference   3D Systems, StereoLithography Interface Specification (1989), as published by many
/// Units       map in m; the file states none, so that an option must
/// Valid       2 points a side at least; heights that vary; rows from the lowest y
/// Accuracy    the number of the file times the unit, rounded once (tests/io/stl_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes are a whole binary file of triangles, or begin as a text of them does.
[[nodiscard]] bool is_stl(std::string_view bytes);

/// Whether \p bytes may be the first of a binary file of triangles.
[[nodiscard]] bool may_be_stl(std::string_view bytes);

/// Uses the units and the names of the options. \throws domain_error naming file, triangle and what is allowed.
[[nodiscard]] Reading read_stl(std::string_view bytes, std::string_view name, const SurfaceOptions& options = {});

}  // namespace fstiff::inline v0_1::io
