// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/upper_half.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace upper_half_test {

using namespace fstiff;

namespace {

constexpr Eigen::Index side = 48;

/// A plateau of slight roughness with a deep hole in one corner, under a plane and a bow, as least squares see it.
struct Face {
    std::vector<double> plateau, heights;

    explicit Face(double tilt, double bow, double depth = 1, Eigen::Index rows = side) {
        for (Eigen::Index j = 0; j < rows; ++j)
            for (Eigen::Index i = 0; i < side; ++i) {
                const double u = 2 * static_cast<double>(i) / (side - 1) - 1,
                             v = rows > 1 ? 2 * static_cast<double>(j) / static_cast<double>(rows - 1) - 1 : 0;
                const bool hole = i < side / 4 && j <= rows / 3;
                const double rough = 0.01 * std::sin(2.9 * static_cast<double>(i * i + 7 * j));
                plateau.push_back(rough - (hole ? depth : 0));
                heights.push_back(plateau.back() + tilt * (u - 2 * v) + bow * (u * u - u * v));
            }
    }
};

double range_of_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (!std::isnan(a[k])) low = std::min(low, a[k] - b[k]), high = std::max(high, a[k] - b[k]);
    return high - low;
}

}  // namespace

TEST_CASE("A plateau with a hole rests on its upper half, whatever plane or bow was left of it") {
    const Eigen::Index rows = GENERATE(Eigen::Index(1), side);
    for (const int degree : {1, 2}) {
        const double tilt = 0.1, bow = degree == 2 ? 0.05 : 0;
        Face face(tilt, bow, 1, rows);
        const auto removed = math::settle_on_upper_half(face.heights.data(), rows, side, degree);
        REQUIRE(removed);
        // the roughness of +-0.01 makes a form of its own, of a line by 18 points; least squares leave some 0.3
        CHECK(range_of_difference(face.heights, face.plateau) < (rows > 1 ? 0.006 : 0.015));
        double mean = 0;
        for (const double z : face.heights) mean += z;
        CHECK(std::abs(mean) < 1e-12 * static_cast<double>(face.heights.size()));
        if (degree == 1) {
            CHECK(std::abs((*removed)[0] - 2 * tilt) < 0.006);
            if (rows > 1) CHECK(std::abs((*removed)[1] + 4 * tilt) < 0.006);
        }
    }
}

TEST_CASE("Heights without valleys keep the form of least squares, and missing points stay missing") {
    Face peaks(0.1, 0, -1);  // a hill in place of the hole
    const std::vector<double> before = peaks.heights;
    CHECK_FALSE(math::settle_on_upper_half(peaks.heights.data(), side, side, 1));
    CHECK(peaks.heights == before);

    Face face(0.1, 0);
    Face holes = face;
    for (std::size_t k = 5; k < holes.heights.size(); k += 11)
        holes.heights[k] = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(math::settle_on_upper_half(holes.heights.data(), side, side, 1));
    for (std::size_t k = 5; k < holes.heights.size(); k += 11) CHECK(std::isnan(holes.heights[k]));
    CHECK(range_of_difference(holes.heights, holes.plateau) < 0.006);

    std::vector<double> none(16, std::numeric_limits<double>::quiet_NaN()), level(16, 1.0);
    CHECK_FALSE(math::settle_on_upper_half(none.data(), 4, 4, 1));
    CHECK_FALSE(math::settle_on_upper_half(level.data(), 4, 4, 1));
    std::vector<double> pit(25, 0.0);  // no point is above the median
    pit[12] = -1;
    REQUIRE(math::settle_on_upper_half(pit.data(), 5, 5, 1));
    CHECK(std::abs(pit[0] - 0.04) < 1e-15);
}

TEST_CASE("The plane of the upper half does not depend on the unit of the heights") {
    Face face(0.1, 0);
    for (const double unit : {1e9, 1e-9, 0x1p900, 0x1p-990}) {
        Face scaled = face;
        for (double& z : scaled.heights) z *= unit;
        REQUIRE(math::settle_on_upper_half(scaled.heights.data(), side, side, 1));
        for (double& z : scaled.heights) z /= unit;
        CHECK(range_of_difference(scaled.heights, face.plateau) < 0.006);
    }
}

}  // namespace upper_half_test
