// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Law for all loads: peaks where few of them carry, Persson's theory where they are crowded.
///
///     K = (K_peaks^5 + K_crowded^5)^(1/5)         at equal pressure; for a map contact/hybrid_contact.hpp
///     d = int_p^(2 E g) dp'/K(p')                 separation of the mean planes; at 2 E g all is in contact
///     real area and number of contacts            of the peaks, at the same pressure
///
/// K_crowded is Persson's, at the local scale of a bearing curve (contact/bearing_contact.hpp). The peaks are taken
/// without interaction. d is integrated in ln p over panels, each once; a pressure then costs the rest of one.
///
/// Reference   Persson, Phys. Rev. Lett. 99 (2007) 125502; Buczkowski et al. (2014), eq. (4.9); docs/validation.md
/// Units       SI
/// Valid       pressures within the reach of both; separations above 0; both of the same surface
/// Accuracy    K that of its parts, separation 1e-11 of the rms height, 1e-5 where K has kinks
///             (tests/contact/hybrid_contact_test.cpp). Against boundary elements: docs/validation.md

#include <fstiff/contact/bearing_contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/map_spectrum.hpp>

namespace fstiff::inline v0_1 {

namespace detail {

/// (a^5 + b^5)^(1/5), without overflow: of laws that are each below the truth where they fail.
template <Real T = double>
struct FifthPowers {
    template <class Peaks, class Crowded>
    [[nodiscard]] T operator()(T /*pressure*/, const Peaks& peaks, const Crowded& crowded) const {
        const T a = peaks(), b = crowded();
        const T most = (std::max)(a, b), ratio = (std::min)(a, b) / most, square = ratio * ratio;
        return most * std::exp(std::log1p(square * square * ratio) / 5);
    }
};

}  // namespace detail

/// \p Peaks is a contact of independent peaks: RoughContact with any law, BandHills or SummitContact; \p Join makes one
/// K under a pressure of two functions, and calls those that it needs.
template <Real T, Contact<T> Peaks, class Join = detail::FifthPowers<T>>
class HybridContact : public detail::SlopeContact<HybridContact<T, Peaks, Join>, T> {
public:
    /// \throws domain_error when \p peaks has an interaction, or does not reach 2 E g.
    HybridContact(Peaks peaks, BearingContact<T> crowded, Join join = {})
        : peaks_(std::move(peaks)), crowded_(std::move(crowded)), join_(std::move(join)) {
        if (peaks_.interaction().reading != InteractionReading::none)
            throw domain_error("interaction of the peaks in a hybrid contact: must be none, Persson's theory has it");
    }
    /// Contact of a Gaussian surface, without a bearing curve.
    template <std::default_initializable J = Join>
    HybridContact(Peaks peaks, PerssonContact<T> crowded)
        : HybridContact(std::move(peaks), BearingContact<T>(std::move(crowded)), J{}) {}

    /// K [Pa/m] under \p pressure [Pa]. \throws domain_error as stiffness() of either law.
    [[nodiscard]] T stiffness(T pressure) const {
        return join_(
            pressure, [&] { return peaks_.at_pressure(pressure, Quantity::stiffness).stiffness.value; },
            [&] { return crowded_.stiffness(pressure); });
    }

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive and within the reach of both laws: at most 0.75 E g.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        crowded_.require_compared(pressure);
        const bool stiff = detail::has(quantities, Quantity::stiffness | Quantity::loading_stiffness);
        const Quantity of_peaks = stiff ? quantities | Quantity::stiffness : quantities;
        ContactState<T> state = peaks_.at_pressure(pressure, of_peaks);
        if (stiff) {
            const T share = state.stiffness.error / state.stiffness.value;
            const int evaluations = state.stiffness.evaluations;
            const T K = join_(
                pressure, [&] { return state.stiffness.value; }, [&] { return crowded_.stiffness(pressure); });
            state.stiffness =
                state.loading_stiffness = {K, (share + 80 * std::numeric_limits<T>::epsilon()) * K, evaluations};
        }
        if (!detail::has(quantities, Quantity::stiffness)) state.stiffness = {};
        if (!detail::has(quantities, Quantity::loading_stiffness)) state.loading_stiffness = {};
        state.separation = detail::has(quantities, Quantity::separation) ? separation(pressure) : Estimate<T>{};
        state.eta = state.separation.value / rms_height();
        return state;
    }

