// SPDX-License-Identifier: BSD-3-Clause
// fstiff truth: the contact of a measured map, solved by boundary elements on the map itself.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "surface/truth_of_map.hpp"

#include <fstiff/answer/checks.hpp>
#include <fstiff/core/version.hpp>

#include <memory>
#include <string>
#include <vector>

namespace fstiff::cli {
namespace truth_command {
namespace {

struct Options {
    OutputOptions output;
    TruthRequest truth;
    std::string scene, pressures, modulus, hardness;
};

std::vector<double> pressures_of(const std::string& list) {
    std::vector<double> pressures;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        if (list.substr(begin, end - begin).find_first_not_of("0123456789+-.eE ") == std::string::npos)
            throw domain_error("--pressures = \"" + list +
                               "\": every pressure needs its unit, and the point as decimal mark");
        pressures.push_back(parse_positive(list.substr(begin, end - begin), io::Dimension::pressure, "--pressures"));
        begin = end + 1;
    }
    return pressures;
}

TruthRequest request_of(const Options& options) {
    const Scene scene = read_scene(SceneOptions{options.scene, ""});
    TruthRequest request = options.truth;
    request.modulus = options.modulus.empty() ? effective_modulus(scene.upper, scene.lower)
                                              : parse_positive(options.modulus, io::Dimension::pressure, "--modulus");
    if (options.pressures.empty() && scene.at_separations)
        throw domain_error("the scene has separations; must have contact.pressures, or --pressures must be given");
    request.pressures = options.pressures.empty() ? scene.points : pressures_of(options.pressures);
    if (!options.hardness.empty()) {
        request.hardness = io::parse_quantity(options.hardness, io::Dimension::pressure, "--hardness");
        require_positive("--hardness", request.hardness);
    }
    if (options.modulus.empty())  // else the bodies are not those of the scene
        request.known_hardness = scene.hardness ? *scene.hardness
                                 : scene.yield_strength
                                     ? parts::hardness_over_yield_strength<double> * *scene.yield_strength
                                     : 0;
    request.progress = progress_bar();
    return request;
}

Report execute(const Options& options) {
    const TruthRequest request = request_of(options);
    const TruthOfMap solved = truth_of_map(request, read_surface_input(request.surface));
    return report({.table =
                       [&] {
                           return "fstiff " FSTIFF_VERSION_TEXT ": boundary elements of " + printable(solved.file) +
                                  "\n  " + std::to_string(solved.points) + " points along the longer side, edges " +
                                  std::string(name_of(solved.edges)) + ", form removed: " + solved.form + "\n  sigma " +
                                  rounded(solved.rms_height * 1e6) + " µm, rms gradient " +
                                  rounded(solved.rms_gradient) + ", effective modulus " +
                                  rounded(solved.modulus / 1e9) + " GPa" +
                                  (options.hardness.empty() ? "" : ", pressures cut at " + options.hardness) + "\n\n" +
                                  rows_of(solved).text();
                       },
                   .csv = [&] { return rows_of(solved).csv(); },
                   .json = [&] { return truth_json(solved); },
                   .warnings = warnings_of(solved),
                   .status = solved.doubtful() ? doubtful_result : success},
                  options.output.format);
}

}  // namespace
}  // namespace truth_command

Command add_truth(Arguments& command) {
    using namespace truth_command;
    auto options = std::make_shared<Options>();
    command.option("file", options->truth.surface.file,
                   {.help = "map of any form; - is standard input", .required = true});
    add_surface_options(command, options->truth.surface);
    command.option("--scene", options->scene,
                   {"scene that gives material and pressures; the default is the built-in scene"});
    command.option("--pressures", options->pressures, {"nominal pressures instead, such as \"1 MPa,10 MPa\""});
    command.option("--modulus", options->modulus, {"effective modulus instead of that of the material"});
    command.option("--hardness", options->hardness, {"hardness at which pressures are cut; the default is elastic"});
    command.fields(options->truth);
    add_output_options(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
