// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps of Sensofar and Leica DCM (.plu, .apx).
///
/// A header of 500 bytes without a mark of its own, and layers of heights, the least significant byte first. Fields
/// of the header that are used, by byte offset:
///
///     0    date and time as text ("Fri Mar 10 16:35:59 2023")    428  type of the measurement (uint32): 3 is a map
///     388  rows, columns (uint32)                                489  layers (uint8)
///     404  steps of x and y [um] (float32)                       492  pictures after each layer (uint8)
///
/// A layer is rows, columns (uint32), the heights in um row after row as float32, the lowest and the highest of them
/// (float32), and the pictures of 3 bytes a point. 1000001 marks a missing point. The first layer is read.
///
/// A file is known by its date and by counts that agree with each other.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose maps of two measured files are the same
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; no profiles and other measurements
/// Accuracy    the float32 of the file times 1e-6, rounded once (tests/io/plu_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes, or the first of them, are such as a file of Sensofar begins with.
[[nodiscard]] bool is_plu(std::string_view bytes);

/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_plu(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
