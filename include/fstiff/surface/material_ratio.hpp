// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Peaks, core and valleys of the material ratio curve: Sk, Spk, Svk, Smr1, Smr2 of a map, Rk, Rpk ... of a profile.
///
///     z(t), t = 0 ... 1     the heights in falling order at t = i/(N-1), straight lines between them
///     [a, a + 0.4]          where z(a) - z(a + 0.4) is least; the first of equal ones
///     z = u - Sk t          least-squares line in z through z(t) over that region, as an integral over t
///     z(Smr1) = u           z(Smr2) = u - Sk
///     Spk Smr1/2 = int_0^Smr1 (z(t) - u) dt          Svk (1-Smr2)/2 = int_Smr2^1 (u - Sk - z(t)) dt
///
/// Smr1 = Spk = 0 where z(0) <= u; Smr2 = 1 and Svk = 0 where z(1) >= u - Sk. Ties: 1e-14 of the range of the heights.
/// Reference   ISO 25178-2:2021 (map), ISO 21920-2:2021 and ISO 13565-2:1996 (profile); the filter of ISO 13565-1,
///             which spares deep valleys, is not applied
/// Units       heights in any unit; shares from 0 to 1, where the standards print per cent
/// Valid       heights finite, or NaN where a point is missing; at least 16 exist, not all of one height
/// Accuracy    1e-12 of the range of the heights (tests/surface/material_ratio_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/surface/bearing_curve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// Core of the material ratio curve, with the parts above and below it.
template <Real T = double>
struct MaterialRatio {
    T core_height{};           ///< Sk, Rk
    T reduced_peak_height{};   ///< Spk, Rpk
    T reduced_valley_depth{};  ///< Svk, Rvk
    T peak_share{};            ///< Smr1, Rmr1: of the points above the core
    T core_and_peak_share{};   ///< Smr2, Rmr2: of the points not below the core
};

/// Core of \p heights in any order. \throws domain_error when fewer than 16 exist, or all are of one height.
template <Real T>
[[nodiscard]] MaterialRatio<T> material_ratio(std::span<const T> heights);

/// Difference below which heights, and differences of them, are equal, over the range of the heights: a few roundings.
template <Real F>
inline constexpr F tie = (std::max)(F(1e-14), 64 * std::numeric_limits<F>::epsilon());

/// Heights in falling order within a range of 1, one at each whole place; straight lines between them.
template <Real F>
class FallingCurve {
public:
    explicit FallingCurve(const std::vector<F>& heights) : z_(heights) {}

    [[nodiscard]] F at(F place) const {
        const std::size_t i = (std::min)(static_cast<std::size_t>(place), z_.size() - 2);
        const F part = place - static_cast<F>(i);
        return z_[i] * (1 - part) + z_[i + 1] * part;
    }
    /// First place where the curve is down to \p level; 0 where it begins below, the last place where it ends above.
    [[nodiscard]] F first_at_or_below(F level) const {
        const auto next = std::partition_point(z_.begin(), z_.end(), [level](F z) { return z > level + tie<F>; });
        return place_of(next, level);
    }
    /// First place after which the curve is below \p level, with the same ends.
    [[nodiscard]] F first_below(F level) const {
        const auto next = std::partition_point(z_.begin(), z_.end(), [level](F z) { return z >= level - tie<F>; });
        return place_of(next, level);
    }
    /// Calls \p use(from, to, z(from), z(to)) for each straight part between two places.
    template <class Use>
    void visit(F from, F to, const Use& use) const {
        while (from < to) {
            const F next = (std::min)(to, std::floor(from) + 1);
            use(from, next, at(from), at(next));
            from = next;
        }
    }
    /// Integral of z - level over the places.
    [[nodiscard]] F area_above(F level, F from, F to) const {
        math::CompensatedSum<F> sum;
        visit(from, to, [&](F a, F b, F za, F zb) { sum.add((b - a) * ((za - level) + (zb - level)) / 2); });
        return sum.value();
    }

private:
    F place_of(typename std::vector<F>::const_iterator next, F level) const {
        if (next == z_.begin()) return 0;
        if (next == z_.end()) return static_cast<F>(z_.size() - 1);
        const F above = *(next - 1), below = *next;
        return static_cast<F>(next - z_.begin() - 1) + std::clamp((above - level) / (above - below), F(0), F(1));
    }
    const std::vector<F>& z_;
};

