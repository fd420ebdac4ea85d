// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Quantiles of a computed quantity over the errors of a surface, from surfaces drawn at random.
///
///     x_1 ... x_n  surfaces drawn about the measured one (measure/uncertain_surface)
///     y_k(x_i)     quantity computed for each, for example at the points k of a curve
///     band at k    5, 50 and 95 % quantiles of y_k(x_1) ... y_k(x_n)
///
/// All points use the same surfaces, so that bands of several curves are comparable. A NaN or infinite y_k is left out
/// at point k alone, and counted.
/// Reference   Hyndman, Fan, Am. Stat. 50 (1996) 361, definition 7 (quantile); JCGM 101:2008 (sampling of errors)
/// Units       those of the computed quantity
/// Valid       at least 1 surface
/// Accuracy    5 and 95 % quantiles: 0.11 standard deviations for n = 400 normal values, sqrt(0.05 0.95/n)/0.103
///             (tests/answer/sampled_band_test.cpp); the same seed gives the same band

#include <fstiff/core/parallel.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/uncertain_surface.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// Quantiles of one value over the errors of a surface.
template <Real T = double>
struct SampledBand {
    T low = 0, median = 0, high = 0;  ///< 5, 50 and 95 %; 0 when no surface gives a value
    std::size_t failed = 0;           ///< surfaces that give no value
};

/// Number of surfaces of a band, and their seed.
struct BandOptions {
    std::size_t samples = 400;
    std::uint64_t seed = 2014;
    ProgressHook progress{};  ///< called once a surface, without threads
    ParallelHook parallel{};  ///< of which each surface is a piece
};

/// Computes the bands of the values of \p compute, one for each. \p compute takes a surface as drawn by SurfaceSampler,
/// an array in the order of Parameter, and its number, and returns a vector of values of constant size.
/// \throws domain_error as SurfaceSampler, for 0 samples, and any exception of \p compute.
template <Real T, class Compute>
[[nodiscard]] std::vector<SampledBand<T>> sampled_band(const SurfaceParameters<T>& surface, const Compute& compute,
                                                       const BandOptions& options = {}) {
    require(options.samples >= 1, "samples", options.samples, "at least 1");
    SurfaceSampler<T> draw(surface, options.seed);
    std::vector<std::array<T, surface_parameter_count>> drawn;
    for (std::size_t i = 0; i < options.samples; ++i) drawn.push_back(draw());
    std::vector<std::vector<T>> outcomes(options.samples);  // by surface, value
    run_pieces(options.parallel, options.samples, [&](std::size_t i) {
        if (options.progress && !options.parallel) options.progress("surfaces", i, options.samples);
        outcomes[i] = compute(drawn[i], i);
    });
    const std::size_t count = outcomes.front().size();
    for (const std::vector<T>& values : outcomes)
        if (values.size() != count)
            refuse("values of a drawn surface", values.size(), std::to_string(count) + ", as of the first");
    std::vector<SampledBand<T>> bands;
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<T> values;
        for (const std::vector<T>& of_surface : outcomes)
            if (std::isfinite(of_surface[k])) values.push_back(of_surface[k]);
        SampledBand<T> band;
        band.failed = options.samples - values.size();
        if (!values.empty()) {
            std::sort(values.begin(), values.end());
            const std::span<const T> sorted(values);
            band.low = math::sorted_quantile(sorted, T(0.05));
            band.median = math::sorted_quantile(sorted, T(0.5));
            band.high = math::sorted_quantile(sorted, T(0.95));
        }
        bands.push_back(band);
    }
    return bands;
}

}  // namespace fstiff::inline v0_1::detail

// Parts of a band of K: errors of the measurement, choice of lambda_s, choice of the window of D, and unknown
// properties of the surface. answer() makes the band of them.
//
//     low = K exp(-hypot(e_low, s_low, u_low)),  high = K exp(hypot(e_high, s_high, u_high)),  u^2 = sum of u_i^2
//
// e_low and e_high are the ends of the band over the errors, as ln(end/K). s_low and s_high are the minimum and the
// maximum of ln(K of a neighbour/K), 0 where no neighbour lies on that side. u_i is the same for surfaces with one
// unknown at its 5 % and at its 95 % quantile. To first order u is the width over surfaces that draw all unknowns.
//
// Reference   independent errors add as squares (JCGM 100:2008, 5.1.2), here in logarithms; surface/process_prior.hpp
// Units       K [Pa/m], widths in ln K
// Valid       K and the ends of the band greater than 0; neighbours without a positive finite stiffness are left out
// Accuracy    rounding (tests/answer/band_parts_test.cpp)

namespace fstiff::inline v0_1::detail {

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

}  // namespace fstiff::inline v0_1::detail
