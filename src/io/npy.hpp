// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads an array of NumPy (.npy): one dimension is a profile, two are a map, whose rows are the first index.
///
/// A magic string, the version (2 bytes), the length of the header (2 bytes, 4 from version 2.0, least significant
/// first), the header, a dictionary such as {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }, and the
/// numbers. The reader takes integers (i1, i2, i4, i8, u1, u2, u4, u8) and floating-point numbers (f4, f8) of either
/// byte order, in the order of C or of Fortran. The file holds neither units nor steps: they are given. NaN is a
/// missing point, and so are the numbers that the options name. Sizes are compared with the bytes that are there before
/// memory is taken.
///
/// Reference   NumPy manual, numpy.lib.format (format versions 1.0, 2.0, 3.0)
/// Units       map in m; SurfaceOptions::units are the file's
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/npy_test.cpp)

#include "io/binary_numbers.hpp"
#include "io/header.hpp"
#include "io/missing_values.hpp"
#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as an array of NumPy does.
[[nodiscard]] bool is_npy(std::string_view bytes);

/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_npy(std::string_view bytes, std::string_view name, const SurfaceOptions& options);

}  // namespace fstiff::inline v0_1::io
