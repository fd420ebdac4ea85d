// SPDX-License-Identifier: BSD-3-Clause
// Mean and rms of heights that are known by hand, and against the statistics of the same map.
#include <fstiff/topography/areal_statistics.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace height_map_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("Mean and rms of a map take the points that exist, whatever the offset", "", FSTIFF_SCALARS) {
    using T = TestType;
    const T missing = std::numeric_limits<T>::quiet_NaN(), offset = GENERATE(T(0), T(1024));
    HeightMap<T> map{typename HeightMap<T>::Array(3, 4), T(1), T(2)};
    map.heights << 1, 3, missing, 1, 3, 1, 3, 1, missing, missing, 3, 3;
    map.heights += offset;
    // four of 1, five of 3
    const T mean = T(19) / 9, square = (4 * (1 - mean) * (1 - mean) + 5 * (3 - mean) * (3 - mean)) / 9;
    CHECK(test::ulps(detail::mean_height(map), mean + offset) <= 1);
    CHECK(test::ulps(rms_height(map), std::sqrt(square)) <= 4);
    CHECK(rms_height(map) == detail::areal_statistics(map).rms_height);
}

TEST_CASE("A map without points, or of one height, has no mean or no rms") {
    HeightMap<double> map{HeightMap<double>::Array::Constant(3, 3, std::numeric_limits<double>::quiet_NaN()), 1, 1};
    CHECK(test::refusal([&] { (void)detail::mean_height(map); }) == "map of which 0 points exist: must be at least 1");
    map.heights.setConstant(2);
    CHECK(detail::mean_height(map) == 2);
    CHECK(test::refusal([&] { (void)rms_height(map); }).find("map of constant height") == 0);
}

}  // namespace height_map_test
