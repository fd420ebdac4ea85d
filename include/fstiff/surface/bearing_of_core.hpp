// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Bearing curves from few numbers: Sk, Spk, Svk, Smr1, Smr2 (three lines), or skewness and kurtosis (Johnson).
///
///     core     zeta_2 = Phi^-1(1 - Smr2) to zeta_1 = Phi^-1(1 - Smr1), rise Sk
///     tails    int_0^Smr1 (f - u) dt = Spk Smr1/2:  slope Spk Smr1/2/(phi(zeta_1) - zeta_1 Smr1); the same below
///     Johnson  f = sinh((zeta + c)/w) (S_U)  or  f = 1/(1 + exp(-(zeta + c)/w)) (S_B), scaled to mean 0 and rms 1
///
/// S_U for a kurtosis above that of a lognormal of this skewness, S_B below it; both numbers are matched exactly.
/// Derivation  docs/theory-surface.md
/// Reference   ISO 25178-2:2021 (Sk ...); Johnson, Biometrika 36 (1949) 149 (S_U, S_B)
/// Units       heights in any unit; skewness and kurtosis dimensionless, the latter 3 for a Gaussian
/// Valid       Sk > 0, Spk, Svk >= 0, 0 <= Smr1 < Smr2 <= 1; |skewness| <= 3, least_kurtosis() <= kurtosis <= 100
/// Accuracy    areas and moments 1e-8 over knots 1/128 apart in zeta, from -8 to 8
///             (tests/surface/bearing_family_test.cpp)

#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Curve with the upper end of the core at height u = 0. \throws domain_error naming the parameter out of range.
template <Real T>
[[nodiscard]] MaterialRatioSlope<T> bearing_of_core(const MaterialRatio<T>& core) {
    require_positive("Sk", core.core_height);
    require(core.reduced_peak_height >= 0, "Spk", core.reduced_peak_height, "0 or more");
    require(core.reduced_valley_depth >= 0, "Svk", core.reduced_valley_depth, "0 or more");
    const T first = core.peak_share, second = core.core_and_peak_share, end = 8;
    require(first >= 0 && first < second && second <= 1, "Smr1", first, "from 0 to below Smr2, which is 1 at most");
    // slope of a tail of the share s beyond |zeta| = z with the area h s/2
    const auto tail = [](T height, T share, T z) { return height * share / 2 / (math::normal_density(z) - z * share); };
    std::vector<typename MaterialRatioSlope<T>::Knot> knots;
    const bool peaks = first > 0 && core.reduced_peak_height > 0, valleys = second < 1 && core.reduced_valley_depth > 0;
    const T upper = first > 0 ? math::normal_quantile(1 - first) : T(4),
            lower = second < 1 ? math::normal_quantile(1 - second) : T(-4);
    if (valleys)
        knots.push_back(
            {-end, -core.core_height - tail(core.reduced_valley_depth, 1 - second, -lower) * (lower + end)});
    knots.push_back({lower, -core.core_height});
    knots.push_back({upper, T(0)});
    if (peaks) knots.push_back({end, tail(core.reduced_peak_height, first, upper) * (end - upper)});
    return MaterialRatioSlope<T>(std::move(knots));
}

/// Mean, mean square about it, skewness and kurtosis of f over normal numbers, by the trapezoidal rule.
template <Real T, class F>
[[nodiscard]] std::array<T, 4> normal_moments(const F& f) {
    std::array<T, 4> raw{};
    const T step = T(1) / 32, middle = f(T(0));
    T mass = 0;
    for (int i = -256; i <= 256; ++i) {
        const T z = step * T(i), weight = math::normal_density(z) * step, y = f(z) - middle;
        T power = weight;
        mass += weight;
        for (T& moment : raw) moment += power *= y;
    }
    for (T& moment : raw) moment /= mass;
    const T m = raw[0], v = raw[1] - m * m;
    const T third = raw[2] - 3 * m * raw[1] + 2 * m * m * m;
    const T fourth = raw[3] - 4 * m * raw[2] + 6 * m * m * raw[1] - 3 * m * m * m * m;
    return {m + middle, v, third / (v * std::sqrt(v)), fourth / (v * v)};
}

/// Johnson's curve at zeta with f(0) = 0 and f'(0) = 1: steepness is 1/w, bend f''(0)/(f'(0) steepness), 0 for a
/// symmetrical curve and 1 for a lognormal one.
template <Real T>
[[nodiscard]] T johnson(bool bounded, T steepness, T bend, T zeta) {
    const T x = steepness * zeta;
    if (!bounded) {
        const T half = std::sinh(x / 2);
        return (std::sinh(x) + 2 * bend * half * half) / steepness;
    }
    const T level = (1 - bend) / 2;  // of f between its ends
    return x < 0 ? std::expm1(x) / ((1 - level) + level * std::exp(x)) / steepness
                 : -std::expm1(-x) / ((1 - level) * std::exp(-x) + level) / steepness;
}

/// One of Johnson's curves, with its errors of skewness and kurtosis.
template <Real T>
struct FittedJohnson {
    T log_steepness, bend, off;
};

