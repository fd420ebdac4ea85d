// SPDX-License-Identifier: BSD-3-Clause
// The loss against the covariance of all points of a profile whose form is removed, without interpolation.
#include <fstiff/profile/form_loss.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <Eigen/QR>

using namespace fstiff;

namespace {

/// S after the removal over S before, from the covariance of every point.
std::vector<double> slow(const std::vector<std::size_t>& lags, Eigen::Index points, double power, Eigen::Index terms) {
    Eigen::MatrixXd covariance(points, points), form(points, terms);
    for (Eigen::Index i = 0; i < points; ++i) {
        for (Eigen::Index j = 0; j < points; ++j)
            covariance(i, j) = -std::pow(std::abs(static_cast<double>(i - j)), power) / 2;
        for (Eigen::Index k = 0; k < terms; ++k)
            form(i, k) = std::pow(static_cast<double>(i) / static_cast<double>(points), static_cast<double>(k));
    }
    const Eigen::MatrixXd q = form.householderQr().householderQ() * Eigen::MatrixXd::Identity(points, terms);
    const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(points, points) - q * q.transpose();
    const Eigen::MatrixXd left = rest * covariance * rest;
    std::vector<double> share;
    for (const std::size_t lag : lags) {
        const auto n = static_cast<Eigen::Index>(lag);
        double sum = 0;
        for (Eigen::Index i = 0; i + n < points; ++i) sum += left(i, i) + left(i + n, i + n) - 2 * left(i, i + n);
        share.push_back(sum / static_cast<double>(points - n) / std::pow(static_cast<double>(lag), power));
    }
    return share;
}

}  // namespace

TEST_CASE("What the removal of a form leaves of S is what the covariance of all points says") {
    const double power = GENERATE(0.4, 1.0, 1.6);
    const Form form = GENERATE(Form::line, Form::parabola);
    const std::vector<std::size_t> lags{1, 4, 10, 30, 60, 100};
    const auto truth = slow(lags, 400, power, form == Form::line ? 2 : 3);
    const auto found = detail::log_retained<double>(lags, 400, power, form);
    for (std::size_t k = 0; k < lags.size(); ++k) {
        CAPTURE(power, static_cast<int>(form), lags[k], truth[k], std::exp(found[static_cast<Eigen::Index>(k)]));
        // of the loss itself, 3 %: the coarse profile has 96 points
        CHECK(std::abs(std::exp(found[static_cast<Eigen::Index>(k)]) - truth[k]) <= 0.03 * (1 - truth[k]) + 1e-4);
        CHECK(truth[k] < 1);
    }
}

TEST_CASE("No form and the mean take nothing of S") {
    const std::vector<std::size_t> lags{1, 10, 100};
    for (const Form form : {Form::none, Form::mean})
        CHECK(detail::log_retained<double>(lags, 400, 1.2, form).isZero(0));
}
