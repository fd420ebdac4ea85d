// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The scene of a subcommand: its options, its reading, and its results.

#include "actions/results.hpp"
#include "document/output.hpp"
#include "input/arguments.hpp"

#include <string>
#include <vector>

namespace fstiff::cli {

struct SceneOptions {
    std::string scene;    ///< file; empty: the built-in scene
    std::string surface;  ///< file in place of [surface]; empty: none
};

/// Adds the scene, and --surface unless \p surface_help is empty.
void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& scene_help,
                       const std::string& surface_help = "");

/// \throws Usage when both files are standard input, domain_error as fstiff::scene::read_scene.
[[nodiscard]] scene::Scene read_scene(const SceneOptions& options);

/// compute() of \p scene on as many threads as the machine has cores, or as start, with progress_bar().
[[nodiscard]] actions::Results computed(const scene::Scene& scene);

}  // namespace fstiff::cli
