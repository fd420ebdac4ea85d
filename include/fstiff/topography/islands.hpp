// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Islands of a map: the connected parts above a cutting level, at all levels in one sweep.
///
///     density = islands / nominal area
///     R       = A_m / (2 pi h_m)      paraboloid of the mean island: area A_m at the level, height h_m above it
///
/// Union-find keeps the islands while the points are raised from the highest level to the lowest. Points strictly above
/// a level count; a missing point is part of no island and of no area.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), Figs. 3 and 4
/// Units       levels, heights, R [m], areas [m^2], densities [1/m^2], bearing area 0 to 1
/// Valid       maps of at least 3 x 3 and at most 2^31 - 1 points, heights that vary
/// Accuracy    counts and areas exact, mean heights 1e-14 of the roughness (tests/topography/islands_test.cpp).
///             Greatest density of narrow Gaussian bands 1.02 to 1.08 of (2 pi)^(-3/2) e^(-1/2) m2/m0

#include <fstiff/math/statistics.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/island_forest.hpp>

#include <cstring>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Bin number of a height, which does not decrease as the height rises.
template <Real T>
class HeightBins {
public:
    static constexpr std::size_t count = std::size_t(1) << 16;

    explicit HeightBins(const HeightRange<T>& range) : low_(range.low) {
        const T scale = static_cast<T>(count) / (range.high - range.low);
        if (std::isfinite(scale)) scale_ = scale;  // else one bin holds all
    }
    std::size_t operator()(T height) const {
        return (std::min)(count - 1, static_cast<std::size_t>((height - low_) * scale_));
    }

private:
    T low_, scale_{};
};

/// Heights of \p map, of the range \p range, that have the rising \p ranks; 0 is the highest.
template <Real T>
std::vector<T> heights_of_ranks(const HeightMap<T>& map, const HeightRange<T>& range,
                                const std::vector<std::size_t>& ranks) {
    struct Slot {
        std::size_t before;  // points of higher bins
        T first{};
        std::size_t like_first = 0;
        std::vector<T> others{};
    };
    const HeightBins<T> bin_of(range);
    const T* const z = map.heights.data();
    const auto size = static_cast<std::size_t>(map.size());
    std::vector<std::size_t> points(HeightBins<T>::count);
    for (std::size_t k = 0; k < size; ++k)
        if (!std::isnan(z[k])) ++points[bin_of(z[k])];
    std::vector<Slot> slots;
    std::vector<std::int32_t> slot_of(points.size(), -1);
    std::size_t before = 0;
    auto rank = ranks.begin();
    for (std::size_t bin = points.size(); bin-- > 0; before += points[bin])
        for (; rank != ranks.end() && *rank < before + points[bin]; ++rank)
            if (slot_of[bin] < 0) {
                slot_of[bin] = static_cast<std::int32_t>(slots.size());
                slots.push_back({.before = before});
            }
    for (std::size_t k = 0; k < size; ++k) {
        if (std::isnan(z[k])) continue;
        const std::int32_t index = slot_of[bin_of(z[k])];
        if (index < 0) continue;
        Slot& slot = slots[static_cast<std::size_t>(index)];
        if (slot.like_first == 0) slot.first = z[k];
        if (z[k] == slot.first)
            ++slot.like_first;
        else
            slot.others.push_back(z[k]);
    }
    std::vector<T> values;
    std::size_t next = 0;
    for (Slot& slot : slots) {
        std::sort(slot.others.begin(), slot.others.end(), std::greater<>());
        const auto higher = static_cast<std::size_t>(
            std::lower_bound(slot.others.begin(), slot.others.end(), slot.first, std::greater<>()) -
            slot.others.begin());
        const std::size_t end = slot.before + slot.like_first + slot.others.size();
        for (; next < ranks.size() && ranks[next] < end; ++next) {
            const std::size_t place = ranks[next] - slot.before;
            values.push_back(place < higher                     ? slot.others[place]
                             : place < higher + slot.like_first ? slot.first
                                                                : slot.others[place - slot.like_first]);
        }
    }
    return values;
}

struct LevelBands {
    static constexpr std::size_t most_levels = 254;
    static constexpr std::uint8_t absent = 255;  ///< of a missing point
};

