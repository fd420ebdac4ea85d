// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Rows of numbers below a header, the table that the readers of text share.
///
/// A text is cut into lines once (lines_of), its table opened once (io/row_layout.hpp: which lines are rows, how they
/// are written), and its numbers parsed once (read_rows), with what their signs show.
///
/// Valid       lines up to 2^20 characters, files up to 2^31 bytes
/// Accuracy    numbers are correctly rounded

#include "io/cells.hpp"
#include "io/column_signs.hpp"
#include "io/missing_values.hpp"
#include "io/reading.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Whether empty cells at the end of a row may be left out, with their separators.
enum class RowEnds { whole, may_be_short };

/// Columns of a table with short rows, which would take memory that the text does not.
inline constexpr std::size_t max_short_row_columns = max_profile_columns;

/// Rows of numbers below a header. Views point into the text, which must outlive them.
struct NumberTable {
    std::vector<Line> lines;
    std::size_t first{};         // of `lines`: the first row
    std::size_t counted{};       // of `lines`, counted from 1: that of the header which holds the number of rows alone
    std::size_t before{};        // lines of the file above the header, which are of another table
    std::vector<Line> footer{};  // lines after the rows, which are none
    std::vector<bool> words{};   // whether a column holds words; empty where none does
    Dialect dialect{};
    std::size_t columns{};
    std::vector<double> values{};  // by row; NaN where missing
    std::vector<std::size_t> row_lines{};
    std::vector<PrintedDigits> printed{};  // of all columns where rows may be short, else of the first 16
    std::vector<LoneWhole> wholes{};       // of all columns
    std::vector<ColumnSigns> signs{};      // of all columns, where no option settles them
    MissingValues missing{};               // in addition to the words that are always missing
    OptionNames names{};                   // for messages
    std::string thousands{};               // the option

    std::size_t rows() const { return row_lines.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }

    bool holds_words(std::size_t column) const { return column < words.size() && words[column]; }

    /// Leaves the table as it was opened.
    void forget_rows();

    /// Describes in one line what its columns are read as, \p roles, its separators, which one column lacks where
    /// \p may_be_one, and what is not used; then its header.
    void say_layout(Record& record, std::string roles, bool may_be_one = false) const;

private:
    /// "; columns 1, 4 of words not used; 2 lines after the rows not used ("EOF")"; empty where all is used.
    std::string unused() const;

    /// Lines at the end of the header that are cut into as many cells as the rows, some of them numbers.
    std::size_t rows_with_words() const;
};

/// Cells of the first row up to the last that is not empty.
std::size_t written_columns(const NumberTable& table);

/// Whether column \p c has words but no number from the first row on.
bool is_text_column(const NumberTable& table, std::size_t c);

/// Reads the rows of a table that open_table() has opened.
void read_rows(NumberTable& table, const std::string& name, RowEnds ends = RowEnds::whole);

}  // namespace fstiff::inline v0_1::io::detail
