// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Representative islands of a map, those at the level of the greatest density, and their spread.
///
/// The highest level counts where densities are equal. The spread comes from tiles drawn with replacement: an island
/// belongs to the tile of its highest point, and each draw has its own maximum. The standard deviation is multiplied by
/// sqrt(n/(n-1)) for n tiles.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), Figs. 3 and 4; Efron, Ann. Stat. 7 (1979)
/// Units       level, R [m], density [1/m^2]
/// Valid       as island_curve(), with islands in at least two tiles
/// Accuracy    errors of density and R 1.14 and 1.16 times the scatter of 60 maps (tests/topography/islands_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/topography/islands.hpp>

namespace fstiff { inline namespace v0_1 {

/// Options of the spread of the representative island.
struct IslandSpread {
    std::size_t tiles = 4;        ///< a side; 1 leaves the spread out
    std::size_t resamples = 400;  ///< of the tiles
    std::uint64_t seed = 2014;
    ProgressHook progress{};  ///< of the resamples
};

/// R and D_p at the level of the greatest island density.
template <Real T = double>
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

namespace detail {

/// Islands, points and summed height above the level, of one tile at one level.
template <Real S>
struct TileTotal {
    S islands{}, points{}, height{};

    void add(const TileTotal& other) { islands += other.islands, points += other.points, height += other.height; }
};

/// Sets the errors of \p result from resamples of the tiles \p held, with \p area points each; \p lines are those of
/// all tiles at the highest level, then at the next.
template <Real T>
void resample_tiles(RepresentativeIslands<T>& result, const HeightMap<T>& map,
                    const std::vector<TileTotal<double>>& lines, const std::vector<std::size_t>& held,
                    const std::vector<double>& area, const IslandSpread& spread) {
    // relative to the values of the whole map, so that no square exceeds the range of numbers
    const double whole_density = static_cast<double>(result.islands) / static_cast<double>(map.present());
    const double cell = static_cast<double>(map.dx) * static_cast<double>(map.dy);
    math::BlockDraw draw(held.size(), 1, spread.seed);
    std::vector<std::size_t> drawn(held.size());
    double d1 = 0, r1 = 0, dd = 0, rr = 0, dr = 0;
    std::size_t count = 0;
    for (std::size_t sample = 0; sample < spread.resamples; ++sample) {
        if (spread.progress) spread.progress("resamples", sample, spread.resamples);
        double points = 0;
        for (std::size_t& tile : drawn) {
            tile = held[draw()];
            points += area[tile];
        }
        TileTotal<double> best;
        for (std::size_t level = 0; level < lines.size(); level += area.size()) {
            TileTotal<double> sum;
            for (const std::size_t tile : drawn) sum.add(lines[level + tile]);
            if (sum.islands > best.islands) best = sum;
        }
        if (!(best.height > 0.0)) continue;  // skips draws without islands
        const double d = best.islands / points / whole_density - 1;
        const double r =
            best.points * cell / (2 * std::numbers::pi * best.height) / static_cast<double>(result.radius) - 1;
        d1 += d;
        r1 += r;
        dd += d * d;
        rr += r * r;
        dr += d * r;
        ++count;
    }
    if (count < 2) return;
    const double n = static_cast<double>(count), tiles = static_cast<double>(held.size());
    const double small_sample = tiles / (tiles - 1) / (n - 1);
    const double variance_d = (std::max)(0.0, (dd - d1 * d1 / n) * small_sample);
    const double variance_r = (std::max)(0.0, (rr - r1 * r1 / n) * small_sample);
    result.density_error = static_cast<T>(std::sqrt(variance_d)) * result.density;
    result.radius_error = static_cast<T>(std::sqrt(variance_r)) * result.radius;
    if (variance_d > 0.0 && variance_r > 0.0)
        result.correlation = static_cast<T>(
            std::clamp((dr - d1 * r1 / n) * small_sample / std::sqrt(variance_d) / std::sqrt(variance_r), -1.0, 1.0));
}

}  // namespace detail

/// Curve, and the density and radius at its greatest density.
/// \throws domain_error as above, when no island counts at any level, or when fewer than two tiles hold points.
template <Real T>
[[nodiscard]] RepresentativeIslands<T> representative_islands(const HeightMap<T>& map,
                                                              const IslandOptions<T>& options = {},
                                                              const IslandSpread& spread = {}) {
    constexpr std::size_t max_lines = std::size_t(1) << 22;
    detail::require(spread.tiles >= 1 && spread.tiles <= 32, "tiles a side", spread.tiles, "between 1 and 32");
    detail::require(spread.tiles == 1 || (spread.resamples >= 2 && spread.resamples <= 100000), "resamples",
                    spread.resamples, "between 2 and 100000");
    const std::size_t all_tiles = spread.tiles * spread.tiles;

    std::vector<detail::TileTotal<double>> lines;  // all tiles of the highest level, then of the next
    RepresentativeIslands<T> result;
    result.curve =
        detail::sweep_islands(map, options, spread.tiles, [&](T level, const detail::IslandForest<T>& forest) {
            if (all_tiles == 1) return;
            if (lines.size() + all_tiles > max_lines)
                throw domain_error(
                    "levels times tiles of the spread: must be at most 2^22; take 1 tile or fewer levels");
            for (const detail::IslandTotal<double>& tile : forest.tile_totals())
                lines.push_back({static_cast<double>(tile.islands), static_cast<double>(tile.points),
                                 tile.height_above(forest.reference(level))});
        });
    const IslandCurve<T>& curve = result.curve;
    result.index = curve.representative();
    result.level = curve.level[result.index];
    result.bearing_area = curve.bearing_area[result.index];
    result.islands = curve.islands[result.index];
    result.density = curve.density[result.index];
    result.radius = curve.radius[result.index];
    detail::require(result.density > T(0) && result.radius > T(0), "greatest density of islands", result.density,
                    "greater than 0, with islands of some height: this border and this least size leave none");
    if (all_tiles == 1) return result;

    const detail::TileGrid tile(map.rows(), map.columns(), spread.tiles);
    std::vector<double> area(all_tiles, 0.0);  // in points
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(map.size()); ++p)
        if (!std::isnan(map.heights.data()[p])) area[tile(p)] += 1;
    std::vector<std::size_t> held;  // tiles that hold points
    for (std::size_t t = 0; t < all_tiles; ++t)
        if (area[t] > 0.0) held.push_back(t);
    detail::require(held.size() >= 2, "tiles that hold points", held.size(), "at least 2 for a spread");
    result.tiles = held.size();
    result.seed = spread.seed;
    detail::resample_tiles(result, map, lines, held, area, spread);
    return result;
}

}}  // namespace fstiff
