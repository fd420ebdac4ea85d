// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Islands of a map: the connected parts above a cutting level, at all levels in one sweep.
///
///     density = islands / nominal area
///     R       = A_m / (2 pi h_m)      paraboloid of the mean island: area A_m at the level, height h_m above it
///
/// The points are sorted by height and raised out of the water one by one; union-find keeps the islands, and their
/// number, area and height are kept up to date, so that a level costs nothing but its own line. Of a cutting level, the
/// points that stand strictly above it count. A missing point is part of no island and of no area; the nominal area is
/// that of the points that exist.
///
/// The representative island is that of the level at which the density is greatest, without smoothing; of equal ones
/// the highest level. Its spread comes from tiles: an island belongs to the tile of its highest point, so that no island
/// is cut; the tiles are drawn with replacement, their curves added, the maximum is sought again. The standard deviation
/// of that, times sqrt(n/(n-1)) for n tiles, contains what the choice of the level adds.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), Figs. 3 and 4; Tarjan, J. ACM 22 (1975) for
///             union-find; Efron, Ann. Stat. 7 (1979) for the bootstrap.
/// Units       levels, heights, R [m], areas [m^2], densities [1/m^2], bearing area 0 to 1
/// Valid       maps of 3 x 3 points at least, 2^31 - 1 points at most, heights that vary
/// Accuracy    counts and areas exact, mean heights 1e-14 of the roughness of those of each level labelled by itself,
///             offset 1e6 times the roughness included; errors of density and R 1.14 and 1.16 times the scatter of 60
///             maps (tests/topography/islands_test.cpp).
///             On Gaussian maps the greatest density is (2 pi)^(-3/2) e^(-1/2) m2/m0 = 0.0385 m2/m0 times 1.02 to 1.08
///             where the waves span a factor of 4 at most; 1.04 to 1.25 at 8, 1.1 to 1.7 at 16: that number is the one
///             of islands less lakes, and in wide bands islands have lakes.

#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/surface/weierstrass_mandelbrot.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
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

template <Real T>
struct IslandOptions {
    Connectivity connectivity = Connectivity::eight;
    BorderIslands border = BorderIslands::kept;
    std::size_t least_points = 1;  ///< smaller islands do not count
    IslandHeight height = IslandHeight::peak;
    std::vector<T> levels{};  ///< cutting levels [m], in any order; none: by bearing area
    std::size_t quantiles =
        200;                  ///< levels at bearing areas (k - 1/2)/quantiles; 0, or more than points: at every height
    ProgressHook progress{};  ///< of the sweep
};

/// Islands against the cutting level, from the highest level to the lowest; the vectors have one length. Where no
/// island counts, means and radius are 0.
template <Real T>
struct IslandCurve {
    std::vector<T> level;         ///< [m]
    std::vector<T> bearing_area;  ///< share of the points that stands above the level, counted islands or not
    std::vector<std::size_t> islands;
    std::vector<T> density;      ///< [1/m^2]
    std::vector<T> mean_area;    ///< A_m [m^2]
    std::vector<T> mean_height;  ///< h_m [m]
    std::vector<T> radius;       ///< R [m]
    T nominal_area{};            ///< [m^2]

    [[nodiscard]] std::size_t size() const { return level.size(); }
    /// Of the greatest density; of equal ones the highest level.
    [[nodiscard]] std::size_t representative() const {
        return static_cast<std::size_t>(std::max_element(density.begin(), density.end()) - density.begin());
    }
};

/// How the spread of the representative island is found.
struct IslandSpread {
    std::size_t tiles = 4;        ///< a side; 1 leaves the spread out
    std::size_t resamples = 400;  ///< of the tiles
    std::uint64_t seed = 2014;
    ProgressHook progress{};  ///< of the resamples
};

template <Real T>
struct RepresentativeIslands {
    std::size_t index{};  ///< in the curve
    T level{};            ///< [m]
    T bearing_area{};
    std::size_t islands{};  ///< at that level
    T density{};            ///< D_p [1/m^2]
    T radius{};             ///< R [m]
    T density_error{};      ///< standard deviation [1/m^2]; 0 when left out
    T radius_error{};       ///< [m]
    T correlation{};        ///< of the two errors
    std::size_t tiles{};    ///< that hold points; 0 when the spread was left out
    std::uint64_t seed{};
    IslandCurve<T> curve;
};

/// \throws domain_error for a map or an option out of range.
template <Real T>
[[nodiscard]] IslandCurve<T> island_curve(const HeightMap<T>& map, const IslandOptions<T>& options = {});

