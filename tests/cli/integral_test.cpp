// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"
#include "support/table.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace integral_test {

namespace {

const std::string table_file(const std::string& name) { return std::string("'") + FSTIFF_TEST_DATA + "/" + name + "'"; }

const std::string two_rows = "a,b,r,theta,eta\n0.5,-0.5,0.3,1,2\n1.5,-0.5,0.3,1,2\n";

/// The largest relative error over a table whose column "value" is the truth; every estimate must cover its error. The
/// floor is 8 ulp (the estimate is of the rule, the truth is rounded to double) and the least positive normal number.
double worst(const test::Csv& rows) {
    double largest = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double truth = rows.number(i, "input_value"), value = rows.number(i, "value"),
                     error = rows.number(i, "error");
        const double difference = std::abs(value - truth);
        INFO("row " << i << ": " << rows.text(i, "a") << "," << rows.text(i, "b") << "," << rows.text(i, "r") << ","
                    << rows.text(i, "theta") << "," << rows.text(i, "eta"));
        CAPTURE(value, truth, error);
        CHECK(difference <= error + 8 * std::numeric_limits<double>::epsilon() * std::abs(truth) +
                                std::numeric_limits<double>::min());
        if (std::abs(truth) > 1e-300) largest = std::max(largest, test::relative_error(value, truth));
    }
    return largest;
}

}  // namespace

TEST_CASE("Every value of the plain table comes back to 1e-12") {
    const auto outcome = test::run_fstiff("integral " + table_file("integrals_plain.csv"));
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    const test::Csv rows(outcome.out);
    CHECK(rows.size() == test::Table("integrals_plain.csv").size());
    CHECK(worst(rows) < 1e-12);
}

TEST_CASE("Every value of the plain table comes back to 1e-12 by the two-dimensional rule") {
    const auto outcome = test::run_fstiff("integral --method tensor " + table_file("integrals_plain.csv"));
    REQUIRE(outcome.status == 0);
    CHECK(worst(test::Csv(outcome.out)) < 1e-12);
}

TEST_CASE("The error estimates cover the true errors of the hard table, and no value is missing") {
    const auto outcome = test::run_fstiff("integral " + table_file("integrals_hard.csv"));
    CHECK((outcome.status == 0 || outcome.status == 4));
    const test::Csv rows(outcome.out);
    CHECK(rows.size() == test::Table("integrals_hard.csv").size());
    worst(rows);
}

TEST_CASE("The paper's rule has an error estimate that covers its error") {
    const auto outcome = test::run_fstiff("integral --method paper " + table_file("integrals_plain.csv"));
    REQUIRE(outcome.status == 0);
    const test::Csv rows(outcome.out);
    CHECK(worst(rows) > 1e-9);  // a 50 x 50 Gauss-Legendre rule on a box ignores the branch points
    CHECK(rows.number(0, "evaluations") == 50 * 50 + 25 * 25);  // the coarser rule is for the estimate
}

TEST_CASE("A tolerance saves evaluations and is met") {
    const test::Csv coarse(test::run_fstiff("integral --tolerance 1e-4", two_rows).out),
        fine(test::run_fstiff("integral", two_rows).out);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(test::relative_error(coarse.number(i, "value"), fine.number(i, "value")) < 1e-4);
        CHECK(coarse.number(i, "evaluations") < fine.number(i, "evaluations"));
        CHECK(coarse.number(i, "error") <= 1e-3 * coarse.number(i, "value"));  // the estimate is on the safe side
    }
}

TEST_CASE("Rows come back in their order with their other columns as they were") {
    const auto outcome = test::run_fstiff("integral -",
                                          "\xEF\xBB\xBFnote,eta, theta,r,b,a,value\r\n\"x, "
                                          "y\",2,1.0,0.30,-0.5,+0.5,seven\r\n\r\nz,2,1,0.3,-0.5,5e-1,\r\n");
    REQUIRE(outcome.status == 0);
    const auto lines = test::lines(outcome.out);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "note,eta,theta,r,b,a,input_value,value,error,evaluations");
    CHECK(lines[1].starts_with("\"x, y\",2,1.0,0.30,-0.5,+0.5,seven,"));
    CHECK(lines[2].starts_with("z,2,1,0.3,-0.5,5e-1,,"));
    const test::Csv plain(test::run_fstiff("integral", two_rows).out);
    CHECK(lines[2].find("," + plain.text(0, "value") + ",") != std::string::npos);
}

