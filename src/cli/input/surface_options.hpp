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

/// Adds --input-format, --units, --missing, --x3p-increment, --channel, --detrend, --spacing, --column, --resample and --cutoff of profiles, --lambda-s and --lambda-c, --dx, --dy, --width and --height
/// of maps. Not the file itself.
void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind = SurfaceKind::any);

/// The file, its SHA-256 and what was decided about it, for a JSON document.
[[nodiscard]] Json json_source(const SurfaceOptions& options, const SurfaceInput& input);
/// The options as they were given, for a JSON document; \p form is the one that was removed.
[[nodiscard]] Json json_inputs(const SurfaceOptions& options, const std::string& form);
/// lambda_s_m and lambda_c_m of a JSON document: null where there is none.
void put_cut_offs(Json& document, const CutOffs& cut_offs);
/// The same decisions as lines of a table, each behind \p indent.
[[nodiscard]] std::string source_lines(const SurfaceInput& input, std::string_view indent);

}  // namespace fstiff::cli
