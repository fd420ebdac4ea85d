// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads surfaces and profiles of Digital Surf (.sur, .pro), compressed or not.
///
/// A header of 512 bytes, a comment, a private zone, and the heights row after row as integers of 16 or 32 bits. Fields
/// of the header that are used, by byte offset:
///
///     0   "DIGITAL SURF", or       86  non-measured points are marked     120  steps of x, y, z (float32)
///         "DSCOMPRESSED"           98  bits of a height                   180  their units (3 x 16 characters)
///     12  0: least significant     100 lowest number                      290  1, 2, 3: inverted
///         byte first, 257: last    108 points of a row                    334  bytes of the comment
///     14  objects in the file      112 rows                               336  bytes of the private zone
///     18  1 profile, 2 surface
///
/// The heights of a compressed file are zlib streams after a table: their count, then of each its bytes when inflated
/// and when deflated (uint32). Together they hold the heights as in the other form.
///
/// Heights are number times step of z; the offset of the axis, a constant, is not added. Where missing points are
/// marked, the lowest number less 2 marks them. A file that states an inversion is read as stored, with
/// a warning.
///
/// Reference   the header of the formats SUR and PRO of Digital Surf, as the open reader of Gwyddion lays it out; files
///             of both forms from an open program are read (tests/data), none from MountainsMap
/// Units       map in m
/// Valid       one object; 2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times step times unit: two roundings (tests/io/sur_test.cpp)

#include "io/binary_numbers.hpp"
#include "io/lines.hpp"
#include "io/reading.hpp"

#include <fstiff/io/quantity.hpp>

#include <functional>
#include <span>

namespace fstiff::inline v0_1::io {

/// Inflates a zlib stream into exactly as many bytes, or returns false: inflate_zlib() of io/inflate.hpp, or
/// nothing where zlib is not there.
using Inflate = std::function<bool(std::string_view stream, std::span<char> out)>;

/// Whether \p bytes begin as a file of Digital Surf does.
[[nodiscard]] bool is_sur(std::string_view bytes);

/// inflate_zlib() of io/inflate.hpp, or nothing without zlib.
[[nodiscard]] Inflate inflate_where_built();

/// Without \p inflate, compressed files are refused. \throws domain_error naming file, field, value and what is
/// allowed.
[[nodiscard]] Reading read_sur(std::string_view bytes, std::string_view name, const Inflate& inflate = {});

}  // namespace fstiff::inline v0_1::io
