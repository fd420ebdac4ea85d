// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads profiles and maps of Bruker Dektak (.opdx).
///
/// "VCA DATA", 1, 0, 0, 55 (hex), and a tree of items, the least significant byte first. An item is its name (uint32
/// length, then the letters), a byte of its type, and its content; a length L is the number of its bytes (1, 2 or 4),
/// then itself.
///
///     01 bool           46, 47, 7D  L, then items up to one of type 7F     00  name, 4 bytes, name, L, a matrix
///     04, 05 int16      12  L, text                                        45  name, L, a matrix
///     06, 07 int32      13  L, float64, name and symbol of its unit        40  name, L, 5 bytes, float64s
///     0A, 0B int64      42  name, L, names                                 0E, 7C  name, L, left out
///     0C float32        15  9 bytes of a date                              18  L, left out
///     0D float64        a matrix: rows, columns (uint32), float32s row after row
///
/// The first channel of heights is read, MetaData/2D_Channels/Height or MetaData/1D_Channels/Height, or the map that
/// MetaData/PrimaryData2D names, in its folder of 2D_Data or 1D_Data:
///
///     Matrix, Dimension1Points, Dimension2Points, Dimension1Extent, Dimension2Extent, DataScale of a map (1 is y)
///     Array, NumPoints, Extent, DataScale of a profile
///
///     height = number DataScale,    step = extent / (points - 1)
///
/// NaN is a missing point.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose profile of a measured file is the same
/// Units       map in m
/// Valid       2 points a side at least, or one profile; heights that vary; 100000 items, 32 within one another
/// Accuracy    number times scale times unit, rounded twice (tests/io/opdx_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a file of Dektak does.
[[nodiscard]] bool is_opdx(std::string_view bytes);

/// \throws domain_error naming file, item, value and what is allowed.
[[nodiscard]] Reading read_opdx(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
