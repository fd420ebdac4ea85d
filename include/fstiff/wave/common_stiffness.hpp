// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One stiffness from reflections at several frequencies, and whether it depends on these, as that of no spring does.
///
///     minimise sum ((R_i - R(K, omega_i))/e_i)^2                 K at one load; the e_i are equal where none is known
///     (R_i - R(K, omega_i))/(K dR/dK) = a_load + b ln omega_i    least squares; the left side is ln K_i - ln K
///     errors of K and b: from the e_i, times sqrt(chi^2/n) above 1; from the scatter alone where no e_i is known
///
/// K depends on the frequency where b is beyond its 99 % interval about 0, and K changes by more than 5 %.
///
/// Reference   this project; wave/spring_interface.hpp has R(K, omega)
/// Units       K [Pa/m], omega [rad/s], R dimensionless
/// Valid       as stiffness_from_reflection; b to first order
/// Accuracy    K 1e-8; within one error of it 66 to 73 % of noisy spectra (tests/wave/common_stiffness_test.cpp)

#include <fstiff/math/least_squares.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <optional>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// A measured |R|, its standard error, 0 where it is not known, and the frequency of the wave.
template <Real T = double>
struct ReflectionAt {
    T angular_frequency{}, reflection{}, error{};
};

/// Whether all of \p observed have an error.
template <Real T>
[[nodiscard]] bool errors_are_known(std::span<const ReflectionAt<T>> observed) {
    return std::all_of(observed.begin(), observed.end(), [](const auto& each) { return each.error > 0; });
}

/// The stiffness of one load.
template <Real T = double>
struct CommonStiffness {
    T value{};    ///< [Pa/m]
    T error{};    ///< standard error; 0 for one reflection without an error
    T scatter{};  ///< of K from one frequency to another, over K: weighted standard deviation; 0 for one reflection
};

/// The factor by which scatter of \p squares, the sum of squares of residuals over errors, widens those errors.
template <Real T>
[[nodiscard]] T widened_by_scatter(T squares, std::size_t freedom, bool errors_known) {
    if (freedom == 0) return errors_known ? T(1) : T(0);
    const T scatter = std::sqrt(squares / static_cast<T>(freedom));
    return errors_known ? (std::max)(T(1), scatter) : scatter;
}

/// K of all \p observed, with that of a film in parallel. \throws domain_error as stiffness_from_reflection, and for
/// none.
template <Real T>
[[nodiscard]] CommonStiffness<T> common_stiffness(std::span<const ReflectionAt<T>> observed,
                                                  const Impedances<T>& media) {
    require(!observed.empty(), "reflections", observed.size(), "at least 1");
    const bool known = errors_are_known(observed);
    const auto error_of = [&](const ReflectionAt<T>& each) { return known ? each.error : T(1); };
    std::vector<MeasuredStiffness<T>> single;
    T weights = 0, sum = 0;
    for (const ReflectionAt<T>& each : observed) {
        single.push_back(measured_stiffness(each.reflection, error_of(each), media, each.angular_frequency));
        const T weight = 1 / (single.back().error * single.back().error);
        weights += weight, sum += weight * std::log(single.back().value);
    }
    if (observed.size() == 1) return {single[0].value, known ? single[0].error : T(0), T(0)};
    using Fit = math::LeastSquaresFit<T>;
    const auto evaluate = [&](const typename Fit::Vector& x, typename Fit::Vector& f, typename Fit::Matrix& jacobian) {
        const T stiffness = std::exp(x(0));
        if (!std::isfinite(stiffness)) return false;
        for (std::size_t i = 0; i < observed.size(); ++i) {
            const auto& [omega, measured, unused] = observed[i];
            const auto row = static_cast<Eigen::Index>(i);
            f(row) = (measured - reflection(stiffness, media, omega)) / error_of(observed[i]);
            jacobian(row, 0) = -stiffness * reflection_slope(stiffness, media, omega) / error_of(observed[i]);
        }
        return true;
    };
    const typename Fit::Vector start = Fit::Vector::Constant(1, sum / weights);
    const Fit fit = math::least_squares<T>(start, static_cast<Eigen::Index>(observed.size()), evaluate,
                                           {.residual_floor = T(1e-14)});
    CommonStiffness<T> common{.value = std::exp(fit.parameters(0))};
    if (fit.covariance.size() > 0)
        common.error = common.value * std::sqrt(fit.covariance(0, 0)) *
                       widened_by_scatter(fit.sum_of_squares, observed.size() - 1, known);
    T squares = 0;
    for (const auto& K : single) squares += (K.value - common.value) / K.error * ((K.value - common.value) / K.error);
    const auto count = static_cast<T>(observed.size());
    common.scatter = std::sqrt(squares / weights * count / (count - 1)) / common.value;
    return common;
}

