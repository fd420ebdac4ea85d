// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Band of K(p) for a measured surface: over the errors of its parameters, and over the choice of lambda_s.
///
///     const auto surface = fstiff::measure(profile);
///     const auto band = fstiff::stiffness_band(surface, pressures, [](double) { return fstiff::HertzLaw<double>{}; },
///                                              112.6e9);
///     band[0].stiffness, band[0].band.low, band[0].band.high       [Pa/m] at pressures[0]: K, 5 and 95 %
///
/// The band over the errors (measured/stiffness_band) is widened by the neighbours of the surface
/// (measured/band_parts). A profile with a lay does not determine K: its band ends lay_factor times higher.
///
/// Reference   measured/stiffness_band.hpp, measured/band_parts.hpp, measured/measure.hpp
/// Units       K [Pa/m], pressures [Pa]
/// Valid       as stiffness_band() of an uncertain surface; r and theta known, for the form with an asperity law
/// Accuracy    the band of `fstiff run` to the last digit (tests/scene/one_measurement_test.cpp)

#include <fstiff/measured/band_parts.hpp>
#include <fstiff/measured/measure.hpp>
#include <fstiff/measured/stiffness_band.hpp>

#include <algorithm>
#include <limits>
#include <span>

namespace fstiff::inline v0_1 {

namespace parts {

/// K of a measured surface at one pressure, with its band.
template <Real T = double>
struct WidenedBand {
    T stiffness{};  ///< of the surface as measured [Pa/m]; NaN where it has none
    SampledBand<T> band;
    BandParts<T> parts;
};

/// Widens \p band of \p stiffness by the neighbours and by the lay of a profile. \p of_neighbours and \p of_windows (of
/// D) are curves of K over many points, used at \p point and times \p factor; \p of_unknowns are relative to K.
template <Real T>
[[nodiscard]] WidenedBand<T> widened(T stiffness, const SampledBand<T>& band,
                                     const std::vector<std::vector<T>>& of_neighbours,
                                     const std::vector<std::vector<T>>& of_windows, std::size_t point,
                                     bool has_lay = false, T factor = T(1),
                                     const std::vector<UnknownCurves<T>>& of_unknowns = {}) {
    const auto at_point = [&](const std::vector<std::vector<T>>& curves) {
        std::vector<T> all;
        for (const auto& curve : curves) all.push_back(curve[point] * factor);
        return all;
    };
    WidenedBand<T> one{stiffness, band, {}};
    const std::vector<T> neighbours = at_point(of_neighbours), windows = at_point(of_windows);
    if (!neighbours.empty() || !of_unknowns.empty())
        one.parts = widen(one.band, stiffness, std::span<const T>(neighbours));
    if (!of_unknowns.empty()) widen(one.band, one.parts, std::span<const UnknownCurves<T>>(of_unknowns), point);
    spread_of(stiffness, std::span<const T>(windows), one.parts.window_low, one.parts.window_high);
    if (has_lay) widen_by_lay(one.band);
    return one;
}

}  // namespace parts

/// Band of the stiffness of any contact: \p contact_of takes a surface, an array in the order of Parameter, and returns
/// an object with at_pressure. A neighbour without a contact is left out.
/// \throws domain_error as sampled_band().
template <Real T, class Pressures, class ContactOf>
[[nodiscard]] std::vector<parts::WidenedBand<T>> stiffness_band(const Surface<T>& surface, const Pressures& pressures,
                                                                const ContactOf& contact_of,
                                                                const parts::BandOptions& options = {});
/// Same as above for RoughContact with the asperity law \p law_of(D) and the modulus \p effective_modulus [Pa].
/// \throws domain_error as above, and when r and theta of \p surface are not known.
template <Real T, class Pressures, class LawOf>
[[nodiscard]] std::vector<parts::WidenedBand<T>> stiffness_band(const Surface<T>& surface, const Pressures& pressures,
                                                                const LawOf& law_of,
                                                                std::type_identity_t<T> effective_modulus,
                                                                const parts::BandOptions& options = {},
                                                                const RoughContactOptions<T>& contact = {});

namespace parts {

/// K at \p pressures; NaN where the surface has no contact, or the contact no state.
template <Real T, class Pressures, class ContactOf>
[[nodiscard]] std::vector<T> stiffnesses_at(const std::array<T, surface_parameter_count>& values,
                                            const Pressures& pressures, const ContactOf& contact_of) {
    std::vector<T> all;
    try {
        for (const auto& point : curve_at_pressures(contact_of(values), pressures, Quantity::stiffness))
            all.push_back(point.ok() ? point.state.stiffness.value : std::numeric_limits<T>::quiet_NaN());
    } catch (const domain_error&) {
        all.assign(std::size(pressures), std::numeric_limits<T>::quiet_NaN());
    }
    return all;
}

/// Parameters of \p neighbour; r and theta of \p surface where it has none.
template <Real T>
[[nodiscard]] std::array<T, surface_parameter_count> values_of_neighbour(const Surface<T>& neighbour,
                                                                         const Surface<T>& surface) {
    auto values = neighbour.values();
    for (const Parameter which : {Parameter::r, Parameter::theta})
        if (!neighbour.find(which)) values[index_of(which)] = surface.values()[index_of(which)];
    return values;
}

}  // namespace parts

template <Real T, class Pressures, class ContactOf>
std::vector<parts::WidenedBand<T>> stiffness_band(const Surface<T>& surface, const Pressures& pressures,
                                                  const ContactOf& contact_of, const parts::BandOptions& options) {
    const auto at = [&](const std::array<T, parts::surface_parameter_count>& of) {
        return parts::stiffnesses_at(of, pressures, contact_of);
    };
    const auto bands = parts::sampled_band(surface, at, options);
    const std::vector<T> own = at(surface.values());
    std::vector<std::vector<T>> of_neighbours, of_windows;
    for (const Surface<T>& neighbour : surface.neighbours)
        of_neighbours.push_back(at(parts::values_of_neighbour(neighbour, surface)));
    if (surface.fractal_dimension && surface.dimension_window_error > T(0))
        for (const T dimension :
             parts::dimensions_of_other_windows(surface.fractal_dimension->value, surface.dimension_window_error)) {
            auto other = surface.values();
            other[parts::index_of(Parameter::fractal_dimension)] = dimension;
            of_windows.push_back(at(other));
        }
    std::vector<parts::WidenedBand<T>> all;
    for (std::size_t i = 0; i < bands.size(); ++i)
        all.push_back(
            parts::widened(own[i], bands[i], of_neighbours, of_windows, i, parts::is_profile_with_lay(surface)));
    return all;
}

template <Real T, class Pressures, class LawOf>
std::vector<parts::WidenedBand<T>> stiffness_band(const Surface<T>& surface, const Pressures& pressures,
                                                  const LawOf& law_of, std::type_identity_t<T> effective_modulus,
                                                  const parts::BandOptions& options,
                                                  const RoughContactOptions<T>& contact) {
    if (!surface.r || !surface.theta)
        throw domain_error("r and theta of the surface are not known: must be known for the density of its peaks");
    return stiffness_band(
        surface, pressures,
        [&](const std::array<T, parts::surface_parameter_count>& drawn) {
            return RoughContact(
                detail::roughness_of(drawn),
                PeakDistribution<T>(drawn[parts::index_of(Parameter::r)], drawn[parts::index_of(Parameter::theta)]),
                law_of(drawn[parts::index_of(Parameter::fractal_dimension)]), effective_modulus, contact);
        },
        options);
}

}  // namespace fstiff::inline v0_1
