// SPDX-License-Identifier: BSD-3-Clause
// The effective modulus (3.15): closed values, accuracy, symmetry, refusals.
#include <fstiff/asperity/material.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <limits>

namespace material_test {

using fstiff::effective_modulus;
using fstiff::Material;

TEMPLATE_TEST_CASE("the effective modulus keeps its stated accuracy", "[material]", float, double) {
    using T = TestType;
    using Wide = long double;
    Wide worst = 0;
    for (const T e1 : {T(1e3), T(2e9), T(205e9)}) {
        for (const T e2 : {T(70e9), T(205e9), T(1.2e12)}) {
            for (int i = -99; i <= 50; ++i) {
                const T nu1 = T(i) / 100, nu2 = T(-i) / 200;
                const Wide truth = 1 / ((1 - Wide(nu1) * nu1) / e1 + (1 - Wide(nu2) * nu2) / e2);
                const Wide computed = effective_modulus<T>({e1, nu1}, {e2, nu2});
                worst = std::max(worst, test::relative_error(computed, truth) / std::numeric_limits<T>::epsilon());
            }
        }
    }
    CAPTURE(worst);
    CHECK(worst <= 3);
}

TEMPLATE_TEST_CASE("simple pairs of materials have simple effective moduli", "[material]", float, double) {
    using T = TestType;
    // nu = 0.5: each body contributes 3/(4 E_i). nu = 0, E = 2 and 2: 1.
    CHECK(test::ulps(effective_modulus<T>({3, T(0.5)}, {3, T(0.5)}), T(2)) <= 3);
    CHECK(effective_modulus<T>({2, 0}, {2, 0}) == 1);
    CHECK(effective_modulus<T>({2, T(0.5)}, {2, T(-0.5)}) == effective_modulus<T>({2, T(0.5)}, {2, T(0.5)}));
    // Steel on steel of the paper: 205 GPa / (2 * 0.91).
    CHECK(test::ulps(effective_modulus<T>({T(205e9L), T(0.3L)}, {T(205e9L), T(0.3L)}), T(205e9L) / T(1.82L)) <= 4);
    // A rigid counter body leaves E1/(1 - nu^2); either body may be called the upper one.
    CHECK(test::ulps(effective_modulus<T>({1, T(0.5)}, {std::numeric_limits<T>::max(), 0}), T(4) / 3) <= 3);
    CHECK(effective_modulus<T>({7, T(0.25)}, {5, T(0.125)}) == effective_modulus<T>({5, T(0.125)}, {7, T(0.25)}));
    constexpr T at_compile_time = effective_modulus<T>({2, 0}, {2, 0});
    CHECK(at_compile_time == 1);
}

TEMPLATE_TEST_CASE("elastic constants out of range are refused by name", "[material]", float, double) {
    using T = TestType;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const Material<T> good{T(205e9), T(0.3)};
    for (const T bad : {T(0), T(-205e9), inf, nan}) {
        for (const auto& text : {test::refusal([&] {
                                     (void)effective_modulus<T>({bad, T(0.3)}, good);
                                 }),
                                 test::refusal([&] {
                                     (void)effective_modulus<T>(good, {bad, T(0.3)});
                                 })}) {
            CAPTURE(bad, text);
            CHECK(text.find("youngs_modulus = ") == 0);
            CHECK(text.find("finite and greater than 0") != std::string::npos);
        }
    }
    for (const T bad : {T(-1), T(0.5000001), T(1), T(-7), inf, -inf, nan}) {
        for (const auto& text : {test::refusal([&] {
                                     (void)effective_modulus<T>({1, bad}, good);
                                 }),
                                 test::refusal([&] {
                                     (void)effective_modulus<T>(good, {1, bad});
                                 })}) {
            CAPTURE(bad, text);
            CHECK(text.find("poisson_ratio = ") == 0);
            CHECK(text.find("greater than -1 and at most 0.5") != std::string::npos);
        }
    }
    CHECK(test::refusal([&] { (void)effective_modulus<T>({1, T(0.5)}, good); }) == "");
    CHECK(test::refusal([&] { (void)effective_modulus<T>({1, T(-0.99)}, good); }) == "");
}

}  // namespace material_test
