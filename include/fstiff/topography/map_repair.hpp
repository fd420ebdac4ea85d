// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Repair of a map: spikes become missing points; the harmonic surface fills the holes of missing points.
///
///     d = z - median of the 8 neighbours;  q_n: z beyond both points that are n steps away in one of 8 directions
///     a spike: |d - median d| > k 1.4826 MAD(d), q_2 or q_3 > |d|/2 in all 8, and of the medians over
///     these q_3 > |d|/2, q_2 > k/6 (q_3 - q_2)
///     fill: (z_E + z_W - 2 z)/dx^2 + (z_N + z_S - 2 z)/dy^2 = 0 at every missing point, zero slope across the edges
///
/// Reference   Laplace's equation in five points; Hampel, J. Am. Stat. Assoc. 69 (1974) 383 (median and MAD)
/// Units       heights [m]; k in standard deviations
/// Valid       k > 0; maps of 3 points a side; at least one point exists
/// Accuracy    fill 1e-10 of the range of harmonic heights; k = 5 removes less than 1e-4 of Gaussian roughness
///             (tests/topography/repair_test.cpp)

#include <fstiff/topography/form.hpp>

#include <Eigen/SparseCholesky>
#include <array>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Whether no point of \p map two or three steps away supports the point (\p j, \p i), which is \p difference above
/// its neighbours: a rim, a wall or a ridge goes on in some direction, and a bump or a cusp has a foot.
template <Real T>
[[nodiscard]] bool is_isolated(const HeightMap<T>& map, Eigen::Index j, Eigen::Index i, T difference, T limit) {
    struct Step {
        Eigen::Index down, right;
    };
    constexpr std::array<std::array<Step, 2>, 8> directions{{{{{0, 2}, {0, 3}}},
                                                             {{{1, 2}, {2, 3}}},
                                                             {{{2, 2}, {3, 3}}},
                                                             {{{2, 1}, {3, 2}}},
                                                             {{{2, 0}, {3, 0}}},
                                                             {{{2, -1}, {3, -2}}},
                                                             {{{2, -2}, {3, -3}}},
                                                             {{{1, -2}, {2, -3}}}}};
    const auto height = [&](Eigen::Index y, Eigen::Index x) {
        const bool inside = y >= 0 && x >= 0 && y < map.rows() && x < map.columns();
        return inside ? map.heights(y, x) : std::numeric_limits<T>::quiet_NaN();
    };
    const auto beyond = [&](Step s) {
        return math::beyond_both(map.heights(j, i), height(j + s.down, i + s.right), height(j - s.down, i - s.right),
                                 std::copysign(T(1), difference));
    };
    std::vector<T> inner, outer;
    for (const auto& [two, three] : directions) {
        const T a = beyond(two), b = beyond(three);
        if (std::fmax(a, b) < std::abs(difference) / 2) return false;  // fmax() leaves a NaN out
        if (!std::isnan(a)) inner.push_back(a);
        if (!std::isnan(b)) outer.push_back(b);
    }
    return inner.empty() || outer.empty() ||
           math::has_no_foot(math::median(inner), math::median(outer), difference, limit);
}

/// Number of spikes of \p map beyond \p limit; with \p remove they become missing. \throws domain_error as above.
template <Real T>
math::Repair find_spikes(HeightMap<T>& map, std::type_identity_t<T> limit, bool remove = true) {
    require_positive("spikes", limit);
    const Eigen::Index rows = map.rows(), columns = map.columns();
    require(rows >= 3 && columns >= 3, "points a side of a map with spikes", (std::min)(rows, columns), "at least 3");
    std::vector<T> differences(static_cast<std::size_t>(map.size()), std::numeric_limits<T>::quiet_NaN()), neighbours;
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            if (std::isnan(map.heights(j, i))) continue;
            if (j > 0 && i > 0 && j + 1 < rows && i + 1 < columns) {
                const auto z = [&](Eigen::Index down, Eigen::Index right) { return map.heights(j + down, i + right); };
                const std::array<T, 8> ring{z(-1, -1), z(-1, 0), z(-1, 1), z(0, -1),
                                            z(0, 1),   z(1, -1), z(1, 0),  z(1, 1)};
                if (std::none_of(ring.begin(), ring.end(), [](T height) { return std::isnan(height); })) {
                    differences[static_cast<std::size_t>(j * columns + i)] = z(0, 0) - math::median_of_eight(ring);
                    continue;
                }
            }
            neighbours.clear();
            for (Eigen::Index l = std::max<Eigen::Index>(0, j - 1); l < (std::min)(rows, j + 2); ++l)
                for (Eigen::Index k = std::max<Eigen::Index>(0, i - 1); k < (std::min)(columns, i + 2); ++k)
                    if ((l != j || k != i) && !std::isnan(map.heights(l, k))) neighbours.push_back(map.heights(l, k));
            if (neighbours.size() < 3) continue;
            differences[static_cast<std::size_t>(j * columns + i)] = map.heights(j, i) - math::median(neighbours);
        }
    return math::spikes_among(map.heights.data(), differences, limit, remove, [&](std::size_t point, T difference) {
        const auto place = static_cast<Eigen::Index>(point);
        return is_isolated(map, place / columns, place % columns, difference, limit);
    });
}

