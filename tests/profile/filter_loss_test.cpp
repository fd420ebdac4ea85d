// SPDX-License-Identifier: BSD-3-Clause
// The share that is left against the integral over the spectrum, which is damped as ISO 16610-21 says.
#include <fstiff/profile/filter_loss.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

using namespace fstiff;

namespace {

/// Integral of (1 - cos q lag)^2 q^-(1+power), damped by the square of 2^-(lambda_s q/(2 pi))^2, by brute force.
double by_spectrum(double lag, double lambda_s, double power) {
    double sum = 0;
    const double step = 1e-4;  // of ln q lag; beyond q lag = 5e3 the mean of the square, 3/2, without a filter
    for (double u = std::log(1e-4); u < std::log(5e3); u += step) {
        const double x = std::exp(u), waves = lambda_s * x / lag / (2 * 3.14159265358979);
        sum += std::pow(1 - std::cos(x), 2) * std::pow(x, -power) * std::pow(4.0, -waves * waves) * step;
    }
    return sum + (lambda_s > 0 ? 0 : 1.5 * std::pow(5e3, -power) / power);
}

}  // namespace

TEST_CASE("What the filter leaves of second differences is what the damped spectrum has") {
    for (const double power : {0.4, 1.0, 1.6})
        for (const double lag : {0.5, 1.0, 4.0}) {
            CAPTURE(power, lag);
            const double truth = by_spectrum(lag, 1, power) / by_spectrum(lag, 0, power);
            CHECK(test::relative_error(detail::share_left(lag, 1.0, power), truth) < 1e-4);
        }
    CHECK(detail::share_left(3.0, 0.0, 1.0) == 1);
    CHECK(test::relative_error(detail::share_left(3e-6, 2e-6, 1.0), detail::share_left(3.0, 2.0, 1.0)) < 1e-12);
}
