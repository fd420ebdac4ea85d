// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Columns of a profile with the positions and the heights.
///
/// Columns that number the points or hold words (io/column_titles.hpp) are neither, unless they are chosen. Of what is
/// left, one column holds heights, two hold positions and heights, in this order unless their titles name the other.
/// Of more, those that hold one number throughout, or that their titles name otherwise, are left out; what is still
/// more needs a choice.
///
/// Units       columns counted from 1

#include "io/column_titles.hpp"

namespace fstiff::inline v0_1::io::detail {

/// The columns that were given.
struct ColumnChoice {
    std::size_t column = 0, x_column = 0;  // of heights and positions; 0: to be found
    bool spacing = false;                  // is given: positions are not used
    OptionNames names{};
};

struct ProfileColumns {
    std::size_t heights{}, positions{};  // positions whether used or not; 0: none
    std::vector<bool> index;             // number the points; by column
    std::vector<bool> unused;            // hold words, one number throughout, or what their titles name

    /// The first column that numbers the points; 0: none.
    std::size_t first_index() const {
        return static_cast<std::size_t>(std::find(index.begin(), index.end(), true) - index.begin() + 1) %
               (index.size() + 1);
    }
    /// "; column 1 numbers the points; column 4 not used"; words apart, which NumberTable::say_layout() has.
    std::string left_out(const NumberTable& table) const;
    /// The units that titles state of the heights and, where \p with_positions, of the positions.
    TitleUnits units(const NumberTable& table, bool with_positions) const {
        FreeColumns free(table.columns);
        for (std::size_t c = 1; c <= table.columns; ++c)
            free[c - 1] = index[c - 1] || unused[c - 1] ||
                          (c != heights && !(with_positions && c == positions) && table.dialect.separator != ' ');
        if (std::count(free.begin(), free.end(), true) == 0) free.clear();
        return title_units(table, table.columns, free);
    }
};

/// That positions must rise, and the way out where the heights of \p table do, in the columns \p heights and
/// \p positions.
std::string must_rise(const NumberTable& table, std::size_t heights, std::size_t positions, const OptionNames& names);

/// The columns of \p table, whose rows are read. \throws domain_error naming the file \p name.
ProfileColumns profile_columns(const NumberTable& table, const std::string& name, const ColumnChoice& choice);

}  // namespace fstiff::inline v0_1::io::detail
