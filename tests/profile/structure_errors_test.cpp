// SPDX-License-Identifier: BSD-3-Clause
// The covariance against the sum over every pair of pairs, and against simulated walks; resamples against that sum.
#include <fstiff/math/decompositions.hpp>
#include <fstiff/profile/structure_fit.hpp>
#include <fstiff/profile/structure_function.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"

namespace structure_errors_test {

using namespace fstiff;

namespace {

/// Cov(ln S2_n, ln S2_m) with every pair of second differences.
double slow_covariance(std::size_t n, std::size_t m, std::size_t points, double power) {
    const auto w = [&](double d) { return std::pow(std::abs(d), power) / 2; };
    const double x = static_cast<double>(n), y = static_cast<double>(m), weight[] = {1, -2, 1};
    double sum = 0;
    for (std::size_t i = n; i + n < points; ++i)
        for (std::size_t j = m; j + m < points; ++j) {
            double c = 0;
            for (int a = -1; a <= 1; ++a)
                for (int b = -1; b <= 1; ++b)
                    c -= weight[a + 1] * weight[b + 1] *
                         w(static_cast<double>(i) + a * x - static_cast<double>(j) - b * y);
            sum += c * c;
        }
    const double mean = 4 - std::pow(2, power);
    return 2 * sum /
           (static_cast<double>(points - 2 * n) * static_cast<double>(points - 2 * m) * mean * mean *
            std::pow(x * y, power));
}

}  // namespace

TEST_CASE("The covariance of ln S2 is the sum over all pairs of second differences") {
    const double power = GENERATE(0.4, 1.0, 1.7);
    const std::vector<std::size_t> lags{1, 4, 7, 20};
    const std::size_t points = 400;
    std::vector<std::size_t> triples;
    for (const auto n : lags) triples.push_back(points - 2 * n);
    const auto formula = detail::log_covariance<double>(lags, triples, power);
    for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index j = 0; j < 4; ++j) {
            const auto n = lags[static_cast<std::size_t>(i)], m = lags[static_cast<std::size_t>(j)];
            const double truth = slow_covariance(n, m, points, power);
            const double scale = std::sqrt(slow_covariance(n, n, points, power) * slow_covariance(m, m, points, power));
            CAPTURE(power, i, j, formula(i, j), truth);
            CHECK(std::abs(formula(i, j) - truth) < 0.05 * scale);
        }
}

TEST_CASE("The covariance has no negative eigenvalue, at any lags") {
    const std::vector<std::size_t> lags = detail::logarithmic_lags(5000);
    const auto covariance =
        detail::log_covariance<double>(lags, std::vector<std::size_t>(lags.size(), 10000), GENERATE(0.1, 1.0, 1.9));
    const auto [values, vectors] = math::symmetric_eigen<double>(covariance);
    CHECK(values.minCoeff() > -1e-12 * values.maxCoeff());
}

TEST_CASE("The closed-form covariance of ln S2 is that of simulated random walks") {
    const std::vector<std::size_t> lags{2, 8, 25};
    const std::size_t points = 400;
    std::vector<std::size_t> triples;
    for (const auto n : lags) triples.push_back(points - 2 * n);
    const auto formula = detail::log_covariance<double>(lags, triples, 1.0);
    const int walks = 4000;
    Eigen::MatrixXd samples(3, walks);
    for (int w = 0; w < walks; ++w) {
        const auto s = detail::second_differences(test::random_walk(points, static_cast<std::uint64_t>(w + 1)),
                                                  std::span<const std::size_t>(lags));
        // relative deviations from the exact mean 2 n sigma^2 of a walk: the quantity of the formula
        for (int k = 0; k < 3; ++k)
            samples(k, w) = s.value[static_cast<std::size_t>(k)] /
                                (2e-16 * static_cast<double>(lags[static_cast<std::size_t>(k)])) -
                            1;
    }
    const Eigen::MatrixXd measured = samples * samples.transpose() / walks;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            CAPTURE(i, j);
            // a variance over 4000 samples is known to some 3 %, more for the skewed S2 of the longest lag
            CHECK(std::abs(measured(i, j) - formula(i, j)) < 0.12 * std::sqrt(formula(i, i) * formula(j, j)));
        }
}

TEST_CASE("Resamples of a walk scatter as walks do, at lags of which it holds many") {
    const std::vector<std::size_t> lags{1, 2, 4};
    const std::size_t points = 20000;
    const auto resampled = detail::bootstrap_log_structure(test::random_walk(points, 3), lags, 2000, 1, {});
    std::vector<std::size_t> triples;
    for (const auto n : lags) triples.push_back(points - 2 * n);
    const auto formula = detail::log_covariance<double>(lags, triples, 1.0);
    for (Eigen::Index k = 0; k < 3; ++k) {
        detail::Vector<double> row = detail::Vector<double>::Zero(3);
        row[k] = 1;
        // the variance of 256 cells is known to 9 %, its root to half of that: four times that
        CHECK(test::relative_error(detail::sample_spread(row, resampled), detail::expected_spread(row, formula)) <
              0.18);
    }
}

}  // namespace structure_errors_test