/// Place where the curve falls least over \p width places: the first of those that agree to 1e-12 of its range.
template <Real F>
[[nodiscard]] F flattest_place(const std::vector<F>& z, F width) {
    const FallingCurve<F> curve(z);
    const std::size_t steps = static_cast<std::size_t>(width);
    const F part = width - static_cast<F>(steps), last = static_cast<F>(z.size() - 1) - width;
    // the fall is piecewise linear in its place: its minimum is where one of its ends is at a height
    const auto visit = [&](const auto& use) {
        for (std::size_t i = 0; static_cast<F>(i) <= last; ++i) {
            if (use(static_cast<F>(i), z[i] - curve.at(static_cast<F>(i) + width))) return;
            const F place = static_cast<F>(i + 1) - part;
            if (place <= last && use(place, curve.at(place) - z[i + steps + 1])) return;
        }
    };
    F least = z.front() - z.back(), flattest = 0;
    const F same = (z.front() - z.back()) * tie<F>;
    visit([&](F, F fall) {
        least = (std::min)(least, fall);
        return false;
    });
    visit([&](F place, F fall) {
        flattest = place;
        return fall <= least + same;
    });
    return flattest;
}

template <Real T>
MaterialRatio<T> material_ratio(std::span<const T> heights) {
    std::vector<double> z;
    z.reserve(heights.size());
    for (const T height : heights)
        if (!std::isnan(height)) z.push_back(static_cast<double>(height));
    require(z.size() >= 16, "heights of a material ratio curve", z.size(), "at least 16");
    math::sort_falling<double>(z, [](double height) { return height; });
    require(z.front() > z.back() && std::isfinite(z.front() - z.back()),
            "heights of a material ratio curve, all of them", static_cast<T>(z.front()),
            "finite and of varying height");
    const double datum = z[z.size() / 2], scale = z.front() - z.back(), places = static_cast<double>(z.size() - 1);
    for (double& height : z) height = (height - datum) / scale;

    const FallingCurve<double> curve(z);
    const double width = 2.0 / 5 * places, from = flattest_place(z, width), to = (std::min)(from + width, places);
    const double middle = (from + to) / 2;
    math::CompensatedSum<double> area, moment;
    curve.visit(from, to, [&](double a, double b, double za, double zb) {
        const double part = b - a, mean = (za + zb) / 2;
        area.add(part * mean);
        moment.add(part * (mean * ((a + b) / 2 - middle) + (zb - za) * part / 12));
    });
    const double slope = (std::min)(0.0, 12 * moment.value() / (width * width * width));  // of z per place
    const double upper = area.value() / width - slope * middle, lower = upper + slope * places;
    const double first = curve.first_at_or_below(upper), second = curve.first_below(lower);
    MaterialRatio<T> result;
    result.core_height = static_cast<T>((upper - lower) * scale);
    result.peak_share = static_cast<T>(first / places);
    result.core_and_peak_share = static_cast<T>(second / places);
    if (first > 0) result.reduced_peak_height = static_cast<T>(2 * curve.area_above(upper, 0, first) / first * scale);
    if (second < places)
        result.reduced_valley_depth =
            static_cast<T>(-2 * curve.area_above(lower, second, places) / (places - second) * scale);
    return result;
}

}  // namespace fstiff::inline v0_1::detail