/// Number of the falling \p levels, at most most_levels, that are not below each point of \p map.
template <Real T>
std::vector<std::uint8_t> level_bands(const HeightMap<T>& map, const HeightRange<T>& range,
                                      const std::vector<T>& levels) {
    const HeightBins<T> bin_of(range);
    // levels above all heights of a bin and of the higher ones
    std::vector<std::uint8_t> least(HeightBins<T>::count);
    std::size_t above = 0;
    for (std::size_t bin = least.size(); bin-- > 0; least[bin] = static_cast<std::uint8_t>(above))
        while (above < levels.size() &&
               (levels[above] > range.high || (levels[above] >= range.low && bin_of(levels[above]) > bin)))
            ++above;
    std::vector<std::uint8_t> bands(static_cast<std::size_t>(map.size()), LevelBands::absent);
    const T* const z = map.heights.data();
    for (std::size_t k = 0; k < bands.size(); ++k) {
        if (std::isnan(z[k])) continue;
        std::size_t band = least[bin_of(z[k])];
        while (band < levels.size() && levels[band] >= z[k]) ++band;
        bands[k] = static_cast<std::uint8_t>(band);
    }
    return bands;
}

}  // namespace detail

/// Islands against the cutting level, from the highest level to the lowest; all vectors have one length. Means and
/// radius are 0 where no island counts.
template <Real T = double>
struct IslandCurve {
    std::vector<T> level;         ///< [m]
    std::vector<T> bearing_area;  ///< share of the points above the level, in counted islands or not
    std::vector<std::size_t> islands;
    std::vector<T> density;      ///< [1/m^2]
    std::vector<T> mean_area;    ///< A_m [m^2]
    std::vector<T> mean_height;  ///< h_m [m]
    std::vector<T> radius;       ///< R [m]
    T nominal_area{};            ///< [m^2]

    [[nodiscard]] std::size_t size() const { return level.size(); }
    /// Index of the greatest density; of equal ones the highest level.
    [[nodiscard]] std::size_t representative() const {
        return static_cast<std::size_t>(std::max_element(density.begin(), density.end()) - density.begin());
    }
};

namespace detail {

template <Real T>
struct IslandPoint {
    T height;
    std::int32_t index;
};

/// Points of \p map that exist, from the highest.
template <Real T>
std::vector<IslandPoint<T>> sorted_points(const HeightMap<T>& map) {
    std::vector<IslandPoint<T>> points;
    points.reserve(static_cast<std::size_t>(map.present()));
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(map.size()); ++p)
        if (const T z = map.heights.data()[p]; !std::isnan(z)) points.push_back({z, p});
    math::sort_falling<T>(points, [](const IslandPoint<T>& point) { return point.height; });
    return points;
}

/// Places (k + 1/2) size/parts of a list of \p size.
inline std::vector<std::size_t> middles_of_parts(std::size_t size, std::size_t parts) {
    const long double step = static_cast<long double>(size) / static_cast<long double>(parts);
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < parts; ++k)
        places.push_back((std::min)(static_cast<std::size_t>((static_cast<long double>(k) + 0.5L) * step), size - 1));
    return places;
}

/// Range of the heights of \p map. \throws domain_error for a map or an option out of range.
template <Real T>
HeightRange<T> checked_range(const HeightMap<T>& map, const IslandOptions<T>& options) {
    map.validate();
    if (map.size() > (std::numeric_limits<std::int32_t>::max)())
        throw domain_error("map of " + std::to_string(map.size()) + " points: must be at most 2^31 - 1");
    require(options.min_points >= 1, "least points of an island", options.min_points, "at least 1");
    for (const T level : options.levels)
        require(std::abs(level) <= (std::numeric_limits<T>::max)(), "cutting level", level, "finite");
    const HeightRange<T> range = detail::height_range(map);
    // sums of as many heights, and of their doubles, stay in range
    const T largest = (std::max)(std::abs(range.high), std::abs(range.low));
    require(largest <= std::sqrt((std::numeric_limits<T>::max)()), "largest height", largest,
            "at most the root of the largest number");
    return range;
}

