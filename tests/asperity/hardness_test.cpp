// SPDX-License-Identifier: BSD-3-Clause
// Units of hardness, and the lesser of two numbers with ranges against draws of both.
#include <fstiff/asperity/hardness.hpp>
#include <fstiff/asperity/material.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace hardness_test {

using fstiff::PriorRange;
using test::relative_error;

TEST_CASE("The pressure under a pyramid is its force over the area at the surface") {
    // a square pyramid of 136 degrees between faces: faces d^2/(2 sin 68), surface d^2/2
    const double angle = 68 * std::acos(-1.0) / 180;
    CHECK(relative_error(fstiff::detail::vickers_pressure, 9.80665e6 / std::sin(angle)) < 1e-12);
}

TEST_CASE("Rockwell hardness follows the table of ASTM E140 for steel") {
    // ASTM E140-07, table 1, which the numbers were not read of
    const double pairs[][2]{{22, 248}, {33, 327}, {42, 412}, {47, 471}, {53, 560}, {57, 636}, {61, 720}, {66, 865}};
    for (const auto& [rockwell, vickers] : pairs)
        CHECK(relative_error(fstiff::detail::vickers_of_rockwell(rockwell), vickers) < 0.03);
    for (const double out : {19.9, 68.1, -1.0, std::nan("")})
        CHECK_THROWS_AS(fstiff::detail::vickers_of_rockwell(out), fstiff::domain_error);
}

TEST_CASE("The softer of two bodies has the quantiles of the lesser of two draws") {
    const PriorRange a{1e9, 2e9, 8e9}, b{1.5e9, 2.5e9, 3.5e9};
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto draw = [&](const PriorRange& of) {
        const double z = normal(random) / 1.6448536269514722;
        return of.middle * std::pow(z < 0 ? of.middle / of.low : of.high / of.middle, z);
    };
    std::vector<double> lesser(200000);
    for (double& one : lesser) one = std::min(draw(a), draw(b));
    std::sort(lesser.begin(), lesser.end());
    const PriorRange found = fstiff::detail::softer(a, b);
    const auto at = [&](double share) { return lesser[static_cast<std::size_t>(share * 2e5)]; };
    CHECK(relative_error(found.low, at(0.05)) < 0.01);  // 4 standard errors of a quantile of these draws
    CHECK(relative_error(found.middle, at(0.5)) < 0.01);
    CHECK(relative_error(found.high, at(0.95)) < 0.01);
}

TEST_CASE("A known hardness bounds that of the other body") {
    const PriorRange open{1e9, 2e9, 8e9}, soft{0.5e9, 0.5e9, 0.5e9}, between{3e9, 3e9, 3e9};
    const auto equals = [](const PriorRange& x, double low, double middle, double high) {
        return x.low == low && x.middle == middle && x.high == high;
    };
    CHECK(equals(fstiff::detail::softer(open, soft), 0.5e9, 0.5e9, 0.5e9));
    CHECK(equals(fstiff::detail::softer(between, open), 1e9, 2e9, 3e9));
    constexpr double never = std::numeric_limits<double>::infinity();
    CHECK(equals(fstiff::detail::softer(open, {never, never, never}), 1e9, 2e9, 8e9));
    CHECK(std::isinf(fstiff::detail::softer({never, never, never}, {never, never, never}).low));
    CHECK(std::isinf(fstiff::detail::hardness_of_elastic({2e6, 0.49}).low));  // rubber
}

}  // namespace hardness_test
