// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Materials by name: typical constants for a contact, a wave, heat and current at 20 degrees Celsius.
///
///     find_material("cast iron")->elastic                           {110e9, 0.26}
///     find_material("Ti6Al4V")->hardness()                          {3.4e9, 4.6e9, 8.4e9}: 5, 50 and 95 % of it
///     near_materials("steel C45")                                   {"steel", "C45"}
///
/// The hardness of a family is that of its soft and hard states together. Machining hardens the skin: its factor, read
/// as 1.13 to 2 of peened, blasted and straightened metal, is 1.25 at the middle and 2 at the upper end, of hardened
/// steel 1.1 and 1.3, of glass, ceramics and polymers 1.05 and 1.3 (judgement); the lower end is the bulk.
///
/// Reference   at the table, whose letters name the sources
/// Units       moduli and hardness [Pa], density [kg/m^3], velocities [m/s], conductivities [W/(m K)] and [S/m]
/// Valid       the material that the source names; conductivities from [C] are those of pure metals, alloys have less
/// Accuracy    moduli some 5 %, cast iron 103 to 118 GPa; by density and velocities (tests/asperity)

#include <fstiff/asperity/hardness.hpp>
#include <fstiff/asperity/material.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Units of hardness, as mean pressures [Pa]; HB is that of steel, HBA that of aluminium and magnesium.
inline constexpr double HV = vickers_pressure, HB = 1.05 * HV, HBA = 1.14 * HV, GPa = 1e9;

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// A row of the table.
///
/// Sources: [K] Kaye and Laby, Tables of Physical and Chemical Constants, 16th ed. (1995), 2.2.2; [C] CRC Handbook of
/// Chemistry and Physics, 97th ed. (2016), sections 12 (conductivities of pure metals) and 14 (speeds of sound); [D]
/// these with densities, and nickel unmagnetized: inaparts.com; [S] Selfridge, IEEE Trans. Sonics Ultrason. 32 (1985)
/// 381; [B] Boston Piezo-Optics (2010); EN: European standards. Read at first hand: Olin Brass, [D], [C] for the speeds
/// of aluminium, brass, copper. Quoted by others: the rest of [C], [S], Plexiglas, the EN but 1993-1-4. Not seen: [B],
/// AISI 1020, the conductivities of cast iron, [K]; Dowling, Mechanical Behavior of Materials, table 5.2, has its E of
/// Al, Cu, brass, W.
/// Hardness: [f] 5, 50, 95 % over the states of a family, pooled from data sheets; [s] read in the data sheet of a
/// supplier, who quotes the standard; [m] MatWeb or the same, quoted; [d] of the tensile strength; [r] remembered.

struct NamedMaterial {
    std::string_view name;               ///< as scenes write it
    Material<double> elastic;            ///< E [Pa] and nu
    double density;                      ///< [kg/m^3]
    PriorRange bulk;                     ///< hardness: mean pressure of a contact, least, typical, greatest, in `unit`
    double unit;                         ///< [Pa]
    double longitudinal_velocity = 0;    ///< of bulk waves, as measured [m/s]; 0: not known
    double shear_velocity = 0;           ///< [m/s]
    double thermal_conductivity = 0;     ///< [W/(m K)]; 0: not known
    double electrical_conductivity = 0;  ///< [S/m]; 0: an insulator, or not known
    std::string_view source;             ///< of E and nu, of the velocities, of the conductivities, of the hardness
    std::string_view other_names = "";   ///< of the same material, each between blanks
    PriorRange thermal_range{};  ///< 5, 50 and 95 % of the conductivity over the alloys of a family; 0: one alloy

