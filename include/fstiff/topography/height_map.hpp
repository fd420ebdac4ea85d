// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured map: heights on a rectangular grid, some of which may be missing.
///
/// Units       heights, dx and dy [m]
/// Valid       dx, dy > 0; every height finite, or NaN where the point is missing

#include <fstiff/core/error.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/statistics.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>

namespace fstiff::inline v0_1 {

namespace detail {

/// Range of the heights that exist; for none of them low is the largest number and high the lowest.
template <Real T>
struct HeightRange {
    T low = (std::numeric_limits<T>::max)(), high = std::numeric_limits<T>::lowest();
    Eigen::Index present{};
};

/// Range of \p count heights \p z in one pass, in lanes that compilers vectorise.
template <Real T>
HeightRange<T> height_range(const T* z, Eigen::Index count) {
    constexpr std::size_t lanes = 16;
    using Count = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    constexpr std::size_t run = std::size_t(1) << 24;  // after which the counts are emptied
    std::array<T, lanes> low, high;
    HeightRange<T> range;
    low.fill(range.low);
    high.fill(range.high);
    const auto size = static_cast<std::size_t>(count), bulk = size - size % lanes;
    for (std::size_t begin = 0; begin < bulk; begin += run) {
        std::array<Count, lanes> present{};
        for (std::size_t k = begin; k < (std::min)(bulk, begin + run); k += lanes)
            for (std::size_t l = 0; l < lanes; ++l) {
                const T height = z[k + l];
                low[l] = height < low[l] ? height : low[l];
                high[l] = height > high[l] ? height : high[l];
                present[l] += height == height ? 1 : 0;  // NaN does not
            }
        for (const Count lane : present) range.present += lane;
    }
    for (std::size_t k = bulk; k < size; ++k) {
        if (z[k] < low[0]) low[0] = z[k];
        if (z[k] > high[0]) high[0] = z[k];
        range.present += std::isnan(z[k]) ? 0 : 1;
    }
    range.low = *std::min_element(low.begin(), low.end());
    range.high = *std::max_element(high.begin(), high.end());
    return range;
}

/// HeightMap::validate() for heights \p z in row order at any address.
template <Real T>
void validate_map(const T* z, Eigen::Index rows, Eigen::Index columns, T dx, T dy, Eigen::Index least) {
    require_positive("dx", dx);
    require_positive("dy", dy);
    if (rows < least || columns < least)
        throw domain_error("map of " + std::to_string(columns) + " x " + std::to_string(rows) +
                           " points: must have at least " + std::to_string(least) + " a side");
    const HeightRange<T> range = height_range(z, rows * columns);
    if (range.present > 0 &&
        (range.low < std::numeric_limits<T>::lowest() || (std::numeric_limits<T>::max)() < range.high))
        throw domain_error("map with an infinite height: must be finite, or NaN where missing");
    if (range.present < least)
        throw domain_error("map of which " + std::to_string(range.present) + " points exist: must be at least " +
                           std::to_string(least));
    require(range.high > range.low, "map of constant height", range.low, "of varying height");
}

}  // namespace detail

/// A map in SI units. heights(j, i) is the height at x = i dx, y = j dy: a row of the array is a profile along x.
template <Real T = double>
struct HeightMap {
    using Array = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    Array heights;  ///< [m], rows along y, columns along x; NaN marks a missing point
    T dx{};         ///< between neighbouring columns [m]
    T dy{};         ///< between neighbouring rows [m]

    [[nodiscard]] Eigen::Index columns() const { return heights.cols(); }
    [[nodiscard]] Eigen::Index rows() const { return heights.rows(); }
    /// Number of points, including missing ones.
    [[nodiscard]] Eigen::Index size() const { return heights.size(); }
    /// Number of points that are not missing.
    [[nodiscard]] Eigen::Index present() const { return heights.size() - heights.isNaN().count(); }
    /// Nominal area: one cell dx dy for every point [m^2].
    [[nodiscard]] T area() const { return static_cast<T>(heights.size()) * dx * dy; }

    /// \throws domain_error unless both spacings are positive, no height is infinite, the map has at least \p least
    /// points a side, as many exist, and they are not all of one height.
    void validate(Eigen::Index least = 3) const {
        detail::validate_map(heights.data(), rows(), columns(), dx, dy, least);
    }
    /// \throws domain_error "map with N missing points: must be filled \p before".
    void require_whole(const char* before) const {
        if (const Eigen::Index missing = size() - present(); missing > 0)
            throw domain_error("map with " + std::to_string(missing) + " missing points: must be filled " + before);
    }
};

namespace detail {

/// Mean of the heights that exist [m]. \throws domain_error when there is none.
template <Real T>
[[nodiscard]] T mean_height(const HeightMap<T>& map) {
    math::CompensatedSum<double> sum;
    for (Eigen::Index k = 0; k < map.size(); ++k)
        if (!std::isnan(map.heights.data()[k])) sum.add(map.heights.data()[k]);
    if (map.present() == 0) throw domain_error("map of which 0 points exist: must be at least 1");
    return static_cast<T>(sum.value() / static_cast<double>(map.present()));
}

template <Real T>
HeightRange<T> height_range(const HeightMap<T>& map) {
    return height_range(map.heights.data(), map.size());
}

/// Power of two near the range of the heights: squares of scaled heights stay in range, and scaling is exact.
template <Real T>
T height_scale(const HeightMap<T>& map) {
    const HeightRange<T> range = height_range(map);
    return range.low < range.high ? math::power_of_two_below(range.high / 2 - range.low / 2) : T(1);
}

/// Mean of \p term(height) over the points that exist, with one sum per row so that rounding does not accumulate.
template <Real T, class Term>
double mean_over_points(const HeightMap<T>& map, const Term& term) {
    double sum = 0;
    const auto of_point = [&, z = map.heights.data()](std::size_t k) { return std::isnan(z[k]) ? 0.0 : term(z[k]); };
    math::sum_runs<double>(0, static_cast<std::size_t>(map.size()), static_cast<std::size_t>(map.columns()), of_point,
                           [&](double row) { sum += row; });
    return sum / static_cast<double>(map.present());
}

/// Heights of a map relative to one of its points, in a unit: removes an offset before anything is squared.
template <Real T>
struct MapHeights {
    T datum{}, unit{};
    double inverse{};   // of the unit, a power of two
    double mean{};      // [unit] above the datum
    double variance{};  // [unit^2]

