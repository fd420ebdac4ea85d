// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The comma-separated reference tables of tests/data; FSTIFF_TEST_DATA is that folder, set by CMake.
#include "support/csv.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace test {

class Table {
public:
    explicit Table(const std::string& name) : csv_(bytes(name)) {
        if (csv_.size() == 0) throw std::runtime_error("empty reference table " + name);
    }
    std::size_t size() const { return csv_.size(); }
    const std::string& text(std::size_t row, const std::string& column) const { return csv_.text(row, column); }
    /// A result, as precisely as it is printed.
    long double number(std::size_t row, const std::string& column) const { return std::stold(text(row, column)); }
    /// An input: the tables were made for exactly this double.
    double input(std::size_t row, const std::string& column) const { return csv_.number(row, column); }

private:
    static std::string bytes(const std::string& name) {
        std::ifstream file(FSTIFF_TEST_DATA "/" + name);
        if (!file) throw std::runtime_error("no reference table " + name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Csv csv_;
};

}  // namespace test
