// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers with a unit, as in a scene, on a command line or in the header of a measured file.
///
///     parse_quantity("0.832 um", Dimension::length, "rms_height")   8.32e-7
///     parse_angle("pi/4", "theta")                                  0.785...
///
/// <fstiff/io/units.hpp> lists the spellings of units, which follow after blanks or directly. The decimal sign is the
/// point in every locale.
///
/// Units       result in SI: m, m^2, 1/m^2, Pa, rad, Hz, m/s, kg/m^3, kg/(m^2 s), Pa/m
/// Valid       finite decimal numbers; "inf", "nan", hexadecimal and anything left over are refused
/// Accuracy    correctly rounded for every unit that is a power of ten of the SI unit; else (in, psi, deg) 2 ulp
///             (tests/io/quantity_test.cpp)

#include <fstiff/io/units.hpp>

#include <string_view>

namespace fstiff { inline namespace v0_1 { namespace io {

/// A decimal number without a unit. \throws domain_error naming \p name when \p text is anything else.
[[nodiscard]] double parse_number(std::string_view text, std::string_view name);

/// A number and its unit, in SI units; angles as parse_angle reads them.
/// \throws domain_error naming \p name, the text and the accepted units; a bare number is refused.
[[nodiscard]] double parse_quantity(std::string_view text, Dimension dimension, std::string_view name);

/// An angle [rad]: "pi/4", "2*pi/7", "0.25 pi", "45 deg", "0.7 rad", or a bare number of radians.
/// \throws domain_error naming \p name and the accepted forms.
[[nodiscard]] double parse_angle(std::string_view text, std::string_view name);

}}}  // namespace fstiff::io
