// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Files of points that may hold one row: that row is a profile, and its dy is no more than a word.
///
/// Units       m

#include <fstiff/core/error.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/topography/height_map.hpp>

#include <string>
#include <utility>
#include <variant>

namespace fstiff::io {

/// What a measured file holds.
using ProfileOrMap = std::variant<Profile<double>, HeightMap<double>>;

namespace detail {

/// The profile that a map of one row is.
inline Profile<double> only_row(const HeightMap<double>& map) {
    return {std::vector<double>(map.heights.data(), map.heights.data() + map.size()), map.dx};
}

/// A map of one row has \p points at least, a map of more at least as many a side. \throws domain_error otherwise.
inline void validate_map_or_row(const HeightMap<double>& map, Eigen::Index points) {
    if (map.rows() > 1)
        map.validate(points);
    else
        only_row(map).validate(static_cast<std::size_t>(points));
}

/// Gives \p map the spacings that file \p name states: dy = dx for one row whose dy is 0.
/// \throws domain_error when the heights are too few, do not vary, or are not finite.
inline void set_spacings(HeightMap<double>& map, double dx, double dy, const std::string& name) {
    map.dx = dx;
    map.dy = map.rows() == 1 && dy == 0 ? dx : dy;
    located({.file = name}, [&] { validate_map_or_row(map, 2); });
}

/// One row is a profile, which has 16 points at least. \throws domain_error naming the file \p name.
inline ProfileOrMap as_surface(HeightMap<double> map, const std::string& name) {
    if (map.rows() > 1) return map;
    located({.file = name}, [&] { validate_map_or_row(map, 16); });
    return only_row(map);
}

}  // namespace detail

}  // namespace fstiff::io
