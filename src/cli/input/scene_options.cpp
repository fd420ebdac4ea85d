// SPDX-License-Identifier: BSD-3-Clause
#include "input/scene_options.hpp"

#include "input/progress.hpp"

namespace fstiff::cli {

void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& scene_help,
                       const std::string& surface_help) {
    arguments.option("scene", options.scene, {.help = scene_help});
    if (!surface_help.empty()) arguments.option("--surface", options.surface, {.help = surface_help});
}

Scene read_scene(const SceneOptions& options) {
    const ProgressHook progress = progress_bar();
    if (options.scene == "-" && options.surface == "-")
        throw Usage("the scene and --surface are both standard input; one of them must be a file");
    const bool builtin = options.scene.empty();
    Scene scene = scene::read_scene(builtin ? builtin_scene : read_all(options.scene, longest_scene),
                                    {.name = builtin ? "built-in scene" : display_name(options.scene),
                                     .surface = options.surface,
                                     .progress = progress,
                                     .parallel = all_cores(progress)});
    for (const std::string& file : scene.files) require_no_output(file);
    return scene;
}

Results computed(const Scene& scene) {
    const ProgressHook progress = progress_bar();
    return scene::compute(scene, progress, all_cores(progress));
}

}  // namespace fstiff::cli
