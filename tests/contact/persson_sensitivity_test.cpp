// SPDX-License-Identifier: BSD-3-Clause
// Truth: differences in long double with another step; the scaling of lengths and of E.
#include <fstiff/contact/sensitivity.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/scalars.hpp"

namespace persson_sensitivity_test {

using namespace fstiff;

TEST_CASE("derivatives of Persson's K are differences of it") {
    for (const double p : {1e4, 1e7, 1e9}) {
        const parts::PerssonParameters<double> at{1.1e-6, 0.1, 8.24, 0.7, 1.1e11, 0.45};
        const auto found = sensitivity(at, p);
        using L = parts::PerssonParameters<long double>;
        const L exact{1.1e-6, 0.1, 8.24, 0.7, 1.1e11, 0.45};
        const auto by = [&](long double L::*parameter) {
            const long double h = exact.*parameter * 1e-5L;
            L low = exact, high = exact;
            low.*parameter -= h, high.*parameter += h;
            const auto pressure = static_cast<long double>(p);
            return static_cast<double>((high.contact().stiffness(pressure) - low.contact().stiffness(pressure)) /
                                       (2 * h));
        };
        const auto near = [&](double value, double truth, double parameter) {
            // 1e-10 of the differences of the test, 1e-8 of those stated
            return std::abs(value - truth) * parameter < 1e-8 * found.stiffness;
        };
        CAPTURE(p);
        CHECK(near(found.rms_height, by(&L::rms_height), 1.1e-6));
        CHECK(near(found.rms_gradient, by(&L::rms_gradient), 0.1));
        CHECK(near(found.alpha, by(&L::alpha), 8.24));
        CHECK(near(found.hurst, by(&L::hurst), 0.7));
        CHECK(near(found.effective_modulus, by(&L::effective_modulus), 1.1e11));
        CHECK(near(found.gamma, by(&L::gamma), 0.45));
        // lengths twice as large and E, p twice as large: K = E/length f(p/E)
        CHECK(test::relative_error(found.pressure * p + found.effective_modulus * 1.1e11, found.stiffness) < 1e-11);
    }
}

TEST_CASE("derivatives at the ends of the ranges are refused") {
    CHECK(test::refusal([] {
              (void)sensitivity(parts::PerssonParameters<double>{1e-6, 0.1, 8, 0.99, 1e11}, 1e6);
          }).find("hurst") == 0);
    CHECK(test::refusal([] {
              (void)sensitivity(parts::PerssonParameters<double>{1e-6, 0.1, 1.51, 0.8, 1e11}, 1e6);
          }).find("alpha") == 0);
}

}  // namespace persson_sensitivity_test
