// SPDX-License-Identifier: BSD-3-Clause
// Clouds and meshes on a grid against scipy's LinearNDInterpolator, planes, closed forms and what does not change them.
#include "io/gridded.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <random>

namespace gridded_test {

using namespace fstiff;
using namespace fstiff::io::detail;
using test::contains;

namespace {

PointCloud random_cloud(std::size_t count, const auto& height, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 1);
    PointCloud cloud;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = 8 * place(random), y = 5 * place(random);
        cloud.points.push_back({x, y, height(x, y)});
    }
    return cloud;
}

RawMap map_of(const PointCloud& cloud, double step, io::Record& record) {
    io::SurfaceOptions options;
    options.grid = step;
    if (!cloud.faces.empty()) options.grid_origin = {0, 0};
    return gridded(cloud, "file", options, record);
}
RawMap map_of(const PointCloud& cloud, double step) {
    io::Record record;
    return map_of(cloud, step, record);
}
std::string refusal(const PointCloud& cloud, double step = 0.2) {
    return test::refusal([&] { (void)map_of(cloud, step); });
}

const auto plane = [](double x, double y) { return 3 + 0.25 * x - 0.4 * y; };
const auto wave = [](double x, double y) { return 0.1 * std::sin(2 * x) * std::cos(3 * y); };

}  // namespace

TEST_CASE("A random cloud has the heights of scipy's LinearNDInterpolator", "[gridded]") {
    const test::Table table("cloud_on_grid.csv");
    PointCloud cloud;
    for (std::size_t row = 0; row < table.size(); ++row)
        if (table.text(row, "kind") == "point")
            cloud.points.push_back({table.input(row, "x"), table.input(row, "y"), table.input(row, "z")});
    io::SurfaceOptions options;
    options.grid = 0.25;
    options.grid_origin = {0, 0};
    io::Record record;
    const RawMap map = gridded(cloud, "file", options, record);
    std::size_t nodes = 0, there = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        if (table.text(row, "kind") != "node") continue;
        ++nodes;
        const double i = (table.input(row, "x") - (*record.origin)[0]) / 0.25,
                     j = (table.input(row, "y") - (*record.origin)[1]) / 0.25;
        REQUIRE(std::abs(i - std::round(i)) < 1e-9);
        if (i < -0.5 || j < -0.5 || i > double(map.columns) - 0.5 || j > double(map.rows) - 0.5) continue;
        const double z = map.at(std::size_t(std::lround(j)), std::size_t(std::lround(i)));
        if (std::isnan(z)) continue;
        ++there;
        CHECK(std::abs(z - table.input(row, "z")) < 1e-12);
    }
    CHECK(nodes == 526);
    CHECK(there > 0.9 * double(nodes));  // the others are in triangles that bridge, or of an outer line
}

TEST_CASE("Planes are reproduced, in any order of the points and any unit", "[gridded]") {
    const PointCloud cloud = random_cloud(3000, plane);
    io::Record record;
    const RawMap map = map_of(cloud, 0.1, record);
    std::size_t there = 0;
    for (std::size_t j = 0; j < map.rows; ++j)
        for (std::size_t i = 0; i < map.columns; ++i) {
            if (std::isnan(map.at(j, i))) continue;
            ++there;
            const double x = (*record.origin)[0] + 0.1 * double(i), y = (*record.origin)[1] + 0.1 * double(j);
            CHECK(std::abs(map.at(j, i) - plane(x, y)) < 1e-13 * 4);
        }
    CHECK(there > 0.99 * double(map.heights.size()));

    const PointCloud waves = random_cloud(3000, wave);
    const RawMap first = map_of(waves, 0.1);
    PointCloud shuffled = waves;
    std::shuffle(shuffled.points.begin(), shuffled.points.end(), std::mt19937(2));
    PointCloud rotated = waves;
    std::rotate(rotated.points.begin(), rotated.points.begin() + 1234, rotated.points.end());
    for (const PointCloud& other : {shuffled, rotated}) {
        const RawMap again = map_of(other, 0.1);
        REQUIRE(again.heights.size() == first.heights.size());
        for (std::size_t i = 0; i < first.heights.size(); ++i)
            CHECK(((std::isnan(first.heights[i]) && std::isnan(again.heights[i])) ||
                   std::abs(first.heights[i] - again.heights[i]) < 1e-13));
    }
    PointCloud small = waves;
    small.units = {1e-6, 1e-6, 1e-6};
    const RawMap micro = map_of(small, 0.1e-6);
    REQUIRE(micro.heights.size() == first.heights.size());
    for (std::size_t i = 0; i < first.heights.size(); ++i)
        CHECK(((std::isnan(first.heights[i]) && std::isnan(micro.heights[i])) ||
               std::abs(first.heights[i] - 1e6 * micro.heights[i]) < 1e-12));
}

