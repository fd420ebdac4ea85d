// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// K of the hybrid contact of many surfaces that differ in their numbers alone, from one table, for error bands.
///
///     K sigma/(E g) = F(p/(E g), alpha, H)
///
/// Surfaces of one bearing curve and gamma are similar where alpha and H are equal. F is tabulated where it is asked
/// for, at 8 pressures and 4 alphas an e-fold and every tenth of H; ln F is interpolated by cubics, none of them across
/// alpha = 6. A table grows as it is asked, by any threads: its numbers are the same whoever asks first.
///
/// Reference   contact/hybrid_of_band.hpp
/// Units       SI
/// Valid       alpha from 2.5 to 130,000, 0.7 <= H <= 1, pressures a quarter of an e-fold within the range of
///             hybrid_of_band; none elsewhere
/// Accuracy    K 4e-4, of heights with a kurtosis of 75 1.2e-3 (tests/contact/similar_hybrids_test.cpp)

#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include <atomic>
#include <functional>
#include <map>
#include <mutex>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Four neighbouring nodes and their weights.
template <Real T>
struct CubicStencil {
    int first;
    std::array<T, 4> weight;

    /// About \p place, of nodes from \p lowest to \p highest.
    static CubicStencil at(T place, int lowest, int highest) {
        const int first = std::clamp(static_cast<int>(std::floor(place)) - 1, lowest, highest - 3);
        const T t = place - T(first);
        return {first,
                {-(t - 1) * (t - 2) * (t - 3) / 6, t * (t - 2) * (t - 3) / 2, -t * (t - 1) * (t - 3) / 2,
                 t * (t - 1) * (t - 2) / 6}};
    }
};

/// K of hybrid_of_band() of many surfaces with one bearing curve.
template <Real T = double>
class SimilarHybrids {
public:
    static constexpr T accuracy = T(1.2e-3);  ///< relative, of K

    /// \p curve: of heights over their rms, null of Gaussian ones; it must outlive the table.
    explicit SimilarHybrids(const MaterialRatioSlope<T>* curve, T gamma = T(0.45)) : curve_(curve), gamma_(gamma) {}

    /// K [Pa/m] of the surface with these moments under \p pressure [Pa]; none beyond the table.
    [[nodiscard]] std::optional<T> stiffness(const SpectralMoments<T>& moments, T hurst, T effective_modulus,
                                             T pressure) const {
        const T closing = effective_modulus * std::sqrt(2 * moments.m2);
        const T bend = std::log(moments.bandwidth() / detail::alpha_of_hills<T>) * alphas, tenths = hurst * hursts;
        const T place = std::log(pressure / closing) * pressures + highest_pressure;
        if (!(bend >= T(least_bend) && bend < T(highest_bend) && tenths >= 7 && tenths <= T(hursts) && place >= 0 &&
              place <= T(highest_pressure)))
            return std::nullopt;
        const auto of_alpha = bend < 0 ? Stencil::at(bend, lowest_bend, 0) : Stencil::at(bend, 0, highest_bend);
        const auto of_hurst = Stencil::at(tenths, 1, hursts);
        const auto of_pressure = Stencil::at(place, 0, highest_pressure);
        T log_value = 0;
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t h = 0; h < 4; ++h) {
                const T share = of_alpha.weight[a] * of_hurst.weight[h];
                if (std::abs(share) < 8 * std::numeric_limits<T>::epsilon()) continue;  // H is that of a node
                Node& node = node_at(of_alpha.first + static_cast<int>(a), of_hurst.first + static_cast<int>(h));
                for (std::size_t i = 0; i < 4; ++i)
                    log_value +=
                        share * of_pressure.weight[i] * value_at(node, static_cast<std::size_t>(of_pressure.first) + i);
            }
        if (!std::isfinite(log_value)) return std::nullopt;
        return std::exp(log_value) * closing / std::sqrt(moments.m0);
    }

private:
    using Stencil = CubicStencil<T>;
    static constexpr int alphas = 4, hursts = 10, pressures = 8;  ///< nodes to an e-fold, to 1, to an e-fold
    static constexpr int lowest_bend = -5, highest_bend = 40;     ///< alpha = 1.72 and 130,000
    static constexpr T least_bend = T(-3.5);                      ///< alpha = 2.5: nearer to 3/2 cubics are coarse
    static constexpr int highest_pressure = 400;                  ///< p = E g; the lowest is 2e-22 E g

    struct Node {
        std::function<T(T)> stiffness;          ///< over p/(E g); none where there is no such surface
        std::vector<std::atomic<T>> log_value;  ///< ln F; infinite: was not asked for yet, NaN: F has none
    };

    [[nodiscard]] Node& node_at(int bend, int tenths) const {
        const std::lock_guard lock(guard_);
        const auto [entry, is_new] = nodes_.try_emplace(std::pair(bend, tenths));
        Node& node = entry->second;
        if (!is_new) return node;
        node.log_value = std::vector<std::atomic<T>>(highest_pressure + 1);
        for (auto& value : node.log_value) value = std::numeric_limits<T>::infinity();
        const T alpha = detail::alpha_of_hills<T> * std::exp(T(bend) / alphas);
        try {
            const BandSpectrum<T> unit = band_of_moments<T>({T(1), T(0.5), alpha / 4}, T(tenths) / hursts);
            const auto keep = [&node](auto contact) {
                node.stiffness = [held = std::make_shared<decltype(contact)>(std::move(contact))](T p) {
                    return held->at_pressure(p, Quantity::stiffness).stiffness.value;
                };
            };
            if (curve_)
                keep(hybrid_of_band(unit, *curve_, T(1), gamma_));
            else
                keep(hybrid_of_band(unit, T(1), gamma_));
        } catch (const domain_error&) {
        }
        return node;
    }

    [[nodiscard]] static T value_at(Node& node, std::size_t place) {
        T value = node.log_value[place];
        if (!std::isinf(value)) return value;
        value = std::numeric_limits<T>::quiet_NaN();
        try {
            if (node.stiffness) value = std::log(node.stiffness(std::exp((T(place) - highest_pressure) / pressures)));
        } catch (const domain_error&) {
        }
        return node.log_value[place] = value;
    }

    const MaterialRatioSlope<T>* curve_;
    T gamma_;
    mutable std::mutex guard_;                           ///< of nodes_
    mutable std::map<std::pair<int, int>, Node> nodes_;  ///< by alpha and H
};

}}}  // namespace fstiff::detail
