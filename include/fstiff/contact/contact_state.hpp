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
};

/// A decreasing function of eta as its logarithm, so that its tail does not underflow.
template <Real T>
struct LogSlope {
    T log;    ///< log f(eta)
    T slope;  ///< d log f/d eta, < 0
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

/// The eta up to \p highest where log f(eta) = \p target; log f is concave, so that Newton's method converges from a start left of the root or
/// right of it. \p log_slope takes eta and returns a LogSlope.
/// \throws domain_error naming \p pressure when eta would leave [lowest_eta, highest] or f its range.
template <Real T, class F>
EtaEstimate<T> eta_of(T target, T pressure, T highest, const F& log_slope) {
    using Limits = std::numeric_limits<T>;
    const auto residual = [&](T eta) {
        const auto f = log_slope(eta);
        return std::pair(f.log - target, f.slope);
    };
    // log f is close to its value and slope at 0 plus -eta^2/2
    const auto [at_zero, slope] = residual(T(0));
    const T guess = at_zero > 0 ? std::sqrt(slope * slope + 2 * at_zero) + slope
                                : -std::cbrt(std::exp(std::min(-2 * at_zero, T(60)))) + 1;
    // closer than the rounding of the logarithms tells apart is not asked for
    const auto found =
        newton_bracketed(residual, T(lowest_eta), highest, guess, 16 * Limits::epsilon() * (1 + std::abs(target)));
    if (!found.converged()) {
        const auto reached = [&](T eta) {  // log p there
            return (std::log(pressure) - target) + log_slope(eta).log;
        };
        const T low = reached(highest), high = reached(T(lowest_eta));
        require(std::isfinite(low) && std::isfinite(high), "pressure", pressure,
                "possible for the scales of this surface");
        const auto power = [](T log) { return "1e" + std::to_string(std::lround(log / numbers::ln10_v<T>)); };
        const std::string allowed =
            "between " + power(low) + " and " + power(high) + " Pa or so for this surface and law";
        require(false, "pressure", pressure, allowed);
    }
    const auto at = log_slope(found.root);
    const T rounding = Limits::epsilon() * (1 + std::abs(target));  // of the logarithms that are compared
    return {found.root, found.error + (at.error + rounding) / -at.slope};
}

}  // namespace detail
}  // namespace fstiff
