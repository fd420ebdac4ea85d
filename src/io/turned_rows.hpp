// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Rows that are meant as columns: one of heights, or positions above heights, as programs of arrays write them.
///
/// Accuracy    none: lines (tests/io/row_layout_test.cpp)

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

/// One or two rows of a table as the columns of a text, below its header.
struct TurnedRows {
    std::string text;
    std::size_t rows{};
};
/// Those of \p table where it has one row of heights, or a row of positions in equal steps above a row of heights; none
/// for other tables.
std::optional<TurnedRows> turned_rows(const NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
