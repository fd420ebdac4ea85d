// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Which lines of a text are rows, and how they are written: decided once, over all lines.
///
///     Mean;;;1.28;                              a result below the rows, no row
///     EOF                                       no row
///
/// The first line that reads as a row of numbers ends the header, and shows the separator; all lines show the columns
/// of words (io/word_columns.hpp), the decimal sign and where the rows end. All from the first row to the last must be
/// rows or comments: a word among the numbers of a column is refused, since it may mark a missing point. A line after
/// the rows that begins with a number is refused too, and one that states a unit or a size.
///
/// Accuracy    none: words (tests/io/row_layout_test.cpp)

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Finds the rows of a text, their separator and decimal sign, and the columns of words; \p before: lines of the file
/// above it. \throws domain_error when no line is a row of numbers.
NumberTable open_table(std::vector<Line> lines, const std::string& name, const SurfaceOptions& options = {},
                       std::size_t before = 0);
NumberTable open_table(std::string_view text, const std::string& name);

/// The rows from line \p first on, below titles that show the \p separator: their decimal sign, columns of words and
/// end.
NumberTable titled_rows(std::vector<Line> lines, std::size_t first, char separator);

/// Takes for rows those directly above the first one that have words only where the rows have nothing, as next to the
/// results of an instrument.
void take_rows_above(NumberTable& table);

/// Takes away the bars at both ends of lines, and the lines that draw the frame of a table, as Markdown has them.
void drop_frame(std::vector<Line>& lines);

}  // namespace fstiff::inline v0_1::io::detail
