// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --show islands: the islands of a map against the cutting level; R and D_p where they are densest.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"
#include "input/progress.hpp"
#include "input/surface_options.hpp"
#include "surface/islands_of_map.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/measured/measured_concerns.hpp>

#include <memory>

namespace fstiff::cli {
namespace islands_command {
namespace {

struct Options {
    OutputOptions output;
    IslandsRequest islands;
};

std::string table(const IslandsRequest& options, const SurfaceInput& input, const IslandsOfMap& result) {
    const RepresentativeIslands<double>& r = result.islands;
    const HeightMap<double>& map = result.levelled.map;
    std::string text = "fstiff " FSTIFF_VERSION_TEXT ": islands of " + shown_name(options.surface.file) + "\n" +
                       source_lines(input, "  file     ");
    text += "  map      " + std::to_string(map.columns()) + " x " + std::to_string(map.rows()) + " points, dx " +
            shown_length(map.dx) + ", dy " + shown_length(map.dy) + "\n";
    text += "  Sq       " + shown_length(result.levelled.rms_as_read) + " as read, " +
            shown_length(result.levelled.rms) + " after removal of the form (" + form_name(result.levelled) + ")\n";
    text += "  cut-offs " + sentence_of(result.levelled.cut_offs) + "\n";
    text += "  islands  of " + std::to_string(options.neighbours) + " neighbours, of " +
            std::to_string(options.min_points) + " points at least, at the border " +
            (options.border == parts::BorderIslands::kept ? "kept" : "dropped") + "; height by " +
            std::string(name_of(options.height)) + "; " + std::to_string(r.curve.size()) + " levels\n\n";
    const auto with_error = [&](const ShownUnit& unit, double value, double error) {
        const int digits = parts::is_known<double>({value, error}) && !parts::is_densest_at_end(r) ? 5 : 2;
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
    IslandsRequest request = options.islands;
    request.progress = progress_bar();
    SurfaceInput input = read_surface_input(request.surface);
    const IslandsOfMap result = islands_of_map(request, input);
    request.progress = {};
    const RepresentativeIslands<double>& r = result.islands;
    return report({.table = [&] { return table(request, input, result); },
                   .csv = [&] { return rows_of(result).csv(); },
                   .json = [&] { return islands_json(request, input, result); },
                   .warnings = warnings_of(input, result),
                   .csv_notes = {"D_p = " + shortest(r.density) + " 1/m^2 +- " + rounded(r.density_error, 2) +
                                 " 1/m^2, R = " + shortest(r.radius) + " m +- " + rounded(r.radius_error, 2) + " m"},
                   .status = result.doubtful() ? doubtful_result : success},
                  options.output.format);
}

}  // namespace
}  // namespace islands_command

Command add_islands(Arguments& command) {
    using namespace islands_command;
    auto options = std::make_shared<Options>();
    command.option("map", options->islands.surface.file,
                   {.help = "map, as fstiff formats lists them; - is standard input", .required = true});
    add_surface_options(command, options->islands.surface, SurfaceKind::map);
    command.fields(options->islands);
    add_output_options(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
