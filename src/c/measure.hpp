// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Heights of the caller, and how they are measured.

#include "c/guard.hpp"
#include "surface/measured_surface.hpp"

#include <fstiff/answer/joint.hpp>

#include <optional>

namespace fstiff::c {

/// A number that is not known where it is 0.
inline std::optional<double> known(double value) { return value == 0 ? std::nullopt : std::optional(value); }

/// Gives \p face the shape of its heights, which is not known where \p kurtosis is 0.
inline void take_shape(double skewness, double kurtosis, JointFace& face) {
    if (kurtosis == 0 && skewness != 0) throw domain_error("skewness: needs kurtosis");
    if (kurtosis != 0) face.skewness = skewness, face.kurtosis = kurtosis;
}

/// \p given, or the defaults where it is null; without neighbours, which the band of K needs.
[[nodiscard]] surface::MeasureOptions options_of(const fstiff_measure_options* given);
/// The heights \p from as a surface that \p options clean.
[[nodiscard]] surface::SurfaceInput input_of(const surface::SurfaceOptions& options, const fstiff_heights& from);

}  // namespace fstiff::c
