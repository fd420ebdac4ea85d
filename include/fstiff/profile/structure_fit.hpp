// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Straight line through ln S2 over ln n, S2 of second differences, by generalised least squares.
///
///     ln S2(tau) = p ln tau + ln C + ln(4 - 2^p),  p = 4 - 2D                       eq. (2.5)
///                + a tau^-p + b tau^(4-p)                                           ends of the band
///                + harmonics 1, 2 of cos, sin(2 pi ln tau / ln gamma)               log-periodic
///
/// The terms a (waves missing below the resolution) and b (end of the spectrum) have a prior mean and deviation, so
/// that their uncertainty enters the error of D. The log-periodic terms enter where they explain half of the scatter.
///
/// Reference   Buczkowski et al., Arch. Mech. 66 (2014), eq. (2.5); Aitken, Proc. R. Soc. Edinb. 55 (1935) 42
/// Valid       at least 4 lags, 0 < p < 2
/// Accuracy    1e-10 of data that are a line (tests/profile/structure_fit_test.cpp)

#include <fstiff/math/decompositions.hpp>
#include <fstiff/profile/lag_window.hpp>
#include <fstiff/profile/structure_errors.hpp>

#include <numbers>

namespace fstiff::inline v0_1::detail {

/// Missing share of S2 at the first lag when no wave is shorter than that.
template <Real T>
T share_of_short_waves(T power) {
    using std::pow;
    const T pi = std::numbers::pi_v<T>;
    return 6 * std::tgamma(1 + power) * std::sin(pi * power / 2) /
           (pi * power * (4 - pow(T(2), power)) * pow(2 * pi, power));
}

/// Ratio of this share in sections of an isotropic map to that of a profile.
template <Real T>
T share_of_oblique_waves(T power) {
    return std::sqrt(std::numbers::pi_v<T>) * std::tgamma(1 + power / 2) / std::tgamma((1 + power) / 2);
}

/// Lower triangular root L of a = L L^T, which must be positive definite.
template <Real T>
parts::Matrix<T> cholesky(const parts::Matrix<T>& a) {
    parts::Matrix<T> l = parts::Matrix<T>::Zero(a.rows(), a.cols());
    for (Eigen::Index j = 0; j < a.rows(); ++j) {
        T left = a(j, j);
        for (Eigen::Index k = 0; k < j; ++k) left -= l(j, k) * l(j, k);
        l(j, j) = std::sqrt((std::max)(left, a(j, j) * std::numeric_limits<T>::epsilon()));
        for (Eigen::Index i = j + 1; i < a.rows(); ++i) {
            T sum = a(i, j);
            for (Eigen::Index k = 0; k < j; ++k) sum -= l(i, k) * l(j, k);
            l(i, j) = sum / l(j, j);
        }
    }
    return l;
}

/// L^-1 a.
template <Real T>
parts::Matrix<T> forward_substituted(const parts::Matrix<T>& l, parts::Matrix<T> a) {
    for (Eigen::Index column = 0; column < a.cols(); ++column)
        for (Eigen::Index i = 0; i < l.rows(); ++i) {
            T sum = a(i, column);
            for (Eigen::Index k = 0; k < i; ++k) sum -= l(i, k) * a(k, column);
            a(i, column) = sum / l(i, i);
        }
    return a;
}

/// A line through the values of ln S2 in one window. Rows are over all lags of the LogStructure, 0 beyond the window:
/// their products with the values, and with the columns a and b, give the line and its changes.
template <Real T = double>
struct LogFit {
    parts::IndexRange range;
    T reference{};       ///< ln n of the middle of the window
    T level{}, slope{};  ///< ln S2 there, without a and b, and p
    parts::Vector<T> level_row, slope_row;
    parts::Vector<T> fitted;        ///< the whole sum above at the lags of range, to be compared with ln S2
    T short_waves{}, long_waves{};  ///< a, b
    T residual{};                   ///< weighted sum of squares
    bool finite_band{};             ///< a or b differs from 0 by two of its standard deviations
    bool log_periodic{};
};

/// Fits lines to one structure function whose slope is near \p power.
template <Real T>
class LineFitter {
public:
    /// \p covariance of log.value; \p band_ends: no wave is much shorter than the window.
    LineFitter(const parts::LogStructure<T>& log, parts::Matrix<T> covariance, T power, T log_gamma, bool band_ends)
        : log_(log),
          covariance_(std::move(covariance)),
          power_(power),
          log_gamma_(log_gamma),
          short_sd_(T(0.6) * share_of_short_waves(power) * (log.apart > T(0) ? share_of_oblique_waves(power) : T(1))),
          expected_short_(short_sd_ * (band_ends          ? T(-1.25)
                                       : log.apart > T(0) ? T(-1)
                                                          : T(-0.75))),
          y_(log.value) {
        for (Eigen::Index k = 0; k < y_.size(); ++k) {
            // the logarithm of a mean of squares is low by half its variance
            y_[k] += (std::min)(covariance_(k, k), T(0.5)) / 2;
            covariance_(k, k) += T(0.0009);
        }
    }

