// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The rows of the laws, and all of them by name: functions of answer/chosen_law.hpp and answer/laws.hpp, inline, or
/// compiled in fstiff::double. A program that is header-only compiles the rows that it names; who asks by a name at run
/// time has all of them.

#include <fstiff/answer/laws_inline.hpp>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

namespace law_rows {

inline constexpr Quantity without_contacts = Quantity::pressure | Quantity::separation | Quantity::stiffness |
                                             Quantity::real_area_fraction | Quantity::loading_stiffness;

FSTIFF_INLINE const Law& fractal() {
    static const Law row{.which = LawKind::fractal,
                         .nature = "as printed in the paper: K is not the slope of the load (docs/errata.md)",
                         .needs_dimension = true,
                         .load = "(3.7)",
                         .stiffness = "(3.14), (4.9)",
                         .peaks = "(4.4)",
                         .contact = joint<fractal_law>};
    return row;
}

FSTIFF_INLINE const Law& fractal_consistent() {
    static const Law row{.which = LawKind::fractal_consistent,
                         .nature = "elastic: K of the paper, with the load that has this slope",
                         .needs_dimension = true,
                         .load = "integral of (3.14)",
                         .stiffness = "(3.14), (4.9)",
                         .peaks = "(4.4)",
                         .contact = joint<fractal_consistent_law>};
    return row;
}

FSTIFF_INLINE const Law& hertz() {
    static const Law row{.which = LawKind::hertz,
                         .nature = "elastic: K is the slope of the load",
                         .load = "(3.7)",
                         .stiffness = "derivative of (3.7)",
                         .peaks = "(4.4)",
                         .contact = joint<hertz_law>};
    return row;
}

FSTIFF_INLINE const Law& greenwood_williamson() {
    static const Law row{.which = LawKind::greenwood_williamson,
                         .nature = "elastic, peaks of one radius",
                         .has_peaks = false,
                         .load = "(3.7)",
                         .stiffness = "derivative of (3.7)",
                         .peaks = "Gaussian, one radius",
                         .contact = greenwood_williamson_contact};
    return row;
}

FSTIFF_INLINE const Law& hybrid() {
    static const Law row{
        .which = LawKind::hybrid,
        .nature = "elastic, for all loads: peaks and Persson's theory",
        .has_peaks = false,
        .load = "at equal K",
        .stiffness = "(hertz^5 + persson^5)^(1/5)",
        .peaks = "from the spectrum cut where alpha is 6; for a map its summits, then its bearing curve",
        .contact = hybrid_contact,
        .needs_spectrum = true,
        .holds_when_crowded = true};
    return row;
}

FSTIFF_INLINE const Law& persson() {
    static const Law row{.which = LawKind::persson,
                         .nature = "elastic, from the spectrum: dense contacts",
                         .has_peaks = false,
                         .load = "Persson (2007)",
                         .stiffness = "Persson (2007), Almqvist et al. (2011)",
                         .peaks = "none: the spectrum",
                         .contact = persson_contact,
                         .quantities = without_contacts,
                         .needs_spectrum = true,
                         .holds_when_crowded = true};
    return row;
}

FSTIFF_INLINE const Law& summits() {
    static const Law row{.which = LawKind::summits,
                         .nature = "elastic, the map's own summits, which push each other down",
                         .has_peaks = false,
                         .load = "(3.7)",
                         .stiffness = "derivative of (3.7)",
                         .peaks = "the summits of the map",
                         .contact = of_map<LawKind::summits>,
                         .needs_map = true,
                         .needs_summits = true,
                         .ends = true,
                         .has_quick_form = true};
    return row;
}

FSTIFF_INLINE const Law& plastic() {
    static const Law row{.which = LawKind::plastic,
                         .nature = "yielded peaks: K is that of unloading, which a wave measures",
                         .load = "hardness and hybrid",
                         .stiffness = "from hybrid to the cut at p/H",
                         .peaks = "(4.4); for a map its summits",
                         .contact = plastic_contact,
                         .quantities = without_contacts,
                         .needs_spectrum = true,
                         .needs_hardness = true,
                         .holds_when_crowded = true};
    return row;
}

FSTIFF_INLINE const Law& plastic_peaks() {
    static const Law row{
        .which = LawKind::plastic_peaks,
        .nature = "fully plastic peaks without interaction: K is that of unloading, which a wave measures",
        .load = "hardness times area, 2 pi R omega",
        .stiffness = "unloading, 2 E a",
        .peaks = "(4.4)",
        .contact = plastic_peaks_contact,
        .needs_hardness = true,
        .range = {.least_interference = 110, .most_radius_ratio = 0.4}};
    return row;
}

FSTIFF_INLINE const Law& jackson_green() {
    static const Law row{.which = LawKind::jackson_green,
                         .nature = "elastic to plastic: K is that of unloading, which a wave measures",
                         .load = "Jackson, Green (2005)",
                         .stiffness = "unloading, 2 E a",
                         .peaks = "(4.4)",
                         .contact = elastic_plastic<JacksonGreenLaw<double>>,
                         .needs_yield = true,
                         .range = {.most_radius_ratio = 0.41}};
    return row;
}

FSTIFF_INLINE const Law& kogut_etsion() {
    static const Law row{.which = LawKind::kogut_etsion,
                         .nature = "elastic to plastic: K is that of unloading, which a wave measures",
                         .load = "Kogut, Etsion (2002)",
                         .stiffness = "unloading, 2 E a",
                         .peaks = "(4.4)",
                         .contact = elastic_plastic<KogutEtsionLaw<double>>,
                         .needs_yield = true,
                         .range = {.most_interference = 110, .most_radius_ratio = 0.41}};
    return row;
}

FSTIFF_INLINE const Law& boundary_elements() {
    static const Law row{.which = LawKind::boundary_elements,
                         .nature = "the half-space solution for the map itself; the error is that of the grid",
                         .has_peaks = false,
                         .load = "elastic half space",
                         .stiffness = "of the contact held together",
                         .peaks = "the map itself",
                         .contact = of_map<LawKind::boundary_elements>,
                         .needs_map = true,
                         .needs_whole_map = true,
                         .holds_when_crowded = true,
                         .varies = false};
    return row;
}

FSTIFF_INLINE const Law& proportional() {
    static const Law row{.which = LawKind::proportional,
                         .nature = "elastic, from the rms height alone: K is p/(0.48 sigma)",
                         .has_peaks = false,
                         .load = "not given",
                         .stiffness = "Akarapu, Sharp, Robbins (2011)",
                         .peaks = "none: the rms height",
                         .contact = proportional_contact,
                         .quantities = Quantity::pressure | Quantity::stiffness,
                         .holds_when_crowded = true};
    return row;
}

inline constexpr std::array all{laws::fractal,       laws::fractal_consistent,
                                laws::hertz,         laws::greenwood_williamson,
                                laws::hybrid,        laws::persson,
                                laws::summits,       laws::plastic,
                                laws::plastic_peaks, laws::jackson_green,
                                laws::kogut_etsion,  laws::boundary_elements,
                                laws::proportional};

}  // namespace law_rows

FSTIFF_INLINE std::span<const ChosenLaw> all_laws() { return law_rows::all; }

FSTIFF_INLINE std::vector<std::string_view> law_names() {
    const auto words = detail::choices<LawKind>();
    return {words.begin(), words.end()};
}

FSTIFF_INLINE const Law& find_law(LawKind name) { return law_rows::all[static_cast<std::size_t>(name)].row(); }

FSTIFF_INLINE const Law* find_law(std::string_view name) {
    const auto match = detail::find_named<LawKind>(name);
    return match ? &find_law(*match) : nullptr;
}

}}}  // namespace fstiff::detail
