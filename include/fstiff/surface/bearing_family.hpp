// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Bearing curves from few numbers: the core of the heights, or skewness and kurtosis.
///
/// Of Sk, Spk, Svk, Smr1, Smr2 three straight lines on probability paper, from zeta_2 = Phi^-1(1 - Smr2) to
/// zeta_1 = Phi^-1(1 - Smr1) with the rise Sk, and beyond them lines with the areas of the standard's triangles:
///
///     int_0^Smr1 (f - u) dt = Spk Smr1/2     slope Spk Smr1/2/(phi(zeta_1) - zeta_1 Smr1), and the same below
///
/// A Gaussian surface gives itself back, one line. Of skewness and kurtosis Johnson's curves, which have both exactly:
///
///     f = sinh((zeta + c)/w)                   S_U, kurtosis above that of a lognormal of this skewness
///     f = 1/(1 + exp(-(zeta + c)/w))           S_B, below it
///
/// shifted and scaled to the mean 0 and the rms 1. They rise everywhere.
///
/// Reference   ISO 25178-2:2021 (Sk ...); Johnson, Biometrika 36 (1949) 149 (S_U, S_B)
/// Units       heights in any unit; skewness and kurtosis dimensionless, the latter 3 of a Gaussian
/// Valid       Sk > 0, Spk, Svk >= 0, 0 <= Smr1 < Smr2 <= 1; kurtosis from skewness^2 + 1.25 up to 100, |skewness| <= 5.
///             No surface has a kurtosis below skewness^2 + 1
/// Accuracy    areas and moments 1e-8 over knots 1/128 apart in zeta, from -8 to 8 (tests/surface/bearing_family_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/surface/bearing_slope.hpp>
#include <fstiff/surface/material_ratio.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace fstiff {

/// Heights about the upper end of the core, u = 0. \throws domain_error naming the parameter that is out of range.
template <Real T>
[[nodiscard]] BearingSlope<T> bearing_of_core(const MaterialRatio<T>& core) {
    require_positive("Sk", core.core_height);
    require(core.reduced_peak_height >= 0, "Spk", core.reduced_peak_height, "0 or more");
    require(core.reduced_valley_depth >= 0, "Svk", core.reduced_valley_depth, "0 or more");
    const T first = core.peak_share, second = core.core_and_peak_share, end = 8;
    require(first >= 0 && first < second && second <= 1, "Smr1", first, "from 0 to below Smr2, which is 1 at most");
    // the slope of a tail of the share s beyond |zeta| = z with the area h s/2
    const auto tail = [](T height, T share, T z) { return height * share / 2 / (normal_density(z) - z * share); };
    std::vector<typename BearingSlope<T>::Knot> knots;
    const bool peaks = first > 0 && core.reduced_peak_height > 0, valleys = second < 1 && core.reduced_valley_depth > 0;
    const T upper = first > 0 ? normal_quantile(1 - first) : T(4), lower = second < 1 ? normal_quantile(1 - second) : T(-4);
    if (valleys)
        knots.push_back({-end, -core.core_height -
                                   tail(core.reduced_valley_depth, 1 - second, -lower) * (lower + end)});
    knots.push_back({lower, -core.core_height});
    knots.push_back({upper, T(0)});
    if (peaks) knots.push_back({end, tail(core.reduced_peak_height, first, upper) * (end - upper)});
    return BearingSlope<T>(std::move(knots));
}

