// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

/// Reads \p bytes as \p form, a name of SurfaceFormat, "profile_text" or "map_text"; aborts where a rule is broken.
void fuzz(const std::string& form, const std::string& bytes);
