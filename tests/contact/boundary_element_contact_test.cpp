// SPDX-License-Identifier: BSD-3-Clause
// Truth: boundary elements themselves; the way back from a separation; -dp/dd by difference, which K is where the set
// of contacts changes smoothly.
#include <fstiff/contact/boundary_element_contact.hpp>
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/summit_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace boundary_element_contact_test {

using namespace fstiff;

static_assert(detail::HasStates<BoundaryElementContact<double>, double>);
static_assert(detail::HasStates<SummitContact<double>, double>);
static_assert(!Contact<BoundaryElementContact<double>, double>);  // no table: every state is a solution

namespace {

HeightMap<double> small_map() {
    HeightMap<double> map = test::half_space_map("gaussian");
    map.heights = map.heights.topLeftCorner(64, 64).eval();
    return map;
}

}  // namespace

TEST_CASE("boundary elements as a contact have the states of the solver, bit for bit") {
    const HeightMap<double> map = small_map();
    const double E = 2;
    const std::vector<double> pressures{0.01, 0.05};
    for (const Eigen::Index points : {32, 64}) {
        const HalfSpaceOptions<double> options{.points = points, .edges = Edges::periodic};
        const BoundaryElementContact<double> contact(map, E, options);
        const auto solved = solve_half_space(map, E, pressures, options);
        const auto curve = curve_at_pressures(contact, pressures);
        CHECK(contact.rms_height() == rms_height(map));
        for (std::size_t i = 0; i < pressures.size(); ++i) {
            REQUIRE(curve[i].ok());
            const ContactState<double>& state = curve[i].state;
            CHECK(state.stiffness.value == solved[i].state.stiffness);
            CHECK(state.stiffness.error == solved[i].stiffness_error);
            CHECK(state.separation.value == solved[i].state.mean_gap);
            CHECK(state.separation.error == solved[i].gap_error);
            CHECK(state.loading_stiffness.value == state.stiffness.value);
            CHECK(state.real_area_fraction.value == solved[i].state.contact_fraction);
            CHECK(test::relative_error(state.eta * rms_height(map), state.separation.value) < 1e-15);
            CHECK(test::relative_error(state.contact_density.value * map.area(), double(solved[i].state.spots)) <
                  1e-14);
        }
        const double d = curve[1].state.separation.value;
        CHECK(test::relative_error(contact.at_separation(d).pressure.value, pressures[1]) < 1e-7);
    }
    const BoundaryElementContact<double> contact(map, E, {.points = 64, .grid_error = false});
    const double p = 0.05, step = 2e-3;
    const double chord =
        2 * step * p /
        (contact.at_pressure(p * (1 - step)).separation.value - contact.at_pressure(p * (1 + step)).separation.value);
    CHECK(test::relative_error(contact.at_pressure(p).stiffness.value, chord) < 1e-2);
}

TEST_CASE("boundary elements as a contact refuse points out of reach and keep the others") {
    const HeightMap<double> map = small_map();
    const BoundaryElementContact<double> hard(map, 2, {.points = 32, .hardness = 0.5});
    CHECK(hard.point_at_pressure(0.5).reason == "pressure = 0.5: must be less than the hardness (Pa)");
    CHECK(hard.point_at_pressure(0.01).ok());
    const ContactState<double> pressed = hard.at_pressure(0.01);
    CHECK(pressed.loading_stiffness.value > 0);
    CHECK(pressed.loading_stiffness.value <= pressed.stiffness.value);
    const ContactState<double> of_unloading = hard.at_pressure(0.01, Quantity::stiffness);
    CHECK(of_unloading.stiffness.value == pressed.stiffness.value);
    CHECK(of_unloading.stiffness.error == pressed.stiffness.error);
    CHECK(of_unloading.separation.value == pressed.separation.value);
    CHECK(of_unloading.loading_stiffness.value == pressed.stiffness.value);
    const BoundaryElementContact<double> elastic(map, 2, {.points = 32});
    CHECK(elastic.point_at_pressure(1e6).reason == "all points of the map are in contact");
    CHECK(test::refusal([&] { (void)elastic.at_pressure(1e6); }) == "all points of the map are in contact");
    for (const double separation : {0.0, -1e-3, map.heights.maxCoeff() - map.heights.mean()})
        CHECK(elastic.point_at_separation(separation).status == PointStatus::out_of_reach);
    CHECK(test::refusal([&] { (void)elastic.at_pressure(0); }).find("pressure = 0") == 0);
    CHECK(test::refusal([&] { BoundaryElementContact<double>(map, -1); }).find("effective_modulus") == 0);
    CHECK(test::refusal([&] { BoundaryElementContact<double>(map, 1, {.points = 8}); }).find("points = 8") == 0);
    HeightMap<double> hole = map;
    hole.heights(3, 4) = std::numeric_limits<double>::quiet_NaN();
    CHECK(test::refusal([&] { BoundaryElementContact<double>(hole, 1); }).find("boundary elements") !=
          std::string::npos);
}

}  // namespace boundary_element_contact_test
