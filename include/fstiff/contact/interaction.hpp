// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How the asperities feel one another: the mean pressure lowers the mean plane.
///
///     eta_new = eta_old - Delta(eta_old),   Delta = p L/(E sigma)                   eq. (4.11), L = sqrt(A0)
///
/// Under the pressure p the plane between the peaks sinks by p L/E, so that the peaks meet at an effective separation
/// that is larger than the nominal one: eta_nominal = eta_effective - Delta(eta_effective). With eta_old read as
/// effective and eta_new as nominal the printed formula is this, explicit at a given pressure. Then for -dp/dd, 1/K =
/// 1/K_effective + L/E: the compliance of the bulk under a patch of size L is added, and K <= E/L. Of FractalLaw K
/// stays the factor f times -dp/dd, bulk included, and may exceed E/L by f. Also in use is L = 1/sqrt(D_p), the spacing
/// of the peaks.
///
/// Reference   Ciavarella, Greenwood, Paggi, Wear 265 (2008) 729-734; Buczkowski, Kleiber, Starzynski, Arch. Mech. 66
///             (2014), eq. (4.11); the readings are discussed in docs/errata.md.
/// Units       L [m]
/// Valid       L > 0 for every reading but none

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>

#include <cmath>

namespace fstiff {

/// How (4.11) is read.
enum class InteractionReading {
    none,                  ///< asperities do not feel one another: the stiffness of the interface alone
    effective_separation,  ///< the integrals at eta_effective; separation and stiffness those of the nominal planes
    as_printed  ///< stiffness, area and contacts at eta_new against the pressure at eta_old, as the paper plots them
};
template <>
inline constexpr auto names<InteractionReading> = name_list<InteractionReading>({
    {InteractionReading::none, "none"},
    {InteractionReading::effective_separation, "effective_separation"},
    {InteractionReading::as_printed, "as_printed"},
});

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

/// How peaks feel one another by (4.11), and over which length.
template <Real T = double>
struct Interaction {
    InteractionReading reading = InteractionReading::none;
    T length{};  ///< L [m]: sqrt(A0) in the paper, 1/sqrt(D_p), or the size of the loaded patch

    /// \throws domain_error unless the length suits the reading.
    constexpr void validate() const {
        if (reading != InteractionReading::none) require_positive("interaction length", length);
    }
};

}  // namespace fstiff
