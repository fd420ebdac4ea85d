// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/round_fit.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <array>
#include <vector>

namespace round_fit_test {

using namespace fstiff;
using namespace fstiff::math;

namespace {

using Points = std::vector<std::array<double, 3>>;

/// Heights of the surface of \p radius, below 0 where it is hollow, with its top at (0.1, -0.05, 0); of a cylinder with
/// its axis at \p axis. Each point is \p above(i) away from it.
template <class Above>
Points points_of(RoundShape shape, double radius, double axis, const Above& above) {
    Points points;
    const bool line = shape == RoundShape::circle;
    for (int j = 0; j < (line ? 1 : 41); ++j)
        for (int i = 0; i < (line ? 401 : 41); ++i) {
            const double x = line ? i / 200.0 - 1 : i / 20.0 - 1, y = line ? 0 : j / 20.0 - 1;
            const double a = x - 0.1, b = y + 0.05, across = -a * std::sin(axis) + b * std::cos(axis);
            const double square = line ? a * a : shape == RoundShape::sphere ? a * a + b * b : across * across;
            const double side = std::copysign(1.0, radius), r = radius + above(points.size());
            points.push_back({x, y, side * std::sqrt(r * r - square) - radius});
        }
    return points;
}

RoundSurface fit(RoundShape shape, const Points& points, double radius = 0) {
    return fit_round(shape, radius, [&](const auto& use) {
        for (const auto& [x, y, z] : points) use(x, y, z);
    });
}

double sum_of_squares(const RoundSurface& surface, const Points& points) {
    double sum = 0;
    for (const auto& [x, y, z] : points) {
        const double d = surface.distance(x, y, z);
        sum += d * d;
    }
    return sum;
}

double rough(std::size_t i) {
    return std::fmod(static_cast<double>(i) * static_cast<double>(i) * 0.6180339887498949, 2.0) - 1;
}

constexpr RoundShape shapes[] = {RoundShape::circle, RoundShape::sphere, RoundShape::cylinder};

}  // namespace

TEST_CASE("Points on a circle, a sphere or a cylinder give its radius and no distance") {
    for (const RoundShape shape : shapes)
        for (const double radius : {4.0, -4.0, 30.0, -1e3, 1e4})
            for (const double axis : {0.0, 0.7, 1.6, 3.0}) {
                CAPTURE(int(shape), radius, axis);
                const Points points = points_of(shape, radius, axis, [](std::size_t) { return 0.0; });
                const RoundSurface found = fit(shape, points);
                // the rounding of the heights, of the order of that of the radius, over the sagitta of 1/(2 R)
                CHECK(test::relative_error(1 / found.curvature(), radius) < 20 * 1.1e-16 * radius * radius + 1e-14);
                CHECK(std::sqrt(sum_of_squares(found, points) / double(points.size())) <
                      1.2e-16 * std::abs(radius) + 1e-15);
            }
}

TEST_CASE("Distances are those from the centre, or from the axis") {
    const RoundSurface ball =
        fit(RoundShape::sphere, points_of(RoundShape::sphere, 5, 0, [](std::size_t) { return 0.0; }));
    const RoundSurface rod =
        fit(RoundShape::cylinder, points_of(RoundShape::cylinder, -5, 0.7, [](std::size_t) { return 0.0; }));
    for (const double x : {-0.9, 0.3})
        for (const double y : {-0.4, 0.8})
            for (const double z : {-0.5, 0.0, 2.0}) {
                CHECK(std::abs(ball.distance(x, y, z) - (std::hypot(x - 0.1, y + 0.05, z + 5) - 5)) < 1e-14);
                const double across = -(x - 0.1) * std::sin(0.7) + (y + 0.05) * std::cos(0.7);
                CHECK(std::abs(rod.distance(x, y, z) - (5 - std::hypot(across, z - 5))) < 1e-14);
            }
}

TEST_CASE("No change of a term makes the squares of the distances smaller") {
    for (const RoundShape shape : shapes)
        for (const double kept : {0.0, 6.5}) {
            const Points points = points_of(shape, 6, 0.7, [](std::size_t i) { return 1e-4 * rough(i); });
            const RoundSurface found = fit(shape, points, kept);
            const double least = sum_of_squares(found, points);
            if (kept > 0) CHECK(found.curvature() == 1 / kept);
            for (Eigen::Index k = kept > 0 ? 1 : 0; k < found.count(); ++k)
                for (const double step : {-1e-6, 1e-6}) {
                    RoundSurface other = found;
                    other.terms[k] += step;
                    CAPTURE(int(shape), kept, k, step);
                    CHECK(sum_of_squares(other, points) > least);
                }
        }
}

TEST_CASE("Points that do not determine the form, and steep ones, are refused") {
    const Points plane = points_of(RoundShape::sphere, 1e9, 0, [](std::size_t i) { return 1e-4 * rough(i); });
    CHECK(test::refused_for("points determine 2 of the 3 terms", [&] {
        return fit(RoundShape::circle, {{0, 0, 0}, {1, 0, 1}});
    }));
    CHECK(test::refused_for("must be curved", [&] {
        return fit(RoundShape::cylinder, points_of(RoundShape::cylinder, 1e12, 0, [](std::size_t) { return 0.0; }));
    }));
    CHECK(test::refused_for("degrees from the height: must be at most 30", [&] {
        return fit(RoundShape::sphere, points_of(RoundShape::sphere, 1.9, 0, [](std::size_t) { return 0.0; }));
    }));
    CHECK(std::abs(1 / fit(RoundShape::sphere, plane).curvature()) > 1e3);
}

}  // namespace round_fit_test
