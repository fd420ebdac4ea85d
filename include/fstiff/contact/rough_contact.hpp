// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The contact of a rough surface with a smooth one: pressure, stiffness, real area and contacts against separation or pressure.
///
///     p   = E load_factor D_p sigma^2 (sigma sigma_kappa)^(-1/2) J[3/2,-1/2](eta)
///     K   = E stiffness_factor D_p sigma (sigma sigma_kappa)^(-1/2) J[1/2,-1/2](eta)          eq. (4.9)
///     A   = area_factor D_p sigma/sigma_kappa J[1,-1](eta)         n = D_p J[0,0](eta)         eqs. (4.5), (4.6)
///     sigma_kappa = 3 sqrt(pi)/(8 R)                                                          eq. (4.10)
///
/// all per nominal area, eta the separation over sigma. The law is always named by the caller: FractalLaw is the paper as
/// printed, whose K is not the slope of its p (asperity/laws.hpp).
///
///     const fstiff::Roughness<double> fine{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
///     const auto peaks = fstiff::PeakDensity<double>::exponential(std::numbers::pi / 3);
///     const fstiff::RoughContact contact(fine, peaks, fstiff::FractalLaw<double>(1.62), 112.6e9);
///     const double K = contact.at_pressure(10e6).stiffness.value;
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), section 4.
/// Units       SI at the border: m, Pa, Pa/m, 1/m^2
/// Valid       separations from -1000 to 1e6 rms heights; pressures whose separation is between -1000 rms heights and where
///             the pressure underflows (37 in double)
/// Accuracy    at a separation that of the integrals; at a pressure 1e-13 relative for eta <= 4 (tests/contact/
///             rough_contact_test.cpp); each value carries its own bound

#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/surface/roughness.hpp>

#include <cmath>

namespace fstiff {

/// How the rms curvature sigma_kappa follows from the mean peak radius R.
enum class CurvatureScale {
    bush_gibson_thomas,  ///< 3 sqrt(pi)/(8 R), eq. (4.10)
    consistent           ///< 1/(R E t): the mean curvature of the peaks of the density (4.4) is 1/R
};
template <>
inline constexpr auto names<CurvatureScale> = name_list<CurvatureScale>(
    {{CurvatureScale::bush_gibson_thomas, "bush_gibson_thomas"}, {CurvatureScale::consistent, "consistent"}});

template <Real T>
struct RoughContactOptions {
    Interaction<T> interaction{};
    CurvatureScale curvature = CurvatureScale::bush_gibson_thomas;
    IntegralOptions<T> integrals{};
};

/// sigma_kappa [1/m].
template <Real T>
[[nodiscard]] T rms_curvature(const Roughness<T>& surface, const PeakDensity<T>& peaks, CurvatureScale scale = {}) {
    const T times_radius =
        scale == CurvatureScale::consistent ? 1 / peaks.mean_curvature() : 3 * std::sqrt(numbers::pi_v<T>) / 8;
    return times_radius / surface.peak_radius;
}

template <Real T, PowerLaw Law>
class RoughContact {
public:
    /// \throws domain_error naming the parameter that is out of range.
    RoughContact(const Roughness<T>& surface, const PeakDensity<T>& peaks, const Law& law, T effective_modulus,
                 const RoughContactOptions<T>& options = {})
        : peaks_(peaks), options_(options), rms_height_(surface.rms_height), peak_density_(surface.peak_density) {
        surface.validate();
        options.interaction.validate();
        require_positive("effective_modulus", effective_modulus);
        const T product = surface.rms_height * rms_curvature(surface, peaks, options.curvature);  // sigma sigma_kappa
        const T dimensionless = surface.peak_density * surface.rms_height * surface.rms_height;   // D_p sigma^2
        pressure_scale_ = effective_modulus * law.load_factor() * dimensionless / std::sqrt(product);
        stiffness_scale_ =
            effective_modulus * law.stiffness_factor() * surface.peak_density * surface.rms_height / std::sqrt(product);
        area_scale_ = law.area_factor() * dimensionless / product;
        slope_ratio_ = T(1.5) * law.load_factor() / law.stiffness_factor();
        if (options.interaction.reading != InteractionReading::none)
            bulk_compliance_ = options.interaction.length / effective_modulus;
    }

