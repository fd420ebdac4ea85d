// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The TOML of one scene of a grid.

#include "request/toml.hpp"
#include "sweep/grid.hpp"

#include <vector>

namespace fstiff::sweep {

/// The scene's table with \p values in place of what is swept: what a person would write by hand, in SI.
[[nodiscard]] toml::table table_of(const Grid& grid, const std::vector<Value>& values);

}  // namespace fstiff::sweep
