// SPDX-License-Identifier: BSD-3-Clause
// Truth: waves, whose autocorrelation is a cosine, and ellipses of a known aspect; direct sums; numpy and scipy.
#include <fstiff/topography/areal_autocorrelation.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/height_map.hpp"
#include "support/roughness_reference.hpp"

#include <numbers>

namespace areal_autocorrelation_test {

using namespace fstiff;
using test::map_of;

namespace {

constexpr double pi = std::numbers::pi;

/// An autocorrelation that is the function \p a of the lags.
detail::ArealAutocorrelation<double> given(Eigen::Index reach, double dx, double dy, const auto& a) {
    detail::ArealAutocorrelation<double> one;
    one.reach_x = one.reach_y = reach;
    one.dx = dx;
    one.dy = dy;
    one.value.resize(reach + 1, 2 * reach + 1);
    for (Eigen::Index j = 0; j <= reach; ++j)
        for (Eigen::Index i = -reach; i <= reach; ++i)
            one.value(j, i + reach) = a(static_cast<double>(i) * dx, static_cast<double>(j) * dy);
    return one;
}

}  // namespace

TEST_CASE("The autocorrelation by transform is that of direct sums over the pairs that exist") {
    const bool holes = GENERATE(false, true);
    auto map = test::reference_map("map_skewed");
    map.heights = HeightMap<double>::Array(map.heights.topLeftCorner(21, 34));
    if (holes)
        for (Eigen::Index k = 0; k < map.size(); k += 5) map.heights.data()[k] = std::nan("");
    const auto found = detail::areal_autocorrelation(map);
    REQUIRE(found.reach_x == 17);
    REQUIRE(found.reach_y == 10);
    const double mean = detail::mean_height(map), variance = std::pow(rms_height(map), 2);
    for (Eigen::Index v = -10; v <= 10; ++v)
        for (Eigen::Index u = -17; u <= 17; ++u) {
            double sum = 0, pairs = 0;
            for (Eigen::Index j = 0; j < 21; ++j)
                for (Eigen::Index i = 0; i < 34; ++i) {
                    if (j + v < 0 || j + v >= 21 || i + u < 0 || i + u >= 34) continue;
                    const double product = (map.heights(j, i) - mean) * (map.heights(j + v, i + u) - mean);
                    if (std::isnan(product)) continue;
                    sum += product;
                    pairs += 1;
                }
            REQUIRE(std::abs(found.at(u, v) - sum / pairs / variance) < 1e-12);
        }
}

TEST_CASE("A periodic map of waves has the cosines of its spectrum") {
    const auto map = map_of(45, 64, 2e-6, 3e-6, [](double x, double y) {
        return 4 + 3 * std::cos(2 * pi * 5 * x / 128e-6) + std::cos(2 * pi * (2 * x / 128e-6 + 3 * y / 135e-6) + 1);
    });
    const auto found = detail::areal_autocorrelation(map, detail::LagPairs::periodic);
    for (Eigen::Index v = -22; v <= 22; ++v)
        for (Eigen::Index u = -32; u <= 32; ++u) {
            const double x = static_cast<double>(u) / 64, y = static_cast<double>(v) / 45;
            REQUIRE(std::abs(found.at(u, v) - 0.9 * std::cos(2 * pi * 5 * x) -
                             0.1 * std::cos(2 * pi * (2 * x + 3 * y))) < 1e-12);
        }
}

TEST_CASE("Sal and Str of cones are their radii") {
    // straight falls along x and along y are exact between the lags
    const auto round = detail::texture_parameters(
        given(50, 1e-6, 2e-6, [](double x, double y) { return 1 - std::hypot(x, y) / 30e-6; }));
    CHECK(test::relative_error(*round.shortest, 24e-6) < 3e-3);  // chords of cells of 1 x 2 below the cone
    CHECK(test::relative_error(*round.aspect_ratio, 1.0) < 3e-3);
    const auto pyramid = detail::texture_parameters(
        given(50, 1e-6, 1e-6, [](double x, double y) { return 1 - std::abs(x) / 10e-6 - std::abs(y) / 40e-6; }));
    CHECK(test::relative_error(pyramid.longest, 32e-6) < 1e-12);
    CHECK(test::relative_error(pyramid.longest_direction, pi / 2) < 1e-12);
    // the distance of the straight edge x/8 + y/32 = 1 from the centre, within the step of the directions
    CHECK(test::relative_error(*pyramid.shortest, 1e-6 / std::hypot(1.0 / 8, 1.0 / 32)) < 3e-6);
    CHECK(std::abs(pyramid.shortest_direction - std::atan(0.25)) < pi / 720);
}

TEST_CASE("Str of an inclined ellipse is its aspect within the step of the directions") {
    const double aspect = GENERATE(0.1, 0.3, 1.0), turn = 0.4123;
    const auto found = detail::texture_parameters(given(400, 1, 1, [&](double x, double y) {
        const double u = x * std::cos(turn) + y * std::sin(turn), v = y * std::cos(turn) - x * std::sin(turn);
        return std::exp(-(u * u + v * v / (aspect * aspect)) / (200.0 * 200));
    }));
    const double length = 200 * std::sqrt(std::log(5.0));
    CHECK(test::relative_error(*found.shortest, aspect * length) < 1e-3);  // of straight lines within cells
    CHECK(test::relative_error(found.longest, length) < 5e-4);
    CHECK(test::relative_error(*found.aspect_ratio, aspect) < 2e-3);
}

TEST_CASE("A texture that does not end in one direction has a Sal and no Str") {
    const auto grooves = map_of(60, 80, 1e-6, 1e-6, [](double x, double) { return std::cos(2 * pi * x / 20e-6); });
    const auto found = detail::texture_parameters(detail::areal_autocorrelation(grooves, detail::LagPairs::periodic));
    REQUIRE(found.shortest);
    CHECK(test::relative_error(*found.shortest, std::acos(0.2) / (2 * pi) * 20e-6) < 0.02);
    CHECK_FALSE(found.aspect_ratio);
    // the ray that leaves the lags at half of the 60 rows while it is just above the threshold
    CHECK(test::relative_error(found.longest, std::hypot(30e-6, *found.shortest)) < 1e-3);
    CHECK(std::abs(found.longest_direction - pi / 2) < 0.2);
    const auto flat = detail::texture_parameters(given(20, 1, 1, [](double, double) { return 0.9; }));
    CHECK_FALSE(flat.shortest);
    CHECK_FALSE(flat.aspect_ratio);
    // from lag 0 in a straight line: points above the threshold after a gap do not count
    const auto ring = detail::texture_parameters(given(40, 1, 1, [](double x, double y) {
        const double r = std::hypot(x, y);
        return r < 10 ? 1 - r / 10 : r < 15 ? 0 : 0.5;
    }));
    CHECK(test::relative_error(ring.longest, 8.0) < 0.02);
}

TEST_CASE("Sal, Str and the autocorrelation are those that scipy finds") {
    for (const std::string source : {"map_gaussian", "map_skewed", "map_oblong", "map_holes"}) {
        CAPTURE(source);
        auto expected = test::roughness_reference(source);
        const auto map = test::reference_map(source);
        const auto correlation = detail::areal_autocorrelation(map);
        CHECK(std::abs(correlation.at(1, 0) - expected.at("acf_1_0")) < 1e-12);
        CHECK(std::abs(correlation.at(0, 2) - expected.at("acf_0_2")) < 1e-12);
        CHECK(std::abs(correlation.at(5, 3) - expected.at("acf_5_3")) < 1e-12);
        CHECK(std::abs(correlation.at(-9, 4) - expected.at("acf_-9_4")) < 1e-12);
        const auto found = detail::texture_parameters(correlation);
        CHECK(test::relative_error(*found.shortest, expected.at("Sal_m")) < 1e-9);
        CHECK(test::relative_error(*found.aspect_ratio, expected.at("Str")) < 1e-9);
        if (source == "map_holes") continue;
        const auto around = detail::texture_parameters(detail::areal_autocorrelation(map, detail::LagPairs::periodic));
        CHECK(test::relative_error(*around.shortest, expected.at("Sal_periodic_m")) < 1e-9);
        CHECK(test::relative_error(*around.aspect_ratio, expected.at("Str_periodic")) < 1e-9);
    }
}

TEST_CASE("The mean over the directions of a function of the length is that function") {
    const auto found = detail::radial_autocorrelation(
        given(30, 1e-6, 1.5e-6, [](double x, double y) { return 1 - std::hypot(x, y) / 50e-6; }));
    REQUIRE(found.lag.size() == 21);  // of 1.5 um, to the shorter reach of 30 um
    CHECK(found.value[0] == 1);
    CHECK(found.lags[0] == 1);
    CHECK(found.lags[1] == 5);  // (1, 0), (2, 0), (0, 1) and (+-1, 1)
    for (std::size_t k = 0; k < found.lag.size(); ++k) {
        CHECK(std::abs(found.value[k] - (1 - found.lag[k] / 50e-6)) < 1e-14);
        CHECK(std::abs(found.lag[k] - static_cast<double>(k) * 1.5e-6) <= 0.75e-6);
    }
}

TEST_CASE("Periodic maps with missing points and thresholds beyond 1 are refused") {
    const auto map = test::reference_map("map_holes");
    CHECK(test::refusal([&] {
              (void)detail::areal_autocorrelation(map, detail::LagPairs::periodic);
          }).find("missing points") != std::string::npos);
    const auto one = given(5, 1, 1, [](double, double) { return 1.0; });
    CHECK(test::refusal([&] { (void)detail::texture_parameters(one, 1.5); }).find("between 0 and 1") !=
          std::string::npos);
}

}  // namespace areal_autocorrelation_test
