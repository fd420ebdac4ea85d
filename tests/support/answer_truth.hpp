// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The table of boundary elements of bench/answer_truth.csv; FSTIFF_SCENES is the folder data, set by CMake.

#include <fstream>
#include <map>
#include <string>

namespace test {

/// K by kind, seed, size, hardness and p* or p/H, all before the last comma of a row, in periods of the map.
inline std::map<std::string, double> answer_truths() {
    std::ifstream file(FSTIFF_SCENES "/../bench/answer_truth.csv");
    std::map<std::string, double> all;
    for (std::string line; std::getline(file, line);) {
        const auto last = line.rfind(',');
        if (line.find("pressure") == std::string::npos) all[line.substr(0, last)] = std::stod(line.substr(last + 1));
    }
    return all;
}

}  // namespace test
