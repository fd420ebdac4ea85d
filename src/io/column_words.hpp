// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Words above the columns of a text, in the languages of instruments: what a column holds by its name. Names are those
/// of ColumnTitle: lower case, without unit.
///
/// Accuracy    none: words (tests/io/roles_test.cpp, row_layout_test.cpp)

#include <string_view>

namespace fstiff::inline v0_1::io::detail {

/// Whether a column called \p name numbers the points.
bool names_index(std::string_view name);

/// Whether it holds positions along x.
bool names_position(std::string_view name);

/// Whether it holds heights.
bool names_height(std::string_view name);

/// Whether it holds neither, as time and intensity.
bool names_neither(std::string_view name);

/// Whether it holds the errors of another.
bool names_error(std::string_view name);

/// Whether it counts pixels.
bool names_pixel(std::string_view name);

}  // namespace fstiff::inline v0_1::io::detail
