// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace mindlin_test {

using namespace fstiff;

namespace {

/// From the stiffnesses of a circle of unit radius, in long double.
long double from_circle(const Material<double>& a, const Material<double>& b) {
    const long double of_a = a.poisson_ratio, of_b = b.poisson_ratio;
    const long double shear_a = a.youngs_modulus / (2 * (1 + of_a)), shear_b = b.youngs_modulus / (2 * (1 + of_b));
    const long double normal = 2 / ((1 - of_a * of_a) / a.youngs_modulus + (1 - of_b * of_b) / b.youngs_modulus);
    const long double tangential = 8 / ((2 - of_a) / shear_a + (2 - of_b) / shear_b);
    return tangential / normal;
}

}  // namespace

TEST_CASE("Mindlin's ratio of like bodies is 2(1-nu)/(2-nu)") {
    for (const double nu : {-0.5, 0.0, 0.2, 0.3, 0.5})
        CHECK(test::ulps(tangential_ratio<double>({205e9, nu}, {205e9, nu}), 2 * (1 - nu) / (2 - nu)) <= 5);
    CHECK(test::relative_error(tangential_ratio<double>({205e9, 0.3}, {205e9, 0.3}), 1.4 / 1.7) < 1e-15);
}

TEST_CASE("Mindlin's ratio of unlike bodies is that of one circle, from either side") {
    for (const double e : {1e-3, 1.0, 70e9, 1e30})
        for (const double nu : {-0.9, 0.0, 0.3, 0.5}) {
            const Material<double> a{e, nu}, b{205e9, 0.28};
            const auto truth = static_cast<double>(from_circle(a, b));
            CHECK(test::ulps(tangential_ratio(a, b), truth) <= 5);
            CHECK(tangential_ratio(a, b) == tangential_ratio(b, a));
        }
    // the soft body decides
    CHECK(test::relative_error(tangential_ratio<double>({1e30, 0.1}, {1e3, 0.5}), 2.0 / 3.0) < 1e-15);
}

TEST_CASE("Mindlin's ratio refuses impossible constants") {
    CHECK(test::refusal([] {
              static_cast<void>(tangential_ratio<double>({0, 0.3}, {1, 0.3}));
          }).find("youngs_modulus") != std::string::npos);
    CHECK(test::refusal([] {
              static_cast<void>(tangential_ratio<double>({1, 0.3}, {1, 0.6}));
          }).find("poisson_ratio") != std::string::npos);
}

}  // namespace mindlin_test
