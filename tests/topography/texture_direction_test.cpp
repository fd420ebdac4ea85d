// SPDX-License-Identifier: BSD-3-Clause
// Truth: ridges of a known direction; a turn of the map; the mean direction of the gradients, which needs no spectrum.
#include <fstiff/topography/texture_direction.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/height_map.hpp"
#include "support/roughness_reference.hpp"

#include <numbers>
#include <random>

namespace texture_direction_test {

using namespace fstiff;
using test::map_of;

namespace {

constexpr double pi = std::numbers::pi;

/// Std [degrees].
double direction(const HeightMap<double>& map) {
    return *detail::texture_direction(detail::areal_autocorrelation(map)) * 180 / pi;
}
/// The angle between two directions without a sense [degrees].
double apart(double a, double b) {
    const double turn = std::fmod(std::abs(a - b), 180.0);
    return std::min(turn, 180 - turn);
}

/// Ridges in the direction \p degrees from x, \p waves across 100 um.
auto ridges(double degrees, double waves) {
    return [=, s = std::sin(degrees * pi / 180), c = std::cos(degrees * pi / 180)](double x, double y) {
        return std::sin(2 * pi * waves * (c * y - s * x) / 100e-6 + 0.3);
    };
}

}  // namespace

TEST_CASE("Std of tilted ridges is their angle, whatever the steps of the map") {
    for (const double degrees : {0.0, 7.3, 30.0, 45.0, 66.6, 90.0, 101.5, 135.0, 178.0})
        for (const double waves : {3.0, 6.3, 12.7, 31.0}) {
            CAPTURE(degrees, waves);
            const double allowed = waves > 3 ? 0.2 : 5;
            CHECK(apart(direction(map_of(100, 100, 1e-6, 1e-6, ridges(degrees, waves))), degrees) < allowed);
            CHECK(apart(direction(map_of(200, 120, 1e-6, 0.5e-6, ridges(degrees, waves))), degrees) < allowed);
        }
}

TEST_CASE("Std of ridges is theirs with noise, missing points and other unit of length") {
    std::mt19937 random(7);
    std::normal_distribution<double> noise;
    const auto of = ridges(23, 9.4);
    auto map = map_of(128, 128, 1e-6, 1e-6, [&](double x, double y) { return of(x, y) + noise(random); });
    const double whole = direction(map);
    CHECK(apart(whole, 23) < 0.5);
    auto larger = map;
    larger.heights *= 1e9, larger.dx *= 1e9, larger.dy *= 1e9;
    CHECK(apart(direction(larger), whole) < 1e-6);
    for (Eigen::Index k = 0; k < map.size(); k += 7) map.heights.data()[k] = std::nan("");
    CHECK(apart(direction(map), 23) < 0.5);
    // the map turned by a quarter, and mirrored
    HeightMap<double> turned = map;
    turned.heights = map.heights.transpose().eval();
    CHECK(apart(direction(turned), 90 - direction(map)) < 0.02);  // another half of the transform is summed
}

TEST_CASE("Std of a stretched random face is the direction of its gradients") {
    // sums of waves with an elliptical spectrum at 35 degrees
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part;
    auto map = map_of(160, 160, 1e-6, 1e-6, [](double, double) { return 0.0; });
    const double c = std::cos(35 * pi / 180), s = std::sin(35 * pi / 180);
    for (int k = 0; k < 400; ++k) {
        const double angle = 2 * pi * part(random), q = 2 * pi * (4 + 8 * part(random)) / 160e-6;
        const double along = q * std::cos(angle) / 6, across = q * std::sin(angle), phase = 2 * pi * part(random);
        const double qx = c * along - s * across, qy = s * along + c * across;
        map.heights +=
            map_of(160, 160, 1e-6, 1e-6, [&](double x, double y) { return std::sin(qx * x + qy * y + phase); }).heights;
    }
    double xx = 0, xy = 0, yy = 0;
    for (Eigen::Index j = 0; j + 1 < 160; ++j)
        for (Eigen::Index i = 0; i + 1 < 160; ++i) {
            const double x = map.heights(j, i + 1) - map.heights(j, i), y = map.heights(j + 1, i) - map.heights(j, i);
            xx += x * x, xy += x * y, yy += y * y;
        }
    const double of_gradients = (std::atan2(2 * xy, xx - yy) / 2 + pi / 2) * 180 / pi;
    CHECK(apart(of_gradients, 35) < 3);
    CHECK(apart(direction(map), of_gradients) < 5);
}

TEST_CASE("Std does without power where there is none") {
    detail::ArealAutocorrelation<double> one;
    one.reach_x = one.reach_y = 4;
    one.dx = one.dy = 1;
    one.value.setConstant(5, 9, std::nan(""));
    CHECK_FALSE(detail::texture_direction(one));
}

}  // namespace texture_direction_test
