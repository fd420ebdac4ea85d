// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The axes of a matrix of text whose first row and first column are positions, as Excel and MATLAB write them.
///
///     y\x [um];0;0,5;1           positions after a word, or after a number or an empty cell in the first
///     0;0,12;0,31;0,25           of the table; both axes rise, or fall, in equal steps
///     0,5;0,22;0,07;0,19
///
/// A matrix has axes where a word is in the corner and two positions at least are on each of them; three where the
/// corner is empty, four where it is a number. Below a word, 1, 2, 3 ... along x alone may number profiles: they are an
/// axis where the corner names both ("y\x", "y/x").
///
/// Units       those of the file
/// Accuracy    positions are equally spaced to within their last printed digit (tests/io/matrix_axes_test.cpp)

#include "io/column_titles.hpp"
#include "io/regular_grid.hpp"

namespace fstiff::inline v0_1::io::detail {

struct MatrixAxes {
    double dx{}, dy{};                  // steps in the unit of the axes
    bool in_table{};                    // the positions along x are the first row of the table
    bool counted{};                     // both count from 0 or 1: they may number the points
    std::size_t line{};                 // of the positions along x
    std::vector<std::string> stated{};  // units of length in the corner, each once
};

/// The equal step of \p positions; 0 where they neither rise nor fall in equal steps.
double equal_step(const std::vector<double>& positions, double printed);

/// The axes of \p table, whose rows are read; none where it has none.
std::optional<MatrixAxes> axes_of(const NumberTable& table);

/// Takes the first row out of \p table, which holds an axis.
void drop_first_row(NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
