// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The regular grid on which the x and y of triples lie.
///
/// Units       as in the table
/// Accuracy    positions are on the grid to within their last printed digit (tests/io/map_text_test.cpp)

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

/// The numbers of column \p c of \p table, counted from 0.
std::vector<double> column_of(const NumberTable& table, std::size_t c);

/// The weight of the last digit to which column \p c is printed; 0 where it is not known.
double printed_step(const NumberTable& table, std::size_t c);

/// Equally spaced positions, some of which may be missing.
struct GridAxis {
    double origin{}, step{};
    std::size_t count{};
    /// The nearest one.
    std::size_t index(double position) const {
        return (std::min)(static_cast<std::size_t>((std::max)(0.0, std::round((position - origin) / step))), count - 1);
    }
};

/// The axis on which \p positions lie to within their last printed digit; none when there is none.
std::optional<GridAxis> axis_of(const std::vector<double>& positions, double printed);

struct Grid {
    GridAxis x, y;
    std::size_t x_column = 0, y_column = 1;  // of the table, counted from 0

    std::size_t size() const { return x.count * y.count; }
    /// The point of row \p r of \p table, row after row of the grid.
    std::size_t point(const NumberTable& table, std::size_t r) const {
        return y.index(table.at(r, y_column)) * x.count + x.index(table.at(r, x_column));
    }
};

/// The grid of two columns of \p table; none when there is none, or hardly any of its points is there.
std::optional<Grid> grid_of(const NumberTable& table, std::size_t x_column = 0, std::size_t y_column = 1);

/// How many points of \p grid \p table holds, each counted once; 0 where one comes twice.
std::size_t points_on(const Grid& grid, const NumberTable& table);

/// The \p heights of the rows of \p table at the points of \p grid; NaN where there is no row.
/// \throws domain_error when two rows are of one point.
std::vector<double> heights_on(const Grid& grid, const NumberTable& table, const std::vector<double>& heights,
                               const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
