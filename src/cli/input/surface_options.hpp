// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a measured surface on the command line, and its file in documents.

#include "document/output.hpp"
#include "input/arguments.hpp"
#include "surface/surface_file.hpp"
#include "surface/surface_option_table.hpp"

#include <string>
#include <string_view>

namespace fstiff::cli {

/// Adds the option of \p key, with its help, range and words for \p kind.
void add_surface_option(Arguments& arguments, SurfaceOptions& options, std::string_view key,
                        SurfaceKind kind = SurfaceKind::any);
/// Adds every option of the table but those of an estimate. Not the file itself.
void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind = SurfaceKind::any);

/// Decisions about the file as lines of a table, each after \p indent.
[[nodiscard]] std::string source_lines(const SurfaceInput& input, std::string_view indent);

}  // namespace fstiff::cli
