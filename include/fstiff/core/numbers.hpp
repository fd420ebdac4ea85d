// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The constants of std::numbers that fstiff uses, in every scalar: libc++ writes those of long double as doubles, and
/// its pi is wrong by 1.2e-16 (LLVM issue 188079).
///
/// Accuracy    correctly rounded for float, double and long double up to 113 bits (tests/core/numbers_test.cpp)

#include <fstiff/core/concepts.hpp>

namespace fstiff::inline v0_1::numbers {

template <Real T>
inline constexpr T pi_v = static_cast<T>(3.14159265358979323846264338327950288419716939937510L);
template <Real T>
inline constexpr T inv_sqrtpi_v = static_cast<T>(0.564189583547756286948079451560772585844050629329L);
template <Real T>
inline constexpr T sqrt2_v = static_cast<T>(1.41421356237309504880168872420969807856967187537695L);
template <Real T>
inline constexpr T ln2_v = static_cast<T>(0.693147180559945309417232121458176568075500134360255L);
template <Real T>
inline constexpr T ln10_v = static_cast<T>(2.30258509299404568401799145468436420760110148862877L);

}  // namespace fstiff::inline v0_1::numbers
