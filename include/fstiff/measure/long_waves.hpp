// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Share of the waves about as long as a measured piece in its mean square height, and the error of sigma from it.
///
///     w_k      mean square height of cos(pi k x/L), for a map cos(pi kx x/Lx) cos(pi ky y/Ly), |k| < 16
///     share    sum w_k / sigma^2
///     V1       = e/(1 - e), e = 2/3 sum w_k^2 / sigma^4     V2 = 2 sum c_k^2 / (sum c_k)^2, c_k = k^-b (map: k^-(b+1))
///     V        = max(V1, min(V2, 4 V1)) for a profile, max(V1, sqrt(V1 min(V2, 4 V1))) for a map, at most 1
///     error    (ln of v over the 5 % point of chi^2 with v degrees of freedom)/(2 1.645), v = 2/V, of ln sigma
///
/// V: relative variance of sigma^2 for a Gaussian process; b gives the measured share: docs/theory-surface.md
/// Reference   Wilson, Hilferty, Proc. Natl. Acad. Sci. 17 (1931) 684 (chi^2); heights in any unit
/// Valid       pieces of at least 16 parts a side; one row for a profile
/// Accuracy    quantile of ln sigma 1 % for v >= 4, 9 % at v = 2; waves of 15 half periods are low by 4 % due to the
///             width of 64 parts (tests/measure/long_waves_test.cpp)

#include <fstiff/math/decompositions.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/height_sums.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// Long waves of a piece.
template <Real T = double>
struct LongWaveShare {
    T share{};  ///< of the mean square height that waves of fewer than 16 half periods have
    T error{};  ///< of ln sigma that comes from them, one standard deviation
    Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic>
        squares{};  ///< w_k over sigma^2, by rows of ky; one row for a profile
};

inline constexpr int long_half_periods = 16;

/// Whether a wave with so many half periods counts as long; the mean and waves of half a period (tilt) do not.
constexpr bool is_long_wave(int x, int y) {
    const int square = x * x + y * y;
    return square > 1 && square < long_half_periods * long_half_periods;
}

/// V of the power law with \p share of its mean square in long waves.
template <Real T>
T variance_of_power_law(T share, bool map) {
    const T edge = long_half_periods - T(0.5);
    T low = T(1.02), high = 8, variance = 0;
    for (int step = 0; step < 40; ++step) {
        const T b = (low + high) / 2;
        T sum = 0, squares = 0;
        for (int y = 0; y < (map ? long_half_periods : 1); ++y)
            for (int x = 0; x < long_half_periods; ++x) {
                if (!is_long_wave(x, y)) continue;
                const T c = std::pow(static_cast<T>(x * x + y * y), -(map ? b + 1 : b) / 2);
                sum += c, squares += c * c;
            }
        const T total = sum + std::pow(edge, 1 - b) / (b - 1) * (map ? std::numbers::pi_v<T> / 2 : T(1));
        variance = 2 * squares / (total * total);
        (sum / total < share ? low : high) = b;
    }
    return variance;
}

/// Long waves from the mean heights of equal \p parts of a piece, relative to its mean, 0 where nothing was measured;
/// \p mean_square is the mean square height.
template <Real T>
LongWaveShare<T> long_waves(const Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic>& parts, T mean_square) {
    constexpr int most = long_half_periods;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    const auto cosines = [&](Eigen::Index points) {
        Matrix values(points, most);
        for (Eigen::Index k = 0; k < most; ++k)
            for (Eigen::Index j = 0; j < points; ++j) {
                const T angle = std::numbers::pi_v<T> * static_cast<T>(k * (2 * j + 1)) / static_cast<T>(2 * points);
                values(j, k) = k < points ? std::cos(angle) * (k > 0 ? std::numbers::sqrt2_v<T> : T(1)) : T(0);
            }
        return values;
    };
    const Matrix down = cosines(parts.rows()), across = cosines(parts.cols());
    Matrix along_columns(most, parts.cols());
    for (Eigen::Index i = 0; i < parts.cols(); ++i)
        for (Eigen::Index k = 0; k < most; ++k)
            along_columns(k, i) = math::dot_in_lanes(&down(0, k), &parts(0, i), parts.rows());
    Matrix amplitude(most, most);
    for (Eigen::Index x = 0; x < most; ++x) {
        const auto waves = math::product(along_columns, &across(0, x), parts.cols());
        for (Eigen::Index y = 0; y < most; ++y) amplitude(y, x) = waves[y] / static_cast<T>(parts.size());
    }
    T heights = 0, squares = 0;
    for (int y = 0; y < most; ++y)
        for (int x = 0; x < most; ++x) {
            if (x * x + y * y == 0 || x * x + y * y >= most * most) continue;
            const T w = amplitude(y, x) * amplitude(y, x) / mean_square;
            heights += w, squares += w * w;
        }
    LongWaveShare<T> result;
    result.share = (std::min)(heights, T(1));
    result.squares.resize(parts.rows() > 1 ? most : 1, most);
    for (Eigen::Index x = 0; x < most; ++x)
        for (Eigen::Index y = 0; y < result.squares.rows(); ++y)
            result.squares(y, x) = amplitude(y, x) * amplitude(y, x) / mean_square;
    const T e = 2 * squares / 3, of_waves = e < T(0.5) ? e / (1 - e) : T(1);
    const bool map = parts.rows() > 1;
    const T of_share = (std::min)(variance_of_power_law(result.share, map), 4 * of_waves);
    const T variance = (std::min)(T(1), (std::max)(of_waves, map ? std::sqrt(of_waves * of_share) : of_share));
    const T z = math::normal_95<T>.value, ninth = variance / 9;  // 2/(9 v)
    result.error = -3 * std::log(1 - ninth - z * std::sqrt(ninth)) / (2 * z);
    return result;
}

