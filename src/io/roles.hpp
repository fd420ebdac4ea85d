// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What a table of text is, and what its columns are: decided here alone, by options, titles and numbers.
///
/// A column numbers the points by its title ("Nr.", "No.", "#", "Index", "Point") and its numbers are whole
/// and rise; or where it is the first, counts 0, 1, 2 ... or 1, 2, 3 ... under a title that names no length, and
/// another column states a unit of length or names a length. One that states a unit of length is none.
///
///     profile    of the columns that neither number the points nor hold words, one holds heights, two hold positions
///                and heights, in this order unless titles name the other. Of more, those of one number throughout and
///                of other titles, such as "Time", are left out; what is still more needs SurfaceOptions::column
///     triples    x, y and heights: three columns that form a grid, or the first two and that of heights of four and
///                more which are called so, or form a grid of which more than half is there, each point once
///     matrix     heights, and positions as its first row and column (io/matrix_axes.hpp)
///
/// A form that the numbers leave open is refused with the options that decide.
///
/// Units       those of the file; columns counted from 0
/// Accuracy    none: words and numbers (tests/io/roles_test.cpp, surface_file_test.cpp)

#include "io/header.hpp"
#include "io/matrix_axes.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Role of a column: x of a profile are its positions, also where the options replace them.
enum class Role { open, x, y, heights, axis, index, words, unused };

/// A table of text whose rows are read; its text must outlive it.
struct TextTable {
    SurfaceFormat form{};   // profile, triples or matrix
    std::string form_from;  // for the record
    NumberTable numbers;
    std::vector<HeaderEntry> entries;  // of the header
    std::vector<ColumnTitle> titles;   // of all columns
    std::vector<Role> roles;           // of all columns; one holds the heights, or all of a matrix
    std::optional<Grid> grid;          // of the x and y of triples
    bool counts_pixels{};              // they are numbers of pixels, whose size is not in the table
    std::optional<MatrixAxes> axes;    // of a matrix

    std::vector<std::size_t> columns(Role role) const;
    /// The first column of that role.
    std::optional<std::size_t> column(Role role) const;
    bool is_zygo() const;
    /// The heights as numbers of the file, row after row; NaN where they are missing. A matrix is moved out, and has no
    /// other columns from then on.
    /// \p unit is theirs, for messages. \throws domain_error for a number that may mark missing points.
    std::vector<double> take_heights(const std::string& name, const std::string& unit);
    /// The step in which they are printed, of the first columns.
    double resolution() const;
};

/// The table that open_table() has \p opened as \p form, which is found where it is automatic; its rows are read.
/// \throws domain_error naming the file \p name, for what is ambiguous, too.
TextTable text_table(NumberTable opened, SurfaceFormat form, const std::string& name, const SurfaceOptions& options);

/// The columns that hold words or number the points; the others are open.
std::vector<Role> first_roles(const NumberTable& table, const std::vector<ColumnTitle>& titles);

/// Whether column \p c of \p table rises or falls in equal steps, as positions do.
bool rises_evenly(const NumberTable& table, std::size_t c);

}  // namespace fstiff::inline v0_1::io::detail
