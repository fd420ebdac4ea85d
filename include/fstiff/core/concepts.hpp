// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The scalar that every template of fstiff is written for.

#include <fstiff/core/config.hpp>

#include <concepts>

namespace fstiff {

/// A floating-point scalar: float, double or long double.
template <class T>
concept Real = std::floating_point<T>;

}  // namespace fstiff