/// Long waves of a piece of \p rows by \p columns points; \p height(j, i) is relative to the mean, NaN where missing.
template <Real T, class Height>
LongWaveShare<T> long_waves(Eigen::Index rows, Eigen::Index columns, T mean_square, const Height& height) {
    constexpr Eigen::Index most = 64;  // parts a side
    const Eigen::Index down = (std::min)(rows, most), across = (std::min)(columns, most);
    Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic> parts = decltype(parts)::Zero(down, across);
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i)
            if (const T z = height(j, i); !std::isnan(z)) parts(j * down / rows, i * across / columns) += z;
    const T share = static_cast<T>(parts.size()) / static_cast<T>(rows) / static_cast<T>(columns);
    for (Eigen::Index k = 0; k < parts.size(); ++k) parts.data()[k] *= share;
    return long_waves(parts, mean_square);
}

/// Adds to \p spread the uncertainty that the long \p waves cause in sigma, and in r, which is proportional to 1/sigma.
template <Real T>
void add_long_waves(EstimateSpread<T>& spread, const Estimates<T>& estimate, const LongWaveShare<T>& waves) {
    const T more = std::expm1(waves.error * waves.error) - spread.error[0] * spread.error[0], r = estimate[4];
    if (!(more > T(0) && std::isfinite(r))) return;
    auto covariance = spread.correlation;
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) covariance[i][j] *= spread.error[i] * spread.error[j];
    covariance[0][0] += more;
    covariance[4][4] += r * r * more;
    covariance[0][4] -= r * more, covariance[4][0] -= r * more;
    spread.set(covariance, T(0));
}

}  // namespace fstiff::inline v0_1::detail

// Waves longer than a measured piece: growth of sigma for a larger nominal contact.
//
//     w_k      mean square height of a wave of k half periods, 1 < k < 16       measure/long_waves
//     E w_k    A max(k, k_r)^-b, b = 2H + 1 for a profile, 2H + 2 for a map     roll-off at k_r
//     P        posterior probability of k_r <= 1 over H and ln k_r, all A; open = min(1, P/prior)
//     growth   ln(sigma of a contact of side L0/sigma) = open (H ln(L0/L) + (sqrt 2 - 1) 1.645 s (1 - L/L0)), L0 > L;
//              s: error of ln sigma from the long waves
//     L        root of the area of a map; length of a profile over sqrt 2
//
// Derivation  docs/theory-surface.md; Reference: Sayles, Thomas, Nature 271 (1978) 431; prior: this project
// Units       lengths [m]; growth, H and shares dimensionless
// Valid       side >= 0; Gaussian heights, one power law with one roll-off
// Accuracy    the band of a piece contains sigma of a whole 4 or 8 times as long for 81 to 95 % of pieces without a
//             roll-off, 95 to 100 % with one, H 0.3 to 0.9 (tests/measure/unmeasured_waves_test.cpp)

namespace fstiff::inline v0_1 {

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

}  // namespace fstiff::inline v0_1

namespace fstiff::inline v0_1::detail {

/// ln of sigma of the nominal contact over measured sigma, from waves longer than the measurement.
template <Real T = double>
struct UnmeasuredWaves {
    T growth{};       ///< >= 0
    bool at_least{};  ///< lower bound: sigma grows by at least this, without a law of the spectrum
};

/// Growth by waves that a contact with the side \p side [m] has and the piece of \p end has not.
template <Real T>
[[nodiscard]] UnmeasuredWaves<T> unmeasured_waves(const LongEnd<T>& end, std::type_identity_t<T> side) {
    if (!(end.side > T(0) && side > end.side)) return {};
    const T scatter = (std::numbers::sqrt2_v<T> - 1) * math::normal_95<T>.value * end.error * (1 - end.side / side);
    const T growth = end.open * (end.hurst * std::log(side / end.side) + scatter);
    return {growth, growth > T(0.01) && !end.law};
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

}  // namespace fstiff::inline v0_1::detail
