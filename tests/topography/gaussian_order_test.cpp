// SPDX-License-Identifier: BSD-3-Clause
// Truth: the definition, for a map of a few points and for a monotone function of a map.
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/gaussian_order.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace gaussian_order_test {

using namespace fstiff;

TEST_CASE("The Gaussian order of a map: scores of ranks, equal heights equal, missing points missing") {
    HeightMap<double> map;
    map.dx = map.dy = 1e-6;
    map.heights.resize(4, 4);
    map.heights << 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 10, 11, 12, 13, std::numeric_limits<double>::quiet_NaN();
    const auto order = detail::gaussian_order(map);
    CHECK(std::isnan(order.map.heights(3, 3)));
    CHECK(order.map.heights(0, 0) == order.rms_height * math::normal_quantile(0.5 / 15));
    CHECK(order.map.heights(2, 0) == order.rms_height * math::normal_quantile(9.5 / 15));
    CHECK(order.map.heights(2, 1) == order.map.heights(2, 0));
    CHECK(order.rms_height == rms_height(map));
    CHECK(order.curve.knots().size() == 13);
    CHECK(order.curve.knots().back().height == 13);
}

TEST_CASE("A monotone function of a map leaves its Gaussian order, and becomes its bearing curve") {
    HeightMap<double> map = test::half_space_map("gaussian");
    const auto order = detail::gaussian_order(map);
    HeightMap<double> bent = map;
    bent.heights = (map.heights * (1 / order.rms_height)).exp();
    const auto of_bent = detail::gaussian_order(bent);
    const double apart =
        (of_bent.map.heights / of_bent.rms_height - order.map.heights / order.rms_height).abs().maxCoeff();
    CHECK(apart < 1e-13);
    for (const double score : {-3.0, -0.4, 0.0, 1.0, 3.5})
        CHECK(
            test::relative_error(of_bent.curve.height(score), std::exp(order.curve.height(score) / order.rms_height)) <
            3e-3);  // straight between knots: 1/512 in the middle, more in the tails
    map.heights.setConstant(2);
    CHECK_THROWS_AS(detail::gaussian_order(map), domain_error);
}

}  // namespace gaussian_order_test
