// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure --show islands as a process: its table and exit codes. tests/scene/islands_test.cpp has its numbers.
#include "command.hpp"

namespace islands_test {

namespace {

std::string map_text() {
    return test::run_fstiff("generate map --points 96 --spacing '1 um' --hurst 0.8 --rms '1 um' --shortest '8 um'").out;
}

}  // namespace

TEST_CASE("The readable islands print the decisions, and warn of a pair that means little") {
    const auto outcome = test::run_fstiff("measure --show islands -", map_text());
    REQUIRE(outcome.status == 4);
    for (const std::string part : {"format: matrix", "96 x 96 points", "8 neighbours", "D_p = ", "R = ", "seed 2014",
                                   "bearing area", "peaks only; their errors are rough"}) {
        INFO(outcome.out << "\nexpected: " << part);
        CHECK(test::contains(outcome.out, part));
    }
}

TEST_CASE("Wrong files and options of islands end with exit codes 3 and 2") {
    const std::string text = map_text();
    test::check_refused("measure --show islands -", 3, {"standard input", "empty"});
    test::check_refused("measure --show islands - --spacing '1 um'", 3,
                        {"has 96 columns", "dx and dy in place of spacing"}, text);
    test::check_refused("measure --show islands - --neighbours 6", 2, {"--neighbours"}, text);
    for (const char* beyond : {"--levels 2000000000", "--least-points 0", "--tiles 0", "--resamples 1"})
        test::check_refused(
            "measure --show islands - " + std::string(beyond), 2,
            {std::string(beyond).substr(0, std::string(beyond).find(' ')), "must be a whole number from"}, text);
    test::check_refused("measure --show islands - --detrend line", 2, {"--detrend", "line"}, text);
    test::check_refused("measure --show islands nowhere.csv", 3, {"nowhere.csv", "no such file"});
    CHECK(test::run_fstiff("measure --show islands - --neighbours 4 --border drop --least-points 3 --island-height "
                           "twice-mean --levels 50",
                           text)
                  .status %
              4 ==
          0);
}

}  // namespace islands_test
