// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Derivatives of K of Persson's theory at a given pressure by each parameter, for fits and error bands.
///
///     dK/dE = K/E (1 - d ln K/d ln p), since E enters as p/E alone; the others by central differences of six points
///
/// Each parameter of the band of the spectrum (surface/roughness_spectrum.hpp) is changed while the others stay.
///
/// Reference   contact/persson_contact.hpp; the differences: Abramowitz and Stegun, 25.3
/// Units       each derivative in Pa/m per unit of its parameter (SI)
/// Valid       as PerssonContact; 0.02 < H < 0.98, alpha above 1.53
/// Accuracy    dK/dE, dK/dp, dK/dgamma 1e-12, the others 1e-8 of K per relative change
///             (tests/contact/persson_sensitivity_test.cpp)

#include <fstiff/contact/persson_contact.hpp>

#include <cmath>

namespace fstiff {

/// What a band of roughness is made of, and the modulus.
template <Real T = double>
struct PerssonParameters {
    T rms_height{};         ///< sigma [m]
    T rms_gradient{};       ///< g of the surface
    T alpha{};              ///< Nayak's m0 m4/m2^2
    T hurst = T(0.8);       ///< H
    T effective_modulus{};  ///< E [Pa]
    T gamma = T(0.45);

    /// \throws domain_error naming the parameter that is out of range.
    [[nodiscard]] PerssonContact<T> contact() const {
        return {band_of_moments(moments_of_gradient(rms_height, rms_gradient, alpha), hurst), effective_modulus, gamma};
    }
};

/// K and its derivatives at constant pressure.
template <Real T = double>
struct PerssonSensitivity {
    T stiffness{};          ///< K [Pa/m]
    T pressure{};           ///< dK/dp [1/m]
    T rms_height{};         ///< dK/dsigma [Pa/m^2]
    T rms_gradient{};       ///< dK/dg [Pa/m]
    T alpha{};              ///< dK/dalpha [Pa/m]
    T hurst{};              ///< dK/dH [Pa/m]
    T effective_modulus{};  ///< dK/dE [1/m]
    T gamma{};              ///< dK/dgamma [Pa/m]
};

/// \throws domain_error as PerssonContact, and outside of what is valid above.
template <Real T>
[[nodiscard]] PerssonSensitivity<T> sensitivity(const PerssonParameters<T>& at, std::type_identity_t<T> pressure) {
    require(at.hurst > T(0.02) && at.hurst < T(0.98), "hurst", at.hurst, "between 0.02 and 0.98, for its derivative");
    require(at.alpha > T(1.53), "alpha", at.alpha, "greater than 1.53, for its derivative");
    const auto K = at.contact().stiffness_and_slope(pressure);
    const auto by = [&](T PerssonParameters<T>::*parameter, T step) {
        const auto stiffness = [&](T steps) {
            PerssonParameters<T> changed = at;
            changed.*parameter += steps * step;
            return changed.contact().stiffness(pressure);
        };
        const auto odd = [&](T steps) { return stiffness(steps) - stiffness(-steps); };
        return (45 * odd(T(1)) - 9 * odd(T(2)) + odd(T(3))) / (60 * step);
    };
    using P = PerssonParameters<T>;
    PerssonSensitivity<T> out;
    out.stiffness = K.stiffness;
    out.pressure = K.slope;
    out.rms_height = by(&P::rms_height, at.rms_height * T(0.005));
    out.rms_gradient = by(&P::rms_gradient, at.rms_gradient * T(0.005));
    out.alpha = by(&P::alpha, (at.alpha - T(1.5)) * T(0.005));
    out.hurst = by(&P::hurst, T(0.005));
    out.effective_modulus = (K.stiffness - pressure * K.slope) / at.effective_modulus;
    // 1/K is linear in gamma: a second point tells its slope
    PerssonParameters<T> other = at;
    other.gamma = at.gamma > T(0.5) ? at.gamma / 2 : 2 * at.gamma;
    const T slope = (1 / other.contact().stiffness(pressure) - 1 / K.stiffness) / (other.gamma - at.gamma);
    out.gamma = -K.stiffness * K.stiffness * slope;
    return out;
}

}  // namespace fstiff
