// SPDX-License-Identifier: BSD-3-Clause
// fstiff truth: the contact of a measured map, solved by boundary elements on the map itself.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "scene/results.hpp"
#include "scene/surface_instances.hpp"

#include <fstiff/contact/validity.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/halfspace/truth.hpp>
#include <fstiff/topography/areal_statistics.hpp>

#include <memory>
#include <string>
#include <vector>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    SurfaceOptions input;
    std::string scene, pressures, modulus, hardness;
    int points = 256;
    Edges edges = Edges::mirrored;
};

/// What was solved, for all three forms of output.
struct Solved {
    std::string file, form;
    double modulus = 0, rms_height = 0, rms_gradient = 0;
    Eigen::Index points = 0;  ///< along the longer side, after coarsening
    std::vector<TruthPoint<double>> at;
};

std::vector<double> pressures_of(const std::string& list) {
    std::vector<double> pressures;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        pressures.push_back(
            io::parse_quantity(list.substr(begin, end - begin), io::Dimension::pressure, "--pressures"));
        require_positive("--pressures", pressures.back());
        begin = end + 1;
    }
    return pressures;
}

Solved solve(const Options& options) {
    const Scene scene = read_scene(SceneOptions{options.scene, ""});
    const SurfaceInput input = read_surface_input(options.input);
    if (input.surface.is_profile())
        throw domain_error(display_name(options.input.file) + ": is a profile; boundary elements need a map");
    const PreparedMap map = scene::level_map(options.input, input);
    Solved solved;
    solved.file = display_name(options.input.file);
    solved.form = map.form + (map.cut_offs.any() ? ", " + map.cut_offs.sentence() : "");
    solved.modulus = options.modulus.empty()
                         ? effective_modulus(scene.upper, scene.lower)
                         : io::parse_quantity(options.modulus, io::Dimension::pressure, "--modulus");
    if (options.pressures.empty() && scene.at_separations)
        throw domain_error("the scene has separations; must have contact.pressures, or --pressures must be given");
    const std::vector<double> pressures = options.pressures.empty() ? scene.points : pressures_of(options.pressures);
    TruthOptions<double> how{.points = options.points, .edges = options.edges, .progress = progress_bar()};
    if (!options.hardness.empty())
        how.hardness = io::parse_quantity(options.hardness, io::Dimension::pressure, "--hardness");
    solved.rms_height = map.rms;
    solved.rms_gradient = map.areal.rms_gradient;
    solved.points = std::min<Eigen::Index>(options.points, std::max(map.map.columns(), map.map.rows()));
    solved.at = truth(map.map, solved.modulus, pressures, how);
    return solved;
}

Rows rows_of(const Solved& solved) {
    std::vector<double> pressure, relative, stiffness, error, gap, gap_error, area, largest;
    std::vector<std::size_t> spots;
    std::vector<std::string> converged;
    for (const auto& [state, stiffness_error, change_of_gap] : solved.at) {
        pressure.push_back(state.pressure);
        relative.push_back(dimensionless_pressure(state.pressure, solved.modulus, solved.rms_gradient));
        stiffness.push_back(state.stiffness);
        error.push_back(stiffness_error);
        gap.push_back(state.mean_gap);
        gap_error.push_back(change_of_gap);
        area.push_back(state.contact_fraction);
        largest.push_back(state.max_pressure);
        spots.push_back(static_cast<std::size_t>(state.spots));
        converged.emplace_back(state.converged ? "yes" : "no");
    }
    Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, pressure);
    rows.add({"p_star", "p*", 1, 3}, relative);
    rows.add({"stiffness_Pa_per_m", "K/A0 [GPa/µm]", 1e-15}, stiffness);
    rows.add({"stiffness_error_Pa_per_m", "+- grid", 1e-15, 2}, error);
    rows.add({"separation_m", "mean gap [µm]", 1e6}, gap);
    rows.add({"separation_error_m", "+- grid", 1e6, 2}, gap_error);
    rows.add({"real_area_fraction", "contact share"}, area);
    rows.add({"contacts", "contacts"}, spots);
    rows.add({"max_pressure_Pa", "largest p [GPa]", 1e-9}, largest);
    rows.add({"converged", "converged"}, converged);
    return rows;
}

Report execute(const Options& options) {
    const Solved solved = solve(options);
    std::vector<std::string> warnings;
    int unresolved = 0, failed = 0;
    for (const auto& point : solved.at) {
        unresolved += point.stiffness_error > 0.2 * point.state.stiffness ? 1 : 0;
        failed += point.state.converged ? 0 : 1;
    }
    if (unresolved > 0)
        warnings.push_back("K changes by more than a fifth from the grid half as fine at " +
                           std::to_string(unresolved) + " of " + std::to_string(solved.at.size()) +
                           " pressures: the contacts there are a few points wide (--points, or a finer map)");
    if (failed > 0) warnings.push_back(std::to_string(failed) + " solutions did not converge");
    return report({.table =
                       [&] {
                           return "fstiff " FSTIFF_VERSION ": boundary elements of " + solved.file + "\n  " +
                                  std::to_string(solved.points) + " points along the longer side, edges " +
                                  std::string(name_of(options.edges)) + ", form removed: " + solved.form +
                                  "\n  sigma " + rounded(solved.rms_height * 1e6) + " µm, rms gradient " +
                                  rounded(solved.rms_gradient) + ", effective modulus " +
                                  rounded(solved.modulus / 1e9) + " GPa" +
                                  (options.hardness.empty() ? "" : ", pressures cut at " + options.hardness) + "\n\n" +
                                  rows_of(solved).text();
                       },
                   .csv = [&] { return rows_of(solved).csv(); },
                   .json =
                       [&] {
                           Json document = json_document("truth");
                           document["map"] = solved.file;
                           document["points"] = solved.points;
                           document["edges"] = name_of(options.edges);
                           document["effective_modulus_Pa"] = solved.modulus;
                           document["rms_height_m"] = solved.rms_height;
                           document["rms_gradient"] = solved.rms_gradient;
                           Json& rows = document["rows"] = Json::array();
                           rows_of(solved).append_to(rows);
                           return document;
                       },
                   .warnings = warnings,
                   .status = unresolved + failed > 0 ? doubtful_result : success},
                  options.output.format);
}

}  // namespace

Command add_truth(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "truth", "Stiffness of a measured map by boundary elements on the map itself");
    command.option("file", options->input.file, "map of any form; - is standard input").required();
    add_surface_options(command, options->input);
    command.option("--scene", options->scene,
                   "scene whose material and pressures are taken; the default is the built-in scene");
    command.option("--pressures", options->pressures, "nominal pressures in place of those, such as \"1 MPa,10 MPa\"");
    command.option("--modulus", options->modulus, "effective modulus in place of that of the material");
    command.option("--hardness", options->hardness, "hardness at which pressures are cut; the default is elastic");
    command
        .option("--points", options->points,
                "points along the longer side that the map is made coarser to; the default is 256")
        .between(16, 4096);
    command.option("--edges", options->edges, "how the map goes on beyond its edges: mirrored (default) or periodic");
    add_output_options(command, options->output);
    command.footer(
        "The error of K is its change from a grid half as fine. Exit code 4: it is above a fifth of K, or no "
        "convergence.\n"
        "Example:\n  fstiff generate map --hurst 0.8 --rms \"1 um\" --spacing \"1 um\" | fstiff truth - --pressures "
        "\"10 MPa\"");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