/// The curve, and the pair of density and radius at its greatest density.
/// \throws domain_error as above, when no island counts at any level, or when fewer than two tiles hold points.
template <Real T>
[[nodiscard]] RepresentativeIslands<T> representative_islands(const HeightMap<T>& map,
                                                              const IslandOptions<T>& options = {},
                                                              const IslandSpread& spread = {});

namespace detail {

/// Heights are summed in double at least.
template <Real T>
using IslandSum = std::conditional_t<std::is_same_v<T, float>, double, T>;

/// What is known of all islands that count.
template <Real S>
struct IslandTotal {
    std::int64_t islands{}, points{};
    S height{}, height_error{};  // of all islands together, above zero; the error of the sum is carried (two-sum)

    void add(int sign, std::int64_t island_points, S island_height) {
        islands += sign;
        points += sign * island_points;
        const S term = sign > 0 ? island_height : -island_height;
        const S next = height + term, added = next - height;
        height_error += (height - (next - added)) + (term - added);
        height = next;
    }
    /// Sum of the heights above \p level: rounded once, however high all islands stand.
    S height_above(S level) const { return std::fma(-static_cast<S>(islands), level, height) + height_error; }
};

/// Islands that grow as points are raised.
template <Real T>
class IslandForest {
public:
    using S = IslandSum<T>;

    IslandForest(const HeightMap<T>& map, const IslandOptions<T>& options, std::size_t tiles, T datum)
        : z_(map.heights.data()),
          columns_(static_cast<std::int32_t>(map.columns())),
          rows_(static_cast<std::int32_t>(map.rows())),
          eight_(options.connectivity == Connectivity::eight),
          drop_border_(options.border == BorderIslands::dropped),
          twice_mean_(options.height == IslandHeight::twice_mean),
          least_points_(options.least_points),
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
        if (static_cast<std::size_t>(points) < least_points_ || (drop_border_ && at_border_[at(root)] != 0)) return;
        const S height =
            twice_mean_ ? 2 * sum_[at(root)] / static_cast<S>(points) : static_cast<S>(z_[peak_[at(root)]]);
        total_.add(sign, points, height);
        if (tile_totals_.size() > 1) tile_totals_[tile(peak_[at(root)])].add(sign, points, height);
    }

    const T* z_;
    std::int32_t columns_, rows_;
    bool eight_, drop_border_, twice_mean_;
    std::size_t least_points_;
    S datum_;
    std::vector<std::int32_t> parent_, peak_;
    std::vector<unsigned char> at_border_;
    std::vector<S> sum_;
    std::vector<std::size_t> tile_of_column_, tile_of_row_;
    IslandTotal<S> total_;
    std::vector<IslandTotal<S>> tile_totals_;
};

template <Real T>
struct IslandPoint {
    T height;
    std::int32_t index;
};

/// Highest first, equal ones as they stand: radix sort of 11 bits a pass; std::stable_sort for long double.
template <Real T>
void sort_from_the_highest(std::vector<IslandPoint<T>>& points) {
    if constexpr (std::numeric_limits<T>::is_iec559 && (sizeof(T) == 4 || sizeof(T) == 8)) {
        using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
        constexpr int width = 8 * static_cast<int>(sizeof(T)), digit = 11;
        constexpr Bits sign = Bits(1) << (width - 1), mask = (Bits(1) << digit) - 1;
        const auto key = [](T height) -> Bits {                    // falls as the height rises
            const Bits bits = std::bit_cast<Bits>(height + T(0));  // -0 becomes +0
            return (bits & sign) != 0 ? bits : ~(bits | sign);
        };
        std::vector<IslandPoint<T>> other(points.size());
        std::vector<std::size_t> start(std::size_t(mask) + 1);
        for (int shift = 0; shift < width; shift += digit) {
            std::fill(start.begin(), start.end(), std::size_t(0));
            for (const IslandPoint<T>& point : points) ++start[key(point.height) >> shift & mask];
            std::size_t sum = 0;
            for (std::size_t& count : start) sum += std::exchange(count, sum);
            for (const IslandPoint<T>& point : points) other[start[key(point.height) >> shift & mask]++] = point;
            points.swap(other);
        }
    } else {
        std::stable_sort(points.begin(), points.end(),
                         [](const IslandPoint<T>& a, const IslandPoint<T>& b) { return a.height > b.height; });
    }
}

