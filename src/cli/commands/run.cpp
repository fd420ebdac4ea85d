// SPDX-License-Identifier: BSD-3-Clause
// fstiff run: a scene to its curves, one per law and peak density.
#include "actions/run.hpp"
#include "commands/commands.hpp"
#include "input/output_options.hpp"
#include "picture/plot.hpp"

#include <memory>
#include <optional>

namespace fstiff::cli {

extern const char* const example_scene;     // data/example_scene.toml
extern const char* const example_of_paper;  // data/example_of_paper.toml

namespace run_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string picture;                 ///< file; empty: none
    bool full = false;                   ///< every point and quantity in the table
    std::optional<std::string> example;  ///< empty: a joint
};

/// The results between the points of \p scene; none where it has enough, or no law reaches any.
std::optional<actions::Answered> between_points(const scene::Scene& scene) {
    const scene::Scene between = actions::with_finer_points(scene, true);
    if (between.points.empty()) return std::nullopt;
    try {
        return computed(between);
    } catch (const domain_error&) {
        return std::nullopt;
    }
}

Report execute(const Options& options) {
    if (options.example) {
        if (!options.scene.scene.empty() || !options.scene.surface.empty() || !options.picture.empty())
            throw Usage("--example prints a scene and computes nothing; give no scene, --surface or --plot with it");
        return {*options.example == "paper" ? example_of_paper : example_scene, {}, success};
    }
    keep_for_picture(options.picture, options.output.force);
    const scene::Scene scene = read_scene(options.scene);
    const actions::Answered answered = computed(scene);
    return with_picture(
        report(document_of(answered, options.full), options.output.format),
        [&] { return results_figure(answered, between_points(scene)); }, options.picture);
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
    command.option(
        "--plot", options->picture,
        {.help = "draw K(p) with its band, and the quantities that are asked for, into FILE.svg; the numbers go "
                 "to FILE.plot.csv",
         .type = "FILE"});
    command.word_or_flag("--example", options->example, {"joint", "paper"},
                         "print a scene with comments, to begin one of your own: a joint of two ground faces, or the "
                         "surface of the paper");
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
