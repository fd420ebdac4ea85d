// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Nonlinear least squares with given derivatives.
///
///     minimise |f(x)|^2 by (J^T J + lambda diag(J^T J)) dx = -J^T f                          Levenberg-Marquardt
///     covariance (J^T J)^-1 at the minimum, for residuals f in units of their standard error
///
/// Steps are solved by QR of J and the damping. Small singular values of J, its columns scaled to length 1, show
/// combinations of parameters that the data do not determine.
///
/// Reference   Marquardt, SIAM J. Appl. Math. 11 (1963) 431-441; More, Lecture Notes in Math. 630 (1978) 105-116
/// Units       those of the caller
/// Valid       at least as many residuals as parameters; f finite at the start
/// Accuracy    the last step is below the tolerance times the standard errors (tests/math/least_squares_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/math/decompositions.hpp>

#include <algorithm>

namespace fstiff { inline namespace v0_1 {

namespace math {

/// When the search for least squares ends.
template <Real T = double>
struct LeastSquaresOptions {
    int max_iterations = 200;
    T tolerance = T(1e-7);        ///< a step below this times the standard errors ends the search
    T residual_floor = T(1e-11);  ///< a change of the residuals that counts as none
    /// Least singular value of the scaled J, over the largest, that counts as a direction: well above the rounding of
    /// J, which would otherwise count as information.
    T singular_value = (std::max)(T(1e-7), T(1e4) * std::numeric_limits<T>::epsilon());
};

/// End of a search for least squares.
enum class FitStatus {
    converged,
    singular,  ///< a combination of the parameters leaves the residuals as they are: no covariance
    at_bound,  ///< a parameter came to the end of its range, which the caller gives (identify/identify): no covariance
    not_converged  ///< steps used up, or no step made the residuals smaller before the end was reached
};

}  // namespace math

template <>
inline constexpr auto enum_names<math::FitStatus> = detail::name_list<math::FitStatus>({
    {math::FitStatus::converged, "converged"},
    {math::FitStatus::singular, "singular"},
    {math::FitStatus::not_converged, "not_converged"},
    {math::FitStatus::at_bound, "at_bound"},
});

namespace math {

/// The outcome of a fit by least squares.
template <Real T = double>
struct LeastSquaresFit {
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    FitStatus status = FitStatus::not_converged;
    Vector parameters, residuals;
    Matrix covariance;      ///< empty when singular
    Vector null_direction;  ///< when singular: the undetermined direction, of length 1 in scaled parameters
    T sum_of_squares{};
    int evaluations = 0;
};

/// Lengths of the columns of \p jacobian; 1 in place of 0.
template <Real T>
[[nodiscard]] auto column_scales(const typename LeastSquaresFit<T>::Matrix& jacobian) {
    typename LeastSquaresFit<T>::Vector scale = jacobian.colwise().norm();
    for (T& s : scale) s = s > 0 ? s : T(1);
    return scale;
}

/// The step in units of 1/\p scale that minimises |J dx + f|^2 + damping |scale dx|^2.
template <Real T>
[[nodiscard]] auto damped_step(const LeastSquaresFit<T>& fit, const typename LeastSquaresFit<T>::Matrix& jacobian,
                               const typename LeastSquaresFit<T>::Vector& scale, T damping) {
    const Eigen::Index residuals = jacobian.rows(), count = jacobian.cols();
    typename LeastSquaresFit<T>::Matrix stacked = LeastSquaresFit<T>::Matrix::Zero(residuals + count, count);
    stacked.topRows(residuals) = jacobian * scale.cwiseInverse().asDiagonal();
    stacked.bottomRows(count).diagonal().setConstant(std::sqrt(damping));
    typename LeastSquaresFit<T>::Vector right = LeastSquaresFit<T>::Vector::Zero(residuals + count);
    right.head(residuals) = -fit.residuals;
    return PivotedQr<T>(std::move(stacked)).solve(std::move(right));
}

/// Covariance and status of a search that \p ended, or the direction that \p jacobian does not determine.
template <Real T>
void set_covariance(LeastSquaresFit<T>& fit, const typename LeastSquaresFit<T>::Matrix& jacobian, bool ended,
                    T least_singular_value) {
    const auto scale = column_scales<T>(jacobian);
    const Eigen::Index last = jacobian.cols() - 1;
    const auto [values, vectors] = singular_vectors<T>(jacobian * scale.cwiseInverse().asDiagonal());
    const bool blind = (jacobian.colwise().norm().array() == 0).any();
    if (blind || values(last) <= least_singular_value * values(0)) {
        fit.status = FitStatus::singular;
        fit.null_direction = vectors.col(last);
        return;
    }
    const typename LeastSquaresFit<T>::Matrix half =
        scale.cwiseInverse().asDiagonal() * vectors * values.cwiseInverse().asDiagonal();
    fit.covariance = half.lazyProduct(half.transpose());
    fit.status = ended ? FitStatus::converged : FitStatus::not_converged;
}

/// Minimises |f|^2 from \p start. \p evaluate(x, f, J) fills residuals and derivatives, and returns whether x is in the
/// domain of the model. \throws domain_error when there are fewer residuals than parameters, or the start is outside.
template <Real T, class Evaluate>
[[nodiscard]] LeastSquaresFit<T> least_squares(const Eigen::Matrix<T, Eigen::Dynamic, 1>& start, Eigen::Index residuals,
                                               const Evaluate& evaluate, const LeastSquaresOptions<T>& options = {}) {
    using Fit = LeastSquaresFit<T>;
    using Vector = typename Fit::Vector;
    using Matrix = typename Fit::Matrix;
    const Eigen::Index count = start.size();
    if (count == 0) throw domain_error(Refusal{.parameter = "parameters to fit", .reason = "none; must be at least 1"});
    if (residuals < count)
        throw domain_error(Refusal{.parameter = "data",
                                   .reason = std::to_string(residuals) + " points; must be at least as many as the " +
                                             std::to_string(count) + " parameters to fit"});
    Fit fit;
    fit.parameters = start;
    fit.residuals.resize(residuals);
    Matrix jacobian(residuals, count), trial_jacobian(residuals, count);
    Vector trial_residuals(residuals);
    const auto usable = [&](const Vector& x, Vector& f, Matrix& j) {
        ++fit.evaluations;
        return evaluate(x, f, j) && f.allFinite() && j.allFinite() && std::isfinite(f.squaredNorm());
    };
    if (!usable(start, fit.residuals, jacobian))
        throw domain_error(Refusal{.parameter = "the starting values",
                                   .reason = "the model has no value there for the data; must be closer to them"});
    fit.sum_of_squares = fit.residuals.squaredNorm();

    T damping = T(1e-3);
    bool ended = false;
    for (int step = 0; step < options.max_iterations && !ended; ++step) {
        const Vector scale = column_scales<T>(jacobian);
        const Vector scaled = damped_step(fit, jacobian, scale, damping);
        const Vector trial = fit.parameters + scaled.cwiseQuotient(scale);
        const bool inside = trial.allFinite() && usable(trial, trial_residuals, trial_jacobian);
        const T sum = inside ? trial_residuals.squaredNorm() : std::numeric_limits<T>::infinity();
        // |scaled| is the change of the residuals: small against their standard error, 1, or against their own size
        const T negligible =
            (std::max)(options.tolerance * (std::min)(T(1), std::sqrt(fit.sum_of_squares)), options.residual_floor);
        if (sum <= fit.sum_of_squares) {
            const bool little = fit.sum_of_squares - sum <= T(1e-3) * options.tolerance * fit.sum_of_squares;
            ended = damping <= T(1e-3) * T(1.001) && (scaled.norm() <= negligible || (little && damping < T(1e-6)));
            fit.parameters = trial;
            fit.residuals = trial_residuals;
            jacobian = trial_jacobian;
            fit.sum_of_squares = sum;
            damping = (std::max)(damping / 10, std::numeric_limits<T>::epsilon());
            if (sum == 0) ended = true;
        } else {
            // no step at all makes it smaller any more: the end of the digits
            if (scaled.norm() <= negligible) ended = true;
            damping *= 8;
            if (damping > T(1e12)) break;
        }
    }
    set_covariance(fit, jacobian, ended, options.singular_value);
    return fit;
}

}  // namespace math

}}  // namespace fstiff
