// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads X3P files: a zip archive of main.xml and the heights. Needs zlib and pugixml.
///
/// main.xml may lie in a folder of the archive, and its root element in any namespace or in none; other files are left
/// alone. Heights are number times increment plus offset, of the types I (int16), L (int32), F and D, from a file
/// or from the list in main.xml. Missing points are NaN, an empty Datum, or not set in the mask of valid points (one
/// bit a point, the least significant first). Rows keep the order of the file.
///
/// Names in the archive are compared, never used as paths. Sizes are compared with the limits and with what main.xml
/// declares before anything is inflated. The CRC of each file is verified, MD5 sums are not.
///
/// Reference   ISO 25178-72:2017 (ISO 5436-2). Refused: absolute x or y axes, layers (SizeZ > 1), point clouds.
/// Units       map in m, as the increments of the file
/// Valid       2 points a side at least, or one profile (dy = dx where the file states none), of heights that vary;
///             files up to 2^30 bytes
/// Accuracy    number times increment, plus offset where there is one, each rounded once (tests/io/x3p_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Uses the increment, the limits and the names of the options. \throws domain_error naming file, element, value and
/// what is allowed.
[[nodiscard]] Reading read_x3p(std::string_view bytes, std::string_view name, const SurfaceOptions& options = {});

}  // namespace fstiff::inline v0_1::io