    /// The contact at the separation \p separation of the mean planes [m]; with interaction as_printed, of the planes that
    /// give the pressure (eta_old). \throws domain_error for a separation outside its range.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity wanted = Quantity::all) const {
        const T eta = separation / rms_height_;
        require(eta >= detail::lowest_eta && eta <= T(1e6), "separation", separation,
                "between -1000 and 1e6 rms heights (m)");
        switch (options_.interaction.reading) {
            case InteractionReading::effective_separation: {
                const auto effective = effective_eta(eta);
                ContactState<T> state =
                    compliant(at_eta(effective, wanted | Quantity::pressure | Quantity::stiffness), wanted);
                state.separation = {separation, 0, 0};
                if (!has(wanted, Quantity::pressure)) state.pressure = {};
                return state;
            }
            case InteractionReading::as_printed:
                return printed(eta, integrals(eta, Quantity::pressure).load * pressure_scale_, wanted);
            case InteractionReading::none:
                break;
        }
        ContactState<T> state = at_eta({eta, 0}, wanted);
        state.separation = {separation, 0, 0};
        return state;
    }

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive and within the reach of the model, which the message tells.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity wanted = Quantity::all) const {
        require_positive("pressure", pressure);
        constexpr Quantity both = Quantity::pressure | Quantity::stiffness;
        ContactIntegrator<T> roughly(peaks_, both,
                                     {std::max(options_.integrals.relative_tolerance, detail::rough_tolerance<T>)});
        ContactIntegrator<T> finely(peaks_, both, options_.integrals);
        const auto eta =
            detail::eta_of(std::log(pressure / pressure_scale_), pressure, detail::highest_gaussian_eta<T>(),
                           [&](T x, bool rough) { return log_slope(rough ? roughly(x) : finely(x)); });
        if (options_.interaction.reading == InteractionReading::as_printed)
            return printed(eta.value, {pressure, 0, 0}, wanted);
        const bool interacting = options_.interaction.reading == InteractionReading::effective_separation;
        ContactState<T> state = at_eta(eta, interacting ? wanted | Quantity::stiffness : wanted);
        state.pressure = {pressure, 0, state.pressure.evaluations};
        return interacting ? compliant(state, wanted) : state;
    }

    /// log(p/Pa) without interaction and its slope against eta, the separation over the rms height.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        LogSlope<T> p = log_slope(
            scaled_contact_integrals(peaks_, eta, Quantity::pressure | Quantity::stiffness, options_.integrals));
        p.log += std::log(pressure_scale_);
        return p;
    }

    [[nodiscard]] T rms_height() const { return rms_height_; }
    [[nodiscard]] const PeakDensity<T>& peaks() const { return peaks_; }
    [[nodiscard]] const Interaction<T>& interaction() const { return options_.interaction; }
    /// Of the bulk in series with the interface, L/E [m/Pa]: 0 without interaction.
    [[nodiscard]] T bulk_compliance() const { return bulk_compliance_; }
    /// K over -dp/dd without interaction: 1 but for FractalLaw.
    [[nodiscard]] T stiffness_over_slope() const { return 1 / slope_ratio_; }

private:
    /// Of the load.
    static LogSlope<T> log_slope(const ContactIntegrals<T>& j) {
        return {std::log(j.load.value) + j.log_scale, T(-1.5) * j.stiffness.value / j.load.value,
                j.load.error / j.load.value};
    }

    ContactIntegrals<T> integrals(T eta, Quantity wanted) const {
        return contact_integrals(peaks_, eta, wanted, options_.integrals);
    }

    /// Without interaction; the error of eta enters every value by its slope, |d log J/d eta| <= |d log J[0,0]/d eta|, which
    /// is about eta + 1.
    ContactState<T> at_eta(const detail::EtaEstimate<T>& eta, Quantity wanted) const {
        const ContactIntegrals<T> j = integrals(eta.value, wanted);
        const T relative = eta.error * (2 + std::max(eta.value, T(0)));
        const auto scaled = [relative](const Estimate<T>& integral, T scale) {
            Estimate<T> out = integral * scale;
            out.error += (relative + 4 * std::numeric_limits<T>::epsilon()) * out.value;
            return out;
        };
        return {eta.value,
                {eta.value * rms_height_, eta.error * rms_height_, 0},
                scaled(j.load, pressure_scale_),
                scaled(j.stiffness, stiffness_scale_),
                scaled(j.area, area_scale_),
                scaled(j.contacts, peak_density_)};
    }

    /// Adds the bulk's compliance L/E in series: the planes approach by p L/E more, and dp/dd is smaller by 1 + K_slope L/E,
    /// where K_slope = -dp/dd of the effective separation (for FractalLaw not its K).
    ContactState<T> compliant(ContactState<T> state, Quantity wanted) const {
        const T sink = state.pressure.value * bulk_compliance_;
        state.separation.value -= sink;
        state.separation.error +=
            state.pressure.error * bulk_compliance_ + 2 * std::numeric_limits<T>::epsilon() * sink;
        const T share = 1 / (1 + slope_ratio_ * state.stiffness.value * bulk_compliance_);
        state.stiffness =
            has(wanted, Quantity::stiffness)
                ? Estimate<T>{state.stiffness.value * share, state.stiffness.error * share, state.stiffness.evaluations}
                : Estimate<T>{};
        return state;
    }

    ContactState<T> printed(T eta_old, const Estimate<T>& pressure, Quantity wanted) const {
        const T eta_new = eta_old - pressure.value * bulk_compliance_ / rms_height_;
        require(eta_new >= detail::lowest_eta, "eta_new", eta_new,
                "at least -1000 (separation over rms height after (4.11))");
        ContactState<T> state =
            at_eta({eta_new, 4 * std::numeric_limits<T>::epsilon() * (std::abs(eta_old) + std::abs(eta_new))}, wanted);
        state.pressure = pressure;
        return state;
    }

    /// The root of eta_effective - Delta(eta_effective) = eta: increasing, between eta and eta + Delta(eta).
    detail::EtaEstimate<T> effective_eta(T eta) const {
        const T shift = bulk_compliance_ * pressure_scale_ / rms_height_;  // Delta = shift J[3/2,-1/2]
        const T highest = eta + shift * integrals(eta, Quantity::pressure).load.value;
        const auto found = newton_bracketed(
            [&](T x) {
                const auto j = integrals(x, Quantity::pressure | Quantity::stiffness);
                return std::pair(x - shift * j.load.value - eta, 1 + T(1.5) * shift * j.stiffness.value);
            },
            eta, highest, eta + (highest - eta) / 4, 4 * std::numeric_limits<T>::epsilon() * (1 + std::abs(eta)));
        return {found.root, found.error};
    }

    PeakDensity<T> peaks_;
    RoughContactOptions<T> options_;
    T rms_height_;
    T peak_density_;
    T pressure_scale_{};   ///< p/J[3/2,-1/2] [Pa]
    T stiffness_scale_{};  ///< K/J[1/2,-1/2] [Pa/m]
    T area_scale_{};       ///< A/J[1,-1]
    T slope_ratio_{};      ///< -dp/dd over K
    T bulk_compliance_{};  ///< L/E [m/Pa], 0 without interaction
};

}  // namespace fstiff
