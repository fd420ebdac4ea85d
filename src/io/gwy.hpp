// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads one channel of a file of Gwyddion (.gwy).
///
/// "GWYP" and a tree of objects, least significant byte first. An object is its name with a NUL byte, the bytes of its
/// content as uint32, and components: name, NUL, a letter of the type, and the value.
///
///     b, c   1 byte           s   text with a NUL byte                 C, I, Q, D   uint32 count, then the elements
///     i      int32            o   an object                            S, O         uint32 count, then texts or
///     objects q, d   int64, float64
///
/// The outer object is a GwyContainer. Channel N is the GwyDataField "/N/data" of xres columns and yres rows over a
/// width xreal and a height yreal in the unit si_unit_xy, its heights in si_unit_z as float64, row after row from the
/// top. Its name is "/N/data/title". Points that its mask "/N/mask" marks (1; 0 elsewhere) are taken for missing.
///
///     dx = xreal / xres,    dy = yreal / yres
///
/// The lowest channel whose units are lengths is read, or the one that the options name by its number or its title;
/// the record lists the others. Graphs, volumes, clouds of points and the files of Gwyddion 1 (GWYO) are not read.
///
/// Reference   Gwyddion user guide, "Format of Gwyddion Files". Deviation: a missing or empty unit is refused.
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/gwy_test.cpp)

#include "io/binary_numbers.hpp"
#include "io/lines.hpp"
#include "io/reading.hpp"

#include <fstiff/io/quantity.hpp>

#include <map>

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a file of Gwyddion 2 does.
[[nodiscard]] bool is_gwy(std::string_view bytes);

/// The channel \p channel, its number ("1") or its title ("Height"), of the file in \p bytes, which messages call \p
/// name; empty: the lowest whose units are lengths.
/// \throws domain_error naming file, component, value and what is allowed.
[[nodiscard]] Reading read_gwy(std::string_view bytes, std::string_view name, std::string_view channel = {});

}  // namespace fstiff::inline v0_1::io
