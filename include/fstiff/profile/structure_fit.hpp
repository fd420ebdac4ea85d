// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The weighted straight line through ln S over ln n, with the terms that a finite band and discrete waves add.
///
///     ln S(tau) = (4-2D) ln tau + ln C                                              eq. (2.5)
///               + a tau^-(4-2D) + b tau^(2D-2)                                      finite band
///               + harmonics 1, 2 of cos, sin(2 pi ln tau / ln gamma)                log-periodic
///
/// Two kinds of terms are added where they matter:
///  - finite band, in windows of two decades and more: a the waves below the resolution, or noise; b the waves longer
///    than the profile, or removed with its form. Left out, they bias D of Weierstrass-Mandelbrot profiles by 0.02 or
///    more;
///  - log-periodic, where they explain more than half of the scatter about the line.
/// The weights 1/(n/N + 0.0009) for a lag of n of N samples follow the sampling error, with a floor for what the model
/// misses.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eq. (2.5)
/// Valid       4 lags at least
/// Accuracy    1e-12 of data that are made of these terms, 1e-9 with those of a finite band
///             (tests/profile/structure_fit_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/decompositions.hpp>
#include <fstiff/profile/lag_window.hpp>

namespace fstiff::detail {

/// A weighted linear fit of ln S.
template <Real T = double>
struct LogFit {
    Matrix<T> solver;  ///< coefficients = solver * y; row 0 gives ln S at the reference lag, row 1 the slope
    Vector<T> coefficients;
    T residual{};  ///< weighted sum of squares
    bool finite_band{}, log_periodic{};
};

/// Fits \p y over \p x = ln(n / reference) with the columns that are asked for; \p power shapes those of the finite
/// band.
template <Real T>
LogFit<T> log_fit(const Vector<T>& x, const Vector<T>& y, const Vector<T>& root_weight, T power, bool finite_band,
                  bool log_periodic, T log_gamma) {
    Matrix<T> columns(x.size(), 2 + (finite_band ? 2 : 0) + (log_periodic ? 4 : 0));
    columns.col(0).setOnes();
    columns.col(1) = x;
    Eigen::Index next = 2;
    if (finite_band) {  // each is 1 at its own end of the window
        columns.col(next++) = (-power * (x.array() - x[0])).exp();
        columns.col(next++) = ((2 - power) * (x.array() - x[x.size() - 1])).exp();
    }
    if (log_periodic)
        for (const int harmonic : {1, 2}) {
            const auto angle = (2 * static_cast<T>(harmonic) * numbers::pi_v<T> / log_gamma * x.array()).eval();
            columns.col(next++) = angle.cos();
            columns.col(next++) = angle.sin();
        }
    LogFit<T> fit;
    const Matrix<T> weighted = root_weight.asDiagonal() * columns;
    fit.solver = PivotedQr<T>(weighted).solver() * root_weight.asDiagonal();
    fit.coefficients = fit.solver.lazyProduct(y);
    fit.residual = (root_weight.array() * (y - columns.lazyProduct(fit.coefficients)).array()).square().sum();
    fit.finite_band = finite_band;
    fit.log_periodic = log_periodic;
    return fit;
}

/// How D and ln S at the reference lag move with ln S at each lag.
template <Real F>
struct FitRows {
    Vector<F> dimension, level;
};

/// The fits over one window, about its middle.
template <Real F>
class WindowFit {
public:
    WindowFit(const LogStructure<F>& log, const IndexRange& range, F log_gamma)
        : log_gamma_(log_gamma), log_reference_((log.lag[range.first] + log.lag[range.last]) / 2) {
        const auto lags = log.lag.segment(range.first, range.count());
        x_ = lags.array() - log_reference_;
        measured_ = y_ = log.value.segment(range.first, range.count());
        root_weight_ = (lags.array().exp() / static_cast<F>(log.points) + F(0.0009)).rsqrt();
        const Vector<F> ones = Vector<F>::Ones(x_.size());
        ordinary_ = log_fit(x_, y_, ones, F(1), false, false, log_gamma);
    }

