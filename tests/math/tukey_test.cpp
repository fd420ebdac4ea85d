// SPDX-License-Identifier: BSD-3-Clause
// Tukey's weights by hand, and the factor by the error function.
#include <fstiff/math/tukey.hpp>

#include "support/catch.hpp"

using namespace fstiff;

TEST_CASE("The factor is three standard deviations over the median of Gaussian absolute values") {
    const double median = 3 / tukey_factor<double>;
    CHECK(std::abs(std::erf(median / std::sqrt(2.)) - 0.5) < 2e-16);
}

TEST_CASE("Tukey's weights are 1 at 0, 9/16 at half of c, and 0 from c on") {
    CHECK(tukey_weight(0., 2.) == 1);
    CHECK(tukey_weight(1., 2.) == 0.5625);
    CHECK(tukey_weight(-1., 2.) == 0.5625);
    CHECK(tukey_weight(2., 2.) == 0);
    CHECK(tukey_weight(-1e9, 2.) == 0);
}

TEST_CASE("The median of few numbers") {
    std::vector<double> odd{5, 1, 4, 2, 3}, even{4, 1, 3, 2}, one{7}, none;
    CHECK(median(odd) == 3);
    CHECK(median(even) == 2.5);
    CHECK(median(one) == 7);
    CHECK_THROWS_AS(median(none), domain_error);
}
