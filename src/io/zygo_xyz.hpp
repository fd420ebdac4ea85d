// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Zygo's XYZ text, whose header holds rows of numbers and ends with a line "#".
///
/// Units       m

#include "io/lines.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Its first words.
inline constexpr std::string_view zygo_xyz_begin = "Zygo XYZ Data File";

/// The first of \p lines after its header; 0 for another text.
std::size_t zygo_header(const std::vector<Line>& lines);

/// The size of a pixel, the seventh number of line 8. \throws domain_error without one.
double zygo_pixel(const std::vector<Line>& lines, const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
