// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a measured surface on the command line, and its file in documents.

#include "document/output.hpp"
#include "input/arguments.hpp"
#include "scene/surface_file.hpp"

#include <string>
#include <string_view>

namespace fstiff::cli {

/// What a subcommand reads.
enum class SurfaceKind { profile, map, any };

/// Adds --input-format, --units, --missing, --x3p-increment, --channel, --detrend, --spacing, --column, --x-column, --resample and --cutoff of profiles, --lambda-s and --lambda-c, --dx, --dy, --width and --height
/// of maps. Not the file itself.
void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind = SurfaceKind::any);

/// What was decided about the file as lines of a table, each behind \p indent.
[[nodiscard]] std::string source_lines(const SurfaceInput& input, std::string_view indent);

}  // namespace fstiff::cli