    /// Separation [m] of the mean planes under \p pressure [Pa]; 0 from 2 E g on. \throws domain_error as stiffness.
    [[nodiscard]] Estimate<T> separation(T pressure) const {
        detail::require_positive("pressure", pressure);
        const T above = log_end() - std::log(pressure);
        if (above <= 0) return {T(0), rms_height() * std::numeric_limits<T>::epsilon(), 0};
        const T width = width_of_panel();
        const auto panels = static_cast<std::size_t>(above / width);
        T d = 0;
        for (std::size_t i = 0; i < panels; ++i) d += panel(i);
        d += panel(std::log(pressure), log_end() - T(panels) * width - std::log(pressure));
        return {d, (error_share() + 64 * std::numeric_limits<T>::epsilon()) * (d + rms_height()), 16};
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless 0 < eta and its pressure is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        detail::require(eta > 0 && std::isfinite(eta), "eta", eta,
                        "finite and greater than 0 (separation over rms height)");
        const T width = width_of_panel();
        std::size_t panels = 0;
        T d = 0;
        while (T(panels) * width < e_folds && (d += panel(panels)) <= eta * rms_height()) ++panels;
        const T high = log_end() - T(panels) * width, low = high - (T(panels) * width < e_folds ? width : T(500));
        return this->searched_log_pressure(eta, low, high, high - width / 2, "within the reach of the laws");
    }

    /// Pressure from which on all is in contact [Pa]: 2 E g at the local scale of a bearing curve.
    [[nodiscard]] T full_pressure() const { return crowded_.full_pressure(); }
    [[nodiscard]] T rms_height() const { return crowded_.rms_height(); }
    [[nodiscard]] bool has_kinks() const { return detail::has_kinks(peaks_) || crowded_.has_kinks(); }
    [[nodiscard]] const Peaks& peaks() const { return peaks_; }
    [[nodiscard]] const BearingContact<T>& crowded() const { return crowded_; }

private:
    static constexpr int e_folds = 24;  ///< of pressure below 2 E g: 4e-11 of it

    /// Panels of ln p: short ones with few points where K has kinks.
    [[nodiscard]] T width_of_panel() const { return has_kinks() ? T(1) / 32 : T(1); }

    [[nodiscard]] T log_end() const { return std::log(full_pressure()); }

    /// Error of the separation over the rms height.
    [[nodiscard]] T error_share() const { return has_kinks() ? T(1e-5) : T(1e-11); }

    /// The same over panel \p i below 2 E g.
    [[nodiscard]] T panel(std::size_t i) const {
        const T width = width_of_panel();
        return panels_.at(i, [&] { return panel(log_end() - T(i + 1) * width, width); });
    }
    /// int p/K d ln p
    [[nodiscard]] T panel(T from, T length) const {
        return has_kinks() ? this->template fall_of_separation<4>(from, length)
                           : this->template fall_of_separation<16>(from, length);
    }

    Peaks peaks_;
    BearingContact<T> crowded_;
    Join join_;
    detail::Panels<T> panels_{static_cast<std::size_t>(T(e_folds) / width_of_panel())};
};

}  // namespace fstiff::inline v0_1

// Hybrid contact of a map: from its summits to its crowded contact.
//
//     K = ratio(p) K_peaks                                                            p <= p_h
//     K = K_crowded (ratio K_peaks/K_crowded at p_h)^(1 - ln(p/p_h)/ln 8)             p_h < p < 8 p_h
//     K = K_crowded                                                                   p >= 8 p_h
//
// ratio is K of summits that push each other down over K of summits each by themselves, tabulated at p_h, p_h/2, ...
// and linear in ln p; surfaces drawn about the map share it. p_h is where 6 % of the area is in contact by the crowded
// law, or less where more than 1,200 summits carry or the summits cannot be separated.
//
// Reference   this project: 6 %, 8 and 1,200 by boundary elements of 25 kinds of maps (docs/validation.md)
// Units       SI
// Valid       pressures within the reach of the laws
// Accuracy    docs/validation.md

namespace fstiff::inline v0_1 {

/// Passage from the summits of a map to its crowded contact.
template <Real T = double>
class HandOver {
public:
    /// Passage for \p peaks: \p log_ratio is ln ratio at p_h = exp(\p log_pressure), p_h/2, ...; \p log_crowded is
    /// ln K_crowded at p_h.
    template <class Peaks>
    HandOver(T log_pressure, std::vector<T> log_ratio, T log_crowded, const Peaks& peaks)
        : log_pressure_(log_pressure), log_crowded_(log_crowded), log_ratio_(std::move(log_ratio)) {
        detail::require(!log_ratio_.empty(), "ratios of a hand-over", log_ratio_.size(), "at least 1");
        find_jump(peaks);
    }

    /// K [Pa/m] under \p pressure [Pa], of the one of the two functions that counts there.
    template <class Peaks, class Crowded>
    [[nodiscard]] T operator()(T pressure, const Peaks& peaks, const Crowded& crowded) const {
        const T beyond = std::log(pressure) - log_pressure_;
        if (beyond > 0) return crowded() * std::exp(log_jump_ * (std::max)(T(0), 1 - beyond / std::log(T(8))));
        return peaks() * std::exp(log_ratio(-beyond / std::numbers::ln2_v<T>));
    }

    /// Hand-over for a surface \p factor times as high, with \p peaks and the same ratios; its crowded contact has the
    /// same K at \p factor times the pressure.
    template <class Peaks>
    [[nodiscard]] HandOver scaled(const Peaks& peaks, T factor) const {
        HandOver other = *this;
        other.log_pressure_ += std::log(factor);
        other.find_jump(peaks);
        return other;
    }

