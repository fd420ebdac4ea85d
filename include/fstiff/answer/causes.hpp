// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The causes of the band of K.
///
///     const auto band = band_of(causes);     K exp(band.low), K exp(band.high): 5 and 95 %
///
///     band     low = -sqrt(sum low_i^2), high = sqrt(sum high_i^2) over the causes i, in ln K
///
/// Reference   sum by squares: independent errors (JCGM 100:2008, 5.1.2), in logarithms; docs/accuracy.md
/// Units       ln K
/// Accuracy    of the causes (tests/answer/causes_test.cpp)

#include <fstiff/core/numbers.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace fstiff { inline namespace v0_1 {

/// Ends of a band, the part of one cause or the error of a law, as ln of K over the value: 5 and 95 %, low at most 0,
/// high at least 0.
template <Real T = double>
struct CauseSpread {
    T low{}, high{};
};

/// Causes of a K that differs from the printed one.
enum class Cause {
    measurement,  ///< errors of the measured parameters: another piece of the same surface
    cut_offs,     ///< choice of lambda_s and of the form
    shape,        ///< shape of the heights, which the measurement does not show
    prior,        ///< parameters that were not measured
    lay,          ///< a profile does not show the length of ridges
    law,          ///< the law by itself
    contacts,     ///< few contacts on the nominal area
    long_waves,   ///< waves longer than the measured piece
    hardness,     ///< of the softer body, which is not known
    noise,        ///< of the instrument that measured a map
    form          ///< faces that are not flat
};

namespace detail {

inline constexpr std::size_t cause_count = 11;

}  // namespace detail

/// One spread for each Cause.
template <Real T = double>
using Causes = std::array<CauseSpread<T>, detail::cause_count>;

/// The word of \p cause, as JSON has it.
[[nodiscard]] constexpr std::string_view name_of(Cause cause) {
    constexpr std::array<std::string_view, detail::cause_count> names{
        "measurement", "cut_offs",   "shape",    "prior", "lay", "law",
        "contacts",    "long_waves", "hardness", "noise", "form"};
    return names[static_cast<std::size_t>(cause)];
}

namespace detail {

/// The whole of \p causes.
template <Real T>
[[nodiscard]] CauseSpread<T> band_of(const Causes<T>& causes) {
    CauseSpread<T> total;
    for (const CauseSpread<T>& cause : causes) {
        total.low = -std::hypot(total.low, cause.low);
        total.high = std::hypot(total.high, cause.high);
    }
    return total;
}

/// The ends \p low and \p high of the band of \p value with one cause more, \p spread of ln value, by squares.
template <Real T>
[[nodiscard]] std::pair<T, T> widened(T value, T low, T high, const CauseSpread<T>& spread) {
    return {value * std::exp(-std::hypot(std::log(value / low), spread.low)),
            value * std::exp(std::hypot(std::log(high / value), spread.high))};
}

/// Of waves that lower ln K by up to \p growth, where \p expected is taken: from none of them to all.
template <Real T>
[[nodiscard]] CauseSpread<T> spread_of_long_waves(T growth, T expected) {
    return {-(std::max)(growth - expected, expected), expected};
}

}  // namespace detail

/// The share that each of \p causes has of the band, by squares; they add up to 1, or are 0 where there is no band.
template <Real T>
[[nodiscard]] std::array<T, detail::cause_count> shares_of(const Causes<T>& causes) {
    std::array<T, detail::cause_count> shares{};
    T total = 0;
    for (std::size_t i = 0; i < detail::cause_count; ++i)
        total += shares[i] = causes[i].low * causes[i].low + causes[i].high * causes[i].high;
    if (total > T(0))
        for (T& share : shares) share /= total;
    return shares;
}

}}  // namespace fstiff
