// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/quick_hybrids.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/answer/quick_hybrids.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/similar_hybrids.hpp>
#include <fstiff/core/shared_values.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// d of one surface over ln p, an e-fold after the other from 0.7 E g downwards: the integral of p/K by the parabola
/// through three of its values, and cubics between half e-folds.
class FallOfSeparation {
public:
    explicit FallOfSeparation(const ContactInputs& inputs) {
        const BandSpectrum<double> band = band_of_moments(inputs.moments, inputs.hurst);
        const auto keep = [&](auto contact) {
            const auto held = std::make_shared<decltype(contact)>(std::move(contact));
            log_top_ = std::log(0.7 * inputs.effective_modulus * std::sqrt(2 * inputs.moments.m2));
            knots_.push_back({held->separation(std::exp(log_top_)).value, 0});
            rise_ = [held](double log_p) { return std::exp(log_p) / held->stiffness(std::exp(log_p)); };
        };
        inputs.bearing ? keep(hybrid_of_band(band, *inputs.bearing, inputs.effective_modulus, inputs.options.gamma))
                       : keep(hybrid_of_band(band, inputs.effective_modulus, inputs.options.gamma));
        knots_.front().rise = rise_(log_top_);
    }
    /// The pressure at \p separation; none above 0.7 E g, and more than 24 e-folds below it.
    std::optional<double> pressure(double separation) {
        if (!(separation > knots_.front().d)) return std::nullopt;
        while (knots_.back().d < separation) {
            if (knots_.size() > 48) return std::nullopt;
            const Knot& last = knots_.back();
            const double from = log_top_ - static_cast<double>(knots_.size() / 2 + 1), rise = rise_(from);
            const double middle = rise_(from + 0.5);
            const Knot half{last.d + (5 * last.rise + 8 * middle - rise) / 24, middle},
                end{last.d + (last.rise + 4 * middle + rise) / 6, rise};
            knots_.insert(knots_.end(), {half, end});
        }
        std::size_t i = 0;
        while (knots_[i + 1].d < separation) ++i;
        const Knot &a = knots_[i], &b = knots_[i + 1];
        double low = 0, high = 1;
        while (high - low > 1e-9) {
            const double t = (low + high) / 2, rise = b.d - a.d, left = a.rise / 2, right = b.rise / 2;
            const double d = a.d + t * (left + t * (3 * rise - 2 * left - right + t * (left + right - 2 * rise)));
            (d < separation ? low : high) = t;
        }
        return std::exp(log_top_ - (static_cast<double>(i) + low) / 2);
    }

private:
    struct Knot {
        double d, rise;  ///< rise: over an e-fold down
    };
    double log_top_ = 0;
    std::function<double(double)> rise_;
    std::vector<Knot> knots_;
};

class HybridsOfDraws final : public QuickHybrid {
public:
    HybridsOfDraws(const MaterialRatioSlope<double>* bearing, double gamma) : table_(bearing, gamma) {}
    std::optional<double> stiffness(const ContactInputs& inputs, double pressure) const override {
        return table_.stiffness(inputs.moments, inputs.hurst, inputs.effective_modulus, pressure);
    }
    PressureOver pressure(const ContactInputs& inputs) const override {
        return [&inputs, fall = std::optional<FallOfSeparation>()](double separation) mutable -> std::optional<double> {
            try {
                if (!fall) fall.emplace(inputs);
                return fall->pressure(separation);
            } catch (const domain_error&) {  // the contact itself gives the reason
                fall.reset();
                return std::nullopt;
            }
        };
    }

private:
    SimilarHybrids<double> table_;
};

using UnitHybrid = HybridContact<double, BandHills<double>>;
using ScaledUnitHybrid = ScaledContact<double, UnitHybrid>;

