// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Islands that grow while points are raised out of the water one by one: union-find with their number, area and
/// height.
///
/// Reference   Tarjan, J. ACM 22 (1975)
/// Valid       maps of 2^31 - 1 points at most; the heights of a map in falling order
/// Accuracy    counts and areas exact, heights as compensated sums (tests/topography/islands_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/topography/height_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace fstiff {

/// Which neighbours of a point are its own island's: the four that share a side, or those that share a corner too.
enum class Connectivity { four, eight };

/// Whether an island that reaches the edge of the map counts.
enum class BorderIslands { kept, dropped };
template <>
inline constexpr auto names<BorderIslands> = name_list<BorderIslands>({{BorderIslands::kept, "keep"},
                                                                       {BorderIslands::dropped, "drop"}});

/// Height of an island above the level: its highest point, or twice its mean; of a paraboloid the same.
enum class IslandHeight { peak, twice_mean };
template <>
inline constexpr auto names<IslandHeight> = name_list<IslandHeight>({{IslandHeight::peak, "peak"},
                                                                     {IslandHeight::twice_mean, "twice-mean"}});

template <Real T = double>
struct IslandOptions {
    Connectivity connectivity = Connectivity::eight;
    BorderIslands border = BorderIslands::kept;
    std::size_t min_points = 1;  ///< smaller islands do not count
    IslandHeight height = IslandHeight::peak;
    std::vector<T> levels{};  ///< cutting levels [m], in any order; none: by bearing area
    std::size_t quantiles =
        200;                  ///< levels at bearing areas (k - 1/2)/quantiles; 0, or more than points: at every height
    ProgressHook progress{};  ///< of the sweep
};

namespace detail {

/// What is known of all islands that count.
template <Real S>
struct IslandTotal {
    std::int64_t islands{}, points{};
    S height{}, height_error{};  // of all islands together, above zero; the error of the sum is carried

    void add(int sign, std::int64_t island_points, S island_height) {
        islands += sign;
        points += sign * island_points;
        const S term = sign > 0 ? island_height : -island_height;
        const RoundedSum<S> next = two_sum(height, term);
        height_error += next.error;
        height = next.sum;
    }
    /// Sum of the heights above \p level: rounded once, however high all islands stand.
    S height_above(S level) const { return std::fma(-static_cast<S>(islands), level, height) + height_error; }
};

/// Islands that grow as points are raised.
template <Real T>
class IslandForest {
public:
    using S = Accumulator<T>;

    IslandForest(const HeightMap<T>& map, const IslandOptions<T>& options, std::size_t tiles, T datum)
        : z_(map.heights.data()),
          columns_(static_cast<std::int32_t>(map.columns())),
          rows_(static_cast<std::int32_t>(map.rows())),
          eight_(options.connectivity == Connectivity::eight),
          drop_border_(options.border == BorderIslands::dropped),
          twice_mean_(options.height == IslandHeight::twice_mean),
          min_points_(options.min_points),
          datum_(datum),
          parent_(static_cast<std::size_t>(map.size()), under_water),
          peak_(parent_.size()),
          at_border_(drop_border_ ? parent_.size() : 0),
          sum_(twice_mean_ ? parent_.size() : 0),
          tile_of_column_(static_cast<std::size_t>(columns_)),
          tile_of_row_(static_cast<std::size_t>(rows_)),
          tile_totals_(tiles * tiles) {
        for (std::size_t i = 0; i < tile_of_column_.size(); ++i)
            tile_of_column_[i] = i * tiles / tile_of_column_.size();
        for (std::size_t j = 0; j < tile_of_row_.size(); ++j) tile_of_row_[j] = j * tiles / tile_of_row_.size() * tiles;
    }

