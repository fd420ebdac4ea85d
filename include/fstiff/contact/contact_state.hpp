// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// State of a contact at one separation or pressure, or the reason for its absence, and the search for eta.
///
/// Units       SI, per nominal area
/// Accuracy    absolute bounds for exact inputs; at a given pressure they contain that of the separation

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/peaks/quantity.hpp>

#include <numbers>
#include <optional>

namespace fstiff { inline namespace v0_1 {

/// State of a contact at one separation. Quantities that were not asked for are 0, with 0 evaluations.
template <Real T = double>
struct ContactState {
    T eta{};                         ///< separation at which the peaks meet, over the rms height
    Estimate<T> separation;          ///< of the mean planes [m]
    Estimate<T> pressure;            ///< nominal [Pa]
    Estimate<T> stiffness;           ///< K/A0 [Pa/m]
    Estimate<T> real_area_fraction;  ///< A/A0
    Estimate<T> contact_density;     ///< n/A0 [1/m^2]
    Estimate<T> loading_stiffness;   ///< -dp/dd [Pa/m]: K where the stiffness of the law is the slope of its load
};

namespace detail {

/// True if every value and error of \p state may be doubled: the tangential stiffness is up to 4/3 of K.
template <Real T>
[[nodiscard]] bool in_range(const ContactState<T>& state) {
    for (const Estimate<T>* estimate : {&state.separation, &state.pressure, &state.stiffness, &state.real_area_fraction,
                                        &state.contact_density, &state.loading_stiffness})
        if (!std::isfinite(2 * estimate->value) || !std::isfinite(2 * estimate->error)) return false;
    return true;
}

}  // namespace detail

/// Status of a point: a state, or the kind of its refusal.
enum class PointStatus {
    ok,
    out_of_reach,   ///< the model has no state there; ContactPoint::reason gives its range
    beyond_numbers  ///< a value or an error, doubled, is beyond the range of the scalar
};

/// State at a pressure or a separation, or the reason for its absence.
template <Real T = double>
struct ContactPoint {
    PointStatus status = PointStatus::ok;
    ContactState<T> state{};  ///< out of reach: all 0, but for a stiffness that is NaN
    std::string reason{};     ///< of out_of_reach: the message of the contact; else empty

    [[nodiscard]] bool ok() const { return status == PointStatus::ok; }

    [[nodiscard]] static ContactPoint of(const ContactState<T>& state) {
        return {detail::in_range(state) ? PointStatus::ok : PointStatus::beyond_numbers, state, {}};
    }
    [[nodiscard]] static ContactPoint out_of_reach(std::string reason) {
        ContactPoint point{PointStatus::out_of_reach, {}, std::move(reason)};
        point.state.stiffness.value = std::numeric_limits<T>::quiet_NaN();
        return point;
    }
};

/// A decreasing function of eta as its logarithm, so that its tail does not underflow.
template <Real T = double>
struct LogSlope {
    T log;    ///< log f(eta)
    T slope;  ///< d log f/d eta, < 0
    T error;  ///< relative error of f
};

namespace detail {

inline constexpr int min_eta = -1000;  ///< separations that are searched for a pressure

/// Result of a search for eta.
template <Real T>
struct EtaSearch {
    Estimate<T> eta;
    bool exists = true;
    T log_lowest{}, log_highest{};  ///< if not found: the least and the greatest log f, less the one looked for
};

/// A state, or the refusal of one.
template <Real T>
struct StateOrRefusal {
    ContactState<T> state{};
    std::optional<domain_error> refusal{};