    /// Speeds of longitudinal and shear waves [m/s], by E, nu and density where none was measured; 0: not known, of
    /// polymers, whose E is another for waves.
    [[nodiscard]] std::pair<double, double> wave_speeds() const {
        const auto [modulus, nu] = elastic;
        if (longitudinal_velocity > 0 || !(modulus > 15e9)) return {longitudinal_velocity, shear_velocity};
        const double shear = std::sqrt(modulus / (2 * (1 + nu) * density));
        return {shear * std::sqrt((1 - nu) / (0.5 - nu)), shear};
    }
    /// 5, 50 and 95 % of the hardness of a machined face [Pa].
    [[nodiscard]] constexpr PriorRange hardness() const {
        const bool metal = elastic.youngs_modulus > 15e9 && elastic.poisson_ratio > 0.24 && bulk.middle * unit < 9e9;
        const auto is_hard = [&](double value) { return !metal || value * unit > 5e9; };
        const double middle = !metal ? 1.05 : is_hard(bulk.middle) ? 1.1 : 1.25;
        return {bulk.low * unit, bulk.middle * unit * middle, bulk.high * unit * (is_hard(bulk.high) ? 1.3 : 2)};
    }
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

// clang-format off
inline constexpr std::array<NamedMaterial, 44> named_materials{
    {{"steel", {210e9, 0.3}, 7850, {1.15, 1.91, 6.76}, 1.0785 * GPa, 5960, 3235, 45, 5.31e6,
      "EN 1993-1-1:2005, 3.2.6; [C] mild steel; [f] alloyed to unalloyed, and by it the current of AISI 1020; [f] annealed to hardened", "", {25, 45, 60}},
     {"stainless_steel", {200e9, 0.3}, 7900, {1.47, 1.93, 3.8}, 1.0785 * GPa, 5790, 3100, 15, 1.37e6,
      "EN 10088-1:2014, 1.4301, nu of EN 1993-1-4:2006; [C] steel 347; EN 10088-1:2014, 0.73 uOhm m; [f]"},
     {"cast_iron", {110e9, 0.26}, 7200, {1.45, 2.05, 2.81}, 1.0785 * GPa, 4600, 2600, 48.5, 1.37e6,
      "EN 1561:2011, annex A, EN-GJL-250; [S]; EN 1561:2011, 0.73 uOhm m; [f]", " iron "},
     {"aluminium", {70.3e9, 0.345}, 2700, {0.233, 1.06, 1.73}, 1.0785 * GPa, 6420, 3040, 165, 26.2e6,
      "[K]; [C] rolled; [f] cast alloys to pure, and by it the current of [C]; [f] pure to 7075-T6", " aluminum ", {115, 165, 237}},
     {"titanium", {115.7e9, 0.321}, 4500, {1.16, 3.11, 4.1}, 1.0785 * GPa, 6070, 3125, 21.9, 2.38e6,
      "[K]; [C]; [C], 0.42 uOhm m; [f] pure to grade 5"},
     {"copper", {129.8e9, 0.343}, 8930, {40, 66, 110}, HV, 5010, 2270, 385, 57.2e6,
      "[K]; [C] rolled; [f] deoxidised to pure, and by it the current of [C]; [s] annealed to hard", "", {300, 385, 401}},
     {"brass", {100.6e9, 0.35}, 8530, {55, 110, 165}, HV, 4700, 2110, 120, 16.1e6,
      "[K] 70 % Cu, 30 % Zn; [C] the same; [f] about C26000 of Olin Brass, and its density; [s] and [r] soft to hard", "", {100, 120, 150}},
     {"nickel", {199.5e9, 0.312}, 8850, {0.638, 0.9, 1.6}, GPa, 5480, 2990, 90.7, 14.4e6,
      "[K] unmagnetized; [D] unmagnetized; [C]; Vickers to Brinell, of tables of elements"},
     {"tungsten", {411e9, 0.28}, 19300, {2.83, 3.7, 4.87}, GPa, 5220, 2890, 174, 18.9e6, "[K]; [C] annealed; [C]; [f]"},
     {"glass", {70e9, 0.2}, 2500, {470, 550, 600}, HV, 5710, 3430, 1, 0,
      "EN 572-1:2012, soda lime (float); [B] plate; EN 572-1:2012; [s]", " soda_lime_glass "},
     {"fused_silica", {73.1e9, 0.17}, 2200, {7.3, 8.7, 9.5}, GPa, 5968, 3764, 1.38, 0,
      "[K]; [C]; [C]; nanoindentation, deep to shallow", " quartz_glass "},
     {"PMMA", {3.3e9, 0.37}, 1190, {0.16, 0.185, 0.22}, GPa, 2680, 1100, 0.19, 0,
      "Roehm, data sheet 211-1 of Plexiglas GS (2007); [C] Lucite; as E; [r] ball indentation", " acrylic plexiglas "},
     {.name = "S235", .elastic = {210e9, 0.3}, .density = 7850, .bulk = {104, 125, 154}, .unit = HB, .source = "[s]", .other_names = " St37 S235JR "},
     {.name = "S355", .elastic = {210e9, 0.3}, .density = 7850, .bulk = {143, 165, 193}, .unit = HB, .source = "[d]", .other_names = " St52 S355J2 "},
     {.name = "C45", .elastic = {205e9, 0.3}, .density = 7850, .bulk = {170, 205, 240}, .unit = HB, .source = "[s] normalized", .other_names = " 1045 AISI_1045 1.0503 Ck45 "},
     {.name = "42CrMo4", .elastic = {205e9, 0.3}, .density = 7840, .bulk = {225, 300, 380}, .unit = HB, .source = "[s] quenched and tempered", .other_names = " 4140 AISI_4140 1.7225 "},
     {.name = "34CrNiMo6", .elastic = {207e9, 0.29}, .density = 7850, .bulk = {320, 362, 412}, .unit = HV, .source = "[m] quenched and tempered, HRC 35 to 45", .other_names = " 4340 AISI_4340 "},
     {.name = "16MnCr5", .elastic = {210e9, 0.3}, .density = 7850, .bulk = {653, 720, 772}, .unit = HV, .source = "[s] case hardened, HRC 58 to 63"},
     {.name = "100Cr6", .elastic = {210e9, 0.3}, .density = 7810, .bulk = {653, 746, 832}, .unit = HV, .source = "[s] hardened, HRC 58 to 65", .other_names = " 52100 AISI_52100 1.3505 bearing_steel "},
     {.name = "tool_steel", .elastic = {208e9, 0.285}, .density = 7750, .bulk = {595, 660, 746}, .unit = HV, .source = "[m] D2, O1, A2 hardened", .other_names = " D2 1.2379 O1 "},
     {.name = "304", .elastic = {193e9, 0.3}, .density = 8000, .bulk = {150, 175, 215}, .unit = HB, .source = "[s] annealed", .other_names = " AISI_304 SS304 1.4301 X5CrNi18-10 "},
     {.name = "316L", .elastic = {193e9, 0.3}, .density = 8000, .bulk = {150, 175, 215}, .unit = HB, .source = "[s] annealed", .other_names = " 316 AISI_316L AISI_316 SS316 1.4404 1.4401 "},
     {.name = "17-4PH", .elastic = {196e9, 0.28}, .density = 7800, .bulk = {286, 370, 434}, .unit = HV, .source = "[s] condition A to H900, E and nu [r]", .other_names = " 1.4542 "},
     {.name = "GJL-250", .elastic = {110e9, 0.26}, .density = 7200, .bulk = {170, 205, 240}, .unit = HB, .source = "[s]", .other_names = " EN-GJL-250 GG25 grey_cast_iron gray_cast_iron "},
     {.name = "GJS-400", .elastic = {169e9, 0.275}, .density = 7100, .bulk = {135, 158, 180}, .unit = HB, .source = "[s] 400-15, nu [r]", .other_names = " EN-GJS-400-15 GJS-400-15 GGG40 ductile_iron nodular_cast_iron "},
     {.name = "GJS-700", .elastic = {176e9, 0.275}, .density = 7200, .bulk = {225, 265, 305}, .unit = HB, .source = "[s] 700-2, nu [r]", .other_names = " EN-GJS-700-2 GJS-700-2 GGG70 "},
     {.name = "6061", .elastic = {68.9e9, 0.33}, .density = 2700, .bulk = {85, 95, 100}, .unit = HBA, .source = "[m] T6", .other_names = " 6061-T6 AA6061 Al6061 EN_AW-6061 "},
     {.name = "6082", .elastic = {70e9, 0.33}, .density = 2700, .bulk = {85, 95, 105}, .unit = HBA, .source = "[s] T6", .other_names = " 6082-T6 AA6082 EN_AW-6082 "},
     {.name = "7075", .elastic = {70e9, 0.33}, .density = 2810, .bulk = {135, 150, 160}, .unit = HBA, .source = "[m] T6", .other_names = " 7075-T6 AA7075 Al7075 EN_AW-7075 "},
     {.name = "2024", .elastic = {73e9, 0.33}, .density = 2780, .bulk = {110, 120, 130}, .unit = HBA, .source = "[m] T3", .other_names = " 2024-T3 AA2024 Al2024 EN_AW-2024 "},
     {.name = "AlSi10Mg", .elastic = {72e9, 0.33}, .density = 2650, .bulk = {50, 80, 115}, .unit = HBA, .source = "[s] cast, as cast to T6"},
     {.name = "Ti-6Al-4V", .elastic = {114e9, 0.33}, .density = 4430, .bulk = {320, 350, 396}, .unit = HV, .source = "[m], HV10 measured", .other_names = " titanium_grade_5 TC4 TiAl6V4 3.7165 "},
     {.name = "Cu-ETP", .elastic = {117e9, 0.343}, .density = 8920, .bulk = {40, 66, 110}, .unit = HV, .source = "[s] annealed to hard", .other_names = " CW004A electrolytic_copper "},
     {.name = "CuZn39Pb3", .elastic = {97e9, 0.35}, .density = 8470, .bulk = {90, 125, 160}, .unit = HV, .source = "[s]", .other_names = " CW614N "},
     {.name = "bronze", .elastic = {115e9, 0.34}, .density = 8800, .bulk = {75, 150, 235}, .unit = HV, .source = "[s] CuSn5 to CuSn8, soft to hard, E [r]", .other_names = " CuSn8 CuSn6 phosphor_bronze "},
     {.name = "Inconel_718", .elastic = {200e9, 0.29}, .density = 8190, .bulk = {354, 411, 457}, .unit = HV, .source = "[s] aged, HRC 36 to 46", .other_names = " IN718 2.4668 "},
     {.name = "AZ31B", .elastic = {45e9, 0.35}, .density = 1770, .bulk = {49, 56, 73}, .unit = HBA, .source = "[s]", .other_names = " AZ31 magnesium "},
     {.name = "PEEK", .elastic = {3.8e9, 0.4}, .density = 1310, .bulk = {0.2, 0.25, 0.29}, .unit = GPa, .source = "[r]"},
     {.name = "POM", .elastic = {2.86e9, 0.37}, .density = 1390, .bulk = {0.12, 0.14, 0.17}, .unit = GPa, .source = "[s] ball indentation", .other_names = " acetal delrin "},
     {.name = "PA66", .elastic = {2.0e9, 0.39}, .density = 1140, .bulk = {0.05, 0.1, 0.16}, .unit = GPa, .source = "[s] ball indentation, conditioned to dry", .other_names = " nylon polyamide "},
     {.name = "alumina", .elastic = {360e9, 0.23}, .density = 3800, .bulk = {12, 16, 19.6}, .unit = GPa, .source = "[s] 94 to 99.9 %", .other_names = " Al2O3 "},
     {.name = "silicon_nitride", .elastic = {307e9, 0.27}, .density = 3200, .bulk = {15, 15.5, 16}, .unit = GPa, .source = "[s]", .other_names = " Si3N4 "},
     {.name = "cemented_carbide", .elastic = {600e9, 0.22}, .density = 14800, .bulk = {12, 14.5, 18}, .unit = GPa, .source = "[r]", .other_names = " tungsten_carbide WC-Co hard_metal "},
     {.name = "silicon", .elastic = {160e9, 0.22}, .density = 2330, .bulk = {9, 10.5, 13}, .unit = GPa, .source = "[s] single crystal"}}};
// clang-format on

/// Whether \p test holds for the name of \p material or for another of its names.
template <class Test>
[[nodiscard]] constexpr bool any_name(const NamedMaterial& material, const Test& test) {
    if (test(material.name)) return true;
    for (std::string_view rest = material.other_names; rest.size() > 1;) {
        rest.remove_prefix(1);
        const std::size_t end = rest.find(' ');
        if (test(rest.substr(0, end))) return true;
        rest.remove_prefix(end);
    }
    return false;
}

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// The row of \p name, or nullptr.
[[nodiscard]] constexpr const NamedMaterial* find_material(std::string_view name) {
    for (const NamedMaterial& material : detail::named_materials)
        if (detail::any_name(material, [&](std::string_view other) { return detail::is_same_name(name, other); }))
            return &material;
    return nullptr;
}

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Beginning of names that the table does not have, or with $ a whole one, with # for one digit or more, and the row
/// that is nearest.
struct MaterialHint {
    std::string_view begin, name;
};

/// Numbers and short names of EN and AISI, and German words. A row comes before those that it begins with.
// clang-format off
inline constexpr auto material_hints = std::to_array<MaterialHint>({
    {"1.4", "stainless_steel"}, {"X#CrNi", "stainless_steel"}, {"X#Cr1", "stainless_steel"}, {"AISI_3", "stainless_steel"},
    {"SS3", "stainless_steel"}, {"Edelstahl", "stainless_steel"}, {"inox", "stainless_steel"}, {"V2A", "304"}, {"V4A", "316L"},
    {"1.2", "tool_steel"}, {"X#Cr", "tool_steel"}, {"Werkzeugstahl", "tool_steel"}, {"1.35", "100Cr6"}, {"W\xC3\xA4lzlagerstahl", "100Cr6"},
    {"1.", "steel"}, {"Stahl", "steel"}, {"Baustahl", "S235"}, {"St#", "steel"}, {"S#", "steel"}, {"C#", "steel"}, {"Ck#", "steel"},
    {"E#", "steel"}, {"#Cr", "steel"}, {"#Mn", "steel"}, {"#Ni", "steel"}, {"AISI", "steel"}, {"SAE", "steel"},
    {"GGG", "GJS-400"}, {"0.7", "GJS-400"}, {"5.3", "GJS-400"}, {"GG", "GJL-250"}, {"0.6", "GJL-250"}, {"5.1", "GJL-250"},
    {"Grauguss", "GJL-250"}, {"Guss", "cast_iron"}, {"Eisen", "cast_iron"},
    {"AlMgSi", "6082"}, {"AlSiMg", "6082"}, {"AlSi1Mg", "6082"}, {"3.2315", "6082"}, {"AlMg1Si", "6061"}, {"3.3211", "6061"}, {"AlZn", "7075"},
    {"3.4365", "7075"}, {"AlCu", "2024"}, {"3.1355", "2024"}, {"AlSi", "AlSi10Mg"}, {"Aluminiumoxid$", "alumina"}, {"Korund", "alumina"},
    {"sapphire", "alumina"}, {"Alu$", "aluminium"}, {"Al$", "aluminium"}, {"AlMg", "aluminium"}, {"AlMn", "aluminium"}, {"Al9", "aluminium"}, {"EN_AW", "aluminium"},
    {"AA#", "aluminium"}, {"3.5", "AZ31B"}, {"3.7", "titanium"}, {"3.", "aluminium"}, {"Titan", "titanium"}, {"Ti#", "titanium"}, {"TiAl", "Ti-6Al-4V"},
    {"MgAZ", "AZ31B"}, {"MgAl", "AZ31B"}, {"Mg", "AZ31B"}, {"AZ", "AZ31B"},
    {"CuZn", "brass"}, {"Ms#", "brass"}, {"Messing", "brass"}, {"2.03", "brass"}, {"2.04", "brass"}, {"CW5", "brass"}, {"CW6", "brass"},
    {"CuSn", "bronze"}, {"Rotguss", "bronze"}, {"2.10", "bronze"}, {"2.00", "copper"}, {"CW0", "copper"}, {"Kupfer", "copper"}, {"Cu", "copper"},
    {"2.46", "Inconel_718"}, {"2.4", "nickel"}, {"Wolfram", "tungsten"}, {"Hartmetall", "cemented_carbide"}, {"carbide", "cemented_carbide"},
    {"Siliziumnitrid", "silicon_nitride"}, {"Silizium", "silicon"}, {"Quarz", "fused_silica"}});
// clang-format on

/// Whether \p name begins with \p begin, whose # is one digit or more.
[[nodiscard]] constexpr bool begins_with_hint(std::string_view name, std::string_view begin) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    for (; !begin.empty(); begin.remove_prefix(1)) {
        while (!name.empty() && (name[0] == ' ' || name[0] == '-' || name[0] == '_')) name.remove_prefix(1);
        if (begin[0] == '_') continue;
        if (begin[0] == '$') return name.empty();
        if (name.empty() || (begin[0] == '#' ? !is_digit(name[0]) : lower(begin[0]) != lower(name[0]))) return false;
        name.remove_prefix(1);
        while (begin[0] == '#' && !name.empty() && is_digit(name[0])) name.remove_prefix(1);
    }
    return true;
}

