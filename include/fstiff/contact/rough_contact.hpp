// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of a rough surface with a smooth one: pressure, stiffness, real area and contacts, per nominal area.
///
///     p = E load_factor D_p sigma^2 (sigma sigma_kappa)^(-1/2) J[3/2,-1/2](eta)
///     K = E stiffness_factor D_p sigma (sigma sigma_kappa)^(-1/2) J[1/2,-1/2](eta)          eq. (4.9)
///     A = area_factor D_p sigma/sigma_kappa J[1,-1](eta)         n = D_p J[0,0](eta)         eqs. (4.5), (4.6)
///
/// ```cpp
/// #include <fstiff/asperity/laws.hpp>
/// #include <fstiff/contact/rough_contact.hpp>
///
/// #include <cstdio>
///
/// int main() {
///     const fstiff::Roughness<double> rough{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
///     const fstiff::PeakDistribution<double> peaks(0.5, 1.0);  // r, theta
///     const fstiff::RoughContact contact(rough, peaks, fstiff::FractalLaw<double>(1.62), 112.6e9);
///     const auto state = contact.at_pressure(10e6);
///     std::printf("K/A0 = %.4e Pa/m, real area %.2e\n", state.stiffness.value, state.real_area_fraction.value);
/// }
/// ```
/// ```text
/// K/A0 = 7.6998e+13 Pa/m, real area 2.19e-03
/// ```
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), section 4; docs/theory-contact.md, section 5
/// Units       SI at the border: m, Pa, Pa/m, 1/m^2; eta = d/sigma, sigma_kappa = 3 sqrt(pi)/(8 R), eq. (4.10)
/// Valid       separations from -1000 to 1e6 rms heights, and their pressures until they underflow (eta = 37)
/// Accuracy    1e-13 at a separation and at a pressure for eta <= 4; each value carries its bound
///             (tests/contact/rough_contact_test.cpp, tests/contact/random_contacts_test.cpp)

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/load_means.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/peaks/contact_integrals.hpp>
#include <fstiff/peaks/law_means.hpp>
#include <fstiff/peaks/law_sums.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/surface/moments.hpp>

namespace fstiff { inline namespace v0_1 {

/// Rms curvature sigma_kappa from the mean peak radius R.
enum class CurvatureScale {
    bush_gibson_thomas,  ///< 3 sqrt(pi)/(8 R), eq. (4.10)
    consistent           ///< 1/(R E t): the mean curvature of the peaks of the density (4.4) is 1/R
};

template <>
inline constexpr auto enum_names<CurvatureScale> = detail::name_list<CurvatureScale>(
    {{CurvatureScale::bush_gibson_thomas, "bush_gibson_thomas"}, {CurvatureScale::consistent, "consistent"}});

/// Options of a RoughContact.
template <Real T = double>
struct RoughContactOptions {
    Interaction<T> interaction{};
    CurvatureScale curvature = CurvatureScale::bush_gibson_thomas;
    IntegralOptions<T> integrals{};
};

namespace detail {

/// sigma_kappa [1/m].
template <Real T>
[[nodiscard]] T rms_curvature(const Roughness<T>& surface, const PeakDistribution<T>& peaks,
                              CurvatureScale scale = {}) {
    const T times_radius =
        scale == CurvatureScale::consistent ? 1 / peaks.mean_curvature() : radius_times_rms_curvature<T>();
    return times_radius / surface.peak_radius;
}

/// sigma_kappa for the joint distribution, 1/R for peaks of one radius [1/m].
template <Real T>
[[nodiscard]] T rms_curvature(const Roughness<T>& surface, const SingleRadius<T>&, CurvatureScale = {}) {
    return 1 / surface.peak_radius;
}

}  // namespace detail

/// The contact of a distribution of peaks, each of which obeys one law: load, stiffness, area and number.
template <Real T, class Law, class Peaks = PeakDistribution<T>>
class RoughContact {
    static_assert(detail::PowerLaw<Law, T> || detail::HasLoad<Law, T>,
                  "this law has no member load(omega, radius) for numbers or an Eigen array, nor factors and powers");
    static_assert(detail::PowerLaw<Law, T> || detail::HasStiffness<Law, T>,
                  "this law has no member stiffness(omega, radius) for numbers or an Eigen array");
    static_assert(detail::PowerLaw<Law, T> || detail::HasArea<Law, T>,
                  "this law has no member area(omega, radius) for numbers or an Eigen array");

public:
    /// \throws domain_error naming the parameter that is out of range.
    RoughContact(const Roughness<T>& surface, const Peaks& peaks, const Law& law,
                 std::type_identity_t<T> effective_modulus, const RoughContactOptions<T>& options = {})
        : surface_(surface),
          peaks_(peaks),
          law_(law),
          options_(options),
          scales_{surface.rms_height, surface.peak_density, effective_modulus,
                  detail::rms_curvature(surface, peaks, options.curvature)} {
        surface.validate();
        options.interaction.validate();
        detail::require_positive("effective_modulus", effective_modulus);
        if constexpr (detail::PowerLaw<Law, T>)
            pressure_unit_ = scales_.unit(effective_modulus * static_cast<T>(law.load_factor()), Law::load_powers);
        else
            pressure_unit_ = effective_modulus * (surface.peak_density * surface.rms_height * surface.rms_height);
        if (options.interaction.reading != InteractionReading::none)
            bulk_compliance_ = options.interaction.length / effective_modulus;
    }

