// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The islands of a measured map against the cutting level, and the pair R, D_p at their greatest density.

#include "document/document.hpp"
#include "surface/surface_file.hpp"

#include <fstiff/core/parallel.hpp>
#include <fstiff/topography/island_spread.hpp>
#include <fstiff/topography/islands.hpp>

#include <cstddef>
#include <optional>

namespace fstiff::actions {

/// How a file is read, and what counts as an island.
struct IslandsRequest {
    surface::SurfaceOptions surface;
    int neighbours = 8;  ///< of a point: 8 or 4
    BorderIslands border = BorderIslands::kept;
    IslandHeight height = IslandHeight::peak;
    std::size_t min_points = 1, levels = IslandOptions<double>{}.quantiles;
    IslandSpread spread;
    ProgressHook progress{};

    template <class Take>
    void each_field(Take take) {
        take(
            "neighbours", neighbours,
            {.help = "how many neighbours of a point can belong to its island: 8 (default) or 4", .words = {"4", "8"}});
        take("border", border, {"whether islands that reach the edge of the map count: keep (default) or drop"});
        take("least_points", min_points,
             {.help = "smallest number of points of an island that counts; the default is 1", .low = 1, .high = 1e9});
        take("island_height", height,
             {"height of an island: peak (default), its highest point, or twice-mean, twice its mean height"});
        take("levels", levels,
             {.help = "number of levels, at equal steps of bearing area; default 200, 0 for every height",
              .low = 0,
              .high = 1e9});
        take(
            "tiles", spread.tiles,
            {.help =
                 "divide the map into N x N tiles and draw among them for the standard errors; the default is 4, and 1 "
                 "gives no errors",
             .low = 1,
             .high = 1e5});
        take("resamples", spread.resamples,
             {.help = "how often the tiles are drawn; the default is 400", .low = 2, .high = 1e5});
        take("seed", spread.seed, {"seed of the random numbers of the draws; the default is 2014"});
    }
};

/// The document of fstiff measure --show islands for \p input, or for the file that \p options name.
/// \throws domain_error in one sentence with the name of the file.
[[nodiscard]] document::Document document_of(const IslandsRequest& options,
                                             std::optional<surface::SurfaceInput> input = {});

}  // namespace fstiff::actions
