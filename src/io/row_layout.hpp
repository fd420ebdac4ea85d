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

/// Finds the columns of words of \p table, where its lines are no rows of numbers alone, and its first row.
void find_words(NumberTable& table);

/// Refuses a table without rows of numbers whose cells are numbers with their units.
void refuse_units_in_cells(const NumberTable& table, const std::string& name);

/// Moves the lines after the last row to NumberTable::footer.
void drop_footer(NumberTable& table);

/// Takes away the bars at both ends of lines, and the lines that draw the frame of a table, as Markdown has them.
void drop_frame(std::vector<Line>& lines);

/// The rows of \p table as columns, below its header, where it has one row of heights, or a row of positions in equal
/// steps above a row of heights; none for other tables.
std::optional<std::string> turned_rows(const NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
