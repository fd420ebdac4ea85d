// SPDX-License-Identifier: BSD-3-Clause
// Truth: Gaussian heights, whose curve is a straight line; the regression written out over all heights, without a
// table.
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bearing_slope_test {

using namespace fstiff;

/// f(zeta) at the scores of \p count ranks, in an order that is not theirs.
template <class F>
std::vector<double> heights_of(const F& f, std::size_t count) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t rank = (i * 7919) % count;
        heights.push_back(f(math::normal_quantile((static_cast<double>(rank) + 0.5) / static_cast<double>(count))));
    }
    return heights;
}

/// The formula of the header over all points, found by scores and not by ranks.
double slow_slope(const std::vector<double>& heights, double center, double width) {
    std::vector<double> z(heights), score;
    std::sort(z.begin(), z.end());
    for (std::size_t i = 0; i < z.size(); ++i)
        score.push_back(math::normal_quantile((static_cast<double>(i) + 0.5) / static_cast<double>(z.size())));
    const double from = std::max(center - 3 * width, score.front()), to = std::min(center + 3 * width, score.back());
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int k = 0; k <= 60; ++k) {
        const double t = from + (to - from) * k / 60;
        const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            std::upper_bound(score.begin(), score.end(), t) - score.begin(), 1, std::ssize(score) - 1));
        const double f = z[i - 1] + (z[i] - z[i - 1]) * (t - score[i - 1]) / (score[i] - score[i - 1]);
        const double weight = std::exp(-(t - center) * (t - center) / (2 * width * width));
        w += weight, x += weight * t, y += weight * f, xx += weight * t * t, xy += weight * t * f;
    }
    return (xy - x * y / w) / (xx - x * x / w);
}

TEST_CASE("The bearing curve of Gaussian heights has their rms height as its slope everywhere") {
    const auto curve = MaterialRatioSlope<double>::of_heights(heights_of([](double z) { return 3 + 2e-6 * z; }, 10007));
    for (const double center : {-9.0, -3.0, 0.0, 0.3, 3.7, 9.0})
        for (const double width : {0.5, 1.0}) CHECK(test::relative_error(curve.slope(center, width), 2e-6) < 1e-8);
    CHECK(std::abs(curve.height(0.5) - (3 + 1e-6)) < 1e-14);
    CHECK(curve.knots().size() < 4100);
    CHECK(std::abs(curve.highest() + curve.lowest()) < 1e-11);  // 1 - p is rounded
}

TEST_CASE("The table of a bearing curve has the slope of all heights to 2e-4") {
    test::Normal normal(7);
    std::vector<double> heights;
    for (int i = 0; i < 65536; ++i) {
        const double z = normal();
        heights.push_back(std::min(z, 0.3) + 0.15 * normal() + 0.1 * std::sinh(z));
    }
    const auto curve = MaterialRatioSlope<double>::of_heights(heights);
    CHECK(curve.knots().size() < 4000);
    double worst = 0, change = 0;
    for (double center = -4; center <= 4; center += 0.37)
        for (const double width : {0.5, 0.7, 1.1}) {
            const double truth = slow_slope(heights, center, width), s = curve.slope(center, width);
            worst = std::max(worst, std::abs(s / truth - 1));
            change = std::max(change, std::abs(s / slow_slope(heights, center - 0.1, width) - 1));
        }
    CHECK(worst < 2e-4);
    CHECK(change > 0.02);
}

TEST_CASE("Equal heights of a bearing curve have their mean rank, and missing ones none") {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    const auto curve = MaterialRatioSlope<double>::of_heights(std::vector<double>{1, 5, missing, 5, 2, 5, missing, 5});
    REQUIRE(curve.knots().size() == 3);
    CHECK(curve.knots()[2].score == math::normal_quantile(4.0 / 6));  // ranks 2 to 5 of six
    CHECK(curve.knots()[1].score == math::normal_quantile(1.5 / 6));
    CHECK(curve.knots()[2].height == 5);
    for (const double center : {-5.0, 0.0, 5.0}) CHECK(curve.slope(center, 0.5) > 0);
    CHECK_THROWS_AS(MaterialRatioSlope<double>::of_heights(std::vector<double>{2, 2, missing, 2}), domain_error);
    CHECK_THROWS_AS(MaterialRatioSlope<double>::of_heights(std::vector<double>{missing}), domain_error);
    CHECK_THROWS_AS(
        MaterialRatioSlope<double>::of_heights(std::vector<double>{1, std::numeric_limits<double>::infinity()}),
        domain_error);
    CHECK_THROWS_AS(MaterialRatioSlope<double>({{0, 1}, {1, 1}}), domain_error);
    CHECK_THROWS_AS(MaterialRatioSlope<double>({{0, 1}, {0, 2}}), domain_error);
}

TEST_CASE("The slope of a bearing curve scales with the heights alone") {
    const auto f = [](double z) { return std::expm1(0.3 * z); };
    const auto one = MaterialRatioSlope<double>::of_heights(heights_of(f, 4099));
    const auto tiny = MaterialRatioSlope<double>::of_heights(heights_of([&](double z) { return 1e-9 * f(z); }, 4099));
    for (const double center : {-3.0, 0.1, 3.0})
        CHECK(test::relative_error(tiny.slope(center, 0.6), 1e-9 * one.slope(center, 0.6)) < 1e-12);
    // of exp(0.3 zeta), whose slope at c is 0.3 exp(0.3 c): weighted evenly about c within the points
    CHECK(test::relative_error(one.slope(0.2, 0.1), 0.3 * std::exp(0.06)) < 1e-3);
}

TEST_CASE("A part of a bearing curve, and a taller one") {
    const MaterialRatioSlope<double> curve({{-3, -9}, {-1, -1}, {0, 0}, {2, 8}, {3, 27}});
    const auto part = curve.between(-2, 2.5), taller = curve.scaled(1e-6);
    CHECK(part.lowest() == -2);
    CHECK(part.highest() == 2.5);
    for (const double zeta : {-2.0, -1.5, -0.3, 1.0, 2.2, 2.5}) {
        CHECK(std::abs(part.height(zeta) - curve.height(zeta)) < 1e-12);
        CHECK(std::abs(taller.height(zeta) - 1e-6 * curve.height(zeta)) < 1e-18);
    }
    CHECK(part.slope(9, 0.5) == part.slope(2.5, 0.5));
    CHECK(curve.between(-9, 9).knots().size() == 5);
    CHECK_THROWS_AS(curve.between(1, 1), domain_error);
    CHECK_THROWS_AS(curve.between(4, 5), domain_error);
}

}  // namespace bearing_slope_test
