// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Checks of the range of the elastic multi-asperity models: each by its name, with its numbers and its limit.
///
///     for (const auto& check : fstiff::detail::check_curve<double>(states, {.effective_modulus = 112.6e9,
///                                                                         .rms_gradient = 0.08}))
///         if (!check.holds()) warn(name_of(check.concern), check.first, check.greatest, check.limit);
///
/// Nothing is refused: a check that does not hold reports the states, and the numbers stay as they are. Every quantity,
/// its limit and the reason: docs/theory-contact.md, section 12.
///
/// Reference   Greenwood, Williamson, Proc. R. Soc. Lond. A 295 (1966) 300-319 (psi); Greenwood, Proc. R. Soc. Lond. A
///             393 (1984) 133-157 (r = sigma_m^2/(sigma sigma_kappa), sigma_m the slope of a profile); Tabor, The
///             Hardness of Metals (1951) (2.8); the limits 0.01, 10 and 1e-6 are this project's.
/// Units       SI; the numbers returned are dimensionless, but for separations [m] and mean pressures [Pa]
/// Valid       states of one contact, with finite values

#include <fstiff/answer/concern.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/surface/moments.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real T>
inline constexpr T min_gaussian_product = T(0.0249);  ///< least sigma R D_p of an isotropic Gaussian surface

template <Real T>
inline constexpr T max_dimensionless_pressure = T(0.01);  ///< p* above which independent peaks are in doubt

template <Real T>
inline constexpr T hardness_over_yield_strength = T(2.8);  ///< H/Y of the plasticity index

template <Real T>
inline constexpr T max_elastic_plasticity_index = T(1);  ///< psi above which the peaks yield at first loading

template <Real T>
inline constexpr T max_plausible_height = T(1e-3);  ///< rms height [m] above which a unit is likely wrong

template <Real T>
inline constexpr T min_plausible_modulus = T(1e3);  ///< [Pa] below which a unit is likely wrong

template <Real T>
inline constexpr T min_plausible_pressure = T(1e-9);  ///< over the effective modulus, the same

template <Real T>
inline constexpr T min_contacts = T(10);  ///< on the nominal area, below which a mean over peaks is of little use

/// psi for the yield strength Y [Pa] of the softer body. \throws domain_error naming what is not positive.
template <Real T>
[[nodiscard]] T plasticity_index(const Roughness<T>& surface, T effective_modulus, T yield_strength) {
    surface.validate();
    require_positive("effective_modulus", effective_modulus);
    require_positive("yield_strength", yield_strength);
    return effective_modulus / (hardness_over_yield_strength<T> * yield_strength) *
           std::sqrt(surface.rms_height / surface.peak_radius);
}

/// g_rms = sqrt(2 r sigma sigma_kappa) of the surface; none for r = 0, where the slopes are of another scale than
/// heights and curvatures.
template <Real T>
[[nodiscard]] std::optional<T> rms_gradient(const Roughness<T>& surface, const PeakDistribution<T>& peaks,
                                            CurvatureScale scale = {}) {
    if (peaks.r() == 0) return std::nullopt;
    return std::sqrt(2 * peaks.r() * surface.rms_height * rms_curvature(surface, peaks, scale));
}

/// p* = p/(E g_rms).
template <Real T>
[[nodiscard]] T dimensionless_pressure(T pressure, T effective_modulus, T rms_gradient) {
    return pressure / (effective_modulus * rms_gradient);
}

/// The check of \p concern among \p checks; null when it was not made.
template <Real T>
[[nodiscard]] const Check<T>* find_check(const std::vector<Check<T>>& checks, Concern concern) {
    const auto match =
        std::find_if(checks.begin(), checks.end(), [&](const auto& check) { return check.concern == concern; });
    return match == checks.end() ? nullptr : &*match;
}

template <Real T>
Check<T> surface_check(Concern concern, T value, T limit, bool holds) {
    return {concern, limit, value, value, holds ? std::size_t(0) : std::size_t(1), 0};
}

/// The checks that need no state: plasticity when \p yield_strength [Pa] is known, gaussian_surface always.
/// \throws domain_error as plasticity_index.
template <Real T>
[[nodiscard]] std::vector<Check<T>> check_surface(const Roughness<T>& surface, T effective_modulus,
                                                  std::optional<T> yield_strength = {}) {
    std::vector<Check<T>> checks;
    if (yield_strength) {
        const T psi = plasticity_index(surface, effective_modulus, *yield_strength);
        checks.push_back(surface_check(Concern::plasticity, psi, max_elastic_plasticity_index<T>,
                                       psi <= max_elastic_plasticity_index<T>));
    }
    const T product = surface.rms_height * surface.peak_radius * surface.peak_density;
    constexpr T least = min_gaussian_product<T>;
    checks.push_back(surface_check(Concern::gaussian_surface, product, least, product >= least));
    return checks;
}

