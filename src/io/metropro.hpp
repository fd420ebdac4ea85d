// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps of Zygo MetroPro (.dat).
///
/// A header of 834 or 4096 bytes, frames of intensities (uint16), and the heights row after row as int32, all the most
/// significant byte first. Fields of the header that are used, by byte offset:
///
///     0   88 1B 03 6F, 70, or 71 (hex)     68  columns, rows of the heights (uint16)    184 step of x and y [m]
///     6   bytes of the header (uint32):    164 scale factor S of the interferometer     218 phase resolution: 0, 1, 2
///         4096 after 71,  else 834         168 wavelength lambda [m]                    232 sign: 0, or turned over
///     52  columns, rows, frames of the     176 obliquity factor O (float32 all three)
///         intensities (uint16)
///
///     height = number S O lambda / R,     R = 4096, 32768, 131072 by the phase resolution
///
/// Numbers of 2147483640 and more are missing points.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose maps of a measured file are the same
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files with a step of x and y
/// Accuracy    five roundings, and those of float32 in the file (tests/io/metropro_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a file of MetroPro does.
[[nodiscard]] bool is_metropro(std::string_view bytes);

/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_metropro(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