namespace detail {

/// Mean, mean square about it, skewness and kurtosis of f over normal numbers, by the trapezoidal rule.
template <Real T, class F>
[[nodiscard]] std::array<T, 4> normal_moments(const F& f) {
    std::array<T, 4> raw{};
    const T step = T(1) / 32, middle = f(T(0));
    T mass = 0;
    for (int i = -256; i <= 256; ++i) {
        const T z = step * T(i), weight = normal_density(z) * step, y = f(z) - middle;
        T power = weight;
        mass += weight;
        for (T& one : raw) one += power *= y;
    }
    for (T& one : raw) one /= mass;
    const T m = raw[0], v = raw[1] - m * m;
    const T third = raw[2] - 3 * m * raw[1] + 2 * m * m * m;
    const T fourth = raw[3] - 4 * m * raw[2] + 6 * m * m * raw[1] - 3 * m * m * m * m;
    return {m + middle, v, third / (v * std::sqrt(v)), fourth / (v * v)};
}

/// Johnson's curve at zeta, with the shift c and ln w.
template <Real T>
[[nodiscard]] T johnson(bool bounded, T c, T log_width, T zeta) {
    const T x = (zeta + c) * std::exp(-log_width);
    return bounded ? 1 / (1 + std::exp(-x)) : std::sinh(x);
}

/// c and ln w of given skewness >= 0 and kurtosis, by Newton's method on differences with halved steps.
template <Real T>
[[nodiscard]] std::array<T, 3> fitted_johnson(bool bounded, T skewness, T kurtosis) {
    const auto off = [&](T c, T log_width) {
        const auto m = normal_moments<T>([&](T z) { return johnson(bounded, c, log_width, z); });
        return std::array<T, 2>{m[2] - skewness, m[3] - kurtosis};
    };
    const auto size = [](const std::array<T, 2>& r) { return r[0] * r[0] + r[1] * r[1]; };
    T c = bounded ? -skewness : skewness, w = bounded ? T(0) : T(0.7);
    auto r = off(c, w);
    for (int round = 0; round < 100 && size(r) > T(1e-22); ++round) {
        const T h = T(1e-5);
        const auto by_c = off(c + h, w), by_w = off(c, w + h);
        const T a = (by_c[0] - r[0]) / h, b = (by_w[0] - r[0]) / h, d = (by_c[1] - r[1]) / h, e = (by_w[1] - r[1]) / h;
        const T det = a * e - b * d;
        T dc = -(r[0] * e - r[1] * b) / det, dw = -(a * r[1] - d * r[0]) / det;
        const T longest = (std::max)(std::abs(dc), std::abs(dw));
        if (!(std::isfinite(longest) && longest > 0)) break;
        if (longest > T(0.5)) dc /= 2 * longest, dw /= 2 * longest;
        for (int half = 0; half < 30; ++half, dc /= 2, dw /= 2) {
            const auto next = off(c + dc, w + dw);
            if (!(size(next) < size(r))) continue;
            c += dc, w += dw, r = next;
            break;
        }
    }
    return {c, w, std::sqrt(size(r))};
}

}  // namespace detail

/// The curve of mean 0 and rms 1 with \p skewness and \p kurtosis.
/// \throws domain_error where no surface has both, or beyond what is valid above.
template <Real T>
[[nodiscard]] BearingSlope<T> bearing_of_moments(T skewness, std::type_identity_t<T> kurtosis) {
    require(std::abs(skewness) <= 5, "skewness", skewness, "between -5 and 5");
    require(kurtosis >= skewness * skewness + T(1.25) && kurtosis <= 100, "kurtosis", kurtosis,
            "from skewness^2 + 1.25 to 100: no surface has less than skewness^2 + 1");
    const T end = 8;
    const auto knots_of = [&](const auto& f) {
        const auto m = detail::normal_moments<T>(f);
        const T sign = skewness < 0 ? T(-1) : T(1);
        std::vector<typename BearingSlope<T>::Knot> knots;
        for (int i = -1024; i <= 1024; ++i) {
            const T zeta = end * T(i) / 1024, height = sign * (f(sign * zeta) - m[0]) / std::sqrt(m[1]);
            if (knots.empty() || height > knots.back().height) knots.push_back({zeta, height});
        }
        return BearingSlope<T>(std::move(knots));
    };
    if (std::abs(skewness) < T(1e-9) && std::abs(kurtosis - 3) < T(1e-9)) return knots_of([](T z) { return z; });
    // the lognormal of this skewness: (q - 1)(q + 2)^2 = skewness^2, kurtosis q^4 + 2 q^3 + 3 q^2 - 3
    T q = 1;
    for (int i = 0; i < 200; ++i) q = 1 + skewness * skewness / ((q + 2) * (q + 2));
    const bool bounded = kurtosis < ((q + 2) * q + 3) * q * q - 3;
    const auto [c, w, left] = detail::fitted_johnson<T>(bounded, std::abs(skewness), kurtosis);
    require(left < T(1e-7), "kurtosis", kurtosis, "one that a curve of Johnson's has within zeta of -8 to 8");
    return knots_of([&, shift = c, width = w](T z) { return detail::johnson(bounded, shift, width, z); });
}

}  // namespace fstiff
