// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The band of K: what the errors of the surface, the choice of lambda_s, and what is not known leave open.

#include "scene/results.hpp"

namespace fstiff::scene {

/// Gives every curve whose law varies its band: 5 % to 95 % over surfaces drawn about this one by its errors, and,
/// where the surface was measured, the spread of K over the neighbours at half and twice the root of two of
/// lambda_s, and the spread over the ends of what is not known. All widths, in logarithms, add by squares.
void add_bands(const Scene& scene, Results& results, const ProgressHook& progress);

}  // namespace fstiff::scene
