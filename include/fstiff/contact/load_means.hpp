// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How deep the peaks of a contact are pressed in; contact/rough_contact.hpp computes it.

#include <fstiff/core/numbers.hpp>

namespace fstiff { inline namespace v0_1 {

/// Depth to which the peaks are pressed in, as means over the load that they carry.
template <Real T = double>
struct LoadMeans {
    Estimate<T> interference;  ///< of omega/omega_c
    Estimate<T> radius_ratio;  ///< of a/R
};

}}  // namespace fstiff