/// Materials with a name that \p name or one of its words is, begins, or begins with; where these are none or several
/// the one of the hint, if \p name has one.
[[nodiscard]] inline std::vector<std::string_view> near_materials(std::string_view name) {
    std::vector<std::string_view> names;
    const auto hint = std::find_if(material_hints.begin(), material_hints.end(),
                                   [&](const MaterialHint& row) { return begins_with_hint(name, row.begin); });
    const bool has_hint = hint != material_hints.end();
    if (has_hint && hint->begin.back() == '$') return {hint->name};
    const auto consider = [&](std::string_view word) {
        const auto is_near = [&](std::string_view other) {
            const std::size_t least = (std::min)(word.size(), other.size());
            return least > 2 && is_same_name(word.substr(0, least), other.substr(0, least));
        };
        for (const NamedMaterial& material : named_materials)
            if (any_name(material, is_near) && std::find(names.begin(), names.end(), material.name) == names.end())
                names.push_back(material.name);
    };
    consider(name);
    while (!name.empty()) {
        const std::size_t end = (std::min)(name.find_first_of(" -_/"), name.size() - 1);
        consider(name.substr(0, end + (end + 1 == name.size() ? 1 : 0)));
        name.remove_prefix(end + 1);
    }
    if (has_hint && names.size() != 1) return {hint->name};
    return names;
}

}}}  // namespace fstiff::detail
