// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Hybrid contact of a surface that is given by numbers: rms height, rms gradient, Nayak's alpha and Hurst exponent.
///
///     K       = (K_hills^5 + K_persson^5)^(1/5)            contact/hybrid_contact.hpp
///     K_hills : Hertz's law, joint peaks with theta -> 0, r = 1/sqrt(alpha), of the band cut where alpha is 6
///     A/A0    = P [1 + 0.36 (1-P)^(3/2)],  P = erf(sqrt(2) p/(E g)),  and n: of the whole band
///
/// Derivation, bearing curves: docs/theory-contact.md, section 9.
/// Reference   this project: boundary elements (tools/make_broad.py); Nayak, J. Lubr. Technol. 93 (1971) 398
/// Units       SI
/// Valid       isotropic surfaces, alpha > 3/2; pressures up to 0.75 E g
/// Accuracy    K over boundary elements of Gaussian maps, alpha 2.5 to 210, p/(E g) 0.001 to 0.25: within 15 % at 97 of
///             100 points with 40 contacts or more, 67 of 100 with fewer; up to 0.75 within 10 %
///             (tests/contact/hybrid_of_band_test.cpp). Broader bands and bearing curves: docs/validation.md

#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/material_ratio_contact.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/spectrum.hpp>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// alpha at which the band is cut for the peaks that carry light loads.
template <Real T>
inline constexpr T alpha_of_hills = T(6);

/// Hertz over the joint peaks of a band of roughness, each by itself: theta -> 0, r = 1/sqrt(alpha).
/// \throws domain_error as BandSpectrum::validate and RoughContact.
template <Real T>
[[nodiscard]] RoughContact<T, HertzLaw<T>> peaks_of_band(const BandSpectrum<T>& band,
                                                         std::type_identity_t<T> effective_modulus) {
    band.validate();
    const SpectralMoments<T> m = band.moments();
    return {{.rms_height = band.rms_height(),
             .peak_radius = detail::peak_radius_of(m),
             .peak_density = detail::peak_density_of(m)},
            PeakDistribution<T>::isotropic(m.bandwidth()),
            HertzLaw<T>{},
            effective_modulus};
}

/// Hills of a band, the peaks of HybridContact. Real area and number of contacts are those of the whole band.
template <Real T = double>
class BandHills : public SlopeContact<BandHills<T>, T> {
public:
    /// \throws domain_error as peaks_of_band and cut_at_bandwidth.
    BandHills(const BandSpectrum<T>& band, std::type_identity_t<T> effective_modulus,
              std::type_identity_t<T> alpha = alpha_of_hills<T>)
        : hills_(peaks_of_band(detail::cut_at_bandwidth(band, alpha), effective_modulus)),
          summits_(peaks_of_band(band, effective_modulus)),
          closing_(effective_modulus * band.rms_gradient() / std::sqrt(T(2))),
          most_(hills_.at_separation(-900 * hills_.rms_height(), Quantity::pressure).pressure.value) {}

    /// The hills under the nominal pressure \p pressure [Pa]. \throws domain_error as RoughContact.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        ContactState<T> state = hills_.at_pressure((std::min)(pressure, most_), quantities);
        if (pressure > most_) state.pressure.value = pressure;
        return of_whole_band(state, pressure, quantities);
    }
    /// The hills at the separation \p separation [m] of the mean planes. \throws domain_error as RoughContact.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        const ContactState<T> state = hills_.at_separation(separation, quantities | Quantity::pressure);
        return of_whole_band(state, state.pressure.value, quantities);
    }
    /// log(p/Pa) and its slope against eta. \throws domain_error as RoughContact.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const { return hills_.log_pressure(eta); }

    /// A/A0 under \p pressure [Pa]: within 5 % of boundary elements for p/(E g) from 0.001 to 0.75.
    [[nodiscard]] T real_area_fraction(T pressure) const {
        const T x = pressure / closing_, P = std::erf(x), open = std::erfc(x);
        return P * (1 + T(0.36) * open * std::sqrt(open));
    }

    [[nodiscard]] T rms_height() const { return hills_.rms_height(); }
    [[nodiscard]] const RoughContact<T, HertzLaw<T>>& hills() const { return hills_; }
    [[nodiscard]] const RoughContact<T, HertzLaw<T>>& summits() const { return summits_; }

private:
    [[nodiscard]] ContactState<T> of_whole_band(ContactState<T> state, T pressure, Quantity quantities) const {
        const T share = real_area_fraction(pressure);
        if (detail::has(quantities, Quantity::real_area_fraction))
            state.real_area_fraction = {share, 8 * std::numeric_limits<T>::epsilon() * share, 0};
        if (detail::has(quantities, Quantity::contact_density))
            state.contact_density = summits_.at_pressure(pressure, Quantity::contact_density).contact_density;
        return state;
    }

    RoughContact<T, HertzLaw<T>> hills_, summits_;
    T closing_;  ///< E g/sqrt(2) [Pa]
    T most_;  ///< [Pa]; beyond, K of the hills stays: it is 0.002 of Persson's and less there, whose fifth power counts
};

}  // namespace detail

/// Elastic contact of the random surface with the spectrum \p band. \p gamma is that of PerssonContact. \throws
/// domain_error as PerssonContact and BandHills.
template <Real T>
[[nodiscard]] HybridContact<T, detail::BandHills<T>> hybrid_of_band(const BandSpectrum<T>& band,
                                                                    std::type_identity_t<T> effective_modulus,
                                                                    std::type_identity_t<T> gamma = T(0.45)) {
    return {detail::BandHills<T>(band, effective_modulus), PerssonContact<T>(band, effective_modulus, gamma)};
}

namespace detail {

/// Greatest score of a height at which bearing curves were compared; higher ones are replaced by it.
template <Real T>
inline constexpr T highest_score = T(4);

}  // namespace detail

/// The same for a surface whose heights, over their rms, have the bearing curve \p curve. The moments of the band are
/// those of the surface. \throws domain_error as above.
template <Real T>
[[nodiscard]] ScaledContact<T, HybridContact<T, detail::BandHills<T>>> hybrid_of_band(
    const BandSpectrum<T>& band, const MaterialRatioSlope<T>& curve, std::type_identity_t<T> effective_modulus,
    std::type_identity_t<T> gamma = T(0.45)) {
    HybridContact<T, detail::BandHills<T>> gaussian = hybrid_of_band(band, effective_modulus, gamma);
    const T sigma = band.rms_height();
    const MaterialRatioSlope<T> heights =
        curve.between(-detail::highest_score<T>, detail::highest_score<T>).scaled(sigma);
    MaterialRatioContact<T> crowded(gaussian.crowded().gaussian(), heights, sigma);
    return {std::move(gaussian), std::move(crowded)};
}

namespace detail {

/// \p known, of hybrid_of_band with a bearing curve, with another curve.
template <Real T>
[[nodiscard]] ScaledContact<T, HybridContact<T, BandHills<T>>> with_bearing(
    const ScaledContact<T, HybridContact<T, BandHills<T>>>& known, const MaterialRatioSlope<T>& curve) {
    constexpr T end = detail::highest_score<T>;
    return {known.gaussian(),
            known.bearing().with_curve(curve.between(-end, end).scaled(known.bearing().rms_height()))};
}

}  // namespace detail

}}  // namespace fstiff
