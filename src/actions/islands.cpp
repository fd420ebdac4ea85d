// SPDX-License-Identifier: BSD-3-Clause
#include "actions/islands.hpp"

#include <fstiff/double/surfaces.hpp>
#include "actions/measure.hpp"

#include <fstiff/measure/concerns.hpp>

#include <algorithm>

namespace fstiff::actions {

namespace {

RepresentativeIslands<double> islands_of(const IslandsRequest& options, const HeightMap<double>& map) {
    IslandOptions<double> counting;
    counting.connectivity = options.neighbours == 4 ? Connectivity::four : Connectivity::eight;
    counting.border = options.border;
    counting.min_points = options.min_points;
    counting.height = options.height;
    counting.quantiles = options.levels;
    IslandSpread spread = options.spread;
    counting.progress = spread.progress = options.progress;
    return document::about_file(options.surface.file, [&] { return representative_islands(map, counting, spread); });
}

/// The curve, a level a row.
document::Rows level_rows(const RepresentativeIslands<double>& islands) {
    const IslandCurve<double>& c = islands.curve;
    document::Rows rows;
    rows.add({"level_m", "level [µm]", 1e6}, c.level);
    rows.add({"bearing_area", "bearing area", 1, 4}, c.bearing_area);
    rows.add({"islands", "islands"}, c.islands);
    rows.add({"density_per_m2", "density [1/mm²]", 1e-6}, c.density);
    rows.add({"mean_area_m2", "mean area [µm²]", 1e12}, c.mean_area);
    rows.add({"mean_height_m", "mean height [µm]", 1e6}, c.mean_height);
    rows.add({"radius_m", "R [µm]", 1e6}, c.radius);
    std::vector<int> chosen(c.size(), 0);
    chosen[islands.index] = 1;
    rows.add({.key = "representative", .json = false}, chosen);
    rows.add({"", "greatest"}, chosen, [](int concern) { return concern ? "*" : ""; });
    return rows;
}

/// R and D_p with their errors, and where they are.
void add_pair(document::Document& document, const IslandsRequest& options, const RepresentativeIslands<double>& r) {
    document::Json& pair = document.json["representative"] = {{"level_m", r.level},
                                                              {"bearing_area", r.bearing_area},
                                                              {"islands", r.islands},
                                                              {"peak_density_per_m2", r.density},
                                                              {"peak_radius_m", r.radius}};
    if (r.tiles > 0)
        pair.update({{"peak_density_error_per_m2", r.density_error},
                     {"peak_radius_error_m", r.radius_error},
                     {"error_correlation", r.correlation},
                     {"tiles", r.tiles}});
    const auto with_error = [&](const document::ShownUnit& unit, double value, double error) {
        const int digits = detail::is_known<double>({value, error}) && !detail::is_densest_at_end(r) ? 5 : 2;
        return document::rounded(value * unit.factor, digits) +
               (r.tiles > 0 ? " +- " + document::rounded(error * unit.factor, 2) : "") + " " + std::string(unit.name);
    };
    document.line("  D_p = " + with_error(document::unit_of_density(r.density), r.density, r.density_error) +
                  ", R = " + with_error(document::unit_of_length(r.radius), r.radius, r.radius_error) +
                  " at the greatest density: bearing area " + document::rounded(r.bearing_area, 4) + ", " +
                  std::to_string(r.islands) + " islands");
    document.line(r.tiles > 0 ? "  errors by " + std::to_string(options.spread.resamples) + " draws of " +
                                    std::to_string(r.tiles) + " tiles, seed " + std::to_string(r.seed) +
                                    "; their correlation " + document::rounded(r.correlation, 2) + "\n"
                              : "  no errors: one tile\n");
    document.notes = {"D_p = " + document::shortest(r.density) + " 1/m^2 +- " + document::rounded(r.density_error, 2) +
                      " 1/m^2, R = " + document::shortest(r.radius) + " m +- " + document::rounded(r.radius_error, 2) +
                      " m"};
}

}  // namespace

document::Document document_of(const IslandsRequest& options, std::optional<surface::SurfaceInput> given) {
    surface::SurfaceInput input = input_of(options.surface, std::move(given));
    PreparedMap<double> levelled = level_map_of(options.surface, input);
    levelled.unfiltered.reset();  // islands are those of the filtered map
    const RepresentativeIslands<double> r = islands_of(options, levelled.map);
    document::Document document("islands");
    document.title("islands of " + document::shown_name(options.surface.file));
    add_source(document, options.surface, input, surface::form_name(levelled));
    document.json["inputs"].update({{"neighbours", options.neighbours},
                                    {"border", name_of(options.border)},
                                    {"least_points", options.min_points},
                                    {"island_height", name_of(options.height)},
                                    {"levels", options.levels},
                                    {"tiles", options.spread.tiles},
                                    {"resamples", options.spread.resamples},
                                    {"seed", options.spread.seed}});
    document.json["equations"] = {{"radius", "A_m/(2 pi h_m)"}, {"curve", "Figs. 3 and 4"}};
    add_grid(document, input, levelled);
    document.json["nominal_area_m2"] = r.curve.nominal_area;
    add_heights(document, "Sq", levelled, surface::form_name(levelled));
    document.line("islands", "of " + std::to_string(options.neighbours) + " neighbours, of " +
                                 std::to_string(options.min_points) + " points at least, at the border " +
                                 (options.border == BorderIslands::kept ? "kept" : "dropped") + "; height by " +
                                 std::string(name_of(options.height)) + "; " + std::to_string(r.curve.size()) +
                                 " levels\n");
    add_pair(document, options, r);
    document.table(level_rows(r), {.key = "curve",
                                   .thinned = "levels, and the greatest density",
                                   .shown = [index = r.index](std::size_t i) { return i == index; }});
    SurfaceParameters<double> pair;
    pair.peak_radius = {r.radius, r.radius_error};
    pair.peak_density = {r.density, r.density_error};
    const std::vector<MeasuredConcern> concerns = detail::concerns_of(r);
    document.warnings = surface::peak_warnings(concerns, r.islands, pair);
    document.doubtful =
        std::any_of(concerns.begin(), concerns.end(), [](auto concern) { return detail::is_fatal(concern); });
    add_reading(document, input, "they are part of no island and of no area", levelled.areal.rms_gradient);
    return document;
}

}  // namespace fstiff::actions