TEST_CASE("A grid that scatters keeps its nodes, and a raster is itself", "[gridded]") {
    std::mt19937 random(3);
    std::normal_distribution<double> scatter(0, 0.01);
    for (const double size : {0.0, 1.0}) {
        PointCloud cloud;
        for (int j = 0; j < 40; ++j)
            for (int i = 0; i < 60; ++i) {
                const double x = 7 + i + size * scatter(random), y = -3 + j + size * scatter(random);
                cloud.points.push_back({x, y, 0.3 * wave(0.2 * x, 0.2 * y)});
            }
        io::Record record;
        const RawMap map = map_of(cloud, 1, record);
        CHECK(map.columns >= (size == 0 ? 60 : 58));
        CHECK(map.rows >= (size == 0 ? 40 : 38));
        CHECK(present(map) == map.heights.size());
        for (const double place : *record.origin) CHECK(std::abs(place - std::round(place)) < 1e-3);
        for (std::size_t j = 0; j < map.rows; ++j)
            for (std::size_t i = 0; i < map.columns; ++i) {
                const double x = std::round((*record.origin)[0]) + double(i),
                             y = std::round((*record.origin)[1]) + double(j);
                // (d^2/8) |z''| of a diagonal of a cell: 2/8 x 0.03 x (0.4^2 + 0.6^2)
                CHECK(std::abs(map.at(j, i) - 0.3 * wave(0.2 * x, 0.2 * y)) < (size == 0 ? 1e-13 : 4e-3));
            }
    }
}

TEST_CASE("Holes and what is outside of the hull are missing", "[gridded]") {
    PointCloud cloud;
    for (const auto& point : random_cloud(6000, wave).points)
        if (std::hypot(point[0] - 4, point[1] - 2.5) > 1 && std::hypot(point[0] - 4, point[1] - 2.5) < 2.4)
            cloud.points.push_back(point);
    io::Record record;
    const RawMap map = map_of(cloud, 0.1, record);
    const double area = double(present(map)) * 0.01, ring = std::numbers::pi * (2.4 * 2.4 - 1);
    CHECK(std::abs(area / ring - 1) < 0.08);  // triangles reach over the rims by up to half a long edge
    CHECK(contains(record.said("triangles"), "bridges holes and is left out"));
}

TEST_CASE("The effect of the step on sigma and g is that of closed forms", "[gridded]") {
    PointCloud cloud;  // 64 points a wave of cos x: sigma is 1/sqrt(2), and g over steps h is 2 sin(h/2)/h of it
    const double point = 2 * std::numbers::pi / 64, step = 8 * point;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 64 * 64; ++i) cloud.points.push_back({point * i, point * j, std::cos(point * i)});
    io::Record record;
    (void)map_of(cloud, step, record);
    const std::string said = record.said("grid");
    double sigma[3], g[3];
    REQUIRE(std::sscanf(said.c_str(),
                        "step 785.4 mm: sigma and gradient %lf mm and %lf from the plane; at twice the step %lf mm and "
                        "%lf, of the triangles %lf mm and %lf",
                        &sigma[0], &g[0], &sigma[1], &g[1], &sigma[2], &g[2]) == 6);
    const double steps[] = {step, 2 * step, point};
    for (int k = 0; k < 3; ++k) {  // three digits, and 64 waves that end within one
        CHECK(test::relative_error(sigma[k], 1000 / std::numbers::sqrt2) < 5e-3);
        CHECK(test::relative_error(g[k], 2 * std::sin(steps[k] / 2) / steps[k] / std::numbers::sqrt2) < 5e-3);
    }
}