    /// The contact at the separation \p separation of the mean planes [m]; with interaction as_printed, of the planes
    /// that give the pressure (eta_old). \throws domain_error for a separation outside its range.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        return state_at_separation(separation, quantities).value();
    }
    /// The same with a status: a separation outside the range is out_of_reach. Does not throw.
    [[nodiscard]] ContactPoint<T> point_at_separation(T separation, Quantity quantities = Quantity::all) const {
        return state_at_separation(separation, quantities).point();
    }

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive and within the reach of the model, which the message gives.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        return state_at_pressure(pressure, quantities).value();
    }
    /// The same with a status: out_of_reach beyond the model. \throws domain_error unless positive.
    [[nodiscard]] ContactPoint<T> point_at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        return state_at_pressure(pressure, quantities).point();
    }

    /// log(p/Pa) without interaction and its slope against eta, the separation over the rms height.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        LogSlope<T> p = log_slope(sums(eta, slope_quantities));
        p.log += std::log(pressure_unit_);
        return p;
    }
    /// log(K/(Pa/m)) without interaction at eta; its error is the relative one of K.
    [[nodiscard]] Estimate<T> log_stiffness(T eta) const {
        const detail::LawSums<T> j = sums(eta, Quantity::stiffness);
        return {std::log(j.stiffness.value) + j.log_scale, j.stiffness.error / j.stiffness.value};
    }

    [[nodiscard]] T rms_height() const { return scales_.rms_height; }
    [[nodiscard]] const Roughness<T>& surface() const { return surface_; }
    [[nodiscard]] T effective_modulus() const { return scales_.effective_modulus; }  ///< [Pa]
    [[nodiscard]] const RoughContactOptions<T>& options() const { return options_; }
    [[nodiscard]] const Peaks& peaks() const { return peaks_; }
    [[nodiscard]] const Law& law() const { return law_; }
    [[nodiscard]] const Interaction<T>& interaction() const { return options_.interaction; }
    /// Compliance of the bulk in series, L/E [m/Pa]: 0 without interaction.
    [[nodiscard]] T bulk_compliance() const { return bulk_compliance_; }
    /// True if K is a constant times -dp/dd without interaction, at every separation.
    static constexpr bool stiffness_follows_slope = [] {
        if constexpr (detail::PowerLaw<Law, T>)
            return Law::stiffness_powers == HalfPowers{Law::load_powers.omega - 2, Law::load_powers.radius};
        else if constexpr (requires { Law::stiffness_is_slope; })
            return static_cast<bool>(Law::stiffness_is_slope);
        else
            return false;
    }();
    /// K over -dp/dd without interaction: 1 where the stiffness of the law is the slope of its load.
    [[nodiscard]] T stiffness_over_slope() const requires stiffness_follows_slope {
        if constexpr (detail::PowerLaw<Law, T>)
            return static_cast<T>(law_.stiffness_factor()) /
                   (T(Law::load_powers.omega) / 2 * static_cast<T>(law_.load_factor()));
        else
            return T(1);
    }

