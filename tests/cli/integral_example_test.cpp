// SPDX-License-Identifier: BSD-3-Clause
// The program of examples/integral against tables of mpmath, and its refusals; FSTIFF_EXAMPLE_INTEGRAL is its path.
#include "command.hpp"

#include "support/accuracy.hpp"
#include "support/table.hpp"

#include <limits>

namespace integral_example_test {

namespace {

test::Outcome run(const std::string& arguments, const std::string& input = "") {
    return test::shell("'" FSTIFF_EXAMPLE_INTEGRAL "' " + arguments, input);
}

const std::string header = "a,b,r,theta,eta\n";

}  // namespace

TEST_CASE("The example integral has the values of the tables within its errors") {
    for (const std::string file : {"integrals_plain.csv", "integrals_hard.csv"}) {
        const auto outcome = run("'" FSTIFF_TEST_DATA "/" + file + "'");
        REQUIRE(outcome.status == 0);
        const test::Csv rows(outcome.out);
        REQUIRE(rows.size() == test::Table(file).size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double truth = rows.number(i, "input_value"), value = rows.number(i, "value");
            INFO(file << ", row " << i << ": " << value << " for " << truth);
            // the value has the digits that its error leaves and one more, and the error is rounded to one digit
            const double error = rows.number(i, "error");
            CHECK(std::abs(value - truth) <= 1.5 * error + std::numeric_limits<double>::min());
            if (file == "integrals_plain.csv") CHECK(std::abs(value - truth) <= 1e-12 * std::abs(truth) + error / 2);
        }
    }
}

TEST_CASE("The example integral keeps the columns of its rows, in any order") {
    const auto outcome =
        run("", "\xEF\xBB\xBFnote,eta, theta,r,b,a\r\nx,2,1.0,0.30,-0.5,+1.5\r\n\r\nz,2,1,0.3,-0.5,15e-1");
    REQUIRE(outcome.status == 0);
    const auto lines = test::lines(outcome.out);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "note,eta,theta,r,b,a,value,error,evaluations");
    CHECK(lines[1].starts_with("x,2,1.0,0.30,-0.5,+1.5,0.01269149980"));
    CHECK(lines[2].starts_with("z,2,1,0.3,-0.5,15e-1,0.01269149980"));
}

TEST_CASE("The example integral refuses what is no row of the integrals") {
    const std::string name = "standard input";
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
        {"", {name, "is empty"}},
        {header, {name, "no row"}},
        {"a,b,r,theta\n0,0,0,1\n", {name + ":1: ", "column eta"}},
        {"a;b;r;theta;eta\n0,5;-0,5;0,3;1;2\n", {name + ":1: ", "column r"}},
        {header + "0.5,-0.5,0.3,1\n", {name + ":2: has 4 cells", "5"}},
        {header + "0.5,-0.5,word,1,2\n", {name + ":2: r = \"word\""}},
        {header + "0.5,-0.5,0.3,1,inf\n", {name + ":2: eta = "}},
        {header + "0.5,-0.5,nan,1,2\n", {name + ":2: r = "}},
        {header + "0.7,-0.5,0.3,1,2\n", {name + ":2: a = 0.7", "must be"}},
        {header + "0.5,-0.5,1,1,2\n", {name + ":2: r = 1:", "less than 1"}},
        {header + "0.5,-0.5,0.3,1.6,2\n", {name + ":2: theta = 1.6:", "pi/2"}}};
    const auto refused = [](const std::string& arguments, const std::string& input,
                            const std::vector<std::string>& parts) {
        const auto outcome = run(arguments, input);
        INFO(arguments << "\n" << input << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(test::lines(outcome.err).size() == 1);
        CHECK_FALSE(test::contains(outcome.out, "nan"));
        for (const std::string& part : parts) CHECK(test::contains(outcome.err, part));
    };
    for (const auto& [input, parts] : cases) refused("", input, parts);
    refused("none.csv", "", {"none.csv: cannot be read"});
    refused("--tolerance 0", header + "0.5,-0.5,0.3,1,2\n", {"relative_tolerance = 0: must be"});
    refused("--method paper", "", {"--method: must be --yielding"});
}

}  // namespace integral_example_test
