// SPDX-License-Identifier: BSD-3-Clause
// Truth: boundary elements whose pressures are cut at the hardness, of a map and of tests/data/plastic_closing.csv
// (make_plastic_closing.py; no map of it was fitted); elastic and flowed limits in closed form; differences of p(d).
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/summits.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

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
    const detail::MapCut<double> cut(map, 1.0, Edges::periodic);
    for (const double over_gradient : {0.05, 0.2}) {
        const double hardness = over_gradient * g;
        BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic, .hardness = hardness, .tolerance = 1e-6});
        const PlasticContact contact(elastic, cut, hardness);
        const PlasticContact numbers(elastic, detail::GaussianCut<double>(sigma, g, 1.0), hardness);
        for (const double share : {0.01, 0.03, 0.3, 0.7}) {
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

/// Gaussian surface with rms height, gradient and modulus 1, so that H is H/(E g) and K is K sigma/(E g).
auto gaussian(double alpha, double hurst) {
    return hybrid_of_band(detail::band_of_moments<double>({1, 0.5, alpha / 4}, hurst), 1.0);
}
const detail::GaussianCut<double> unit_cut(1, 1, 1);

TEST_CASE("K, area and separation of numbers are those of boundary elements up to 0.95 H") {
    const test::Table table("plastic_closing.csv");
    std::map<int, decltype(gaussian(4, 0.8))> elastic;
    int within_15 = 0, within_25 = 0, areas = 0, crowded = 0, separations = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = [&](const char* column) { return table.input(row, column); };
        const auto of = elastic.try_emplace(int(at("seed")), gaussian(at("alpha"), at("hurst"))).first;
        const double H = at("hardness_over_Eg");
        const auto state = PlasticContact(of->second, unit_cut, H).at_pressure(at("p_over_H") * H);
        const double error = test::relative_error(state.stiffness.value, at("stiffness_sigma_over_Eg"));
        within_15 += error < 0.15, within_25 += error < 0.25;
        if (at("contacts") < 10 && at("p_over_H") < 0.4) continue;  // one surface is not another
        ++crowded;
        areas += test::relative_error(state.real_area_fraction.value, at("real_area")) < 0.2;
        separations += std::abs(state.separation.value - at("separation_over_sigma")) < 0.1;
    }
    const double all = double(table.size());
    CAPTURE(all, within_15, within_25, crowded, areas, separations);
    CHECK(within_15 > 0.94 * all);
    CHECK(within_25 > 0.98 * all);
    CHECK(areas > 0.9 * crowded);
    CHECK(separations > 0.9 * crowded);
}

TEST_CASE("A plastic contact is elastic for a great hardness, and the cut for a small one") {
    const auto elastic = gaussian(6, 0.8);
    for (const double p : {1e-6, 1e-3, 0.03, 0.3, 0.7}) {
        const auto hard = PlasticContact(elastic, unit_cut, 1e5).at_pressure(p), plain = elastic.at_pressure(p);
        CAPTURE(p);
        CHECK(test::relative_error(hard.stiffness.value, plain.stiffness.value) < 1e-4);
        CHECK(test::relative_error(hard.loading_stiffness.value, plain.stiffness.value) < 1e-4);
        CHECK(test::relative_error(hard.real_area_fraction.value, plain.real_area_fraction.value) < 1e-4);
        CHECK(std::abs(hard.separation.value - plain.separation.value) < 1e-4);
    }
    const double soft = 1e-7;
    for (const double share : {1e-4, 0.02, 0.3, 0.5, 0.7, 0.98}) {
        const auto state = PlasticContact(elastic, unit_cut, soft).at_pressure(share * soft);
        const double z = -math::normal_quantile(share);
        CAPTURE(share);
        CHECK(test::relative_error(state.stiffness.value, share / (1 - share) * std::hypot(0.55, 0.28 * (z - 0.65))) <
              1e-3);
        CHECK(test::relative_error(state.real_area_fraction.value, share) < 1e-3);
        CHECK(std::abs(state.separation.value - z) < 1e-3);
        CHECK(test::relative_error(state.loading_stiffness.value, soft * math::normal_density(z)) < 1e-3);
    }
    // in between: the law by hand
    const double H = 0.3, s = 0.2, K = elastic.stiffness(H * s), c = 0.8 / 0.2 * unit_cut.stiffness(s);
    const double flow = -std::log(1 - s), alone = std::log(1 + K / (1.5 * c)), n = 2.8 - 1.65 * s;
    const double both = std::pow(std::pow(flow, n) + std::pow(alone, n), 1 / n);
    const PlasticContact contact(elastic, unit_cut, H);
    CHECK(test::relative_error(contact.at_pressure(H * s).stiffness.value,
                               c * (std::exp(both) - 1) * std::pow(1.5, alone / both)) < 1e-12);
}

