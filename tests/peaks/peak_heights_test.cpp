// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/peaks/peak_heights.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace peak_heights_test {

using namespace fstiff;

namespace {

double moment(const PeakHeights<double>& heights, int twice_n, double h) {
    const auto [value, log_scale] = twice_n == 0   ? heights.scaled_moment<0>(h)
                                    : twice_n == 1 ? heights.scaled_moment<1>(h)
                                    : twice_n == 2 ? heights.scaled_moment<2>(h)
                                                   : heights.scaled_moment<3>(h);
    return value * std::exp(log_scale);
}

}  // namespace

TEST_CASE("Heights of skewness 0 and kurtosis 3 are Gaussian ones") {
    const auto heights = PeakHeights<double>::of_moments(0, 3);
    for (const double h : {-3.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0})
        for (int n = 0; n < 4; ++n) {
            CAPTURE(h, n);
            CHECK(test::relative_error(moment(heights, n, h), detail::height_moment(n / 2.0, h)) < 3e-3);
        }
}

TEST_CASE("Heights of a skewness and a kurtosis have the means of Johnson's curve") {
    for (const auto& [skewness, kurtosis] : {std::pair{-1.0, 5.0}, std::pair{1.0, 5.0}, std::pair{0.0, 2.0},
                                             std::pair{-0.44, 4.04}, std::pair{2.0, 12.0}}) {
        const auto heights = PeakHeights<double>::of_moments(skewness, kurtosis);
        const auto curve = detail::bearing_of_moments<double>(skewness, kurtosis);
        for (const double z : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {  // of the height that is exceeded so often
            const double h = curve.height(z);
            for (int n = 0; n < 4; ++n) {
                double direct = 0;
                constexpr int parts = 200000;
                for (int i = 0; i < parts; ++i) {
                    const double x = z + (8 - z) * (i + 0.5) / parts;
                    direct += std::pow(std::max(curve.height(x) - h, 0.0), n / 2.0) * math::normal_density(x) *
                              (8 - z) / parts;
                }
                CAPTURE(skewness, kurtosis, z, n);
                CHECK(test::relative_error(moment(heights, n, h), direct) < (z > 2 && kurtosis < 3 ? 5e-3 : 2e-3));
            }
        }
    }
}

TEST_CASE("Measured heights have the means of their sum") {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> all;
    for (int i = 0; i < 2000; ++i) all.push_back(3e-6 * normal(random));
    const auto heights = PeakHeights<double>::measured(all, 3e-6);
    for (const double h : {-2.0, 0.0, 1.0, 2.0}) {
        double load = 0, stiffness = 0;
        for (const double x : all) {
            const double omega = std::max(x / 3e-6 - h, 0.0);
            load += std::pow(omega, 1.5) / 2000, stiffness += std::sqrt(omega) / 2000;
        }
        CHECK(test::relative_error(moment(heights, 3, h), load) < (h < 1.5 ? 0.02 : 0.05));
        CHECK(test::relative_error(moment(heights, 1, h), stiffness) < (h < 1.5 ? 0.02 : 0.05));
    }
}

TEST_CASE("The contact of Greenwood and Williamson takes other heights, and its K is the slope of its load") {
    const Roughness<double> face = test::sand_blasted_fine.roughness();
    const GreenwoodWilliamson<double> gaussian(face, 112.6e9);
    const GreenwoodWilliamson<double> same(face, 112.6e9, PeakHeights<double>::of_moments(0, 3));
    const GreenwoodWilliamson<double> outliers(face, 112.6e9, PeakHeights<double>::of_moments(0.5, 6));
    for (const double p : {1e5, 1e6, 1e7, 1e8})
        CHECK(test::relative_error(same.at_pressure(p).stiffness.value, gaussian.at_pressure(p).stiffness.value) <
              3e-3);
    // outliers carry light loads: fewer peaks, so that K is less
    CHECK(outliers.at_pressure(1e5).stiffness.value < 0.8 * gaussian.at_pressure(1e5).stiffness.value);
    const auto law = ContactLaw<double>::tabulate(outliers, {1e5, 1e8});
    CHECK(law.stiffness_is_slope());
    for (const double p : {2e5, 3e6, 5e7}) {
        const double d = law.separation(p), h = 1e-3 * p / law.stiffness(p);
        const double slope =
            (outliers.at_separation(d - h).pressure.value - outliers.at_separation(d + h).pressure.value) / (2 * h);
        CHECK(test::relative_error(slope, law.stiffness(p)) < 1e-5);
        CHECK(test::relative_error(law.stiffness(p), outliers.at_pressure(p).stiffness.value) < 1e-7);
    }
}

TEST_CASE("Heights of peaks that are none are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> one{1e-6}, equal{1e-6, 1e-6}, bad{1e-6, nan};
    for (const auto& heights : {one, equal, bad})
        CHECK(test::refused_for("peak_heights", [&] { (void)PeakHeights<double>::measured(heights, 1e-6); }));
    CHECK(test::refused_for("kurtosis", [] { (void)PeakHeights<double>::of_moments(0, 1e4); }));
}

}  // namespace peak_heights_test
