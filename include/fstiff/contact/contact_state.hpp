// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What is known of a contact at one separation or pressure, and the search for the separation of a given pressure.
///
/// Units       SI, per nominal area
/// Accuracy    the errors are absolute bounds for exact inputs; those at a given pressure contain that of the separation

#include <fstiff/core/error.hpp>
#include <fstiff/core/estimate.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/root.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace fstiff {

/// Quantities that were not asked for are 0, with 0 evaluations.
template <Real T>
struct ContactState {
    T eta{};                         ///< separation at which the peaks meet, over the rms height
    Estimate<T> separation;          ///< of the mean planes [m]
    Estimate<T> pressure;            ///< nominal [Pa]
    Estimate<T> stiffness;           ///< K/A0 [Pa/m]
    Estimate<T> real_area_fraction;  ///< A/A0
    Estimate<T> contact_density;     ///< n/A0 [1/m^2]
    Estimate<T> loading_stiffness;   ///< -dp/dd [Pa/m]: K where the stiffness of the law is the slope of its load
};

/// A decreasing function of eta as its logarithm, so that its tail does not underflow.
template <Real T>
struct LogSlope {
    T log;    ///< log f(eta)
    T slope;  ///< d log f/d eta, < 0
    T error;  ///< relative error of f
};

/// A positive function of eta as its logarithm.
template <Real T>
struct LogValue {
    T log;    ///< log f(eta)
    T error;  ///< relative error of f
};

namespace detail {

inline constexpr int lowest_eta = -1000;  ///< separations that are searched for a pressure

template <Real T>
struct EtaEstimate {
    T value, error;
};

/// Where the tail of a Gaussian underflows, and an exponential one; short of it for the algebraic factors.
template <Real T>
T highest_gaussian_eta() {
    return std::sqrt(-2 * std::log(std::numeric_limits<T>::min())) - 1;
}
template <Real T>
T highest_exponential_eta() {
    return -std::log(std::numeric_limits<T>::min()) - 10;
}

/// Tolerance of the evaluations that only show where the root is.
template <Real T>
inline constexpr T rough_tolerance = T(1e-3);

/// The eta up to \p highest where log f(eta) = \p target. \p log_slope takes eta and whether a rough value will do, and returns
/// a LogSlope. log f is concave and close to its value and slope at 0 plus -eta^2/2: from that guess Halley's method, whose
/// second derivative is the difference of two slopes, arrives in three or four evaluations, the first of them rough; a
/// bracketed search takes over where it does not.
/// \throws domain_error naming \p pressure when eta would leave [lowest_eta, highest] or f its range.
template <Real T, class F>
EtaEstimate<T> eta_of(T target, T pressure, T highest, const F& log_slope) {
    using Limits = std::numeric_limits<T>;
    const T rounding = Limits::epsilon() * (1 + std::abs(target));  // of the logarithms that are compared
    LogSlope<T> at = log_slope(T(0), true);
    const T at_zero = at.log - target;
    const T guess = at_zero > 0 ? std::sqrt(at.slope * at.slope + 2 * at_zero) + at.slope
                                : -std::cbrt(std::exp(std::min(-2 * at_zero, T(60)))) + 1;
    const T near = T(0.05), close = std::sqrt(Limits::epsilon());  // the next step is its square or less
    bool rough = true;
    T x = guess, last_x = 0;
    for (int i = 0; i < 12 && x >= lowest_eta && x <= highest; ++i) {
        const T last_slope = at.slope;
        at = log_slope(x, rough);
        const T newton = (target - at.log) / at.slope;
        const T bend = x != last_x ? (at.slope - last_slope) / (x - last_x) * newton / (2 * at.slope) : T(0);
        const T step = std::abs(bend) < T(0.5) ? newton / (1 + bend) : newton;
        last_x = x;
        x += step;
        if (!rough && std::abs(step) <= close)
            return {x, step * step + (at.error + rounding) / -at.slope + Limits::epsilon() * std::abs(x)};
        if (std::abs(step) <= near) rough = false;
    }

    const auto residual = [&](T eta) {
        const auto f = log_slope(eta, false);
        return std::pair(f.log - target, f.slope);
    };
    // closer than the rounding of the logarithms tells apart is not asked for
    const auto found = newton_bracketed(residual, T(lowest_eta), highest, guess, 16 * rounding);
    if (!found.converged()) {
        const auto reached = [&](T eta) {  // log p there
            return (std::log(pressure) - target) + log_slope(eta, false).log;
        };
        const T low = reached(highest), high = reached(T(lowest_eta));
        require(std::isfinite(low) && std::isfinite(high), "pressure", pressure,
                "possible for the scales of this surface");
        const auto power = [](T log) { return "1e" + std::to_string(std::lround(log / numbers::ln10_v<T>)); };
        const std::string allowed =
            "between " + power(low) + " and " + power(high) + " Pa or so for this surface and law";
        require(false, "pressure", pressure, allowed);
    }
    at = log_slope(found.root, false);
    return {found.root, found.error + (at.error + rounding) / -at.slope};
}

}  // namespace detail
}  // namespace fstiff
