// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Positions of a profile, at equal steps or not.
///
/// Units       those of the file

#include <vector>

namespace fstiff::inline v0_1::io::detail {

/// The steps between the positions \p x, one fewer.
std::vector<double> steps_of(const std::vector<double>& x);

/// The upper median of \p values, one at least.
double median(std::vector<double> values);

/// Whether \p x rises or falls in equal steps, to \p tolerance of a step; no for less than two.
bool has_equal_steps(const std::vector<double>& x, double tolerance);

/// 0 1 2 4 5 ...: whether positions that are \p printed to whole steps, of which one or two are odd, have lost a row
/// rather than digits.
bool is_interrupted(const std::vector<double>& x, double printed);

/// \p heights at as many equal steps from the first position to the last, on straight lines between neighbours; NaN
/// where one of them is.
std::vector<double> at_equal_steps(const std::vector<double>& heights, const std::vector<double>& x);

}  // namespace fstiff::inline v0_1::io::detail
