// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps of Sensofar (.plux): a zip archive of index.xml and layers. Needs what X3P needs.
///
/// Elements of index.xml that are used, below its root:
///
///     GENERAL/IMAGE_SIZE_X, IMAGE_SIZE_Y  columns, rows        LAYER_0/FILENAME_Z  the file of the heights
///     GENERAL/FOV_X, FOV_Y                steps of x and y [um]
///
/// The heights in um are stored row after row as float32, the least significant byte first. NaN is a missing point. The
/// first layer is read, the record lists the others.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence)
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^30 bytes
/// Accuracy    the float32 of the file times 1e-6, rounded once (tests/io/plux_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// The file \p entry of the zip archive \p bytes, which messages call \p name. \throws domain_error without one.
[[nodiscard]] std::string zip_entry(std::string_view bytes, const std::string& name, std::string_view entry,
                                    const X3pLimits& limits = {});

/// Uses the limits of the options. \throws domain_error naming file, element, value and what is allowed.
[[nodiscard]] Reading read_plux(std::string_view bytes, std::string_view name, const SurfaceOptions& options = {});

}  // namespace fstiff::inline v0_1::io
