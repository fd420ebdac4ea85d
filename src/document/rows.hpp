// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Columns of results, described once: the table for people, the CSV and the JSON follow.
//
//     Rows rows;
//     rows.add({"lag_m", "lag [µm]", 1e6}, s.lag);             value in SI by its key, in µm under its heading
//     rows.add({"pairs", "pairs"}, s.pairs);
//     rows.text();  rows.csv();  rows.json();

#include "document/json.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::document {

/// Number of characters of UTF-8 text: all bytes but the continuation bytes.
[[nodiscard]] std::size_t shown_width(std::string_view text);
/// \p text in lines of at most \p most characters, broken at spaces where there are any.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t most);

/// Rows of text for people, the first one their headings.
using TextRows = std::vector<std::vector<std::string>>;

/// \p rows as columns that are right-aligned under the headings.
[[nodiscard]] std::string table_text(const TextRows& rows);

/// Cells joined by commas, with a line end: the one writer of CSV. A cell with a comma, a quotation mark or a line end
/// is quoted (RFC 4180).
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

/// A value of a column.
struct Cell {
    enum class Kind {
        absent,  ///< "-" for people, blank in CSV, no key in JSON
        null,    ///< the same, but null in JSON
        real,
        count,
        text
    };
    Kind kind = Kind::absent;
    double number = 0;
    long long whole = 0;
    std::string words{};

    Cell(Kind nothing = Kind::absent) : kind(nothing) {}
    Cell(double value) : kind(Kind::real), number(value) {}
    template <std::integral Integer>
    Cell(Integer value) : kind(Kind::count), whole(static_cast<long long>(value)) {}
    Cell(std::string text) : kind(Kind::text), words(std::move(text)) {}
    Cell(std::string_view text) : Cell(std::string(text)) {}
    Cell(const char* text) : Cell(std::string(text)) {}
    /// An optional value: absent where there is none.
    Cell(const std::optional<double>& value) : Cell(value ? Cell(*value) : Cell()) {}
    /// The value where it is finite; else \p otherwise.
    [[nodiscard]] static Cell finite(double value, Kind otherwise = Kind::null);

    /// For people: a number times \p factor.
    [[nodiscard]] std::string text(double factor = 1, int digits = 5) const;
    [[nodiscard]] Json json() const;
};

/// How a column is called and shown.
struct Heading {
    std::string key;      ///< of CSV and JSON, with the unit; empty: for people only
    std::string shown{};  ///< for people, with the unit that they read; empty: not for people
    double factor = 1;    ///< from the value to what people read
    int digits = 5;       ///< for people
    bool csv = true, json = true;
};

/// Columns of equal length.
class Rows {
public:
    /// A column of \p value of each of \p items: a function, or a member of theirs. Without items its cells are absent.
    template <class Items, class Value = std::identity>
    void add(Heading heading, const Items& items, const Value& value = {}) {
        std::vector<Cell> cells;
        for (const auto& item : items) cells.emplace_back(std::invoke(value, item));
        if (cells.empty()) cells.resize(size());
        columns_.push_back({std::move(heading), std::move(cells)});
    }
    /// Columns that add_row fills.
    [[nodiscard]] static Rows under(std::vector<Heading> headings) {
        Rows rows;
        for (Heading& heading : headings) rows.columns_.push_back({std::move(heading), {}});
        return rows;
    }
    /// A cell for every column.
    void add_row(std::vector<Cell> cells) {
        for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].cells.push_back(std::move(cells.at(i)));
    }
    /// The same value \p count times.
    void repeat(Heading heading, const Cell& value, std::size_t count) {
        columns_.push_back({std::move(heading), std::vector<Cell>(count, value)});
    }
    [[nodiscard]] std::size_t size() const { return columns_.empty() ? 0 : columns_.front().cells.size(); }

    using Select = std::function<bool(std::size_t row)>;
    /// The columns that people read; of all rows, or of those that \p select takes. Without any there is no text.
    [[nodiscard]] TextRows table(const Select& select = {}) const;
    [[nodiscard]] std::string text(const Select& select = {}) const;
    [[nodiscard]] std::string csv(bool with_header = true, const Select& select = {}) const;
    /// Appends an object for every row to \p list.
    void append_to(Json& list) const;
    /// An object with the values of each column as an array.
    [[nodiscard]] Json arrays() const;

    struct Column {
        Heading heading;
        std::vector<Cell> cells;
    };
    [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

private:
    std::vector<Column> columns_;
};

}  // namespace fstiff::document