/// The curve; the totals of every tile at every level go to \p record(level, forest).
template <Real T, class Record>
IslandCurve<T> sweep_islands(const HeightMap<T>& map, const IslandOptions<T>& options, std::size_t tiles,
                             const Record& record) {
    using S = IslandSum<T>;
    map.validate();
    if (map.size() > std::numeric_limits<std::int32_t>::max())
        throw domain_error("map of " + std::to_string(map.size()) + " points: must be at most 2^31 - 1");
    if (options.least_points < 1) throw domain_error("least points of an island = 0: must be at least 1");
    for (const T level : options.levels)
        require(std::abs(level) <= std::numeric_limits<T>::max(), "cutting level", level, "finite");
    const T* const z = map.heights.data();
    std::vector<IslandPoint<T>> points;
    points.reserve(static_cast<std::size_t>(map.present()));
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(map.size()); ++p)
        if (!std::isnan(z[p])) points.push_back({z[p], p});
    sort_from_the_highest(points);
    // sums of as many heights, and of their doubles, stay in range
    const T largest = std::max(std::abs(points.front().height), std::abs(points.back().height));
    require(largest <= std::sqrt(std::numeric_limits<T>::max()), "largest height", largest,
            "at most the root of the largest number");

    std::vector<T> levels = options.levels;
    if (levels.empty() && (options.quantiles == 0 || options.quantiles >= points.size()))
        for (const IslandPoint<T>& point : points) levels.push_back(point.height);
    else if (levels.empty()) {
        const long double step = static_cast<long double>(points.size()) / static_cast<long double>(options.quantiles);
        for (std::size_t k = 0; k < options.quantiles; ++k) {
            const auto index = static_cast<std::size_t>((static_cast<long double>(k) + 0.5L) * step);
            levels.push_back(points[std::min(index, points.size() - 1)].height);
        }
    }
    std::sort(levels.begin(), levels.end(), std::greater<>());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());

    IslandForest<T> forest(map, options, tiles, points[points.size() / 2].height);
    const T cell = map.dx * map.dy;
    IslandCurve<T> curve;
    curve.nominal_area = static_cast<T>(points.size()) * cell;
    require(cell >= std::numeric_limits<T>::min() && curve.nominal_area <= std::numeric_limits<T>::max() &&
                1 / cell <= std::numeric_limits<T>::max(),
            "dx dy", cell, "an area of normal size");
    std::size_t above = 0;
    for (const T level : levels) {
        if (options.progress) options.progress("islands", above, points.size());
        for (; above < points.size() && points[above].height > level; ++above) forest.raise(points[above].index);
        const IslandTotal<S>& total = forest.total();
        T area = 0, height = 0, radius = 0;
        if (total.islands > 0) {
            const auto islands = static_cast<S>(total.islands);
            area = static_cast<T>(static_cast<S>(total.points) / islands) * cell;
            height = static_cast<T>(std::max(S(0), total.height_above(forest.reference(level)) / islands));
            radius = height > T(0) ? area / (2 * numbers::pi_v<T> * height) : T(0);
            require(radius <= std::numeric_limits<T>::max(), "mean island height", height,
                    "larger: the radius leaves the range of numbers");
        }
        curve.level.push_back(level);
        curve.bearing_area.push_back(static_cast<T>(above) / static_cast<T>(points.size()));
        curve.islands.push_back(static_cast<std::size_t>(total.islands));
        curve.density.push_back(static_cast<T>(total.islands) / curve.nominal_area);
        curve.mean_area.push_back(area);
        curve.mean_height.push_back(height);
        curve.radius.push_back(radius);
        record(level, forest);
    }
    return curve;
}

}  // namespace detail

template <Real T>
IslandCurve<T> island_curve(const HeightMap<T>& map, const IslandOptions<T>& options) {
    return detail::sweep_islands(map, options, 1, [](T, const detail::IslandForest<T>&) {});
}

