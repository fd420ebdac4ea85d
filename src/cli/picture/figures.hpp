// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The pictures of analyses and of fits.

#include "picture/plot.hpp"
#include "scene/identified.hpp"
#include "scene/scales.hpp"
#include "surface/spectrum.hpp"

#include <vector>

namespace fstiff::cli {

/// The measured curve with those that were fitted, and the residuals below.
[[nodiscard]] Figure fit_figure(const Scene& scene, const MeasuredCurve& curve, const Fits& fits);
/// The curves of fstiff measure --show spectrum.
[[nodiscard]] Figure spectrum_figure(const SpectrumRequest& request, const Spectrum& spectrum);
/// sigma, gradient, R, D_p and K over those with the chosen cut-offs, against lambda_s and against lambda_c.
[[nodiscard]] std::vector<Panel> scales_panels(const Scales& scales);

}  // namespace fstiff::cli
