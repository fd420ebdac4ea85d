// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/topography/gaussian_map_filter.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace gaussian_map_filter_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// 1e-7 m of heights that look random, upon a slope, and holes where \p holes.
HeightMap<double> some_map(Eigen::Index columns, Eigen::Index rows, bool holes) {
    HeightMap<double> map{HeightMap<double>::Array(rows, columns), 1e-6, 1.5e-6};
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            const auto k = static_cast<double>(1 + i + 37 * j);
            map.heights(j, i) = 1e-7 * (std::fmod(k * k * 0.6180339887498949, 2.0) + 0.05 * static_cast<double>(i - j));
            if (holes && ((i * j) % 7 == 3 || (i > 20 && i < 30 && j > 8 && j < 15))) map.heights(j, i) = missing;
        }
    return map;
}

/// The double sum of the head of the header, with the weights of the standard as it writes them.
double slow(const HeightMap<double>& map, double cutoff, Eigen::Index j, Eigen::Index i) {
    const double a = std::sqrt(std::numbers::ln2 / std::numbers::pi);
    long double sum = 0, weights = 0;
    for (Eigen::Index k = 0; k < map.rows(); ++k)
        for (Eigen::Index l = 0; l < map.columns(); ++l) {
            if (std::isnan(map.heights(k, l))) continue;
            const long double x = static_cast<double>(l - i) * map.dx, y = static_cast<double>(k - j) * map.dy;
            const long double s =
                std::exp(-std::acos(-1.0L) * (x * x + y * y) / (a * a * cutoff * cutoff)) / (a * a * cutoff * cutoff);
            sum += s * map.heights(k, l);
            weights += s;
        }
    return static_cast<double>(sum / weights);
}

}  // namespace

TEST_CASE("Every point of a filtered map, edges and rims of gaps too, is the weighted mean of the points that exist") {
    for (const bool holes : {false, true}) {
        const auto map = some_map(48, 27, holes);
        for (const double cutoff : {3e-6, 8e-6, 40e-6}) {
            const auto low = detail::gaussian_low_pass(map, cutoff);
            const auto high = detail::gaussian_high_pass(map, cutoff);
            CHECK(low.dx == map.dx);
            CHECK(low.dy == map.dy);
            for (Eigen::Index j = 0; j < map.rows(); ++j)
                for (Eigen::Index i = 0; i < map.columns(); ++i) {
                    CAPTURE(holes, cutoff, i, j);
                    REQUIRE(std::isnan(low.heights(j, i)) == std::isnan(map.heights(j, i)));
                    REQUIRE(std::isnan(high.heights(j, i)) == std::isnan(map.heights(j, i)));
                    if (std::isnan(map.heights(j, i))) continue;
                    REQUIRE(std::abs(low.heights(j, i) - slow(map, cutoff, j, i)) < 1e-13 * 4e-7);
                    REQUIRE(high.heights(j, i) == map.heights(j, i) - low.heights(j, i));
                }
        }
    }
}

TEST_CASE("A wave of a map passes by the closed form in any direction, half of it at the cut-off") {
    HeightMap<double> map{HeightMap<double>::Array(201, 301), 1e-6, 1e-6};
    for (const double angle : {0.0, 0.5, std::numbers::pi / 2}) {
        for (const double length : {10.0, 20.0, 40.0}) {
            for (Eigen::Index j = 0; j < map.rows(); ++j)
                for (Eigen::Index i = 0; i < map.columns(); ++i)
                    map.heights(j, i) = 2e-9 * std::cos(2 * std::numbers::pi / length *
                                                        (std::cos(angle) * static_cast<double>(i - 150) +
                                                         std::sin(angle) * static_cast<double>(j - 100)));
            CAPTURE(angle, length);
            // the crest in the middle, farther from the edges than the weights reach
            CHECK(std::abs(detail::gaussian_low_pass(map, 20e-6).heights(100, 150) / 2e-9 -
                           std::exp(-std::numbers::ln2 * std::pow(20 / length, 2))) < 1e-12);
        }
    }
}

TEST_CASE("A high map is filtered as one at zero, in any unit and scalar") {
    const auto map = some_map(30, 20, true);
    const auto plain = detail::gaussian_low_pass(map, 6e-6);
    auto raised = map;
    raised.heights += 1e-3;
    const auto low = detail::gaussian_low_pass(raised, 6e-6);
    HeightMap<float> narrow{map.heights.cast<float>(), 1e-6F, 1.5e-6F};
    const auto rough = detail::gaussian_low_pass(narrow, 6e-6F);
    for (Eigen::Index k = 0; k < map.size(); ++k) {
        if (std::isnan(map.heights.data()[k])) continue;
        REQUIRE(std::abs(low.heights.data()[k] - 1e-3 - plain.heights.data()[k]) < 1e-18);
        REQUIRE(std::abs(static_cast<double>(rough.heights.data()[k]) - plain.heights.data()[k]) < 4e-13);
    }
}

TEST_CASE("Cut-offs of a map below two steps of its coarser side or beyond its shorter one are refused") {
    const auto map = some_map(48, 27, false);  // 48 um x 40.5 um, steps of 1 um and 1.5 um
    const auto refusal = [&](double cutoff) {
        return test::refusal([&] { (void)detail::gaussian_low_pass(map, cutoff); });
    };
    CHECK(refusal(2.9e-6).find("cut-off") == 0);
    CHECK(refusal(3e-6).empty());
    CHECK(refusal(40.4e-6).empty());
    CHECK(refusal(41e-6).find("cut-off") == 0);
    CHECK(refusal(missing).find("cut-off") == 0);
    CHECK_FALSE(test::refusal([&] { (void)detail::gaussian_high_pass(map, 2.9e-6); }).empty());
}

}  // namespace gaussian_map_filter_test
