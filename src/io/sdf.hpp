// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads surface data files (SDF), text and binary.
///
/// The reader takes the versions ISO-1.0, ISO-2.0 and their forerunner BCR-1.0, with all eight data types, and files
/// with another maker for ISO, such as NIST-1.0, as ISO. It ignores the trailer; rows keep the order of the file.
/// Heights are number times Zscale. Missing points are "BAD" (or "NaN") in text, infinity in binary files, and there,
/// as in the text of BCR-1.0, the numbers that the version reserves:
///
///     type        ISO                        BCR
///     integers    least (unsigned: largest)  largest
///     reals       least, or NaN              1.7e308 (float: 3.4e38) and above, or NaN
///
/// The binary header is of 81 bytes, little-endian on every host: version (8), manufacturer (10), dates (2 x 12),
/// NumPoints and NumProfiles (2 bytes each; 4 in version 2.0), Xscale, Yscale, Zscale, Zresolution (8 each),
/// Compression, DataType, CheckType (1 each). Sizes are compared with the bytes that are there before memory is taken.
///
/// Reference   ISO 25178-71:2017 (versions 1.0, 2.0); K. J. Stout et al., EUR 15178 EN (1993) (BCR). Deviation: text
///             with a data type of integers may hold decimal fractions.
/// Units       map in m; the scales of the file are in m
/// Valid       2 points a side at least, or one profile (dy = dx where its Yscale is 0), of heights that vary; no
///             compression; files up to 2^30 bytes; the check sum is not verified
/// Accuracy    the product with Zscale is rounded once (tests/io/sdf_test.cpp)

#include "io/lines.hpp"
#include "io/reading.hpp"

#include <fstiff/io/quantity.hpp>

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a surface data file does.
[[nodiscard]] bool is_sdf(std::string_view bytes);

/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_sdf(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
