// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads profiles of ISO 5436-2 (.smd, "softgauge") and of its elder relative that Mahr and Taylor Hobson write (.prf).
///
/// Both are text in records. Those of .smd end at the character ETX (3), and their fields are parted by NUL bytes or
/// blanks; those of .prf end at a line EOR. The first record names the file, the form PRF (a profile), and two axes:
///
///     CX I 8000 mm 1.0e0 D 5.0e-4        axis, kind, points, unit, scale, type of the numbers, and of I the increment
///     CZ A 8000 um 1.0e0 D
///
/// kinds being I (equal increments) of x and A (absolute) of z in .smd, and M of both in .prf, whose spacing is in
/// the second record as "SPACING CX 5.0e-4". The third record has a height a line, the fourth of .smd a sum over all
/// bytes.
///
///     z = number * scale * unit of CZ,        dx = increment * scale * unit of CX
///
/// The sum is compared modulo 65535 and modulo 65536, for descriptions differ; one that fits neither is warned of.
/// Lines MAP of .prf other than those of a straight gauge (MAP 1 CZ CZ 1 1, MAP 2 CZ CX 1 0) are not applied, with a
/// warning.
///
/// Reference   ISO 5436-2:2012, as the public help of NPL (softgauges, "Data File Format") and open programs that read
///             or write it lay it out; not compared with files of the instruments themselves
/// Units       m
/// Valid       16 heights at least, that vary; files up to 2^31 bytes, lines up to 2^20 characters
/// Accuracy    number times scale times unit: two roundings (tests/io/smd_test.cpp)

#include "io/lines.hpp"
#include "io/reading.hpp"

#include <fstiff/io/quantity.hpp>

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as one of the two forms does.
[[nodiscard]] bool is_smd(std::string_view bytes);

/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] Reading read_smd(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
