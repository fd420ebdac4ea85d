// SPDX-License-Identifier: BSD-3-Clause
#include "surface/islands_of_map.hpp"

#include <fstiff/double/surfaces.hpp>
#include "surface/documents.hpp"

#include <fstiff/measured/measured_concerns.hpp>

#include <algorithm>

namespace fstiff::scene {

bool IslandsOfMap::doubtful() const {
    const std::vector<MeasuredConcern> concerns = concerns_of(islands);
    return std::any_of(concerns.begin(), concerns.end(), [](MeasuredConcern one) { return parts::is_fatal(one); }) ||
           !parts::is_plausible_gradient(levelled.areal.rms_gradient);
}

IslandsOfMap islands_of_map(const IslandsRequest& options, SurfaceInput& input) {
    IslandOptions<double> how;
    how.connectivity = options.neighbours == 4 ? parts::Connectivity::four : parts::Connectivity::eight;
    how.border = options.border;
    how.min_points = options.min_points;
    how.height = options.height;
    how.quantiles = options.levels;
    parts::IslandSpread spread = options.spread;
    how.progress = spread.progress = options.progress;
    IslandsOfMap result;
    result.levelled = level_map_of(options.surface, input);
    result.levelled.unfiltered.reset();  // islands are those of the filtered map
    result.islands =
        about_file(options.surface.file, [&] { return representative_islands(result.levelled.map, how, spread); });
    return result;
}

std::vector<std::string> warnings_of(const SurfaceInput& input, const IslandsOfMap& result) {
    const RepresentativeIslands<double>& r = result.islands;
    parts::SurfaceParameters<double> pair;
    pair.peak_radius = {r.radius, r.radius_error};
    pair.peak_density = {r.density, r.density_error};
    std::vector<std::string> all = peak_warnings(concerns_of(r), r.islands, pair);
    for (std::string& line :
         reading_warnings(input, "they are part of no island and of no area", result.levelled.areal.rms_gradient))
        all.push_back(std::move(line));
    return all;
}

Rows rows_of(const IslandsOfMap& result) {
    const IslandCurve<double>& c = result.islands.curve;
    Rows rows;
    rows.add({"level_m", "level [µm]", 1e6}, c.level);
    rows.add({"bearing_area", "bearing area", 1, 4}, c.bearing_area);
    rows.add({"islands", "islands"}, c.islands);
    rows.add({"density_per_m2", "density [1/mm²]", 1e-6}, c.density);
    rows.add({"mean_area_m2", "mean area [µm²]", 1e12}, c.mean_area);
    rows.add({"mean_height_m", "mean height [µm]", 1e6}, c.mean_height);
    rows.add({"radius_m", "R [µm]", 1e6}, c.radius);
    std::vector<int> chosen(c.size(), 0);
    std::vector<std::string> mark(c.size());
    chosen[result.islands.index] = 1;
    mark[result.islands.index] = "*";
    rows.add({.key = "representative", .json = false}, chosen);
    rows.add({"", "greatest"}, mark);
    return rows;
}

Json islands_json(const IslandsRequest& options, const SurfaceInput& input, const IslandsOfMap& result) {
    const RepresentativeIslands<double>& r = result.islands;
    Json document = json_document("islands");
    document["source"] = json_source(options.surface, input);
    Json inputs = json_inputs(options.surface, form_name(result.levelled));
    inputs.update({{"neighbours", options.neighbours},
                   {"border", name_of(options.border)},
                   {"least_points", options.min_points},
                   {"island_height", name_of(options.height)},
                   {"levels", options.levels},
                   {"tiles", options.spread.tiles},
                   {"resamples", options.spread.resamples},
                   {"seed", options.spread.seed}});
    document["inputs"] = inputs;
    document["equations"] = {{"radius", "A_m/(2 pi h_m)"}, {"curve", "Figs. 3 and 4"}};
    put_grid(document, result.levelled.map, input.missing(), result.levelled.cut_offs);
    document["nominal_area_m2"] = r.curve.nominal_area;
    document["rms_height_m"] = result.levelled.rms;
    document["rms_height_before_detrend_m"] = result.levelled.rms_as_read;
    Json pair = {{"level_m", r.level},
                 {"bearing_area", r.bearing_area},
                 {"islands", r.islands},
                 {"peak_density_per_m2", r.density},
                 {"peak_radius_m", r.radius}};
    if (r.tiles > 0)
        pair.update({{"peak_density_error_per_m2", r.density_error},
                     {"peak_radius_error_m", r.radius_error},
                     {"error_correlation", r.correlation},
                     {"tiles", r.tiles}});
    document["representative"] = pair;
    document["curve"] = rows_of(result).arrays();
    return document;
}

}  // namespace fstiff::scene
