// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Refusals of rows in which a comma, a point or a blank may do two things: separate columns, thousands or decimals.
///
/// Each names the line, what may be meant and the option that decides; a row with one reading passes.

#include "io/column_titles.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Whether \p cell is a number with points and commas, as 1.000,5 or 1,000.5 is.
bool has_both_signs(std::string_view cell);

/// Refuses \p cell, which is no number where the decimal sign is the comma, or the point.
[[noreturn]] void refuse_sign(const NumberTable& table, const std::string& name, std::size_t line,
                              std::string_view cell, bool comma);

/// Refuses a line that would be a row of numbers but for separators of thousands: as a header, it would be lost.
void refuse_grouped_row(const NumberTable& table, const std::string& name, const Line& line);

/// Refuses a row of \p dialect such as "15 937,17 417", whose blanks separate columns or thousands.
void refuse_blank_groups(const NumberTable& table, const std::string& name, const Line& line, Dialect dialect);

/// For the message of columns between commas where no row holds a point: the comma may be decimal too.
std::string without_points(const NumberTable& table);

/// Refuses rows such as "0,5,-9,8351", whose comma separates columns and is decimal: every second cell has digits
/// alone, as fractions have, some with a zero before others, as whole numbers do not, or all with an exponent; or every
/// second comma alone has a blank after it; or the first two cells of 16 rows and more, as one number, rise in equal
/// steps; or the cells are more than the titles above, as in "P0,4805,3".
void refuse_double_comma(const NumberTable& table, const std::string& name);

/// Refuses rows such as "1 003,5" and "0,1,012", where what separates columns may separate thousands: in each, three
/// digits, in some with a zero before others, follow a whole number of one to three digits.
void refuse_split_thousands(const NumberTable& table, const std::string& name);

/// Refuses \p columns of \p table, counted from 0 in the file, whose comma or point may separate thousands
/// (io/column_signs.hpp): each by itself, or \p together, as in a matrix. Nothing is refused where an option settled
/// it.
void refuse_thousands(const NumberTable& table, const std::vector<std::size_t>& columns, bool together,
                      const std::string& name);

/// In "0,12" the comma may separate two columns, be decimal, or separate thousands. It separates columns, unless no
/// row holds a point and the columns that it would separate could not be equally spaced positions and heights.
void settle_lone_commas(NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