TEST_CASE("Values have 17 significant digits: they read back as the same number in JSON and in CSV") {
    const test::Csv csv(test::run_fstiff("integral", two_rows).out);
    const auto document = nlohmann::json::parse(test::run_fstiff("integral --format json", two_rows).out);
    CHECK(document["schema_version"] == 1);
    CHECK(document["method"] == "reduced");
    for (std::size_t i = 0; i < 2; ++i)
        for (const char* column : {"a", "b", "r", "theta", "eta", "value", "error", "evaluations"})
            CHECK(document["rows"][i][column].get<double>() == csv.number(i, column));
    const auto table = test::run_fstiff("integral --format table", two_rows);
    CHECK(test::contains(table.out, csv.text(0, "value").substr(0, 14)));
}

TEST_CASE("Rows that are no rows of the integrals are refused with file and line") {
    struct Case {
        std::string text;
        std::vector<std::string> parts;
    };
    const std::string header = "a,b,r,theta,eta\n";
    const std::vector<Case> cases{
        {"", {"empty"}},
        {"\n\n", {"empty"}},
        {"a,b,r,theta\n0,0,0,1\n", {"eta", "a,b,r,theta,eta"}},
        {"a;b;r;theta;eta\n0,5;-0,5;0,3;1;2\n", {":1: has semicolons", "must have commas", "points as decimal marks"}},
        {"a\tb\tr\ttheta\teta\n0.5\t0\t0.3\t1\t2\n", {":1: has tabs", "must have commas"}},
        {header + "\"0,5\",-0.5,0.3,1,2\n", {":2: a = \"0,5\"", "the decimal mark is the point"}},
        {"a,b,r,theta,eta,a\n0,0,0,1,1,1\n", {"\"a\" twice"}},
        {"0.5,-0.5,0.3,1,2\n", {"header", "a,b,r,theta,eta"}},
        {header, {"no row"}},
        {header + "0.5,-0.5,0.3,1\n", {":2: has 4 cells", "5"}},
        {header + "0.5,-0.5,0.3,1,2,3\n", {":2: has 6 cells", "5"}},
        {header + "0.5,-0.5,0.3,1,2\n0.5,-0.5,word,1,2\n", {":3: r = \"word\""}},
        {header + "0.5,-0.5,nan,1,2\n", {":2: r = \"nan\"", "finite"}},
        {header + "0.5,-0.5,0.3,1,inf\n", {":2: eta = \"inf\"", "finite"}},
        {header + "0.5,-0.5,0.3,1,\n", {":2: eta = \"\""}},
        {header + "0.5,-0.5,0.3,1,2 3\n", {":2: eta = \"2 3\""}},
        {header + "0.7,-0.5,0.3,1,2\n", {":2: ", "0.7", "must be"}},
        {header + "-1,-0.5,0.3,1,2\n", {":2: ", "-1", "must be"}},
        {header + "0.5,0.5,0.3,1,2\n", {":2: ", "0.5", "must be"}},
        {header + "0.5,-0.5,1,1,2\n", {":2: r = 1:", "less than 1"}},
        {header + "0.5,-0.5,-0.1,1,2\n", {":2: r = -0.1:", "at least 0"}},
        {header + "0.5,-0.5,0.3,0,2\n", {":2: theta = 0:", "pi/2"}},
        {header + "0.5,-0.5,0.3,1.6,2\n", {":2: theta = 1.6:", "pi/2"}},
        {header + std::string("0.5,\0-0.5,0.3,1,2\n", 18), {"binary"}},
    };
    for (const Case& c : cases) {
        INFO(c.text);
        std::vector<std::string> parts = c.parts;
        parts.push_back("standard input");
        test::check_refused("integral -", 3, parts, c.text);
    }
    test::check_refused("integral none.csv", 3, {"none.csv", "no such file"});
    test::check_refused("integral --tolerance 0", 2, {"--tolerance = 0:", "between 1.2e-14 and 0.1"}, two_rows);
    test::check_refused("integral --tolerance nan", 2, {"--tolerance = nan", "between"}, two_rows);
    test::check_refused("integral --method simpson", 2, {"--method", "simpson"}, two_rows);
}

}  // namespace integral_test
