// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Summits of a map: place, height and principal curvatures of each.
///
///     summit      higher than all its eight neighbours
///     curvatures  eigenvalues k1 >= k2 of -H, H the second differences of fourth order, over five points a side
///     top         z + g dx + (1/2) dx H dx at dx = -H^(-1) g: one Newton step, of at most one grid step along x and y
///
/// A point at the border or next to a missing one is no summit, and its area does not count. A summit with
/// k2 <= 1e-3 k1, a paraboloid without a top, is a point of a ridge and left out.
///
/// Reference   Nayak, J. Lubr. Technol. 93 (1971) 398
/// Units       heights above the mean plane and places [m], curvatures [1/m], area [m^2]
/// Valid       maps of at least 3 x 3 points; remove the form first
/// Accuracy    rounding for a paraboloid; five points lose (8/45) (pi/samples of its wave)^4 of a curvature
///             (tests/topography/summits_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/height_map.hpp>

#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// A point of a map that is higher than its eight neighbours, as the top of a paraboloid.
template <Real T = double>
struct Summit {
    T height;                        ///< of the top above the mean of the map [m]
    T max_curvature, min_curvature;  ///< k1, k2 of the principal directions [1/m]
    T x, y;                          ///< of the top, from the first point [m]
    /// Factors of the ellipse of Hertz [m^(1/2), m], by with_hertz_factors(); else 0.
    T load_factor{}, area_factor{};

    /// R of the sphere of the same mean curvature [m].
    [[nodiscard]] T radius() const { return 2 / (max_curvature + min_curvature); }
};

/// All summits of a map.
template <Real T = double>
struct Summits {
    std::vector<Summit<T>> summits;  ///< the highest first
    T area{};                        ///< of the points that can be summits [m^2]
    T width{}, height{};             ///< of the map [m]
    T rms_height{};                  ///< of the map [m]
    T dx{}, dy{};                    ///< steps of the map [m]: its edges are half a step beyond the outer points
    std::size_t ridges = 0;          ///< points above their neighbours whose paraboloid has no top
};

