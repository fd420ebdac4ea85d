// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/quadrature.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <gsl/gsl_integration.h>

namespace gauss_legendre_test {

using fstiff::math::GaussLegendre;

TEMPLATE_TEST_CASE("N points integrate polynomials of degree 2N-1", "", float, double) {
    using T = TestType;
    const auto& rule = GaussLegendre<T, 50>::get();
    T zeroth = 0, second = 0, last = 0, odd = 0;
    for (std::size_t i = 0; i < 50; ++i) {
        zeroth += rule.weight[i];
        second += rule.weight[i] * rule.node[i] * rule.node[i];
        last += rule.weight[i] * std::pow(rule.node[i], T(98));
        odd += rule.weight[i] * rule.node[i];
    }
    CHECK(test::ulps(zeroth, T(2)) <= 50);
    CHECK(test::ulps(second, T(2) / 3) <= 50);
    CHECK(test::ulps(last, T(2) / 99) <= 400);  // the power takes 98 times the rounding of the node
    CHECK(std::abs(odd) <= 10 * std::numeric_limits<T>::epsilon());
}

TEST_CASE("nodes and weights agree with GSL's table for 64 points") {
    gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(64);
    const auto& rule = GaussLegendre<double, 64>::get();
    for (std::size_t i = 0; i < 64; ++i) {
        double node = 0, weight = 0;
        gsl_integration_glfixed_point(-1, 1, i, &node, &weight, table);
        bool found =
            false;  // GSL orders them differently from version to version; both lose digits near the ends (1 - x^2)
        for (std::size_t j = 0; j < 64; ++j)
            found = found ||
                    (std::abs(rule.node[j] - node) < 1e-15 && test::relative_error(rule.weight[j], weight) < 2e-13);
        CHECK(found);
    }
    gsl_integration_glfixed_table_free(table);
}

TEST_CASE("the middle node of an odd rule is 0") {
    CHECK(GaussLegendre<double, 3>::get().node[1] == 0);
    CHECK(test::ulps(GaussLegendre<double, 3>::get().weight[1], 8.0 / 9) <= 4);
    CHECK(test::ulps(GaussLegendre<double, 3>::get().node[2], std::sqrt(0.6)) <= 4);
}

}  // namespace gauss_legendre_test
