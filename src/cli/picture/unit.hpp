// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The unit in which a person reads numbers of one size: nm, µm or mm; Pa to GPa.

#include <span>
#include <string>
#include <string_view>

namespace fstiff::cli {

/// A unit and its size in SI.
struct Unit {
    std::string_view name;
    double size = 1;
};

/// The unit for values of \p si, such as "m" or "Pa/m", of about \p size: the usual one where it gives numbers from 0.01
/// (0.1 of a length) to 1000, else the greatest that is not above the size. An unknown \p si stays as it is.
Unit unit_for(std::string_view si, double size);
/// The unit of \p si in which most of \p values are between 1 and 1000, for a table that has one unit.
Unit unit_for_all(std::string_view si, std::span<const double> values);
/// "0.832 µm", or "0.832 ± 0.08 µm" where \p error is not 0; \p digits of the value are significant.
std::string with_unit(double value, std::string_view si, int digits = 5, double error = 0);

}  // namespace fstiff::cli
