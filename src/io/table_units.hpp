// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The units of the columns of a text: those of the options, with a warning where the file states another; else those
/// of the titles, which the header must not contradict; else those of the header.
///
/// A unit that is not understood, of no length, or that may have a factor in the numbers is refused. The header of a
/// map without titles may state a conversion factor in place of a unit of the heights, or SPIP's Bit2nm.
///
/// Units       m

#include "io/roles.hpp"

namespace fstiff::inline v0_1::io::detail {

struct LengthUnit {
    std::string name;  // as it is written, or for messages; empty where there is none
    double factor{};   // [m]
};

struct Units {
    LengthUnit heights, x, y;  // x of a profile is that of the positions, of a matrix that of its axes
    std::string lateral;       // that the options give for lengths apart from heights
    std::string text, from;    // for the record
};

/// The units of \p table, whose file messages call \p name.
/// \throws domain_error naming a column without a unit, and what is stated in its place.
Units units_of(const TextTable& table, const SurfaceOptions& options, const std::string& name, Record& record);

/// How messages call the units of a map that are to be given: that of the heights by its name where it is stated.
std::string asked_units(const TextTable& table, const std::string& name);

/// What a length and the number of points above one column of heights may mean, for messages; empty for another table.
std::string hint_of_mitutoyo(const NumberTable& table);

}  // namespace fstiff::inline v0_1::io::detail
