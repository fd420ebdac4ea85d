// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What the Gaussian filter lambda_s leaves of the second differences of a self-affine profile.
///
///     the filter       weights of a normal distribution, s = lambda_s sqrt(2 ln 2)/(2 pi)
///     S after it       C (M(tau) - M(0)),  M(tau) = E |tau + s sqrt(2) xi|^p,  xi standard normal, of S = C tau^p before
///     left of S2       (4 M(tau) - M(2 tau) - 3 M(0)) / ((4 - 2^p) tau^p)
///
/// At tau = lambda_s 60 to 80 % are left, at two lambda_s 80 to 95 %: a fit that begins at lambda_s can make up for the rest.
///
/// Reference   ISO 16610-21 (the filter); the mean over two normal distributions is this project's
/// Units       lag and lambda_s in the same unit
/// Valid       0 < p < 2, tau >= lambda_s/2
/// Accuracy    1e-4 of the share for lambda_s of many samples; at two samples the filter itself is coarse
///             (tests/profile/filter_loss_test.cpp)

#include <fstiff/core/concepts.hpp>
#include <fstiff/core/numbers.hpp>

#include <cmath>

namespace fstiff::detail {

/// E |t + xi|^power, xi standard normal.
template <Real T>
T mean_power_of_normal(T t, T power) {
    if (t == T(0))
        return std::pow(T(2), power / 2) * std::tgamma((power + 1) / 2) / std::sqrt(numbers::pi_v<T>);
    const T step = T(1) / 64, reach = T(8);
    T sum = 0;
    for (T x = -reach; x <= reach; x += step) sum += std::pow(std::abs(t + x), power) * std::exp(-x * x / 2);
    return sum * step / std::sqrt(2 * numbers::pi_v<T>);
}

/// The share of the mean square of second differences that \p lambda_s leaves at the lag \p lag, of a profile whose S goes as
/// lag^\p power; 1 without a filter.
template <Real T>
T share_left(T lag, T lambda_s, T power) {
    if (!(lambda_s > T(0))) return T(1);
    const T width = lambda_s * std::sqrt(std::log(T(2))) / numbers::pi_v<T>;  // sqrt(2) s
    const T t = lag / width;
    const T left =
        4 * mean_power_of_normal(t, power) - mean_power_of_normal(2 * t, power) - 3 * mean_power_of_normal(T(0), power);
    return left / ((4 - std::pow(T(2), power)) * std::pow(t, power));
}

}  // namespace fstiff::detail
