// SPDX-License-Identifier: BSD-3-Clause
// Truth: boundary elements of the map itself, whose contact set is held together in the same way; a flat band, in
// closed form.
#include <fstiff/halfspace/bonded_contact.hpp>
#include <fstiff/halfspace/boundary_elements.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace bonded_contact_test {

using namespace fstiff;

TEST_CASE("A periodic flat band held together has the stiffness of its closed form") {
    // u = -(2 L/(pi E)) ln sin(pi a/(2 L)) p for bands of the width a in the period L
    HeightMap<double> map;
    map.dx = map.dy = 1.0 / 512;
    map.heights.resize(4, 512);
    for (int i = 0; i < 512; ++i) map.heights.col(i) = -std::abs(i - 255.5);
    const detail::HighestPoints<double> points(map, 3.0, Edges::periodic);
    for (const double share : {0.125, 0.25, 0.5}) {
        const double K = -3 * std::numbers::pi / (2 * std::log(std::sin(std::numbers::pi * share / 2)));
        CAPTURE(share);
        CHECK(test::relative_error(points.stiffness(share), K) <
              1e-2);  // a band ends half a step beyond its last point
    }
    CHECK(points.stiffness(0.25) < points.stiffness(0.26));
    CHECK_THROWS_AS(points.stiffness(0.0), domain_error);
    CHECK_THROWS_AS(points.stiffness(1.0), domain_error);
}

TEST_CASE("The highest points of a wave are its contact, whose stiffness boundary elements have") {
    HeightMap<double> map;
    map.dx = map.dy = 1.0 / 64;
    map.heights.resize(64, 64);
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            map.heights(j, i) =
                0.01 * std::cos(2 * std::numbers::pi * i / 64) * std::cos(2 * std::numbers::pi * j / 64) +
                1e-7 * j;  // no two points of one height
    for (const Edges edges : {Edges::mirrored, Edges::periodic}) {
        BoundaryElements<double> solver(map, 1.0, {.edges = edges});
        const auto state = solver.at_pressure(0.004);
        const detail::HighestPoints<double> points(map, 1.0, edges);
        CHECK(test::relative_error(points.stiffness(state.contact_fraction), state.stiffness) < 0.05);
        // the set itself: the same linear problem
        detail::GridField<double> on = (solver.pressures() > 0).cast<double>();
        detail::SurfaceCompliance<double> compliance(64, 64, map.dx, map.dy, edges);
        const auto held = detail::bonded<double>(compliance, on, on, 1e-9);
        CHECK(test::relative_error(1 / held.compliance, state.stiffness) < 1e-8);
        CHECK(held.residual < 1e-9);
        for (const double scatter : {1e-2, 1e-3, 1e-4}) {
            const auto rough = detail::bonded<double>(compliance, on, on, scatter);
            CAPTURE(scatter, rough.residual);
            CHECK(rough.compliance > held.compliance * (1 - 1e-12));  // the least there is
            CHECK(rough.compliance / held.compliance - 1 < 200 * rough.residual * rough.residual);
        }
    }
}

}  // namespace bonded_contact_test
