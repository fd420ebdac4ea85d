// SPDX-License-Identifier: BSD-3-Clause
// Truth: areal_statistics.hpp, which sums over the same summits; one paraboloid.
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/summits.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace summits_test {

using namespace fstiff;

TEST_CASE("the summits of a map add up to its statistics") {
    HeightMap<double> map;
    map.dx = 2e-6;
    map.dy = 3e-6;
    map.heights = 5e-6 + 1e-7 * Eigen::ArrayXXd::Random(60, 80);
    map.heights(20, 30) = std::nan("");
    const auto statistics = areal_statistics(map);
    const auto found = summits_of(map);
    REQUIRE(found.summits.size() == statistics.summits);
    double height = 0, curvature = 0;
    for (const auto& summit : found.summits) {
        height += summit.height;
        curvature += (summit.curvature_x + summit.curvature_y) / 2;
        CHECK(summit.radius() > 0);
    }
    const auto n = static_cast<double>(found.summits.size());
    CHECK(test::relative_error(height / n, statistics.summit_height) < 1e-12);
    CHECK(test::relative_error(curvature / n, statistics.summit_curvature) < 1e-12);
    CHECK(test::relative_error(found.rms_height, statistics.rms_height) < 1e-12);
    CHECK(test::relative_error(n / found.area, statistics.summit_density) < 1e-14);
    for (std::size_t i = 1; i < found.summits.size(); ++i)
        CHECK(found.summits[i].height <= found.summits[i - 1].height);
}

TEST_CASE("a paraboloid is one summit of its curvatures") {
    HeightMap<double> map;
    map.dx = map.dy = 1e-7;
    map.heights.resize(21, 21);
    for (Eigen::Index j = 0; j < 21; ++j)
        for (Eigen::Index i = 0; i < 21; ++i)
            map.heights(j, i) = -std::pow(static_cast<double>(i - 12) * 1e-7, 2) / (2 * 4e-6) -
                                std::pow(static_cast<double>(j - 9) * 1e-7, 2) / (2 * 8e-6);
    const auto found = summits_of(map);
    REQUIRE(found.summits.size() == 1);
    const auto& top = found.summits[0];
    CHECK(test::relative_error(top.curvature_x, 1 / 4e-6) < 1e-12);
    CHECK(test::relative_error(top.curvature_y, 1 / 8e-6) < 1e-12);
    CHECK(test::relative_error(top.x, 12e-7) < 1e-15);
    CHECK(test::relative_error(top.y, 9e-7) < 1e-15);
    CHECK(test::relative_error(top.height, -map.heights.mean()) < 1e-12);
}

}  // namespace summits_test