TEST_CASE("K and -dp/dd of plastic contacts rise with p, fall with H, and loading is never the stiffer") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 300; ++i) {
        const double alpha = 2.5 * std::pow(40, uniform(random)), hurst = 0.2 + 0.79 * uniform(random);
        const double H = 0.01 * std::pow(1000, uniform(random)), skewness = 3 * uniform(random) - 2;
        const BandSpectrum<double> band = detail::band_of_moments<double>({1, 0.5, alpha / 4}, hurst);
        const auto rises = [&](const auto& elastic) {
            const PlasticContact contact(elastic, unit_cut, H), harder(elastic, unit_cut, 1.01 * H);
            const auto K_of = [](const auto& one, double p) { return one.at_pressure(p).stiffness.value; };
            double K = 0, d = std::numeric_limits<double>::infinity();
            for (double logit = -12; logit < 4; logit += 1) {
                const double p = H / (1 + std::exp(-logit));
                const auto point = contact.point_at_pressure(p);
                if (!point.ok()) break;  // closed
                const double now = point.state.stiffness.value, other = K_of(harder, p);
                CAPTURE(alpha, hurst, H, skewness, p / H);
                CHECK(now > K);
                CHECK(point.state.separation.value < d);
                CHECK(point.state.loading_stiffness.value <= now);
                CHECK(other <= now * (1 + 1e-9));
                if (p < 0.6 * H && p < 0.6) {  // near H K goes as 1/(1 - p/H), and near closing hybrid rises as fast
                    CHECK(other > 0.96 * now);
                    CHECK(K_of(contact, 1.01 * p) < 1.04 * now);
                }
                K = now, d = point.state.separation.value;
            }
        };
        if (i % 3 == 0)
            rises(hybrid_of_band(band, detail::bearing_of_moments(skewness, 3.2 + 1.5 * skewness * skewness), 1.0));
        else
            rises(hybrid_of_band(band, 1.0));
    }
}

TEST_CASE("The separation of a plastic contact falls through 0, and its slope is the loading stiffness") {
    const auto elastic = gaussian(6, 0.8);
    for (const double H : {0.02, 0.3, 1.4}) {
        const PlasticContact contact(elastic, unit_cut, H);
        static_assert(Contact<decltype(contact), double>);
        static_assert(!detail::ProportionalContact<decltype(contact), double>);
        CHECK(std::abs(contact.at_pressure(H / 2).separation.value) < 1e-14);
        for (const double share : {1e-5, 0.01, 0.3, 0.52, 0.9}) {
            if (share * H > 0.75) continue;
            const double p = share * H, step = 1e-4 * p * (1 - share);
            const auto state = contact.at_pressure(p);
            CAPTURE(H, share);
            CHECK((state.separation.value < 0) == (share > 0.5));
            const double fall =
                contact.at_pressure(p - step).separation.value - contact.at_pressure(p + step).separation.value;
            CHECK(test::relative_error(state.loading_stiffness.value, 2 * step / fall) < 1e-6);
            const auto back = contact.at_separation(state.separation.value);
            CHECK(test::relative_error(back.pressure.value, p) < 1e-9);
            CHECK(test::relative_error(back.stiffness.value, state.stiffness.value) < 1e-8);
            CHECK(std::abs(contact.log_stiffness(state.eta).value - std::log(state.stiffness.value)) < 1e-8);
            CHECK(test::relative_error(contact.log_pressure(state.eta).slope, -state.loading_stiffness.value / p) <
                  1e-8);
        }
        CHECK_THROWS_AS(contact.at_pressure(H), domain_error);
        CHECK_THROWS_AS(contact.at_pressure(0), domain_error);
        CHECK(contact.point_at_pressure(2 * H).status == PointStatus::out_of_reach);
        CHECK(contact.point_at_separation(-40).status == PointStatus::out_of_reach);
    }
    CHECK_THROWS_AS(PlasticContact(elastic, unit_cut, 0.0), domain_error);
    CHECK_THROWS_AS(detail::GaussianCut<double>(1, -1, 1), domain_error);
}

}  // namespace plastic_contact_map_test
