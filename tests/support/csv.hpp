// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The CSV reader of the tests: output of the command, and the reference tables of tests/data. Shares
// nothing with the library's readers.
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

/// The cells of one line; those with commas are in quotes.
inline std::vector<std::string> csv_cells(const std::string& line) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
}

/// Cells of CSV text by column name; the first line names the columns.
class Csv {
public:
    explicit Csv(const std::string& text) {
        std::istringstream stream(text);
        for (std::string line; std::getline(stream, line);)
            if (!line.empty()) rows_.push_back(csv_cells(line));
        if (rows_.empty()) throw std::runtime_error("the document is empty");
    }
    std::size_t size() const { return rows_.size() - 1; }
    const std::vector<std::string>& header() const { return rows_.front(); }
    const std::string& text(std::size_t row, const std::string& column) const {
        const auto found = std::find(header().begin(), header().end(), column);
        if (found == header().end()) throw std::runtime_error("no column " + column);
        return rows_.at(row + 1).at(static_cast<std::size_t>(found - header().begin()));
    }
    double number(std::size_t row, const std::string& column) const { return std::stod(text(row, column)); }

private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace test
