// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Materials by name: typical constants for a contact, a wave, heat and current at 20 degrees Celsius.
///
///     find_material("cast iron")->elastic                           {110e9, 0.26}
///
/// Hardness and yield strength are not included: cold work and heat treatment change them up to tenfold.
///
/// Reference   at the table, whose letters name the sources
/// Units       moduli [Pa], density [kg/m^3], velocities [m/s], thermal conductivity [W/(m K)], electrical one [S/m]
/// Valid       the material that the source names; conductivities from [C] are those of pure metals, alloys have less
/// Accuracy    moduli some 5 %, cast iron 103 to 118 GPa. The modulus from density and velocities differs by less than
///             4 %, for cast iron by 12 %, for PMMA, which is stiffer at MHz, by 22 %
///             (tests/asperity/named_materials_test.cpp)

#include <fstiff/asperity/material.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace fstiff::inline v0_1::parts {

/// A row of the table.
///
/// Sources: [K] Kaye and Laby, Tables of Physical and Chemical Constants, 16th ed. (1995), 2.2.2; [C] CRC Handbook of
/// Chemistry and Physics, 97th ed. (2016), sections 12 (conductivities of pure metals) and 14 (speeds of sound); [D]
/// these with densities, and nickel unmagnetized: inaparts.com; [S] Selfridge, IEEE Trans. Sonics Ultrason. 32 (1985)
/// 381; [B] Boston Piezo-Optics (2010); EN: European standards. Read at first hand: Olin Brass, [D], [C] for the speeds
/// of aluminium, brass, copper. Quoted by others: the rest of [C], [S], Plexiglas, the EN but 1993-1-4. Not seen: [B],
/// AISI 1020, the conductivities of cast iron, [K]; Dowling, Mechanical Behavior of Materials, table 5.2, has its E of
/// Al, Cu, brass, W.
// clang-format off
struct NamedMaterial {
    std::string_view name;             ///< as scenes write it, in small letters but for PMMA, blanks as "_"
    Material<double> elastic;          ///< E [Pa] and nu
    double density;                    ///< [kg/m^3]
    double longitudinal_velocity;      ///< of bulk waves [m/s]
    double shear_velocity;             ///< [m/s]
    double thermal_conductivity;       ///< [W/(m K)]
    double electrical_conductivity;    ///< [S/m]; 0: an insulator
    std::string_view source;           ///< of E and nu, of the velocities, of the conductivities; others as above
};

inline constexpr std::array<NamedMaterial, 12> named_materials{
    {{"steel", {210e9, 0.3}, 7850, 5960, 3235, 53.3, 6.29e6,
      "EN 1993-1-1:2005, 3.2.6; [C] mild steel; EN 1993-1-2:2005, 3.4.1.3; AISI 1020, 0.159 uOhm m"},
     {"stainless_steel", {200e9, 0.3}, 7900, 5790, 3100, 15, 1.37e6,
      "EN 10088-1:2014, 1.4301, nu of EN 1993-1-4:2006; [C] steel 347; EN 10088-1:2014, 0.73 uOhm m"},
     {"cast_iron", {110e9, 0.26}, 7200, 4600, 2600, 48.5, 1.37e6,
      "EN 1561:2011, annex A, EN-GJL-250; [S]; EN 1561:2011, 0.73 uOhm m"},
     {"aluminium", {70.3e9, 0.345}, 2700, 6420, 3040, 237, 37.7e6, "[K]; [C] rolled; [C]"},
     {"titanium", {115.7e9, 0.321}, 4500, 6070, 3125, 21.9, 2.38e6, "[K]; [C]; [C], 0.42 uOhm m"},
     {"copper", {129.8e9, 0.343}, 8930, 5010, 2270, 401, 59.6e6, "[K]; [C] rolled; [C]"},
     {"brass", {100.6e9, 0.35}, 8530, 4700, 2110, 121, 16.2e6,
      "[K] 70 % Cu, 30 % Zn; [C] the same; Olin Brass, data sheet of C26000, and its density"},
     {"nickel", {199.5e9, 0.312}, 8850, 5480, 2990, 90.7, 14.4e6, "[K] unmagnetized; [D] unmagnetized; [C]"},
     {"tungsten", {411e9, 0.28}, 19300, 5220, 2890, 174, 18.9e6, "[K]; [C] annealed; [C]"},
     {"glass", {70e9, 0.2}, 2500, 5710, 3430, 1, 0, "EN 572-1:2012, soda lime (float); [B] plate; EN 572-1:2012"},
     {"fused_silica", {73.1e9, 0.17}, 2200, 5968, 3764, 1.38, 0, "[K]; [C]; [C]"},
     {"PMMA", {3.3e9, 0.37}, 1190, 2680, 1100, 0.19, 0,
      "Roehm, data sheet 211-1 of Plexiglas GS (2007); [C] Lucite; as E"}}};
// clang-format on

/// The row of \p name, or nullptr. Case does not matter, and blanks and hyphens are as "_"; aluminum
/// is aluminium.
[[nodiscard]] constexpr const NamedMaterial* find_material(std::string_view name) {
    const auto plain = [](char c) {
        return c == ' ' || c == '-' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    const auto same = [&](std::string_view other) {
        return std::equal(name.begin(), name.end(), other.begin(), other.end(),
                          [&](char a, char b) { return plain(a) == plain(b); });
    };
    if (same("aluminum")) name = "aluminium";
    for (const NamedMaterial& one : named_materials)
        if (same(one.name)) return &one;
    return nullptr;
}

}  // namespace fstiff::inline v0_1::parts
