// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured value with its standard error.

#include <fstiff/core/numbers.hpp>

namespace fstiff { inline namespace v0_1 {

/// A measured value and its standard error.
template <Real T = double>
struct Measurement {
    T value{}, error{};
};

}}  // namespace fstiff
