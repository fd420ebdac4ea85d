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
#include <fstiff/surface/material_ratio_curve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

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

}}}  // namespace fstiff::detail
