// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What the removal of a form takes of the structure function.
///
/// A line or a parabola that is fitted takes long waves of the roughness along: S of a self-affine profile without its line
/// is low by a tenth and more at a tenth of the length, the more the smoother it is, and D would come out high, by 0.04 at
/// D = 1.2. The mean loss is known: the covariance -|i-j|^p/2 of the points of a coarse profile, without its share in the
/// polynomials, gives S after the removal; the loss goes as n^(2-p) times a smooth function of n, which is interpolated.
///
/// Valid       0 < p < 2
/// Accuracy    the loss within 3 % of itself and 1e-4 (tests/profile/form_loss_test.cpp)

#include <fstiff/profile/detrend.hpp>
#include <fstiff/profile/lag_window.hpp>

namespace fstiff::detail {

/// ln of the share of S that remains in the mean, at the lags \p step, when the \p form of a self-affine profile whose S
/// grows as n^\p power is removed.
template <Real T>
Vector<T> log_retained(const std::vector<std::size_t>& step, std::size_t points, T power, Form form) {
    using Eigen::Index;
    Vector<T> retained = Vector<T>::Zero(static_cast<Index>(step.size()));
    if (form == Form::none || form == Form::mean) return retained;  // differences do not see the mean
    constexpr Index size = 96;
    Matrix<T> covariance(size, size), basis(size, static_cast<Index>(coefficients(form)));
    for (Index i = 0; i < size; ++i) {
        for (Index j = 0; j < size; ++j)
            covariance(i, j) = i == j ? T(0) : -std::pow(std::abs(static_cast<T>(i - j)), power) / 2;
        const T u = 2 * static_cast<T>(i) / static_cast<T>(size - 1) - 1;
        for (Index k = 0; k < basis.cols(); ++k) basis(i, k) = std::pow(u, static_cast<T>(k));
    }
    for (Index k = 0; k < basis.cols(); ++k) {  // made orthonormal, then covariance (1 - q q^T) from both sides
        for (Index other = 0; other < k; ++other) basis.col(k) -= basis.col(other).dot(basis.col(k)) * basis.col(other);
        const Vector<T> q = basis.col(k) / basis.col(k).norm();
        basis.col(k) = q;
        Vector<T> share(size);
        for (Index j = 0; j < size; ++j) share[j] = covariance.col(j).dot(q);
        share -= share.dot(q) / 2 * q;
        for (Index j = 0; j < size; ++j) covariance.col(j) -= share[j] * q + q[j] * share;
    }
    const auto loss = [&](Index m) {  // over m^(2-p)
        T sum = 0;
        for (Index i = 0; i + m < size; ++i)
            sum += covariance(i, i) + covariance(i + m, i + m) - 2 * covariance(i, i + m);
        const T lag = static_cast<T>(m);
        return (1 - sum / static_cast<T>(size - m) / std::pow(lag, power)) / std::pow(lag, 2 - power);
    };
    Vector<T> losses(size / 2);
    for (Index m = 1; m <= losses.size(); ++m) losses[m - 1] = loss(m);
    for (Index k = 0; k < retained.size(); ++k) {
        const T lag = static_cast<T>(step[static_cast<std::size_t>(k)]) * static_cast<T>(size) / static_cast<T>(points);
        const T place = std::clamp(lag, T(1), static_cast<T>(losses.size())) - 1;
        const Index below = std::min(static_cast<Index>(place), losses.size() - 2);
        const T share = place - static_cast<T>(below);
        const T lost = (losses[below] * (1 - share) + losses[below + 1] * share) * std::pow(lag, 2 - power);
        retained[k] = std::log(std::max(T(0.05), 1 - lost));
    }
    return retained;
}

}  // namespace fstiff::detail
