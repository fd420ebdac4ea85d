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

namespace fstiff { inline namespace v0_1 {

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

}}  // namespace fstiff
