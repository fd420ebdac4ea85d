// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/gaussian_moment.hpp>
#include <fstiff/math/normal_distribution.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <gsl/gsl_sf_hyperg.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gaussian_moment_test {

using fstiff::math::gaussian_moment;

namespace {

/// F_a(x), for x > 0 times exp(x^2/2), by its definition: v = exp(u - exp(-u)) and the trapezoidal rule; in v itself
/// where the whole Gaussian counts.
long double scaled_by_quadrature(long double a, long double x) {
    const long double step = 1 / 128.0L;
    if (x < -12) {
        long double whole = 0;
        for (long double w = -11; w < 11; w += 8 * step) whole += std::pow(w - x, a) * std::exp(-w * w / 2) * 8 * step;
        return whole;
    }
    const long double scale = x > 1 ? 1 / x : 1;  // for large x it falls as exp(-x v)
    long double sum = 0;
    for (long double u = -5; u < 6; u += step) {
        const long double fall = std::exp(-u);
        const long double v = scale * std::exp(u - fall);
        const long double exponent = x > 0 ? v * (v / 2 + x) : (v + x) * (v + x) / 2;
        sum += std::pow(v, a) * std::exp(-exponent) * v * (1 + fall) * step;
    }
    return sum;
}
long double by_quadrature(long double a, long double x) {
    return scaled_by_quadrature(a, x) * (x > 0 ? std::exp(-x * x / 2) : 1.0L);
}

/// The accuracy that the header states, in epsilon.
constexpr double stated = 6;

}  // namespace

TEMPLATE_TEST_CASE("F_a agrees with its definition", "", float, double) {
    using T = TestType;
    for (const double a : {-0.5, 0.0, 0.5, 1.0, 1.5, 2.5})
        for (const double x : {-40.0, -9.5, -5.01, -4.99, -2.0, -0.3, -0.01, 0.0, 0.01, 0.5, 1.5, 4.0, 8.0, 11.0}) {
            const T at = static_cast<T>(x);
            const long double truth = by_quadrature(a, at);
            INFO("a " << a << " x " << x);
            CHECK(test::ulps(gaussian_moment(T(a), at), static_cast<T>(truth)) <= T(stated));
        }
}

TEST_CASE("F_0 and F_1 agree with erfc") {
    for (const double x : {-6.0, -3.0, 0.0, 0.7, 3.0, 10.0, 30.0}) {
        const long double closed = std::sqrt(std::acos(-1.0L) / 2) * std::erfc(x / std::sqrt(2.0L));
        INFO("x " << x);
        CHECK(test::ulps<double>(gaussian_moment(0.0, x), static_cast<double>(closed)) <= stated);
    }
    for (const double x : {-6.0, -3.0, 0.0, 0.7}) {
        const long double g = std::exp(-0.5L * x * x);
        const long double closed = g - x * std::sqrt(std::acos(-1.0L) / 2) * std::erfc(x / std::sqrt(2.0L));
        CHECK(test::ulps<double>(gaussian_moment(1.0, x), static_cast<double>(closed)) <= stated);
    }
}

TEST_CASE("F_a agrees with Tricomi's function of GSL") {
    // F_a(x) = Gamma(a+1) 2^(-(a+1)/2) exp(-x^2/2) U((a+1)/2, 1/2, x^2/2) for x > 0
    for (const double a : {-0.5, 0.0, 0.5, 1.0, 1.5, 2.5})
        for (const double x : {0.2, 1.0, 3.0, 7.0}) {
            const double tricomi = gsl_sf_hyperg_U((a + 1) / 2, 0.5, x * x / 2);
            const double other = std::tgamma(a + 1) * std::pow(2.0, -(a + 1) / 2) * std::exp(-x * x / 2) * tricomi;
            INFO("a " << a << " x " << x);
            CHECK(test::relative_error(gaussian_moment(a, x), other) < 1e-11);  // GSL's own error
        }
}

TEST_CASE("the recurrence F_{a+1} = a F_{a-1} - x F_a holds where it does not cancel") {
    for (const double x : {-100.0, -20.0, -5.0, -1.0, -0.1}) {
        INFO("x " << x);
        // every term is positive for x < 0: the sum is as good as its terms, and two roundings
        CHECK(test::ulps(1.5 * gaussian_moment(0.5, x) - x * gaussian_moment(1.5, x), gaussian_moment(2.5, x)) <=
              2 * stated + 2);
        CHECK(test::ulps(0.5 * gaussian_moment(-0.5, x) - x * gaussian_moment(0.5, x), gaussian_moment(1.5, x)) <=
              2 * stated + 2);
    }
}

TEST_CASE("F_a agrees with its definition at random points and at the seams", "[more]") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto check = [](double x) {
        INFO("x " << x);
        const auto error = [x]<int TwiceA>() {
            const long double truth = scaled_by_quadrature(TwiceA / 2.0L, x);
            return test::ulps(fstiff::math::scaled_moment<TwiceA>(x), static_cast<double>(truth));
        };
        CHECK(error.operator()<-1>() <= stated);
        CHECK(error.operator()<0>() <= stated);
        CHECK(error.operator()<1>() <= stated);
        CHECK(error.operator()<2>() <= stated);
        CHECK(error.operator()<3>() <= stated);
        CHECK(error.operator()<5>() <= stated);
    };
    for (const double seam : {0.0, -5.0, 30.0, -30.0, 2.0, -2.0, 6.0, 14.0})
        for (const double step : {0.0, 1e-15, -1e-15, 1e-9, -1e-9}) check(seam + step);
    for (int i = 0; i < 300; ++i) {
        check(40 * uniform(random));
        check(-6 * uniform(random));
        check(-5 / (uniform(random) + 1e-6));
    }
}

TEST_CASE("erf on lanes agrees with std::erf") {
    using T = double;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> start(0, 5), step(0, 1);
    std::array<T, 8> y, out;
    for (int i = 0; i < 5000; ++i) {
        const T first = T(start(random)), increment = T(step(random));
        for (std::size_t j = 0; j < 8; ++j) y[j] = first + increment * T(j);
        const auto erf = [&](double tolerance) {
            const auto by = fstiff::math::ErfPolynomials::for_tolerance(tolerance);
            fstiff::math::erf_ascending(fstiff::math::Lanes<T, 8>::load(y.data()), y.front(), y.back(), by)
                .store(out.data());
        };
        erf(0);
        for (std::size_t j = 0; j < 8; ++j) {
            INFO("y " << y[j]);
            REQUIRE(test::ulps(out[j], T(std::erf(static_cast<long double>(y[j])))) <= 4);
        }
        erf(1e-3);
        for (std::size_t j = 0; j < 8; ++j) {
            INFO("y " << y[j] << ", rough");
            REQUIRE(test::relative_error(out[j], std::erf(y[j])) <= T(fstiff::math::ErfTable::rough_error));
        }
    }
}

TEST_CASE("F_a is finite at the ends and refuses NaN") {
    CHECK(gaussian_moment(0.5, 1e300) == 0);
    CHECK(test::ulps(gaussian_moment(0.0, -1e300), std::sqrt(2 * std::numbers::pi)) <= 2);
    CHECK(std::isfinite(gaussian_moment(0.5, -1e300)));
    CHECK(test::refusal([] { static_cast<void>(gaussian_moment(0.75, 1.0)); }) ==
          "a = 0.75: must be -1/2, 0, 1/2, 1, 3/2 or 5/2");
    CHECK(test::refusal([] { static_cast<void>(gaussian_moment(0.5, std::nan(""))); }).starts_with("x = nan"));
}

}  // namespace gaussian_moment_test
