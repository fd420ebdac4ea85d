// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A scene of TOML that was parsed before. For those who change the table between two scenes: it brings in toml++.

#include "scene/source.hpp"

namespace fstiff::scene {

/// As read_scene, of the parsed \p root; the scene has no sha256. \p builtin: nobody chose its laws.
[[nodiscard]] Scene read_table(const toml::table& root, const SceneSource& from, bool builtin = false);

}  // namespace fstiff::scene
