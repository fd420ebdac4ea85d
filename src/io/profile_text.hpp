// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a profile from delimited text, and records every decision it took about the file.
///
/// Rows are separated by line ends (LF, CR LF, CR CR LF, CR), columns by comma, semicolon, tab or blanks. The decimal
/// sign is the point, or the comma where the comma does not separate columns. One column holds heights; two hold
/// positions and heights; more need SurfaceOptions::column. A column that numbers the points, by its title or by
/// counting 1, 2, 3 ... next to one that names a length, is neither (io/roles.hpp); SurfaceOptions::x_column
/// names the positions where that is wrong. Lines before the first row of numbers are the header,
/// lines that begin with "#", "%", "!", "//" or ";" comments; both are searched for units, from the first row upwards:
/// "x [um]; z [nm]", "Lateral um,Raw Micrometer", "x (µm)", or the bare units. Missing points are empty
/// cells, "nan", "NA", "N/A", "BAD", "No Data", "***" and the number that the header or the options name.
/// Positions may fall (the profile is turned round) but must be equally spaced, as far as the digits they are printed
/// with show; where all steps but one or two are the same, a row is missing.
/// SurfaceOptions::resample puts as many points at equal steps from the first position to the last, by straight lines
/// between neighbours; that lowers the finest waves, as the record notes.
///
/// Nothing is guessed: without a unit, without a spacing, or with a cell that is not a number, the file is refused.
///
/// Units       profile in m; SurfaceOptions::units are the file's
/// Valid       16 points at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    heights within 1 ulp of the printed number (tests/io/profile_text_test.cpp)

#include "io/roles.hpp"

namespace fstiff::inline v0_1::io {

/// Reads a table whose form is a profile; its text must outlive the call. Messages call it \p name.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] Reading read_profile(detail::TextTable table, const std::string& name, const SurfaceOptions& options);

}  // namespace fstiff::inline v0_1::io
