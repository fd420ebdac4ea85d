// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Separators of thousands in the numbers of a text: those that an option names are removed before anything is read,
/// others are refused with that option.
///
///     1,234,567   1.234,5   1'003   1 234,5       one to three digits without a leading zero, then groups of three
///
/// "1,003" is a decimal number as well. It is taken for one unless other cells of the column are whole numbers as the
/// thousands would leave them ("986"): a program that prints decimals prints them in every cell, or drops zeros at the
/// end, which leaves one or two digits in a tenth of the cells.
///
/// Valid       blanks of Unicode and of CP1252 count as blanks, the typographic apostrophe as an apostrophe
/// Accuracy    none: characters (tests/io/thousands_test.cpp)

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

/// \p text without the separators of thousands that \p given names: "," "." "'" or " "; as it is for "" and "none".
/// \throws domain_error for another name, and for a row of numbers in which that character does something else too.
std::string without_thousands(std::string text, const std::string& given, const std::string& name);

/// Refuses \p columns of \p table, counted from 0 in the file, whose comma or point may separate thousands: each by
/// itself, or \p together, as in a matrix. Nothing is refused where an option settled it.
/// \throws domain_error naming two cells and the option.
void refuse_thousands(const NumberTable& table, const std::vector<std::size_t>& columns, bool together,
                      const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
