// SPDX-License-Identifier: BSD-3-Clause
// Truth: curves of straight lines, whose core and triangles are found with a pencil; Gaussian heights in closed form;
// numpy's quadrature of the same definition on maps with and without missing points.
#include <fstiff/surface/material_ratio.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/roughness_reference.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <numbers>

namespace material_ratio_test {

using namespace fstiff;

namespace {

detail::MaterialRatio<double> of(const std::vector<double>& z) { return detail::material_ratio<double>(z); }

/// \p z at equal steps of t from 0 to 1.
template <class Curve>
std::vector<double> sampled(const Curve& z, int points) {
    std::vector<double> heights;
    for (int i = 0; i < points; ++i) heights.push_back(z(static_cast<double>(i) / (points - 1)));
    return heights;
}

double bent(double t) { return t < 0.1 ? 1 - 10 * t : t < 0.8 ? 0.1 - t : -0.7 - 20 * (t - 0.8); }

}  // namespace

TEST_CASE("The heights of a ramp are all core, in any order and at any offset") {
    for (const double offset : {0.0, 1e3}) {
        const auto found = of(sampled([&](double t) { return offset + 3 * t; }, 1001));
        CHECK(std::abs(found.core_height - 3) < 1e-12 + 1e-14 * offset);
        CHECK(found.reduced_peak_height < 1e-12);
        CHECK(found.reduced_valley_depth < 1e-12);
        CHECK(found.peak_share < 1e-12);
        CHECK(found.core_and_peak_share > 1 - 1e-12);
    }
}

TEST_CASE("A curve of three straight parts has triangles of its own heights") {
    // the flattest part, drawn on to both ends, goes from 0.1 to -0.9; the curve is at 0.1 at t = 0.09, 0.9 below its
    // top, and at -0.9 at t = 0.81, 3.8 above its bottom
    const auto found = of(sampled(bent, 1001));
    CHECK(test::relative_error(found.core_height, 1.0) < 1e-12);
    CHECK(test::relative_error(found.peak_share, 0.09) < 1e-12);
    CHECK(test::relative_error(found.core_and_peak_share, 0.81) < 1e-12);
    CHECK(test::relative_error(found.reduced_peak_height, 0.9) < 1e-12);
    CHECK(test::relative_error(found.reduced_valley_depth, 3.8) < 1e-12);
}

TEST_CASE("Gaussian heights have the core of the closed form") {
    // the flattest 40 % are in the middle, from t = 0.3 to 0.7; with c = 0.5244 there,
    // int (t - 1/2) z dt = 0.4 pdf(c) - int_-c^c pdf^2 dx, and int pdf^2 = erf(c)/(2 sqrt(pi))
    const double c = gsl_cdf_ugaussian_Pinv(0.7);
    const double core = 12 / 0.064 * (std::erf(c) / (2 * std::sqrt(std::numbers::pi)) - 0.4 * gsl_ran_ugaussian_pdf(c));
    const double share = gsl_cdf_ugaussian_Q(core / 2);
    const double triangle = 2 * (gsl_ran_ugaussian_pdf(core / 2) - core / 2 * share) / share;
    const int points = 200001;  // 0.3 and 0.7 are places of heights
    std::vector<double> z;
    for (int i = 0; i < points; ++i) z.push_back(gsl_cdf_ugaussian_Qinv((i + 0.5) / points));
    const auto found = of(z);
    // N heights at (i + 1/2)/N are at i/(N-1): shares are off by 1/(2 N), and the triangles by the ends of the curve,
    // where the sum over half a step of a tail is off by a few steps
    CHECK(test::relative_error(found.core_height, core) < 2 / static_cast<double>(points));
    CHECK(std::abs(found.peak_share - share) < 1 / static_cast<double>(points));
    CHECK(std::abs(found.core_and_peak_share - (1 - share)) < 1 / static_cast<double>(points));
    CHECK(test::relative_error(found.reduced_peak_height, triangle) < 2e-4);
    CHECK(test::relative_error(found.reduced_valley_depth, found.reduced_peak_height) < 1e-8);
}

TEST_CASE("Core, peaks and valleys are those that numpy finds") {
    for (const std::string source :
         {"map_gaussian", "map_skewed", "map_oblong", "map_holes", "profile_row", "profile_holes"}) {
        CAPTURE(source);
        auto expected = test::roughness_reference(source);
        const bool profile = source[0] == 'p';
        detail::MaterialRatio<double> found;
        if (profile) {
            found = of(test::reference_profile(source).heights);
        } else {
            const auto map = test::reference_map(source);
            found = detail::material_ratio<double>({map.heights.data(), static_cast<std::size_t>(map.size())});
        }
        const std::string letter = profile ? "R" : "S";
        CHECK(test::relative_error(found.core_height, expected.at(letter + "k_m")) < 1e-9);
        CHECK(test::relative_error(found.reduced_peak_height, expected.at(letter + "pk_m")) < 1e-9);
        CHECK(test::relative_error(found.reduced_valley_depth, expected.at(letter + "vk_m")) < 1e-9);
        CHECK(test::relative_error(found.peak_share, expected.at(letter + "mr1")) < 1e-9);
        CHECK(test::relative_error(found.core_and_peak_share, expected.at(letter + "mr2")) < 1e-9);
    }
}

TEST_CASE("The unit of the heights scales the core, and a mirrored surface swaps peaks and valleys") {
    const auto plain = of(sampled(bent, 777));
    const auto scaled = of(sampled([](double t) { return 1e-9 * bent(t); }, 777));
    CHECK(test::relative_error(scaled.core_height, 1e-9 * plain.core_height) < 1e-12);
    CHECK(test::relative_error(scaled.reduced_peak_height, 1e-9 * plain.reduced_peak_height) < 1e-12);
    CHECK(test::relative_error(scaled.peak_share, plain.peak_share) < 1e-12);
    const auto mirrored = of(sampled([](double t) { return -bent(t); }, 777));
    CHECK(test::relative_error(mirrored.reduced_peak_height, plain.reduced_valley_depth) < 1e-11);
    CHECK(test::relative_error(1 - mirrored.peak_share, plain.core_and_peak_share) < 1e-12);
}

TEST_CASE("The first of several places that are equally flat counts") {
    // two flat parts of 40 %, at 1 and at 0, with a step between them
    const auto found = of(sampled([](double t) { return t < 0.45 ? 1 : t < 0.55 ? 1 - (t - 0.45) / 0.1 : 0; }, 1001));
    CHECK(std::abs(found.core_height) < 1e-12);
    CHECK(std::abs(found.peak_share) < 1e-9);
    CHECK(found.reduced_valley_depth > 1);
}

TEST_CASE("Too few heights, and heights that do not vary, are refused") {
    CHECK(test::refusal([] { (void)of(std::vector<double>(15, 1.0)); }).find("at least 16") != std::string::npos);
    CHECK(test::refusal([] { (void)of(std::vector<double>(20, 1.0)); }).find("varying height") != std::string::npos);
}

}  // namespace material_ratio_test
