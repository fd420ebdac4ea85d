// SPDX-License-Identifier: BSD-3-Clause
#include "input/scene_options.hpp"

#include "input/progress.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <thread>

namespace fstiff::cli {

void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& scene_help,
                       const std::string& surface_help) {
    arguments.option("scene", options.scene, {.help = scene_help});
    if (!surface_help.empty()) arguments.option("--surface", options.surface, {.help = surface_help});
}

scene::Scene read_scene(const SceneOptions& options) {
    if (options.scene == "-" && options.surface == "-")
        throw Usage("the scene and --surface are both standard input; one of them must be a file");
    const bool builtin = options.scene.empty();
    scene::Scene scene =
        scene::read_scene(builtin ? scene::builtin_scene : document::read_all(options.scene, document::longest_scene),
                          {.name = builtin ? "built-in scene" : document::display_name(options.scene),
                           .surface = options.surface,
                           .progress = progress_bar()});
    for (const std::string& file : scene.files) require_no_output(file);
    return scene;
}

actions::Results computed(const scene::Scene& scene) {
    const ProgressHook progress = progress_bar();
    return actions::compute(scene, progress, [&](std::size_t count, const Piece& run) {
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i; (i = next++) < count;) run(i);
        };
        std::vector<std::future<void>> helpers;  // each ends before it is destroyed
        try {
            for (std::size_t i = 1; i < std::min<std::size_t>(std::thread::hardware_concurrency(), count); ++i)
                helpers.push_back(std::async(std::launch::async, work));
        } catch (const std::system_error&) {  // a limit on threads
        }
        for (std::size_t i; (i = next++) < count; run(i))
            if (progress) progress("pieces", i, count);
    });
}

}  // namespace fstiff::cli
