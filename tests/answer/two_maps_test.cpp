// SPDX-License-Identifier: BSD-3-Clause
// The answer of two maps, which meet at a shift that is not known. Truth: boundary elements of the maps added at shifts
// that the answer did not compute.
#include <fstiff/answer/answer.hpp>
#include <fstiff/contact/boundary_element_contact.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/sum_of_maps.hpp>

#include "support/catch.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace two_maps_test {

using namespace fstiff;

namespace {

HeightMap<double> map_of(double rms, std::uint64_t seed) {
    return self_affine_map<double>(
        {.hurst = 0.8, .rms = rms, .longest_wavelength = 32e-6, .shortest_wavelength = 4e-6, .seed = seed}, 64, 64,
        1e-6, 1e-6);
}

Joint joint_of(const HeightMap<double>& upper, const HeightMap<double>& lower) {
    const auto face = [](const HeightMap<double>& map) {
        return JointFace{.measured = measured_face(measure(map, {.map_form = MapForm::mean}))};
    };
    return {.face = face(upper),
            .other = face(lower),
            .upper = {.hardness = std::numeric_limits<double>::infinity()},
            .effective_modulus = 1e11};
}

}  // namespace

TEST_CASE("Two maps have one K whichever is the upper one, and its band holds that of shifts that were not computed") {
    int inside = 0, all = 0;
    for (const std::uint64_t seed : {1u, 3u, 5u, 7u}) {
        const HeightMap<double> rough = map_of(0.3e-6, seed), fine = map_of(0.2e-6, seed + 1);
        const std::vector<double> pressures{1e8, 5e8, 2e9};
        const Answer one = answer(joint_of(rough, fine), pressures), other = answer(joint_of(fine, rough), pressures);
        for (std::size_t i = 0; i < pressures.size(); ++i) {
            const WithBand &K = one.points[i].stiffness, &exchanged = other.points[i].stiffness;
            CHECK(K.value == exchanged.value);
            CHECK(K.low == exchanged.low);
            CHECK(K.high == exchanged.high);
            for (const Eigen::Index shift : {5, 17, 29, 41, 53}) {
                const BoundaryElementContact<double> solved(detail::shifted_sum(rough, fine, shift, 64 - shift), 1e11,
                                                            {.edges = Edges::mirrored});
                const double truth = solved.at_pressure(pressures[i]).stiffness.value;
                inside += K.low <= truth && truth <= K.high, ++all;
            }
        }
        CHECK(one.points.back().law == LawKind::boundary_elements);
    }
    CAPTURE(inside, all);
    CHECK(inside >= 0.88 * all);
}

}  // namespace two_maps_test
