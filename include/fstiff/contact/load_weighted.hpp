// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Mean depth of the peaks of a contact, each peak weighted by its load, to check the range of plastic laws.
///
///     <s>   = sum load omega/omega_c / sum load          omega_c = (its strain)^2 R, where a peak begins to yield
///     <a/R> = sum load a/R / sum load                    a = sqrt(area/pi)
///
/// Reference   this project
/// Units       eta is the separation over the rms height; the means have no unit
/// Valid       as RoughContact
/// Accuracy    the tolerance asked for, 1e-4 by default; each mean carries its bound
///             (tests/contact/load_means_test.cpp)

#include <fstiff/contact/rough_contact.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// \p Law with its load times omega/omega_c as stiffness and its load times a/R as area.
template <Real T, class Law>
class LoadWeighted {
public:
    LoadWeighted(const Law& law, T critical_over_radius) : law_(law), critical_over_radius_(critical_over_radius) {}

    template <class Omega>
    [[nodiscard]] auto load(const Omega& omega, T radius) const {
        return each(omega, [&](T w) { return static_cast<T>(law_.load(w, radius)); });
    }
    template <class Omega>
    [[nodiscard]] auto stiffness(const Omega& omega, T radius) const {
        return each(omega, [&](T w) { return law_.load(w, radius) * (w / (critical_over_radius_ * radius)); });
    }
    template <class Omega>
    [[nodiscard]] auto area(const Omega& omega, T radius) const {
        return each(omega, [&](T w) {
            return law_.load(w, radius) * (std::sqrt(law_.area(w, radius) / std::numbers::pi_v<T>) / radius);
        });
    }
    [[nodiscard]] T critical(T radius) const requires requires(const Law& law) { law.critical(radius); }
    { return law_.critical(radius); }
    [[nodiscard]] auto kinks() const requires requires(const Law& law) { law.kinks(); }
    { return law_.kinks(); }

private:
    Law law_;
    T critical_over_radius_;
};

/// The means over the peaks of \p contact at \p eta, with omega_c = \p critical_over_radius times R. Of a contact with
/// interaction eta is that of its states. \throws domain_error for an eta outside the range of RoughContact, a
/// tolerance outside that of the integrals, and unless critical_over_radius is finite and positive.
template <Real T, class Law, class Peaks>
[[nodiscard]] LoadMeans<T> load_means(const RoughContact<T, Law, Peaks>& contact, T eta, T critical_over_radius,
                                      T relative_tolerance = T(1e-4)) {
    require_positive("critical_over_radius", critical_over_radius);
    RoughContactOptions<T> options = contact.options();
    options.interaction = {};
    options.integrals.relative_tolerance = relative_tolerance;
    const T modulus = contact.effective_modulus(), sigma = contact.rms_height();
    const RoughContact weighted(contact.surface(), contact.peaks(),
                                LoadWeighted<T, Law>(contact.law(), critical_over_radius), modulus, options);
    const auto sums =
        weighted.at_separation(eta * sigma, Quantity::pressure | Quantity::stiffness | Quantity::real_area_fraction);
    const auto over_load = [&](const Estimate<T>& sum, T unit) {
        const T mean = sum.value * unit / sums.pressure.value;
        return Estimate<T>{mean, mean * (sum.error / sum.value + sums.pressure.error / sums.pressure.value),
                           sum.evaluations + sums.pressure.evaluations};
    };
    return {over_load(sums.stiffness, T(1)), over_load(sums.real_area_fraction, modulus)};
}

/// The same for a law that gives the first yield of its peaks.
template <Real T, class Law, class Peaks>
requires requires(const Law& law) { law.critical(T(1)); }
[[nodiscard]] LoadMeans<T> load_means(const RoughContact<T, Law, Peaks>& contact, T eta) {
    return load_means(contact, eta, static_cast<T>(contact.law().critical(T(1))));
}

}}}  // namespace fstiff::detail
