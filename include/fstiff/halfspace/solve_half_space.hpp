// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of a map by boundary elements on a grid of the size asked for and on one half as fine; the difference of the
/// two is the error of the grid.
///
///     const auto points = fstiff::solve_half_space(map, 100e9, pressures,
///                                                  {.points = 256, .edges = fstiff::Edges::mirrored});
///     points[0].state.stiffness, points[0].stiffness_error       K [Pa/m] and its change from the coarser grid
///
/// Reference   halfspace/boundary_elements.hpp
/// Units       SI
/// Valid       maps without missing points whose form is removed, of 16 points a side at least
/// Accuracy    stiffness_error is the change from a grid half as fine: of 30 solutions of three maps at 256 points a
///             side the error of 27 against 512 is less (tests/halfspace/truth_test.cpp)

#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Options of the truth of a map.
template <Real T = double>
struct HalfSpaceOptions {
    Eigen::Index points = 256;  ///< along the longer side; a map that has no more is taken as it is
    Edges edges = Edges::mirrored;
    T hardness{};             ///< [Pa]; 0: elastic
    bool grid_error = true;   ///< solve on the coarser grid too
    bool loading = true;      ///< as of BoundaryElementOptions
    ProgressHook progress{};  ///< called once a pressure
};

/// Result of boundary elements at one pressure.
template <Real T = double>
struct HalfSpacePoint {
    BoundaryElementState<T> state{};
    T stiffness_error{};  ///< change from the grid half as fine [Pa/m]; infinite where all points of one grid alone
                          ///< touch; 0 where all points of both touch, and where it was not asked for
    T gap_error{};        ///< the same of the mean gap [m]
};

namespace detail {

/// The grid on which \p map is solved.
template <Real T>
[[nodiscard]] HeightMap<T> map_for_truth(const HeightMap<T>& map, Eigen::Index points) {
    require(points >= 16, "points", points, "at least 16 along the longer side");
    HeightMap<T> fine = coarsened(map, points);
    const Eigen::Index shorter = (std::min)(fine.rows(), fine.columns());
    require(shorter >= 16, "points along the shorter side", shorter, "at least 16, for boundary elements on two grids");
    return fine;
}

}  // namespace detail

/// The contact of \p map against a smooth flat under \p pressures [Pa], in their order.
/// \throws domain_error as BoundaryElements, and for fewer than 16 points.
template <Real T, class Pressures>
[[nodiscard]] std::vector<HalfSpacePoint<T>> solve_half_space(const HeightMap<T>& map,
                                                              std::type_identity_t<T> effective_modulus,
                                                              const Pressures& pressures,
                                                              const HalfSpaceOptions<T>& options = {}) {
    const BoundaryElementOptions<T> settings{
        .edges = options.edges, .hardness = options.hardness, .loading = options.loading};
    BoundaryElements<T> solver(detail::map_for_truth(map, options.points), effective_modulus, settings);
    std::vector<HalfSpacePoint<T>> points;
    for (const T pressure : pressures) {
        if (options.progress) options.progress("pressures", points.size(), std::size(pressures));
        HalfSpacePoint<T> point{solver.at_pressure(pressure)};
        if (options.grid_error) {
            const auto other = solver.on_coarser_grid();
            if (other.stiffness != point.state.stiffness)  // both are infinite where all points touch
                point.stiffness_error = std::abs(other.stiffness - point.state.stiffness);
            point.gap_error = std::abs(other.mean_gap - point.state.mean_gap);
        }
        points.push_back(point);
    }
    return points;
}

}}  // namespace fstiff
