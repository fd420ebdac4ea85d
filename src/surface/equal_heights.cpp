// SPDX-License-Identifier: BSD-3-Clause
#include "surface/equal_heights.hpp"

#include "document/shown_unit.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::surface {

namespace {

/// Runs of equal heights; missing points are passed over.
struct Runs {
    std::size_t points{}, first{}, last{}, longest{};  ///< longest: of those between the first and the last
    double first_height{}, last_height{};

    template <class Height>
    Runs(std::size_t count, const Height& height) {
        bool any = false;
        for (std::size_t i = 0; i < count; ++i) {
            const double z = height(i);
            if (std::isnan(z)) continue;
            ++points;
            if (any && z == last_height) {
                ++last;
                continue;
            }
            if (first == 0)
                first = last, first_height = last_height;
            else
                longest = std::max(longest, last);
            any = true, last = 1, last_height = z;
        }
    }
    /// Whether a run of \p equal heights at an end is padding.
    [[nodiscard]] bool is_padding(std::size_t equal) const {
        return equal >= 16 && 100 * equal >= points && longest > 0 && equal >= 10 * longest &&
               3 * (points - first - last) >= points;
    }
};

/// \p hints with one for each end of \p runs that is padding.
void add_padding(const Runs& runs, const std::string& order, const SurfaceOptions& options,
                 std::vector<std::string>& hints) {
    for (const bool last : {false, true}) {
        const std::size_t equal = last ? runs.last : runs.first;
        if (!runs.is_padding(equal)) continue;
        hints.push_back("the " + std::string(last ? "last " : "first ") + std::to_string(equal) + " of " +
                        std::to_string(runs.points) + " heights" + order + " are equal, " +
                        document::shown_length(last ? runs.last_height : runs.first_height, 3) +
                        ", like padding, which changes sigma; " + options.name("crop") + " removes them");
    }
}

/// How many of the heights are at one end of their range, and at the level next to it.
struct Level {
    double height{}, next{};
    std::size_t here{}, there{};
};

/// The end of the range of \p count heights, by \p beyond(a, b): the lowest by <, the highest by >.
template <class Height, class Beyond>
Level end_of_range(std::size_t count, const Height& height, const Beyond& beyond) {
    Level level;
    for (std::size_t i = 0; i < count; ++i) {
        const double z = height(i);
        if (std::isnan(z)) continue;
        if (level.here == 0 || beyond(z, level.height))
            level = {z, level.height, 1, level.here};
        else if (z == level.height)
            ++level.here;
        else if (level.there == 0 || beyond(z, level.next))
            level.next = z, level.there = 1;
        else if (z == level.next)
            ++level.there;
    }
    return level;
}

template <class Height>
void add_stops(std::size_t count, std::size_t points, const Height& height, std::vector<std::string>& hints) {
    const Level low = end_of_range(count, height, [](double a, double b) { return a < b; }),
                high = end_of_range(count, height, [](double a, double b) { return a > b; });
    const auto is_stop = [&](const Level& level) {
        return 50 * level.here >= points && level.there > 0 && level.here >= 5 * level.there;
    };
    const std::size_t both = low.here + high.here;
    if (!is_stop(low) || !is_stop(high) || 20 * both < points || 5 * both > 3 * points) return;
    const auto text = [&](const Level& level, const char* place) {
        return document::shown_percent(static_cast<double>(level.here) / static_cast<double>(points)) +
               " of the heights are at the " + place + ", " + document::shown_length(level.height, 3);
    };
    hints.push_back(text(low, "lowest") + ", and " + text(high, "highest") +
                    ": the gauge was likely at its stops, and sigma is too low; a greater range shows all heights");
}

}  // namespace

std::vector<std::string> equal_heights_hints(const SurfaceOptions& options, const io::Surface& surface) {
    std::vector<std::string> hints;
    if (surface.is_profile()) {
        const std::vector<double>& z = surface.profile().heights;
        const auto height = [&](std::size_t i) { return z[i]; };
        const Runs runs(z.size(), height);
        add_padding(runs, "", options, hints);
        add_stops(z.size(), runs.points, height, hints);
        return hints;
    }
    const auto& z = surface.map().heights;
    const auto rows = static_cast<std::size_t>(z.rows()), columns = static_cast<std::size_t>(z.cols());
    const auto along_x = [&](std::size_t i) { return z.data()[i]; };
    const auto along_y = [&](std::size_t i) { return z.data()[i % rows * columns + i / rows]; };
    const Runs runs(rows * columns, along_x);
    add_padding(runs, ", row by row,", options, hints);
    if (hints.empty()) add_padding(Runs(rows * columns, along_y), ", column by column,", options, hints);
    add_stops(rows * columns, runs.points, along_x, hints);
    return hints;
}

}  // namespace fstiff::surface
