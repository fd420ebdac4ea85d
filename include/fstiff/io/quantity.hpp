// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers with a unit, as people write them in a scene, on a command line or in the header of a measured file.
///
///     parse_quantity("0.832 um", Dimension::length, "rms_height")   8.32e-7
///     parse_angle("pi/4", "theta")                                  0.785...
///     unit_factor("GPa/um", Dimension::stiffness_per_area)          1e15
///
/// The micro sign may be "u", U+00B5, U+03BC or the CP1252 byte 0xB5; exponents may be written "^2", "2" or as
/// superscripts; products with a blank, "*" or a middle dot. Case matters ("MPa" is not "mPa"), except in spelt-out
/// words ("Micrometer"). The decimal sign is the point in every locale.
///
/// Units       result in SI: m, m^2, 1/m^2, Pa, rad, Hz, m/s, kg/m^3, kg/(m^2 s), Pa/m
/// Valid       finite decimal numbers; "inf", "nan", hexadecimal and anything left over are refused
/// Accuracy    correctly rounded for every unit that is a power of ten of the SI unit; else (in, psi, deg) 2 ulp
///             (tests/io/quantity_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/core/text.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace fstiff::io {

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

/// A decimal number without a unit. \throws domain_error naming \p name when \p text is anything else.
[[nodiscard]] inline double parse_number(std::string_view text, std::string_view name);

/// A number and its unit, in SI units; angles as parse_angle reads them.
/// \throws domain_error naming \p name, the text and the accepted units; a bare number is refused.
[[nodiscard]] inline double parse_quantity(std::string_view text, Dimension dimension, std::string_view name);

/// An angle [rad]: "pi/4", "2*pi/7", "0.25 pi", "45 deg", "0.7 rad", or a bare number of radians.
/// \throws domain_error naming \p name and the accepted forms.
[[nodiscard]] inline double parse_angle(std::string_view text, std::string_view name);

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
    Unit{Dimension::length, "cm", -2, 1, false},
    Unit{Dimension::length, "mm", -3, 1, true},
    Unit{Dimension::length, "um", -6, 1, true},
    Unit{Dimension::length, "nm", -9, 1, true},
    Unit{Dimension::length, "pm", -12, 1, true},
    Unit{Dimension::length, "km", 3, 1, false},
    Unit{Dimension::length, "in", -4, 254, true},
    Unit{Dimension::length, "inch", -4, 254, false},
    Unit{Dimension::length, "\xC3\x85", -10, 1, false},      // angstrom as a letter
    Unit{Dimension::length, "\xE2\x84\xAB", -10, 1, false},  // and as a sign
    Unit{Dimension::length, "angstrom", -10, 1, false},
    Unit{Dimension::length, "meter", 0, 1, false},
    Unit{Dimension::length, "metre", 0, 1, false},
    Unit{Dimension::length, "millimeter", -3, 1, false},
    Unit{Dimension::length, "millimetre", -3, 1, false},
    Unit{Dimension::length, "micrometer", -6, 1, false},
    Unit{Dimension::length, "micrometre", -6, 1, false},
    Unit{Dimension::length, "micron", -6, 1, false},
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

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// ASCII only: the locale has no say.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

/// One spelling for all: micro signs to "u", superscripts to digits, products to ".", no "^", no brackets, no "1/".
inline std::string canonical_unit(std::string_view unit) {
    struct Spelling {
        std::string_view from, to;
    };
    static constexpr std::array spellings{Spelling{"\xC2\xB5", "u"},
                                          Spelling{"\xCE\xBC", "u"},
                                          Spelling{"\xB5", "u"},
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
    unit = trimmed(unit);
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
    std::string word = wanted.size() > 3 ? lower_case(wanted) : std::string();
    if (word.size() > 4 && word.back() == 's') word.pop_back();  // plural
    for (const Unit& unit : units)
        if (unit.dimension == dimension) {
            const std::string name = canonical_unit(unit.name);
            if (name == wanted || (name.size() > 3 && name == lower_case(name) && name == word)) return &unit;
        }
    return nullptr;
}

inline const Unit& require_unit(std::string_view text, Dimension dimension) {
    if (const Unit* unit = find_unit(text, dimension)) return *unit;
    throw domain_error("unit \"" + std::string(text) + "\": is no unit of " + std::string(name_of(dimension)) +
                       "; allowed are " + accepted_units(dimension));
}

enum class NumberStatus { ok, no_number, out_of_range };

struct LeadingNumber {
    double value{};
    std::size_t length{};  // characters taken
    NumberStatus status = NumberStatus::no_number;
};

/// The decimal number that \p text begins with, times 10^\p exponent, correctly rounded. No blanks, no "inf", no "nan".
inline LeadingNumber leading_number(std::string_view text, int exponent = 0) {
    const std::size_t sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t point = text.size() > sign && text[sign] == '.' ? 1 : 0;
    if (text.size() <= sign + point || !is_digit(text[sign + point])) return {};
    const std::size_t skipped = text[0] == '+' ? 1 : 0;  // read_decimal knows no "+"
    const char* const first = text.data() + skipped;
    const char* const end = text.data() + text.size();
    LeadingNumber number;
    const auto parsed = read_decimal(first, end, number.value);
    number.length = static_cast<std::size_t>(parsed.ptr - text.data());
    bool fits = parsed.ec == std::errc();
    if (fits && exponent != 0) {
        // The power of ten of the unit joins the exponent of the text, so that only one rounding happens.
        const std::string_view digits(first, number.length - skipped);
        const std::size_t e = digits.find_first_of("eE");
        int written = 0;
        if (e != std::string_view::npos) {
            const std::size_t plus = digits[e + 1] == '+' ? 1 : 0;
            std::from_chars(digits.data() + e + 1 + plus, digits.data() + digits.size(), written);
        }
        const std::string joined = std::string(digits.substr(0, e)) + "e" + std::to_string(written + exponent);
        fits = read_decimal(joined.data(), joined.data() + joined.size(), number.value).ec == std::errc();
    }
    number.status = fits ? NumberStatus::ok : NumberStatus::out_of_range;
    return number;
}

[[noreturn]] inline void refuse_text(std::string_view name, std::string_view text, const std::string& reason) {
    throw domain_error(std::string(name) + " = \"" + std::string(text) + "\": " + reason);
}

/// \p value, unless the factor of the unit made it infinite.
inline double finite(double value, std::string_view name, std::string_view text) {
    if (std::abs(value) <= std::numeric_limits<double>::max()) return value;
    refuse_text(name, text, "is beyond the range of double precision; allowed is a finite number");
}

}  // namespace detail

