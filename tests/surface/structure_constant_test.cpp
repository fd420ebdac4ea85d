// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/surface/fractal.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <limits>
#include <numbers>

namespace structure_constant_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("At D = 1.5 the constant is pi as printed and pi^2 / ln gamma as exact", "", float, double) {
    using T = TestType;
    constexpr T pi = std::numbers::pi_v<T>;
    CHECK(test::ulps(detail::structure_constant(T(1.5), StructureConvention::paper), pi) <= 20);
    CHECK(test::ulps(detail::structure_constant(T(1.5)), pi * pi / std::log(T(1.5))) <= 20);
    CHECK(test::ulps(detail::structure_constant(T(1.5), StructureConvention::majumdar_tien),
                     pi / (2 * std::log(T(1.5)))) <= 20);
}

TEST_CASE("Away from D = 1.5 the regular form equals the printed Gamma(2D-3) sin((2D-3) pi/2)") {
    // long double for the printed form, so that its own cancellation does not count
    for (const double d : {1.001, 1.05, 1.2, 1.3, 1.45, 1.58, 1.62, 1.7, 1.8, 1.95, 1.999}) {
        CAPTURE(d);
        const long double x = 2 * static_cast<long double>(d) - 3;
        const long double pi = std::acos(-1.0L);
        const long double g = std::tgamma(x) * std::sin(x * pi / 2), gamma = 1.5L;
        CHECK(test::ulps<long double>(detail::structure_constant(d, StructureConvention::paper),
                                      g / (2 - static_cast<long double>(d))) <=
              20 * std::numeric_limits<double>::epsilon() /
                  std::numeric_limits<long double>::epsilon());  // ulp of long double: 2048 to one of double
        const long double exact = std::pow(2 * pi, 1 - x) * g / ((1 - x) * std::log(gamma));
        CHECK(test::ulps<long double>(detail::structure_constant(d), exact) <=
              20 * std::numeric_limits<double>::epsilon() / std::numeric_limits<long double>::epsilon());
    }
}

TEST_CASE("The printed constant is low by the factors that the errata name") {
    // theory: (2 pi)^(4-2D) / (2 ln gamma) = 5.77, 4.98, 3.71 at D = 1.58, 1.62, 1.70, printed with three digits
    const auto ratio = [](double d) {
        return detail::structure_constant(d) / detail::structure_constant(d, StructureConvention::paper);
    };
    CHECK(std::abs(ratio(1.58) - 5.77) < 0.006);
    CHECK(std::abs(ratio(1.62) - 4.98) < 0.006);
    CHECK(std::abs(ratio(1.70) - 3.71) < 0.006);
    // and G inverted with it is too large by the 1/(2D-2) th power: 4.5, 3.7, 2.6
    const auto inverted = [&](double d) { return std::pow(ratio(d), 1 / (2 * d - 2)); };
    CHECK(std::abs(inverted(1.58) - 4.5) < 0.06);
    CHECK(std::abs(inverted(1.62) - 3.7) < 0.06);
    CHECK(std::abs(inverted(1.70) - 2.6) < 0.06);
}

TEMPLATE_TEST_CASE("G inverted from its own structure function comes back in every convention", "", float, double) {
    using T = TestType;
    for (const auto convention :
         {StructureConvention::exact, StructureConvention::paper, StructureConvention::majumdar_tien})
        for (const T d : {T(1.2), T(1.5), T(1.62), T(1.8)}) {
            const Fractal<T> fractal{d, T(1.2e-8)};
            const T s = detail::structure_function_at(T(3e-6), fractal, convention);
            // the 1/(2D-2) th power, up to 2.5, of a value known to some ulp
            CHECK(test::ulps(detail::fractal_roughness(d, T(3e-6), s, convention), fractal.roughness) <= 100);
        }
}

TEST_CASE("The power law of S scales with the unit of length") {
    for (const double unit : {1e-9, 1e9}) {
        const double s = detail::structure_function_at(3e-6, Fractal<double>{1.62, 1.2e-8});
        const double scaled = detail::structure_function_at(3e-6 * unit, Fractal<double>{1.62, 1.2e-8 * unit});
        CHECK(test::ulps(scaled, s * unit * unit) <= 20);
        CHECK(test::relative_error(detail::fractal_roughness(1.62, 3e-6 * unit, scaled), 1.2e-8 * unit) <= 1e-14);
    }
}

TEST_CASE("Arguments out of range are refused by name and value") {
    for (const double d : {1.0, 2.0, 0.5, 3.0, std::numeric_limits<double>::quiet_NaN()}) {
        const std::string refusal = test::refusal([&] { (void)detail::structure_constant(d); });
        CHECK(refusal.find("fractal_dimension = ") != std::string::npos);
    }
    CHECK(test::refusal([] {
              (void)detail::structure_constant(1.5, StructureConvention::exact, 1.0);
          }).find("gamma = 1") != std::string::npos);
    CHECK(test::refusal([] { (void)detail::fractal_roughness(1.5, 0.0, 1.0); }).find("lag = 0") != std::string::npos);
    CHECK(test::refusal([] { (void)detail::fractal_roughness(1.5, 1.0, -1.0); }).find("structure_function = -1") !=
          std::string::npos);
    // G = 10^-4500: no number
    CHECK_FALSE(test::refusal([] { (void)detail::fractal_roughness(1.001, 1e-6, 1e-21); }).empty());
    CHECK(detail::log_fractal_roughness(1.001, 1e-6, 1e-21) < -1000);
}

}  // namespace structure_constant_test
