// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Islands that grow while points are raised one by one: union-find with their number, area and height.
///
/// Reference   Tarjan, J. ACM 22 (1975)
/// Valid       maps of at most 2^31 - 1 points; points in any order, which affects the rounding of sums of twice_mean
/// Accuracy    counts and areas exact, heights as compensated sums (tests/topography/islands_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/topography/height_map.hpp>

#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Neighbours that belong to the island of a point: the four that share a side, or also those that share a corner.
enum class Connectivity { four, eight };

/// Whether an island that reaches the edge of the map counts.
enum class BorderIslands { kept, dropped };

template <>
inline constexpr auto enum_names<BorderIslands> = detail::name_list<BorderIslands>({{BorderIslands::kept, "keep"},
                                                                                    {BorderIslands::dropped, "drop"}});

/// Height of an island above the level: its highest point, or twice its mean; both are equal for a paraboloid.
enum class IslandHeight { peak, twice_mean };

template <>
inline constexpr auto enum_names<IslandHeight> =
    detail::name_list<IslandHeight>({{IslandHeight::peak, "peak"}, {IslandHeight::twice_mean, "twice-mean"}});

/// Options: islands that count, and cutting levels.
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

/// Totals of all islands that count.
template <Real S>
struct IslandTotal {
    std::int64_t islands{}, points{};
    S height{}, height_error{};  // of all islands together, above zero; the error of the sum is carried

    void add(int sign, std::int64_t island_points, S island_height) {
        islands += sign;
        points += sign * island_points;
        const S term = sign > 0 ? island_height : -island_height;
        const math::RoundedSum<S> next = math::two_sum(height, term);
        height_error += next.error;
        height = next.sum;
    }
    /// Sum of the heights above \p level: rounded once, whatever the height of all islands.
    S height_above(S level) const { return std::fma(-static_cast<S>(islands), level, height) + height_error; }
};

/// Index of the tile of a point, of \p tiles by \p tiles parts of a map.
class TileGrid {
public:
    TileGrid(Eigen::Index rows, Eigen::Index columns, std::size_t tiles)
        : columns_(static_cast<std::int32_t>(columns)),
          of_column_(static_cast<std::size_t>(columns)),
          of_row_(static_cast<std::size_t>(rows)) {
        for (std::size_t i = 0; i < of_column_.size(); ++i) of_column_[i] = i * tiles / of_column_.size();
        for (std::size_t j = 0; j < of_row_.size(); ++j) of_row_[j] = j * tiles / of_row_.size() * tiles;
    }
    std::size_t operator()(std::int32_t point) const {
        const std::int32_t j = point / columns_;
        return of_row_[static_cast<std::size_t>(j)] + of_column_[static_cast<std::size_t>(point - j * columns_)];
    }

private:
    std::int32_t columns_;
    std::vector<std::size_t> of_column_, of_row_;
};

/// Islands that grow as points are raised. The root of an island is its highest point; for equal ones the first.
template <Real T>
class IslandForest {
public:
    /// \p datum is the zero of the sums of mean heights. With \p bands, which rise as the heights fall, a point that
    /// changes no height leaves their sum unchanged; else its island is subtracted and added again, with its rounding.
    IslandForest(const HeightMap<T>& map, const IslandOptions<T>& options, std::size_t tiles, T datum,
                 const std::uint8_t* bands)
        : z_(map.heights.data()),
          columns_(static_cast<std::int32_t>(map.columns())),
          rows_(static_cast<std::int32_t>(map.rows())),
          eight_(options.connectivity == Connectivity::eight),
          drop_border_(options.border == BorderIslands::dropped),
          twice_mean_(options.height == IslandHeight::twice_mean),
          bands_(bands),
          all_count_(bands && !drop_border_ && !twice_mean_ && options.min_points <= 1),
          min_points_(options.min_points),
          datum_(datum),
          parent_(static_cast<std::size_t>(map.size()), under_water),
          at_border_(drop_border_ ? parent_.size() : 0),
          sum_(twice_mean_ ? parent_.size() : 0),
          tile_(map.rows(), map.columns(), tiles),
          tile_totals_(tiles * tiles) {}

    void raise(std::int32_t point) {
        const Islands met = islands_beside(point);
        if (all_count_ && met.count == 1 && !rises(point, met.root[0])) {  // most points: one more of an island
            const std::int32_t root = met.root[0];
            parent_[index(point)] = root;
            --parent_[index(root)];
            ++total_.points;
            if (tile_totals_.size() > 1) ++tile_totals_[tile_(root)].points;
            return;
        }
        std::int32_t highest = point, points = 1;
        for (std::size_t k = 0; k < met.count; ++k) {
            account(met.root[k], -1);
            points -= parent_[index(met.root[k])];
            if (is_higher(met.root[k], highest)) highest = met.root[k];
        }
        const std::int32_t j = point / columns_, i = point - j * columns_;
        unsigned char border = i == 0 || j == 0 || i + 1 == columns_ || j + 1 == rows_ ? 1 : 0;
        double sum = twice_mean_ ? static_cast<double>(z_[point]) - datum_ : 0.0;
        for (std::size_t k = 0; k < met.count; ++k) {
            if (drop_border_) border |= at_border_[index(met.root[k])];
            if (twice_mean_) sum += sum_[index(met.root[k])];
            parent_[index(met.root[k])] = highest;
        }
        parent_[index(point)] = highest;
        parent_[index(highest)] = -points;
        if (drop_border_) at_border_[index(highest)] = border;
        if (twice_mean_) sum_[index(highest)] = sum;
        account(highest, 1);
    }