/// Hybrid of a surface with rms height, gradient and modulus 1. Many joints share it, since alpha and H are those that
/// are assumed of a process. \throws domain_error as hybrid_of_band().
FSTIFF_INLINE std::shared_ptr<const UnitHybrid> unit_hybrid(double gamma, double alpha, double hurst) {
    static SharedValues<std::array<double, 3>, UnitHybrid> contacts;
    return contacts.at({gamma, alpha, hurst}, [&] {
        return std::make_shared<const UnitHybrid>(
            hybrid_of_band(band_of_moments<double>({1, 0.5, alpha / 4}, hurst), 1.0, gamma));
    });
}
/// The same of a bearing curve that ends as high as \p bearing, for with_bearing().
FSTIFF_INLINE std::shared_ptr<const ScaledUnitHybrid> unit_hybrid(double gamma, double alpha, double hurst,
                                                                  const MaterialRatioSlope<double>& bearing) {
    static SharedValues<std::array<double, 4>, ScaledUnitHybrid> contacts;
    return contacts.at({gamma, alpha, hurst, (std::min)(bearing.highest(), highest_score<double>)}, [&] {
        return std::make_shared<const ScaledUnitHybrid>(
            hybrid_of_band(band_of_moments<double>({1, 0.5, alpha / 4}, hurst), bearing, 1.0, gamma));
    });
}

/// K sigma/(E g) is a function of p/(E g), alpha, H and the bearing curve.
class HybridsOfNumbers final : public QuickHybrid {
public:
    explicit HybridsOfNumbers(double gamma) : gamma_(gamma) {}
    std::optional<double> stiffness(const ContactInputs& inputs, double pressure) const override {
        const double closing = closing_of(inputs);
        return of_unit(inputs, [&](const auto& unit) {
            return unit.at_pressure(pressure / closing, Quantity::stiffness).stiffness.value * closing /
                   std::sqrt(inputs.moments.m0);
        });
    }
    PressureOver pressure(const ContactInputs& inputs) const override {
        return [this, &inputs](double separation) {
            return of_unit(inputs, [&](const auto& unit) {
                return std::exp(unit.log_pressure(separation / std::sqrt(inputs.moments.m0)).log) * closing_of(inputs);
            });
        };
    }

private:
    /// Contact of one alpha and H, with rms height, gradient and modulus 1.
    struct Surface {
        std::shared_ptr<const UnitHybrid> gaussian;
        std::shared_ptr<const ScaledUnitHybrid> any_scaled;  ///< that all bearing curves are made of
        std::map<const MaterialRatioSlope<double>*, ScaledUnitHybrid> scaled;
    };
    static double closing_of(const ContactInputs& inputs) {
        return inputs.effective_modulus * std::sqrt(2 * inputs.moments.m2);
    }
    /// What \p call returns of the contact of the alpha, H and bearing curve of \p inputs; none where there is no such
    /// contact or state: the contact itself gives the reason.
    template <class Call>
    std::optional<double> of_unit(const ContactInputs& inputs, const Call& call) const {
        // the same alpha after rounding is one surface
        const double alpha = std::exp(std::round(std::log(inputs.moments.bandwidth()) * 1e9) / 1e9);
        Surface& surface = surfaces_[std::pair(alpha, inputs.hurst)];
        const MaterialRatioSlope<double>* const bearing = inputs.bearing;
        try {
            if (!bearing) {
                if (!surface.gaussian) surface.gaussian = unit_hybrid(gamma_, alpha, inputs.hurst);
                return call(*surface.gaussian);
            }
            if (!surface.any_scaled) surface.any_scaled = unit_hybrid(gamma_, alpha, inputs.hurst, *bearing);
            auto entry = surface.scaled.find(bearing);
            if (entry == surface.scaled.end())
                entry = surface.scaled.emplace(bearing, detail::with_bearing(*surface.any_scaled, *bearing)).first;
            return call(entry->second);
        } catch (const domain_error&) {
            return std::nullopt;
        }
    }

    double gamma_;
    mutable std::map<std::pair<double, double>, Surface> surfaces_;
};

FSTIFF_INLINE std::shared_ptr<const QuickHybrid> hybrids_of_draws(const MaterialRatioSlope<double>* bearing,
                                                                  double gamma) {
    if (bearing) return std::make_shared<const HybridsOfDraws>(bearing, gamma);
    static SharedValues<double, HybridsOfDraws> of_gaussian_heights;
    return of_gaussian_heights.at(gamma, [&] { return std::make_shared<const HybridsOfDraws>(nullptr, gamma); });
}
FSTIFF_INLINE std::shared_ptr<const QuickHybrid> hybrids_of_numbers(double gamma) {
    return std::make_shared<const HybridsOfNumbers>(gamma);
}

}}}  // namespace fstiff::detail
