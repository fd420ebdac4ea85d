// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Rows of numbers below a header: separators, cells, and the table that the readers of text share. But for TextRecord all
/// of it is internal.
///
/// A text is cut into lines once (lines_of), its table opened once (open_table: where the header ends, which separators),
/// and its numbers parsed once (read_rows).
///
/// Valid       lines up to 2^20 characters, files up to 2^31 bytes
/// Accuracy    numbers are correctly rounded

#include "io/missing_values.hpp"

#include <Eigen/Core>

namespace fstiff::io {

/// What was decided about any delimited text, and why.
struct TextRecord {
    std::string name;
    std::string separator;  ///< "comma", "semicolon", "tab", "blanks" or, of one column, "none"
    bool decimal_comma{};
    std::size_t lines{};
    std::size_t header_lines{};  ///< before the first row of numbers, blank lines and comments included
    std::string units_from;      ///< "line 28" or "options"
    std::size_t missing{};
    std::string missing_from;  ///< "-9999, from line 6": the number that stands for missing points, where one is stated
    double resolution{};       ///< step in which the heights are printed [m]; 0 where it is not known
    std::vector<std::string> warnings;  ///< options that contradict the file, and what was assumed of it

protected:
    /// The separators and the header as sentences.
    [[nodiscard]] std::vector<std::string> layout_sentences() const {
        return {"separator: " + separator + ", decimal " + (decimal_comma ? "comma" : "point"),
                "header: " + std::to_string(header_lines) + (header_lines == 1 ? " line" : " lines")};
    }
    /// How many of \p points are missing, and what stands for them.
    [[nodiscard]] std::string points_sentence(const std::string& points) const {
        return "points: " + points + ", of which " + std::to_string(missing) + " missing" +
               (missing_from.empty() ? "" : " (" + missing_from + ")");
    }
};

namespace detail {

struct Dialect {
    char separator = ' ';  // ' ' stands for any run of blanks and tabs
    bool decimal_comma = false;
};

std::string_view unquoted(std::string_view cell);

std::string separator_name(char separator);

/// The cells of a line, empty ones included except at its end.
void split_line(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// The cells of a line, empty ones at its end included.
void split_row(std::string_view line, char separator, std::vector<std::string_view>& cells);

std::string_view without_comment(std::string_view line);

bool is_comment(std::string_view line);

/// What the rows of a table may look like.
struct TableRules {
    std::string_view holds;   ///< what must be there, for messages
    bool short_rows = false;  ///< empty cells at the end of a row may be left out, with their separators
};

/// Columns of a table with short rows, which would take memory that the text does not.
inline constexpr std::size_t max_short_row_columns = max_profile_columns;

/// The numbers of a table, one behind the other, which a map may take over without a copy.
class TableNumbers {
public:
    using Array = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    std::size_t size() const { return size_; }
    double* data() { return numbers_.data(); }
    const double* begin() const { return numbers_.data(); }
    const double* end() const { return begin() + size_; }
    double& operator[](std::size_t i) { return numbers_.data()[i]; }
    double operator[](std::size_t i) const { return numbers_.data()[i]; }

    void reserve(std::size_t capacity) {
        if (capacity > static_cast<std::size_t>(numbers_.size()))
            numbers_.conservativeResize(1, static_cast<Eigen::Index>(capacity));
    }
    void push_back(double number) {
        if (size_ == static_cast<std::size_t>(numbers_.size())) reserve(2 * size_ + 16);
        numbers_.data()[size_++] = number;
    }
    void resize(std::size_t size, double number = 0) {
        reserve(size);
        for (; size_ < size; ++size_) numbers_.data()[size_] = number;
        size_ = size;
    }
    /// All of them as \p rows x \p columns, whose product is size(); nothing is left here.
    Array take(std::size_t rows, std::size_t columns) {
        numbers_.conservativeResize(1, static_cast<Eigen::Index>(size_));
        numbers_.resize(static_cast<Eigen::Index>(rows),
                        static_cast<Eigen::Index>(columns));  // of the same size: it stays
        size_ = 0;
        return std::move(numbers_);
    }

private:
    Array numbers_{1, 0};  // with room behind the last
    std::size_t size_ = 0;
};

/// Rows of numbers below a header. Views point into the text, which must outlive them.
struct NumberTable {
    std::vector<Line> lines;
    std::size_t line_count{};
    std::size_t first{};  // of `lines`: the first row
    Dialect dialect;
    std::size_t columns{};
    TableNumbers values;  // by row; NaN where missing
    std::vector<std::size_t> row_lines;
    std::vector<PrintedDigits> printed;  // of all columns where rows may be short, else of the first 16
    MissingValues missing;               // beside the words that are always missing

    std::size_t rows() const { return row_lines.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }

    /// What the table knows of a record.
    void describe(TextRecord& record) const {
        record.separator = separator_name(dialect.separator);
        record.decimal_comma = dialect.decimal_comma;
        record.lines = line_count;
        record.header_lines = lines[first].number - 1;
    }
};

/// The first words of Zygo's XYZ text, whose header holds rows of numbers and ends with a line "#".
inline constexpr std::string_view zygo_xyz_begin = "Zygo XYZ Data File";

/// Finds the end of the header and the separators. \throws domain_error when no line is a row of numbers.
void find_first_row(NumberTable& table, const std::string& name, const TableRules& rules);

NumberTable open_table(std::string_view text, const std::string& name, const TableRules& rules);

/// Reads the rows of a table that open_table has opened.
void read_rows(NumberTable& table, const std::string& name, const TableRules& rules);

}  // namespace detail

}  // namespace fstiff::io
