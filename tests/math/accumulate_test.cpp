// SPDX-License-Identifier: BSD-3-Clause
// Sums that are known exactly: integers, and powers of two that a plain sum loses.
#include <fstiff/math/rounding.hpp>

#include "support/catch.hpp"

#include <limits>

namespace accumulate_test {

using namespace fstiff;

TEST_CASE("two_sum gives the rounding of a sum, whichever is larger") {
    const double small = 0x1p-60;
    for (const auto& [a, b] : {std::pair{1.0, small}, {small, 1.0}, {-1.0, small}, {1.0, -1.0}}) {
        const math::RoundedSum<double> s = math::two_sum(a, b);
        CHECK(s.sum == a + b);
        CHECK(s.error == (a + b == 0 ? 0 : small));
    }
}

TEST_CASE("A compensated sum keeps the digits that a plain one loses") {
    math::CompensatedSum<double> sum;
    double plain = 0;
    for (const double term : {1.0, 0x1p100, 1.0, -0x1p100}) {
        sum.add(term);
        plain += term;
    }
    CHECK(plain == 0);
    CHECK(sum.value() == 2);
    // the bound of the header, 2 epsilon of the sum and n^2 epsilon^2 of the magnitudes
    constexpr int terms = 10000;
    constexpr double truth = terms * static_cast<double>(0.1f), epsilon = std::numeric_limits<float>::epsilon();
    math::CompensatedSum<float> tenths;
    float plain_tenths = 0;
    for (int i = 0; i < terms; ++i) {
        tenths.add(0.1f);
        plain_tenths += 0.1f;
    }
    CHECK(std::abs(tenths.value() - truth) <= (2 * epsilon + terms * epsilon * (terms * epsilon)) * truth);
    CHECK(std::abs(plain_tenths - truth) > 0.05);
}

TEST_CASE("The power of two below a number is the greatest that is not above it") {
    for (const double size : {1.0, 1.5, 2.0, 0.75, 3e-7, 1e300, std::numeric_limits<double>::max()}) {
        const double power = math::power_of_two_below(size);
        CHECK((power <= size && size / 2 < power));
        int exponent = 0;
        CHECK(std::frexp(power, &exponent) == 0.5);
    }
    CHECK(math::power_of_two_below(0.0) == 1);
    CHECK(math::power_of_two_below(std::numeric_limits<double>::denorm_min()) ==
          std::numeric_limits<double>::denorm_min());
}

}  // namespace accumulate_test