private:
    using Integrator = detail::LawIntegrator<T, Law, Peaks>;
    static constexpr Quantity slope_quantities = Quantity::pressure | Quantity::loading_stiffness;
    static constexpr Quantity for_compliance = Quantity::pressure | Quantity::stiffness | Quantity::loading_stiffness;

    using Outcome = detail::StateOrRefusal<T>;

    [[nodiscard]] Outcome state_at_separation(T separation, Quantity quantities) const {
        const T eta = separation / scales_.rms_height;
        if (!(eta >= detail::min_eta && eta <= T(1e6))) {
            const T rms = scales_.rms_height;
            return {
                {},
                detail::refusal_of("separation", separation,
                                   "between " + detail::shortest_text(static_cast<T>(detail::min_eta) * rms) + " and " +
                                       detail::shortest_text(T(1e6) * rms) + " m, -1000 and 1e6 rms heights")};
        }
        switch (options_.interaction.reading) {
            case InteractionReading::effective_separation: {
                ContactState<T> state = compliant(at_eta(effective_eta(eta), quantities | for_compliance), quantities);
                state.separation = {separation, 0, 0};
                if (!detail::has(quantities, Quantity::pressure)) state.pressure = {};
                return {state, {}};
            }
            case InteractionReading::as_printed:
                return printed(eta, unscaled(sums(eta, Quantity::pressure), eta).load, quantities);
            case InteractionReading::none: break;
        }
        ContactState<T> state = at_eta({eta, 0}, quantities);
        state.separation = {separation, 0, 0};
        return {state, {}};
    }

    [[nodiscard]] Outcome state_at_pressure(T pressure, Quantity quantities) const {
        detail::require_positive("pressure", pressure);
        if constexpr (requires { law_.pressure_limit(); })  // of a plastic law, at which all of the area is in contact
            if (!(pressure < static_cast<T>(law_.pressure_limit())))
                return {{}, detail::refusal_of("pressure", pressure, "less than the hardness of the law (Pa)")};
        Integrator roughly(law_, peaks_, scales_, slope_quantities,
                           (std::max)(options_.integrals.relative_tolerance, detail::rough_tolerance<T>));
        Integrator finely(law_, peaks_, scales_, slope_quantities, options_.integrals.relative_tolerance);
        const auto search = detail::eta_of(std::log(pressure / pressure_unit_), max_eta(),
                                           [&](T x, bool rough) { return log_slope(rough ? roughly(x) : finely(x)); });
        if (!search.exists) return {{}, detail::unreachable_pressure(pressure, search)};
        if (options_.interaction.reading == InteractionReading::as_printed)
            return printed(search.eta.value, {pressure, 0, 0}, quantities);
        const bool interacting = options_.interaction.reading == InteractionReading::effective_separation;
        ContactState<T> state = at_eta(search.eta, interacting ? quantities | for_compliance : quantities);
        state.pressure = {pressure, 0, state.pressure.evaluations};
        return {interacting ? compliant(state, quantities) : state, {}};
    }

    detail::LawSums<T> sums(T eta, Quantity quantities) const {
        return Integrator(law_, peaks_, scales_, quantities, options_.integrals.relative_tolerance)(eta);
    }

    /// Logarithm of the load over pressure_unit_, and its slope.
    LogSlope<T> log_slope(const detail::LawSums<T>& j) const {
        return {std::log(j.load.value / pressure_unit_) + j.log_scale,
                -j.loading.value * scales_.rms_height / j.load.value, j.load.error / j.load.value};
    }

    [[nodiscard]] T max_eta() const {
        if constexpr (std::same_as<Peaks, SingleRadius<T>>) {
            if (peaks_.measured) return peaks_.measured->most();
            if (peaks_.heights == Heights::exponential) return detail::max_exponential_eta<T>();
        }
        return detail::max_gaussian_eta<T>();
    }

    /// exp(log_scale) multiplied in.
    detail::LawSums<T> unscaled(detail::LawSums<T> j, T eta) const {
        T scale = math::gaussian((std::max)(eta, T(0)));
        if constexpr (std::same_as<Peaks, SingleRadius<T>>)
            if (peaks_.measured || peaks_.heights == Heights::exponential) scale = std::exp(j.log_scale);
        return {j.contacts * scale, j.load * scale, j.stiffness * scale, j.area * scale, j.loading * scale, T(0)};
    }

    /// State without interaction; the error of eta enters by the slope |d log J/d eta| <= |d log J[0,0]/d eta|, about
    /// eta + 1.
    ContactState<T> at_eta(const Estimate<T>& eta, Quantity quantities) const {
        const detail::LawSums<T> j = unscaled(sums(eta.value, quantities), eta.value);
        const T relative = eta.error * (2 + (std::max)(eta.value, T(0)));
        const auto with_eta = [relative](Estimate<T> sum) {
            sum.error += (relative + 4 * std::numeric_limits<T>::epsilon()) * std::abs(sum.value);
            return sum;
        };
        return {eta.value,          {eta.value * scales_.rms_height, eta.error * scales_.rms_height, 0},
                with_eta(j.load),   with_eta(j.stiffness),
                with_eta(j.area),   with_eta(j.contacts),
                with_eta(j.loading)};
    }

    /// Adds the compliance L/E of the bulk in series: the planes approach by p L/E more, and -dp/dd is smaller by 1 +
    /// (-dp/dd) L/E. A K that is a constant times it (of FractalLaw, whose factor thus multiplies the bulk too) shrinks
    /// with it; any other K is itself in series with the bulk.
    ContactState<T> compliant(ContactState<T> state, Quantity quantities) const {
        const T sink = state.pressure.value * bulk_compliance_;
        state.separation.value -= sink;
        state.separation.error +=
            state.pressure.error * bulk_compliance_ + 2 * std::numeric_limits<T>::epsilon() * sink;
        const auto in_series = [&](Quantity quantity, Estimate<T>& k, T inner) {
            const T share = 1 / (1 + inner * bulk_compliance_);
            k = detail::has(quantities, quantity) ? Estimate<T>{k.value * share, k.error * share, k.evaluations}
                                                  : Estimate<T>{};
        };
        const T slope = state.loading_stiffness.value;
        in_series(Quantity::stiffness, state.stiffness, stiffness_follows_slope ? slope : state.stiffness.value);
        in_series(Quantity::loading_stiffness, state.loading_stiffness, slope);
        return state;
    }

    Outcome printed(T eta_old, const Estimate<T>& pressure, Quantity quantities) const {
        const T eta_new = eta_old - pressure.value * bulk_compliance_ / scales_.rms_height;
        if (!(eta_new >= detail::min_eta))
            return {{},
                    detail::refusal_of("eta_new", eta_new, "at least -1000 (separation over rms height after (4.11))")};
        ContactState<T> state = at_eta(
            {eta_new, 4 * std::numeric_limits<T>::epsilon() * (std::abs(eta_old) + std::abs(eta_new))}, quantities);
        state.pressure = pressure;
        return {state, {}};
    }

    /// The root of eta_effective - Delta(eta_effective) = eta: increasing, between eta and eta + Delta(eta).
    Estimate<T> effective_eta(T eta) const {
        const T shift = bulk_compliance_ / scales_.rms_height;  // Delta = shift p
        const T rough = options_.integrals.relative_tolerance * options_.integrals.relative_tolerance;
        const T highest =
            (std::min)(eta + shift * unscaled(sums(eta, Quantity::pressure), eta).load.value, (std::max)(eta, T(1e6)));
        const auto solution = math::newton_bracketed(
            [&](T x) {
                const auto j = unscaled(sums(x, slope_quantities), x);
                return std::pair(x - shift * j.load.value - eta, 1 + shift * j.loading.value * scales_.rms_height);
            },
            eta, highest, eta + (highest - eta) / 4,
            (std::max)(4 * std::numeric_limits<T>::epsilon(), rough) * (1 + std::abs(eta)));
        return {solution.root, solution.error};
    }

    Roughness<T> surface_;
    Peaks peaks_;
    Law law_;
    RoughContactOptions<T> options_;
    detail::PeakScales<T> scales_;
    T pressure_unit_{};    ///< unit of p in log p [Pa]
    T bulk_compliance_{};  ///< L/E [m/Pa], 0 without interaction
};

}}  // namespace fstiff
