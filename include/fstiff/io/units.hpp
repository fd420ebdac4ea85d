// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The units that fstiff reads, in the spellings that scenes, command lines and measured files use.
///
///     unit_factor("GPa/um", Dimension::stiffness_per_area)          1e15
///
/// The micro sign may be "u", U+00B5, U+03BC, the CP1252 byte 0xB5 or the MS-DOS byte 0xE6; exponents may be written "^2", "2" or as
/// superscripts; blanks around a unit may be those of Unicode; products with a blank, "*" or a middle dot. Case matters ("MPa" is not "mPa"), except in spelt-out
/// words ("Micrometer").
///
/// Units       SI: m, m^2, 1/m^2, Pa, rad, Hz, m/s, kg/m^3, kg/(m^2 s), Pa/m
/// Accuracy    powers of ten are correctly rounded; in, psi, deg within 1 ulp (tests/io/quantity_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/io/number.hpp>

#include <array>

namespace fstiff::io {

/// The kinds of quantities that have units.
enum class Dimension {
    length,
    area,
    inverse_area,
    pressure,
    angle,
    frequency,
    velocity,
    density,
    impedance,
    stiffness_per_area
};

}  // namespace fstiff::io

namespace fstiff {

/// As messages call them.
template <>
inline constexpr auto names<io::Dimension> = name_list<io::Dimension>({
    {io::Dimension::length, "length"},
    {io::Dimension::area, "area"},
    {io::Dimension::inverse_area, "number per area"},
    {io::Dimension::pressure, "pressure"},
    {io::Dimension::angle, "angle"},
    {io::Dimension::frequency, "frequency"},
    {io::Dimension::velocity, "velocity"},
    {io::Dimension::density, "density"},
    {io::Dimension::impedance, "impedance"},
    {io::Dimension::stiffness_per_area, "stiffness per area"},
});

}  // namespace fstiff

namespace fstiff::io {

/// What one \p unit of \p dimension is in SI units.
/// \throws domain_error listing the accepted units.
[[nodiscard]] inline double unit_factor(std::string_view unit, Dimension dimension);

/// Whether \p unit is one of \p dimension.
[[nodiscard]] inline bool is_unit(std::string_view unit, Dimension dimension);

namespace detail {

struct Unit {
    Dimension dimension;
    std::string_view name;
    int exponent;         // of ten
    double factor = 1;    // besides the power of ten
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
};

inline std::string accepted_units(Dimension dimension) {
    std::string list;
    for (const Unit& unit : units)
        if (unit.dimension == dimension && unit.listed) {
            if (!list.empty()) list += ", ";
            list += unit.name;
        }
    return list;
}

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

/// One spelling for all: micro signs to "u", superscripts to digits, products to ".", no "^", no brackets, no "1/".
inline std::string canonical_unit(std::string_view unit) {
    struct Spelling {
        std::string_view from, to;
    };
    static constexpr std::array spellings{Spelling{"\xC2\xB5", "u"},
                                          Spelling{"\xCE\xBC", "u"},
                                          Spelling{"\xB5", "u"},
                                          Spelling{"\xE6", "u"},  // the micro sign of MS-DOS (CP437, CP850)
                                          Spelling{"\xC2\xB2", "2"},
                                          Spelling{"\xB2", "2"},
                                          Spelling{"\xC2\xB3", "3"},
                                          Spelling{"\xB3", "3"},
                                          Spelling{"\xE2\x81\xBB", "-"},
                                          Spelling{"\xC2\xB9", "1"},
                                          Spelling{"\xC2\xB7", "."},
                                          Spelling{"\xE2\x8B\x85", "."},
                                          Spelling{"*", "."},
                                          Spelling{" ", "."},
                                          Spelling{"\t", "."},
                                          Spelling{"^", ""},
                                          Spelling{"(", ""},
                                          Spelling{")", ""}};
    unit = without_blanks(unit);
    std::string spelt;
    while (!unit.empty()) {
        std::string_view next = unit.substr(0, 1);
        std::size_t taken = 1;
        for (const Spelling& s : spellings)
            if (unit.starts_with(s.from)) {
                next = s.to;
                taken = s.from.size();
                break;
            }
        const bool product = next == ".";
        if (product && (spelt.empty() || spelt.back() == '.' || spelt.back() == '/')) next = "";
        if (next == "/" && !spelt.empty() && spelt.back() == '.') spelt.pop_back();
        spelt += next;
        unit.remove_prefix(taken);
    }
    if (spelt.starts_with("1/")) spelt.erase(0, 1);
    return spelt;
}

/// nullptr when there is none.
inline const Unit* find_unit(std::string_view text, Dimension dimension) {
    const std::string wanted = canonical_unit(text);
    if (wanted.empty()) return nullptr;
    const std::string lower = wanted.size() > 3 ? lower_case(wanted) : std::string();
    std::string word = lower;
    if (word.size() > 4 && word.back() == 's') word.pop_back();  // plural
    for (const Unit& unit : units)
        if (unit.dimension == dimension) {
            const std::string name = canonical_unit(unit.name);
            if (name == wanted || (name.size() > 3 && name == lower_case(name) && (name == word || name == lower)))
                return &unit;
        }
    return nullptr;
}

inline const Unit& require_unit(std::string_view text, Dimension dimension) {
    if (const Unit* unit = find_unit(text, dimension)) return *unit;
    throw domain_error("unit \"" + std::string(text) + "\": is no unit of " + std::string(name_of(dimension)) +
                       "; allowed are " + accepted_units(dimension));
}

}  // namespace detail

inline double unit_factor(std::string_view unit, Dimension dimension) {
    const detail::Unit& found = detail::require_unit(unit, dimension);
    return detail::leading_number("1", found.exponent).value * found.factor;
}

inline bool is_unit(std::string_view unit, Dimension dimension) {
    return detail::find_unit(unit, dimension) != nullptr;
}

}  // namespace fstiff::io