    const parts::Vector<T>& y() const { return y_; }

    /// Line in \p lags. The columns a and b are those of the window \p band.
    LogFit<T> fit(const parts::IndexRange& lags, const parts::IndexRange& band) const {
        LogFit<T> line = fit_with(lags, band, false);
        const T width = log_.lag[lags.last] - log_.lag[lags.first];
        if (width > 2 * log_gamma_ && lags.count() >= 12)
            if (LogFit<T> waves = fit_with(lags, band, true); waves.residual < line.residual / 2) line = waves;
        return line;
    }

    /// Covariance of row_a * ln S2 and row_b * ln S2 by sampling alone, and with the uncertainty of a and b of \p band.
    T covariance_of(const parts::Vector<T>& row_a, const parts::Vector<T>& row_b, const parts::IndexRange& band) const {
        const parts::Matrix<T> ends = band_columns(band);
        const T a = row_a.dot(ends.col(0)) * row_b.dot(ends.col(0)) * short_sd_ * short_sd_;
        const T b = row_a.dot(ends.col(1)) * row_b.dot(ends.col(1)) * long_sd * long_sd;
        return row_a.dot(covariance_.lazyProduct(row_b)) + a + b;
    }

private:
    static constexpr T long_sd = T(0.5);

    /// a and b at all lags: each is 1 at its own end of the band.
    parts::Matrix<T> band_columns(const parts::IndexRange& band) const {
        parts::Matrix<T> columns(log_.lag.size(), 2);
        columns.col(0) = ((-power_ * (log_.lag.array() - log_.lag[band.first])).min)(T(2)).exp();
        columns.col(1) = (((4 - power_) * (log_.lag.array() - log_.lag[band.last])).min)(T(2)).exp();
        return columns;
    }

    LogFit<T> fit_with(const parts::IndexRange& range, const parts::IndexRange& band, bool log_periodic) const {
        const Eigen::Index count = range.count(), terms = log_periodic ? 8 : 4;
        LogFit<T> line;
        line.range = range;
        line.log_periodic = log_periodic;
        line.reference = (log_.lag[range.first] + log_.lag[range.last]) / 2;
        const parts::Vector<T> x = log_.lag.segment(range.first, count).array() - line.reference;
        parts::Matrix<T> columns(count, terms);
        columns.col(0).setOnes();
        columns.col(1) = x;
        columns.block(0, 2, count, 2) = band_columns(band).block(range.first, 0, count, 2);
        if (log_periodic)
            for (const Eigen::Index harmonic : {1, 2}) {
                const auto angle =
                    (2 * static_cast<T>(harmonic) * std::numbers::pi_v<T> / log_gamma_ * x.array()).eval();
                columns.col(2 + 2 * harmonic) = angle.cos();
                columns.col(3 + 2 * harmonic) = angle.sin();
            }
        const parts::Matrix<T> root = cholesky<T>(covariance_.block(range.first, range.first, count, count));
        // two more values, 0: the prior of a and b
        parts::Matrix<T> weighted = parts::Matrix<T>::Zero(count + 2, terms);
        weighted.topRows(count) = forward_substituted<T>(root, columns);
        weighted(count, 2) = 1 / short_sd_;
        weighted(count + 1, 3) = 1 / long_sd;
        const parts::Matrix<T> inverse_root = forward_substituted<T>(root, parts::Matrix<T>::Identity(count, count));
        const parts::Matrix<T> solver = math::PivotedQr<T>(weighted).solver().leftCols(count).lazyProduct(inverse_root);
        const parts::Vector<T> y = y_.segment(range.first, count) - expected_short_ * columns.col(2);
        const parts::Vector<T> found = solver.lazyProduct(y);
        const auto spread = [&](Eigen::Index term) {
            const parts::Vector<T> row = solver.row(term).transpose();
            return std::sqrt(row.dot(covariance_.block(range.first, range.first, count, count).lazyProduct(row)));
        };
        line.level = found[0], line.slope = found[1], line.short_waves = found[2] + expected_short_,
        line.long_waves = found[3];
        line.finite_band = std::abs(found[2]) > 2 * spread(2) || std::abs(found[3]) > 2 * spread(3);
        const parts::Vector<T> missed = y - columns.lazyProduct(found);
        const parts::Vector<T> left = inverse_root.lazyProduct(missed);
        line.residual = left.squaredNorm();
        line.fitted = log_.value.segment(range.first, count) - missed;
        line.level_row = line.slope_row = parts::Vector<T>::Zero(log_.lag.size());
        line.level_row.segment(range.first, count) = solver.row(0).transpose();
        line.slope_row.segment(range.first, count) = solver.row(1).transpose();
        return line;
    }

    const parts::LogStructure<T>& log_;
    parts::Matrix<T> covariance_;
    T power_, log_gamma_, short_sd_, expected_short_;
    parts::Vector<T> y_;
};

}  // namespace fstiff::inline v0_1::detail