TEST_CASE("The faces of a mesh count, and of two the upper one", "[gridded]") {
    PointCloud mesh;  // a roof: without its faces the ridge would be cut
    mesh.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 1}};
    mesh.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const RawMap roof = map_of(mesh, 1);
    REQUIRE(roof.heights.size() == 25);
    CHECK(roof.at(2, 2) == 1);
    CHECK(std::abs(roof.at(1, 2) - 0.5) < 1e-15);
    CHECK(roof.at(0, 3) == 0);
    mesh.faces = {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};  // all turned over: seen from below
    CHECK(map_of(mesh, 1).heights == roof.heights);
    mesh.faces = {{0, 1, 4}, {1, 2, 4}, {2, 4, 3}, {3, 0, 4}};
    CHECK(contains(refusal(mesh, 1), "25 % of its faces, by their area in x and y, lie over or under others"));
    mesh.faces = {{0, 1, 2}, {2, 3, 0}};
    mesh.points.insert(mesh.points.end(), {{1.9, 1.9, 0.5}, {2.1, 1.9, 0.5}, {2.0, 2.1, 0.5}});
    mesh.faces.push_back({5, 6, 7});  // a crumb of 0.02 of 16 above the plate
    CHECK(map_of(mesh, 1).at(2, 2) == 0.5);
}

TEST_CASE("What is no field of heights is refused in words", "[gridded]") {
    PointCloud cloud = random_cloud(2000, wave);
    for (std::size_t i = 0; i < cloud.points.size(); i += 2) cloud.points[i][2] += 40;
    CHECK(contains(refusal(cloud), "neighbouring heights differ by more than 10 times their distance"));
    cloud = random_cloud(2000, wave);
    const auto points = cloud.points;
    for (auto point : points) point[2] += 1, cloud.points.push_back(point);
    CHECK(contains(refusal(cloud), "2000 of 4000 points have the x and y of another one and another height"));
    CHECK(contains(refusal(random_cloud(2000, [](double x, double) { return 1.2 * x; })),
                   "tilted by 50 degrees; must be turned until z is along its height"));
    io::Record record;
    (void)map_of(random_cloud(2000, [](double x, double y) { return 0.5 * x + wave(x, y); }), 0.2, record);
    CHECK(record.warnings.size() == 1);
    PointCloud line{.points = {{0, 0, 1}, {1, 1, 2}, {2, 2, 1}, {3, 3, 0}}};
    CHECK(contains(refusal(line), "on one line"));
    CHECK(contains(refusal({.points = {{0, 0, 1}, {1, 1, 2}}}), "holds 2 points"));
    CHECK(contains(refusal({.points = {{1, 1, 1}, {1, 1, 2}, {1, 1, 3}}}), "on one line"));
    CHECK(contains(refusal(random_cloud(100, wave), 1e-6), "file: grid = 1 um: must be at least "));
    CHECK(contains(refusal(random_cloud(100, wave), 4), "a third of the shorter side"));
    CHECK(contains(refusal(random_cloud(100, wave), -1), "grid"));
    PointCloud gaps = random_cloud(2000, wave);
    for (std::size_t i = 0; i < 10; ++i) gaps.points[i][2] = std::numeric_limits<double>::quiet_NaN();
    gaps.points[11][0] = std::numeric_limits<double>::infinity();
    (void)map_of(gaps, 0.2, record);
    CHECK(contains(record.said("triangles"), "triangulation"));
}

TEST_CASE("The proposed grid is the median distance of neighbours", "[gridded]") {
    PointCloud raster{.units = {1e-3, 1e-3, 1e-3}, .unit_names = {"mm", "mm", "mm"}};
    for (int j = 0; j < 50; ++j)
        for (int i = 0; i < 50; ++i) raster.points.push_back({0.2 * i, 0.2 * j, 0.01 * ((7 * i + 3 * j) % 5)});
    CHECK(proposed_grid(raster, "file", {.prefix = "--", .equals = " "}).starts_with("--grid \"0.2 mm\""));
}

}  // namespace gridded_test
