// SPDX-License-Identifier: BSD-3-Clause
// A few triples by hand, whole and in parts.
#include <fstiff/profile/peak_statistics.hpp>

#include "support/catch.hpp"

#include <limits>

namespace triples_test {

using namespace fstiff;

TEST_CASE("Triples give slopes and curvatures and peaks and leave out missing points") {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    detail::TripleSums<double> plain, part;
    detail::TripleSums<double, math::CompensatedSum<double>> compensated;
    const auto add = [&](double rise, double fall) {
        part.add(rise, fall);
        compensated.add(rise, fall);
    };
    add(1, -3);  // a peak: slope (1 + 9)/2, curvature 16
    add(2, 2);
    plain.add(part);
    part = {};
    add(-1, 1);
    add(missing, 1);
    add(1, missing);
    add(1, 0);  // of a plateau no point is a peak
    plain.add(part);
    CHECK(plain.triples == 4);
    CHECK(plain.peaks == 1);
    CHECK(plain.mean_square_slope() == (5 + 4 + 1 + 0.5) / 4);
    CHECK(plain.mean_square_curvature() == (16 + 0 + 4 + 1) / 4.0);
    CHECK(compensated.triples == 4);
    CHECK(compensated.peaks == 1);
    CHECK(compensated.mean_square_slope() == plain.mean_square_slope());
    CHECK(compensated.mean_square_curvature() == plain.mean_square_curvature());
}

}  // namespace triples_test
