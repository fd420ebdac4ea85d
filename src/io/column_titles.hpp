// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Titles above the columns of a text, and the units that they state.
///
/// Units       lengths by the names of their units
/// Accuracy    none: words (tests/io/stated_units_test.cpp)

#include "io/column_words.hpp"
#include "io/number_table.hpp"

#include <fstiff/io/units.hpp>

namespace fstiff::inline v0_1::io::detail {

/// A pair of brackets in a text, and the trimmed words inside.
struct Bracket {
    char sign{};
    std::string_view inside;
    std::size_t begin{}, end{};  // of the text, end after the closing one

    /// Whether it holds a unit of length. "(0.1 mm)" may be a length: a number belongs to a unit in square brackets, or
    /// in a power of ten.
    bool states_unit() const;
};
std::vector<Bracket> brackets_in(std::string_view text);

/// What a column title states of a unit; views into the title, empty for none.
struct TitleUnit {
    std::string_view length;  // as in "x [um]", "x (um)", "x/um", "height in um", "um"
    /// What is in place of a unit but is not understood: "raw" of "z [raw]", "[um] (x100)" of a unit with a factor, two
    /// units that contradict each other.
    std::string_view unread;
    bool scaled{};  // a factor is next to a unit of length
};
TitleUnit unit_of_title(std::string_view title);
/// The unit of length alone.
std::string_view title_unit(std::string_view title);

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

/// Title above one column, of up to two lines; without text where there is none.
struct ColumnTitle {
    std::string name{};                 // lower case, without unit and punctuation; "#" stays
    std::string_view unit{}, unread{};  // as of TitleUnit
    std::string_view no_length{};       // a unit of something else, as of "Slope (urad)"
    std::string text{};  // as written; all there is where not the separator of the table cuts the line into titles
    std::size_t line{};
};

ColumnTitle title_of(std::string_view cell);

/// The titles above the columns of \p table, of the nearest two lines of the header with a word for some and no number
/// for any.
std::vector<ColumnTitle> titles_above(const NumberTable& table);

/// Whether the title \p cell has a unit, or a word for what a column holds (io/column_words.hpp).
bool names_something(std::string_view cell);

/// The cells of the line above the row \p first of \p lines, between \p separator; none where there is none.
std::vector<std::string_view> cells_above(const std::vector<Line>& lines, std::size_t first, char separator);

/// Whether that line may have a title for each of \p columns: none begins with a digit.
bool has_titles(const std::vector<Line>& lines, std::size_t first, char separator, std::size_t columns);

/// Whether one of \p titles has a name.
bool is_titled(const std::vector<ColumnTitle>& titles);

/// The titles in \p line; between blanks a unit in brackets belongs to the word before it.
void split_titles(std::string_view line, char separator, std::vector<std::string_view>& cells);

}  // namespace fstiff::inline v0_1::io::detail
