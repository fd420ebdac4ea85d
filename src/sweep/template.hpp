// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The TOML of a grid. Private to the files that make scenes: it brings in toml++.

#include "request/toml.hpp"

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

}  // namespace fstiff::sweep
