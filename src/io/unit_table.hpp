// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The table of the units, and how a spelling is found in it.

#include "io/number.hpp"

#include <fstiff/io/units.hpp>

#include <array>
#include <numbers>

namespace fstiff::inline v0_1::io::detail {

struct Unit {
    Dimension dimension;
    std::string_view name;
    int exponent;         // of ten
    double factor = 1;    // in addition to the power of ten
    bool listed = false;  // in error messages
};

inline constexpr std::array units{
    Unit{Dimension::length, "m", 0, 1, true},
    Unit{Dimension::length, "km", 3, 1, true},
    Unit{Dimension::length, "cm", -2, 1, true},
    Unit{Dimension::length, "mm", -3, 1, true},
    Unit{Dimension::length, "um", -6, 1, true},
    Unit{Dimension::length, "nm", -9, 1, true},
    Unit{Dimension::length, "angstrom", -10, 1, true},
    Unit{Dimension::length, "pm", -12, 1, true},
    Unit{Dimension::length, "in", -4, 254, true},
    Unit{Dimension::length, "inch", -4, 254, false},
    Unit{Dimension::length, "inches", -4, 254, false},
    Unit{Dimension::length, "mil", -7, 254, true},
    Unit{Dimension::length, "mils", -7, 254, false},
    Unit{Dimension::length, "thou", -7, 254, false},
    Unit{Dimension::length, "uin", -10, 254, true},
    Unit{Dimension::length, "uinch", -10, 254, false},
    Unit{Dimension::length, "microinch", -10, 254, false},
    Unit{Dimension::length, "microinches", -10, 254, false},
    Unit{Dimension::length, "\xC3\x85", -10, 1, false},      // angstrom as a letter
    Unit{Dimension::length, "\xE2\x84\xAB", -10, 1, false},  // and as a sign
    Unit{Dimension::length, "A\xCC\x8A", -10, 1, false},     // and as two characters
    Unit{Dimension::length, "\xC5", -10, 1, false},          // and in CP1252
    Unit{Dimension::length, "A", -10, 1, false},
    Unit{Dimension::length, "k\xC3\x85", -7, 1, false},
    Unit{Dimension::length, "k\xE2\x84\xAB", -7, 1, false},
    Unit{Dimension::length, "k\xC5", -7, 1, false},
    Unit{Dimension::length, "\xC3\xA5ngstr\xC3\xB6m", -10, 1, false},
    Unit{Dimension::length, "\xC3\x85ngstr\xC3\xB6m", -10, 1, false},
    Unit{Dimension::length, "meter", 0, 1, false},
    Unit{Dimension::length, "metre", 0, 1, false},
    Unit{Dimension::length, "millimeter", -3, 1, false},
    Unit{Dimension::length, "millimetre", -3, 1, false},
    Unit{Dimension::length, "micrometer", -6, 1, false},
    Unit{Dimension::length, "micrometre", -6, 1, false},
    Unit{Dimension::length, "micron", -6, 1, false},
    Unit{Dimension::length, "mikrometer", -6, 1, false},  // German
    Unit{Dimension::length, "microm\xC3\xA8tre", -6, 1, false},
    Unit{Dimension::length, "micr\xC3\xB3metro", -6, 1, false},
    Unit{Dimension::length, "nanometer", -9, 1, false},
    Unit{Dimension::length, "nanometre", -9, 1, false},
    Unit{Dimension::length, "UM", -6, 1, false},  // as instruments write them
    Unit{Dimension::length, "NM", -9, 1, false},
    Unit{Dimension::length, "MM", -3, 1, false},
    Unit{Dimension::length, "CM", -2, 1, false},
    Unit{Dimension::length, "mikron", -6, 1, false},
    Unit{Dimension::length, "micrometro", -6, 1, false},
    Unit{Dimension::length, "micrometri", -6, 1, false},
    Unit{Dimension::length, "nanometro", -9, 1, false},
    Unit{Dimension::length, "nanometri", -9, 1, false},
    Unit{Dimension::length, "millimetri", -3, 1, false},
    Unit{Dimension::length, "\xD0\xBC\xD0\xBA\xD0\xBC", -6, 1, false},  // Russian, in UTF-8 and CP1251
    Unit{Dimension::length, "\xD0\xBD\xD0\xBC", -9, 1, false},
    Unit{Dimension::length, "\xD0\xBC\xD0\xBC", -3, 1, false},
    Unit{Dimension::length, "\xEC\xEA\xEC", -6, 1, false},
    Unit{Dimension::length, "\xED\xEC", -9, 1, false},
    Unit{Dimension::length, "\xEC\xEC", -3, 1, false},
    Unit{Dimension::length, "\xE5\xBE\xAE\xE7\xB1\xB3", -6, 1, false},  // Chinese
    Unit{Dimension::length, "\xE7\xBA\xB3\xE7\xB1\xB3", -9, 1, false},
    Unit{Dimension::length, "\xE6\xAF\xAB\xE7\xB1\xB3", -3, 1, false},
    Unit{Dimension::length, "\xE3\x8E\x9B", -6, 1, false},  // one character of Chinese, Japanese and Korean
    Unit{Dimension::length, "\xE3\x8E\x9A", -9, 1, false},
    Unit{Dimension::length, "\xE3\x8E\x9C", -3, 1, false},
    Unit{Dimension::area, "m^2", 0, 1, true},
    Unit{Dimension::area, "cm^2", -4, 1, true},
    Unit{Dimension::area, "mm^2", -6, 1, true},
    Unit{Dimension::area, "um^2", -12, 1, true},
    Unit{Dimension::area, "nm^2", -18, 1, true},
    Unit{Dimension::inverse_area, "/m^2", 0, 1, true},
    Unit{Dimension::inverse_area, "/cm^2", 4, 1, true},
    Unit{Dimension::inverse_area, "/mm^2", 6, 1, true},
    Unit{Dimension::inverse_area, "/um^2", 12, 1, true},
    Unit{Dimension::inverse_area, "/nm^2", 18, 1, false},
    Unit{Dimension::inverse_area, "m^-2", 0, 1, false},
    Unit{Dimension::inverse_area, "cm^-2", 4, 1, false},
    Unit{Dimension::inverse_area, "mm^-2", 6, 1, false},
    Unit{Dimension::inverse_area, "um^-2", 12, 1, false},
    Unit{Dimension::inverse_area, "nm^-2", 18, 1, false},
    Unit{Dimension::pressure, "Pa", 0, 1, true},
    Unit{Dimension::pressure, "kPa", 3, 1, true},
    Unit{Dimension::pressure, "MPa", 6, 1, true},
    Unit{Dimension::pressure, "GPa", 9, 1, true},
    Unit{Dimension::pressure, "TPa", 12, 1, false},
    Unit{Dimension::pressure, "bar", 5, 1, true},
    Unit{Dimension::pressure, "N/m^2", 0, 1, false},
    Unit{Dimension::pressure, "N/mm^2", 6, 1, true},
    Unit{Dimension::pressure, "kN/mm^2", 9, 1, false},
    Unit{Dimension::pressure, "kgf/mm^2", 1, 980665, false},
    Unit{Dimension::pressure, "psi", 0, 6894.757293168361, true},
    Unit{Dimension::angle, "rad", 0, 1, true},
    Unit{Dimension::angle, "deg", 0, std::numbers::pi / 180, true},
    Unit{Dimension::angle, "\xC2\xB0", 0, std::numbers::pi / 180, false},  // degree sign
    Unit{Dimension::angle, "degree", 0, std::numbers::pi / 180, false},
    Unit{Dimension::angle, "radian", 0, 1, false},
    Unit{Dimension::frequency, "Hz", 0, 1, true},
    Unit{Dimension::frequency, "kHz", 3, 1, true},
    Unit{Dimension::frequency, "MHz", 6, 1, true},
    Unit{Dimension::frequency, "GHz", 9, 1, true},
    Unit{Dimension::velocity, "m/s", 0, 1, true},
    Unit{Dimension::velocity, "km/s", 3, 1, true},
    Unit{Dimension::velocity, "mm/s", -3, 1, false},
    Unit{Dimension::velocity, "mm/us", 3, 1, true},
    Unit{Dimension::density, "kg/m^3", 0, 1, true},
    Unit{Dimension::density, "g/cm^3", 3, 1, true},
    Unit{Dimension::density, "kg/dm^3", 3, 1, false},
    Unit{Dimension::density, "kg/l", 3, 1, false},
    Unit{Dimension::impedance, "kg/(m^2 s)", 0, 1, true},
    Unit{Dimension::impedance, "kg/m^2/s", 0, 1, false},
    Unit{Dimension::impedance, "kg m^-2 s^-1", 0, 1, false},
    Unit{Dimension::impedance, "Pa s/m", 0, 1, false},
    Unit{Dimension::impedance, "N s/m^3", 0, 1, false},
    Unit{Dimension::impedance, "Rayl", 0, 1, true},
    Unit{Dimension::impedance, "kRayl", 3, 1, false},
    Unit{Dimension::impedance, "MRayl", 6, 1, true},
    Unit{Dimension::stiffness_per_area, "Pa/m", 0, 1, true},
    Unit{Dimension::stiffness_per_area, "N/m^3", 0, 1, true},
    Unit{Dimension::stiffness_per_area, "N/mm^3", 9, 1, true},
    Unit{Dimension::stiffness_per_area, "MPa/mm", 9, 1, false},
    Unit{Dimension::stiffness_per_area, "GPa/mm", 12, 1, false},
    Unit{Dimension::stiffness_per_area, "MPa/um", 12, 1, true},
    Unit{Dimension::stiffness_per_area, "GPa/um", 15, 1, true},
    Unit{Dimension::stiffness_per_area, "GPa/nm", 18, 1, false},
    Unit{Dimension::stiffness_per_area, "GPa/m", 9, 1, false},
    Unit{Dimension::stiffness_per_area, "MPa/m", 6, 1, false},
    Unit{Dimension::force, "N", 0, 1, true},
    Unit{Dimension::force, "kN", 3, 1, true},
    Unit{Dimension::force, "MN", 6, 1, true},
    Unit{Dimension::force, "mN", -3, 1, true},
    Unit{Dimension::force, "uN", -6, 1, true},
    Unit{Dimension::force, "lbf", 0, 4.4482216152605, true},
    Unit{Dimension::thermal_conductivity, "W/(m K)", 0, 1, true},
    Unit{Dimension::thermal_conductivity, "mW/(m K)", -3, 1, true},
    Unit{Dimension::thermal_conductivity, "W/m/K", 0, 1, false},
    Unit{Dimension::thermal_conductivity, "W m^-1 K^-1", 0, 1, false},
    Unit{Dimension::electrical_conductivity, "S/m", 0, 1, true},
    Unit{Dimension::electrical_conductivity, "kS/m", 3, 1, false},
    Unit{Dimension::electrical_conductivity, "MS/m", 6, 1, true},
    Unit{Dimension::electrical_conductivity, "S/cm", 2, 1, true},
    Unit{Dimension::thermal_film, "m^2 K/W", 0, 1, true},
    Unit{Dimension::thermal_film, "mm^2 K/W", -6, 1, true},
    Unit{Dimension::thermal_film, "cm^2 K/W", -4, 1, false},
    Unit{Dimension::electrical_film, "ohm m^2", 0, 1, true},
    Unit{Dimension::electrical_film, "ohm mm^2", -6, 1, true},
    Unit{Dimension::electrical_film, "ohm um^2", -12, 1, true},
    Unit{Dimension::temperature, "K", 0, 1, true},
};

/// \p text without the blanks at its ends, those of Unicode too: no-break, thin and their like.
constexpr std::string_view without_blanks(std::string_view text) {
    const auto blank_at = [&](std::size_t i) -> std::size_t {  // its length; 0 for no blank
        const std::string_view rest = text.substr(i);
        if (!rest.empty() && (is_blank(rest[0]) || rest[0] == '\xA0')) return 1;  // the second of an 8-bit code page
        if (rest.starts_with("\xC2\xA0")) return 2;
        const auto last = static_cast<unsigned char>(rest.size() > 2 ? rest[2] : '\0');
        if (rest.starts_with("\xE2\x80") && ((last >= 0x80 && last <= 0x8A) || last == 0xAF)) return 3;
        return rest.starts_with("\xE2\x81\x9F") || rest.starts_with("\xE3\x80\x80") ? 3 : 0;
    };
    while (const std::size_t length = blank_at(0)) text.remove_prefix(length);
    const auto last_blank = [&]() -> std::size_t {
        for (std::size_t length = 3; length > 0; --length)
            if (length <= text.size() && blank_at(text.size() - length) == length) return length;
        return 0;
    };
    while (const std::size_t length = last_blank()) text.remove_suffix(length);
    return text;
}

/// A multiple of a unit of length as titles state it, "x10 nm", "10^-6 m" or "0.1 um": the power of ten, greater or
/// smaller than 1, and the unit; 0 and none for another text.
struct Multiple {
    double factor{};
    const Unit* unit{};
};
Multiple multiple_of_length(std::string_view text);

/// nullptr when there is none.
const Unit* find_unit(std::string_view text, Dimension dimension);

/// Whether \p text is a unit of something else than a length, as deg, mV, urad or nm/V is.
bool measures_no_length(std::string_view text);

const Unit& require_unit(std::string_view text, Dimension dimension);

}  // namespace fstiff::inline v0_1::io::detail
