// SPDX-License-Identifier: BSD-3-Clause
#include "io/profile_or_map.hpp"

#include <fstiff/core/error.hpp>

namespace fstiff::io {

namespace detail {

namespace {

/// The profile that a map of one row is.
Profile<double> only_row(const HeightMap<double>& map) {
    return {std::vector<double>(map.heights.data(), map.heights.data() + map.size()), map.dx};
}

}  // namespace

void validate_map_or_row(const HeightMap<double>& map, Eigen::Index points) {
    if (map.rows() > 1)
        map.validate(points);
    else
        only_row(map).validate(static_cast<std::size_t>(points));
}

void set_spacings(HeightMap<double>& map, double dx, double dy, const std::string& name) {
    map.dx = dx;
    map.dy = map.rows() == 1 && dy == 0 ? dx : dy;
    located({.file = name}, [&] { validate_map_or_row(map, 2); });
}

ProfileOrMap as_surface(HeightMap<double> map, const std::string& name) {
    if (map.rows() > 1) return map;
    located({.file = name}, [&] { validate_map_or_row(map, 16); });
    return only_row(map);
}

}  // namespace detail

}  // namespace fstiff::io
