// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Law for all loads: peaks where few of them touch, Persson's theory where contacts are dense.
///
///     K = (K_peaks^5 + K_crowded^5)^(1/5)         at equal pressure; for a map contact/hybrid_contact.hpp
///     d = int_p^(2 E g) dp'/K(p')                 separation of the mean planes; at 2 E g all is in contact
///     real area and number of contacts            of the peaks, at the same pressure
///
/// K_crowded is Persson's, at the local scale of a bearing curve (contact/material_ratio_contact.hpp). The peaks are
/// taken without interaction. d is integrated in ln p over panels, each once; a pressure then costs the rest of one.
///
/// Reference   Persson, Phys. Rev. Lett. 99 (2007) 125502; Buczkowski et al. (2014), eq. (4.9); docs/validation.md
/// Units       SI
/// Valid       pressures within the reach of both; separations above 0; both of the same surface
/// Accuracy    K that of its parts, separation 1e-10 of the rms height, 1e-5 where K has kinks
///             (tests/contact/hybrid_contact_test.cpp). Against boundary elements: docs/validation.md

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/material_ratio_contact.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/map_spectrum.hpp>

namespace fstiff { inline namespace v0_1 {

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

/// Contact by its independent peaks at light loads, and by its whole spectrum at heavy ones. \p Peaks is RoughContact
/// with any law, BandHills or SummitContact; \p Join makes one K under a pressure of two functions, and calls those
/// that it needs.
template <Real T, Contact<T> Peaks, class Join = detail::FifthPowers<T>>
class HybridContact : public detail::SlopeContact<HybridContact<T, Peaks, Join>, T> {
public:
    /// \throws domain_error when \p peaks has an interaction, or does not reach 2 E g.
    HybridContact(Peaks peaks, MaterialRatioContact<T> crowded, Join join = {})
        : peaks_(std::move(peaks)), crowded_(std::move(crowded)), join_(std::move(join)) {
        if (peaks_.interaction().reading != InteractionReading::none)
            throw domain_error("interaction of the peaks in a hybrid contact: must be none, Persson's theory has it");
    }
    /// Contact of a Gaussian surface, without a bearing curve.
    template <std::default_initializable J = Join>
    HybridContact(Peaks peaks, PerssonContact<T> crowded)
        : HybridContact(std::move(peaks), MaterialRatioContact<T>(std::move(crowded)), J{}) {}

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
        const detail::PanelEdges<T> edge = edges();
        const std::size_t panels = edge.before(above);
        T d = 0;
        for (std::size_t i = 0; i < panels; ++i) d += panel(i);
        d += panel(std::log(pressure), log_end() - edge(panels) - std::log(pressure));
        return {d, (error_share() + 64 * std::numeric_limits<T>::epsilon()) * (d + rms_height()), 16};
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless 0 < eta and its pressure is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        detail::require(eta > 0 && std::isfinite(eta), "eta", eta,
                        "finite and greater than 0 (separation over rms height)");
        const detail::PanelEdges<T> edge = edges();
        std::size_t panels = 0;
        T d = 0;
        while (edge(panels) < e_folds && (d += panel(panels)) <= eta * rms_height()) ++panels;
        const T begin = edge(panels), width = edge(panels + 1) - begin, high = log_end() - begin;
        const T low = high - (begin < e_folds ? width : T(500));
        return this->searched_log_pressure(eta, low, high, high - (std::min)(width, T(1)) / 2,
                                           "within the reach of the laws");
    }

    /// Pressure from which on all is in contact [Pa]: 2 E g at the local scale of a bearing curve.
    [[nodiscard]] T full_pressure() const { return crowded_.full_pressure(); }
    [[nodiscard]] T rms_height() const { return crowded_.rms_height(); }
    [[nodiscard]] bool has_kinks() const { return detail::has_kinks(peaks_) || crowded_.has_kinks(); }
    [[nodiscard]] const Peaks& peaks() const { return peaks_; }
    [[nodiscard]] const MaterialRatioContact<T>& crowded() const { return crowded_; }

private:
    static constexpr int e_folds = 24;  ///< of pressure below 2 E g: 4e-11 of it

    /// Of panels of ln p below 2 E g: short ones with few points where K has kinks.
    [[nodiscard]] detail::PanelEdges<T> edges() const {
        return has_kinks() ? detail::PanelEdges<T>(T(1) / 32) : detail::PanelEdges<T>();
    }

    [[nodiscard]] T log_end() const { return std::log(full_pressure()); }

    /// Error of the separation over the rms height.
    [[nodiscard]] T error_share() const { return has_kinks() ? T(1e-5) : T(1e-10); }

    /// The same over panel \p i below 2 E g.
    [[nodiscard]] T panel(std::size_t i) const {
        const detail::PanelEdges<T> edge = edges();
        return panels_.at(i, [&] { return panel(log_end() - edge(i + 1), edge(i + 1) - edge(i)); });
    }
    /// int p/K d ln p
    [[nodiscard]] T panel(T from, T length) const {
        return has_kinks() ? this->template fall_of_separation<4>(from, length)
                           : this->template fall_of_separation<16>(from, length);
    }

    Peaks peaks_;
    MaterialRatioContact<T> crowded_;
    Join join_;
    detail::Panels<T> panels_{edges().before(T(e_folds))};
};

}}  // namespace fstiff
