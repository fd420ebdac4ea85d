// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Hybrid contact of a map: from its summits to its dense contact.
///
///     K = ratio(p) K_peaks                                                            p <= p_h
///     K = K_crowded (ratio K_peaks/K_crowded at p_h)^(1 - ln(p/p_h)/ln 8)             p_h < p < 8 p_h
///     K = K_crowded                                                                   p >= 8 p_h
///
/// ratio is K of summits that push each other down over K of summits each by themselves, tabulated at p_h, p_h/2, ...
/// and linear in ln p; surfaces drawn about the map share it. p_h is where 6 % of the area is in contact by the dense
/// law, or less where more than 1,200 summits touch or the summits cannot be separated.
///
/// Reference   this project: 6 %, 8 and 1,200 by boundary elements of 25 kinds of maps (docs/validation.md)
/// Units       SI
/// Valid       pressures within the reach of the laws
/// Accuracy    docs/validation.md

#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

namespace fstiff { inline namespace v0_1 {

/// Passage from the summits of a map to its dense contact.
template <Real T = double>
class Crossover {
public:
    /// Passage for \p peaks: \p log_ratio is ln ratio at p_h = exp(\p log_pressure), p_h/2, ...; \p log_crowded is
    /// ln K_crowded at p_h.
    template <class Peaks>
    Crossover(T log_pressure, std::vector<T> log_ratio, T log_crowded, const Peaks& peaks)
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

    /// Passage for a surface \p factor times as high, with \p peaks and the same ratios; its dense contact has the
    /// same K at \p factor times the pressure.
    template <class Peaks>
    [[nodiscard]] Crossover scaled(const Peaks& peaks, T factor) const {
        Crossover other = *this;
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

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Passage for a map with \p summits and the dense contact \p crowded. \throws domain_error as SummitContact.
template <Real T>
[[nodiscard]] Crossover<T> hand_over_of(const Summits<T>& summits, const MaterialRatioContact<T>& crowded,
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
    return Crossover<T>(low, std::move(ratios), std::log(crowded.stiffness(std::exp(low))), alone);
}

}}}  // namespace fstiff::detail