// Bearing curves from few numbers: Sk, Spk, Svk, Smr1, Smr2 (three lines), or skewness and kurtosis (Johnson).
//
//     core     zeta_2 = Phi^-1(1 - Smr2) to zeta_1 = Phi^-1(1 - Smr1), rise Sk
//     tails    int_0^Smr1 (f - u) dt = Spk Smr1/2:  slope Spk Smr1/2/(phi(zeta_1) - zeta_1 Smr1); the same below
//     Johnson  f = sinh((zeta + c)/w) (S_U)  or  f = 1/(1 + exp(-(zeta + c)/w)) (S_B), scaled to mean 0 and rms 1
//
// S_U for a kurtosis above that of a lognormal of this skewness, S_B below it; both numbers are matched exactly.
// Derivation  docs/theory-surface.md
// Reference   ISO 25178-2:2021 (Sk ...); Johnson, Biometrika 36 (1949) 149 (S_U, S_B)
// Units       heights in any unit; skewness and kurtosis dimensionless, the latter 3 for a Gaussian
// Valid       Sk > 0, Spk, Svk >= 0, 0 <= Smr1 < Smr2 <= 1; |skewness| <= 3, least_kurtosis() <= kurtosis <= 100
// Accuracy    areas and moments 1e-8 over knots 1/128 apart in zeta, from -8 to 8
//             (tests/surface/bearing_family_test.cpp)

namespace fstiff::inline v0_1::detail {

/// Curve with the upper end of the core at height u = 0. \throws domain_error naming the parameter out of range.
template <Real T>
[[nodiscard]] BearingSlope<T> bearing_of_core(const MaterialRatio<T>& core) {
    require_positive("Sk", core.core_height);
    require(core.reduced_peak_height >= 0, "Spk", core.reduced_peak_height, "0 or more");
    require(core.reduced_valley_depth >= 0, "Svk", core.reduced_valley_depth, "0 or more");
    const T first = core.peak_share, second = core.core_and_peak_share, end = 8;
    require(first >= 0 && first < second && second <= 1, "Smr1", first, "from 0 to below Smr2, which is 1 at most");
    // slope of a tail of the share s beyond |zeta| = z with the area h s/2
    const auto tail = [](T height, T share, T z) { return height * share / 2 / (math::normal_density(z) - z * share); };
    std::vector<typename BearingSlope<T>::Knot> knots;
    const bool peaks = first > 0 && core.reduced_peak_height > 0, valleys = second < 1 && core.reduced_valley_depth > 0;
    const T upper = first > 0 ? math::normal_quantile(1 - first) : T(4),
            lower = second < 1 ? math::normal_quantile(1 - second) : T(-4);
    if (valleys)
        knots.push_back(
            {-end, -core.core_height - tail(core.reduced_valley_depth, 1 - second, -lower) * (lower + end)});
    knots.push_back({lower, -core.core_height});
    knots.push_back({upper, T(0)});
    if (peaks) knots.push_back({end, tail(core.reduced_peak_height, first, upper) * (end - upper)});
    return BearingSlope<T>(std::move(knots));
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
[[nodiscard]] std::array<T, 4> normal_moments(const BearingSlope<T>& curve) {
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
[[nodiscard]] BearingSlope<T> bearing_of_moments(T skewness, std::type_identity_t<T> kurtosis) {
    require(std::abs(skewness) <= most_skewness<T>, "skewness", skewness, "between -3 and 3");
    require(kurtosis >= least_kurtosis(skewness) && kurtosis <= most_kurtosis<T>, "kurtosis", kurtosis,
            "from skewness^2 + 1.25, and more beyond a skewness of 1.5, to 100");
    const T end = 8;
    const T sign = skewness < 0 ? T(-1) : T(1);
    const auto knots_of = [&](const auto& f) {
        const auto m = normal_moments<T>(f);
        std::vector<typename BearingSlope<T>::Knot> knots;
        for (int i = -1024; i <= 1024; ++i) {
            const T zeta = end * T(i) / 1024, height = sign * (f(sign * zeta) - m[0]) / std::sqrt(m[1]);
            if (knots.empty() || height > knots.back().height + T(1e-12)) knots.push_back({zeta, height});
        }
        return BearingSlope<T>(std::move(knots));
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

}  // namespace fstiff::inline v0_1::detail