    explicit MapHeights(const HeightMap<T>& map) : unit(height_scale(map)), inverse(1 / static_cast<double>(unit)) {
        for (Eigen::Index k = map.size(); k-- > 0;)
            if (!std::isnan(map.heights.data()[k])) {
                datum = map.heights.data()[k];
                break;
            }
        mean = mean_over_points(map, [&](T z) { return in_units(z); });
        variance = mean_over_points(map, [&](T z) { return (in_units(z) - mean) * (in_units(z) - mean); });
    }
    double in_units(T z) const { return (static_cast<double>(z) - datum) * inverse; }
};

}  // namespace detail

/// Sq: root of the mean square of the heights about their mean [m]. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] T rms_height(const HeightMap<T>& map) {
    map.validate();
    const detail::MapHeights<T> heights(map);
    return static_cast<T>(std::sqrt(heights.variance) * heights.unit);
}

}  // namespace fstiff::inline v0_1

// A map on a coarser grid: each new cell has the mean height of the area that it covers.
//
// Units       as the map
// Valid       maps without missing points; at most as many cells as there are points
// Accuracy    the mean height is kept to 1e-14 of the largest (tests/topography/coarsen_test.cpp)

namespace fstiff::inline v0_1::detail {

/// Each row of \p fine on \p to longer cells, transposed: cell j of row i is in row j, column i.
template <Real T>
typename HeightMap<T>::Array coarsened_rows(const typename HeightMap<T>::Array& fine, Eigen::Index to) {
    const Eigen::Index from = fine.cols();
    const T length = T(from) / T(to);
    typename HeightMap<T>::Array coarse = HeightMap<T>::Array::Zero(to, fine.rows());
    for (Eigen::Index j = 0; j < to; ++j) {
        const T begin = T(j) * length, end = T(j + 1) * length;
        for (auto i = static_cast<Eigen::Index>(begin); i < from && T(i) < end; ++i) {
            const T share = (std::max)(T(0), (std::min)(end, T(i + 1)) - (std::max)(begin, T(i))) / length;
            for (Eigen::Index row = 0; row < fine.rows(); ++row) coarse(j, row) += share * fine(row, i);
        }
    }
    return coarse;
}

/// \p map on \p columns by \p rows cells over the same area.
/// \throws domain_error for missing points, for less than 1 cell and for more cells than points.
template <Real T>
[[nodiscard]] HeightMap<T> coarsened(const HeightMap<T>& map, Eigen::Index columns, Eigen::Index rows) {
    require(columns >= 1 && columns <= map.columns(), "columns", columns, "from 1 to those of the map");
    require(rows >= 1 && rows <= map.rows(), "rows", rows, "from 1 to those of the map");
    map.require_whole("before it is made coarser");
    HeightMap<T> coarse;
    coarse.dx = map.dx * T(map.columns()) / T(columns);
    coarse.dy = map.dy * T(map.rows()) / T(rows);
    coarse.heights = coarsened_rows<T>(coarsened_rows<T>(map.heights, columns), rows);
    return coarse;
}

/// \p map with \p points along its longer side (unchanged where it has no more), with the same aspect of the cells.
template <Real T>
[[nodiscard]] HeightMap<T> coarsened(const HeightMap<T>& map, Eigen::Index points) {
    require(points >= 1, "points", points, "at least 1");
    const Eigen::Index longer = (std::max)(map.columns(), map.rows());
    if (longer <= points) return map;
    const auto side = [&](Eigen::Index n) {
        return (std::max)(Eigen::Index(1),
                          static_cast<Eigen::Index>(std::lround(double(n) * double(points) / double(longer))));
    };
    return coarsened(map, side(map.columns()), side(map.rows()));
}

}  // namespace fstiff::inline v0_1::detail

// Sum of the heights of two measured faces, the lower one shifted along x and y: the roughness of both faces as one.
//
//     z(j, i) = z_upper(j, i) + z_lower(m(j + rows), m(i + columns)),   m mirrors an index at the edges of the map
//
// Both heights point outwards from their own body. Mirroring makes no steps, but ridges and valleys at the edges. A
// point that is missing on either face is missing in the sum.
//
// Reference   Greenwood, Tripp, Proc. Inst. Mech. Eng. 185 (1970) 625
// Units       [m]
// Valid       maps of one shape whose steps differ by at most 1e-6 of themselves
// Accuracy    exact sums (tests/topography/shifted_sum_test.cpp)

namespace fstiff::inline v0_1::detail {

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

}  // namespace fstiff::inline v0_1::detail
