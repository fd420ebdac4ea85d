// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Normal stiffness of a rock joint by Barton and Bandis, fitted to measured points.
///
///     K = K_n0 (1 - p/(V_m K_n0 + p))^-2 = K_n0 (1 + p/(V_m K_n0))^2        closure V = p/(K_n0 + p/V_m)
///
/// sqrt(K) is a straight line over p, which the search starts from.
///
/// Reference   Bandis, Lumsden, Barton, Int. J. Rock Mech. Min. Sci. 20 (1983) 249-268
/// Units       SI
/// Valid       as identify/identify; p >= 0
/// Accuracy    of exact points 1e-9; errors within 1e-6 of those of the straight line through two points
///             (tests/identify/barton_bandis_test.cpp)

#include <fstiff/identify/identify.hpp>
#include <fstiff/math/least_squares.hpp>
#include <fstiff/math/normal_distribution.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// One of both parameters, with its interval of 95 %.
template <Real T = double>
struct HyperbolaParameter {
    T value{}, standard_error{}, low{}, high{};
};

/// K_n0 [Pa/m] and V_m [m] of a joint.
template <Real T = double>
struct BartonBandis {
    math::FitStatus status = math::FitStatus::not_converged;
    HyperbolaParameter<T> initial_stiffness{}, closure{};
    T chi_squared{}, scatter{};  ///< scatter: of points without errors, rms and relative
    int degrees_of_freedom = 0;
    bool errors_known = false, has_errors = false;
    std::vector<T> model{};  ///< K at the points

    [[nodiscard]] T stiffness(T pressure) const {
        const T growth = 1 + pressure / (closure.value * initial_stiffness.value);
        return initial_stiffness.value * growth * growth;
    }
};

/// Logarithms of K_n0 and V_m by the line through sqrt(K), or a rising one in its place.
template <Real T>
[[nodiscard]] Eigen::Matrix<T, Eigen::Dynamic, 1> hyperbola_start(const std::vector<Observation<T>>& data) {
    T n = 0, p = 0, s = 0, pp = 0, ps = 0, least = data.front().value, most = least, greatest = 0;
    for (const Observation<T>& point : data) {
        const T root = std::sqrt(point.value);
        ++n, p += point.pressure, s += root, pp += point.pressure * point.pressure, ps += point.pressure * root;
        least = (std::min)(least, point.value), most = (std::max)(most, point.value);
        greatest = (std::max)(greatest, point.pressure);
    }
    const T determinant = n * pp - p * p;
    T slope = determinant > 0 ? (n * ps - p * s) / determinant : T(0), root = (s - slope * p) / n;
    if (!(slope > 0 && root > 0)) root = std::sqrt(least) / 2, slope = (std::sqrt(most) - root) / greatest;
    return Eigen::Matrix<T, 2, 1>(2 * std::log(root), -std::log(slope * root));
}

/// Fits both parameters to stiffnesses, weighed by their errors, or all alike in relative terms.
/// \throws domain_error for fewer than two points, and as identify().
template <Real T>
[[nodiscard]] BartonBandis<T> fit_barton_bandis(const std::vector<Observation<T>>& data) {
    BartonBandis<T> out;
    for (const Observation<T>& point : data) out.errors_known = out.errors_known || point.error != 0;
    require_observations(data, false, out.errors_known);
    if (data.size() < 2) throw domain_error("Barton-Bandis needs two points at least");
    using Fit = math::LeastSquaresFit<T>;
    const auto set = [&](const typename Fit::Vector& u) {
        out.initial_stiffness.value = std::exp(u(0)), out.closure.value = std::exp(u(1));
    };
    const auto evaluate = [&](const typename Fit::Vector& u, typename Fit::Vector& f, typename Fit::Matrix& j) {
        set(u);
        if (!(out.initial_stiffness.value > 0 && out.closure.value > 0) || !std::isfinite(u.sum())) return false;
        for (std::size_t i = 0; i < data.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            const T K0 = out.initial_stiffness.value, error = out.errors_known ? data[i].error : data[i].value,
                    growth = 1 + data[i].pressure / (out.closure.value * K0);
            f(row) = (K0 * growth * growth - data[i].value) / error;
            j(row, 0) = K0 * growth * (2 - growth) / error;
            j(row, 1) = -2 * K0 * growth * (growth - 1) / error;
        }
        return f.allFinite() && j.allFinite();
    };
    const Fit fit = math::least_squares<T>(hyperbola_start(data), static_cast<Eigen::Index>(data.size()), evaluate, {});
    set(fit.parameters);
    out.status = fit.status;
    out.degrees_of_freedom = static_cast<int>(data.size()) - 2;
    out.chi_squared = fit.sum_of_squares;
    for (const Observation<T>& point : data) out.model.push_back(out.stiffness(point.pressure));
    if (!out.errors_known && out.degrees_of_freedom > 0)
        out.scatter = std::sqrt(fit.sum_of_squares / static_cast<T>(out.degrees_of_freedom));
    out.has_errors = fit.covariance.size() > 0 && (out.errors_known || out.degrees_of_freedom > 0);
    if (!out.has_errors) return out;
    const T factor = math::student_quantile(math::normal_975<T>, out.errors_known ? 0 : out.degrees_of_freedom);
    for (const auto& [parameter, index] : {std::pair{&out.initial_stiffness, 0}, {&out.closure, 1}}) {
        const T deviation = std::sqrt(fit.covariance(index, index)) * (out.errors_known ? T(1) : out.scatter);
        parameter->standard_error = parameter->value * deviation;
        parameter->low = parameter->value * std::exp(-factor * deviation);
        parameter->high = parameter->value * std::exp(factor * deviation);
    }
    return out;
}

}  // namespace detail

}}  // namespace fstiff
