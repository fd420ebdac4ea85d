// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace peaks_test {

namespace {

nlohmann::json json(const std::string& arguments, const std::string& input = "") {
    const auto outcome = test::run_fstiff("measure --show peaks --format json " + arguments, input);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("The moments of Fig. 2 are those that the theory gives") {
    // theta = pi/3; mean, variance, skewness, kurtosis to the five digits they are printed with
    const double figures[3][5] = {{0.5, .51824, .83480, .02686, 3.00737},
                                  {1.0 / 3, .34549, .92658, .00681, 3.00118},
                                  {0.2, .20730, .97357, .00137, 3.00014}};
    for (const auto& row : figures) {
        const auto document = json("--theta pi/3 --r " + std::to_string(row[0]));
        // r = 1/3 is passed with six digits: 3e-7 of it
        CHECK(std::abs(document["mean_height"].get<double>() - row[1]) < 6e-6);
        CHECK(std::abs(document["height_variance"].get<double>() - row[2]) < 6e-6);
        CHECK(std::abs(document["height_skewness"].get<double>() - row[3]) < 6e-6);
        CHECK(std::abs(document["height_kurtosis"].get<double>() - row[4]) < 6e-6);
    }
}

TEST_CASE("One density has several names") {
    // exponential autocorrelation rho2 = rho1^2: theta = pi/3 is rho1 = 0 and r^2 = 2/3
    const auto exponential = json("--theta '60 deg' --exponential");
    CHECK(test::relative_error(exponential["r"].get<double>(), std::sqrt(2.0 / 3)) < 1e-15);
    const auto correlations = json("--rho1 0 --rho2 0");
    CHECK(test::relative_error(correlations["r"].get<double>(), std::sqrt(2.0 / 3)) < 1e-15);
    CHECK(test::relative_error(correlations["theta"].get<double>(), std::numbers::pi / 3) < 1e-15);
    CHECK(json("--theta 1.0471975511965976 --r 0.25")["theta"].get<double>() == 1.0471975511965976);
    CHECK(test::relative_error(exponential["peak_ratio"].get<double>(), 1.0 / 3) < 1e-15);
}

TEST_CASE("The height marginal integrates to one and has the mean of the closed form") {
    const auto document = json("--theta pi/3 --r 0.5 --heights=-8,9,341");
    const auto heights = document["heights"]["height"].get<std::vector<double>>();
    const auto density = document["heights"]["density"].get<std::vector<double>>();
    REQUIRE(heights.size() == 341);
    CHECK(heights.front() == -8);
    CHECK(heights.back() == 9);
    double sum = 0, mean = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        sum += density[i] * 0.05;
        mean += heights[i] * density[i] * 0.05;
    }
    // the trapezoidal rule of step 0.05 on a near-Gaussian is exact to rounding; the tails beyond 8 are 1e-15
    CHECK(std::abs(sum - 1) < 1e-12);
    CHECK(std::abs(mean - document["mean_height"].get<double>()) < 1e-12);
    const test::Csv csv(
        test::run_fstiff("measure --show peaks --format csv --theta pi/3 --r 0.5 --heights=-8,9,341").out);
    REQUIRE(csv.size() == 341);
    CHECK(csv.number(170, "density") == density[170]);
    CHECK(csv.number(170, "height") == heights[170]);
}

TEST_CASE("White noise as a profile has theta = pi/3 and one peak in three ordinates") {
    std::string text = "z [um]\n";
    unsigned long long state = 1984;
    for (int i = 0; i < 20000; ++i) {
        double gaussian = -6;  // the sum of 12 uniform numbers
        for (int k = 0; k < 12; ++k) {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            gaussian += static_cast<double>(state >> 40) / 16777216.0;
        }
        text += std::to_string(gaussian) + "\n";
    }
    const auto document = json("--profile - --lambda-s none --lambda-c none --spacing '10 um'", text);
    // standard errors over 20000 points: theta 0.004, r 0.005, the share of peaks 0.002; 4 of each
    CHECK(std::abs(document["theta"].get<double>() - std::numbers::pi / 3) < 0.016);
    CHECK(std::abs(document["r"].get<double>() - std::sqrt(2.0 / 3)) < 0.02);
    CHECK(std::abs(document["counted_peak_ratio"].get<double>() - 1.0 / 3) < 0.008);
    CHECK(document["points"] == 20000);
}

TEST_CASE("The table and the CSV of peaks hold the same") {
    const auto document = json("--theta pi/3 --r 0.5");
    const test::Csv csv(test::run_fstiff("measure --show peaks --format csv --theta pi/3 --r 0.5").out);
    for (const std::string& name : csv.header()) CHECK(document[name].get<double>() == csv.number(0, name));
    const auto table = test::run_fstiff("measure --show peaks --theta pi/3 --r 0.5 --heights 0,1,2");
    for (const char* part : {"0.51824", "0.8348", "3.00737", "0.333333", "height"})
        CHECK(test::contains(table.out, part));
}

TEST_CASE("Peaks refuses values that no density has") {
    using test::check_refused;
    check_refused("measure --show peaks --theta pi/2 --r 0.5", 3, {"theta = 1.57", "pi/2"});
    check_refused("measure --show peaks --theta 0 --r 0.5", 3, {"theta = 0", "pi/2"});
    check_refused("measure --show peaks --theta nan --r 0.5", 3, {"--theta = \"nan\""});
    check_refused("measure --show peaks --theta 1 --r 1", 3, {"r = 1", "less than 1"});
    check_refused("measure --show peaks --theta 1 --r nan", 2, {"--r = \"nan\": must be a plain number"});
    check_refused("measure --show peaks --theta 0.5 --exponential", 3, {"theta = 0.5", "pi/4 and pi/3"});
    check_refused("measure --show peaks --rho1 1 --rho2 1", 3, {"rho1 = 1"});
    check_refused("measure --show peaks --rho1 0.5 --rho2 -0.9", 3, {"rho2 = -0.9"});
    check_refused("measure --show peaks --rho1 0.5", 2, {"--rho1 and --rho2"});
    check_refused("measure --show peaks --theta 1", 2, {"--theta needs"});
    check_refused("measure --show peaks --theta 1 --r 0.5 --exponential", 2, {"--theta needs"});
    check_refused("measure --show peaks --theta 1 --r 0.5 --rho1 0.1 --rho2 0.1", 2, {"give one of"});
    check_refused("measure --show peaks", 2, {"give one of"});
    check_refused("measure --show peaks --theta 1 --r 0.5 --heights 0,1", 2, {"--heights = \"0,1\"", "FROM,TO,COUNT"});
    check_refused("measure --show peaks --theta 1 --r 0.5 --heights 0,1e9,3", 2, {"--heights", "30"});
    check_refused("measure --show peaks --theta 1 --r 0.5 --heights 0,1,1e9", 2, {"--heights", "100000"});
    check_refused("measure --show peaks --theta 1 --r 0.5 --heights 0,one,3", 2, {"--heights", "FROM,TO,COUNT"});
    check_refused("measure --show peaks --profile none.csv", 3, {"none.csv", "no such file"});
    check_refused("measure --show peaks --profile - --spacing '1 um' --units um", 3, {"standard input", "16"},
                  "1\n2\n1\n");
}

}  // namespace peaks_test
