// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Scalar type of every template of fstiff. Others are rejected, such as long double, which not every machine has, or
/// std::float16_t of C++23.

#include <fstiff/core/config.hpp>

#include <concepts>
#include <type_traits>

namespace fstiff::inline v0_1 {

/// A floating-point scalar: float or double.
template <class T>
concept Real = std::same_as < std::remove_cv_t<T>,
float > || std::same_as<std::remove_cv_t<T>, double>;

}  // namespace fstiff::inline v0_1
