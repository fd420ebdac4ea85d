// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Covariance of the structure function of second differences, in closed form and by resampling.
///
///     Cov(ln S2_n, ln S2_m) = 4 pi / sqrt(M_n M_m) int W_n W_m C^2 dq / (V_n V_m),  q from -pi to pi
///     W_n(q) = 4 (1 - cos q n)^2,  V_n = int W_n C dq,  M_n triples of n
///     C(q) = sum over all whole k of |q + 2 pi k|^-(1+p)                             the spectrum, sampled
///
/// for a long Gaussian profile whose S grows as n^p; a sum over 48 wave numbers an octave, positive despite rounding.
/// Resamples are blocks of neighbouring cells; a triple belongs to the cell of its centre.
///
/// Units       ln S2 in any unit
/// Valid       lags rising, 0 < p < 2
/// Accuracy    5 % of the sum over all pairs of a profile of 20 lags and more (tests/profile/structure_errors_test.cpp)

#include <fstiff/core/progress.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/lag_window.hpp>

#include <numbers>

namespace fstiff::inline v0_1::parts {

/// Covariance of ln S2 at the lags \p step, with \p triples each, for a Gaussian profile whose S grows as n^\p power.
template <Real T>
Matrix<T> log_covariance(const std::vector<std::size_t>& step, const std::vector<std::size_t>& triples, T power) {
    constexpr int per_octave = 48;
    const T pi = std::numbers::pi_v<T>, turn = 2 * pi;
    const auto longest = static_cast<T>(step.back());
    const auto nodes = static_cast<Eigen::Index>(per_octave * std::log2(10 * pi * longest)) + 1;
    const auto size = static_cast<Eigen::Index>(step.size());
    Matrix<T> shares(size, nodes);  // W_n C sqrt(dq)
    Vector<T> means = Vector<T>::Zero(size);
    for (Eigen::Index node = 0; node < nodes; ++node) {
        const T q = pi * std::exp2(-(static_cast<T>(node) + T(0.5)) / per_octave);
        const T width = q * std::log(T(2)) / per_octave;
        T spectrum = std::pow(q, -1 - power) + 2 * std::pow(turn, -1 - power) * std::pow(T(3.5), -power) / power;
        for (const int k : {1, 2, 3})
            spectrum +=
                std::pow(static_cast<T>(k) * turn - q, -1 - power) + std::pow(static_cast<T>(k) * turn + q, -1 - power);
        for (Eigen::Index row = 0; row < size; ++row) {
            const T wave = 1 - std::cos(q * static_cast<T>(step[static_cast<std::size_t>(row)]));
            shares(row, node) = 4 * wave * wave * spectrum * std::sqrt(width);
            means[row] += shares(row, node) * std::sqrt(width);
        }
    }
    for (Eigen::Index row = 0; row < size; ++row) {
        const auto n = static_cast<std::size_t>(row);
        // both halves of the spectrum: V twice, the integral twice; at least one value for a lag
        const T triples_of_it = (std::max)(static_cast<T>(triples[n]), T(1));
        shares.row(row) *= std::sqrt(turn / triples_of_it) / means[row];
    }
    Matrix<T> covariance(size, size);
    const Matrix<T> columns = shares.transpose();
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j <= i; ++j) covariance(i, j) = covariance(j, i) = columns.col(i).dot(columns.col(j));
    return covariance;
}

/// ln S2 of moving-block resamples of the profile: steps by rows, resamples by columns.
template <Real T>
Matrix<T> bootstrap_log_structure(const Profile<T>& profile, const std::vector<std::size_t>& step, int resamples,
                                  std::uint64_t seed, const ProgressHook& progress) {
    constexpr std::size_t cells_wanted = 256;
    const std::vector<T>& z = profile.heights;
    const std::size_t cell = std::max<std::size_t>(1, z.size() / cells_wanted);
    const std::size_t cells = (z.size() + cell - 1) / cell;
    // four times the longest lag, so that blocks are nearly independent of their neighbours
    const std::size_t block =
        std::clamp<std::size_t>(4 * step.back() / cell + 1, 1, std::max<std::size_t>(1, cells / 4));
    math::BlockBootstrap<T> bootstrap(cells, block, static_cast<std::size_t>(resamples), seed);
    const T scale = 2 * height_scale(profile);
    Matrix<T> resampled(static_cast<Eigen::Index>(step.size()), resamples);
    for (std::size_t k = 0; k < step.size(); ++k) {
        if (progress) progress("bootstrap", k, step.size());
        const std::size_t n = step[k];
        const std::vector<T>& means = bootstrap.means([&](std::size_t c) {
            T sum = 0, count = 0;
            const std::size_t end = (std::min)((c + 1) * cell, z.size() - n);
            for (std::size_t i = (std::max)(c * cell, n); i < end; ++i) {
                const T difference = (z[i + n] - z[i]) / scale - (z[i] - z[i - n]) / scale;
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
    return std::sqrt((std::max)(T(0), row.dot(covariance.lazyProduct(row))));
}

/// Standard deviation of row * column over the columns of \p samples.
template <Real T>
T sample_spread(const Vector<T>& row, const Matrix<T>& samples) {
    const Vector<T> values = samples.transpose().lazyProduct(row);
    const T variance =
        (values.array() - values.mean()).square().sum() / static_cast<T>(std::max<Eigen::Index>(1, values.size() - 1));
    return std::sqrt(variance);
}

}  // namespace fstiff::inline v0_1::parts
