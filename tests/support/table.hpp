// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Reads the comma-separated reference tables of tests/data; FSTIFF_TEST_DATA is that folder, set by CMake.
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

class Table {
public:
    explicit Table(const std::string& name) {
        std::ifstream file(FSTIFF_TEST_DATA "/" + name);
        if (!file) throw std::runtime_error("no reference table " + name);
        std::string line;
        std::getline(file, line);
        header_ = split(line);
        while (std::getline(file, line))
            if (!line.empty()) rows_.push_back(split(line));
        if (rows_.empty()) throw std::runtime_error("empty reference table " + name);
    }
    std::size_t size() const { return rows_.size(); }
    const std::string& text(std::size_t row, const std::string& column) const {
        for (std::size_t i = 0; i < header_.size(); ++i)
            if (header_[i] == column) return rows_.at(row).at(i);
        throw std::runtime_error("no column " + column);
    }
    /// A result, as precisely as it is printed.
    long double number(std::size_t row, const std::string& column) const { return std::stold(text(row, column)); }
    /// An input: the tables were made for exactly this double.
    double input(std::size_t row, const std::string& column) const { return std::stod(text(row, column)); }

private:
    static std::vector<std::string> split(const std::string& line) {
        std::vector<std::string> cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        return cells;
    }
    std::vector<std::string> header_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace test
