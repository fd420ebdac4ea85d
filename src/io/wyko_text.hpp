// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads the text that Wyko and Bruker Vision export ("Wyko ASCII").
///
///     Wyko ASCII Data File Format 0 U 1     U: heights in waves (0) or in nm (1)
///     X Size 640, Y Size 480                counts of points, not lengths
///     Block Name, Type, Length, Value       of the blocks that follow, one a line
///     RAW_DATA 3 4915200                    the heights follow, a line for each x; "Bad" where missing
///
/// The step along x is Pixel_size [mm], along y Pixel_size times Aspect; a height in waves is number times Wavelength
/// [nm] over Mult. A line of the file is a row of the map, along which y grows; where the lines are as many as Y Size
/// and as long as X Size, x does. Other arrays, such as intensities, are named and left out.
///
/// Reference   files as the open readers of Gwyddion and SurfaceTopography describe them
/// Units       map in m
/// Valid       2 points a side at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    number times step, rounded twice (tests/io/wyko_text_test.cpp)

#include "io/lines.hpp"
#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether the first line of a text is \p line in an export of Wyko.
[[nodiscard]] bool is_wyko_text(std::string_view line);

/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] Reading read_wyko_text(std::vector<detail::Line> lines, const std::string& name,
                                     const SurfaceOptions& options);

}  // namespace fstiff::inline v0_1::io
