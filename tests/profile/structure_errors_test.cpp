// SPDX-License-Identifier: BSD-3-Clause
// The covariance against the sum over every pair of pairs, and against simulated walks; resamples against that sum.
#include <fstiff/profile/structure_errors.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"

using namespace fstiff;

namespace {

/// Cov(ln S_n, ln S_m) with every pair of increments, none left to a stride.
double slow_covariance(std::size_t n, std::size_t m, std::size_t points, double power) {
    const auto w = [&](double d) { return std::pow(std::abs(d), power); };
    double sum = 0;
    for (std::size_t i = 0; i < points - n; ++i)
        for (std::size_t j = 0; j < points - m; ++j) {
            const double a = static_cast<double>(i), b = static_cast<double>(j);
            const double x = static_cast<double>(n), y = static_cast<double>(m);
            const double c = (w(a + x - b) + w(a - b - y) - w(a - b) - w(a + x - b - y)) / 2;
            sum += c * c;
        }
    return 2 * sum /
           (static_cast<double>(points - n) * static_cast<double>(points - m) * w(static_cast<double>(n)) *
            w(static_cast<double>(m)));
}

Profile<double> random_walk(std::size_t points, std::uint64_t seed) {
    test::Normal normal(seed);
    Profile<double> profile{std::vector<double>(points), 1e-6};
    double height = 0;
    for (double& z : profile.heights) z = height += 1e-8 * normal();
    return profile;
}

}  // namespace

TEST_CASE("The covariance of ln S is the sum over all pairs of increments") {
    const double power = GENERATE(0.4, 1.0, 1.7);
    const std::vector<std::size_t> lags{1, 4, 7, 40};
    const std::size_t points = 300;
    std::vector<std::size_t> pairs;
    for (const auto n : lags) pairs.push_back(points - n);
    const auto formula = detail::log_covariance<double>(lags, pairs, points, power);
    for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index j = 0; j < 4; ++j) {
            CAPTURE(power, i, j);
            const double truth =
                slow_covariance(lags[static_cast<std::size_t>(i)], lags[static_cast<std::size_t>(j)], points, power);
            // where both increments are long their overlap is summed in strides, of which 5 samples miss the kink at p = 0.4
            CHECK(test::relative_error(formula(i, j), truth) < (i == 3 && j == 3 ? 0.06 : 2e-3));
        }
}

TEST_CASE("The closed-form covariance of ln S is that of simulated random walks") {
    const std::vector<std::size_t> lags{2, 8, 50};
    const std::size_t points = 400;
    std::vector<std::size_t> pairs;
    for (const auto n : lags) pairs.push_back(points - n);
    const auto formula = detail::log_covariance<double>(lags, pairs, points, 1.0);
    const int walks = 4000;
    Eigen::MatrixXd samples(3, walks);
    for (int w = 0; w < walks; ++w) {
        const auto s = structure_function(random_walk(points, static_cast<std::uint64_t>(w + 1)),
                                          std::span<const std::size_t>(lags));
        // relative deviations from the exact mean n sigma^2 of a walk: what the formula is about
        for (int k = 0; k < 3; ++k)
            samples(k, w) = s.value[static_cast<std::size_t>(k)] /
                                (1e-16 * static_cast<double>(lags[static_cast<std::size_t>(k)])) -
                            1;
    }
    const Eigen::MatrixXd measured = samples * samples.transpose() / walks;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            CAPTURE(i, j);
            // a variance over 4000 samples is known to some 3 %, more for the skewed S of the longest lag
            CHECK(std::abs(measured(i, j) - formula(i, j)) < 0.12 * std::sqrt(formula(i, i) * formula(j, j)));
        }
}

TEST_CASE("Resamples of a walk scatter as walks do, at lags of which it holds many") {
    const std::vector<std::size_t> lags{1, 2, 4};
    const std::size_t points = 20000;
    const auto resampled = detail::bootstrap_log_structure(random_walk(points, 3), lags, 2000, 1, {});
    std::vector<std::size_t> pairs;
    for (const auto n : lags) pairs.push_back(points - n);
    const auto formula = detail::log_covariance<double>(lags, pairs, points, 1.0);
    for (Eigen::Index k = 0; k < 3; ++k) {
        detail::Vector<double> row = detail::Vector<double>::Zero(3);
        row[k] = 1;
        // the variance of 256 cells is known to 9 %, its root to half of that: four times that
        CHECK(test::relative_error(detail::sample_spread(row, resampled), detail::expected_spread(row, formula)) <
              0.18);
    }
}
