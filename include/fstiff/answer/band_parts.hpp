// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parts of a band of K: errors of the measurement, choice of lambda_s, choice of the window of D, and unknown
/// properties of the surface. answer() makes the band of them.
///
///     low = K exp(-hypot(e_low, s_low, u_low)),  high = K exp(hypot(e_high, s_high, u_high)),  u^2 = sum of u_i^2
///
/// e_low and e_high are the ends of the band over the errors, as ln(end/K). s_low and s_high are the minimum and the
/// maximum of ln(K of a neighbour/K), 0 where no neighbour lies on that side. u_i is the same for surfaces with one
/// unknown at its 5 % and at its 95 % quantile. To first order u is the width over surfaces that draw all unknowns.
///
/// Reference   independent errors add as squares (JCGM 100:2008, 5.1.2), here in logarithms; surface/process_prior.hpp
/// Units       K [Pa/m], widths in ln K
/// Valid       K and the ends of the band greater than 0; neighbours without a positive finite stiffness are left out
/// Accuracy    rounding (tests/answer/band_parts_test.cpp)

#include <fstiff/answer/band.hpp>
#include <fstiff/math/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Factor by which K of a face with a lay may exceed that of an isotropic face with the statistics of a profile across
/// the lay: boundary elements of three turned faces gave 10 to 18 at p* of 1e-4 to 1e-2.
inline constexpr double lay_factor = 20;

/// One part of a band as ln(K/value): low <= 0 <= high.
template <Real T = double>
struct BandPart {
    T low{}, high{};
};

/// All parts of a band as ln(K/value): low <= 0 <= high.
template <Real T = double>
struct BandParts {
    T errors_low{}, errors_high{};                        ///< of the errors of the measurement
    T scale_low{}, scale_high{};                          ///< of the neighbours with another lambda_s
    T window_low{}, window_high{};                        ///< of the choice of the window of D: a share of the errors
    T prior_low{}, prior_high{};                          ///< of the unknowns, except the shape
    T shape_low{}, shape_high{};                          ///< of the shape of the heights: skewness and kurtosis
    std::array<BandPart<T>, unknown_count> of_unknown{};  ///< parts of these two and of the hardness, as Unknown

    [[nodiscard]] const BandPart<T>& part_of(Unknown unknown) const {
        return of_unknown[static_cast<std::size_t>(unknown)];
    }
};

/// K of the surfaces that have one unknown at its 5 % and at its 95 % quantile, over K, at every point.
template <Real T = double>
struct UnknownCurves {
    Unknown which{};
    std::vector<T> low, high;
};

/// Extends \p low and \p high by the ln(other/value) of \p others; values that are no stiffness are left out.
template <Real T>
void spread_of(std::type_identity_t<T> value, std::span<const T> others, T& low, T& high) {
    for (const T other : others) {
        const T change = std::log(other / value);
        if (!std::isfinite(change)) continue;
        low = (std::min)(low, change);
        high = (std::max)(high, change);
    }
}

/// Widens \p band of the stiffness \p value by the spread to the neighbours \p others. A band of 0 surfaces stays 0.
template <Real T>
BandParts<T> widen(SampledBand<T>& band, std::type_identity_t<T> value, std::span<const T> others) {
    BandParts<T> parts;
    if (!(band.low > T(0))) return parts;
    parts.errors_low = (std::min)(T(0), std::log(band.low / value));
    parts.errors_high = (std::max)(T(0), std::log(band.high / value));
    spread_of(value, others, parts.scale_low, parts.scale_high);
    band.low *= std::exp(-(std::hypot(parts.errors_low, parts.scale_low) + parts.errors_low));
    band.high *= std::exp(std::hypot(parts.errors_high, parts.scale_high) - parts.errors_high);
    band.high = (std::min)(band.high, (std::numeric_limits<T>::max)() / 2);  // as in_range() of a state
    return parts;
}

