// SPDX-License-Identifier: BSD-3-Clause
// Truth: the Gaussian contact under a straight bearing curve; boundary elements of the skewed map of
// tests/data/bem_maps.csv.
#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/material_ratio_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <cmath>

namespace scaled_contact_test {

using namespace fstiff;

/// hybrid of the moments \p m under the bearing curve \p curve of the rms \p unit.
auto law_of(const SpectralMoments<double>& m, const MaterialRatioSlope<double>& curve, double unit) {
    const PerssonContact<double> persson(detail::band_of_moments(m, 0.8), 1.0);
    const double sigma = std::sqrt(m.m0), alpha = m.bandwidth();
    const Roughness<double> surface{sigma, detail::peak_radius_of(m), detail::peak_density_of(m)};
    HybridContact of(
        RoughContact(surface, PeakDistribution<double>(1 / std::sqrt(alpha), 1e-3), HertzLaw<double>{}, 1.0), persson);
    return ScaledContact(of, MaterialRatioContact<double>(persson, curve.scaled(sigma / unit), sigma));
}

TEST_CASE("A contact at the scale of a straight bearing curve is the Gaussian one") {
    const auto contact = law_of(detail::moments_of_gradient(1e-3, 0.1, 8.0), detail::bearing_of_moments(0.0, 3.0), 1);
    static_assert(detail::ProportionalContact<decltype(contact), double>);
    for (const double p : {1e-5, 1e-3, 1e-2}) {
        const auto state = contact.at_pressure(p), truth = contact.gaussian().at_pressure(p);
        CHECK(test::relative_error(state.stiffness.value, truth.stiffness.value) < 1e-9);
        CHECK(test::relative_error(state.real_area_fraction.value, truth.real_area_fraction.value) < 1e-9);
        CHECK(std::abs(state.separation.value - truth.separation.value) < 1e-4 * contact.rms_height());
        CHECK(test::relative_error(contact.at_separation(state.separation.value).pressure.value, p) < 1e-8);
    }
}

TEST_CASE("K of two levels, of the least kurtosis of a skewness, rises with the pressure") {
    // Truth: the scale is explicit in the pressure x of the Gaussian surface, so that p = x rho(x)
    const PerssonContact<double> persson(detail::band_of_moments(detail::moments_of_gradient(1.0, 1.0, 8.0), 0.8), 1.0);
    const detail::PerssonSeparation<double> separation(persson, 1.0, 9.0);
    for (const double skewness : {-3.0, -2.06, -1.5, -1.2, 0.0, 1.5, 3.0})
        for (const double more : {0.0, 0.01, 0.1}) {
            const auto curve = detail::bearing_of_moments(skewness, detail::least_kurtosis(skewness) + more);
            const MaterialRatioContact<double> contact(persson, curve, 1.0);
            double last = 0;
            for (double log_x = -7; log_x < 0; log_x += 0.1) {
                const double x = std::exp(log_x), P = persson.real_area_fraction(x);
                const double rho = curve.slope(separation(x) + 0.2 - 0.3 * P, std::sqrt(0.25 + P * P)), p = x * rho;
                CAPTURE(skewness, more, x, p);
                CHECK(test::relative_error(contact.local_scale(p), rho) < 1e-6);
                CHECK(contact.stiffness(p) > last);
                last = contact.stiffness(p);
            }
        }
}

TEST_CASE("Statistics of a skewed map are nearer to its boundary elements with its bearing curve") {
    const test::Table bem("bem_maps.csv");
    const HeightMap<double> map = test::half_space_map("skewed");
    const auto order = detail::gaussian_order(map);
    // moments of the Gaussian map of the same order
    SpectralMoments<double> m{};
    const detail::ShellGrid<double> grid(map, Edges::periodic);
    detail::visit_waves<double>(order.map.heights - order.map.heights.mean(), Edges::periodic,
                                [&](double k, double l, double power) {
                                    const double q = grid.wave_number(k, l);
                                    m.m0 += power, m.m2 += q * q * power / 2, m.m4 += 0.375 * q * q * q * q * power;
                                });
    const auto contact = law_of(m, order.curve, order.rms_height);
    double with = 0, without = 0;
    int points = 0;
    for (std::size_t row = 0; row < bem.size(); ++row) {
        if (bem.text(row, "map") != "skewed" || bem.input(row, "p_star") < 9e-4) continue;
        const double p = bem.input(row, "p_over_E"), truth = bem.input(row, "stiffness_times_L_over_E");
        with = std::max(with, std::abs(std::log(contact.stiffness(p) / truth)));
        without = std::max(without, std::abs(std::log(contact.gaussian().stiffness(p) / truth)));
        ++points;
    }
    CAPTURE(with, without);
    CHECK(points >= 5);
    CHECK(with < 0.25);
    CHECK(without > 1.5 * with);
}

}  // namespace scaled_contact_test
