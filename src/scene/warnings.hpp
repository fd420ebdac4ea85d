// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Sentences on what does not hold of results.

#include "scene/results.hpp"

namespace fstiff::scene {

/// Adds to \p results of \p scene, which are complete without them, their warnings and whether they are doubtful.
void add_warnings(const Scene& scene, Results& results);

}  // namespace fstiff::scene