/// Adds the islands \p total at \p level to \p curve.
template <Real T, Real S>
void add_level(IslandCurve<T>& curve, T level, T bearing_area, const IslandTotal<S>& total, S reference, T cell) {
    T area = 0, height = 0, radius = 0;
    if (total.islands > 0) {
        const auto islands = static_cast<S>(total.islands);
        area = static_cast<T>(static_cast<S>(total.points) / islands) * cell;
        height = static_cast<T>((std::max)(S(0), total.height_above(reference) / islands));
        radius = height > T(0) ? area / (2 * std::numbers::pi_v<T> * height) : T(0);
        require(radius <= (std::numeric_limits<T>::max)(), "mean island height", height,
                "larger: the radius leaves the range of numbers");
    }
    curve.level.push_back(level);
    curve.bearing_area.push_back(bearing_area);
    curve.islands.push_back(static_cast<std::size_t>(total.islands));
    curve.density.push_back(static_cast<T>(total.islands) / curve.nominal_area);
    curve.mean_area.push_back(area);
    curve.mean_height.push_back(height);
    curve.radius.push_back(radius);
}

/// Computes the curve; passes the totals of every tile at every level to \p record(level, forest).
template <Real T, class Record>
IslandCurve<T> sweep_islands(const HeightMap<T>& map, const IslandOptions<T>& options, std::size_t tiles,
                             const Record& record) {
    const HeightRange<T> range = checked_range(map, options);
    const auto present = static_cast<std::size_t>(range.present);
    std::vector<T> levels = options.levels;
    std::vector<IslandPoint<T>> points;  // from the highest, where they are sorted
    if (levels.empty() && (options.quantiles == 0 || options.quantiles >= present)) {
        points = sorted_points(map);
        for (const IslandPoint<T>& point : points) levels.push_back(point.height);
    } else if (levels.empty()) {
        levels = heights_of_ranks(map, range, middles_of_parts(present, options.quantiles));
    }
    std::sort(levels.begin(), levels.end(), std::greater<>());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());

    // the rounding of a mean height depends on the order of its sum: the order is that of the heights
    const bool in_bands = levels.size() <= LevelBands::most_levels && options.height == IslandHeight::peak;
    if (!in_bands && points.empty()) points = sorted_points(map);
    if (in_bands) points = {};
    const std::vector<std::uint8_t> bands = in_bands ? level_bands(map, range, levels) : std::vector<std::uint8_t>();
    IslandForest<T> forest(map, options, tiles, in_bands ? T(0) : points[present / 2].height,
                           in_bands ? bands.data() : nullptr);
    std::size_t above = 0;
    const auto raise_to = [&](std::size_t index) {  // the points above that level, and not above the one before
        if (in_bands) {
            const std::uint8_t *const begin = bands.data(), *const end = begin + bands.size();
            const auto next = [&](const std::uint8_t* from) {
                return static_cast<const std::uint8_t*>(
                    std::memchr(from, static_cast<int>(index), static_cast<std::size_t>(end - from)));
            };
            for (const std::uint8_t* p = next(begin); p != nullptr; p = next(p + 1), ++above)
                forest.raise(static_cast<std::int32_t>(p - begin));
        } else {
            for (; above < points.size() && points[above].height > levels[index]; ++above)
                forest.raise(points[above].index);
        }
    };
    const T cell = map.dx * map.dy;
    IslandCurve<T> curve;
    curve.nominal_area = static_cast<T>(present) * cell;
    require(cell >= (std::numeric_limits<T>::min)() && curve.nominal_area <= (std::numeric_limits<T>::max)() &&
                1 / cell <= (std::numeric_limits<T>::max)(),
            "dx dy", cell, "an area of normal size");
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const T level = levels[k];
        if (options.progress) options.progress("islands", above, present);
        raise_to(k);
        add_level(curve, level, static_cast<T>(above) / static_cast<T>(present), forest.total(),
                  static_cast<double>(forest.reference(level)), cell);
        record(level, forest);
    }
    return curve;
}

}  // namespace detail

/// \throws domain_error for a map or an option out of range.
template <Real T>
[[nodiscard]] IslandCurve<T> island_curve(const HeightMap<T>& map, const IslandOptions<T>& options = {}) {
    return detail::sweep_islands(map, options, 1, [](T, const detail::IslandForest<T>&) {});
}

}}  // namespace fstiff
