// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a measured surface on the command line.

#include "document/output.hpp"
#include "input/arguments.hpp"
#include "surface/surface_option_table.hpp"

#include <string>
#include <string_view>

namespace fstiff::cli {

/// Adds the option of \p key, with its help, range and words for \p kind.
void add_surface_option(Arguments& arguments, surface::SurfaceOptions& options, std::string_view key,
                        surface::SurfaceKind kind = surface::SurfaceKind::any);
/// Adds every option of the table but those of an estimate. Not the file itself.
void add_surface_options(Arguments& arguments, surface::SurfaceOptions& options,
                         surface::SurfaceKind kind = surface::SurfaceKind::any);

}  // namespace fstiff::cli
