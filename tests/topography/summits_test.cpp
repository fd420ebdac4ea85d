// SPDX-License-Identifier: BSD-3-Clause
// Truth: areal_statistics.hpp, which sums over the same summits; paraboloids, turned and off the grid; waves.
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/summits.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace summits_test {

using namespace fstiff;

TEST_CASE("the summits of a map add up to its statistics") {
    HeightMap<double> map;
    map.dx = 2e-6;
    map.dy = 3e-6;
    map.heights.resize(60, 80);  // waves of about twelve points, so that every summit has a top
    for (Eigen::Index j = 0; j < 60; ++j)
        for (Eigen::Index i = 0; i < 80; ++i) {
            const auto x = static_cast<double>(i), y = static_cast<double>(j);
            map.heights(j, i) =
                5e-6 + 1e-7 * (std::sin(0.5 * x + 0.3) * std::cos(0.55 * y) + 0.3 * std::sin(0.37 * x + 0.2 * y));
        }
    map.heights(20, 30) = std::nan("");
    const auto statistics = detail::areal_statistics(map);
    const auto found = summits_of(map);
    REQUIRE(found.summits.size() == statistics.summits);
    REQUIRE(statistics.summits > 10);
    CHECK(found.ridges == 0);
    double height = 0, curvature = 0;
    for (const auto& summit : found.summits) {
        height += summit.height;
        curvature += 1 / summit.radius();
        CHECK(summit.max_curvature >= summit.min_curvature);
    }
    const auto n = static_cast<double>(found.summits.size());
    CHECK(height / n > statistics.summit_height);  // tops lie above the points
    CHECK(height / n < statistics.summit_height + 1e-8);
    CHECK(curvature / n > statistics.summit_curvature);  // which loses (pi/12)^2/3
    CHECK(curvature / n < statistics.summit_curvature * 1.03);
    CHECK(test::relative_error(found.rms_height, statistics.rms_height) < 1e-12);
    CHECK(test::relative_error(n / found.area, statistics.summit_density) < 1e-14);
    for (std::size_t i = 1; i < found.summits.size(); ++i)
        CHECK(found.summits[i].height <= found.summits[i - 1].height);
}

TEST_CASE("every summit of point-to-point noise is counted and those without a top separately") {
    HeightMap<double> map;
    map.dx = map.dy = 1e-6;
    map.heights = 1e-7 * Eigen::ArrayXXd::Random(60, 80);
    const auto found = summits_of(map);
    CHECK(found.ridges > 0);
    CHECK(found.summits.size() + found.ridges == detail::areal_statistics(map).summits);
}

TEST_CASE("a paraboloid is one summit of its principal curvatures, with its top between the points") {
    const double k1 = 1 / 4e-6, k2 = 1 / 9e-6;
    for (const double angle : {0.0, 0.3, 1.2, 2.5}) {
        HeightMap<double> map;
        map.dx = 1e-7;
        map.dy = 1.4e-7;
        map.heights.resize(21, 23);
        const double x0 = 12.35e-7, y0 = 1.4 * 9.4e-7, c = std::cos(angle), s = std::sin(angle);
        for (Eigen::Index j = 0; j < 21; ++j)
            for (Eigen::Index i = 0; i < 23; ++i) {
                const double x = static_cast<double>(i) * map.dx - x0, y = static_cast<double>(j) * map.dy - y0;
                map.heights(j, i) = -k1 * std::pow(c * x + s * y, 2) / 2 - k2 * std::pow(c * y - s * x, 2) / 2;
            }
        const auto found = summits_of(map);
        CAPTURE(angle);
        REQUIRE(found.summits.size() == 1);
        const auto& top = found.summits[0];
        CHECK(test::relative_error(top.max_curvature, k1) < 1e-11);
        CHECK(test::relative_error(top.min_curvature, k2) < 1e-11);
        CHECK(test::relative_error(top.x, x0) < 1e-12);
        CHECK(test::relative_error(top.y, y0) < 1e-12);
        CHECK(test::relative_error(top.height, -map.heights.mean()) < 1e-12);
        CHECK(found.dx == map.dx);
    }
}

TEST_CASE("curvatures and tops of a wave of n points are short by the error of five points") {
    const double pi = std::numbers::pi;
    for (const int n : {8, 16, 64}) {
        HeightMap<double> map;
        map.dx = map.dy = 1.0 / n;
        map.heights.resize(2 * n, 2 * n);
        for (Eigen::Index j = 0; j < 2 * n; ++j)
            for (Eigen::Index i = 0; i < 2 * n; ++i)
                map.heights(j, i) = std::cos(2 * pi * (static_cast<double>(i) / n - 1.3 / n - 0.5)) +
                                    std::cos(2 * pi * (static_cast<double>(j) / n - 0.2 / n - 0.5));
        const auto found = summits_of(map);
        REQUIRE(found.summits.size() == 4);
        for (const auto& top : found.summits) {
            CAPTURE(n, top.height, top.max_curvature);
            // the cosine of 0.3 of a step off the top, and the difference of the fourth order
            const double lost = std::pow(pi / n, 4) * 8 / 45 + std::pow(2 * pi * 0.3 / n, 2) / 2;
            CHECK(std::abs(top.max_curvature / (4 * pi * pi) - 1) < 1.01 * lost);
            CHECK(std::abs(top.min_curvature / (4 * pi * pi) - 1) < 1.01 * lost);
            CHECK(std::abs(top.height - 2) < 0.5 * std::pow(2 * pi / n, 4) * 0.3 * 0.3);
        }
    }
}

}  // namespace summits_test
