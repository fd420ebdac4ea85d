// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of a surface f(zeta) known by its bearing curve f and the moments of zeta.
///
///     K(p) = K_g(p/rho)     A/A0 = A_g(p/rho)     n = n_g(p/rho)     d = int_p dp'/K
///
/// g marks the Gaussian surface, rho the local scale of a BearingContact with the same curve, up to whose
/// full_pressure() d is integrated.
///
/// Reference   contact/bearing_contact.hpp
/// Units       SI
/// Valid       pressures as \p Of at p/rho; separations above 0
/// Accuracy    K that of its parts, separation 1e-4 of the rms height (tests/contact/scaled_contact_test.cpp). Against
///             boundary elements: docs/validation.md

#include <fstiff/contact/bearing_contact.hpp>
#include <fstiff/contact/contact_concept.hpp>
#include <fstiff/contact/slope_contact.hpp>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace fstiff {

/// \p Of is the contact of the Gaussian surface: HybridContact of its peaks and its spectrum.
template <Real T, Contact<T> Of>
class ScaledContact : public SlopeContact<ScaledContact<T, Of>, T> {
public:
    ScaledContact(Of of, BearingContact<T> bearing) : of_(std::move(of)), bearing_(std::move(bearing)) {}

    /// The contact under the nominal pressure \p pressure [Pa]. \throws domain_error as \p Of at p/rho.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity wanted = Quantity::all) const {
        ContactState<T> state =
            of_.at_pressure(pressure / bearing_.local_scale(pressure), without(wanted, Quantity::separation));
        state.pressure = {pressure, 0, 0};
        state.separation = has(wanted, Quantity::separation) ? separation(pressure) : Estimate<T>{};
        state.eta = state.separation.value / rms_height();
        return state;
    }
    /// The contact at the separation \p separation [m] of the mean planes.
    /// \throws domain_error unless it is positive and its pressure within reach.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity wanted = Quantity::all) const {
        return this->state_at_separation(separation, wanted);
    }
    /// K [Pa/m] under \p pressure [Pa]. \throws domain_error as at_pressure.
    [[nodiscard]] T stiffness(T pressure) const {
        const T scaled = pressure / bearing_.local_scale(pressure);
        if constexpr (requires { of_.stiffness(scaled); })  // beyond what was compared too
            return of_.stiffness(scaled);
        else
            return of_.at_pressure(scaled, Quantity::stiffness).stiffness.value;
    }
    /// Separation [m] of the mean planes; 0 from the full pressure on. \throws domain_error as at_pressure.
    [[nodiscard]] Estimate<T> separation(T pressure) const {
        require_positive("pressure", pressure);
        const T to = std::log(bearing_.full_pressure()), from = std::log(pressure);
        const T error = T(1e-4) * rms_height();
        if (from >= to) return {T(0), error, 0};
        const auto whole = static_cast<int>((to - from) * 2);  // panels at the same places for every pressure
        T d = this->template fall_of_separation<8>(from, to - T(whole) / 2 - from);
        for (int i = 1; i <= whole; ++i) d += this->template fall_of_separation<8>(to - T(i) / 2, T(1) / 2);
        return {d, error, 8 * (whole + 1)};
    }
    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless 0 < eta and its pressure is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        require(eta > 0 && std::isfinite(eta), "eta", eta, "finite and greater than 0 (separation over rms height)");
        const T high = std::log(bearing_.full_pressure());
        return this->searched_log_pressure(eta, high - 60, high, high - T(1.5) - 2 * eta, "within the reach of the laws");
    }

    [[nodiscard]] T rms_height() const { return bearing_.rms_height(); }
    [[nodiscard]] bool has_kinks() const { return detail::has_kinks(of_) || bearing_.has_kinks(); }
    [[nodiscard]] const Of& gaussian() const { return of_; }
    [[nodiscard]] const BearingContact<T>& bearing() const { return bearing_; }

private:
    Of of_;
    BearingContact<T> bearing_;
};

template <class Of, class Bearing>
ScaledContact(Of, Bearing) -> ScaledContact<std::remove_cvref_t<decltype(std::declval<Of>().rms_height())>, Of>;

}  // namespace fstiff
