// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The parts of a band of K: errors of the measurement, choice of lambda_s, choice of the window of D.
///
///     low = K exp(-hypot(e_low, s_low)),  high = K exp(hypot(e_high, s_high))
///
/// e_low and e_high are the ends of the band over the errors, as ln(end/K); s_low and s_high the least and the greatest
/// ln(K of a neighbour/K), 0 where no neighbour lies on that side.
///
/// Reference   the sum by squares is that of independent errors (JCGM 100:2008, 5.1.2), in logarithms
/// Units       K [Pa/m], widths in ln K
/// Valid       K and the ends of the band greater than 0; what is no stiffness among the neighbours is left out
/// Accuracy    rounding (tests/measured/widened_band_test.cpp)

#include <fstiff/math/statistics.hpp>
#include <fstiff/measured/sampled_band.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

namespace fstiff::parts {

/// How many times K of a face with a lay may exceed that of an isotropic one with the statistics of a profile across
/// it: boundary elements of three turned faces gave 10 to 18 at p* of 1e-4 to 1e-2.
inline constexpr double lay_factor = 20;

/// The parts of a band, as ln(K/value): low ones at most 0, high ones at least 0.
template <Real T = double>
struct BandParts {
    T errors_low{}, errors_high{};  ///< of the errors of the measurement
    T scale_low{}, scale_high{};    ///< of the neighbours with another lambda_s
    T window_low{}, window_high{};  ///< of the choice of the window of D: a share of the errors
};

/// The least and the greatest ln(other/value) of \p others into \p low and \p high; what is no stiffness is left out.
template <Real T>
void spread_of(std::type_identity_t<T> value, std::span<const T> others, T& low, T& high) {
    for (const T other : others) {
        const T change = std::log(other / value);
        if (!std::isfinite(change)) continue;
        low = (std::min)(low, change);
        high = (std::max)(high, change);
    }
}

/// Widens \p band of the stiffness \p value by the spread to the neighbours \p others. A band of no surface stays 0.
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

/// Widens \p band for a profile with a lay.
template <Real T>
void widen_by_lay(SampledBand<T>& band) {
    band.high = (std::min)(static_cast<T>(lay_factor) * band.high, (std::numeric_limits<T>::max)() / 2);
}

/// D greater and smaller by what the choice of its window of lags leaves open: 5 % and 95 %, within (1, 2).
template <Real T>
[[nodiscard]] std::array<T, 2> dimensions_of_other_windows(T dimension, T window_error) {
    const T away = math::normal_95<T>.value * window_error;
    return {std::clamp(dimension - away, T(1.001), T(1.999)), std::clamp(dimension + away, T(1.001), T(1.999))};
}

}  // namespace fstiff::parts
