// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Columns of words next to columns of numbers.
///
///     P1;2024-05-03 12:00:01;0.0;1.25;ok        names, times and marks of quality
///     P2;2024-05-03 12:00:02;0.5;1.31;ok
///
/// A column holds words where no row has a number in it. They are sought where a line among the rows is no row of
/// numbers: of all separators the one counts that gives the most numbers.
///
/// Accuracy    none: words (tests/io/row_layout_test.cpp)

#include "io/number_table.hpp"

#include <span>

namespace fstiff::inline v0_1::io::detail {

/// Whether \p cell begins with a digit, signs apart.
bool begins_with_number(std::string_view cell);

/// Whether \p line holds digits, signs and separators alone, so that it need not be cut into cells.
bool is_plain(std::string_view line);

/// Whether a line of cells is a row of \p table: numbers, missing points, and words where its columns hold words.
bool is_row_of(const NumberTable& table, const std::vector<std::string_view>& cells);

/// Whether a number of \p rows has a point.
bool has_points(std::span<const Line> rows, char separator);

/// Whether each of the \p columns holds more words than numbers in the \p lines with that many cells, one a number.
std::vector<bool> words_in(std::span<const Line> lines, char separator, std::size_t columns);

/// Finds the columns of words, where the lines are no rows of numbers alone, and the first row.
/// \throws domain_error where a comma may be decimal or separate the columns
void find_words(NumberTable& table, const std::string& name);

/// Refuses a table without rows of numbers whose cells are numbers with their units.
void refuse_units_in_cells(const NumberTable& table, const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
