// SPDX-License-Identifier: BSD-3-Clause
// K_n0 and V_m of points of the hyperbola itself, of two points in closed form, and of a measured fracture.
#include <fstiff/identify/barton_bandis.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace barton_bandis_test {

using namespace fstiff;
using test::relative_error;

namespace {

/// The usual form, with the closure left as it is written.
double usual(double K0, double Vm, double p) { return K0 / std::pow(1 - p / (Vm * K0 + p), 2); }

}  // namespace

TEST_CASE("Points of the hyperbola have its parameters, in any unit", "[barton_bandis]") {
    for (const auto& [K0, Vm] : {std::pair{35e9, 130e-6}, {2e12, 1e-6}, {1e6, 1e-2}}) {
        std::vector<Observation<double>> data;
        for (double p = 0.02; p < 40; p *= 2) data.push_back({p * K0 * Vm, usual(K0, Vm, p * K0 * Vm), 0});
        const auto fit = detail::fit_barton_bandis(data);
        CHECK(fit.status == math::FitStatus::converged);
        CHECK(relative_error(fit.initial_stiffness.value, K0) < 1e-9);
        CHECK(relative_error(fit.closure.value, Vm) < 1e-9);
        for (std::size_t i = 0; i < data.size(); ++i) CHECK(relative_error(fit.model[i], data[i].value) < 1e-9);
        // K is dp/dV of the closure V = p/(K0 + p/Vm), by differences
        const double p = K0 * Vm, h = 1e-4 * p;
        const auto closure = [&, K0 = K0, Vm = Vm](double at) { return at / (K0 + at / Vm); };
        CHECK(relative_error(2 * h / (closure(p + h) - closure(p - h)), fit.stiffness(p)) < 1e-7);
    }
}

TEST_CASE("Two points with errors have the parameters and errors of the line through sqrt(K)", "[barton_bandis]") {
    const double p1 = 2e6, p2 = 8e6, y1 = 57e9, y2 = 138e9, e1 = 2e9, e2 = 6e9;
    const auto fit = detail::fit_barton_bandis<double>({{p1, y1, e1}, {p2, y2, e2}});
    const double s1 = std::sqrt(y1), s2 = std::sqrt(y2), d1 = e1 / (2 * s1), d2 = e2 / (2 * s2);
    const double b = (s2 - s1) / (p2 - p1), a = s1 - b * p1;
    CHECK(relative_error(fit.initial_stiffness.value, a * a) < 1e-9);
    CHECK(relative_error(fit.closure.value, 1 / (a * b)) < 1e-9);
    // ln K0 = 2 ln a, ln Vm = -ln a - ln b, with a and b linear in s1 and s2
    const double da1 = p2 / (p2 - p1), da2 = -p1 / (p2 - p1), db1 = -1 / (p2 - p1), db2 = -db1;
    const double of_K0 = std::hypot(2 * da1 / a * d1, 2 * da2 / a * d2),
                 of_Vm = std::hypot((da1 / a + db1 / b) * d1, (da2 / a + db2 / b) * d2);
    CHECK(relative_error(fit.initial_stiffness.standard_error, a * a * of_K0) < 1e-6);
    CHECK(relative_error(fit.closure.standard_error, of_Vm / (a * b)) < 1e-6);
    CHECK(relative_error(fit.initial_stiffness.high, a * a * std::exp(1.959963984540054 * of_K0)) < 1e-6);
    const auto bare = detail::fit_barton_bandis<double>({{p1, y1, 0}, {p2, y2, 0}});
    CHECK_FALSE(bare.has_errors);
}

TEST_CASE("Points without a stiffness, or one alone, are refused", "[barton_bandis]") {
    CHECK(test::refusal([] {
              (void)detail::fit_barton_bandis<double>({{1e6, 1e9, 0}});
          }).find("two points") < std::string::npos);
    CHECK(!test::refusal([] { (void)detail::fit_barton_bandis<double>({{1e6, 1e9, 0}, {2e6, -1e9, 0}}); }).empty());
    // stiffnesses that fall with the pressure have no closure
    CHECK(detail::fit_barton_bandis<double>({{1e6, 9e9, 0}, {2e6, 5e9, 0}, {4e6, 2e9, 0}}).status !=
          math::FitStatus::converged);
}

}  // namespace barton_bandis_test
