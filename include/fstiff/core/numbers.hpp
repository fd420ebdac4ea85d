// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Scalar type of every template of fstiff. Others are rejected, such as long double, which not every machine has, or
/// std::float16_t of C++23.

#include <fstiff/core/config.hpp>

#include <concepts>
#include <limits>
#include <type_traits>

namespace fstiff { inline namespace v0_1 {

/// A floating-point scalar: float or double.
template <class T>
concept Real = std::same_as < std::remove_cv_t<T>,
float > || std::same_as<std::remove_cv_t<T>, double>;

/// A computed number with its error and its cost. \p error is an absolute bound on |value - true value|, in the units
/// of \p value; inputs count as exact.
template <Real T = double>
struct Estimate {
    T value{};
    T error{};
    int evaluations{};  ///< points at which the integrand was evaluated (0: closed form)
};

/// Estimate in another unit; \p factor >= 0. A product in the subnormal range is rounded to a multiple of the least
/// number, not to a relative epsilon, and the error includes that.
template <Real T>
[[nodiscard]] constexpr Estimate<T> operator*(const Estimate<T>& estimate, T factor) {
    const T value = estimate.value * factor;
    const bool subnormal = value < (std::numeric_limits<T>::min)() && estimate.value > 0;
    return {value, estimate.error * factor + (subnormal ? std::numeric_limits<T>::denorm_min() : T(0)),
            estimate.evaluations};
}

}}  // namespace fstiff
