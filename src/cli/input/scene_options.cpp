// SPDX-License-Identifier: BSD-3-Clause
#include "input/scene_options.hpp"

#include "input/progress.hpp"
#include "input/surface_options.hpp"

namespace fstiff::cli {

void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& scene_help,
                       const std::string& surface_help) {
    arguments.option("scene", options.scene, scene_help);
    if (!surface_help.empty()) arguments.option("--surface", options.surface, surface_help);
}

void add_picture_option(Arguments& arguments, std::string& picture, const std::string& draws) {
    arguments
        .option(
            "--plot", picture,
            draws + " into FILE (.svg or .html); its numbers (.plot.csv) and a gnuplot script (.plot.gp) go beside it")
        .type_name("FILE");
}

Scene read_scene(const SceneOptions& options) {
    if (options.scene == "-" && options.surface == "-")
        throw Usage("the scene and --surface are both standard input; one of them must be a file");
    const bool builtin = options.scene.empty();
    return scene::read_scene(builtin ? builtin_scene : read_all(options.scene),
                             {.name = builtin ? "built-in scene" : display_name(options.scene),
                              .surface = options.surface,
                              .progress = progress_bar()});
}

Json scene_json(const Scene& scene) { return {{"name", scene.name}, {"file", scene.file}, {"sha256", scene.sha256}}; }

Json measured_document(const MeasuredSurface& surface) {
    Json document = json_document("measure");
    document["source"] = {
        {"file", surface.file}, {"sha256", surface.sha256}, {"kind", surface.kind}, {"decisions", surface.decisions}};
    put_cut_offs(document, surface.cut_offs);
    Json& values = document["surface"] = Json::object();
    for (const ParameterLine& line : parameter_lines(surface)) {
        Json& entry = values[line.name] = Json::object();
        if (!line.unit.empty()) entry["quantity"] = shortest(line.measured.value) + " " + line.unit;
        entry["value"] = line.measured.value;
        entry["error"] = line.measured.error;
        if (!line.unit.empty()) entry["unit"] = line.unit;
        entry["how"] = line.how;
    }
    if (surface.parameters.known[index_of(Parameter::fractal_dimension)])
        document["fractal_dimension_window_error"] = surface.dimension_window_error;
    if (surface.heights)
        document["moments"] = {{"m0_m2", surface.heights->moments.m0},
                               {"m2", surface.heights->moments.m2},
                               {"m4_per_m2", surface.heights->moments.m4},
                               {"alpha", surface.heights->moments.bandwidth()}};
    for (const MeasuredSurface& neighbour : surface.neighbours) {
        Json of = measured_document(neighbour);
        document["neighbours"].push_back({{"lambda_s_m", of["lambda_s_m"]},
                                          {"lambda_c_m", of["lambda_c_m"]},
                                          {"surface", of["surface"]},
                                          {"moments", of["moments"]}});
    }
    if (!surface.fractal_refusal.empty()) document["no_fractal_dimension"] = surface.fractal_refusal;
    if (!surface.peaks_refusal.empty()) document["no_r_and_theta"] = surface.peaks_refusal;
    Json names = Json::array(), rows = Json::array();
    for (std::size_t i = 0; i < surface_parameter_count; ++i) {
        names.push_back(parameter_table[i].key);
        Json row = Json::array();
        for (const double one : surface.parameters.correlation[i]) row.push_back(one);
        rows.push_back(std::move(row));
    }
    document["correlation_of_errors"] = {{"of", std::move(names)}, {"matrix", std::move(rows)}};
    Json& concerns = document["concerns"] = Json::array();
    for (const MeasuredConcern concern : surface.concerns) concerns.push_back(name_of(concern));
    document["warnings"] = surface.warnings;
    return document;
}

}  // namespace fstiff::cli