    /// p_h [Pa].
    [[nodiscard]] T pressure() const { return std::exp(log_pressure_); }

private:
    template <class Peaks>
    void find_jump(const Peaks& peaks) {
        const T K = peaks.at_pressure(pressure(), Quantity::stiffness).stiffness.value;
        log_jump_ = log_ratio_.front() + std::log(K) - log_crowded_;
    }

    /// ln ratio at p_h 2^-\p steps; constant below the last pressure.
    [[nodiscard]] T log_ratio(T steps) const {
        const T last = static_cast<T>(log_ratio_.size() - 1), place = (std::min)(steps, last);
        const auto i = static_cast<std::size_t>(place);
        if (i + 1 >= log_ratio_.size()) return log_ratio_.back();
        return log_ratio_[i] + (place - static_cast<T>(i)) * (log_ratio_[i + 1] - log_ratio_[i]);
    }

    T log_pressure_, log_crowded_;
    T log_jump_{};  ///< ln of ratio K_peaks/K_crowded at p_h
    std::vector<T> log_ratio_;
};

}  // namespace fstiff::inline v0_1

namespace fstiff::inline v0_1::detail {

/// Hand-over for a map with \p summits and the crowded contact \p crowded. \throws domain_error as SummitContact.
template <Real T>
[[nodiscard]] HandOver<T> hand_over_of(const Summits<T>& summits, const BearingContact<T>& crowded,
                                       Edges edges = Edges::mirrored) {
    constexpr T most_area = T(0.06), most_contacts = T(1200);
    const T modulus = crowded.effective_modulus();
    const SummitContact<T> alone(summits, modulus);
    const MutualSummits<T> mutual(summits, modulus, edges);
    const auto is_beyond = [&](T log_pressure) {
        const T p = std::exp(log_pressure);
        return crowded.at_pressure(p, Quantity::real_area_fraction).real_area_fraction.value > most_area ||
               alone.at_pressure(p, Quantity::contact_density).contact_density.value * alone.area() > most_contacts;
    };
    T high = std::log(crowded.full_pressure()) - 2, low = high - 30;
    while (high - low > T(0.01)) (is_beyond((low + high) / 2) ? high : low) = (low + high) / 2;

    const auto ratio_at = [&](T log_pressure) {
        const T p = std::exp(log_pressure);
        return std::log(mutual.at_pressure(p, Quantity::stiffness).stiffness.value /
                        alone.at_pressure(p, Quantity::stiffness).stiffness.value);
    };
    std::vector<T> ratios;
    for (int tries = 0; ratios.empty(); ++tries) {  // down to where the summits can be separated
        try {
            ratios.push_back(tries < 20 ? ratio_at(low) : T(0));
        } catch (const domain_error&) {
            low -= T(0.3);
        }
    }
    for (int k = 1; k <= 12; ++k) {
        const T log_pressure = low - T(k) * std::numbers::ln2_v<T>;
        const auto state = alone.at_pressure(std::exp(log_pressure), Quantity::contact_density);
        if (state.contact_density.value * alone.area() < 2) break;
        try {
            ratios.push_back(ratio_at(log_pressure));
        } catch (const domain_error&) {
            ratios.push_back(ratios.back());
        }
    }
    return HandOver<T>(low, std::move(ratios), std::log(crowded.stiffness(std::exp(low))), alone);
}

}  // namespace fstiff::inline v0_1::detail

// The law `hybrid` for a map, from its heights: elliptic summits at light loads, Persson's theory at the local slope
// of the bearing curve at heavy ones, and the hand-over between them. It is a fstiff::Contact, so that it has a table.
//
// Reference   contact/hybrid_contact.hpp, contact/bearing_contact.hpp
// Units       SI
// Valid       heights after form and cut-offs (measure/prepare.hpp), without missing points; p/(E g) up to 0.75
// Accuracy    within 15 % of boundary elements at 97 of 100 points of 25 kinds of maps (docs/validation.md); the same
//             number as `fstiff run` (tests/scene/one_measurement_test.cpp)

namespace fstiff::inline v0_1 {

/// Returns the contact of \p map under the effective modulus \p effective_modulus [Pa]; \p edges continues the map
/// beyond its edges. \throws domain_error for missing points, a map without summits, or a modulus that is not positive.
template <Real T>
[[nodiscard]] HybridContact<T, SummitContact<T>, HandOver<T>> hybrid_of_map(const HeightMap<T>& map,
                                                                            std::type_identity_t<T> effective_modulus,
                                                                            Edges edges = Edges::mirrored) {
    const detail::GaussianOrder<T> order = detail::gaussian_order(map);
    const Summits<T> summits = summits_of(map);
    const BearingContact<T> crowded(PerssonContact<T>(map_spectrum(order.map, edges), effective_modulus), order.curve,
                                    order.rms_height);
    return {SummitContact<T>(summits, effective_modulus), crowded, detail::hand_over_of(summits, crowded, edges)};
}

}  // namespace fstiff::inline v0_1
