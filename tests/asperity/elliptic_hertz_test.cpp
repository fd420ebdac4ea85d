// SPDX-License-Identifier: BSD-3-Clause
// Truth: Johnson (4.25)-(4.26) by mpmath; GSL's elliptic integrals; the sphere; the limit of a long ellipse.
#include <fstiff/asperity/elliptic_hertz.hpp>
#include <fstiff/asperity/laws.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <numbers>

namespace elliptic_hertz_test {

using namespace fstiff;

// mpmath 1.3, 50 digits: s of ((K-E)/(E/s^2-K)) = k2/k1 by findroot, K and E of m = 1 - s^2 by ellipk and ellipe;
// F1^3 = 4/(pi m) s^(3/2) sqrt((E/s^2-K)(K-E)), F2 = (2/pi) sqrt(s) K/F1
struct Row {
    double ratio, s, f1, f2;
};
constexpr Row truth[] = {
    {0.9, 0.932173115225763029680362810409, 0.999845881084397591367580787652, 0.999845857334198778513655829449},
    {0.5, 0.630595701428099704704259675194, 0.993435694373990247832106341146, 0.993392795607402955129691579257},
    {0.3, 0.450424412206233783030628675589, 0.98081122355364401817088752851, 0.980447924914883356796332922071},
    {0.1, 0.222249519246221376483465718933, 0.937098332607642117385534519453, 0.933329789205203295573962881966},
    {0.03, 0.105695734322234616940379396798, 0.875095352368251743726665297931, 0.861113290238330243407386799763},
    {0.01, 0.0549840180571187636451415785019, 0.814674220820262496798168924862, 0.785996473401258581300250073044},
    {1e-3, 0.014733513154946717921405881483, 0.692130211981631759473162886907, 0.625687023139283948399562864897},
    {1e-4, 0.00412485735838562174131852191767, 0.583080603675931141720140376042, 0.48223391222699400973551261312}};

TEST_CASE("the ellipse of contact against Johnson's formulae") {
    for (const Row& row : truth) {
        const auto found = detail::hertz_ellipse(row.ratio);
        CAPTURE(row.ratio);
        CHECK(test::ulps(found.axis_ratio, row.s) < 16);
        CHECK(test::ulps(found.size_factor, row.f1) < 16);
        CHECK(test::ulps(found.approach_factor, row.f2) < 16);
    }
}

TEST_CASE("the ellipse of contact by another library's elliptic integrals, and smooth through the circle") {
    double last = 0;
    for (double ratio = 1e-6; ratio <= 1; ratio *= 1.003) {
        const auto [s, f1, f2] = detail::hertz_ellipse(ratio);
        const double m = 1 - s * s, k = std::sqrt(m);
        CAPTURE(ratio);
        if (m > 1e-3) {  // K - E of the library loses digits to m near the circle, to 1 - k^2 for long ellipses
            const double tolerance = 2e-14 + 2e-15 / m + 1e-15 / (s * s);
            const double K = gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE), E = gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE);
            CHECK(test::relative_error((K - E) / (E / (s * s) - K), ratio) < tolerance);
            CHECK(test::relative_error(2 / std::numbers::pi * std::sqrt(s) * K / f1, f2) < tolerance);
        }
        CHECK(f2 > last);  // rises to 1
        last = f2;
    }
    const auto circle = detail::hertz_ellipse(1.0);
    CHECK(circle.axis_ratio == 1.0);
    CHECK(test::ulps(circle.approach_factor, 1.0) < 4);
    // 1 - F2 goes like the square of the logarithm of the ratio: F2 = 1 - ln^2/72 to fourth order
    for (const double ratio : {0.999, 0.99, 0.97}) {
        const double square = std::pow(std::log(ratio), 2);
        CHECK(std::abs(1 - detail::hertz_ellipse(ratio).approach_factor - square / 72) < square * square);
    }
}

TEST_CASE("load, stiffness and area of an ellipse") {
    const HertzLaw<double> sphere;
    const double R = 3e-5, omega = 2e-8;
    const auto round = detail::elliptic_hertz(1 / R, 1 / R);
    CHECK(test::ulps(round.load(omega), sphere.load(omega, R)) < 8);
    CHECK(test::ulps(round.stiffness(omega), sphere.stiffness(omega, R)) < 8);
    CHECK(test::ulps(round.area(omega), sphere.area(omega, R)) < 8);
    const auto one = detail::elliptic_hertz(2e4, 5e3), turned = detail::elliptic_hertz(5e3, 2e4);
    CHECK(one.load_factor == turned.load_factor);
    // stiffness is the slope of the load, and pressure 3F/(2A) falls off as Hertz's from F = (2/3) p0 A
    const double h = 1e-4 * omega;
    CHECK(test::relative_error((one.load(omega + h) - one.load(omega - h)) / (2 * h), one.stiffness(omega)) < 1e-8);
    // Johnson (4.24): omega = (3 F/(2 pi a E)) K, with a = sqrt(A/(pi s))
    const double s = one.axis_ratio, a = std::sqrt(one.area(omega) / (std::numbers::pi * s));
    const double K = gsl_sf_ellint_Kcomp(std::sqrt(1 - s * s), GSL_PREC_DOUBLE);
    CHECK(test::relative_error(1.5 * one.load(omega) / (std::numbers::pi * a) * K, omega) < 1e-13);
    // a long one, of which B -> 1 and D -> ln(4/s) - 1
    const auto thin = detail::hertz_ellipse(1e-12);
    const double log = std::log(4 / thin.axis_ratio) - 1;
    CHECK(test::relative_error(thin.axis_ratio * thin.axis_ratio * log, 1e-12) < 1e-10);
}

TEST_CASE("curvatures that are none are refused") {
    CHECK(test::refusal([] { (void)detail::hertz_ellipse(0.0); }).find("curvature_ratio") == 0);
    CHECK(test::refusal([] { (void)detail::hertz_ellipse(1.1); }).find("curvature_ratio") == 0);
    CHECK(test::refusal([] { (void)detail::elliptic_hertz(1.0, -1.0); }).find("curvature") == 0);
    CHECK(test::refusal([] { (void)detail::elliptic_hertz(std::nan(""), 1.0); }).find("curvature") == 0);
}

}  // namespace elliptic_hertz_test
