// SPDX-License-Identifier: BSD-3-Clause
// Truth: planes and waves in closed form; Gaussian maps in the mean; numpy on maps with and without missing points.
#include <fstiff/topography/areal_statistics.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"
#include "support/roughness_reference.hpp"

#include <numbers>

namespace areal_parameters_test {

using namespace fstiff;

TEST_CASE("Areal parameters are those that numpy finds") {
    for (const std::string source : {"map_gaussian", "map_skewed", "map_oblong", "map_holes"}) {
        CAPTURE(source);
        auto expected = test::roughness_reference(source);
        const auto found = areal_parameters(test::reference_map(source));
        CHECK(test::relative_error(found.mean_deviation, expected.at("Sa_m")) < 1e-9);
        CHECK(test::relative_error(found.rms_height, expected.at("Sq_m")) < 1e-9);
        CHECK(test::relative_error(found.skewness, expected.at("Ssk")) < 1e-9);
        CHECK(test::relative_error(found.kurtosis, expected.at("Sku")) < 1e-9);
        CHECK(test::relative_error(found.max_peak_height, expected.at("Sp_m")) < 1e-9);
        CHECK(test::relative_error(found.max_pit_depth, expected.at("Sv_m")) < 1e-9);
        CHECK(test::relative_error(found.max_height, expected.at("Sz_m")) < 1e-9);
        CHECK(test::relative_error(found.rms_gradient, expected.at("Sdq")) < 1e-9);
        CHECK(test::relative_error(*found.developed_area_ratio, expected.at("Sdr")) < 1e-9);
    }
}

TEST_CASE("A tilted plane with one wave: the moments of a sine, and the area of a plane") {
    HeightMap<double> map;
    map.dx = 2e-6;
    map.dy = 3e-6;
    map.heights.resize(40, 64);
    for (Eigen::Index j = 0; j < 40; ++j)
        for (Eigen::Index i = 0; i < 64; ++i)
            map.heights(j, i) = 1e-3 + 0.3 * static_cast<double>(i) * map.dx - 0.4 * static_cast<double>(j) * map.dy;
    const auto plane = areal_parameters(map);
    CHECK(test::relative_error(*plane.developed_area_ratio, std::sqrt(1.25) - 1) < 1e-10);
    CHECK(test::relative_error(plane.rms_gradient, 0.5) < 1e-10);
    for (Eigen::Index i = 0; i < 64; ++i)
        map.heights.col(i) = 1e-3 + 2e-6 * std::sin(2 * std::numbers::pi * (static_cast<double>(i) + 0.25) / 16);
    const auto wave = areal_parameters(map);
    CHECK(test::relative_error(wave.rms_height, std::sqrt(2e-12)) < 1e-9);  // offset 500 times the wave
    CHECK(std::abs(wave.skewness) < 1e-9);
    CHECK(test::relative_error(wave.kurtosis, 1.5) < 1e-9);
    CHECK(wave.max_height == wave.max_peak_height + wave.max_pit_depth);
}

TEST_CASE("Sdr of an egg-box is the mean of its area by quadrature, and not the product of mean lengths") {
    constexpr double pi = std::numbers::pi;
    for (const double steepness : {0.05, 0.5, 2.0}) {  // amplitude times wave number
        CAPTURE(steepness);
        double area = 0, length = 0;  // of the function itself, which is periodic: the trapezoidal rule is exact
        for (int i = 0; i < 400; ++i)
            for (int j = 0; j < 400; ++j) {
                const double x = 2 * pi * i / 400, y = 2 * pi * j / 400;
                const double u = steepness * std::sin(x) * std::cos(y), v = steepness * std::cos(x) * std::sin(y);
                area += (std::sqrt(1 + u * u + v * v) - 1) / 160000;
                length += std::sqrt(1 + u * u) / 160000;
            }
        HeightMap<double> map;
        map.dx = map.dy = 2 * pi / 200;
        map.heights.resize(401, 401);
        for (Eigen::Index j = 0; j < 401; ++j)
            for (Eigen::Index i = 0; i < 401; ++i)
                map.heights(j, i) =
                    steepness * std::cos(static_cast<double>(i) * map.dx) * std::cos(static_cast<double>(j) * map.dy);
        const double found = *areal_parameters(map).developed_area_ratio;
        CHECK(test::relative_error(found, area) < 1.5e-4);  // 200 steps a wave take (pi/200)^2/3 of a slope squared
        CHECK(length * length - 1 - found > 0.05 * steepness * steepness * found);  // the product of Stout
    }
}

TEST_CASE("Gaussian heights have Ssk 0, Sku 3 and Sa = sqrt(2/pi) Sq, within the scatter of their number") {
    test::Normal normal(7);
    HeightMap<double> map;
    map.dx = map.dy = 1e-6;
    map.heights.resize(300, 300);
    for (Eigen::Index k = 0; k < map.size(); ++k) map.heights.data()[k] = 1e-7 * normal();
    const auto found = areal_parameters(map);
    const double points = 90000;  // four times the standard errors sqrt(6/N), sqrt(24/N), sqrt((1 - 2/pi)/N)
    CHECK(std::abs(found.skewness) < 4 * std::sqrt(6 / points));
    CHECK(std::abs(found.kurtosis - 3) < 4 * std::sqrt(24 / points));
    CHECK(std::abs(found.mean_deviation / found.rms_height - std::sqrt(2 / std::numbers::pi)) <
          4 * std::sqrt((1 - 2 / std::numbers::pi) / points));
    CHECK(test::relative_error(found.rms_gradient, 2 * found.rms_height / 1e-6) < 0.02);  // of unrelated neighbours
}

TEST_CASE("The unit of length leaves ratios, and a small slope keeps the digits of its area") {
    const auto map = test::reference_map("map_skewed");
    auto small = map;
    small.heights *= 1e-9;
    small.dx *= 1e-9;
    small.dy *= 1e-9;
    const auto a = areal_parameters(map), b = areal_parameters(small);
    CHECK(test::relative_error(b.mean_deviation, 1e-9 * a.mean_deviation) < 1e-13);
    CHECK(test::relative_error(b.skewness, a.skewness) < 1e-12);
    CHECK(test::relative_error(*b.developed_area_ratio, *a.developed_area_ratio) < 1e-12);
    auto flat = map;
    flat.heights *= 1e-7;  // slopes of 1e-8, whose squares are lost in a sum with 1
    const auto c = areal_parameters(flat);
    CHECK(*c.developed_area_ratio > 0);
    CHECK(test::relative_error(*c.developed_area_ratio, c.rms_gradient * c.rms_gradient / 2) <
          0.02);  // but for the border
}

TEST_CASE("A map without a whole cell has no developed area") {
    auto map = test::reference_map("map_gaussian");
    for (Eigen::Index j = 1; j < 256; j += 2)
        for (Eigen::Index i = 1; i < 256; i += 2) map.heights(j, i) = std::nan("");
    CHECK_FALSE(areal_parameters(map).developed_area_ratio);
    CHECK(areal_parameters(map).rms_gradient > 0);
}

}  // namespace areal_parameters_test