    const IslandTotal<double>& total() const { return total_; }
    const std::vector<IslandTotal<double>>& tile_totals() const { return tile_totals_; }
    /// Height from which the totals count at \p level.
    double reference(T level) const {
        return twice_mean_ ? 2 * (static_cast<double>(level) - datum_) : static_cast<double>(level);
    }

private:
    // parent_: for a root, minus its number of points
    static constexpr std::int32_t under_water = (std::numeric_limits<std::int32_t>::min)();
    static std::size_t index(std::int32_t point) { return static_cast<std::size_t>(point); }

    std::int32_t find(std::int32_t point) {
        while (parent_[index(point)] >= 0) {
            const std::int32_t next = parent_[index(point)];
            if (parent_[index(next)] >= 0) parent_[index(point)] = parent_[index(next)];  // path halving
            point = next;
        }
        return point;
    }

    bool is_higher(std::int32_t a, std::int32_t b) const { return z_[a] > z_[b] || (z_[a] == z_[b] && a < b); }

    /// is_higher(), by the bands where they differ: more of these are in the cache than heights.
    bool rises(std::int32_t a, std::int32_t b) const {
        return bands_[b] == bands_[a] ? is_higher(a, b) : bands_[a] < bands_[b];
    }

    /// Roots of up to four islands.
    struct Islands {
        std::array<std::int32_t, 4> root;
        std::size_t count = 0;
    };

    /// Islands that \p point joins once it is raised. Of eight neighbours, two that touch belong to one island.
    Islands islands_beside(std::int32_t point) {
        const std::int32_t j = point / columns_, i = point - j * columns_;
        const bool to_left = i > 0, to_right = i + 1 < columns_, up = j > 0, down = j + 1 < rows_;
        const auto is_raised = [&](bool exists, std::int32_t other) {
            return exists && parent_[index(other)] != under_water;
        };
        Islands met;
        const auto meet = [&](std::int32_t neighbour) {
            const std::int32_t root = find(neighbour);
            for (std::size_t k = 0; k < met.count; ++k)
                if (met.root[k] == root) return;
            met.root[met.count++] = root;
        };
        const bool west = is_raised(to_left, point - 1), east = is_raised(to_right, point + 1);
        const bool north = is_raised(up, point - columns_), south = is_raised(down, point + columns_);
        if (west) meet(point - 1);
        if (east && !(eight_ && west && (north || south))) meet(point + 1);
        if (north && !(eight_ && (west || east))) meet(point - columns_);
        if (south && !(eight_ && (west || east))) meet(point + columns_);
        if (!eight_) return met;
        if (!north && !west && is_raised(up && to_left, point - columns_ - 1)) meet(point - columns_ - 1);
        if (!north && !east && is_raised(up && to_right, point - columns_ + 1)) meet(point - columns_ + 1);
        if (!south && !west && is_raised(down && to_left, point + columns_ - 1)) meet(point + columns_ - 1);
        if (!south && !east && is_raised(down && to_right, point + columns_ + 1)) meet(point + columns_ + 1);
        return met;
    }

    void account(std::int32_t root, int sign) {
        const std::int64_t points = -static_cast<std::int64_t>(parent_[index(root)]);
        if (static_cast<std::size_t>(points) < min_points_ || (drop_border_ && at_border_[index(root)] != 0)) return;
        const double height =
            twice_mean_ ? 2 * sum_[index(root)] / static_cast<double>(points) : static_cast<double>(z_[root]);
        total_.add(sign, points, height);
        if (tile_totals_.size() > 1) tile_totals_[tile_(root)].add(sign, points, height);
    }

    const T* z_;
    std::int32_t columns_, rows_;
    bool eight_, drop_border_, twice_mean_;
    const std::uint8_t* bands_;
    bool all_count_;  // every island does, its height is that of its root, and that need not be summed anew
    std::size_t min_points_;
    double datum_;
    std::vector<std::int32_t> parent_;
    std::vector<unsigned char> at_border_;
    std::vector<double> sum_;
    TileGrid tile_;
    IslandTotal<double> total_;
    std::vector<IslandTotal<double>> tile_totals_;
};

}  // namespace detail

}}  // namespace fstiff
