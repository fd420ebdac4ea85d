// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/asperity/conductance.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/named_materials.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace conductance_test {

TEST_CASE("One circular spot conducts 2 k a, as two bodies in series of 4 k a each") {
    for (const auto& [k1, k2] : {std::pair{50.0, 50.0}, {50.0, 0.2}, {400.0, 1e-9}, {1e300, 1e-300}}) {
        const double a = 3e-6, E = 112e9, K = 2 * E * a;
        const double series = 1 / (1 / (4 * k1 * a) + 1 / (4 * k2 * a));
        CHECK(test::relative_error(fstiff::spot_conductance(K, fstiff::joint_conductivity(k1, k2), E), series) < 1e-15);
    }
    CHECK(fstiff::joint_conductivity(0.0, 50.0) == 0);
    CHECK(fstiff::joint_conductivity(0.0, 0.0) == 0);
    CHECK_THROWS_AS(fstiff::joint_conductivity(-1.0, 50.0), fstiff::domain_error);
    CHECK_THROWS_AS(fstiff::joint_conductivity(1.0, std::nan("")), fstiff::domain_error);
    CHECK_THROWS_AS(fstiff::spot_conductance(1.0, 1.0, 0.0), fstiff::domain_error);
    CHECK(test::refusal([] { (void)fstiff::spot_conductance(-1.0, 1.0, 1.0); }) ==
          "stiffness = -1: must be 0 or greater");
    CHECK(test::refusal([] { (void)fstiff::spot_conductance(1.0, -1.0, 1.0); }) ==
          "conductivity = -1: must be 0 or greater");
    CHECK(std::isnan(fstiff::spot_conductance(std::nan(""), 1.0, 1.0)));
}

TEST_CASE("A film lies between the spots and nothing, and the gap and radiation have their limits") {
    using namespace fstiff;
    using namespace fstiff::detail;
    CHECK(under_film(1e4, 0.01, 0.0) == 1e4);
    CHECK(test::relative_error(under_film(1e12, 0.01, 1e-6), 1e4) < 1e-6);  // the film alone, A_r/r
    CHECK(test::relative_error(1 / under_film(1e4, 0.02, 1e-6), 1e-4 + 1e-6 / 0.02) < 1e-15);
    CHECK(under_film(0.0, 0.0, 1e-6) == 0);
    const GapFilling<double> grease{.conductivity = 0.8};
    CHECK(test::relative_error(gap_conductance(grease, 2e-6), 4e5) < 1e-15);
    CHECK(gap_conductance(grease, -1e-6) == 0);
    // air at one atmosphere between metals: a temperature jump of some tenths of a micrometre (Yovanovich 2005: 0.37
    // um)
    const double jump = temperature_jump(air<double>, 0.87);
    CHECK(jump > 0.25e-6);
    CHECK(jump < 0.45e-6);
    CHECK(temperature_jump(air<double>, 1.0) < jump);
    CHECK_THROWS_AS(temperature_jump(air<double>, 0.0), fstiff::domain_error);
    // black faces at 300 K: 4 s T^3 = 6.12 W/(m^2 K)
    CHECK(test::relative_error(radiative_conductance(300.0, 1.0), 6.1240) < 1e-5);
    CHECK(radiative_conductance(300.0, 0.1) < 0.06 * 6.124);
}

TEST_CASE("Media by name are those of other tables, and of kinetic theory") {
    // Conductivity at 300 K: Smirnov, Fundamentals of Ionized Gases (2011), table 4.6. Viscosity at 25 degrees and
    // molar mass: CRC Handbook, which make the mean free path of hard spheres, 16/5 mu/p sqrt(R T/(2 pi M)), and Pr =
    // c_p mu/k.
    const struct {
        const char* name;
        double at_300_K, viscosity, molar_mass;
    } rows[] = {{"helium", 0.151, 19.9e-6, 4.0026e-3},
                {"argon", 0.0177, 22.7e-6, 39.95e-3},
                {"nitrogen", 0.0259, 17.8e-6, 28.01e-3},
                {"hydrogen", 0.183, 8.9e-6, 2.016e-3},
                {"air", 0.0262, 18.5e-6, 28.96e-3}};
    const double R = 8.314, T = 293.15, p = 101325;
    for (const auto& row : rows) {
        const auto found = std::find_if(fstiff::detail::named_media.begin(), fstiff::detail::named_media.end(),
                                        [&](const auto& one) { return one.name == row.name; });
        REQUIRE(found != fstiff::detail::named_media.end());
        const auto& gas = found->gas;
        INFO(row.name);
        CHECK(test::relative_error(gas.conductivity, row.at_300_K) < 0.03);
        const double mu = row.viscosity * std::pow(T / 298.15, 0.7), ratio = gas.heat_capacity_ratio;
        const double path = 3.2 * mu / p * std::sqrt(R * T / (2 * std::numbers::pi * row.molar_mass));
        CHECK(test::relative_error(gas.mean_free_path, path) < 0.03);
        CHECK(test::relative_error(gas.prandtl, ratio / (ratio - 1) * R / row.molar_mass * mu / gas.conductivity) <
              0.03);
    }
    // Ramires and others, J. Phys. Chem. Ref. Data 24 (1995) 1377, of water at 1 bar
    const double t = T / 298.15, water = 0.6065 * (-1.48445 + 4.12292 * t - 1.63866 * t * t);
    const auto& media = fstiff::detail::named_media;
    const auto found = std::find_if(media.begin(), media.end(), [](const auto& one) { return one.name == "water"; });
    CHECK(test::relative_error(found->gas.conductivity, water) < 0.002);
}

}  // namespace conductance_test
