// SPDX-License-Identifier: BSD-3-Clause
#include "scene/quick_hybrids.hpp"

#include <fstiff/double/integrals.hpp>

#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/similar_hybrids.hpp>

#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace fstiff::scene {
namespace {

class HybridsOfDraws final : public QuickHybrid {
public:
    HybridsOfDraws(const parts::BearingSlope<double>* bearing, double gamma) : table_(bearing, gamma) {}
    std::optional<double> stiffness(const ContactInputs& inputs, double pressure) const override {
        return table_.stiffness(inputs.moments, inputs.hurst, inputs.effective_modulus, pressure);
    }

private:
    parts::SimilarHybrids<double> table_;
};

/// K sigma/(E g) is a function of p/(E g), alpha, H and the bearing curve.
class HybridsOfNumbers final : public QuickHybrid {
public:
    explicit HybridsOfNumbers(double gamma) : gamma_(gamma) {}
    std::optional<double> stiffness(const ContactInputs& inputs, double pressure) const override {
        // the same alpha after rounding is one surface
        const double alpha = std::exp(std::round(std::log(inputs.moments.bandwidth()) * 1e9) / 1e9);
        const auto found = surfaces_.try_emplace(std::pair(alpha, inputs.hurst)).first;
        const double closing = inputs.effective_modulus * std::sqrt(2 * inputs.moments.m2);
        try {
            return unit_stiffness(found->second, alpha, inputs.hurst, inputs.bearing, pressure / closing) * closing /
                   std::sqrt(inputs.moments.m0);
        } catch (const domain_error&) {  // beyond reach: the contact itself gives the reason
            return std::nullopt;
        }
    }

private:
    using Gaussian = HybridContact<double, detail::BandHills<double>>;
    using Scaled = parts::ScaledContact<double, Gaussian>;
    /// Contact of one alpha and H, with rms height, gradient and modulus 1.
    struct Surface {
        std::optional<Gaussian> gaussian;
        std::map<const parts::BearingSlope<double>*, Scaled> scaled;
    };
    double unit_stiffness(Surface& of, double alpha, double hurst, const parts::BearingSlope<double>* bearing,
                          double pressure) const {
        const auto band = [&] { return band_of_moments<double>({1, 0.5, alpha / 4}, hurst); };
        if (!bearing) {
            if (!of.gaussian) of.gaussian = hybrid_of_band(band(), 1.0, gamma_);
            return of.gaussian->at_pressure(pressure, Quantity::stiffness).stiffness.value;
        }
        auto found = of.scaled.find(bearing);
        if (found == of.scaled.end())
            found = of.scaled
                        .emplace(bearing, of.scaled.empty() ? hybrid_of_band(band(), *bearing, 1.0, gamma_)
                                                            : parts::with_bearing(of.scaled.begin()->second, *bearing))
                        .first;
        return found->second.at_pressure(pressure, Quantity::stiffness).stiffness.value;
    }

    double gamma_;
    mutable std::map<std::pair<double, double>, Surface> surfaces_;
};

}  // namespace

std::shared_ptr<const QuickHybrid> hybrids_of_draws(const parts::BearingSlope<double>* bearing, double gamma) {
    return std::make_shared<const HybridsOfDraws>(bearing, gamma);
}
std::shared_ptr<const QuickHybrid> hybrids_of_numbers(double gamma) {
    return std::make_shared<const HybridsOfNumbers>(gamma);
}

}  // namespace fstiff::scene