/// Curve of given skewness >= 0 and kurtosis, by Newton's method on differences with halved steps, from \p steepness
/// and \p t.
template <Real T>
[[nodiscard]] FittedJohnson<T> fitted_johnson(bool bounded, T skewness, T kurtosis, T steepness, T t) {
    const auto off = [&](T log_steepness, T bend) {
        const T slope = std::exp(log_steepness);
        const auto m = normal_moments<T>([&](T z) { return johnson(bounded, slope, bend, z); });
        return std::array<T, 2>{m[2] - skewness, m[3] - kurtosis};
    };
    const auto size = [](const std::array<T, 2>& r) { return r[0] * r[0] + r[1] * r[1]; };
    const T h = T(1e-5);
    T s = std::log(steepness);
    auto r = off(s, t);
    for (int round = 0; round < 100 && size(r) > T(1e-22); ++round) {
        const T side = t > T(0.5) ? -h : h;
        const auto by_s = off(s + h, t), by_t = off(s, t + side);
        const T a = (by_s[0] - r[0]) / h, b = (by_t[0] - r[0]) / side, d = (by_s[1] - r[1]) / h,
                e = (by_t[1] - r[1]) / side;
        const T det = a * e - b * d;
        T ds = -(r[0] * e - r[1] * b) / det, dt = -(a * r[1] - d * r[0]) / det;
        const T longest = (std::max)(std::abs(ds), std::abs(dt));
        if (!(std::isfinite(longest) && longest > 0)) break;
        if (longest > T(0.5)) ds /= 2 * longest, dt /= 2 * longest;
        const T before = size(r);
        for (int half = 0; half < 30 && size(r) == before; ++half, ds /= 2, dt /= 2) {
            const T next_t = std::clamp(t + dt, T(0), T(1));
            const auto next = off(s + ds, next_t);
            if (size(next) < before) s += ds, t = next_t, r = next;
        }
        if (size(r) == before) break;
    }
    return {s, t, std::sqrt(size(r))};
}

/// Same as above, starting from the leading order of small steepnesses, and on failure from greater ones.
template <Real T>
[[nodiscard]] FittedJohnson<T> fitted_johnson(bool bounded, T skewness, T kurtosis) {
    const T excess = kurtosis - 3, square = skewness * skewness, least = T(1e-7);
    const T leading = std::sqrt((std::max)(bounded ? square - excess / 2 : excess / 4 - square / 3, least * least));
    FittedJohnson<T> best{0, 0, (std::numeric_limits<T>::max)()};
    for (const T steepness : {(std::min)(leading, T(1.4)), bounded ? T(1) : T(0.5), bounded ? T(4) : T(0.25)}) {
        const T bend =
            steepness == leading ? skewness / (3 * steepness) : std::tanh(skewness / (bounded ? 2 : 1) * steepness);
        const auto fit = fitted_johnson(bounded, skewness, kurtosis, steepness, std::clamp(bend, T(0), T(0.999)));
        if (fit.off < best.off) best = fit;
        if (best.off < T(1e-9)) break;
    }
    return best;
}

/// Mean, mean square about it, skewness and kurtosis of the heights of \p curve.
template <Real T>
[[nodiscard]] std::array<T, 4> normal_moments(const MaterialRatioSlope<T>& curve) {
    return normal_moments<T>([&](T zeta) { return curve.height(zeta); });
}

/// Ranges of skewness and kurtosis of bearing_of_moments. The lower limit of the kurtosis is skewness^2 + 1.25 up to a
/// skewness of 1.5; no distribution has a kurtosis below skewness^2 + 1.
template <Real T>
inline constexpr T most_skewness = T(3);
template <Real T>
inline constexpr T most_kurtosis = T(100);
template <Real T>
[[nodiscard]] T least_kurtosis(T skewness) {
    return skewness * skewness + (std::max)(T(1.25), std::abs(skewness) / 2 + T(0.5));
}

/// Curve of mean 0 and rms 1 with \p skewness and \p kurtosis; a straight line for 0 and 3.
/// \throws domain_error where no surface has both, or beyond the valid range above.
template <Real T>
[[nodiscard]] MaterialRatioSlope<T> bearing_of_moments(T skewness, std::type_identity_t<T> kurtosis) {
    require(std::abs(skewness) <= most_skewness<T>, "skewness", skewness, "between -3 and 3");
    require(kurtosis >= least_kurtosis(skewness) && kurtosis <= most_kurtosis<T>, "kurtosis", kurtosis,
            "from skewness^2 + 1.25, and more beyond a skewness of 1.5, to 100");
    const T end = 8;
    const T sign = skewness < 0 ? T(-1) : T(1);
    const auto knots_of = [&](const auto& f) {
        const auto m = normal_moments<T>(f);
        std::vector<typename MaterialRatioSlope<T>::Knot> knots;
        for (int i = -1024; i <= 1024; ++i) {
            const T zeta = end * T(i) / 1024, height = sign * (f(sign * zeta) - m[0]) / std::sqrt(m[1]);
            if (knots.empty() || height > knots.back().height + T(1e-12)) knots.push_back({zeta, height});
        }
        return MaterialRatioSlope<T>(std::move(knots));
    };
    if (std::abs(skewness) < T(1e-9) && std::abs(kurtosis - 3) < T(1e-9)) return knots_of([](T z) { return z; });
    // the lognormal of this skewness: (q - 1)(q + 2)^2 = skewness^2, kurtosis q^4 + 2 q^3 + 3 q^2 - 3
    T q = 1;
    for (int i = 0; i < 200; ++i) q = 1 + skewness * skewness / ((q + 2) * (q + 2));
    const bool bounded = kurtosis < ((q + 2) * q + 3) * q * q - 3;
    const auto fit = fitted_johnson<T>(bounded, std::abs(skewness), kurtosis);
    require(fit.off < T(1e-7), "kurtosis", kurtosis, "one that a curve of Johnson's has within zeta of -8 to 8");
    const T steepness = std::exp(fit.log_steepness);
    return knots_of([&](T z) { return johnson(bounded, steepness, fit.bend, z); });
}

}}}  // namespace fstiff::detail
