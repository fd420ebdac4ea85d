// SPDX-License-Identifier: BSD-3-Clause
// Truth: boundary elements whose pressures are cut at the hardness; K_cut and K_elastic by themselves; differences of
// p(d).
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/topography/coarsen.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/summits.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <cmath>

namespace plastic_contact_map_test {

using namespace fstiff;

auto elastic_of(const HeightMap<double>& map) {
    return HybridContact(SummitContact<double>(summits_of(map), 1.0),
                         PerssonContact<double>(map_spectrum(map, Edges::periodic), 1.0));
}

TEST_CASE("The plastic contact of a map is near boundary elements with a hardness") {
    const HeightMap<double> map = test::half_space_map("gaussian");
    const auto elastic = elastic_of(map);
    const double g = map_spectrum(map, Edges::periodic).rms_gradient(), sigma = rms_height(map);
    const parts::MapCut<double> cut(map, 1.0, Edges::periodic);
    for (const double over_gradient : {0.05, 0.2}) {
        const double hardness = over_gradient * g;
        BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic, .hardness = hardness, .tolerance = 1e-6});
        const PlasticContact contact(elastic, cut, hardness, 1.0, g);
        const PlasticContact numbers(elastic, parts::GaussianCut<double>(sigma, g, 1.0), hardness, 1.0, g);
        for (const double share : {0.01, 0.03}) {
            const double p = share * hardness;
            const auto truth = solver.at_pressure(p);
            const auto state = contact.at_pressure(p);
            CAPTURE(over_gradient, share);
            CHECK(test::relative_error(state.stiffness.value, truth.stiffness) < 0.15);
            CHECK(test::relative_error(numbers.at_pressure(p).stiffness.value, truth.stiffness) < 0.2);
            CHECK(test::relative_error(state.real_area_fraction.value, truth.contact_fraction) < 0.05);
            CHECK(std::abs(state.separation.value - truth.mean_gap) < 0.1 * sigma);
            CHECK(truth.stiffness > 1.3 * elastic.stiffness(p));
        }
    }
}

TEST_CASE("K of a plastic contact joins its parts, and its load is that of both") {
    const double E = 1e11, H = 2e9;
    const PerssonContact<double> persson(BandSpectrum<double>{5e-7, 0.8, 1e4, 1e4, 1e6}, E);
    const double g = persson.rms_gradient(), sigma = persson.rms_height();
    const parts::GaussianCut<double> cut(sigma, g, E);
    const PlasticContact contact(persson, cut, H, E, g);
    static_assert(Contact<decltype(contact), double>);
    static_assert(!parts::ProportionalContact<decltype(contact), double>);
    for (const double p : {1e5, 1e7, 3e8}) {
        const auto state = contact.at_pressure(p);
        const double K_cut = 0.68 * E * g * p / (sigma * H), K = persson.stiffness(p);
        CAPTURE(p);
        CHECK(test::relative_error(std::pow(state.stiffness.value, 1.9), std::pow(K_cut, 1.9) + std::pow(K, 1.9)) <
              1e-12);
        CHECK(test::relative_error(state.real_area_fraction.value, p * std::sqrt(1 / (H * H) + 4 / (E * g * E * g))) <
              1e-12);
        const double d = state.separation.value;
        const double p_cut = H * std::erfc(d / sigma / std::sqrt(2.0)) / 2,
                     p_elastic = persson.at_separation(d).pressure.value;
        CHECK(test::relative_error(std::pow(p, -1.3), std::pow(p_cut, -1.3) + std::pow(p_elastic, -1.3)) < 1e-7);
        const double step = 1e-4 * p, rise = contact.at_pressure(p - step).separation.value -
                                             contact.at_pressure(p + step).separation.value;
        CHECK(test::relative_error(state.loading_stiffness.value, 2 * step / rise) < 1e-4);
        CHECK(test::relative_error(contact.at_separation(d).stiffness.value, state.stiffness.value) < 1e-7);
        CHECK(std::abs(contact.log_stiffness(state.eta).value - std::log(state.stiffness.value)) < 1e-7);
    }
    CHECK_THROWS_AS(contact.at_pressure(H), domain_error);
    CHECK_THROWS_AS(contact.at_pressure(0), domain_error);
    CHECK(contact.point_at_pressure(2 * H).status == PointStatus::out_of_reach);
    CHECK_THROWS_AS(PlasticContact(persson, cut, 0.0, E, g), domain_error);
    CHECK_THROWS_AS(parts::GaussianCut<double>(sigma, -1, E), domain_error);
}

}  // namespace plastic_contact_map_test
