// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/results.hpp"

namespace fstiff::cli {

/// compute() of \p scene on as many threads as the machine has cores, or as start, with progress_bar().
scene::Results computed(const scene::Scene& scene);

}  // namespace fstiff::cli
