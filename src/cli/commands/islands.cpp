// SPDX-License-Identifier: BSD-3-Clause
// fstiff islands: the islands of a map against the cutting level, and the pair R, D_p at their greatest density.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/progress.hpp"
#include "input/surface_options.hpp"
#include "scene/measured_surface.hpp"
#include "scene/shown_unit.hpp"
#include "scene/surface_instances.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/topography/island_spread.hpp>

#include <algorithm>
#include <memory>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    SurfaceOptions surface;
    int neighbours = 8;
    BorderIslands border = BorderIslands::kept;
    IslandHeight height = IslandHeight::peak;
    std::size_t min_points = 1, levels = IslandOptions<double>{}.quantiles;
    IslandSpread spread;
};

struct Result {
    PreparedMap levelled;
    RepresentativeIslands<double> islands;
};

Result sweep(const Options& options, SurfaceInput& input) {
    IslandOptions<double> how;
    how.connectivity = options.neighbours == 4 ? Connectivity::four : Connectivity::eight;
    how.border = options.border;
    how.min_points = options.min_points;
    how.height = options.height;
    how.quantiles = options.levels;
    IslandSpread spread = options.spread;
    how.progress = spread.progress = progress_bar();
    Result result;
    result.levelled = level_map_of(options.surface, input);
    result.levelled.unfiltered.reset();  // islands are those of the map behind the filter
    result.islands =
        about_file(options.surface.file, [&] { return representative_islands(result.levelled.map, how, spread); });
    return result;
}

std::vector<std::string> warnings(const SurfaceInput& input, const Result& result) {
    const RepresentativeIslands<double>& r = result.islands;
    UncertainSurface<double> pair;
    pair.set(Parameter::peak_radius, {r.radius, r.radius_error});
    pair.set(Parameter::peak_density, {r.density, r.density_error});
    std::vector<std::string> all = peak_warnings(concerns_of(r), r.islands, pair);
    for (std::string& line : reading_warnings(input, "they are part of no island and of no area"))
        all.push_back(std::move(line));
    return all;
}

