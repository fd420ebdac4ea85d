// SPDX-License-Identifier: BSD-3-Clause
// What programs give to the requests of commands, in place of a text: numbers in SI and arrays. The numbers of each
// request are in tests/cli, those of its arrays in tests/c and tests/python.
#include "actions/ultrasound.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <vector>

namespace requests_test {

using namespace fstiff;

TEST_CASE("A quantity is a number in SI or a text with its unit") {
    using io::Dimension;
    CHECK(request::Amount("7 MHz").positive(Dimension::frequency, "f") == 7e6);
    CHECK(request::Amount(7e6).positive(Dimension::frequency, "f") == 7e6);
    CHECK(request::Amount(0.0).value(Dimension::pressure, "p") == 0);
    CHECK(test::refusal([] { (void)request::Amount(0.0).positive(Dimension::pressure, "p"); }) ==
          "p = 0: must be finite and greater than 0");
    CHECK(test::refusal([] { (void)request::Amount(std::nan("")).value(Dimension::pressure, "p"); }) ==
          "p = nan: must be finite");
    CHECK(request::Amount().empty());
}

TEST_CASE("A curve of numbers has a value for each pressure, and no value that a file may not have") {
    const std::vector<double> pressures{1e6, 2e6};
    const auto refused = [&](std::vector<double> values, std::vector<double> errors, bool reflections) {
        return test::refusal([&] { (void)actions::curve_of_numbers(pressures, values, errors, reflections, "curve"); });
    };
    CHECK(refused({0.5, 0.4}, {0.01, 0.01}, true).empty());
    CHECK(refused({0.5}, {}, true) == "curve: pressures, values and errors must have the same length");
    CHECK(refused({1.0, -1.0}, {}, false) == "curve:2: stiffness = -1: must be finite and greater than 0");
}

}  // namespace requests_test
