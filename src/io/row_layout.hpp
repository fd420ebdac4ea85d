// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Lines of a text that hold more than numbers: columns of words next to columns of numbers, and lines after the rows.
///
///     P1;2024-05-03 12:00:01;0.0;1.25;ok        names, times and marks of quality: columns of words
///     P2;2024-05-03 12:00:02;0.5;1.31;ok
///     Mean;;;1.28;                              a result, no row
///     EOF                                       no row
///
/// A column holds words where no row has a number in it. All lines from the first row to the last must be rows or
/// comments: a word among the numbers of a column is refused, since it may mark a missing point. A line after the
/// rows that begins with a number is refused too, and one that states a unit or a size.
///
/// Accuracy    none: words (tests/io/row_layout_test.cpp)

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Whether a line of cells is a row of \p table: numbers, missing points, and words where its columns hold words.
bool is_row_of(const NumberTable& table, const std::vector<std::string_view>& cells);

/// Finds the rows of a text, their separator and decimal sign, and the columns of words; \p before: lines of the file
/// above it. \throws domain_error when no line is a row of numbers.
NumberTable open_table(std::vector<Line> lines, const std::string& name, const SurfaceOptions& options = {},
                       std::size_t before = 0);
NumberTable open_table(std::string_view text, const std::string& name);

/// Takes for rows those directly above the first one that have words only where the rows have nothing, as next to the
/// results of an instrument.
void take_rows_above(NumberTable& table);

/// Takes away the bars at both ends of lines, and the lines that draw the frame of a table, as Markdown has them.
void drop_frame(std::vector<Line>& lines);

/// One or two rows of a table as the columns of a text, below its header.
struct TurnedRows {
    std::string text;
    std::size_t rows{};
};
/// Those of \p table where it has one row of heights, or a row of positions in equal steps above a row of heights; none
/// for other tables.
std::optional<TurnedRows> turned_rows(const NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
