// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/laws.hpp: inline, or compiled in fstiff::double.

#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/held_contacts.hpp>
#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/boundary_element_contact.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fstiff::inline v0_1 {

FSTIFF_INLINE ContactLaw<double> AnyContact::tabulate(const LawRange<double>&) const {
    throw domain_error(
        "this law cannot be tabulated: it gives no separation, or each of its points is a solution by boundary "
        "elements; choose another");
}

namespace detail {

/// The contacts of each law.
namespace of_laws {

FSTIFF_INLINE RoughContactOptions<double> options_of(const ContactInputs& inputs) {
    RoughContactOptions<double> options;
    options.interaction = inputs.interaction;
    return options;
}

// one contact and one fit are compiled for all three elastic laws
using LawOfDimension = ElasticLaw<double> (*)(double dimension);
FSTIFF_INLINE ElasticLaw<double> fractal(double dimension) { return FractalLaw<double>(dimension); }
FSTIFF_INLINE ElasticLaw<double> fractal_consistent(double dimension) {
    return FractalConsistentLaw<double>(dimension);
}
FSTIFF_INLINE ElasticLaw<double> hertz(double) { return HertzLaw<double>{}; }

/// A contact of joint peaks with the asperity law that \p of_dimension makes of the fractal dimension.
template <LawOfDimension of_dimension>
std::unique_ptr<AnyContact> joint(const ContactInputs& inputs) {
    return held(RoughContact(inputs.surface, *inputs.peaks, of_dimension(inputs.fractal_dimension),
                             inputs.effective_modulus, options_of(inputs)));
}

template <LawOfDimension of_dimension>
Identification<double> fitted(const FitInputs& inputs) {
    return identify(inputs.data, inputs.parameters, inputs.start, of_dimension, inputs.options);
}

FSTIFF_INLINE std::unique_ptr<AnyContact> greenwood_williamson(const ContactInputs& inputs) {
    return held(
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

FSTIFF_INLINE std::unique_ptr<AnyContact> persson(const ContactInputs& inputs) { return held(of_spectrum(inputs)); }

/// The mean of what \p make makes of the summits of every shift and its number.
template <class Make>
std::unique_ptr<AnyContact> over_shifts(const ContactInputs& inputs, const Make& make) {
    std::vector<decltype(make(inputs.map->summits.front(), 0))> contacts;
    for (std::size_t shift = 0; shift < inputs.map->summits.size(); ++shift)
        contacts.push_back(make(inputs.map->summits[shift], shift));
    return mean_over(std::move(contacts));
}

/// The crowded contact of one shift by its bearing curve.
FSTIFF_INLINE BearingContact<double> crowded(const ContactInputs& inputs, std::size_t shift) {
    const MapOfSurface& map = *inputs.map;
    return map.bearings
        ->contact(map.first_bearing + shift, inputs.options.edges, inputs.effective_modulus, inputs.options.gamma)
        .scaled(map.taller)
        .over_rms_height(map.rms_height());
}

FSTIFF_INLINE std::unique_ptr<AnyContact> summits(const ContactInputs& inputs) {
    if (!inputs.options.mutual)
        return over_shifts(inputs, [&](const Summits<double>& summits, std::size_t) {
            return SummitContact<double>(summits, inputs.effective_modulus);
        });
    return over_shifts(inputs, [&](const Summits<double>& summits, std::size_t) {
        return MutualSummits<double>(summits, inputs.effective_modulus, inputs.options.edges);
    });
}

/// The hybrid law of one shift of a map, and of numbers.
FSTIFF_INLINE auto hybrid_of_map(const ContactInputs& inputs, const Summits<double>& summits, std::size_t shift) {
    const MapOfSurface& map = *inputs.map;
    SummitContact<double> peaks(summits, inputs.effective_modulus);
    BearingContact<double> crowded_contact = crowded(inputs, shift);
    HandOver<double> hand_over =
        map.bearings
            ->hand_over(map.first_bearing + shift, inputs.options.edges, inputs.effective_modulus, inputs.options.gamma)
            .scaled(peaks, map.taller);
    return HybridContact(std::move(peaks), std::move(crowded_contact), std::move(hand_over));
}
/// Calls \p make with hybrid from numbers, with Gaussian heights or a bearing curve.
template <class Make>
std::unique_ptr<AnyContact> of_hybrid_of_numbers(const ContactInputs& inputs, const Make& make) {
    const BandSpectrum<double> band = band_of_moments(inputs.moments, inputs.hurst);
    if (!inputs.bearing) return held(make(hybrid_of_band(band, inputs.effective_modulus, inputs.options.gamma)));
    return held(make(hybrid_of_band(band, *inputs.bearing, inputs.effective_modulus, inputs.options.gamma)));
}

FSTIFF_INLINE std::unique_ptr<AnyContact> hybrid_of_numbers(const ContactInputs& inputs) {
    return of_hybrid_of_numbers(inputs, [](auto&& contact) { return std::move(contact); });
}

/// Hybrid as the law of hybrid of a QuickContact.
struct Itself {
    static std::optional<double> stiffness(const ContactInputs&, double K, double) { return K; }
    static QuickHybrid::PressureOver pressure(const ContactInputs& inputs) { return inputs.similar->pressure(inputs); }
};

FSTIFF_INLINE std::unique_ptr<AnyContact> hybrid(const ContactInputs& inputs) {
    if (!inputs.map || !inputs.spectrum_of_map) {
        if (!inputs.similar) return hybrid_of_numbers(inputs);
        return std::make_unique<QuickContact<Itself>>(inputs, hybrid_of_numbers, Itself());
    }
    return over_shifts(inputs, [&](const Summits<double>& summits, std::size_t shift) {
        return hybrid_of_map(inputs, summits, shift);
    });
}

/// Yielded peaks, from numbers: the cut of a Gaussian surface.
FSTIFF_INLINE GaussianCut<double> gaussian_cut(const ContactInputs& inputs) {
    return {std::sqrt(inputs.moments.m0), std::sqrt(2 * inputs.moments.m2), inputs.effective_modulus};
}

/// Plastic as the law of hybrid of a QuickContact.
struct Flowing {
    double hardness;
    std::optional<double> stiffness(const ContactInputs& inputs, double K, double p) const {
        const double s = p / hardness;
        return s < 1 ? std::optional(detail::yielded(s, gaussian_cut(inputs).stiffness(s), K).stiffness) : std::nullopt;
    }
    QuickHybrid::PressureOver pressure(const ContactInputs& inputs) const {
        const PlasticContact contact(QuickElastic(inputs), gaussian_cut(inputs), hardness);
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
    return of_hybrid_of_numbers(inputs, [&](auto&& contact) {
        return PlasticContact(std::move(contact), gaussian_cut(inputs), inputs.material.hardness_or_default());
    });
}

/// The same; of a map with the cut of the map itself.
FSTIFF_INLINE std::unique_ptr<AnyContact> plastic(const ContactInputs& inputs) {
    const double hardness = inputs.material.hardness_or_default();
    if (!inputs.map || !inputs.spectrum_of_map) {
        if (!inputs.similar) return plastic_of_numbers(inputs);
        return std::make_unique<QuickContact<Flowing>>(inputs, plastic_of_numbers, Flowing{hardness});
    }
    return over_shifts(inputs, [&](const Summits<double>& summits, std::size_t shift) {
        const auto cut = inputs.map->bearings->cut(inputs.map->first_bearing + shift, inputs.options.edges,
                                                   inputs.effective_modulus);
        return PlasticContact(hybrid_of_map(inputs, summits, shift), cut.scaled(inputs.map->taller), hardness);
    });
}

FSTIFF_INLINE std::unique_ptr<AnyContact> plastic_peaks(const ContactInputs& inputs) {
    const double hardness = inputs.material.hardness_or_default();
    PlasticMaterial<double> material = inputs.material;  // omega_c of Kogut and Etsion, which follows from H alone
    material.effective_modulus = inputs.effective_modulus;
    material.hardness = hardness;
    if (!(material.yield_strength > 0))
        material.yield_strength = hardness / detail::hardness_over_yield_strength<double>;
    const double critical_over_radius = KogutEtsionLaw<double>(material).critical(1.0);
    return std::make_unique<PlasticHolder<RoughContact<double, PlasticLaw<double>>>>(
        RoughContact(inputs.surface, *inputs.peaks, PlasticLaw<double>(hardness, inputs.effective_modulus),
                     inputs.effective_modulus, options_of(inputs)),
        critical_over_radius);
}

/// A law of peaks that begin to flow. Its integrals have two dimensions, and the law itself is known to some percent.
template <class OfMaterial>
std::unique_ptr<AnyContact> elastic_plastic(const ContactInputs& inputs) {
    RoughContactOptions<double> options = options_of(inputs);
    options.integrals.relative_tolerance = inputs.similar ? 1e-3 : 1e-9;  // K of a band, within 1e-5
    PlasticMaterial<double> material = inputs.material;
    material.effective_modulus = inputs.effective_modulus;
    const OfMaterial law(material);
    return std::make_unique<PlasticHolder<RoughContact<double, OfMaterial>>>(
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

FSTIFF_INLINE std::unique_ptr<AnyContact> proportional(const ContactInputs& inputs) {
    return std::make_unique<ProportionalToPressure>(inputs.surface.rms_height);
}

FSTIFF_INLINE std::unique_ptr<AnyContact> boundary_elements(const ContactInputs& inputs) {
    const LawOptions& options = inputs.options;
    const TruthOptions<double> settings{
        .points = options.points, .edges = options.edges, .hardness = options.hardness, .progress = inputs.progress};
    std::vector<BoundaryElementContact<double>> of_shifts;
    for (const auto& map : inputs.map->maps) of_shifts.emplace_back(*map, inputs.effective_modulus, settings);
    return mean_over(std::move(of_shifts));
}

inline constexpr Quantity without_contacts = Quantity::pressure | Quantity::separation | Quantity::stiffness |
                                             Quantity::real_area_fraction | Quantity::loading_stiffness;

inline const std::array<Law, 13> table{{
    {.which = LawName::fractal,
     .nature = "as printed in the paper: K is not the slope of the load (docs/errata.md)",
     .needs_dimension = true,
     .load = "(3.7)",
     .stiffness = "(3.14), (4.9)",
     .peaks = "(4.4)",
     .contact = joint<fractal>,
     .fit = fitted<fractal>},
    {.which = LawName::fractal_consistent,
     .nature = "elastic: K of the paper, with the load that has this slope",
     .needs_dimension = true,
     .load = "integral of (3.14)",
     .stiffness = "(3.14), (4.9)",
     .peaks = "(4.4)",
     .contact = joint<fractal_consistent>,
     .fit = fitted<fractal_consistent>},
    {.which = LawName::hertz,
     .nature = "elastic: K is the slope of the load",
     .load = "(3.7)",
     .stiffness = "derivative of (3.7)",
     .peaks = "(4.4)",
     .contact = joint<hertz>,
     .fit = fitted<hertz>},
    {.which = LawName::greenwood_williamson,
     .nature = "elastic, peaks of one radius",
     .has_peaks = false,
     .load = "(3.7)",
     .stiffness = "derivative of (3.7)",
     .peaks = "Gaussian, one radius",
     .contact = greenwood_williamson},
    {.which = LawName::hybrid,
     .nature = "elastic, for all loads: peaks and Persson's theory",
     .has_peaks = false,
     .load = "at equal K",
     .stiffness = "(hertz^5 + persson^5)^(1/5)",
     .peaks = "from the spectrum cut where alpha is 6; for a map its summits, then its bearing curve",
     .contact = hybrid,
     .needs_spectrum = true,
     .holds_when_crowded = true},
    {.which = LawName::persson,
     .nature = "elastic, from the spectrum: crowded contacts",
     .has_peaks = false,
     .load = "Persson (2007)",
     .stiffness = "Persson (2007), Almqvist et al. (2011)",
     .peaks = "none: the spectrum",
     .contact = persson,
     .quantities = without_contacts,
     .needs_spectrum = true,
     .holds_when_crowded = true},
    {.which = LawName::summits,
     .nature = "elastic, the map's own summits, which push each other down",
     .has_peaks = false,
     .load = "(3.7)",
     .stiffness = "derivative of (3.7)",
     .peaks = "the summits of the map",
     .contact = summits,
     .needs_map = true,
     .needs_summits = true,
     .ends = true,
     .has_quick_form = true},
    {.which = LawName::plastic,
     .nature = "yielded peaks: K is that of unloading, which a wave measures",
     .load = "hardness and hybrid",
     .stiffness = "from hybrid to the cut at p/H",
     .peaks = "(4.4); for a map its summits",
     .contact = plastic,
     .quantities = without_contacts,
     .needs_spectrum = true,
     .needs_hardness = true,
     .holds_when_crowded = true},
    {.which = LawName::plastic_peaks,
     .nature = "fully plastic peaks without interaction: K is that of unloading, which a wave measures",
     .load = "hardness times area, 2 pi R omega",
     .stiffness = "unloading, 2 E a",
     .peaks = "(4.4)",
     .contact = plastic_peaks,
     .needs_hardness = true,
     .range = {.least_interference = 110, .most_radius_ratio = 0.4}},
    {.which = LawName::jackson_green,
     .nature = "elastic to plastic: K is that of unloading, which a wave measures",
     .load = "Jackson, Green (2005)",
     .stiffness = "unloading, 2 E a",
     .peaks = "(4.4)",
     .contact = elastic_plastic<JacksonGreenLaw<double>>,
     .needs_yield = true,
     .range = {.most_radius_ratio = 0.41}},
    {.which = LawName::kogut_etsion,
     .nature = "elastic to plastic: K is that of unloading, which a wave measures",
     .load = "Kogut, Etsion (2002)",
     .stiffness = "unloading, 2 E a",
     .peaks = "(4.4)",
     .contact = elastic_plastic<KogutEtsionLaw<double>>,
     .needs_yield = true,
     .range = {.most_interference = 110, .most_radius_ratio = 0.41}},
    {.which = LawName::boundary_elements,
     .nature = "the half-space solution for the map itself; the error is that of the grid",
     .has_peaks = false,
     .load = "elastic half space",
     .stiffness = "of the contact held together",
     .peaks = "the map itself",
     .contact = boundary_elements,
     .needs_map = true,
     .needs_whole_map = true,
     .holds_when_crowded = true,
     .varies = false},
    {.which = LawName::proportional,
     .nature = "elastic, from the rms height alone: K is p/(0.48 sigma)",
     .has_peaks = false,
     .load = "not given",
     .stiffness = "Akarapu, Sharp, Robbins (2011)",
     .peaks = "none: the rms height",
     .contact = proportional,
     .quantities = Quantity::pressure | Quantity::stiffness,
     .holds_when_crowded = true},
}};

}  // namespace of_laws

FSTIFF_INLINE std::span<const Law> laws() { return of_laws::table; }

FSTIFF_INLINE std::vector<std::string_view> law_names() {
    const auto words = detail::choices<LawName>();
    return {words.begin(), words.end()};
}

FSTIFF_INLINE std::vector<std::string_view> fitted_law_names() {
    std::vector<std::string_view> names;
    for (const Law& law : of_laws::table)
        if (law.varies) names.push_back(law.name);
    return names;
}

FSTIFF_INLINE Identification<double> fit_curve(const FitInputs& inputs, const CurveOfParameters<double>& curve) {
    return detail::identify_by_differences(inputs.data, inputs.parameters, inputs.start, curve, inputs.options);
}

FSTIFF_INLINE const Law& find_law(LawName name) { return of_laws::table[static_cast<std::size_t>(name)]; }

FSTIFF_INLINE const Law* find_law(std::string_view name) {
    const auto match = detail::find_named<LawName>(name);
    return match ? &find_law(*match) : nullptr;
}

}  // namespace detail
}  // namespace fstiff::inline v0_1
