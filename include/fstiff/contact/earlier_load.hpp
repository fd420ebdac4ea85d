// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Stiffness after an earlier, greater load, whose yielded area remains.
///
///     K(p after p_max)/K(p_max) = f r/(1 + (f^n - 1) r^n)^(1/n),  r = K(p)/K(p_max) of first loadings, n = 1.7
///     f = 1 + 1.1/(1 + (h/0.44)^2.1),  h = H/(E g)
///
/// Fitted to boundary elements; 1 at p_max, never below the first loading, and that of it for elastic bodies, h large.
///
/// Units       ratios
/// Valid       p above p_max/10; h of 0.05 and more
/// Accuracy    within 15 % at 86 % of 140 points of three maps, at 75 to 95 % of each, which differ by as much among
///             themselves; below p_max/10 within 50 % (tests/contact/earlier_load_test.cpp)

#include <fstiff/core/error.hpp>

#include <cmath>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// K over that at the greatest pressure; \p ratio is that of first loadings, from 0 to 1, \p hardness H/(E g).
[[nodiscard]] inline double stiffness_after_load(double ratio, double hardness) {
    require(ratio >= 0 && ratio <= 1, "ratio of the stiffnesses of first loadings", ratio, "0 to 1");
    require(hardness >= 0, "H/(E g)", hardness, "0 or greater");
    const double f = 1 + 1.1 / (1 + std::pow(hardness / 0.44, 2.1)), n = 1.7;
    return f * ratio / std::pow(1 + (std::pow(f, n) - 1) * std::pow(ratio, n), 1 / n);
}

}}}  // namespace fstiff::detail
