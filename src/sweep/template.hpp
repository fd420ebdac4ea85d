// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The TOML of a grid and of its scenes. Private to the files that make scenes: it brings in toml++.

#include "request/toml.hpp"
#include "sweep/grid.hpp"

#include <string>
#include <vector>

namespace fstiff::sweep {

struct Template {
    toml::table root;                 ///< without [sweep]; swept nodes as they are written
    std::vector<toml::array> listed;  ///< of the axes: the nodes of a list; else empty
};

/// Puts \p node at \p key of the scene \p root, such as "contact.pressures[0]"; its section may be new.
/// \throws domain_error, after the name of the \p file, where the scene has no such place.
void put_at(toml::table& root, const std::string& key, const toml::node& node, const std::string& file);

/// The scene's table with \p values in place of what is swept: what a person would write by hand, in SI.
[[nodiscard]] toml::table table_of(const Grid& grid, const std::vector<Value>& values);

}  // namespace fstiff::sweep
