// SPDX-License-Identifier: BSD-3-Clause
// Truth: independent normal numbers, of which n and D^2 are known; heights whose departure is a closed form; plain
// sums.
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace height_shape_test {

using namespace fstiff;

/// \p count independent normal numbers.
std::vector<double> white(std::size_t count, std::uint64_t seed) {
    std::vector<double> z;
    for (std::uint64_t state = seed; z.size() < count;) z.push_back(math::normal_pair<double>(state).real());
    return z;
}

void add(detail::ShapeOfHeights<double>& shape, const Profile<double>& profile) {
    shape.add(profile, autocorrelation(profile));
}

double share_of(std::vector<double> heights) {
    detail::ShapeOfHeights<double> shape;
    add(shape, {std::move(heights), 1.0});
    return shape.share();
}

TEST_CASE("Independent heights are as many as there are, and those of a moving mean fewer by its width") {
    const std::vector<double> z = white(40000, 1);
    for (const std::size_t width : {1u, 4u, 16u}) {
        std::vector<double> smooth;
        for (std::size_t i = 0; i + width <= z.size(); ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < width; ++k) sum += z[i + k];
            smooth.push_back(sum);
        }
        // A is a triangle: 1 + 2 sum (1 - k/w)^2 = (2 w^2 + 1)/(3 w)
        const double w = static_cast<double>(width), lags = (2 * w * w + 1) / (3 * w);
        const Profile<double> profile{smooth, 1.0};
        const double found = detail::independent_points(autocorrelation(profile)),
                     points = static_cast<double>(smooth.size());
        // chance adds to the sum of squares: 2 sum_k Var A(k) (1 - k/N)^2 over half the length, with Var A = lags/N
        const double chance = 2 * lags * (7.0 / 24);
        CAPTURE(width, found, points / lags);
        CHECK(test::relative_error(found, points / (lags + chance)) < 0.1);
    }
}

TEST_CASE("The departure of heights from Gaussian ones is that of plain sums") {
    std::vector<double> z = white(2001, 7);
    for (double& one : z) one = std::exp(0.5 * one);
    z[5] = z[9] = std::numeric_limits<double>::quiet_NaN();
    detail::ShapeOfHeights<double> shape;
    add(shape, {z, 1.0});
    std::vector<double> present;
    for (const double one : z)
        if (!std::isnan(one)) present.push_back(one);
    double mean = 0, square = 0, away = 0;
    for (const double one : present) mean += one / 1999;
    for (const double one : present) square += (one - mean) * (one - mean) / 1999;
    for (const double one : present) {
        double below = 0;
        for (const double other : present) below += other < one;
        away += std::pow((one - mean) / std::sqrt(square) - math::normal_quantile((below + 0.5) / 1999), 2) / 1999;
    }
    CHECK(test::relative_error(shape.departure(), away) < 1e-10);
    // of many lognormal heights: 2 - 2 <f zeta> with <f zeta> = a/sqrt(e^(a^2) - 1)
    detail::ShapeOfHeights<double> many;
    std::vector<double> lognormal = white(200000, 3);
    for (double& one : lognormal) one = std::exp(0.3 * one);
    add(many, {lognormal, 1.0});
    CHECK(test::relative_error(many.departure(), 2 - 2 * 0.3 / std::sqrt(std::expm1(0.09))) < 0.03);
}

TEST_CASE("Shape counts where heights are surely not Gaussian, and not where they may be") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        std::vector<double> z = white(400, seed), skewed = z;
        for (double& one : skewed) one = std::exp(0.5 * one);
        CHECK(share_of(skewed) > 0.9);
        CHECK(share_of(z) < 0.8);
    }
    SelfAffineOptions<double> options;
    options.hurst = 0.8, options.rms = 1e-6, options.longest_wavelength = 1.0 / 8,
    options.shortest_wavelength = 1.0 / 24;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {  // 8 waves cannot know
        options.seed = seed;
        CHECK(share_of(self_affine_profile(options, 512, 1.0 / 512).heights) == 0);
    }
    // a rescaled and shifted surface has the same share
    std::vector<double> z = white(300, 5);
    for (double& one : z) one = std::exp(0.3 * one);
    const double share = share_of(z);
    for (double& one : z) one = 1e-9 * one + 3e-9;
    CHECK(test::relative_error(share_of(z), share) < 1e-9);
    CHECK(share_of(std::vector<double>{0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}) >= 0);
}

TEST_CASE("Maps and several traces are one surface") {
    SelfAffineOptions<double> options;
    options.hurst = 0.8, options.rms = 1e-6, options.longest_wavelength = 1.0 / 8,
    options.shortest_wavelength = 1.0 / 24, options.seed = 4;
    HeightMap<double> map = self_affine_map(options, 192, 192, 1.0 / 192, 1.0 / 192);
    detail::ShapeOfHeights<double> gaussian;
    gaussian.add(map);
    CHECK(gaussian.independent_points() > 100);
    CHECK(gaussian.independent_points() < 3000);
    map.heights = (0.5 * map.heights / rms_height(map)).exp();
    detail::ShapeOfHeights<double> skewed, rows;
    skewed.add(map);
    CHECK(skewed.share() > 0.9);
    double points = 0;
    for (const Eigen::Index j : {0, 48, 96, 144}) {
        const Profile<double> row{std::vector<double>(map.heights.row(j).begin(), map.heights.row(j).end()), map.dx};
        add(rows, row);
        points += detail::independent_points(autocorrelation(row));
    }
    CHECK(test::relative_error(rows.independent_points(), points) < 1e-12);
    CHECK(rows.share() < skewed.share());
}

TEST_CASE("The counted part of a shape lies between a Gaussian one and the whole") {
    const auto half = detail::counted_shape(1.0, 5.0, 0.5);
    CHECK(half.skewness == 0.5);
    CHECK(half.kurtosis == 4);
    CHECK(detail::counted_shape(1.0, 5.0, 0.0).is_gaussian());
    HeightStatistics<double> measured;
    measured.skewness = {1, 0.6}, measured.kurtosis = {5, 1.1};
    CHECK(detail::counted_shape(measured, 0.5).is_gaussian());
    measured.kurtosis.error = 0.9;
    CHECK(detail::counted_shape(measured, 0.5).skewness == 0.5);
    measured.kurtosis.error = 1.1, measured.skewness.error = 0.4;
    CHECK(detail::counted_shape(measured, 0.5).kurtosis == 4);
    CHECK(detail::counted_shape(9.0, 90.0, 1.0).skewness == 2);
    CHECK(detail::counted_shape(9.0, 90.0, 1.0).kurtosis == 10);
    CHECK(detail::counted_shape(0.0, 1.01, 1.0).kurtosis == 1.25);
    CHECK_NOTHROW(detail::bearing_of_moments(detail::counted_shape(-9.0, 1.0, 1.0).skewness,
                                             detail::counted_shape(-9.0, 1.0, 1.0).kurtosis));
    // the sum of two lognormal surfaces of like heights: skewness by sqrt(2) less, excess of kurtosis by 2
    const auto sum =
        detail::sum_of_shapes(detail::HeightShape<double>{1, 5}, 2.0, detail::HeightShape<double>{1, 5}, 2.0);
    CHECK(test::relative_error(sum.skewness, 1 / std::sqrt(2.0)) < 1e-14);
    CHECK(test::relative_error(sum.kurtosis, 4.0) < 1e-14);
}

}  // namespace height_shape_test
