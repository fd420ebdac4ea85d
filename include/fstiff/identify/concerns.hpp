// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Concerns about the parameters of a fit, each with its name, its parameters and its number.
///
///     singular        a combination of the parameters leaves the model as it is: those with a share above 0.02 in it
///     not_converged   the search ended before the least sum of squares
///     misfit          chi^2 > n + 3 sqrt(2 n), n degrees of freedom
///     scattered      points without errors whose scatter about the model is above 0.25: of K relative, of |R| absolute
///     outlier    a residual above 10 times the median residual, and above 4 errors, or 0.05 of K or |R| without errors
///     far_from_start  a positive parameter that is 30 times its starting value, or a thirtieth: a wrong unit, often
///     no_errors       as many parameters as points, and points without errors: no standard errors
///     at_bound        D, r or theta within 1e-6 of an end of its range: no value of it fits the data
///     unresolved      a positive parameter whose 95 % interval spans a factor of 100 or more
///     correlated      two parameters with a correlation beyond 0.99: hardly separable
///
/// Reference   this project

#include <fstiff/core/names.hpp>
#include <fstiff/identify/identify.hpp>

namespace fstiff { inline namespace v0_1 {

/// Possible faults of a fit.
enum class FitConcern {
    singular,
    not_converged,
    misfit,
    scattered,
    outlier,
    far_from_start,
    no_errors,
    at_bound,
    unresolved,
    correlated
};

template <>
inline constexpr auto enum_names<FitConcern> = detail::name_list<FitConcern>({
    {FitConcern::singular, "singular"},
    {FitConcern::not_converged, "not_converged"},
    {FitConcern::misfit, "misfit"},
    {FitConcern::scattered, "scattered"},
    {FitConcern::outlier, "outlier"},
    {FitConcern::far_from_start, "far_from_start"},
    {FitConcern::no_errors, "no_errors"},
    {FitConcern::at_bound, "at_bound"},
    {FitConcern::unresolved, "unresolved"},
    {FitConcern::correlated, "correlated"},
});

namespace detail {

/// True if the values of the fit are no answer at all; else they are valid.
[[nodiscard]] constexpr bool is_fatal(FitConcern concern) {
    return concern == FitConcern::singular || concern == FitConcern::not_converged || concern == FitConcern::at_bound;
}

/// True if the model does not describe the data, or only some of them, or with values that are unexpected or known to a
/// factor of 100 at best: the fit needs a look before it is used. Concerns that are neither this nor fatal are about
/// the errors of the values.
[[nodiscard]] constexpr bool is_doubtful(FitConcern concern) {
    return concern == FitConcern::misfit || concern == FitConcern::scattered || concern == FitConcern::outlier ||
           concern == FitConcern::far_from_start || concern == FitConcern::unresolved;
}

/// One doubt about a fit, with its numbers.
template <Real T = double>
struct FitFinding {
    FitConcern concern{};
    std::vector<Parameter> parameters{};  ///< in the order of the fit; none of not_converged to outlier, no_errors
    /// misfit: chi^2 over the degrees of freedom; scattered: scatter; outlier: residual over the median;
    /// far_from_start: value/start; unresolved: high/low; correlated: correlation.
    T value{};
    std::size_t point{};  ///< of outlier: the observation
};

/// The largest residual if it is an outlier.
template <Real T>
void add_outlier(const Identification<T>& fit, std::vector<FitFinding<T>>& findings) {
    if (fit.degrees_of_freedom < 3 || fit.residuals.empty()) return;
    std::vector<T> sizes;
    for (const T residual : fit.residuals) sizes.push_back(std::abs(residual));
    const auto largest = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    const T size = sizes[largest];
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    const T median = sizes[sizes.size() / 2];
    const bool stands_out = fit.errors_known ? size > T(4) : size * fit.scatter > T(0.05);
    if (stands_out && size > 10 * median)
        findings.push_back({.concern = FitConcern::outlier, .value = size / median, .point = largest});
}

template <Real T>
void add_far_from_start(const Identification<T>& fit, std::vector<FitFinding<T>>& findings) {
    for (const auto& p : fit.parameters) {
        const T start = fit.start[p.parameter];
        if (row_of(p.parameter).variation == Variation::log && start > T(0) &&
            !(p.value < 30 * start && start < 30 * p.value))
            findings.push_back(
                {.concern = FitConcern::far_from_start, .parameters = {p.parameter}, .value = p.value / start});
    }
}

/// Concerns in the order of FitConcern, but at_bound and unresolved as the parameters come; singular excludes the
/// others.
template <Real T>
[[nodiscard]] std::vector<FitFinding<T>> concerns_of(const Identification<T>& fit) {
    std::vector<FitFinding<T>> findings;
    if (fit.status == math::FitStatus::singular) {
        FitFinding<T> unseen{.concern = FitConcern::singular};
        for (const auto& p : fit.parameters)
            if (p.null_share > T(0.02)) unseen.parameters.push_back(p.parameter);
        return {unseen};
    }
    if (fit.status == math::FitStatus::not_converged) findings.push_back({.concern = FitConcern::not_converged});
    const auto freedom = static_cast<T>(fit.degrees_of_freedom);
    if (fit.errors_known && freedom > 0 && fit.chi_squared > freedom + 3 * std::sqrt(2 * freedom))
        findings.push_back({.concern = FitConcern::misfit, .value = fit.chi_squared / freedom});
    if (!fit.errors_known && fit.scatter > T(0.25))
        findings.push_back({.concern = FitConcern::scattered, .value = fit.scatter});
    add_outlier(fit, findings);
    add_far_from_start(fit, findings);
    const bool has_errors = fit.covariance.size() > 0;
    if (!has_errors && fit.status != math::FitStatus::at_bound) findings.push_back({.concern = FitConcern::no_errors});
    for (const auto& p : fit.parameters) {
        if (p.at_bound)
            findings.push_back({.concern = FitConcern::at_bound, .parameters = {p.parameter}});
        else if (detail::row_of(p.parameter).variation == detail::Variation::log && has_errors &&
                 !(p.high < 100 * p.low))
            findings.push_back(
                {.concern = FitConcern::unresolved, .parameters = {p.parameter}, .value = p.high / p.low});
    }
    for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            if (std::abs(fit.correlation(i, k)) > T(0.99)) {
                const auto parameter = [&](Eigen::Index index) {
                    return fit.parameters[static_cast<std::size_t>(index)].parameter;
                };
                findings.push_back({.concern = FitConcern::correlated,
                                    .parameters = {parameter(k), parameter(i)},
                                    .value = fit.correlation(i, k)});
            }
    return findings;
}

}  // namespace detail

}}  // namespace fstiff
