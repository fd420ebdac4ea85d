// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What a scene asks for, computed.

#include "actions/results.hpp"

#include <fstiff/core/parallel.hpp>

#include <vector>

namespace fstiff::actions {

/// Everything the scene asks for. A point that a law does not reach leaves the others alone, with a warning. \p
/// progress is called while a band is sampled; \p parallel runs what takes long.
/// \throws domain_error where the model cannot give it, or no law reaches any point, naming the place in the scene.
[[nodiscard]] Results compute(const scene::Scene& scene, const ProgressHook& progress = {},
                              const ParallelHook& parallel = {});
/// The curves of compute() with their states, bands and columns, but without checks, means and warnings.
/// \p contacts are those of the scene, or of one with other points. \throws domain_error as compute().
[[nodiscard]] std::vector<Curve> curves_of(const scene::Scene& scene, const std::vector<detail::MadeContact>& contacts);

}  // namespace fstiff::actions