template <Real T>
RepresentativeIslands<T> representative_islands(const HeightMap<T>& map, const IslandOptions<T>& options,
                                                const IslandSpread& spread) {
    using S = detail::IslandSum<T>;
    constexpr std::size_t most_tiles = 32, most_resamples = 100000, most_lines = std::size_t(1) << 22;
    if (spread.tiles < 1 || spread.tiles > most_tiles)
        throw domain_error("tiles a side = " + std::to_string(spread.tiles) + ": must be between 1 and 32");
    if (spread.tiles > 1 && (spread.resamples < 2 || spread.resamples > most_resamples))
        throw domain_error("resamples = " + std::to_string(spread.resamples) + ": must be between 2 and 100000");
    const std::size_t all_tiles = spread.tiles * spread.tiles;

    struct Line {  // of one tile at one level
        S islands, points, height;
    };
    std::vector<Line> lines;  // all tiles of the highest level, then of the next
    RepresentativeIslands<T> result;
    result.curve =
        detail::sweep_islands(map, options, spread.tiles, [&](T level, const detail::IslandForest<T>& forest) {
            if (all_tiles == 1) return;
            if (lines.size() + all_tiles > most_lines)
                throw domain_error(
                    "levels times tiles of the spread: must be at most 2^22; take 1 tile or fewer levels");
            for (const detail::IslandTotal<S>& tile : forest.tile_totals())
                lines.push_back({static_cast<S>(tile.islands), static_cast<S>(tile.points),
                                 tile.height_above(forest.reference(level))});
        });
    const IslandCurve<T>& curve = result.curve;
    result.index = curve.representative();
    result.level = curve.level[result.index];
    result.bearing_area = curve.bearing_area[result.index];
    result.islands = curve.islands[result.index];
    result.density = curve.density[result.index];
    result.radius = curve.radius[result.index];
    require(result.density > T(0) && result.radius > T(0), "greatest density of islands", result.density,
            "greater than 0, with islands of some height: this border and this least size leave none");
    if (all_tiles == 1) return result;

    const detail::IslandForest<T> grid(map, {}, spread.tiles, T(0));  // for its tiles
    std::vector<S> area(all_tiles, S(0));                             // in points
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(map.size()); ++p)
        if (!std::isnan(map.heights.data()[p])) area[grid.tile(p)] += 1;
    std::vector<std::size_t> held;  // tiles that hold points
    for (std::size_t t = 0; t < all_tiles; ++t)
        if (area[t] > S(0)) held.push_back(t);
    if (held.size() < 2)
        throw domain_error("tiles that hold points = " + std::to_string(held.size()) +
                           ": must be at least 2 for a spread");
    result.tiles = held.size();
    result.seed = spread.seed;

    // relative to the pair of the whole map, so that no square leaves the range of numbers
    const S whole_density = static_cast<S>(result.islands) / static_cast<S>(map.present());
    const S cell = static_cast<S>(map.dx) * static_cast<S>(map.dy);
    std::uint64_t state = spread.seed;
    std::vector<std::size_t> drawn(held.size());
    S d1 = 0, r1 = 0, dd = 0, rr = 0, dr = 0;
    std::size_t count = 0;
    for (std::size_t sample = 0; sample < spread.resamples; ++sample) {
        if (spread.progress) spread.progress("resamples", sample, spread.resamples);
        S points = 0;
        for (std::size_t& tile : drawn) {
            tile = held[static_cast<std::size_t>(detail::splitmix64(state) % held.size())];
            points += area[tile];
        }
        Line best{S(0), S(0), S(0)};
        for (std::size_t k = 0; k < curve.size(); ++k) {
            Line sum{S(0), S(0), S(0)};
            for (const std::size_t tile : drawn) {
                const Line& line = lines[k * all_tiles + tile];
                sum.islands += line.islands;
                sum.points += line.points;
                sum.height += line.height;
            }
            if (sum.islands > best.islands) best = sum;
        }
        if (!(best.height > S(0))) continue;  // a draw without islands says nothing
        const S d = best.islands / points / whole_density - 1;
        const S r = best.points * cell / (2 * numbers::pi_v<S> * best.height) / static_cast<S>(result.radius) - 1;
        d1 += d;
        r1 += r;
        dd += d * d;
        rr += r * r;
        dr += d * r;
        ++count;
    }
    if (count < 2) return result;
    const S n = static_cast<S>(count), tiles = static_cast<S>(held.size());
    const S small_sample = tiles / (tiles - 1) / (n - 1);
    const S variance_d = std::max(S(0), (dd - d1 * d1 / n) * small_sample);
    const S variance_r = std::max(S(0), (rr - r1 * r1 / n) * small_sample);
    result.density_error = static_cast<T>(std::sqrt(variance_d)) * result.density;
    result.radius_error = static_cast<T>(std::sqrt(variance_r)) * result.radius;
    if (variance_d > S(0) && variance_r > S(0))
        result.correlation = static_cast<T>(
            std::clamp((dr - d1 * r1 / n) * small_sample / std::sqrt(variance_d) / std::sqrt(variance_r), S(-1), S(1)));
    return result;
}

}  // namespace fstiff
