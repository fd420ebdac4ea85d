// SPDX-License-Identifier: BSD-3-Clause
// The series of nesting indices against its own digits, and the table of cut-offs as the standard prints it.
#include <fstiff/measure/cut_offs.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cstdlib>
#include <string>

namespace nesting_indices_test {

using namespace fstiff;

TEST_CASE("The nesting index of a length is the least of the series that is as long") {
    const char* digits[] = {"1", "2", "2.5", "5", "8", "10"};
    for (int decade = -15; decade <= 5; ++decade) {
        const auto index = [&](const char* digit) {  // the nearest double, by another way
            return std::strtod((digit + ("e" + std::to_string(decade))).c_str(), nullptr);
        };
        for (int i = 0; i + 1 < 6; ++i) {
            CAPTURE(decade, digits[i]);
            CHECK(detail::nesting_index(index(digits[i])) == index(digits[i]));
            CHECK(detail::nesting_index(index(digits[i]) * 1.009) == index(digits[i]));
            CHECK(detail::nesting_index(index(digits[i]) * 1.011) == index(digits[i + 1]));
        }
        if (decade > -15) CHECK(detail::nesting_index(index("1") * (1 - 1e-12)) == index("1"));
    }
    for (const double length : {0., -1., 1e-16, 2e6, std::nan("")})
        CHECK_THROWS_AS(detail::nesting_index(length), domain_error);
}

TEST_CASE("For every step of the standard's table lambda_s is the one of its row") {
    for (const detail::CutOffRow& row : detail::cut_off_table) {
        CHECK(detail::shortest_lambda_s(row.max_step) == row.lambda_s);
        CHECK(detail::lambda_s_of_tip(row.tip_radius) == row.lambda_s);
        CHECK(row.lambda_c / row.lambda_s >= detail::min_ratio_of_cut_offs);
    }
    // the smallest ratio, of two rounded lengths
    CHECK(test::ulps(detail::cut_off_table[0].lambda_c / detail::cut_off_table[0].lambda_s, 32.) <= 2);
}

TEST_CASE("The rounding of printed positions never moves lambda_s by a class") {
    for (const double nominal : {0.1e-6, 0.2e-6, 0.4e-6, 0.5e-6, 1e-6, 1.6e-6, 2e-6})
        for (const double factor : {1 - 1e-3, 1 - 1e-6, 1 + 1e-6, 1 + 8.4e-4, 1 + 5e-3}) {
            CAPTURE(nominal, factor);
            CHECK(detail::shortest_lambda_s(nominal * factor) == detail::shortest_lambda_s(nominal));
            CHECK(detail::shortest_lambda_s(1e-9, 5 * nominal * factor) == detail::shortest_lambda_s(nominal));
        }
    CHECK(detail::shortest_lambda_s(0.50042e-6) == 2.5e-6);
    CHECK(detail::shortest_lambda_s(0.1e-6, 0., 5.01e-6) == 8e-6);
    CHECK(detail::shortest_lambda_s(0.1e-6, 0., 2.01e-6) == 2.5e-6);
}

TEST_CASE("The resolution and the tip lengthen lambda_s and never shorten it") {
    CHECK(detail::shortest_lambda_s(10e-9) == 50e-9);  // of an atomic force microscope
    CHECK(detail::shortest_lambda_s(10e-9, 0.3e-6) == 0.5e-6);
    CHECK(detail::shortest_lambda_s(10e-9, 1e-9) == 50e-9);
    CHECK(detail::shortest_lambda_s(10e-9, 0., 2e-6) == 2.5e-6);
    CHECK(detail::shortest_lambda_s(10e-9, 0., 4e-6) == 8e-6);
    CHECK(detail::shortest_lambda_s(10e-9, 0., 7e-6) == 25e-6);
    CHECK(detail::shortest_lambda_s(10e-9, 0., 20e-6) == 50e-6);
    CHECK(detail::shortest_lambda_s(10e-9, 0., 10e-9) == 50e-9);  // 1.25 times 10 nm is less than five steps
    CHECK(detail::shortest_lambda_s(2e-6, 0., 2e-6) == 10e-6);
    CHECK(detail::shortest_lambda_s(1e-6f) == 5e-6f);
    CHECK_THROWS_AS(detail::shortest_lambda_s(0.), domain_error);
}

}  // namespace nesting_indices_test
