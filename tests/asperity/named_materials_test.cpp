// SPDX-License-Identifier: BSD-3-Clause
// Named materials: E and nu against those of density and sound speeds, which have another source; spellings.
#include <fstiff/asperity/hardness.hpp>
#include <fstiff/asperity/named_materials.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace named_materials_test {

using fstiff::find_material;
using fstiff::detail::named_materials;

TEST_CASE("The modulus of a named material is that of its density and speeds of sound") {
    for (const auto& one : named_materials) {
        INFO(one.name);
        if (one.longitudinal_velocity == 0) continue;  // of an alloy, not known
        const double shear = one.density * one.shear_velocity * one.shear_velocity,
                     ratio = one.longitudinal_velocity / one.shear_velocity,
                     nu = (ratio * ratio - 2) / (2 * (ratio * ratio - 1)), modulus = 2 * shear * (1 + nu);
        const double allowed = one.name == "cast_iron" ? 0.12 : one.name == "PMMA" ? 0.23 : 0.04;
        CHECK(test::relative_error(modulus, one.elastic.youngs_modulus) < allowed);
        CHECK(std::abs(nu - one.elastic.poisson_ratio) < 0.035);
    }
}

TEST_CASE("Speeds by E, nu and density are those measured, where both are known") {
    for (auto one : named_materials) {
        INFO(one.name);
        const double fast = one.longitudinal_velocity, slow = one.shear_velocity;
        one.longitudinal_velocity = one.shear_velocity = 0;
        const auto [longitudinal, shear] = one.wave_speeds();
        if (one.elastic.youngs_modulus < 15e9) {
            CHECK(longitudinal == 0);
            CHECK(shear == 0);
            continue;
        }
        CHECK(longitudinal > 1.4 * shear);
        CHECK(shear > 2000);
        if (fast == 0) continue;
        // half of what E and nu are known to, by the test above
        const double nu = one.elastic.poisson_ratio, of_modulus = one.name == "cast_iron" ? 0.06 : 0.02, d = 0.035 / 2;
        CHECK(test::relative_error(longitudinal, fast) <
              of_modulus + d * (2 / (1 - 2 * nu) - 1 / (1 - nu) - 1 / (1 + nu)));
        CHECK(test::relative_error(shear, slow) < of_modulus + d / (1 + nu));
    }
}

TEST_CASE("Every metal conducts heat and current by the law of Wiedemann and Franz and no glass conducts current") {
    for (const auto& one : named_materials) {
        INFO(one.name);
        if (one.thermal_conductivity == 0) continue;  // of an alloy, not known
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
    for (const char* name : {"Ti6Al4V", "TI 6AL 4V", "TC4"}) CHECK(find_material(name) == find_material("Ti-6Al-4V"));
    CHECK(find_material("GG25") == find_material("EN-GJL-250"));
    CHECK(find_material("AISI 304") == find_material("1.4301"));
    static_assert(find_material("steel")->elastic.youngs_modulus == 210e9);
}

TEST_CASE("No name of a material is that of another") {
    for (const auto& one : named_materials)
        CHECK(fstiff::detail::any_name(one, [&](std::string_view name) {
                  INFO(name);
                  CHECK(find_material(name) == &one);
                  return false;
              }) == false);
}

TEST_CASE("An unknown name has the materials next to it") {
    using fstiff::detail::near_materials;
    const auto near = [](std::string_view name, std::string_view wanted) {
        const auto found = near_materials(name);
        return std::count(found.begin(), found.end(), wanted) == 1;
    };
    CHECK(near("aluminium 6061", "6061"));
    CHECK(near("steel C45", "C45"));
    CHECK(near("stainles", "stainless_steel"));
    CHECK(near("42CrMo", "42CrMo4"));
    CHECK(near("EN AW-7075 T651", "7075"));
    for (const char* none : {"", "-", "wood", "x", "rubber", "gold", "tin", "wax", "concrete"})
        CHECK(near_materials(none).empty());
    // a hint is one row, and only where no name is near or several are
    for (const auto& [name, row] :
         {std::pair("Alu", "aluminium"), std::pair("AlMgSi1", "6082"), std::pair("MgAZ31", "AZ31B"),
          std::pair("Stahl", "steel"), std::pair("1.4305", "stainless_steel"),
          std::pair("X8CrNiS18-9", "stainless_steel"), std::pair("AISI 303", "stainless_steel"),
          std::pair("S275JR", "steel"), std::pair("GGG50", "GJS-400"), std::pair("CuZn37", "brass"),
          std::pair("1.2842", "tool_steel")})
        CHECK(near_materials(name) == std::vector<std::string_view>{row});
    for (const auto& hint : fstiff::detail::material_hints) CHECK(find_material(hint.name) != nullptr);
}

TEST_CASE("The range of a hardness holds what handbooks give") {
    // HV of tables that the ranges were not made of: normalized C45 (DIN EN 10083-2, 185 to 255 HBW),
    // quenched 100Cr6 (ISO 683-17, 700 to 850 HV), Ti-6Al-4V annealed (ASM, 349 HV), C11000 H04 (CDA, 105 HV)
    const auto holds = [](const char* name, double vickers) {
        const auto range = find_material(name)->hardness();
        const double pressure = vickers * fstiff::detail::vickers_pressure;
        INFO(name << " " << vickers);
        CHECK((range.low <= pressure && pressure <= range.high));
    };
    holds("C45", 195), holds("C45", 265), holds("100Cr6", 700), holds("100Cr6", 850), holds("Ti-6Al-4V", 349);
    holds("Cu-ETP", 105), holds("steel", 150), holds("steel", 700), holds("aluminium", 30), holds("aluminium", 175);
    for (const auto& one : named_materials) {
        INFO(one.name);
        const auto [low, middle, high] = one.hardness();
        CHECK((0 < low && low < middle && middle < high));
        CHECK((low > 0.003 * one.elastic.youngs_modulus && high < 0.2 * one.elastic.youngs_modulus));
        const auto of_elastic = fstiff::detail::hardness_of_elastic(one.elastic);
        CHECK((of_elastic.low < middle && middle < of_elastic.high));  // E and nu alone know less
    }
}

}  // namespace named_materials_test
