// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The heights of given ranks of a map, and between which cutting levels each of its points lies, without sorting it.
///
/// Heights fall into bins of one width; a rank is sought in its bin alone. The points between two levels come in the
/// order of the map, which is that of the memory: a sweep over a few hundred levels needs no other order.
///
/// Units       heights and levels [m]
/// Valid       maps as HeightMap::validate, whose range of heights does not leave the range of numbers
/// Accuracy    exact (tests/topography/island_levels_test.cpp)
/// Cost        two passes over the map, and a byte a point; heights that crowd in a few of 65536 bins are copied and
///             sorted there, unless they are equal

#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace fstiff::detail {

/// The number of the bin of a height, which never falls as the height rises.
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

/// The heights of \p map, of the range \p range, that have the rising \p ranks; 0 is that of the highest.
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
        const std::int32_t at = slot_of[bin_of(z[k])];
        if (at < 0) continue;
        Slot& slot = slots[static_cast<std::size_t>(at)];
        if (slot.like_first == 0) slot.first = z[k];
        if (z[k] == slot.first)
            ++slot.like_first;
        else
            slot.others.push_back(z[k]);
    }
    std::vector<T> found;
    std::size_t at = 0;
    for (Slot& slot : slots) {
        std::sort(slot.others.begin(), slot.others.end(), std::greater<>());
        const auto higher = static_cast<std::size_t>(
            std::lower_bound(slot.others.begin(), slot.others.end(), slot.first, std::greater<>()) -
            slot.others.begin());
        const std::size_t end = slot.before + slot.like_first + slot.others.size();
        for (; at < ranks.size() && ranks[at] < end; ++at) {
            const std::size_t place = ranks[at] - slot.before;
            found.push_back(place < higher                     ? slot.others[place]
                            : place < higher + slot.like_first ? slot.first
                                                               : slot.others[place - slot.like_first]);
        }
    }
    return found;
}

struct LevelBands {
    static constexpr std::size_t most_levels = 254;
    static constexpr std::uint8_t absent = 255;  ///< of a missing point
};

/// Of every point of \p map, how many of the falling \p levels, most_levels at most, are not below it: the first level
/// that it stands above has that number.
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

}  // namespace fstiff::detail
