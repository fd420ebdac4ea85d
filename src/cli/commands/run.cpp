// SPDX-License-Identifier: BSD-3-Clause
// fstiff run: a scene to its curves, one per law and peak density.
#include "commands/commands.hpp"
#include "commands/run_table.hpp"
#include "document/document.hpp"
#include "input/computed.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "picture/panels.hpp"
#include "scene/explanation.hpp"
#include "scene/result_rows.hpp"
#include "surface/documents.hpp"

#include <memory>
#include <utility>

namespace fstiff::cli {

extern const char* const example_scene;  // data/example_scene.toml

namespace run_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string picture;  ///< file; empty: none
    bool full = false;    ///< every point and quantity in the table
    bool example = false;
};

/// The rows of the answer, then those of the laws that are named.
std::string csv(const Scene& scene, const Results& results) {
    std::string text;
    const auto add = [&](const Curve& curve, int answers) {
        Rows rows = rows_of(results, curve);
        rows.repeat({"answer"}, answers, rows.size());
        text += rows.csv(text.empty());
    };
    if (results.answer) add(results.answer->curve, 1);
    if (scene.best) return text;
    for (Curve curve : results.curves) {  // with the columns of the answer, which has a band
        if (results.answer) curve.columns = columns_of(scene, curve, true);
        add(curve, 0);
    }
    return text;
}

Report execute(const Options& options) {
    if (options.example) {
        if (!options.scene.scene.empty() || !options.scene.surface.empty() || !options.picture.empty())
            throw Usage("--example prints a scene and computes nothing; give no scene, --surface or --plot with it");
        return {example_scene, {}, success};
    }
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const Scene scene = read_scene(options.scene);
    const Results results = computed(scene);
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(results_figure(scene, results), options.picture);
    Report made = report({.table = [&] { return run_table(scene, results, options.full); },
                          .csv = [&] { return csv(scene, results); },
                          .json = [&] { return run_document(scene, results); },
                          .warnings = results.warnings,
                          .status = results.doubtful ? doubtful_result : success},
                         options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace run_command

Command add_run(Arguments& command) {
    using namespace run_command;
    auto options = std::make_shared<Options>();
    add_scene_options(command, options->scene,
                      "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
                      "profile, map, or JSON of fstiff measure, in place of the scene's [surface] and contact.peaks; "
                      "- is standard input");
    add_output_options(command, options->output);
    command.option("--full", options->full, {"the table has every point and quantity, not a summary"});
    add_picture_option(command, options->picture, "draw K(p)");
    command.option("--example", options->example, {"print a scene with comments, to begin one of your own"});
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
