// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Band of K(p) over the errors of a surface; that of `fstiff run` has more causes and is two to five times as wide.
///
///     const auto surface = fstiff::parts::surface_parameters(profile);
///     const auto law = [](double D) { return fstiff::FractalLaw<double>(D); };
///     const auto band = fstiff::stiffness_band(surface, pressures, law, 112.6e9, {.samples = 400, .seed = 1});
///     band[0].low, band[0].median, band[0].high       K [Pa/m] at pressures[0]: 5, 50 and 95 %
///
/// Every sample is one contact; sigma, R, D_p, D, r and theta are drawn together with their errors and correlation
/// (measured/uncertain_surface). 400 samples at 20 pressures are 8000 states and take at most a second or so. A sample
/// that does not reach a pressure is left out there and counted in SampledBand::failed.
/// Reference   measured/sampled_band.hpp, contact/rough_contact.hpp
/// Units       SI
/// Valid       as RoughContact, for every drawn surface; r and theta known, for the first form
/// Accuracy    as measured/sampled_band.hpp (tests/measured/stiffness_band_test.cpp)

#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/measured/sampled_band.hpp>

#include <array>
#include <type_traits>
#include <vector>

namespace fstiff::inline v0_1 {

namespace detail {

/// sigma, R and D_p of a surface as drawn by SurfaceSampler, in the order of Parameter.
template <Real T>
[[nodiscard]] Roughness<T> roughness_of(const std::array<T, parts::surface_parameter_count>& drawn) {
    const auto at = [&](Parameter which) { return drawn[static_cast<std::size_t>(which)]; };
    return {at(Parameter::rms_height), at(Parameter::peak_radius), at(Parameter::peak_density), T(0)};
}

}  // namespace detail

/// Band of the stiffness of any contact: \p contact_of takes a drawn surface, an array in the order of Parameter, and
/// returns an object with at_pressure.
/// \throws domain_error for a pressure that is not finite and greater than 0, as sampled_band, and as \p contact_of.
template <Real T, class Pressures, class ContactOf>
[[nodiscard]] std::vector<parts::SampledBand<T>> stiffness_band(const parts::SurfaceParameters<T>& surface,
                                                                const Pressures& pressures, const ContactOf& contact_of,
                                                                const parts::BandOptions& options = {}) {
    return parts::sampled_band(
        surface,
        [&](const std::array<T, parts::surface_parameter_count>& drawn) {
            std::vector<T> stiffness;
            for (const auto& point : curve_at_pressures(contact_of(drawn), pressures, Quantity::stiffness))
                stiffness.push_back(point.state.stiffness.value);
            return stiffness;
        },
        options);
}

/// Band of the stiffness of RoughContact with the asperity law \p law_of(D), such as
/// [](double D) { return FractalLaw<double>(D); }, and the modulus \p effective_modulus [Pa].
/// \throws domain_error as above, and when r and theta of \p surface are not known.
template <Real T, class Pressures, class LawOf>
[[nodiscard]] std::vector<parts::SampledBand<T>> stiffness_band(const parts::SurfaceParameters<T>& surface,
                                                                const Pressures& pressures, const LawOf& law_of,
                                                                std::type_identity_t<T> effective_modulus,
                                                                const parts::BandOptions& options = {},
                                                                const RoughContactOptions<T>& contact = {}) {
    const auto place = [](Parameter which) { return static_cast<std::size_t>(which); };
    if (!surface.r || !surface.theta)
        throw domain_error("r and theta of the surface are not known: must be known for the density of its peaks");
    return stiffness_band(
        surface, pressures,
        [&](const std::array<T, parts::surface_parameter_count>& drawn) {
            return RoughContact(detail::roughness_of(drawn),
                                PeakDistribution<T>(drawn[place(Parameter::r)], drawn[place(Parameter::theta)]),
                                law_of(drawn[place(Parameter::fractal_dimension)]), effective_modulus, contact);
        },
        options);
}

}  // namespace fstiff::inline v0_1
