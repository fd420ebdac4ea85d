// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps of Alicona (.al3d).
///
/// "AliconaImaging", NUL, CR LF, and tags of 52 bytes, each a key (20 characters), a value (30) and CR LF. The first
/// are Version and TagCount, the number of those that follow. Of them are used
///
///     Cols, Rows, PixelSizeXMeter, PixelSizeYMeter [m], DepthImageOffset, InvalidPixelValue
///
/// The heights in m begin at byte DepthImageOffset, row after row as float32, the least significant byte first,
/// each row filled up to a multiple of 8 bytes. Missing points are NaN or within 1.5e-7 of InvalidPixelValue.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose map of a measured file is the same
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary
/// Accuracy    the float32 of the file (tests/io/al3d_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a file of Alicona does.
[[nodiscard]] bool is_al3d(std::string_view bytes);

/// \throws domain_error naming file, tag, value and what is allowed.
[[nodiscard]] Reading read_al3d(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
