// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The regular grid on which the x and y of triples lie.
///
/// Units       as in the table
/// Accuracy    positions are on the grid to within their last printed digit (tests/io/map_text_test.cpp)

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Equally spaced positions, some of which may be missing.
struct GridAxis {
    double origin{}, step{};
    std::size_t count{};
    std::size_t index(double position) const {
        return static_cast<std::size_t>((std::max)(0.0, std::round((position - origin) / step)));
    }
};

/// The axis on which \p positions lie to within their last printed digit; none when there is none.
std::optional<GridAxis> axis_of(std::vector<double> positions, double printed);

struct Grid {
    GridAxis x, y;
};

/// The grid of the first two columns; none when there is none, or hardly any of its points is there.
std::optional<Grid> grid_of(const NumberTable& table);

/// How many points of \p grid \p table holds, each counted once; 0 where one comes twice.
std::size_t points_on(const Grid& grid, const NumberTable& table);

/// The third column of \p table at the points of \p grid, row after row; NaN where there is no row.
/// \throws domain_error when two rows are of one point.
std::vector<double> heights_on(const Grid& grid, const NumberTable& table, const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
