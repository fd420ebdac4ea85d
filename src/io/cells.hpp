// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The cells of a line of text, and how one line reads as a row of numbers.
///
/// Accuracy    none: characters (tests/io/number_table_test.cpp)

#include "io/number.hpp"

#include <vector>

namespace fstiff::inline v0_1::io::detail {

/// How the numbers of a row are written.
struct Dialect {
    char separator = ' ';  // ' ' is any run of blanks and tabs, else one of ; , | and the tab
    bool decimal_comma = false;
};

std::string_view unquoted(std::string_view cell);

/// The cells of a line, empty ones included except at its end; a separator between quotes is none.
void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// The cells of a line, empty ones at its end included.
void split_row(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// \p line up to a "#" that is glued neither to a number nor to a word for a missing point, as in 1.#IND and #N/A.
std::string_view without_comment(std::string_view line);

/// How \p line reads as a row of numbers and missing points; none when it does not.
std::optional<Dialect> dialect_of(std::string_view line);

bool is_comment(std::string_view line);

}  // namespace fstiff::inline v0_1::io::detail