    void raise(std::int32_t point) {
        const std::int32_t j = point / columns_, i = point - j * columns_;
        parent_[at(point)] = -1;
        peak_[at(point)] = point;
        if (drop_border_) at_border_[at(point)] = i == 0 || j == 0 || i + 1 == columns_ || j + 1 == rows_;
        if (twice_mean_) sum_[at(point)] = static_cast<S>(z_[point]) - datum_;
        std::int32_t root = point;
        const bool left = i > 0, right = i + 1 < columns_, up = j > 0, down = j + 1 < rows_;
        if (left) root = join(root, point - 1);
        if (right) root = join(root, point + 1);
        if (up) root = join(root, point - columns_);
        if (down) root = join(root, point + columns_);
        if (eight_) {
            if (left && up) root = join(root, point - columns_ - 1);
            if (right && up) root = join(root, point - columns_ + 1);
            if (left && down) root = join(root, point + columns_ - 1);
            if (right && down) root = join(root, point + columns_ + 1);
        }
        account(root, 1);
    }

    const IslandTotal<S>& total() const { return total_; }
    const std::vector<IslandTotal<S>>& tile_totals() const { return tile_totals_; }
    std::size_t tile(std::int32_t point) const {
        return tile_of_row_[at(point / columns_)] + tile_of_column_[at(point % columns_)];
    }
    /// Of a level, what the sums of the totals count heights from.
    S reference(T level) const { return twice_mean_ ? 2 * (static_cast<S>(level) - datum_) : static_cast<S>(level); }

private:
    // parent_: of a root, minus its number of points
    static constexpr std::int32_t under_water = std::numeric_limits<std::int32_t>::min();
    static std::size_t at(std::int32_t point) { return static_cast<std::size_t>(point); }

    std::int32_t find(std::int32_t point) {
        while (parent_[at(point)] >= 0) {
            const std::int32_t next = parent_[at(point)];
            if (parent_[at(next)] >= 0) parent_[at(point)] = parent_[at(next)];  // path halving
            point = next;
        }
        return point;
    }

    /// \p root, not accounted for, with the island of \p neighbour, which is.
    std::int32_t join(std::int32_t root, std::int32_t neighbour) {
        if (parent_[at(neighbour)] == under_water) return root;
        std::int32_t other = find(neighbour);
        if (other == root) return root;
        account(other, -1);
        if (parent_[at(other)] < parent_[at(root)]) std::swap(root, other);  // the larger one stays
        parent_[at(root)] += parent_[at(other)];
        parent_[at(other)] = root;
        // equal peaks: the earlier point, whatever the order of joining
        const T here = z_[peak_[at(root)]], there = z_[peak_[at(other)]];
        if (there > here || (there == here && peak_[at(other)] < peak_[at(root)])) peak_[at(root)] = peak_[at(other)];
        if (drop_border_) at_border_[at(root)] |= at_border_[at(other)];
        if (twice_mean_) sum_[at(root)] += sum_[at(other)];
        return root;
    }

    void account(std::int32_t root, int sign) {
        const std::int64_t points = -static_cast<std::int64_t>(parent_[at(root)]);
        if (static_cast<std::size_t>(points) < min_points_ || (drop_border_ && at_border_[at(root)] != 0)) return;
        const S height =
            twice_mean_ ? 2 * sum_[at(root)] / static_cast<S>(points) : static_cast<S>(z_[peak_[at(root)]]);
        total_.add(sign, points, height);
        if (tile_totals_.size() > 1) tile_totals_[tile(peak_[at(root)])].add(sign, points, height);
    }

    const T* z_;
    std::int32_t columns_, rows_;
    bool eight_, drop_border_, twice_mean_;
    std::size_t min_points_;
    S datum_;
    std::vector<std::int32_t> parent_, peak_;
    std::vector<unsigned char> at_border_;
    std::vector<S> sum_;
    std::vector<std::size_t> tile_of_column_, tile_of_row_;
    IslandTotal<S> total_;
    std::vector<IslandTotal<S>> tile_totals_;
};

}  // namespace detail

}  // namespace fstiff
