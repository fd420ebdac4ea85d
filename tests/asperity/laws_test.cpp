// SPDX-License-Identifier: BSD-3-Clause
// The three asperity laws: derivatives, the factor f of the reference paper, arrays against scalars, refusals.
#include <fstiff/asperity/laws.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace laws_test {

using fstiff::AsperityLaw;
using fstiff::FractalConsistentLaw;
using fstiff::FractalLaw;
using fstiff::HertzLaw;
using fstiff::detail::PowerLaw;

namespace {

using Wide = long double;

// Eighth-order central difference; with steps of 1/200 of x its truncation is below 1e-17 for x^(3/2).
template <class F>
double derivative(const F& f, double x) {
    const double h = x / 200;
    return (4 * (f(x + h) - f(x - h)) / 5 - (f(x + 2 * h) - f(x - 2 * h)) / 5 +
            4 * (f(x + 3 * h) - f(x - 3 * h)) / 105 - (f(x + 4 * h) - f(x - 4 * h)) / 280) /
           h;
}

template <class T>
Wide ulps(T computed, Wide truth) {
    return test::relative_error<Wide>(computed, truth) / std::numeric_limits<T>::epsilon();
}

// Only a shape that the concepts must distinguish: a law with a kink, no power law.
struct KinkedLaw {
    double load(double omega, double radius) const { return omega > radius ? 2 * omega : omega; }
    double stiffness(double omega, double radius) const { return omega > radius ? 2 : 1; }
    double area(double omega, double) const { return omega; }
};

}  // namespace

TEST_CASE("the concepts distinguish asperity laws from power laws", "[laws]") {
    CHECK((AsperityLaw<HertzLaw<double>, double>));
    CHECK((AsperityLaw<FractalLaw<float>, Eigen::ArrayXf>));
    CHECK((PowerLaw<FractalConsistentLaw<double>>));
    CHECK((AsperityLaw<KinkedLaw, double>));
    CHECK(!(PowerLaw<KinkedLaw>));
    CHECK(!(AsperityLaw<int, double>));
}

TEMPLATE_TEST_CASE("load, stiffness and area keep their stated accuracy", "[laws]", float, double) {
    using T = TestType;
    const Wide pi = std::numbers::pi_v<Wide>;
    Wide worst = 0;
    for (const T d : {T(1.05), T(1.5), T(1.62), T(1.97)}) {
        const Wide f = 2 * (3 - Wide(d)) / (3 * (2 - Wide(d)));
        const HertzLaw<T> hertz;
        const FractalLaw<T> fractal(d);
        const FractalConsistentLaw<T> consistent(d);
        for (T omega = T(1e-10); omega < T(1e-3); omega *= T(1.31)) {
            for (const T radius : {T(1.9e-5), T(3e-5), T(4e-5), T(1.7)}) {
                const Wide root = std::sqrt(Wide(radius) * omega);
                const Wide load = 4 * omega * root / 3, stiffness = 2 * root, area = pi * radius * omega;
                worst = std::max(
                    {worst, ulps(hertz.load(omega, radius), load), ulps(hertz.stiffness(omega, radius), stiffness),
                     ulps(fractal.load(omega, radius), load), ulps(fractal.stiffness(omega, radius), f * stiffness),
                     ulps(consistent.load(omega, radius), f * load),
                     ulps(consistent.stiffness(omega, radius), f * stiffness), ulps(hertz.area(omega, radius), area),
                     ulps(fractal.area(omega, radius), area), ulps(consistent.area(omega, radius), area)});
            }
        }
    }
    CAPTURE(worst);
    CHECK(worst <= 4);
}

TEST_CASE("stiffness is the derivative of the load for hertz and fractal_consistent, f times it for fractal",
          "[laws]") {
    for (const double d : {1.05, 1.58, 1.62, 1.7, 1.95}) {
        const HertzLaw<double> hertz;
        const FractalLaw<double> fractal(d);
        const FractalConsistentLaw<double> consistent(d);
        for (const double omega : {1e-9, 3e-7, 1e-5}) {
            const double radius = 4e-5;
            CAPTURE(d, omega);
            const auto slope = [&](const auto& law) {
                return derivative([&](double w) { return law.load(w, radius); }, omega);
            };
            // Rounding of the differences: some eps over the step of 1/200.
            CHECK(test::relative_error(hertz.stiffness(omega, radius), slope(hertz)) < 1e-13);
            CHECK(test::relative_error(consistent.stiffness(omega, radius), slope(consistent)) < 1e-13);
            CHECK(test::relative_error(fractal.stiffness(omega, radius) / slope(fractal),
                                       fstiff::detail::fractal_stiffness_factor(d)) < 1e-13);
        }
    }
}

