// SPDX-License-Identifier: BSD-3-Clause
// Named materials: E and nu against those of density and sound speeds, which have another source; spellings.
#include <fstiff/asperity/named_materials.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <set>
#include <string>

namespace named_materials_test {

using fstiff::parts::find_material;
using fstiff::parts::named_materials;

TEST_CASE("The modulus of a named material is that of its density and speeds of sound") {
    for (const auto& one : named_materials) {
        INFO(one.name);
        const double shear = one.density * one.shear_velocity * one.shear_velocity,
                     ratio = one.longitudinal_velocity / one.shear_velocity,
                     nu = (ratio * ratio - 2) / (2 * (ratio * ratio - 1)), modulus = 2 * shear * (1 + nu);
        const double allowed = one.name == "cast_iron" ? 0.12 : one.name == "PMMA" ? 0.23 : 0.04;
        CHECK(test::relative_error(modulus, one.elastic.youngs_modulus) < allowed);
        CHECK(std::abs(nu - one.elastic.poisson_ratio) < 0.035);
    }
}

TEST_CASE("Every metal conducts heat and current by the law of Wiedemann and Franz and no glass conducts current") {
    for (const auto& one : named_materials) {
        INFO(one.name);
        if (one.electrical_conductivity == 0) {
            CHECK(one.thermal_conductivity < 2);
            continue;
        }
        // 2.44e-8 W Ohm/K^2 of the electrons; the lattice of alloys, and graphite, add their part
        const double lorenz = one.thermal_conductivity / (one.electrical_conductivity * 293);
        CHECK(lorenz > 2e-8);
        CHECK(lorenz < (one.name == "cast_iron" ? 13e-8 : 4e-8));
    }
}

TEST_CASE("A material is found in any spelling of its name, and once") {
    std::set<std::string_view> names;
    for (const auto& one : named_materials) {
        CHECK(names.insert(one.name).second);
        CHECK(find_material(one.name) == &one);
        CHECK(effective_modulus(one.elastic, one.elastic) > 1e9);
        CHECK_FALSE(one.source.empty());
    }
    CHECK(find_material("Cast iron") == find_material("cast_iron"));
    CHECK(find_material("STAINLESS-STEEL")->density == 7900);
    CHECK(find_material("aluminum")->name == "aluminium");
    CHECK(find_material("pmma")->name == "PMMA");
    for (const char* none : {"", "stee", "steels", "wood"}) CHECK(find_material(none) == nullptr);
    static_assert(find_material("steel")->elastic.youngs_modulus == 210e9);
}

}  // namespace named_materials_test
