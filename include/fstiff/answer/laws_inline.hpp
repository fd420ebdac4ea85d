// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/laws.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/erased_contact.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/shared_values.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace fstiff { inline namespace v0_1 {

FSTIFF_INLINE ContactLaw<double> AnyContact::tabulate(const LawRange<double>&) const {
    throw domain_error(
        "this law cannot be tabulated: it gives no separation, or each of its points is a solution by boundary "
        "elements; choose another");
}

namespace detail {

/// The contacts of each law.
namespace law_rows {

FSTIFF_INLINE RoughContactOptions<double> options_of(const ContactInputs& inputs) {
    RoughContactOptions<double> options;
    options.interaction = inputs.interaction;
    return options;
}

// one contact is compiled for all three elastic laws
using LawOfDimension = ElasticLaw<double> (*)(double dimension);
FSTIFF_INLINE ElasticLaw<double> fractal_law(double dimension) { return FractalLaw<double>(dimension); }
FSTIFF_INLINE ElasticLaw<double> fractal_consistent_law(double dimension) {
    return FractalConsistentLaw<double>(dimension);
}
FSTIFF_INLINE ElasticLaw<double> hertz_law(double) { return HertzLaw<double>{}; }

/// A contact of joint peaks with the asperity law that \p of_dimension makes of the fractal dimension.
template <LawOfDimension of_dimension>
std::unique_ptr<AnyContact> joint(const ContactInputs& inputs) {
    return erase(RoughContact(inputs.surface, *inputs.peaks, of_dimension(inputs.fractal_dimension),
                              inputs.effective_modulus, options_of(inputs)));
}

FSTIFF_INLINE std::unique_ptr<AnyContact> greenwood_williamson_contact(const ContactInputs& inputs) {
    if (inputs.peak_heights)
        return erase(GreenwoodWilliamson<double>(inputs.surface, inputs.effective_modulus, *inputs.peak_heights,
                                                 options_of(inputs)));
    return erase(
        GreenwoodWilliamson<double>(inputs.surface, inputs.effective_modulus, Heights::gaussian, options_of(inputs)));
}

/// Persson's contact of the spectrum.
FSTIFF_INLINE PerssonContact<double> of_spectrum(const ContactInputs& inputs) {
    return inputs.map && inputs.spectrum_of_map
               ? PerssonContact<double>(inputs.map->spectrum(inputs.options.edges), inputs.effective_modulus,
                                        inputs.options.gamma)
               : PerssonContact<double>(band_of_moments(inputs.moments, inputs.hurst), inputs.effective_modulus,
                                        inputs.options.gamma);
}

FSTIFF_INLINE std::unique_ptr<AnyContact> persson_contact(const ContactInputs& inputs) {
    return erase(of_spectrum(inputs));
}

/// Calls \p make with hybrid from numbers, with Gaussian heights or a bearing curve.
template <class Make>
std::unique_ptr<AnyContact> with_hybrid_of_band(const ContactInputs& inputs, const Make& make) {
    const BandSpectrum<double> band = band_of_moments(inputs.moments, inputs.hurst);
    if (!inputs.bearing) return erase(make(hybrid_of_band(band, inputs.effective_modulus, inputs.options.gamma)));
    return erase(make(hybrid_of_band(band, *inputs.bearing, inputs.effective_modulus, inputs.options.gamma)));
}

FSTIFF_INLINE std::unique_ptr<AnyContact> hybrid_of_numbers(const ContactInputs& inputs) {
    return with_hybrid_of_band(inputs, [](auto&& contact) { return std::move(contact); });
}

/// Hybrid as the law of hybrid of a QuickContact.
struct Itself {
    static std::optional<double> stiffness(const ContactInputs&, double K, double) { return K; }
    static QuickHybrid::PressureOver pressure(const ContactInputs& inputs) { return inputs.similar->pressure(inputs); }
};

FSTIFF_INLINE std::unique_ptr<AnyContact> hybrid_contact(const ContactInputs& inputs) {
    if (inputs.map && inputs.spectrum_of_map) return inputs.map->contact(LawKind::hybrid, inputs);
    if (!inputs.similar) return hybrid_of_numbers(inputs);
    return std::make_unique<QuickContact<Itself>>(inputs, hybrid_of_numbers, Itself());
}

/// Yielded peaks, from numbers: the cut of Gaussian heights or of \p bearing, that of \p inputs or a copy.
FSTIFF_INLINE BearingCut<double> cut_of(const ContactInputs& inputs,
                                        std::shared_ptr<const MaterialRatioSlope<double>> bearing) {
    return {{std::sqrt(inputs.moments.m0), std::sqrt(2 * inputs.moments.m2), inputs.effective_modulus},
            std::move(bearing)};
}
/// The same while \p inputs has its bearing curve.
FSTIFF_INLINE BearingCut<double> cut_of(const ContactInputs& inputs) {
    return cut_of(inputs, {std::shared_ptr<void>(), inputs.bearing});  // owns nothing
}

/// Plastic as the law of hybrid of a QuickContact.
struct Flowing {
    double hardness;
    std::optional<double> stiffness(const ContactInputs& inputs, double K, double p) const {
        const double s = p / hardness;
        return s < 1 ? std::optional(detail::yielded(cut_of(inputs), s, K, hardness).stiffness) : std::nullopt;
    }
    QuickHybrid::PressureOver pressure(const ContactInputs& inputs) const {
        const PlasticContact contact(QuickElastic(inputs), cut_of(inputs), hardness);
        return [contact](double separation) -> std::optional<double> {
            try {
                return std::exp(contact.log_pressure(separation / contact.rms_height()).log);
            } catch (const domain_error&) {  // the law itself gives the reason
                return std::nullopt;
            }
        };
    }
};

FSTIFF_INLINE std::unique_ptr<AnyContact> plastic_of_numbers(const ContactInputs& inputs) {
    const auto bearing = inputs.bearing ? std::make_shared<const MaterialRatioSlope<double>>(*inputs.bearing) : nullptr;
    return with_hybrid_of_band(inputs, [&](auto&& contact) {
        return PlasticContact(std::move(contact), cut_of(inputs, bearing), inputs.material.hardness_or_default());
    });
}

FSTIFF_INLINE std::unique_ptr<AnyContact> plastic_contact(const ContactInputs& inputs) {
    if (inputs.map && inputs.spectrum_of_map) return inputs.map->contact(LawKind::plastic, inputs);
    if (!inputs.similar) return plastic_of_numbers(inputs);
    return std::make_unique<QuickContact<Flowing>>(inputs, plastic_of_numbers,
                                                   Flowing{inputs.material.hardness_or_default()});
}

FSTIFF_INLINE std::unique_ptr<AnyContact> plastic_peaks_contact(const ContactInputs& inputs) {
    const double hardness = inputs.material.hardness_or_default();
    PlasticMaterial<double> material = inputs.material;  // omega_c of Kogut and Etsion, which follows from H alone
    material.effective_modulus = inputs.effective_modulus;
    material.hardness = hardness;
    if (!(material.yield_strength > 0))
        material.yield_strength = hardness / detail::hardness_over_yield_strength<double>;
    const double critical_over_radius = KogutEtsionLaw<double>(material).critical(1.0);
    return std::make_unique<ErasedPlasticContact<RoughContact<double, PlasticLaw<double>>>>(
        RoughContact(inputs.surface, *inputs.peaks, PlasticLaw<double>(hardness, inputs.effective_modulus),
                     inputs.effective_modulus, options_of(inputs)),
        critical_over_radius);
}

/// A law of peaks that begin to yield. Its integrals have two dimensions, and the law itself is known to some percent.
template <class OfMaterial>
std::unique_ptr<AnyContact> elastic_plastic(const ContactInputs& inputs) {
    RoughContactOptions<double> options = options_of(inputs);
    options.integrals.relative_tolerance = inputs.similar ? 1e-3 : 1e-9;  // K of a band, within 1e-5
    PlasticMaterial<double> material = inputs.material;
    material.effective_modulus = inputs.effective_modulus;
    const OfMaterial law(material);
    return std::make_unique<ErasedPlasticContact<RoughContact<double, OfMaterial>>>(
        RoughContact(inputs.surface, *inputs.peaks, law, inputs.effective_modulus, options), law.critical(1.0));
}

/// K of the pressure and the rms height alone.
class ProportionalToPressure final : public AnyContact {
public:
    explicit ProportionalToPressure(double rms_height) : rms_height_(rms_height) {}
    Points at_pressures(std::span<const double> pressures, Quantity) const override {
        std::vector<ContactPoint<double>> points;
        for (const double p : pressures) {
            ContactState<double> state;
            state.pressure = {p, 0, 0};
            const double K = detail::linear_stiffness(p, rms_height_);
            state.stiffness = {K, 4 * std::numeric_limits<double>::epsilon() * K, 0};
            points.push_back(ContactPoint<double>::of(state));
        }
        return points;
    }
    Points at_separations(std::span<const double>, Quantity) const override {
        throw domain_error("law proportional: gives no separation; give pressures");
    }

private:
    double rms_height_;
};

FSTIFF_INLINE std::unique_ptr<AnyContact> proportional_contact(const ContactInputs& inputs) {
    return std::make_unique<ProportionalToPressure>(inputs.surface.rms_height);
}

/// A law that a map alone has.
template <LawKind law>
std::unique_ptr<AnyContact> of_map(const ContactInputs& inputs) {
    return inputs.map->contact(law, inputs);
}

}  // namespace law_rows
FSTIFF_INLINE std::shared_ptr<const MaterialRatioSlope<double>> bearing_of_shape(const HeightShape<double>& shape) {
    if (shape.is_gaussian()) return nullptr;
    static SharedValues<std::pair<double, double>, MaterialRatioSlope<double>>
        curves;  // of what is assumed of a process
    return curves.at({shape.skewness, shape.kurtosis}, [&] {
        return std::make_shared<const MaterialRatioSlope<double>>(
            detail::bearing_of_moments(shape.skewness, shape.kurtosis));
    });
}

}  // namespace detail
}}  // namespace fstiff