inline double unit_factor(std::string_view unit, Dimension dimension) {
    const detail::Unit& found = detail::require_unit(unit, dimension);
    return detail::leading_number("1", found.exponent).value * found.factor;
}

inline bool is_unit(std::string_view unit, Dimension dimension) {
    return detail::find_unit(unit, dimension) != nullptr;
}

inline double parse_number(std::string_view text, std::string_view name) {
    const std::string_view inner = detail::trimmed(text);
    const auto number = detail::leading_number(inner);
    if (number.status == detail::NumberStatus::out_of_range)
        detail::refuse_text(name, text, "is beyond the range of double precision; allowed is a finite number");
    if (number.status == detail::NumberStatus::no_number || number.length != inner.size())
        detail::refuse_text(name, text, "is no number; allowed is a finite decimal number such as 0.25 or 1e-6");
    return number.value;
}

inline double parse_quantity(std::string_view text, Dimension dimension, std::string_view name) {
    if (dimension == Dimension::angle) return parse_angle(text, name);
    const std::string_view inner = detail::trimmed(text);
    const std::string kind(name_of(dimension));
    const auto bare = detail::leading_number(inner);
    if (bare.status == detail::NumberStatus::no_number)
        detail::refuse_text(name, text,
                            "does not begin with a finite number; allowed is a " + kind +
                                " as number and unit, the unit one of " + detail::accepted_units(dimension));
    const std::string_view unit_text = detail::trimmed(inner.substr(bare.length));
    if (unit_text.empty())
        detail::refuse_text(
            name, text, "a number without a unit; a " + kind + " needs one of " + detail::accepted_units(dimension));
    const detail::Unit* const unit = detail::find_unit(unit_text, dimension);
    if (!unit)
        detail::refuse_text(name, text,
                            "\"" + std::string(unit_text) + "\" is no unit of " + kind + "; allowed are " +
                                detail::accepted_units(dimension));
    const auto number = detail::leading_number(inner, unit->exponent);
    if (bare.status != detail::NumberStatus::ok || number.status != detail::NumberStatus::ok)
        detail::refuse_text(name, text, "is beyond the range of double precision; allowed is a finite number");
    return detail::finite(number.value * unit->factor, name, text);
}

inline double parse_angle(std::string_view text, std::string_view name) {
    const auto refuse = [&]() -> double {
        detail::refuse_text(name, text,
                            "is no angle; allowed are a number of radians, \"45 deg\", \"0.7 rad\" or \"pi/4\"");
    };
    std::string_view rest = detail::trimmed(text);
    const auto skip_blanks = [&] { rest = detail::trimmed(rest); };
    double value = 1;
    bool has_number = false;
    if (const auto number = detail::leading_number(rest); number.status == detail::NumberStatus::ok) {
        value = number.value;
        has_number = true;
        rest.remove_prefix(number.length);
        skip_blanks();
        if (rest.empty()) return value;
        if (const detail::Unit* unit = detail::find_unit(rest, Dimension::angle))
            return detail::finite(value * unit->factor, name, text);
    } else if (number.status == detail::NumberStatus::out_of_range) {
        return refuse();
    } else if (rest.starts_with('-')) {
        value = -1;
        rest.remove_prefix(1);
    }
    // [number [*]] pi [/ number]
    if (has_number && rest.starts_with('*')) {
        rest.remove_prefix(1);
        skip_blanks();
    }
    if (rest.starts_with("pi"))
        rest.remove_prefix(2);
    else if (rest.starts_with("\xCF\x80"))
        rest.remove_prefix(2);
    else
        return refuse();
    value *= std::numbers::pi;
    skip_blanks();
    if (rest.empty()) return detail::finite(value, name, text);
    if (!rest.starts_with('/')) return refuse();
    rest.remove_prefix(1);
    skip_blanks();
    const auto divisor = detail::leading_number(rest);
    if (divisor.status != detail::NumberStatus::ok || divisor.length != rest.size() || divisor.value == 0)
        return refuse();
    return detail::finite(value / divisor.value, name, text);
}

}  // namespace fstiff::io