/// Widens \p band by the unknowns, with \p curves at the place \p point, and records the widths in \p parts. For two
/// faces an unknown may occur twice.
template <Real T>
void widen(SampledBand<T>& band, BandParts<T>& parts, std::span<const UnknownCurves<T>> curves, std::size_t point) {
    for (const UnknownCurves<T>& curve : curves) {
        const std::array<T, 2> ratios{curve.low[point], curve.high[point]};
        BandPart<T> part;
        spread_of(T(1), std::span<const T>(ratios), part.low, part.high);
        BandPart<T>& sum = parts.of_unknown[static_cast<std::size_t>(curve.which)];
        sum = {-std::hypot(sum.low, part.low), std::hypot(sum.high, part.high)};
    }
    for (std::size_t i = 0; i < unknown_count; ++i) {
        if (static_cast<Unknown>(i) == Unknown::hardness) continue;
        const bool shape = is_of_shape(static_cast<Unknown>(i));
        T &low = shape ? parts.shape_low : parts.prior_low, &high = shape ? parts.shape_high : parts.prior_high;
        low = -std::hypot(low, parts.of_unknown[i].low), high = std::hypot(high, parts.of_unknown[i].high);
    }
    const auto& [soft, hard] = parts.part_of(Unknown::hardness);
    const T known_low = std::hypot(parts.errors_low, parts.scale_low),
            known_high = std::hypot(parts.errors_high, parts.scale_high),
            low = std::hypot(std::hypot(known_low, soft), parts.prior_low, parts.shape_low),
            high = std::hypot(std::hypot(known_high, hard), parts.prior_high, parts.shape_high);
    band.low *= std::exp(known_low - low), band.high *= std::exp(high - known_high);
    band.high = (std::min)(band.high, (std::numeric_limits<T>::max)() / 2);
}

/// Widens \p band for a profile with a lay.
template <Real T>
void widen_by_lay(SampledBand<T>& band) {
    band.high = (std::min)(static_cast<T>(lay_factor) * band.high, (std::numeric_limits<T>::max)() / 2);
}

/// 5 % and 95 % quantiles of D, within (1, 2), over the choice of the window of lags.
template <Real T>
[[nodiscard]] std::array<T, 2> dimensions_of_other_windows(T dimension, T window_error) {
    const T away = math::normal_95<T>.value * window_error;
    return {std::clamp(dimension - away, T(1.001), T(1.999)), std::clamp(dimension + away, T(1.001), T(1.999))};
}

/// K of a measured surface at one pressure, with its band.
template <Real T = double>
struct WidenedBand {
    T stiffness{};  ///< of the surface as measured [Pa/m]; NaN where it has none
    SampledBand<T> band;
    BandParts<T> parts;
};

/// Widens \p band of \p stiffness by the neighbours and by the lay of a profile. \p of_neighbours and \p of_windows (of
/// D) are curves of K over many points, used at \p point and times \p factor; \p of_unknowns are relative to K.
template <Real T>
[[nodiscard]] WidenedBand<T> widened(T stiffness, const SampledBand<T>& band,
                                     const std::vector<std::vector<T>>& of_neighbours,
                                     const std::vector<std::vector<T>>& of_windows, std::size_t point,
                                     bool has_lay = false, T factor = T(1),
                                     const std::vector<UnknownCurves<T>>& of_unknowns = {}) {
    const auto at_point = [&](const std::vector<std::vector<T>>& curves) {
        std::vector<T> stiffnesses;
        for (const auto& curve : curves) stiffnesses.push_back(curve[point] * factor);
        return stiffnesses;
    };
    WidenedBand<T> result{stiffness, band, {}};
    const std::vector<T> neighbours = at_point(of_neighbours), windows = at_point(of_windows);
    if (!neighbours.empty() || !of_unknowns.empty())
        result.parts = widen(result.band, stiffness, std::span<const T>(neighbours));
    if (!of_unknowns.empty()) widen(result.band, result.parts, std::span<const UnknownCurves<T>>(of_unknowns), point);
    spread_of(stiffness, std::span<const T>(windows), result.parts.window_low, result.parts.window_high);
    if (has_lay) widen_by_lay(result.band);
    return result;
}

}}}  // namespace fstiff::detail
