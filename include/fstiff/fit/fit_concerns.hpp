// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What speaks against the parameters of a fit: every concern by its name, with the parameters and the number behind
/// it.
///
///     singular        a combination of the parameters leaves the model as it is: those with a share above 0.02 in it
///     not_converged   the search ended before the least sum of squares
///     misfit          chi^2 > n + 3 sqrt(2 n), n degrees of freedom: three standard deviations of chi^2 above its mean
///     no_errors       as many parameters as points, and points without errors: no standard errors
///     at_bound        D, r or theta within 1e-6 of an end of its range: no value of it fits the data
///     unresolved      a positive parameter whose 95 % interval spans a factor of 100 or more
///     correlated      two parameters with a correlation beyond 0.99: hardly told apart
///
///     for (const auto& finding : fstiff::concerns_of(fit)) report(name_of(finding.concern), finding.parameters);
///
/// Reference   fit/identify.hpp; the limits are this project's.
/// Units       none: shares, ratios and correlations
/// Valid       what identify() returns

#include <fstiff/core/names.hpp>
#include <fstiff/fit/identify.hpp>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace fstiff {

enum class FitConcern { singular, not_converged, misfit, no_errors, at_bound, unresolved, correlated };

template <>
inline constexpr auto names<FitConcern> = name_list<FitConcern>({
    {FitConcern::singular, "singular"},
    {FitConcern::not_converged, "not_converged"},
    {FitConcern::misfit, "misfit"},
    {FitConcern::no_errors, "no_errors"},
    {FitConcern::at_bound, "at_bound"},
    {FitConcern::unresolved, "unresolved"},
    {FitConcern::correlated, "correlated"},
});

/// Whether the values of the fit are no answer at all; else they stand, and the concern is about their errors.
[[nodiscard]] constexpr bool is_fatal(FitConcern concern) {
    return concern == FitConcern::singular || concern == FitConcern::not_converged || concern == FitConcern::at_bound;
}

template <Real T = double>
struct FitFinding {
    FitConcern concern{};
    std::vector<Parameter> parameters{};  ///< in the order of the fit; none of not_converged, misfit, no_errors
    T value{};  ///< of misfit chi^2 over the degrees of freedom, of unresolved high/low, of correlated the correlation
};

/// In the order of FitConcern, but at_bound and unresolved as the parameters come; singular stands alone.
template <Real T>
[[nodiscard]] std::vector<FitFinding<T>> concerns_of(const Identification<T>& fit) {
    std::vector<FitFinding<T>> findings;
    if (fit.status == FitStatus::singular) {
        FitFinding<T> unseen{.concern = FitConcern::singular};
        for (const auto& one : fit.parameters)
            if (one.null_share > T(0.02)) unseen.parameters.push_back(one.parameter);
        return {unseen};
    }
    if (fit.status == FitStatus::not_converged) findings.push_back({.concern = FitConcern::not_converged});
    const auto freedom = static_cast<T>(fit.degrees_of_freedom);
    if (fit.errors_known && freedom > 0 && fit.chi_squared > freedom + 3 * std::sqrt(2 * freedom))
        findings.push_back({.concern = FitConcern::misfit, .value = fit.chi_squared / freedom});
    const bool has_errors = fit.covariance.size() > 0;
    if (!has_errors && fit.status != FitStatus::at_bound) findings.push_back({.concern = FitConcern::no_errors});
    for (const auto& one : fit.parameters) {
        if (one.at_bound)
            findings.push_back({FitConcern::at_bound, {one.parameter}, T(0)});
        else if (row_of(one.parameter).variation == Variation::log && has_errors && !(one.high < 100 * one.low))
            findings.push_back({FitConcern::unresolved, {one.parameter}, one.high / one.low});
    }
    for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            if (std::abs(fit.correlation(i, k)) > T(0.99)) {
                const auto which = [&](Eigen::Index index) {
                    return fit.parameters[static_cast<std::size_t>(index)].parameter;
                };
                findings.push_back({FitConcern::correlated, {which(k), which(i)}, fit.correlation(i, k)});
            }
    return findings;
}

}  // namespace fstiff
