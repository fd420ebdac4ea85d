// SPDX-License-Identifier: BSD-3-Clause
// The ratios that fstiff run shows, against the table of docs/validation.md.
#include "scene/validated_ratio.hpp"

#include "cli/command.hpp"

#include <sstream>

namespace validated_ratio_test {

namespace scene = fstiff::scene;

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

}  // namespace

TEST_CASE("The ratios of each law are those of docs/validation.md, which has no other law of the command") {
    std::vector<std::string> laws;
    std::size_t compared = 0;
    double least = 1, most = 0;
    for (const std::string& line : test::lines(test::read(FSTIFF_SCENES "/../docs/validation.md"))) {
        if (line.starts_with("| p* |")) {
            laws = cells(line);
            continue;
        }
        if (laws.empty() || line.starts_with("| ---")) continue;
        if (!line.starts_with("|")) {
            if (compared > 0) break;
            continue;
        }
        const auto row = cells(line);
        const double p = std::stod(row[0]);
        least = std::min(least, p), most = std::max(most, p);
        for (std::size_t i = 1; i < row.size(); ++i) {
            const std::string law = laws[i].substr(0, laws[i].find(','));
            const auto ratio = scene::validated_ratio(law, p);
            if (law.starts_with("p/")) {  // no law of the command
                CHECK(!ratio);
                continue;
            }
            INFO(law << " at p* = " << p);
            REQUIRE(ratio);
            const std::string dash = "\xE2\x80\x93";
            CHECK(ratio->low == std::stod(row[i]));
            CHECK(ratio->high == std::stod(row[i].substr(row[i].find(dash) + dash.size())));
            ++compared;
        }
    }
    CHECK(compared == 6 * 8);
    CHECK(least == scene::min_validated_pressure);
    CHECK(most == scene::max_validated_pressure);
}

TEST_CASE("Between two rows the ratio covers both, and outside of the table there is none") {
    const auto between = scene::validated_ratio("hertz", 0.02);
    REQUIRE(between);
    CHECK(between->low == 0.63);
    CHECK(between->high == 0.97);
    CHECK(!scene::validated_ratio("hertz", 0.0019));
    CHECK(!scene::validated_ratio("hertz", 0.26));
    CHECK(!scene::validated_ratio("gauss", 0.02));
}

}  // namespace validated_ratio_test
