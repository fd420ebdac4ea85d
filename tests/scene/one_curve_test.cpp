// SPDX-License-Identifier: BSD-3-Clause
// The answer of a map over the pressure is one curve. Truth: boundary elements of the same map at each pressure alone,
// and that K, its ends and the pressure rise together.
#include <fstiff/contact/boundary_element_contact.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/library.hpp"
#include "support/map_kinds.hpp"

#include <fstiff/answer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace one_curve_test {

using namespace fstiff;

namespace {

/// A joint of \p map and a smooth face, E* = 100 GPa; of \p hardness [Pa], 0: elastic.
Joint joint_of(const HeightMap<double>& map, double hardness) {
    Joint joint{
        .face = {.measured = measured_face(measure(map))}, .effective_modulus = 100e9, .nominal_area = map.area()};
    joint.upper.hardness = hardness > 0 ? hardness : std::numeric_limits<double>::infinity();
    return joint;
}

HeightMap<double> map_of(double hurst, std::uint64_t seed, int points = 64) {
    return self_affine_map<double>(
        {.hurst = hurst, .rms = 0.2e-6, .longest_wavelength = 16e-6, .shortest_wavelength = 4e-6, .seed = seed}, points,
        points, 1e-6, 1e-6);
}

/// \p count pressures at equal steps of ln p.
std::vector<double> pressures_of(double from, double to, int count) {
    std::vector<double> all;
    for (int i = 0; i < count; ++i) all.push_back(from * std::pow(to / from, i / (count - 1.0)));
    return all;
}

}  // namespace

TEST_CASE("A list and a range of pressures have the same K at the same pressure") {
    const Joint joint = joint_of(map_of(0.8, 3), 0);
    const std::vector<double> range = pressures_of(1e6, 2e9, 40), list{range[30], range[7], range[21]};
    const Answer of_range = answer(joint, range, {.samples = 0}), of_list = answer(joint, list, {.samples = 0});
    CHECK(of_list.points[0].stiffness.value == of_range.points[30].stiffness.value);
    CHECK(of_list.points[1].stiffness.value == of_range.points[7].stiffness.value);
    CHECK(of_list.points[2].stiffness.value == of_range.points[21].stiffness.value);
    CHECK(of_range.points[30].law == LawKind::boundary_elements);
}

TEST_CASE("K of a map and both ends of its band rise with the pressure, over the passage from its summits too") {
    for (const double hardness : {0.0, 2e9})
        for (const std::uint64_t seed : {4u, 5u, 6u}) {
            CAPTURE(hardness, seed);
            const Joint joint = joint_of(map_of(seed == 5 ? 0.5 : 0.8, seed), hardness);
            const Answer found = answer(joint, pressures_of(2e4, hardness > 0 ? 1e9 : 6e9, 50), {.samples = 50});
            int of_summits = 0, solved = 0;
            const AnswerPoint* last = nullptr;
            for (const AnswerPoint& at : found.points) {
                if (!at.ok()) continue;
                (at.law == LawKind::boundary_elements ? solved : of_summits) += 1;
                if (at.loading_stiffness) CHECK(*at.loading_stiffness <= at.stiffness.value);
                if (last) {
                    CHECK(at.stiffness.value > last->stiffness.value);
                    CHECK(at.stiffness.low >= last->stiffness.low);
                    CHECK(at.stiffness.high >= last->stiffness.high);
                    CHECK(at.stiffness.value < 1.6 * last->stiffness.value * at.pressure / last->pressure);
                }
                last = &at;
            }
            CHECK(of_summits > 5);
            CHECK(solved > 20);
        }
}

TEST_CASE("K of many pressures is within 1 % of boundary elements at each of them alone") {
    for (const double hardness : {0.0, 2e9}) {
        CAPTURE(hardness);
        const Joint joint = joint_of(map_of(0.8, 8, 128), hardness);
        const Answer found = answer(joint, pressures_of(3e7, 1.6e9, 75), {.samples = 0});
        for (std::size_t i = 4; i < found.points.size(); i += 7) {
            const auto& at = found.points[i];
            if (at.law != LawKind::boundary_elements || *at.p_star < 0.02) continue;  // a smooth K from here
            const Answer alone = answer(joint, std::vector<double>{at.pressure}, {.samples = 0});
            CHECK(test::relative_error(at.stiffness.value, alone.points[0].stiffness.value) < 0.01);
        }
    }
}

TEST_CASE("The loading stiffness of a map that yields is that of the separations of boundary elements") {
    const HeightMap<double> map = test::map_kinds()[2].map(9);  // H 0.8, 8 to 32 waves, gradient 0.1, of side 1
    const double E = 1, H = 0.02;
    const BoundaryElementContact<double> contact(map, E, {.edges = Edges::periodic, .hardness = H});
    for (const double share : {0.01, 0.1, 0.4}) {
        CAPTURE(share);
        const ContactState<double> at = contact.at_pressure(share * H);
        const double above = contact.at_pressure(1.03 * share * H).separation.value,
                     below = contact.at_pressure(0.97 * share * H).separation.value;
        CHECK(test::relative_error(at.loading_stiffness.value, 0.06 * share * H / (below - above)) < 0.05);
        CHECK(at.loading_stiffness.value < 0.8 * at.stiffness.value);
    }
}

TEST_CASE("Bands of a plastic law over many pressures, which are computed at a few, are those of each by itself") {
    const Body steel{.elastic = {205e9, 0.3}, .yield_strength = 400e6};
    const Joint joint{.face = {.rms_height = 0.8e-6,
                               .rms_gradient = 0.1,
                               .alpha = 10,
                               .errors = {.height = 0.05e-6, .gradient = 0.01}},
                      .upper = steel,
                      .lower = steel};
    const AnswerOptions options{.laws = {laws::jackson_green}, .samples = 40};
    const std::vector<double> many = pressures_of(1e6, 1e8, 61);
    const Answer of_many = answer(joint, many, options);
    for (const std::size_t i : {0u, 17u, 40u, 60u}) {
        const auto& found = of_many.laws.front().points[i].stiffness;
        const auto alone = answer(joint, std::vector{many[i]}, options).laws.front().points.front().stiffness;
        CAPTURE(many[i]);
        CHECK(found.value == alone.value);
        CHECK(found.low < 0.95 * found.value);
        CHECK(test::relative_error(found.low, alone.low) < 1e-6);  // 4e-8 by the polynomial over ln p
        CHECK(test::relative_error(found.high, alone.high) < 1e-6);
    }
}

}  // namespace one_curve_test
