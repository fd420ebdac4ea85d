// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// --format and --output, which every subcommand takes, and the options of a scene and of a measured surface.

#include "actions/answered.hpp"
#include "document/output.hpp"
#include "input/arguments.hpp"
#include "surface/surface_option_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace fstiff::cli {

/// Adds --format, --output and --force; \p initial is the format without --format.
void add_output_options(Arguments& arguments, OutputOptions& options,
                        document::Format initial = document::Format::table);
/// --output and --force alone, for a subcommand that has one form.
void add_output_option(Arguments& arguments, OutputOptions& options);
/// --format alone, for a subcommand that writes a folder: its document goes to standard output.
void add_format_option(Arguments& arguments, OutputOptions& options,
                       document::Format initial = document::Format::table);

/// Adds the option of \p key, with its help, range and words for \p kind.
void add_surface_option(Arguments& arguments, surface::SurfaceOptions& options, std::string_view key,
                        surface::SurfaceKind kind = surface::SurfaceKind::any);
/// Adds every option of the table but those of an estimate. Not the file itself.
void add_surface_options(Arguments& arguments, surface::SurfaceOptions& options,
                         surface::SurfaceKind kind = surface::SurfaceKind::any);

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
[[nodiscard]] actions::Answered computed(const scene::Scene& scene);

}  // namespace fstiff::cli
