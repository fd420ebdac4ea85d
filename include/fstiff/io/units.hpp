// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Units that fstiff reads, in the spellings of scenes, command lines and measured files.
///
///     unit_factor("GPa/um", Dimension::stiffness_per_area)          1e15
///
/// The micro sign may be "u", U+00B5, U+03BC, the CP1252 byte 0xB5 or the MS-DOS byte 0xE6; exponents may be written
/// "^2", "2" or as superscripts; blanks around a unit may be those of Unicode; products with a blank, "*" or a middle
/// dot. Case matters ("MPa" is not "mPa"), except in spelt-out words ("Micrometer").
///
/// Units       SI: m, m^2, 1/m^2, Pa, rad, Hz, m/s, kg/m^3, kg/(m^2 s), Pa/m, N, W/(m K), S/m, m^2 K/W, ohm m^2, K
/// Accuracy    powers of ten are correctly rounded; in, psi, lbf, deg within 1 ulp (tests/io/quantity_test.cpp)

#include <fstiff/core/names.hpp>

#include <string>
#include <string_view>

namespace fstiff { inline namespace v0_1 { namespace io {

/// Kinds of quantities that have units.
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
    stiffness_per_area,
    force,
    thermal_conductivity,
    electrical_conductivity,
    thermal_film,
    electrical_film,
    temperature
};

}}}  // namespace fstiff::io

namespace fstiff { inline namespace v0_1 {

/// Name of a kind in messages.
template <>
inline constexpr auto enum_names<io::Dimension> = fstiff::detail::name_list<io::Dimension>({
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
    {io::Dimension::force, "force"},
    {io::Dimension::thermal_conductivity, "thermal conductivity"},
    {io::Dimension::electrical_conductivity, "electrical conductivity"},
    {io::Dimension::thermal_film, "thermal resistance"},
    {io::Dimension::electrical_film, "electrical resistance"},
    {io::Dimension::temperature, "temperature"},
});

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace io {

/// Value of one \p unit of \p dimension in SI units; of length, powers of ten of one too: "10 nm", "x10 nm", "10^-6 m".
/// \throws domain_error listing the accepted units.
[[nodiscard]] double unit_factor(std::string_view unit, Dimension dimension);

/// Whether \p unit is one of \p dimension.
[[nodiscard]] bool is_unit(std::string_view unit, Dimension dimension);

/// Units of \p dimension as messages list them: "m, km, cm, mm, um".
[[nodiscard]] std::string accepted_units(Dimension dimension);

}}}  // namespace fstiff::io
