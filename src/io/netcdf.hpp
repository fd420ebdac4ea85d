// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps and profiles of contact.engineering (.nc) in the classic form of NetCDF.
///
/// "CDF" and 1, 2 or 5, then dimensions, attributes and variables, the most significant byte first; a count is of 4
/// bytes, of 8 in form 5. Of the file are used
///
///     heights    variable over (x, y), or over (x): float32, float64 or integers, in its attribute unit
///     x, y       variables with the attributes length, the size of the map, and unit; all units are the same
///     mask       variable as heights, whose numbers other than 0 mark missing points
///
///     dx = length of x / points of x
///
/// NaN and the attribute _FillValue of heights are missing points too. Rows are the index y.
///
/// Reference   The NetCDF Classic Format Specification (Unidata); names as in SurfaceTopography 1.27.1 (MIT licence)
/// Units       map in m
/// Valid       2 points a side at least, or one profile; heights that vary; no records; at most 100000
///             entries; NetCDF 4, which is HDF5, and profiles of unequal steps are refused
/// Accuracy    number times unit, rounded once (tests/io/netcdf_test.cpp)

#include "io/reading.hpp"

namespace fstiff::inline v0_1::io {

/// Whether \p bytes begin as a file of NetCDF does in its classic form.
[[nodiscard]] bool is_netcdf(std::string_view bytes);

/// \throws domain_error naming file, variable, value and what is allowed.
[[nodiscard]] Reading read_netcdf(std::string_view bytes, std::string_view name);

}  // namespace fstiff::inline v0_1::io
