// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The slope of a function at 0 by differences of four points.
///
///     df/dx = [8 (f(h) - f(-h)) - (f(2h) - f(-2h))]/(12 h) + h^4/30 f'''''
///
/// Reference   Abramowitz and Stegun, 25.3.6
/// Units       those of f over those of h
/// Valid       f of a number, or of an array of Eigen; h > 0
/// Accuracy    h^4/30 of the fifth derivative, and 2/h of the error of f (tests/identify/fit_problem_test.cpp)

#include <fstiff/core/config.hpp>

#include <type_traits>

namespace fstiff { inline namespace v0_1 { namespace math {

/// The slope of \p f at 0, by its values at \p h and at twice that on both sides.
template <class F, class T>
[[nodiscard]] auto central_difference(const F& f, T h) {
    using Value = std::decay_t<std::invoke_result_t<const F&, T>>;
    const Value up = f(h), down = f(-h), far_up = f(2 * h), far_down = f(-2 * h);
    return Value((8 * (up - down) - (far_up - far_down)) / (12 * h));
}

}}}  // namespace fstiff::math
