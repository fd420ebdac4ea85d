// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How the values of a structure function scatter, and with one another: as theory says, and as the profile shows.
///
///     Cov(S_n, S_m) = 2/(N_n N_m) sum over pairs of Cov(increment n at i, increment m at j)^2,
///     Cov = (|d+s|^p + |d-s|^p - |d+t|^p - |d-t|^p)/2,   d distance of the centres, s = (n+m)/2, t = (n-m)/2
///
/// of a Gaussian profile whose S grows as n^p. The sum over d takes every sample where an increment is short, and strides
/// of an eighth of it or of d elsewhere. What is not Gaussian is seen by resamples: a pair belongs to the cell in which it
/// begins, and a resample is made of blocks of neighbouring cells.
///
/// Units       ln S in any unit
/// Valid       lags rising, 0 < p < 2
/// Accuracy    0.2 % of the sum over all pairs where the shorter lag is below 16 samples; 6 % beyond, at p = 0.4, less the
///             larger p (tests/profile/structure_errors_test.cpp)

#include <fstiff/core/progress.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/lag_window.hpp>

namespace fstiff::detail {

/// Covariance of ln S at the lags \p step of a Gaussian profile of \p points whose S grows as n^\p power.
template <Real T>
Matrix<T> log_covariance(const std::vector<std::size_t>& step, const std::vector<std::size_t>& pairs,
                         std::size_t points, T power) {
    std::vector<T> powers(4 * points + 4);  // of half samples
    for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = std::pow(static_cast<T>(k) / 2, power);
    const auto at = [&](std::size_t halves) { return powers[std::min(halves, powers.size() - 1)]; };
    const auto distance = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    const auto size = static_cast<Eigen::Index>(step.size());
    Matrix<T> covariance(size, size);
    for (Eigen::Index row = 0; row < size; ++row)
        for (Eigen::Index column = 0; column <= row; ++column) {
            const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
            const std::size_t n = step[i], m = step[j];  // n >= m
            const std::size_t all_n = points - n, all_m = points - m;
            const std::size_t s = n + m, t = n - m;  // halves, like every distance below
            T sum = 0;
            for (std::size_t d = s % 2; d < 2 * points;) {
                const std::size_t reach = std::max(m / 8, d > 4 * s ? d / 16 : 0);
                const std::size_t stride = std::max<std::size_t>(1, reach);  // samples
                const std::size_t centre = d + (stride - 1);                 // of the cell [d, d + 2 stride)
                const T overlap =
                    std::min(static_cast<T>(all_n), static_cast<T>(points) - static_cast<T>(s + centre) / 2);
                if (overlap <= T(0)) break;
                const T c = (at(centre + s) + at(distance(centre, s)) - at(centre + t) - at(distance(centre, t))) / 2;
                // distances count on both sides, but zero counts once
                const T count = 2 * static_cast<T>(stride) - (d == 0 ? T(1) : T(0));
                sum += count * overlap * c * c;
                d += 2 * stride;
            }
            const T missing = std::sqrt(static_cast<T>(all_n) / static_cast<T>(pairs[i]) * static_cast<T>(all_m) /
                                        static_cast<T>(pairs[j]));
            const T value = 2 * sum * missing / (static_cast<T>(all_n) * static_cast<T>(all_m) * at(2 * n) * at(2 * m));
            covariance(row, column) = covariance(column, row) = value;
        }
    return covariance;
}

/// ln S of moving-block resamples of the profile: steps by rows, resamples by columns.
template <Real T>
Matrix<T> bootstrap_log_structure(const Profile<T>& profile, const std::vector<std::size_t>& step, int resamples,
                                  std::uint64_t seed, const ProgressHook& progress) {
    constexpr std::size_t cells_wanted = 256;
    const std::vector<T>& z = profile.heights;
    const std::size_t cell = std::max<std::size_t>(1, z.size() / cells_wanted);
    const std::size_t cells = (z.size() + cell - 1) / cell;
    // twice the longest lag, so that what a block holds is nearly independent of its neighbours
    const std::size_t block = std::min(cells - 1, 2 * step.back() / cell + 1);
    BlockBootstrap<T> bootstrap(cells, block, static_cast<std::size_t>(resamples), seed);
    const T scale = height_scale(profile);
    Matrix<T> resampled(static_cast<Eigen::Index>(step.size()), resamples);
    for (std::size_t k = 0; k < step.size(); ++k) {
        if (progress) progress("bootstrap", k, step.size());
        const std::size_t n = step[k];
        const std::vector<T>& means = bootstrap.means([&](std::size_t c) {
            T sum = 0, count = 0;
            const std::size_t end = std::min((c + 1) * cell, z.size() - n);
            for (std::size_t i = c * cell; i < end; ++i) {
                const T difference = (z[i + n] - z[i]) / scale;
                if (std::isnan(difference)) continue;
                sum += difference * difference;
                ++count;
            }
            return std::pair{sum, count};
        });
        for (int r = 0; r < resamples; ++r)
            resampled(static_cast<Eigen::Index>(k), r) = std::log(means[static_cast<std::size_t>(r)]);
    }
    return resampled;
}

/// Standard deviation of row * y for values y of this covariance.
template <Real T>
T expected_spread(const Vector<T>& row, const Matrix<T>& covariance) {
    return std::sqrt(std::max(T(0), row.dot(covariance.lazyProduct(row))));
}

/// Standard deviation of row * column over the columns of \p samples.
template <Real T>
T sample_spread(const Vector<T>& row, const Matrix<T>& samples) {
    const Vector<T> values = samples.transpose().lazyProduct(row);
    const T variance =
        (values.array() - values.mean()).square().sum() / static_cast<T>(std::max<Eigen::Index>(1, values.size() - 1));
    return std::sqrt(variance);
}

}  // namespace fstiff::detail
