// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The table of a map of text: its rows, the columns that are used, its axes and its grid.
///
/// Columns that number the points are dropped (io/column_titles.hpp). Four columns and more begin with x, y and z where
/// the first two are called so, or form a grid of which more than half is there, each point once.
///
/// Units       those of the file

#include "io/given_lengths.hpp"
#include "io/gridded.hpp"
#include "io/height_sense.hpp"
#include "io/matrix_axes.hpp"
#include "io/regular_grid.hpp"
#include "io/zygo_xyz.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Each step is done once. The text must outlive it.
class MapTable {
public:
    MapTable(NumberTable table, std::string name)
        : name_(std::move(name)), table_(std::move(table)), entries_(header_entries(table_, true)) {}

    /// The columns of the first row; of all rows once they are read.
    const NumberTable& opened() const { return table_; }
    const std::vector<HeaderEntry>& entries() const { return entries_; }
    /// Reads the rows, once. Columns that number the points are dropped.
    const NumberTable& table(std::string_view missing = {});
    static constexpr const char* axes_from = "positions in the first row and the first column";
    /// The axes that the first row and the first column are, once the rows are read.
    const std::optional<MatrixAxes>& axes() const { return axes_; }
    bool is_zygo() const { return table_.lines.front().text.starts_with(zygo_xyz_begin); }
    /// Whether the rows, of four columns or more, begin with x, y and z.
    bool begins_with_triples();
    /// Whether words are above the columns.
    bool is_titled() const {
        return std::any_of(titles_.begin(), titles_.end(),
                           [](const ColumnTitle& title) { return !title.name.empty(); });
    }
    /// Columns that may hold positions and heights (io/column_titles.hpp), where titles or numbers rule others out.
    std::size_t columns_of_lengths();
    /// Whether the titles of x and y name pixels, "col" and "row", whose size is not in the table.
    bool counts_pixels();
    /// Why begins_with_triples().
    std::string triples_from();
    /// Refuses a matrix whose size the header does not state and whose first row or column is positions, the other not.
    void require_no_lone_axis(const OptionNames& names) const;
    /// The grid of the first two columns, sought once.
    const std::optional<Grid>& grid();
    /// The table as it was opened.
    NumberTable unread() &&;

protected:
    /// Whether the header counts the columns of the whole table, or states a size of it.
    bool states_other_count() const;

    /// Puts x, y and z first where their titles name them in another order.
    void order_columns();

    /// Leaves the columns \p kept, counted from 0.
    void keep_columns(const std::vector<std::size_t>& kept);

    /// The column of z, counted from 0, where there are more than three: the one of that title, or the only one beyond
    /// x and y with a unit of length, or the third.
    std::size_t height_column() const;

    /// The first three columns as points.
    PointCloud cloud(const std::array<double, 3>& units, const std::array<std::string, 3>& unit_names) const;

    std::string name_;
    NumberTable table_;
    std::vector<HeaderEntry> entries_;
    std::optional<std::optional<Grid>> grid_;  // empty until it is sought
    std::optional<MatrixAxes> axes_;
    std::vector<ColumnTitle> titles_;    // of all columns of the file
    std::vector<WrittenTitle> written_;  // the same as written
    std::vector<std::size_t> columns_;   // of the file, counted from 1, that the table holds
};

}  // namespace fstiff::inline v0_1::io::detail
