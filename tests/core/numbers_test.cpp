// SPDX-License-Identifier: BSD-3-Clause
// The constants: those of the standard library in float and double, those of its functions in long double.
#include <fstiff/core/numbers.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace numbers_test {

TEMPLATE_TEST_CASE("the constants are those of the standard library", "[numbers]", float, double) {
    using T = TestType;
    CHECK(fstiff::numbers::pi_v<T> == std::numbers::pi_v<T>);
    CHECK(fstiff::numbers::inv_sqrtpi_v<T> == std::numbers::inv_sqrtpi_v<T>);
    CHECK(fstiff::numbers::sqrt2_v<T> == std::numbers::sqrt2_v<T>);
    CHECK(fstiff::numbers::ln2_v<T> == std::numbers::ln2_v<T>);
    CHECK(fstiff::numbers::ln10_v<T> == std::numbers::ln10_v<T>);
}

TEST_CASE("the constants of long double have all its digits", "[numbers]") {
    CHECK(test::ulps(fstiff::numbers::pi_v<long double>, std::acos(-1.0L)) <= 1);
    CHECK(test::ulps(fstiff::numbers::inv_sqrtpi_v<long double>, 1 / std::sqrt(std::acos(-1.0L))) <= 1);
    CHECK(test::ulps(fstiff::numbers::sqrt2_v<long double>, std::sqrt(2.0L)) <= 1);
    CHECK(test::ulps(fstiff::numbers::ln2_v<long double>, std::log(2.0L)) <= 1);
    CHECK(test::ulps(fstiff::numbers::ln10_v<long double>, std::log(10.0L)) <= 1);
}

}  // namespace numbers_test
