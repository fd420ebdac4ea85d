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
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/height_sums.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

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

}}}  // namespace fstiff::detail