namespace detail {

/// Height, gradient and second derivatives at one point, for steps of 1 along x and y.
template <Real T>
struct PointShape {
    T z, z_x, z_y, z_xx, z_yy, z_xy;
};

/// Differences of fourth order over the 5 x 5 points about (\p j, \p i), of second order over 3 x 3 next to an edge or
/// a missing point; heights are relative to the one at this point.
template <Real T, class Heights>
[[nodiscard]] PointShape<T> shape_by_differences(const Heights& z, Eigen::Index j, Eigen::Index i) {
    const auto height = [&](Eigen::Index down, Eigen::Index right) {
        return static_cast<T>(z(j + down, i + right) - z(j, i));
    };
    // odd(a, b) of the points +-1 and +-2 is the first derivative, even(a, b) the second
    const bool wide =
        j >= 2 && i >= 2 && j + 2 < z.rows() && i + 2 < z.cols() && !z.template block<5, 5>(j - 2, i - 2).isNaN().any();
    const auto odd = [&](const auto& f) {
        return wide ? (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / 12 : (f(1) - f(-1)) / 2;
    };
    const auto even = [&](const auto& f) { return wide ? (16 * (f(1) + f(-1)) - (f(2) + f(-2))) / 12 : f(1) + f(-1); };
    const auto along_x = [&](Eigen::Index k) { return height(0, k); };
    const auto along_y = [&](Eigen::Index k) { return height(k, 0); };
    const auto slope_x = [&](Eigen::Index down) { return odd([&](Eigen::Index k) { return height(down, k); }); };
    return {T(0), odd(along_x), odd(along_y), even(along_x), even(along_y), odd(slope_x)};
}

/// Top of the paraboloid of \p shape: height, curvatures and place in m, with the steps \p dx and \p dy [m], at most
/// \p reach grid steps away. There is no top for curvatures of both signs.
template <Real T>
[[nodiscard]] Summit<T> top_of(const PointShape<T>& shape, T dx, T dy, T reach) {
    const auto& [z, z_x, z_y, z_xx, z_yy, z_xy] = shape;
    const T k_x = -z_xx / dx / dx, k_y = -z_yy / dy / dy;
    const T mean = (k_x + k_y) / 2, half = std::hypot((k_x - k_y) / 2, z_xy / dx / dy);
    const T max_curvature = mean + half,
            min_curvature = (k_x * k_y - (z_xy / dx / dy) * (z_xy / dx / dy)) / max_curvature;
    const T determinant = z_xx * z_yy - z_xy * z_xy;
    T right = (z_xy * z_y - z_yy * z_x) / determinant, down = (z_xy * z_x - z_xx * z_y) / determinant;
    const T longest = (std::max)(std::abs(right), std::abs(down));
    if (longest > reach) right *= reach / longest, down *= reach / longest;
    const T rise = z_x * right + z_y * down + (z_xx * right * right + z_yy * down * down) / 2 + z_xy * right * down;
    return {z + rise, max_curvature, min_curvature, right * dx, down * dy};
}

/// Minimum k2/k1 of a summit.
template <Real T>
inline constexpr T min_curvature_ratio = T(1e-3);

}  // namespace detail

/// \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] Summits<T> summits_of(const HeightMap<T>& map) {
    map.validate();
    const auto& z = map.heights;
    const detail::MapHeights<T> heights(map);
    Summits<T> result;
    result.width = static_cast<T>(z.cols()) * map.dx;
    result.height = static_cast<T>(z.rows()) * map.dy;
    result.rms_height = static_cast<T>(std::sqrt(heights.variance) * heights.unit);
    std::size_t inner = 0;
    result.dx = map.dx;
    result.dy = map.dy;
    detail::visit_inner_points(map, {0, z.rows(), 0, z.cols()}, [&](Eigen::Index j, Eigen::Index i, bool summit) {
        ++inner;
        if (!summit) return;
        Summit<T> top = detail::top_of(detail::shape_by_differences<T>(z, j, i), map.dx, map.dy, T(1));
        if (!(top.min_curvature > detail::min_curvature_ratio<T> * top.max_curvature)) {
            ++result.ridges;
            return;
        }
        top.height += static_cast<T>((heights.in_units(z(j, i)) - heights.mean) * heights.unit);
        top.x += T(i) * map.dx;
        top.y += T(j) * map.dy;
        result.summits.push_back(top);
    });
    result.area = static_cast<T>(inner) * map.dx * map.dy;
    std::sort(result.summits.begin(), result.summits.end(),
              [](const Summit<T>& a, const Summit<T>& b) { return a.height > b.height; });
    return result;
}

namespace detail {

/// How often each of \p count tiles is among as many that are drawn with replacement. \p state is that of splitmix64
/// and advances.
[[nodiscard]] inline std::vector<std::size_t> drawn_tiles(std::size_t count, std::uint64_t& state) {
    std::vector<std::size_t> times(count, 0);
    for (std::size_t i = 0; i < count; ++i) ++times[math::splitmix64(state) % count];
    return times;
}

/// Summits of another map of the same surface: of \p tiles by \p tiles of this map each as often as in \p times.
template <Real T>
[[nodiscard]] Summits<T> resampled(const Summits<T>& sample, std::size_t tiles, const std::vector<std::size_t>& times) {
    const auto tile = [&](T x, T side) {
        return (std::min)(tiles - 1, static_cast<std::size_t>(x / side * static_cast<T>(tiles)));
    };
    std::vector<Summit<T>> drawn;
    drawn.reserve(sample.summits.size());
    for (const Summit<T>& s : sample.summits)
        for (std::size_t n = times[tile(s.y, sample.height) * tiles + tile(s.x, sample.width)]; n > 0; --n)
            drawn.push_back(s);
    return {std::move(drawn),  sample.area, sample.width, sample.height,
            sample.rms_height, sample.dx,   sample.dy,    sample.ridges};
}

}  // namespace detail

}}  // namespace fstiff