TEMPLATE_TEST_CASE("the factor f has its published values, its limits and its pole", "[laws]", float, double) {
    using T = TestType;
    const T eps = std::numeric_limits<T>::epsilon();
    struct Row {
        T dimension, factor;
    };
    // Three decimals for Table 2 of the paper: half a unit of the last is the tolerance.
    for (const auto& row : {Row{T(1.62), T(2.421)}, {T(1.58), T(2.254)}, {T(1.7), T(2.889)}})
        CHECK(std::abs(fstiff::detail::fractal_stiffness_factor(row.dimension) - row.factor) <= T(5e-4));
    CHECK(test::ulps(fstiff::detail::fractal_stiffness_factor(T(1.5)), T(2)) <= 1);
    CHECK(test::ulps(fstiff::detail::fractal_stiffness_factor(1 + eps), T(4) / 3) <= 2);
    CHECK(test::ulps(fstiff::detail::fractal_stiffness_factor(2 - eps), 2 / (3 * eps)) <= 4);
    for (int i = 1; i < 100; ++i) CHECK(fstiff::detail::fractal_stiffness_factor(1 + T(i) / 100) > T(4) / 3);
    constexpr T at_compile_time = fstiff::detail::fractal_stiffness_factor(T(1.5));
    CHECK(at_compile_time == fstiff::detail::fractal_stiffness_factor(T(1.5)));
}

TEMPLATE_TEST_CASE("a law of an Eigen array is the law of its elements", "[laws]", float, double) {
    using T = TestType;
    using Array = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic>;
    Array omega(7, 5), radius(7, 5);
    for (Eigen::Index i = 0; i < omega.size(); ++i) {
        omega(i) = T(1e-9) * std::exp2(T(i) / 3);
        radius(i) = T(4e-5) / T(1 + i);
    }
    omega(3) = 0;
    // The compiler may contract products; and Eigen takes float square roots from the reciprocal root, an ulp off.
    const T allowed = std::is_same_v<T, float> ? 2 : 1;
    const auto check = [&](const auto& law) {
        const Array load = law.load(omega, radius), stiffness = law.stiffness(omega, radius),
                    area = law.area(omega, radius);
        for (Eigen::Index i = 0; i < omega.size(); ++i) {
            CHECK(test::ulps(load(i), law.load(omega(i), radius(i))) <= allowed);
            CHECK(test::ulps(stiffness(i), law.stiffness(omega(i), radius(i))) <= allowed);
            CHECK(test::ulps(area(i), law.area(omega(i), radius(i))) <= 1);
        }
        CHECK((load(3) == 0 && stiffness(3) == 0 && area(3) == 0));
    };
    check(HertzLaw<T>{});
    check(FractalLaw<T>(T(1.62)));
    check(FractalConsistentLaw<T>(T(1.62)));
}

TEST_CASE("a result of a law does not depend on the unit of length", "[laws]") {
    const FractalLaw<double> law(1.62);
    const double omega = 3e-7, radius = 4e-5;
    for (const double unit : {1e9, 1e-9}) {
        CHECK(test::ulps(law.load(omega * unit, radius * unit), law.load(omega, radius) * unit * unit) <= 8);
        CHECK(test::ulps(law.stiffness(omega * unit, radius * unit), law.stiffness(omega, radius) * unit) <= 8);
        CHECK(test::ulps(law.area(omega * unit, radius * unit), law.area(omega, radius) * unit * unit) <= 8);
    }
}

TEMPLATE_TEST_CASE("a fractal dimension outside (1, 2) is refused by name", "[laws]", float, double) {
    using T = TestType;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (const T bad : {T(1), T(2), T(0), T(-1.5), T(3), inf, -inf, nan}) {
        for (const std::string& text :
             {test::refusal([&] { FractalLaw<T> law(bad); }), test::refusal([&] { FractalConsistentLaw<T> law(bad); }),
              test::refusal([&] { (void)fstiff::detail::fractal_stiffness_factor(bad); })}) {
            CAPTURE(bad, text);
            CHECK(text.find("fractal_dimension = ") == 0);
            CHECK(text.find(": must be between 1 and 2, both excluded") != std::string::npos);
        }
    }
    CHECK(test::refusal([] { FractalLaw<T> law(T(2.5)); }) ==
          "fractal_dimension = 2.5: must be between 1 and 2, both excluded");
}

}  // namespace laws_test