/// Calls \p visit(place, 1/step^2 over 1/dx^2) for the neighbours of \p point along its sides.
template <Real T, class Visit>
void visit_sides(const HeightMap<T>& map, Eigen::Index point, const Visit& visit) {
    const double across = static_cast<double>(map.dx) / map.dy * (static_cast<double>(map.dx) / map.dy);
    const Eigen::Index columns = map.columns(), j = point / columns, i = point % columns;
    if (i > 0) visit(point - 1, 1.0);
    if (i + 1 < columns) visit(point + 1, 1.0);
    if (j > 0) visit(point - columns, across);
    if (j + 1 < map.rows()) visit(point + columns, across);
}

/// Missing points of a map, hole by hole.
template <Real T>
struct Holes {
    std::vector<int> number;           ///< of each point in `points`; -1: it exists
    std::vector<Eigen::Index> points;  ///< missing
    std::size_t longest = 0;           ///< points of the largest hole

    explicit Holes(const HeightMap<T>& map) : number(static_cast<std::size_t>(map.size()), -1) {
        std::vector<Eigen::Index> stack;
        const auto find = [&](Eigen::Index point, double) {
            if (!std::isnan(map.heights.data()[point]) || number[static_cast<std::size_t>(point)] >= 0) return;
            number[static_cast<std::size_t>(point)] = 0;
            stack.push_back(point);
        };
        for (Eigen::Index start = 0; start < map.size(); ++start) {
            const std::size_t before = points.size();
            for (find(start, 0); !stack.empty();) {
                const Eigen::Index point = stack.back();
                stack.pop_back();
                number[static_cast<std::size_t>(point)] = static_cast<int>(points.size());
                points.push_back(point);
                visit_sides(map, point, find);
            }
            longest = (std::max)(longest, points.size() - before);
        }
    }
};

/// Fills the missing points of \p map. \throws domain_error where every point is missing.
template <Real T>
math::Repair fill_missing(HeightMap<T>& map) {
    using Index = Eigen::Index;
    require(map.present() > 0, "points that exist", 0, "at least 1 to fill the others");
    const Holes<T> holes(map);
    const math::Repair repair{.missing = holes.points.size(), .longest = holes.longest};
    const auto size = static_cast<Index>(holes.points.size());
    if (size < 1) return repair;
    const MapHeights<T> scaled(map);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::Matrix<double, Eigen::Dynamic, 1> right = Eigen::Matrix<double, Eigen::Dynamic, 1>::Zero(size);
    for (Index n = 0; n < size; ++n) {
        double own = 0;
        visit_sides(map, holes.points[static_cast<std::size_t>(n)], [&](Index other, double weight) {
            own += weight;
            if (const int m = holes.number[static_cast<std::size_t>(other)]; m >= 0)
                entries.emplace_back(static_cast<int>(n), m, -weight);
            else
                right[n] += weight * (scaled.in_units(map.heights.data()[other]) - scaled.mean);
        });
        entries.emplace_back(static_cast<int>(n), static_cast<int>(n), own);
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::Matrix<double, Eigen::Dynamic, 1> heights = solver.solve(right);
    for (Index n = 0; n < size; ++n)
        map.heights.data()[holes.points[static_cast<std::size_t>(n)]] =
            static_cast<T>((heights[n] + scaled.mean) * scaled.unit + scaled.datum);
    return repair;
}

}}}  // namespace fstiff::detail
