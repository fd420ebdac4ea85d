// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The picture of a measured curve and of the models that were fitted to it.

#include "picture/plot.hpp"
#include "scene/identification.hpp"

namespace fstiff::cli {

/// The measured curve with those that were fitted, and the residuals below.
[[nodiscard]] Figure fit_figure(const Scene& scene, const MeasuredCurve& curve, const Fits& fits);

}  // namespace fstiff::cli
