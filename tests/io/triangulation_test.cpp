// SPDX-License-Identifier: BSD-3-Clause
// The triangles cover the convex hull, whose area is computed otherwise, and no circle holds a point, in whole numbers.
#include "io/triangulation.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <random>
#include <set>

namespace triangulation_test {

using namespace fstiff::io::detail;

namespace {

/// Exact to 2^-64 for what is compared with 0 here: coordinates below 2^26.
using Wide = long double;

Wide turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return Wide(a.x - c.x) * (b.y - c.y) - Wide(a.y - c.y) * (b.x - c.x);
}

/// Twice the area of the hull, by the chains of Andrew.
Wide hull_area(std::vector<GridPoint> points) {
    std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    Wide area = 0;
    for (int pass = 0; pass < 2; ++pass) {
        std::vector<GridPoint> chain;
        for (const GridPoint& p : points) {
            while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
            chain.push_back(p);
        }
        for (std::size_t i = 1; i + 1 < chain.size(); ++i) area += turn(chain[0], chain[i], chain[i + 1]);
        std::reverse(points.begin(), points.end());
    }
    return area;
}

Wide area_of(const std::vector<GridPoint>& points, const std::vector<Triangle>& triangles) {
    Wide area = 0;
    for (const Triangle& t : triangles) {
        const Wide own = turn(points[t[0]], points[t[1]], points[t[2]]);
        CHECK(own > 0);
        area += own;
    }
    return area;
}

/// Points in the circles of triangles; coordinates up to 2^15 keep the products in 64 bits.
std::size_t points_in_circles(const std::vector<GridPoint>& points, const std::vector<Triangle>& triangles) {
    std::size_t count = 0;
    for (const Triangle& t : triangles)
        for (const GridPoint& d : points) {
            const GridPoint &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
            const auto lift = [&](const GridPoint& p) {
                return Wide(p.x - d.x) * (p.x - d.x) + Wide(p.y - d.y) * (p.y - d.y);
            };
            count += lift(a) * turn(b, c, d) + lift(b) * turn(c, a, d) + lift(c) * turn(a, b, d) > 0;
        }
    return count;
}

std::vector<GridPoint> random_points(std::mt19937& random, std::size_t count, std::uint32_t below) {
    std::set<std::pair<std::int32_t, std::int32_t>> places;
    while (places.size() < count) places.insert({std::int32_t(random() % below), std::int32_t(random() % below)});
    std::vector<GridPoint> points;
    for (const auto& [x, y] : places) points.push_back({x, y});
    std::shuffle(points.begin(), points.end(), random);
    return points;
}

}  // namespace

TEST_CASE("No circle of a triangle holds a point, and the triangles cover the hull", "[triangulation]") {
    std::mt19937 random(70);
    for (const auto& [count, below] : {std::pair(300u, 32768u), {250u, 17u}, {60u, 9u}}) {
        const auto points = random_points(random, count, below);
        const auto triangles = delaunay(points);
        CHECK(area_of(points, triangles) == hull_area(points));
        CHECK(points_in_circles(points, triangles) == 0);
    }
    for (int i = 0; i < 300; ++i) {  // few points, many of them on lines and circles
        const auto points = random_points(random, 3 + random() % 20, 6);
        const auto triangles = delaunay(points);
        CHECK(area_of(points, triangles) == hull_area(points));
        CHECK(points_in_circles(points, triangles) == 0);
    }
}

TEST_CASE("A raster, a circle, a line and far points are triangulated", "[triangulation]") {
    std::vector<GridPoint> raster, line, circle;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 50; ++j) raster.push_back({i * 670000, j * 670000});
    CHECK(delaunay(raster).size() == 2 * 99 * 49);
    CHECK(area_of(raster, delaunay(raster)) == hull_area(raster));
    for (int i = 0; i < 1000; ++i) line.push_back({i, 2 * i});
    CHECK(delaunay(line).empty());
    line.push_back({0, 1});
    CHECK(delaunay(line).size() == 999);
    for (int i = 0; i < 4000; ++i) {
        const double angle = 6.283185307179586 * i / 4000;
        circle.push_back(
            {std::int32_t(33554432 * (1 + std::cos(angle))), std::int32_t(33554432 * (1 + std::sin(angle)))});
    }
    CHECK(area_of(circle, delaunay(circle)) == hull_area(circle));
    CHECK(delaunay({{0, 0}, {most_grid_position, most_grid_position}, {most_grid_position, 0}, {1, 1}}).size() == 2);
    CHECK(delaunay({}).empty());
    CHECK(delaunay({{1, 2}, {3, 4}}).empty());
}

}  // namespace triangulation_test
