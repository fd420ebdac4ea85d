// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Rows of a table that keep the straight lines between them close to a finer one.

#include <cstddef>
#include <vector>

namespace fstiff::actions {

/// A point of a line y(x).
struct LinePoint {
    double x, y;
    double slope = 0;  ///< dy/dx, where chords keep it too; else 0
};
using Line = std::vector<LinePoint>;  ///< x rises, y is not 0

/// Largest relative errors of chords at the points that they pass: of y, and of their slope.
struct ChordErrors {
    double value = 0, slope = 0;
};

/// Points of \p lines, from the first to the last, that keep the chords between them \p within errors; as few as a
/// search from one to the next finds. The lines have equally many points; a row is one of each.
[[nodiscard]] std::vector<std::size_t> rows_within(const std::vector<Line>& lines, ChordErrors within);

/// The errors of the chords between \p rows of \p lines.
[[nodiscard]] ChordErrors error_of_rows(const std::vector<Line>& lines, const std::vector<std::size_t>& rows);

}  // namespace fstiff::actions
