// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Points in JSON, such as [[x, y, z], ...] or {"points": [{"x": 1, "y": 2, "z": 3}, ...]}, as lines of text: the
// readers of text do the rest, and line 7 of their messages is point 7.

#include <cstddef>
#include <string>
#include <string_view>

namespace fstiff::surface {

/// Whether \p bytes begin as JSON with points, and not as a document of fstiff.
[[nodiscard]] bool is_points_json(std::string_view bytes);

struct PointLines {
    std::string text;
    std::string list;  ///< its name in the file; empty where it has none
    std::size_t points{};
};

/// Numbers of the only list of points in \p bytes, a point a line: all of an array, or x, y and z of an object, in this
/// order. What is not there or is null is missing, and other members are left out.
/// \throws domain_error for what is no JSON, for no list and for several, with \p name.
[[nodiscard]] PointLines lines_of_points(std::string_view bytes, const std::string& name);

}  // namespace fstiff::surface