/// The rms gradients that a surface implies: by R and D_p, sqrt(2 m2) of moments_of_peaks(); by sigma and R,
/// sqrt(2 r sigma sigma_kappa), with r = 1/2 where \p r is 0, which gives none. \throws domain_error as
/// moments_of_peaks().
template <Real T>
[[nodiscard]] std::array<T, 2> implied_gradients(const Roughness<T>& surface, T r) {
    const SpectralMoments<T> moments = moments_of_peaks(surface.rms_height, surface.peak_radius, surface.peak_density);
    const T curvature = radius_times_rms_curvature<T>() / surface.peak_radius;
    return {std::sqrt(2 * moments.m2), std::sqrt(2 * (r > T(0) ? r : T(0.5)) * surface.rms_height * curvature)};
}

/// Limits for the states of a curve; a check is made only if all its inputs are given.
template <Real T = double>
struct CurveLimits {
    T effective_modulus{};              ///< [Pa], for p*
    std::optional<T> rms_gradient{};    ///< for p*
    T max_peak_height{};                ///< R_p [m]; 0: not known
    std::optional<T> nominal_area{};    ///< [m^2], for few_contacts
    std::optional<T> yield_strength{};  ///< [Pa]; without it above_hardness has its values, and always holds
};

/// The checks of \p states, which hold the quantities \p known and always separation and pressure; in the order of
/// Concern.
template <Real T>
[[nodiscard]] std::vector<Check<T>> check_curve(std::span<const ContactState<T>> states, const CurveLimits<T>& limits,
                                                Quantity known = Quantity::all) {
    std::vector<Check<T>> checks;
    // value_of gives the number that is shown, or none; broken is true where the check does not hold
    const auto check = [&](Concern concern, T limit, const auto& value_of, const auto& broken) {
        Check<T> result{.concern = concern, .limit = limit};
        for (std::size_t i = 0; i < states.size(); ++i) {
            const std::optional<T> value = value_of(states[i]);
            if (!value) continue;
            result.least = (std::min)(result.least, *value);
            result.greatest = (std::max)(result.greatest, *value);
            if (broken(states[i], *value) && result.violations++ == 0) result.first = i;
        }
        checks.push_back(result);
    };
    const auto above = [&](Concern concern, T limit, const auto& value_of) {
        check(concern, limit, value_of, [limit](const ContactState<T>&, T value) { return value > limit; });
    };
    const auto below = [&](Concern concern, T limit, const auto& value_of) {
        check(concern, limit, value_of, [limit](const ContactState<T>&, T value) { return value < limit; });
    };
    using State = ContactState<T>;
    const auto separation = [](const State& state) { return std::optional(state.separation.value); };
    if (limits.rms_gradient)
        above(Concern::interacting_asperities, max_dimensionless_pressure<T>, [&](const State& state) {
            return std::optional(
                dimensionless_pressure(state.pressure.value, limits.effective_modulus, *limits.rms_gradient));
        });
    below(Concern::mean_planes_crossed, T(0), separation);
    if (limits.max_peak_height > T(0)) above(Concern::above_highest_peak, limits.max_peak_height, separation);
    if (has(known, Quantity::contact_density) && limits.nominal_area)
        below(Concern::few_contacts, min_contacts<T>,
              [&](const State& state) { return std::optional(state.contact_density.value * *limits.nominal_area); });
    if (has(known, Quantity::real_area_fraction)) {
        above(Concern::area_above_nominal, T(1),
              [](const State& state) { return std::optional(state.real_area_fraction.value); });
        above(Concern::above_hardness,
              limits.yield_strength ? hardness_over_yield_strength<T> * *limits.yield_strength
                                    : std::numeric_limits<T>::infinity(),
              [](const State& state) {
                  const T area = state.real_area_fraction.value;
                  return area > T(0) ? std::optional(state.pressure.value / area) : std::nullopt;
              });
    }
    if (has(known, Quantity::stiffness))
        check(
            Concern::not_converged, T(1e-6),
            [](const State& state) {
                const T scale = (std::max)(state.stiffness.value, (std::numeric_limits<T>::min)());
                return std::optional(state.stiffness.error / scale);
            },
            [](const State& state, T) {  // as a product, so that a K that underflows is no concern
                return state.stiffness.error >
                       (std::max)(T(1e-6) * state.stiffness.value, (std::numeric_limits<T>::min)());
            });
    return checks;
}

}  // namespace detail

}}  // namespace fstiff
