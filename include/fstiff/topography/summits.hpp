// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The summits of a map one by one: where each stands, how high, and how it is curved.
///
///     summit      higher than all its eight neighbours
///     curvature   -d2z/dx2, -d2z/dy2 by three points; both are positive at a summit
///
/// A point at the border or beside a missing one is no summit, and is not counted in the area. Of a plateau no point is a summit.
///
/// Reference   Nayak, J. Lubr. Technol. 93 (1971) 398; the same rule as areal_statistics.hpp.
/// Units       heights above the mean plane and places [m], curvatures [1/m], area [m^2]
/// Valid       maps of 3 x 3 points at least; remove the form first
/// Accuracy    rounding; what three points lose of a curvature is (pi/samples of its wave)^2/3 (tests/topography/summits_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fstiff {

/// One point of a map that is higher than its eight neighbours.
template <Real T = double>
struct Summit {
    T height;                    ///< above the mean of the map [m]
    T curvature_x, curvature_y;  ///< [1/m]
    T x, y;                      ///< from the first point [m]

    /// R of the sphere of the same mean curvature [m].
    [[nodiscard]] T radius() const { return 2 / (curvature_x + curvature_y); }
};

/// All summits of a map.
template <Real T = double>
struct Summits {
    std::vector<Summit<T>> summits;  ///< the highest first
    T area{};                        ///< of the points that can be summits [m^2]
    T width{}, height{};             ///< of the map [m]
    T rms_height{};                  ///< of the map [m]
};

/// \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] Summits<T> summits_of(const HeightMap<T>& map) {
    map.validate();
    const auto& z = map.heights;
    const detail::MapHeights<T> heights(map);
    Summits<T> found;
    found.width = static_cast<T>(z.cols()) * map.dx;
    found.height = static_cast<T>(z.rows()) * map.dy;
    found.rms_height = static_cast<T>(std::sqrt(heights.variance) * heights.unit);
    std::size_t inner = 0;
    detail::visit_inner_points(map, {0, z.rows(), 0, z.cols()}, [&](Eigen::Index j, Eigen::Index i, bool summit) {
        ++inner;
        if (!summit) return;
        const T here = z(j, i);
        found.summits.push_back({static_cast<T>((heights.of(here) - heights.mean) * heights.unit),
                                 ((here - z(j, i - 1)) + (here - z(j, i + 1))) / map.dx / map.dx,
                                 ((here - z(j - 1, i)) + (here - z(j + 1, i))) / map.dy / map.dy, T(i) * map.dx,
                                 T(j) * map.dy});
    });
    found.area = static_cast<T>(inner) * map.dx * map.dy;
    std::sort(found.summits.begin(), found.summits.end(),
              [](const Summit<T>& a, const Summit<T>& b) { return a.height > b.height; });
    return found;
}

/// Another map of the same surface, as far as this one tells: \p tiles by \p tiles of it, drawn with replacement. \p state is
/// that of splitmix64, and goes on.
template <Real T>
[[nodiscard]] Summits<T> resampled(const Summits<T>& of, std::size_t tiles, std::uint64_t& state) {
    std::vector<std::size_t> times(tiles * tiles, 0);
    for (std::size_t i = 0; i < times.size(); ++i) ++times[splitmix64(state) % times.size()];
    const auto tile = [&](T x, T side) {
        return (std::min)(tiles - 1, static_cast<std::size_t>(x / side * static_cast<T>(tiles)));
    };
    Summits<T> drawn{{}, of.area, of.width, of.height, of.rms_height};
    for (const Summit<T>& one : of.summits)
        drawn.summits.insert(drawn.summits.end(), times[tile(one.y, of.height) * tiles + tile(one.x, of.width)], one);
    return drawn;
}

}  // namespace fstiff
