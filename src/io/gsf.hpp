// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads the simple field of Gwyddion (.gsf).
///
/// The line "Gwyddion Simple Field 1.0", lines "key = value", one to four NUL bytes up to a multiple of 4 bytes, and
/// the heights, row after row from the top, as float32, least significant byte first. NaN is a missing point. XRes and
/// YRes are the columns and rows, XReal and YReal the width and the height in XYUnits, and the heights are in ZUnits.
/// The description lets XReal, YReal and the units be left out; here they must be stated, for nothing is guessed.
///
///     dx = XReal / XRes,    dy = YReal / YRes
///
/// Reference   Gwyddion user guide, "Gwyddion Simple Field" (file formats). Deviation: units with a prefix (um) are
///             read.
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/gsf_test.cpp)

#include "io/binary_numbers.hpp"
#include "io/lines.hpp"
#include "io/reading.hpp"

#include <fstiff/io/quantity.hpp>

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a simple field does.
[[nodiscard]] bool is_gsf(std::string_view bytes);

/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_gsf(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
