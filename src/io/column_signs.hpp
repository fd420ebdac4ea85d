// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What the cells of one column show of the signs in their numbers: whether a comma, a point or a blank may separate
/// thousands. Gathered while the rows are read.
///
///     1,234,567   1.234,5   1'003   1 234,5       one to three digits without a leading zero, then groups of three
///
/// "1,003" is a decimal number as well. It is taken for one unless other cells of the column are whole numbers as the
/// thousands would leave them ("986"): a program that prints decimals prints them in every cell, or drops zeros at the
/// end, which leaves one or two digits in a tenth of the cells.
///
/// Accuracy    none: characters (tests/io/thousands_test.cpp)

#include "io/number.hpp"

namespace fstiff::inline v0_1::io::detail {

class ColumnSigns {
public:
    /// \p value is what fills \p cell in \p line; \p sign is decimal, or separates thousands.
    void add(std::string_view cell, double value, std::size_t line, std::string_view sign);
    /// In its row, \p cell follows \p before and \p separator.
    void add_pair(std::string_view before, std::string_view cell, char separator, std::size_t line);
    /// Those of another column, for one decision about both.
    void add(const ColumnSigns& other);

    /// Whether a cell shows that the sign is decimal, so that no other matters.
    [[nodiscard]] bool are_decimal() const { return decimal_; }
    /// Whether the fractions may be thousands: next to them are whole numbers below them all. \p known: the sign is
    /// decimal elsewhere in the file, or the point, which is decimal as a rule. Then whole numbers among few fractions,
    /// and zeros, may be what they are, unless they are far above the fractions.
    [[nodiscard]] bool may_be_thousands(bool known) const;
    /// The line of a cell such as "012" where each cell of the column may be the last three digits of a number that the
    /// column before begins; 0 where they are none.
    [[nodiscard]] std::size_t split_line() const { return pairs_ ? zero_line_ : 0; }

    struct Place {
        std::string cell;
        std::size_t line{};
    };
    /// The first cells like 1,003 and like 986.
    [[nodiscard]] const Place& grouped() const { return grouped_; }
    [[nodiscard]] const Place& whole() const { return whole_; }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    bool decimal_ = false, pairs_ = true;
    std::size_t groups_{}, wholes_{}, zero_line_{};
    double largest_group_{}, smallest_group_ = infinite, largest_whole_{}, sum_of_whole_{};
    Place grouped_, whole_;
};

}  // namespace fstiff::inline v0_1::io::detail
