// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The models against boundary elements: K at equal pressure over that of periodic elastic half-spaces with self-affine
// Gaussian surfaces (tests/data/bem.csv, bem_surfaces.csv; lengths in periods, pressures in E). Used by
// tests/docs/validation_test.cpp and by bench/validation.cpp.
#include "support/table.hpp"

#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// One law on one family of surfaces at one pressure.
struct HalfSpaceRatio {
    std::string law, family;
    double dimensionless_pressure{};  ///< p/(E g_rms)
    double ratio{};                   ///< K of the model over the mean K of the surfaces of the family
    double least{}, largest{};        ///< over each of its surfaces
};

inline std::vector<HalfSpaceRatio> half_space_ratios() {
    using namespace fstiff;
    const Table truth("bem.csv"), surfaces("bem_surfaces.csv");
    std::vector<HalfSpaceRatio> rows;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const std::string family = surfaces.text(i, "family");
        std::map<double, std::vector<double>> stiffness;  // of each surface, by pressure
        for (std::size_t j = 0; j < truth.size(); ++j)
            if (truth.text(j, "family") == family)
                stiffness[truth.input(j, "p_over_E")].push_back(truth.input(j, "stiffness_times_L_over_E"));
        const Roughness<double> surface{.rms_height = surfaces.input(i, "rms_height_over_L"),
                                        .peak_radius = 1 / surfaces.input(i, "mean_summit_curvature_times_L"),
                                        .peak_density = surfaces.input(i, "summit_density_8_times_L2")};
        const PeakDistribution<double> peaks(surfaces.input(i, "r"), surfaces.input(i, "theta"));
        const double dimension = 2 - surfaces.input(i, "hurst"), modulus = 1;
        const auto law = [&](const auto& asperity) {
            return [contact = RoughContact(surface, peaks, asperity, modulus)](double p) {
                return contact.at_pressure(p, Quantity::stiffness).stiffness.value;
            };
        };
        const GreenwoodWilliamson<double> one_radius(surface, modulus);
        const auto moments = detail::moments_of_gradient(surface.rms_height, surfaces.input(i, "rms_gradient"),
                                                         surfaces.input(i, "alpha"));
        const auto band = detail::band_of_moments(moments, surfaces.input(i, "hurst"));
        const PerssonContact<double> persson(band, modulus);
        const auto hybrid = hybrid_of_band(band, modulus);
        const std::pair<std::string, std::function<double(double)>> laws[] = {
            {"hybrid", [&](double p) { return hybrid.stiffness(p); }},
            {"persson", [&](double p) { return persson.stiffness(p); }},
            {"hertz", law(HertzLaw<double>{})},
            {"fractal", law(FractalLaw<double>(dimension))},
            {"fractal_consistent", law(FractalConsistentLaw<double>(dimension))},
            {"greenwood_williamson",
             [&](double p) { return one_radius.at_pressure(p, Quantity::stiffness).stiffness.value; }},
            {"linear", [&](double p) { return detail::linear_stiffness(p, surface.rms_height); }}};
        for (const auto& [name, model] : laws)
            for (const auto& [pressure, of_each] : stiffness) {
                double sum = 0;
                for (const double k : of_each) sum += k;
                const auto [low, high] = std::minmax_element(of_each.begin(), of_each.end());
                const double k = model(pressure);
                rows.push_back({name, family, pressure / (modulus * surfaces.input(i, "rms_gradient")),
                                k * static_cast<double>(of_each.size()) / sum, k / *high, k / *low});
            }
    }
    return rows;
}

}  // namespace test
