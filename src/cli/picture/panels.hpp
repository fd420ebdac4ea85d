// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The picture of a scene's results.

#include "picture/plot.hpp"
#include "scene/results.hpp"

namespace fstiff::cli {

/// Picture of `run --plot`: K(p) of \p smooth, which is of \p scene with finer points, with marks at the points of
/// \p scene; below it what follows from K and is asked for.
/// \throws domain_error when the scene asks for no stiffness.
[[nodiscard]] Figure results_figure(const Scene& scene, const Results& results, const Results& smooth);

}  // namespace fstiff::cli
