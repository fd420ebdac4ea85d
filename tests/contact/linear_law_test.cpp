// SPDX-License-Identifier: BSD-3-Clause
// Truth: the load that falls as exp(-separation/(0.48 sigma)), whose slope the law is. Against boundary elements:
// tests/docs/validation_test.cpp.
#include <fstiff/contact/persson_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace linear_law_test {

using namespace fstiff;

TEST_CASE("The linear law is the slope of an exponential load, and of no scale") {
    const double sigma = 0.832e-6, step = 1e-3 * sigma;
    const auto load = [&](double separation) { return 1e7 * std::exp(-separation / (0.48 * sigma)); };
    for (const double separation : {0.0, 1e-6, 3e-6}) {
        const double slope = (8 * (load(separation - step) - load(separation + step)) -
                              (load(separation - 2 * step) - load(separation + 2 * step))) /
                             (12 * step);
        CHECK(test::relative_error(detail::linear_stiffness(load(separation), sigma), slope) <
              1e-11);  // (step/sigma)^4/30
    }
    CHECK(detail::linear_stiffness(0.0, sigma) == 0);
    CHECK(test::ulps(detail::linear_stiffness(1e7, 1e9 * sigma) * 1e9, detail::linear_stiffness(1e7, sigma)) <= 4);
}

TEST_CASE("The linear law refuses arguments without a stiffness") {
    CHECK(test::refusal([] { (void)detail::linear_stiffness(-1.0, 1e-6); }) ==
          "pressure = -1: must be finite and not negative");
    CHECK(test::refusal([] { (void)detail::linear_stiffness(1.0, 0.0); }).starts_with("rms_height = 0: must be"));
}

}  // namespace linear_law_test
