// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Titles above the columns of a text: the units they state, and which column numbers the points.
///
/// A column numbers the points by its title ("Nr.", "No.", "#", "Index", "Point") and its numbers are whole
/// and rise; or where it is the first, counts 0, 1, 2 ... or 1, 2, 3 ... under a title that names no length, and
/// another column states a unit of length or names a length. One that states a unit of length is none.
///
/// Units       lengths by the names of their units
/// Accuracy    none: words (tests/io/column_titles_test.cpp)

#include "io/column_words.hpp"
#include "io/number_table.hpp"

#include <fstiff/io/units.hpp>

namespace fstiff::inline v0_1::io::detail {

/// The length unit that a column title states, as in "x [um]", "x (um)", "x/um", "height in um", "um"; "" for none.
std::string_view title_unit(std::string_view title);

/// What \p title states in place of a unit that is understood: "raw" of "z [raw]", "[um] (x100)" of a unit with a
/// factor, two units that contradict each other; empty where there is nothing.
std::string_view unread_unit(std::string_view title);

/// Whether each column may do without a unit; empty: none may.
using FreeColumns = std::vector<bool>;

/// \p line without the signs of a comment before it.
std::string_view without_comment_sign(std::string_view line, char separator);

/// The units of \p columns columns that \p line states, empty for \p free ones without; none when it does not state
/// them all. Free columns need titles that the separator of the table separates.
std::vector<std::string_view> units_in(std::string_view line, std::size_t columns, char separator,
                                       const FreeColumns& free = {});
/// The units of the options: "um,nm" or "um". \throws domain_error for more than \p most of them, or another unit.
std::vector<std::string_view> given_units(const std::string& text, std::size_t most, const std::string& name,
                                          std::string_view allowed);

/// Titles above the columns, from the first row upwards, that state the units of all of them but \p free ones.
struct TitleUnits {
    std::vector<std::string_view> units;  // empty when there are none
    std::string from;                     // "line 3"
};
TitleUnits title_units(const NumberTable& table, std::size_t columns, const FreeColumns& free = {});

/// Title above one column.
struct ColumnTitle {
    std::string name;              // lower case, without unit and punctuation; "#" stays
    bool has_unit{};               // of length
    std::string unit{}, unread{};  // that unit, and what is in its place but is not understood
    std::string no_length{};       // its unit where that is of something else, as of "Slope (urad)"
    std::size_t line{};
};

ColumnTitle title_of(std::string_view cell);

/// Refuses a column, counted from 1, whose title states a unit that is of no length.
void refuse_no_length(const std::vector<ColumnTitle>& titles, std::size_t column, const std::string& name);

/// The titles above the columns of \p table, of the nearest two lines of the header with a word for some and no number
/// for any; none where there are none.
std::vector<ColumnTitle> titles_above(const NumberTable& table);

/// The titles in \p line; between blanks a unit in brackets belongs to the word before it.
void split_titles(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Whether \p line is a key and a number, as "Pitch [um]: 0.5" is, and no title of one column.
bool is_key_and_number(std::string_view line);

/// Whether \p cells, of a \p line above the rows of \p table, may be titles of its columns; \p above another such line,
/// where it may be a key and its value, "Objective:;20X".
bool may_be_titles(const NumberTable& table, std::string_view line, const std::vector<std::string_view>& cells,
                   bool above);

/// Whether column \p c of the rows counts: whole numbers that rise, and \p from_start, by one from 0 or 1.
bool counts_points(const NumberTable& table, std::size_t c, bool from_start);

/// Columns of \p table, whose rows are read, that hold neither positions nor heights: of one number throughout, or by
/// their \p titles, such as "Time" and "Intensity" without a unit of length.
std::vector<bool> spare_columns(const NumberTable& table, const std::vector<ColumnTitle>& titles);

/// Whether the \p first title may be of heights and the \p second of positions.
bool may_be_exchanged(const ColumnTitle& first, const ColumnTitle& second);

/// Columns of \p table, whose rows are read, that number its points or hold words; empty where none does.
std::vector<bool> index_columns(const NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
