// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// K of hybrid of the many surfaces of numbers that a band is made of.

#include <fstiff/answer/curves.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include <memory>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Contacts of random surfaces with the bearing curve \p bearing, which must outlive it (none: Gaussian heights):
/// from a table over p/(E g), alpha and H, to 1.2e-3. For any threads.
[[nodiscard]] std::shared_ptr<const QuickHybrid> hybrids_of_draws(const MaterialRatioSlope<double>* bearing,
                                                                  double gamma);
/// Contacts of surfaces with few different alpha and H: one contact of each, with any bearing curves, which must
/// outlive it. For one thread.
[[nodiscard]] std::shared_ptr<const QuickHybrid> hybrids_of_numbers(double gamma);

}}}  // namespace fstiff::detail
