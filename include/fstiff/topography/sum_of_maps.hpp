// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sum of the heights of two measured faces, the lower one shifted along x and y: the roughness of both faces as one.
///
///     z(j, i) = z_upper(j, i) + z_lower(m(j + rows), m(i + columns)),   m mirrors an index at the edges of the map
///
/// Both heights point outwards from their own body. Mirroring makes no steps, but ridges and valleys at the edges. A
/// point that is missing on either face is missing in the sum.
///
/// Reference   Greenwood, Tripp, Proc. Inst. Mech. Eng. 185 (1970) 625
/// Units       [m]
/// Valid       maps of one shape whose steps differ by at most 1e-6 of themselves
/// Accuracy    exact sums (tests/topography/shifted_sum_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/topography/height_map.hpp>

#include <Eigen/Core>
#include <cstdint>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Reason why two maps have no sum; empty where they have one.
template <Real T>
[[nodiscard]] std::string no_sum_of(const HeightMap<T>& upper, const HeightMap<T>& lower) {
    const auto grid = [](const HeightMap<T>& map) {
        return std::to_string(map.columns()) + " x " + std::to_string(map.rows()) + " points";
    };
    if (upper.rows() != lower.rows() || upper.columns() != lower.columns())
        return "the maps have " + grid(upper) + " and " + grid(lower);
    if (std::abs(upper.dx - lower.dx) > T(1e-6) * upper.dx || std::abs(upper.dy - lower.dy) > T(1e-6) * upper.dy)
        return "the points of the maps are not equally far apart";
    return "";
}

/// Sum with \p lower shifted by \p rows and \p columns of any sign and size.
/// \throws domain_error for maps for which no_sum_of() gives a reason.
template <Real T>
[[nodiscard]] HeightMap<T> shifted_sum(const HeightMap<T>& upper, const HeightMap<T>& lower, Eigen::Index rows,
                                       Eigen::Index columns) {
    if (const std::string why = no_sum_of(upper, lower); !why.empty())
        throw domain_error("sum of two maps: " + why + "; must be of one grid");
    const auto mirrored = [](Eigen::Index i, Eigen::Index size) {
        const Eigen::Index k = ((i % (2 * size)) + 2 * size) % (2 * size);
        return k < size ? k : 2 * size - 1 - k;
    };
    HeightMap<T> sum = upper;
    for (Eigen::Index j = 0; j < sum.rows(); ++j)
        for (Eigen::Index i = 0; i < sum.columns(); ++i)
            sum.heights(j, i) += lower.heights(mirrored(j + rows, sum.rows()), mirrored(i + columns, sum.columns()));
    return sum;
}

/// Sum at a random shift. \p state is that of splitmix64 and advances: the same state gives the same shifts.
template <Real T>
[[nodiscard]] HeightMap<T> random_sum(const HeightMap<T>& upper, const HeightMap<T>& lower, std::uint64_t& state) {
    const auto below = [&](Eigen::Index size) {
        return static_cast<Eigen::Index>(math::splitmix64(state) % static_cast<std::uint64_t>(2 * size));
    };
    const Eigen::Index rows = below(upper.rows()), columns = below(upper.columns());
    return shifted_sum(upper, lower, rows, columns);
}

}}}  // namespace fstiff::detail
