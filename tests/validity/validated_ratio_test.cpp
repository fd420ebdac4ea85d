// SPDX-License-Identifier: BSD-3-Clause
// Truth: the table of docs/validation.md, which tools/make_validation.py makes.
#include <fstiff/validity/validated_ratio.hpp>

#include "support/catch.hpp"

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace validated_ratio_test {

using namespace fstiff;

namespace {

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> all;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) {
        const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
        all.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return all;
}

/// The table of ratios by p*, its heading first.
std::vector<std::vector<std::string>> table() {
    std::ifstream document(FSTIFF_SCENES "/../docs/validation.md");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(document, line);) {
        if (rows.empty() && !line.starts_with("| p* |")) continue;
        if (!line.starts_with("|")) break;
        if (!line.starts_with("| ---")) rows.push_back(cells(line));
    }
    return rows;
}

}  // namespace

TEST_CASE("The ratios of each law are those of docs/validation.md, which has no other law of the command") {
    const auto rows = table();
    REQUIRE(rows.size() == 9);
    CHECK(std::stod(rows[1][0]) == parts::min_validated_pressure);
    CHECK(std::stod(rows.back()[0]) == parts::max_validated_pressure);
    std::set<LawName> compared;
    for (std::size_t i = 1; i < rows[0].size(); ++i) {
        const auto law = parts::find_named<LawName>(rows[0][i].substr(0, rows[0][i].find(',')));
        CHECK(law.has_value() != rows[0][i].starts_with("p/"));
        if (!law) continue;
        compared.insert(*law);
        for (std::size_t j = 1; j < rows.size(); ++j) {
            INFO(rows[0][i] << " at p* = " << rows[j][0]);
            const auto ratio = parts::validated_ratio(*law, std::stod(rows[j][0]));
            REQUIRE(ratio);
            const std::string dash = "\xE2\x80\x93";
            CHECK(ratio->low == std::stod(rows[j][i]));
            CHECK(ratio->high == std::stod(rows[j][i].substr(rows[j][i].find(dash) + dash.size())));
        }
    }
    CHECK(compared.size() == 6);
    for (const auto& [law, word] : names<LawName>)
        CHECK(parts::validated_ratio(law, 0.03).has_value() == compared.contains(law));
}

TEST_CASE("Between two rows the ratio covers both, next to one it is that row, and outside there is none") {
    const auto between = parts::validated_ratio(LawName::hertz, 0.02);
    REQUIRE(between);
    CHECK(between->low == 0.63);
    CHECK(between->high == 0.97);
    CHECK(parts::validated_ratio(LawName::hertz, 0.0301)->low == 0.63);
    CHECK(parts::validated_ratio(LawName::hertz, 0.0305)->low == 0.49);
    CHECK(parts::validated_ratio(LawName::hertz, 0.00199)->low == 0.87);
    CHECK(parts::validated_ratio(LawName::hertz, 0.2515)->low == 0.18);
    CHECK_FALSE(parts::validated_ratio(LawName::hertz, 0.0019));
    CHECK_FALSE(parts::validated_ratio(LawName::hertz, 0.26));
}

}  // namespace validated_ratio_test