    /// \throws the refusal.
    [[nodiscard]] const ContactState<T>& value() const {
        if (refusal) throw *refusal;
        return state;
    }
    [[nodiscard]] ContactPoint<T> point() const {
        return refusal ? ContactPoint<T>::out_of_reach(refusal->what()) : ContactPoint<T>::of(state);
    }
};

/// The refusal that require() would throw.
template <Real T>
[[nodiscard]] FSTIFF_COLD domain_error refusal_of(std::string_view parameter, T value, std::string_view allowed) {
    const std::string shown = rounded_text(static_cast<double>(value), std::numeric_limits<T>::digits10);
    return domain_error(Refusal{.parameter = parameter, .value = shown, .allowed = allowed});
}

/// Greatest eta, where the tail of a Gaussian underflows, and an exponential one; short of it for the algebraic
/// factors.
template <Real T>
T max_gaussian_eta() {
    return std::sqrt(-2 * std::log((std::numeric_limits<T>::min)())) - 1;
}
template <Real T>
T max_exponential_eta() {
    return -std::log((std::numeric_limits<T>::min)()) - 10;
}

/// Tolerance of the evaluations that only show where the root is.
template <Real T>
inline constexpr T rough_tolerance = T(1e-3);

/// The eta up to \p highest where log f(eta) = \p target. \p log_slope takes eta and whether a rough value will do, and
/// returns a LogSlope. log f is concave and close to its value and slope at 0 plus -eta^2/2: from that guess Halley's
/// method, whose second derivative is the difference of two slopes, arrives in three or four evaluations, the first of
/// them rough; a bracketed search takes over where it does not.
/// Not found when eta would leave [min_eta, highest] or f its range.
template <Real T, class F>
EtaSearch<T> eta_of(T target, T highest, const F& log_slope) {
    using Limits = std::numeric_limits<T>;
    const T rounding = Limits::epsilon() * (1 + std::abs(target));  // of the logarithms that are compared
    LogSlope<T> tangent = log_slope(T(0), true);
    const T at_zero = tangent.log - target;
    const T guess = at_zero > 0 ? std::sqrt(tangent.slope * tangent.slope + 2 * at_zero) + tangent.slope
                                : -std::cbrt(std::exp((std::min)(-2 * at_zero, T(60)))) + 1;
    const T last_rough = T(0.05), close = std::sqrt(Limits::epsilon());  // the next step is its square or less
    bool rough = true;
    T x = guess, last_x = 0;
    for (int i = 0; i < 12 && x >= min_eta && x <= highest; ++i) {
        const T last_slope = tangent.slope;
        tangent = log_slope(x, rough);
        const T newton = (target - tangent.log) / tangent.slope;
        const T bend = x != last_x ? (tangent.slope - last_slope) / (x - last_x) * newton / (2 * tangent.slope) : T(0);
        const T step = std::abs(bend) < T(0.5) ? newton / (1 + bend) : newton;
        last_x = x;
        x += step;
        if (!rough && std::abs(step) <= close)
            return {{x, step * step + (tangent.error + rounding) / -tangent.slope + Limits::epsilon() * std::abs(x)}};
        if (std::abs(step) <= last_rough) rough = false;
    }

    const auto residual = [&](T eta) {
        const auto f = log_slope(eta, false);
        return std::pair(f.log - target, f.slope);
    };
    // no closer than the rounding of the logarithms
    const auto solution = math::newton_bracketed(residual, T(min_eta), highest, guess, 16 * rounding);
    if (!solution.converged())
        return {{}, false, log_slope(highest, false).log - target, log_slope(T(min_eta), false).log - target};
    tangent = log_slope(solution.root, false);
    return {{solution.root, solution.error + (tangent.error + rounding) / -tangent.slope}};
}

/// The reason why \p search, for the logarithm of \p pressure, found no eta.
template <Real T>
[[nodiscard]] FSTIFF_COLD domain_error unreachable_pressure(T pressure, const EtaSearch<T>& search) {
    const T low = std::log(pressure) + search.log_lowest, high = std::log(pressure) + search.log_highest;
    if (!std::isfinite(low) || !std::isfinite(high))
        return refusal_of("pressure", pressure, "possible for the scales of this surface");
    const auto power = [](T log) { return "1e" + std::to_string(std::lround(log / std::numbers::ln10_v<T>)); };
    return refusal_of("pressure", pressure,
                      "between " + power(low) + " and " + power(high) + " Pa or so for this surface and law");
}

}  // namespace detail

}}  // namespace fstiff
