// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Heights of the caller, and how they are measured.

#include "c/guard.hpp"
#include "surface/measured_surface.hpp"

namespace fstiff::c {

/// \p given, or the defaults where it is null; without neighbours, which the band of K needs.
[[nodiscard]] surface::MeasureOptions options_of(const fstiff_measure_options* given);
/// The heights \p from as a surface that \p options clean.
[[nodiscard]] surface::SurfaceInput input_of(const surface::SurfaceOptions& options, const fstiff_heights& from);

}  // namespace fstiff::c
