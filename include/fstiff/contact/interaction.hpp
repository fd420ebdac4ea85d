// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Interaction of the asperities: the mean pressure lowers the mean plane.
///
///     eta_new = eta_old - Delta(eta_old),   Delta = p L/(E sigma)                   eq. (4.11), L = sqrt(A0)
///
/// With eta_old as the effective separation of the peaks and eta_new as the nominal one, 1/K = 1/K_effective + L/E for
/// K = -dp/dd: the bulk under a patch of size L is in series, and K <= E/L. K of FractalLaw stays f times -dp/dd, bulk
/// included. L = 1/sqrt(D_p), the spacing of the peaks, is also in use.
///
/// Reference   Ciavarella, Greenwood, Paggi, Wear 265 (2008) 729-734; Buczkowski et al. (2014), eq. (4.11);
///             docs/errata.md
/// Units       L [m]
/// Valid       L > 0 for every reading but none

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/peaks/quantity.hpp>

namespace fstiff { inline namespace v0_1 {

/// Reading of (4.11).
enum class InteractionReading {
    none,                  ///< asperities act independently: the stiffness of the interface alone
    effective_separation,  ///< the integrals at eta_effective; separation and stiffness those of the nominal planes
    as_printed  ///< stiffness, area and contacts at eta_new against the pressure at eta_old, as the paper plots them
};
template <>
inline constexpr auto enum_names<InteractionReading> = detail::name_list<InteractionReading>({
    {InteractionReading::none, "none"},
    {InteractionReading::effective_separation, "effective_separation"},
    {InteractionReading::as_printed, "as_printed"},
});

namespace detail {

/// L = sqrt(A0) [m], as the paper has it. \throws domain_error unless the nominal area [m^2] is finite and positive.
template <Real T>
[[nodiscard]] T interaction_length_of_area(T nominal_area) {
    require_positive("nominal_area", nominal_area);
    return std::sqrt(nominal_area);
}

/// L = 1/sqrt(D_p) [m]. \throws domain_error unless the density of peaks [1/m^2] is finite and positive.
template <Real T>
[[nodiscard]] T interaction_length_of_peaks(T peak_density) {
    require_positive("peak_density", peak_density);
    return 1 / std::sqrt(peak_density);
}

}  // namespace detail

/// Interaction of the peaks by (4.11): its reading and its length.
template <Real T = double>
struct Interaction {
    InteractionReading reading = InteractionReading::none;
    T length{};  ///< L [m]: sqrt(A0) in the paper, 1/sqrt(D_p), or the size of the loaded patch

    /// \throws domain_error unless the length suits the reading.
    constexpr void validate() const {
        if (reading != InteractionReading::none) detail::require_positive("interaction length", length);
    }
};

}}  // namespace fstiff
