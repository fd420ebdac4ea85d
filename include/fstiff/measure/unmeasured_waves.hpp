// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Waves longer than a measured piece: growth of sigma for a larger nominal contact.
///
///     w_k      mean square height of a wave of k half periods, 1 < k < 16       measure/long_waves
///     E w_k    A max(k, k_r)^-b, b = 2H + 1 for a profile, 2H + 2 for a map     roll-off at k_r
///     P        posterior probability of k_r <= 1 over H and ln k_r, all A; open = min(1, P/prior)
///     growth   ln(sigma of a contact of side L0/sigma) = open (H ln(L0/L) + (sqrt 2 - 1) 1.645 s (1 - L/L0)), L0 > L;
///              s: error of ln sigma from the long waves
///     L        root of the area of a map; length of a profile over sqrt 2
///
/// Derivation  docs/theory-surface.md; Reference: Sayles, Thomas, Nature 271 (1978) 431; prior: this project
/// Units       lengths [m]; growth, H and shares dimensionless
/// Valid       side >= 0; Gaussian heights, one power law with one roll-off
/// Accuracy    the band of a piece contains sigma of a whole 4 or 8 times as long for 81 to 95 % of pieces without a
///             roll-off, 95 to 100 % with one, H 0.3 to 0.9 (tests/measure/unmeasured_waves_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/measure/long_waves.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Long end of the spectrum of a measured piece.
template <Real T = double>
struct LongEnd {
    T side{};        ///< of the square that has as many waves as the piece [m]; 0: not known
    T hurst{};       ///< H of its long waves
    T open{};        ///< 0 to 1: extent of their power law beyond the piece; 0: the roll-off is measured
    T error{};       ///< of ln sigma, by the scatter of the long waves
    bool law{};      ///< whether H is that of the structure function; else of the long waves alone
    T form_share{};  ///< rms height over sigma of the surface waves that the removal of the form took
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// ln of sigma of the nominal contact over measured sigma, from waves longer than the measurement.
template <Real T = double>
struct UnmeasuredWaves {
    T growth{};       ///< greatest, >= 0
    T expected{};     ///< from 0 to growth: mean over faces whose waves end with the piece and whose waves go on
    bool at_least{};  ///< lower bound: sigma grows by at least this, without a law of the spectrum
};

/// Of the growth by the law of the long end: a piece of a face whose waves end with it looks like one of a face whose
/// waves go on, so that it is less than 1.
template <Real T>
inline constexpr T expected_share = T(0.75);

/// Growth by waves that a contact with the side \p side [m] has and the piece of \p end has not.
template <Real T>
[[nodiscard]] UnmeasuredWaves<T> unmeasured_waves(const LongEnd<T>& end, std::type_identity_t<T> side) {
    if (!(end.side > T(0) && side > end.side)) return {};
    const T scatter = (std::numbers::sqrt2_v<T> - 1) * math::normal_95<T>.value * end.error * (1 - end.side / side);
    const T law = end.open * (end.hurst * std::log(side / end.side)), growth = law + end.open * scatter;
    return {growth, expected_share<T> * law, growth > T(0.01) && !end.law};
}

/// Mean of two ends, \p a and \p b, of surfaces that have \p share and 1 - share of the mean square height or of the
/// size.
template <Real T>
[[nodiscard]] LongEnd<T> mean_of_ends(const LongEnd<T>& a, const LongEnd<T>& b, T share) {
    const auto mean = [share](T x, T y) { return share * x + (1 - share) * y; };
    const T open = mean(a.open, b.open), form_share = mean(a.form_share, b.form_share);
    if (!(a.side > T(0) && b.side > T(0))) {  // what is known of one of them
        const LongEnd<T>& known = a.side > T(0) ? a : b;
        return {known.side, known.hurst, open, known.error, known.law, form_share};
    }
    return {std::exp(mean(std::log(a.side), std::log(b.side))),
            mean(a.hurst, b.hurst),
            open,
            mean(a.error, b.error),
            a.law && b.law,
            form_share};
}

/// Knowledge of H from other sources than the long waves; error 0: none.
template <Real T>
struct PriorHurst {
    T value{}, error{};
};

/// H and open from \p squares, the mean square heights of waves of x and y half periods (columns and rows).
template <Real T, class Squares>
[[nodiscard]] LongEnd<T> long_end(const Squares& squares, const PriorHurst<T>& prior) {
    const bool map = squares.rows() > 1;
    std::vector<T> logs, heights;
    for (Eigen::Index y = 0; y < squares.rows(); ++y)
        for (Eigen::Index x = 0; x < squares.cols(); ++x)
            if (const auto k = static_cast<T>(x * x + y * y); k > T(1) && k < T(256) && squares(y, x) > 0)
                logs.push_back(std::log(k) / 2), heights.push_back(static_cast<T>(squares(y, x)));
    if (logs.empty()) return {};
    T best = -std::numeric_limits<T>::infinity(), total = 0, open = 0, hurst = 0;
    for (int i = 1; i < 20; ++i)
        for (int j = 0; j <= 16; ++j) {
            const T h = T(i) / 20, edge = T(j) * std::numbers::ln2_v<T> / 4;  // ln k_r, to four octaves
            const T b = 2 * h + (map ? 2 : 1), away = prior.error > T(0) ? (h - prior.value) / prior.error : T(0);
            T sum = 0, of_logs = 0;
            for (std::size_t w = 0; w < logs.size(); ++w) {
                const T log = -b * (std::max)(logs[w], edge);
                sum += heights[w] * std::exp(-log), of_logs += log;
            }
            const T likelihood = -(static_cast<T>(logs.size()) * std::log(sum) + of_logs + away * away) / 2;
            if (likelihood > best) {
                const T less = std::exp(best - likelihood);
                total *= less, open *= less, hurst *= less, best = likelihood;
            }
            const bool beyond = j == 0;
            const T weight = (beyond ? 4 : 1) * std::exp(likelihood - best);
            total += weight, hurst += beyond ? weight * h : T(0), open += beyond ? weight : T(0);
        }
    LongEnd<T> end;
    end.hurst = open > T(0) ? hurst / open : prior.value;
    end.open = (std::min)(T(1), 5 * open / total);  // 4 of 4 + 16 weights are the prior
    return end;
}

/// Upper bound of rms height over sigma lost with \p terms of a form that were waves of the surface: each has twice the
/// mean of the waves of fewer than four half periods.
template <Real T, class Squares>
[[nodiscard]] T greatest_form_share(const Squares& squares, int terms) {
    T sum = 0, waves = 0;
    for (Eigen::Index y = 0; y < squares.rows(); ++y)
        for (Eigen::Index x = 0; x < squares.cols(); ++x)
            if (const auto k = x * x + y * y; k > 1 && k < 16) sum += static_cast<T>(squares(y, x)), waves += 1;
    return waves > T(0) ? std::sqrt(2 * static_cast<T>(terms) * sum / waves) : T(0);
}

}}}  // namespace fstiff::detail
