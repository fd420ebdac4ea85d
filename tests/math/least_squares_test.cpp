// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/least_squares.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace least_squares_test {

using namespace fstiff;

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

}  // namespace

TEST_CASE("a line through points is that of the closed form, with its covariance") {
    const Vector x = Vector::LinSpaced(7, -1, 2), y = (Vector(7) << 1, 2.5, 2, 4, 5.5, 5, 7).finished();
    const auto fit = math::least_squares<double>(Vector::Zero(2), 7, [&](const Vector& p, Vector& f, Matrix& j) {
        f = p(0) + p(1) * x.array() - y.array();
        j.col(0).setOnes();
        j.col(1) = x;
        return true;
    });
    const double mean = x.mean(), sxx = (x.array() - mean).square().sum();
    const double slope = ((x.array() - mean) * y.array()).sum() / sxx;
    CHECK(fit.status == math::FitStatus::converged);
    // the search ends at 1e-7 of a standard error, which is a tenth of the values here
    CHECK(test::relative_error(fit.parameters(1), slope) < 1e-8);
    CHECK(test::relative_error(fit.parameters(0), y.mean() - slope * mean) < 1e-8);
    CHECK(test::relative_error(fit.covariance(1, 1), 1 / sxx) < 1e-13);
    CHECK(test::relative_error(fit.covariance(0, 1), -mean / sxx) < 1e-13);
}

TEST_CASE("NIST's Misra1a from its far start has the certified parameters and errors") {
    // NIST Statistical Reference Datasets, nonlinear regression: y = b1 (1 - exp(-b2 x)), 11 certified digits
    const Vector y =
        (Vector(14) << 10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78)
            .finished();
    const Vector x =
        (Vector(14) << 77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0)
            .finished();
    const auto fit = math::least_squares<double>((Vector(2) << 500, 0.0001).finished(), 14,
                                                 [&](const Vector& b, Vector& f, Matrix& j) {
                                                     const Eigen::ArrayXd fall = (-b(1) * x.array()).exp();
                                                     f = b(0) * (1 - fall) - y.array();
                                                     j.col(0) = 1 - fall;
                                                     j.col(1) = b(0) * x.array() * fall;
                                                     return true;
                                                 });
    REQUIRE(fit.status == math::FitStatus::converged);
    const double deviation = std::sqrt(fit.sum_of_squares / 12);
    CHECK(test::relative_error(fit.sum_of_squares, 1.2455138894e-01) < 1e-10);
    CHECK(test::relative_error(fit.parameters(0), 2.3894212918e+02) < 1e-8);
    CHECK(test::relative_error(fit.parameters(1), 5.5015643181e-04) < 1e-8);
    CHECK(test::relative_error(deviation * std::sqrt(fit.covariance(0, 0)), 2.7070075241e+00) < 1e-7);
    CHECK(test::relative_error(deviation * std::sqrt(fit.covariance(1, 1)), 7.2668688436e-06) < 1e-7);
}

TEST_CASE("the valley of Rosenbrock leads to its end, around what is outside") {
    const auto fit =
        math::least_squares<double>((Vector(2) << -1.2, 1).finished(), 2, [](const Vector& x, Vector& f, Matrix& j) {
            f << 10 * (x(1) - x(0) * x(0)), 1 - x(0);
            j << -20 * x(0), 10, -1, 0;
            return x(0) < 1.5 && x(1) > -2;
        });
    CHECK(fit.status == math::FitStatus::converged);
    CHECK(std::abs(fit.parameters(0) - 1) < 1e-10);
    CHECK(std::abs(fit.parameters(1) - 1) < 1e-10);
}

TEST_CASE("parameters without effect on the residuals are singular and have the direction") {
    const Vector x = Vector::LinSpaced(5, 1, 2);
    const auto fit = math::least_squares<double>(Vector::Ones(3), 5, [&](const Vector& p, Vector& f, Matrix& j) {
        const Eigen::ArrayXd value = p(0) + p(1) * p(2) * x.array();
        f = value - (3 + 2 * x.array());
        j.col(0).setOnes();
        j.col(1) = p(2) * x;
        j.col(2) = p(1) * x;
        return true;
    });
    CHECK(fit.status == math::FitStatus::singular);
    CHECK(fit.covariance.size() == 0);
    CHECK(fit.sum_of_squares < 1e-12);
    CHECK(std::abs(fit.parameters(1) * fit.parameters(2) - 2) < 1e-6);
    CHECK(std::abs(fit.null_direction(0)) < 1e-7);
    CHECK(std::abs(std::abs(fit.null_direction(1)) - std::sqrt(0.5)) < 1e-7);
}

TEST_CASE("least squares refuses too few points and a start outside") {
    const auto nothing = [](const Vector&, Vector&, Matrix&) { return false; };
    CHECK(test::refusal([&] {
              static_cast<void>(math::least_squares<double>(Vector::Ones(3), 2, nothing));
          }).find("at least as many as the 3 parameters") != std::string::npos);
    CHECK(test::refusal([&] {
              static_cast<void>(math::least_squares<double>(Vector::Ones(1), 2, nothing));
          }).find("starting values") != std::string::npos);
}

}  // namespace least_squares_test