/// The reflections of one load, and K by all of them, with that of a film in parallel.
template <Real T = double>
struct LoadSpectrum {
    std::vector<ReflectionAt<T>> observed{};
    CommonStiffness<T> common{};
};

/// ln K against ln omega.
template <Real T = double>
struct FrequencyTrend {
    T exponent{};     ///< b of K ~ omega^b
    T error{};        ///< standard error of b
    int freedom{};    ///< degrees of freedom of the scatter; 0: from known errors
    T low{}, high{};  ///< [rad/s]
    T misfit{};       ///< chi^2 over the degrees of freedom about one K a load; 0 where no error is known
    bool scatters{};  ///< chi^2 > n + 3 sqrt(2 n) about one K a load

    /// K at the highest frequency over K at the lowest.
    [[nodiscard]] T change() const { return std::pow(high / low, exponent); }
    [[nodiscard]] bool depends() const {
        constexpr math::NormalQuantile<T> normal_995{T(0.995), T(2.575829303548900760966349L)};
        return std::abs(exponent) > math::student_quantile(normal_995, freedom) * error &&
               std::abs(std::log(change())) > std::log(T(1.05));
    }
};

/// The trend of all \p loads together, with a film of the stiffness \p film in parallel; none where no load has two
/// frequencies, or nothing distinguishes scatter from trend.
template <Real T>
[[nodiscard]] std::optional<FrequencyTrend<T>> frequency_trend(std::span<const LoadSpectrum<T>> loads,
                                                               const Impedances<T>& media, T film) {
    FrequencyTrend<T> trend;
    T xx = 0, xy = 0, yy = 0;
    bool known = true;
    int freedom = -1;
    for (const LoadSpectrum<T>& load : loads) {
        if (load.observed.empty()) continue;
        const std::span<const ReflectionAt<T>> observed(load.observed);
        known = known && errors_are_known(observed);
        freedom += static_cast<int>(observed.size()) - 1;
        std::vector<T> weights, x, y;
        T weight = 0, x_mean = 0, y_mean = 0;
        const T K = load.common.value;
        for (const auto& [omega, measured, error] : observed) {
            const T slope = (K - film) * reflection_slope(K, media, omega),
                    uncertain = (error > 0 ? error : T(1)) / slope;
            weights.push_back(1 / (uncertain * uncertain));
            x.push_back(std::log(omega)), y.push_back((measured - reflection(K, media, omega)) / slope);
            weight += weights.back(), x_mean += weights.back() * x.back(), y_mean += weights.back() * y.back();
            trend.low = trend.low > 0 ? (std::min)(trend.low, omega) : omega;
            trend.high = (std::max)(trend.high, omega);
        }
        for (std::size_t i = 0; i < x.size(); ++i) {
            const T dx = x[i] - x_mean / weight, dy = y[i] - y_mean / weight;
            xx += weights[i] * dx * dx, xy += weights[i] * dx * dy, yy += weights[i] * dy * dy;
        }
    }
    if (!(trend.high > trend.low) || !(xx > 0) || freedom < (known ? 0 : 1)) return std::nullopt;
    trend.exponent = xy / xx;
    const T rest = (std::max)(yy - xy * xy / xx, T(0));
    trend.error = widened_by_scatter(rest, static_cast<std::size_t>(freedom), known) / std::sqrt(xx);
    trend.freedom = known ? 0 : freedom;
    if (known) {
        const T all = static_cast<T>(freedom) + 1;
        trend.misfit = yy / all, trend.scatters = yy > all + 3 * std::sqrt(2 * all);
    }
    return trend;
}

}}}  // namespace fstiff::detail