Rows rows_of(const Result& result) {
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

Json json(const Options& options, const SurfaceInput& input, const Result& result) {
    const RepresentativeIslands<double>& r = result.islands;
    const HeightMap<double>& map = result.levelled.map;
    Json document = json_document("islands");
    document["source"] = json_source(options.surface, input);
    Json inputs = json_inputs(options.surface, result.levelled.form);
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
    document["columns"] = map.columns();
    document["rows"] = map.rows();
    document["dx_m"] = map.dx;
    document["dy_m"] = map.dy;
    document["missing_points"] = input.missing();
    put_cut_offs(document, result.levelled.cut_offs);
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

std::string table(const Options& options, const SurfaceInput& input, const Result& result) {
    const RepresentativeIslands<double>& r = result.islands;
    const HeightMap<double>& map = result.levelled.map;
    std::string text = "fstiff " FSTIFF_VERSION ": islands of " + display_name(options.surface.file) + "\n" +
                       source_lines(input, "  file     ");
    text += "  map      " + std::to_string(map.columns()) + " x " + std::to_string(map.rows()) + " points, dx " +
            shown_length(map.dx) + ", dy " + shown_length(map.dy) + "\n";
    text += "  Sq       " + shown_length(result.levelled.rms_as_read) + " as read, " +
            shown_length(result.levelled.rms) + " after removal of the form (" + result.levelled.form + ")\n";
    text += "  cut-offs " + result.levelled.cut_offs.sentence() + "\n";
    text += "  islands  of " + std::to_string(options.neighbours) + " neighbours, of " +
            std::to_string(options.min_points) + " points at least, at the border " +
            (options.border == BorderIslands::kept ? "kept" : "dropped") + "; height by " +
            std::string(name_of(options.height)) + "; " + std::to_string(r.curve.size()) + " levels\n\n";
    const auto with_error = [&](const ShownUnit& unit, double value, double error) {
        const int digits = is_known<double>({value, error}) && !is_densest_at_end(r) ? 5 : 2;
        return rounded(value * unit.factor, digits) + (r.tiles > 0 ? " +- " + rounded(error * unit.factor, 2) : "") +
               " " + std::string(unit.name);
    };
    text += "  D_p = " + with_error(unit_of_density(r.density), r.density, r.density_error) +
            ", R = " + with_error(unit_of_length(r.radius), r.radius, r.radius_error) +
            " at the greatest density: bearing area " + rounded(r.bearing_area, 4) + ", " + std::to_string(r.islands) +
            " islands\n";
    text += r.tiles > 0 ? "  errors by " + std::to_string(options.spread.resamples) + " draws of " +
                              std::to_string(r.tiles) + " tiles, seed " + std::to_string(r.seed) +
                              "; their correlation " + rounded(r.correlation, 2) + "\n\n"
                        : "  no errors: one tile\n\n";
    constexpr std::size_t shown = 24;
    const std::size_t size = r.curve.size(), step = (size + shown - 1) / shown;
    text += rows_of(result).text([&](std::size_t i) { return i % step == 0 || i == r.index; });
    if (step > 1)
        text += "  every " + std::to_string(step) + ". of " + std::to_string(size) +
                " levels, and the greatest density; all with --format csv\n";
    return text;
}

Report execute(const Options& options) {
    SurfaceInput input = read_surface_input(options.surface);
    const Result result = sweep(options, input);
    const RepresentativeIslands<double>& r = result.islands;
    const std::vector<MeasuredConcern> concerns = concerns_of(r);
    const bool doubtful =
        std::any_of(concerns.begin(), concerns.end(), [](MeasuredConcern one) { return is_fatal(one); });
    return report({.table = [&] { return table(options, input, result); },
                   .csv = [&] { return rows_of(result).csv(); },
                   .json = [&] { return json(options, input, result); },
                   .warnings = warnings(input, result),
                   .csv_notes = {"D_p = " + shortest(r.density) + " 1/m^2 +- " + rounded(r.density_error, 2) +
                                 " 1/m^2, R = " + shortest(r.radius) + " m +- " + rounded(r.radius_error, 2) + " m"},
                   .status = doubtful ? doubtful_result : success},
                  options.output.format);
}

}  // namespace

Command add_islands(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "islands", "Islands of a map at every cutting level, and peak radius R and density D_p");
    command.option("map", options->surface.file, "map, as fstiff formats lists them; - is standard input").required();
    add_surface_options(command, options->surface, SurfaceKind::map);
    command
        .option("--neighbours", options->neighbours,
                "how many neighbours of a point can belong to its island: 8 (default) or 4")
        .one_of({4, 8});
    command.option("--border", options->border,
                   "whether islands that reach the edge of the map count: keep (default) or drop");
    command.option("--least-points", options->min_points,
                   "smallest number of points of an island that counts; the default is 1");
    command.option("--island-height", options->height,
                   "height of an island: peak (default), its highest point, or twice-mean, twice its mean height");
    command.option("--levels", options->levels,
                   "number of levels, at equal steps of bearing area; default 200, 0 for every height");
    command.option(
        "--tiles", options->spread.tiles,
        "divide the map into N x N tiles and draw among them for the standard errors; the default is 4, and 1 gives no "
        "errors");
    command.option("--resamples", options->spread.resamples, "how often the tiles are drawn; the default is 400");
    command.option("--seed", options->spread.seed, "seed of the random numbers of the draws; the default is 2014");
    add_output_options(command, options->output);
    command.footer(
        "The CSV is the curve; the JSON holds everything. R = A_m/(2 pi h_m), of the mean island of the level at "
        "which\n"
        "islands are densest.\n"
        "Example:\n"
        "  fstiff generate map --points 512 --spacing \"0.5 um\" --hurst 0.8 --rms \"1 um\" --shortest \"8 um\" "
        "--longest "
        "\"32 um\" |\n"
        "      fstiff islands -");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