    const Vector<F>& x() const { return x_; }
    const Vector<F>& y() const { return y_; }                // without the loss by the form, after fit()
    const LogFit<F>& ordinary() const { return ordinary_; }  // straight line, all lags of one weight
    F log_reference() const { return log_reference_; }
    F width() const { return x_[x_.size() - 1] - x_[0]; }

    /// The fit with the terms that matter. \p log_retained(power) is what the removal of a form left of ln S;
    /// \p has_no_form: all of it.
    template <class LogRetained>
    LogFit<F> fit(const LogRetained& log_retained, bool has_no_form) {
        LogFit<F> fit;
        F slope_of_correction = ordinary_.coefficients[1];
        for (int round = 0; round < (has_no_form ? 1 : 6); ++round) {
            y_ = measured_ - log_retained(slope_of_correction);
            std::optional<LogFit<F>> chosen;
            if (width() > std::log(F(100)) * F(0.999)) chosen = with_waves(true);
            if (!chosen) chosen = with_waves(false);
            fit = *chosen;
            slope_of_correction = fit.coefficients[1];
        }
        return fit;
    }

    /// Of the \p fit that was found: directly, and through what moves with D, the columns and the loss by the form.
    template <class LogRetained>
    FitRows<F> rows(const LogFit<F>& fit, const LogRetained& log_retained, bool has_no_form) const {
        FitRows<F> rows{-fit.solver.row(1).transpose() / 2, fit.solver.row(0).transpose()};
        const F power = fit.coefficients[1];
        if (fit.finite_band) {
            const F small = F(1e-4);
            const LogFit<F> up = fit_at(power + small, true, fit.log_periodic);
            const LogFit<F> down = fit_at(power - small, true, fit.log_periodic);
            const F feedback = (up.coefficients[1] - down.coefficients[1]) / (2 * small);
            const F level_feedback = (up.coefficients[0] - down.coefficients[0]) / (2 * small);
            rows.dimension /= 1 - std::min(feedback, F(0.9));
            rows.level += -2 * level_feedback * rows.dimension;
        }
        if (!has_no_form) {
            const F small = F(1e-3);
            const Vector<F> change = (log_retained(power + small) - log_retained(power - small)) / (2 * small);
            const F feedback = 2 * rows.dimension.dot(change);  // of D on itself: d power = -2 dD
            rows.dimension /= std::max(F(0.3), 1 - feedback);
            rows.level += 2 * rows.level.dot(change) * rows.dimension;
        }
        return rows;
    }

private:
    LogFit<F> fit_at(F power, bool finite_band, bool log_periodic) const {
        return log_fit(x_, y_, root_weight_, power, finite_band, log_periodic, log_gamma_);
    }

    /// The columns of the finite band depend on the slope: repeated until it stays.
    std::optional<LogFit<F>> settled(bool finite_band, bool log_periodic) const {
        F power = std::clamp(ordinary_.coefficients[1], F(0.1), F(1.9));
        LogFit<F> fit = fit_at(power, finite_band, log_periodic);
        if (!finite_band) return fit;
        for (int round = 0; round < 50; ++round) {
            const F next = fit.coefficients[1];
            if (!(next > F(0.02) && next < F(1.98))) return std::nullopt;
            const bool stays = std::abs(next - power) < F(1e-10);
            power = next;
            fit = fit_at(power, finite_band, log_periodic);
            // a correction, not the main thing: at its own end of the window each term stays below the power law
            if (stays && std::abs(fit.coefficients[2]) < F(1) && std::abs(fit.coefficients[3]) < F(1)) return fit;
            if (stays) return std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<LogFit<F>> with_waves(bool finite_band) const {
        auto fit = settled(finite_band, false);
        const bool enough_lags = width() > 2 * log_gamma_ && x_.size() >= 12;
        if (fit && enough_lags)
            if (auto waves = settled(finite_band, true); waves && waves->residual < fit->residual / 2) fit = waves;
        return fit;
    }

    F log_gamma_, log_reference_;
    Vector<F> x_, measured_, y_, root_weight_;
    LogFit<F> ordinary_;
};

}  // namespace fstiff::detail
