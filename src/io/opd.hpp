// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps of Wyko and Bruker Vision (.opd).
///
/// Two bytes (1, 0) and a directory of 24 bytes a block, the first of which is the directory itself; the blocks follow
/// in that order. The least significant byte comes first.
///
///     0   name (16 characters)      18  bytes of the block (int32; nothing follows where it is below 1)
///     16  type (int16)              22  attribute (uint16)
///
/// A block of type 3 is an array: columns, rows, bytes of a number (uint16), then the numbers column after column, each
/// from the bottom: int16 or float32. The first of the arrays RAW_DATA, "RAW DATA", OPD, Raw and SAMPLE_DATA is read,
/// with the blocks
///
///     Wavelength lambda [nm], Mult M (1 where there is none), Pixel_size dx [mm], Aspect a (1 where there is none)
///
///     height = number lambda / M,     dy = a dx
///
/// Missing points are int16 of 32766 and more, float32 of 1e38 and more, and NaN.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose maps of three measured files are the same
/// Units       map in m, rows from the top
/// Valid       2 points a side at least, or one row; heights that vary
/// Accuracy    five roundings, and those of float32 in the file (tests/io/opd_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a file of Vision does.
[[nodiscard]] bool is_opd(std::string_view bytes);

/// \throws domain_error naming file, block, value and what is allowed.
[[nodiscard]] Reading read_opd(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
