// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Conductance for heat and current between two faces: contacts, films on them, gap and radiation, in parallel.
///
///     h   = k K/E,   k = 2 k1 k2/(k1 + k2)                            contacts, for heat and current alike
///     h_f = 1/(1/h + r/A_r)                                           contacts under a film of r [m^2 K/W or m^2/S]
///     h_g = k_g/(d + M)                                               gap of mean width d and temperature jump M
///     M   = [(2 - a1)/a1 + (2 - a2)/a2] 2 g/(g + 1)/Pr L              gas of mean free path L
///     h_r = 4 s T^3/(1/e1 + 1/e2 - 1)                                 radiation between grey faces
///
/// Derivation: docs/theory-applications.md, section 14.
/// Reference   Barber, Proc. R. Soc. A 459 (2003) 53; Yovanovich, IEEE Trans. Compon. Packag. Technol. 28 (2005) 182
///             (gap and M); Holm, Electric Contacts (1967), section 5 (film); media: at the table
/// Units       k [W/(m K)] or [S/m], K [Pa/m], E [Pa], h [W/(m^2 K)] or [S/m^2], d, M, L [m], T [K]
/// Valid       bodies much thicker than the distance of the contacts; films much thinner than a contact is wide
/// Accuracy    5 ulp (tests/asperity/conductance_test.cpp); the gap by its mean width, which the narrow parts exceed

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>

#include <array>
#include <limits>
#include <string_view>

namespace fstiff { inline namespace v0_1 {

/// k of the bodies in series, 2 k1 k2/(k1 + k2); 0 where one does not conduct. \throws domain_error unless both are
/// finite and not negative.
template <Real T>
[[nodiscard]] T joint_conductivity(T upper, T lower) {
    constexpr T most = (std::numeric_limits<T>::max)();
    detail::require(upper >= 0 && upper <= most, "upper", upper, "finite and not negative");
    detail::require(lower >= 0 && lower <= most, "lower", lower, "finite and not negative");
    const T less = upper < lower ? upper : lower, more = upper < lower ? lower : upper;
    return more > 0 ? 2 * less / (1 + less / more) : T(0);
}

/// h of the contacts. \throws domain_error unless the modulus is positive, k not negative, K not negative or
/// NaN, of a point without one.
template <Real T>
[[nodiscard]] T spot_conductance(T stiffness, T conductivity, T effective_modulus) {
    detail::require(!(stiffness < 0), "stiffness", stiffness, "0 or greater");
    detail::require(conductivity >= 0, "conductivity", conductivity, "0 or greater");
    detail::require(effective_modulus > 0, "effective_modulus", effective_modulus, "greater than 0");
    return stiffness / effective_modulus * conductivity;
}

namespace detail {

/// h of contacts that cover \p area of the nominal one, under a film of the resistance \p film of an area.
template <Real T>
[[nodiscard]] T under_film(T spots, T area, T film) {
    return film > 0 && spots > 0 ? spots / (1 + spots * film / area) : spots;
}

}  // namespace detail

/// Filling of the gap between two faces.
template <Real T = double>
struct GapFilling {
    T conductivity{};      ///< [W/(m K)]
    T temperature_jump{};  ///< M [m]; 0: a liquid or a grease
};

namespace detail {

/// h of the gap; 0 where the mean planes have passed each other and no gap is left.
template <Real T>
[[nodiscard]] T gap_conductance(const GapFilling<T>& filling, T separation) {
    const T width = separation + filling.temperature_jump;
    return width > 0 ? filling.conductivity / width : T(0);
}

/// A gas at rest between two faces.
template <Real T = double>
struct Gas {
    T conductivity{};    ///< [W/(m K)]
    T mean_free_path{};  ///< [m]
    T heat_capacity_ratio{}, prandtl{};
};
/// Air at 20 degrees Celsius and 1 atm (CRC Handbook of Chemistry and Physics; mean free path: Jennings, J. Aerosol
/// Sci. 19 (1988) 159).
template <Real T = double>
inline constexpr Gas<T> air{T(0.0257), T(66.35e-9), T(1.4), T(0.71)};

/// Medium in a gap, by its name.
struct NamedMedium {
    std::string_view name;
    Gas<double> gas;  ///< a liquid has no mean free path, a vacuum no conductivity
    double accommodation;
};
/// Media at 20 degrees Celsius and 1 atm. Gases: CRC Handbook, conductivities between 200 and 300 K, mean free paths of
/// 25 degrees and 100 kPa times T/p, Prandtl numbers of its viscosities. Accommodation on machined metal: helium 0.36
/// to 0.46 (Trott and others, Rev. Sci. Instrum. 82 (2011) 035120), hydrogen as helium. Water: IAPWS R15-11 (2011);
/// glycerol: CRC Handbook, 25 degrees.
inline constexpr std::array<NamedMedium, 8> named_media{{{"air", air<double>, 0.87},
                                                         {"helium", {0.154, 194e-9, 5.0 / 3, 0.67}, 0.4},
                                                         {"argon", {0.0175, 70.1e-9, 5.0 / 3, 0.67}, 0.87},
                                                         {"nitrogen", {0.0255, 65.6e-9, 1.4, 0.72}, 0.87},
                                                         {"hydrogen", {0.183, 122e-9, 1.41, 0.69}, 0.4},
                                                         {"water", {0.598, 0, 1, 1}, 1},
                                                         {"glycerol", {0.292, 0, 1, 1}, 1},
                                                         {"vacuum", {0, 0, 1, 1}, 1}}};

/// M of \p gas between faces that both have the accommodation coefficient \p accommodation.
template <Real T>
[[nodiscard]] T temperature_jump(const Gas<T>& gas, T accommodation) {
    require(accommodation > 0 && accommodation <= 1, "accommodation", accommodation, "greater than 0, 1 at most");
    const T ratio = gas.heat_capacity_ratio;
    return 2 * (2 - accommodation) / accommodation * 2 * ratio / (ratio + 1) / gas.prandtl * gas.mean_free_path;
}

/// h of radiation at the temperature \p kelvin between grey faces of the emissivity \p emissivity each.
template <Real T>
[[nodiscard]] T radiative_conductance(T kelvin, T emissivity) {
    constexpr double stefan_boltzmann = 5.670374419e-8;  // W/(m^2 K^4), CODATA 2018
    require(emissivity > 0 && emissivity <= 1, "emissivity", emissivity, "greater than 0, 1 at most");
    return T(4 * stefan_boltzmann) * kelvin * kelvin * kelvin / (2 / emissivity - 1);
}

}  // namespace detail
}}  // namespace fstiff
