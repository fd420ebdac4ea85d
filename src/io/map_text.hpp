// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a height map from delimited text, and records every decision it took about the file.
///
/// Two forms. A *matrix* has a row of the map a line, its size and units in a header of "key: value" or "key = value"
/// lines, with or without a comment sign: Gwyddion's "# Width: 10 um", "# Height: 5 um", "# Value units: m"; "dx",
/// "pixel size" and the like; "h=305 w=75" is compared with what is there; heights in another unit (rad) need a
/// "height conversion factor (-> m)". *Triples* have x, y and z a line, in any order of the points; the grid is
/// recovered from the coordinates, x and y rise in the map, and points that are not there are missing.
/// Exports of Keyence ("XY Calibration","277.8","nm"), of SPIP ("# x-length = 2000", in nm, "# Bit2nm = 0.5") and of
/// Gwyddion in other languages are matrices too (io/header_words.hpp).
/// Which of the two a text is, io/roles.hpp finds out. Of four columns and more, triples leave out what is not
/// x, y or z. A matrix may have positions as its first row and column (io/matrix_axes.hpp), which give its
/// steps. Zygo's XYZ text has its pixel in the header. Missing points are empty cells,
/// "nan", "NA", "N/A", "BAD", "No Data", "***" and the number that the header ("NODATA_value -9999") or the options
/// name. Rows of a matrix keep the order of the file.
///
/// Nothing is guessed: without units, without a physical size, or with points off the grid, the file is refused.
///
///     dx = width / columns,    dy = height / rows               a point represents a cell, as in Gwyddion
///
/// Units       map in m; SurfaceOptions::units are the file's
/// Valid       2 points a side at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    heights and a stated pitch within 1 ulp of the printed number (tests/io/map_text_test.cpp)

#include "io/roles.hpp"

namespace fstiff::inline v0_1::io {

/// Reads a table of triples or a matrix; its text must outlive the call. Messages call it \p name.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] Reading read_map(detail::TextTable table, const std::string& name, const SurfaceOptions& options);

/// Whether \p line is the first of an export of Wyko (io/wyko_text.cpp).
[[nodiscard]] bool is_wyko_text(std::string_view line);
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] Reading read_wyko_text(std::vector<detail::Line> lines, const std::string& name,
                                     const SurfaceOptions& options);

}  // namespace fstiff::inline v0_1::io
