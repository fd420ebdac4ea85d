// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The law that holds for a contact, and how well: findings with their numbers, the most important one first.
///
///     const auto advice = fstiff::recommended_law(fstiff::measure(map), 112e9, std::vector{1e6, 10e6});
///     if (advice.law) use(*advice.law);                          such as LawName::hybrid
///     for (const auto& one : advice.findings) use(one.finding, one.value, one.limit, one.ratio);
///
/// Every threshold is a constant below, next to its source; those that check_curve() uses too are in
/// validity/checks.hpp.
///
/// Reference   docs/validation.md: boundary elements of Gaussian maps, skewed ones and plastic ones; docs/accuracy.md
/// Units       p* = p/(E g_rms), heights over the rms height, numbers of contacts
/// Valid       isotropic surfaces, but for Finding::profile_with_lay
/// Accuracy    the thresholds have one or two digits, the ratios are those of their sources
///             (tests/validity/law_findings_test.cpp reaches every finding and every threshold from both sides)

#include <fstiff/measured/height_shape.hpp>
#include <fstiff/measured/measure.hpp>
#include <fstiff/measured/widened_band.hpp>
#include <fstiff/topography/summits.hpp>
#include <fstiff/validity/checks.hpp>
#include <fstiff/validity/validated_ratio.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff {

namespace parts {

/// Departures from Gaussian heights beyond which K of a law over Gaussian peaks is off, and beyond which no law over a
/// distribution of peaks is near: of skewness, of kurtosis - 3, and of the highest point over that of Gaussian summits.
/// The numbers are those of the maps of docs/validation.md that are not Gaussian; two standard errors are asked for
/// too.
inline constexpr double gaussian_skewness = 0.3, gaussian_kurtosis = 1;
inline constexpr double far_skewness = 1, far_kurtosis = 2, far_peak = 1.6;
/// K over boundary elements of laws over Gaussian peaks, on skewed maps of docs/validation.md: at skewnesses of 0.35 to
/// 0.9, of -0.9 to -0.23, and beyond (README: 5 times too stiff).
inline constexpr StiffnessRatio ratio_of_positive_skewness{1.05, 1.9}, ratio_of_negative_skewness{0.3, 0.9},
    ratio_far_from_gaussian{1 / 5.0, 5};

/// Percent of boundary elements within which K of hybrid is at 96 of 100 points of single surfaces, by their map or,
/// where they are Gaussian, by their numbers, from min_validated_pressure on. The means of families are nearer.
inline constexpr int hybrid_accuracy_percent = 15;
/// p* above which hybrid is within a quarter, and below which within a factor of two (docs/validation.md).
inline constexpr double sparse_pressure = 0.001;
/// p* to which hybrid and persson were compared (tests/contact/hybrid_of_band_test.cpp), and beyond which they refuse.
inline constexpr double max_compared_pressure = 0.75;
inline constexpr StiffnessRatio within_hybrid_accuracy{1 - hybrid_accuracy_percent / 100.0,
                                                       1 + hybrid_accuracy_percent / 100.0},
    within_quarter{0.75, 1.25}, within_half{1 / 1.5, 1.5}, within_factor_of_two{0.5, 2};
/// K of a sum over independent peaks at p* of 0.1, and p* from and to which hertz is within a fifth
/// (docs/validation.md).
inline constexpr StiffnessRatio ratio_of_crowded_peaks{0.5, 1}, within_fifth{0.8, 1.2};
inline constexpr double hertz_from = 0.002, hertz_to = 0.008;

/// Contacts below which the departure of one surface from a law counts (docs/accuracy.md).
inline constexpr double many_contacts = 200;
/// The rms departure of K of one surface from a law above a number of contacts (docs/accuracy.md).
struct ContactScatter {
    double above, share;  ///< number of contacts; of K
};
inline constexpr std::array<ContactScatter, 4> contact_scatter{{{100, 0.07}, {40, 0.11}, {15, 0.16}, {0, 0.34}}};

}  // namespace parts

/// What is found of a contact and its laws.
enum class Finding {
    profile_with_lay,    ///< no law: K may be higher by value, since a profile does not know how far the ridges reach
    far_from_gaussian,   ///< no law over a distribution of peaks; value: what is beyond its limit
    sums_too_stiff,      ///< heights not Gaussian: K of laws over Gaussian peaks is too large
    sums_too_compliant,  ///< heights not Gaussian: K of laws over Gaussian peaks is too small
    sums_off,            ///< heights not Gaussian, of unknown side
    peaks_flow,          ///< value: the plasticity index; law: whose K is that of unloading, if there is one
    hybrid_holds,        ///< of the elastic laws; value: the least p*
    hybrid_missing,      ///< the surface has no spectrum; ratio: of hertz from hertz_from to hertz_to
    crowded_peaks,       ///< value: the greatest p*, at which sums over independent peaks give too little K
    beyond_comparison,   ///< value: the greatest p*; above the limit hybrid and persson alone were compared
    few_contacts,        ///< value: the fewest contacts; ratio: of one surface over the law, rms
    no_contact           ///< value: the fewest contacts, less than one: a mean over many surfaces
};

/// One finding.
template <Real T = double>
struct LawFinding {
    Finding finding{};
    T value{}, limit{};            ///< the number that decided, and what it was held against
    std::optional<LawName> law{};  ///< recommended by it
    parts::StiffnessRatio ratio{};        ///< of K of the laws concerned over that of the contact; 0: not known
};

namespace parts {

/// How hybrid knows the heights.
enum class HeightsKnown {
    map,             ///< or Gaussian ones
    given_shape,     ///< by skewness and kurtosis, or a bearing curve, that are given
    measured_shape,  ///< by those of a trace, as far as they count
};

/// What is known of a contact.
template <Real T = double>
struct LawQuestion {
    std::vector<LawName> available{};  ///< laws that can be computed of the surface
    T least_pressure = std::numeric_limits<T>::infinity(), greatest_pressure{};  ///< p*; least NaN: no gradient known
    T fewest_contacts = std::numeric_limits<T>::infinity();  ///< expected on the area; infinite: not known
    std::optional<Measurement<T>> skewness{}, kurtosis{};    ///< none: heights not measured
    T highest_point{};       ///< over the rms height; 0: not known
    std::size_t summits{};   ///< of the map; 0: no map
    HeightsKnown heights = HeightsKnown::map;
    bool has_lay = false;                ///< measured by a profile that repeats itself
    std::optional<T> plasticity_index{};

    [[nodiscard]] bool can(LawName law) const {
        return std::find(available.begin(), available.end(), law) != available.end();
    }
    /// The first of \p laws that is available.
    [[nodiscard]] std::optional<LawName> first_of(std::initializer_list<LawName> laws) const {
        for (const LawName law : laws)
            if (can(law)) return law;
        return std::nullopt;
    }
    /// Whether the p* are known.
    [[nodiscard]] bool has_pressures() const { return least_pressure <= greatest_pressure; }
    /// Takes in the p* of \p pressure [Pa].
    void add_pressure(T pressure, T effective_modulus, const std::optional<T>& rms_gradient) {
        const T p = rms_gradient ? dimensionless_pressure(pressure, effective_modulus, *rms_gradient)
                                 : std::numeric_limits<T>::quiet_NaN();
        least_pressure = p < least_pressure ? p : std::isnan(p) ? p : least_pressure;
        greatest_pressure = (std::max)(greatest_pressure, p);
    }
    /// Takes in p* and contacts of \p states on \p area [m^2]; 0: not known.
    void add_states(std::span<const ContactState<T>> states, T effective_modulus, const std::optional<T>& rms_gradient,
                    T area) {
        for (const ContactState<T>& state : states) {
            add_pressure(state.pressure.value, effective_modulus, rms_gradient);
            const T contacts = state.contact_density.value * area;
            if (contacts > T(0)) fewest_contacts = (std::min)(fewest_contacts, contacts);
        }
    }
};

/// Whether \p one is farther from \p gaussian than \p limit, and than two standard errors.
template <Real T>
[[nodiscard]] bool departs(const Measurement<T>& one, T gaussian, T limit) {
    const T distance = std::abs(one.value - gaussian);
    return distance > limit && distance > 2 * one.error;
}

/// The highest of \p summits Gaussian summits, of two at least, over the rms height.
template <Real T>
[[nodiscard]] T highest_gaussian_summit(std::size_t summits) {
    return std::sqrt(2 * std::log((std::max)(static_cast<T>(summits), T(2))));
}

/// What the distribution of the heights does to every law over Gaussian peaks.
template <Real T>
[[nodiscard]] std::optional<LawFinding<T>> finding_of_heights(const LawQuestion<T>& question) {
    if (!question.skewness || !question.kurtosis) return std::nullopt;
    const Measurement<T>&skewness = *question.skewness, &kurtosis = *question.kurtosis;
    const T over_gaussian =
        question.summits > 0 ? question.highest_point / highest_gaussian_summit<T>(question.summits) : T(0);
    const auto departed = [&](T value, double limit) {
        return LawFinding<T>{Finding::far_from_gaussian, value, T(limit),
                             question.first_of({LawName::boundary_elements, LawName::hybrid}), ratio_far_from_gaussian};
    };
    if (departs(skewness, T(0), T(far_skewness))) return departed(skewness.value, far_skewness);
    if (departs(kurtosis, T(3), T(far_kurtosis))) return departed(kurtosis.value - 3, far_kurtosis);
    if (over_gaussian > T(far_peak)) return departed(over_gaussian, far_peak);
    const bool skewed = departs(skewness, T(0), T(gaussian_skewness));
    if (!skewed && !departs(kurtosis, T(3), T(gaussian_kurtosis))) return std::nullopt;
    LawFinding<T> off{Finding::sums_off, kurtosis.value - 3, T(gaussian_kurtosis)};
    if (skewed) off.value = skewness.value, off.limit = T(gaussian_skewness);
    off.ratio = {ratio_of_negative_skewness.low, ratio_of_positive_skewness.high};
    if (!departs(skewness, T(0), T(0))) return off;
    off.finding = skewness.value > T(0) ? Finding::sums_too_stiff : Finding::sums_too_compliant;
    off.ratio = skewness.value > T(0) ? ratio_of_positive_skewness : ratio_of_negative_skewness;
    return off;
}

/// K of hybrid over that of the contact down to \p least p*.
template <Real T>
[[nodiscard]] StiffnessRatio ratio_of_hybrid(HeightsKnown heights, T least) {
    if (heights == HeightsKnown::measured_shape) return within_half;
    if (heights == HeightsKnown::given_shape) return within_quarter;
    if (least >= T(min_validated_pressure)) return within_hybrid_accuracy;
    return least >= T(sparse_pressure) ? within_quarter : within_factor_of_two;
}

/// Which elastic law holds at the pressures.
template <Real T>
void add_pressures(const LawQuestion<T>& question, std::vector<LawFinding<T>>& findings) {
    if (!question.has_pressures()) return;
    const T low = question.least_pressure, high = question.greatest_pressure;
    const std::optional<LawName> hybrid = question.first_of({LawName::hybrid});
    LawFinding<T> beyond{Finding::beyond_comparison, high, T(max_validated_pressure)};
    if (high <= T(max_compared_pressure)) beyond.law = hybrid, beyond.ratio = within_hybrid_accuracy;
    if (low > T(max_validated_pressure)) return findings.push_back(beyond);
    findings.push_back(hybrid ? LawFinding<T>{Finding::hybrid_holds, low, T(min_validated_pressure), hybrid,
                                              ratio_of_hybrid(question.heights, low)}
                              : LawFinding<T>{Finding::hybrid_missing, low, T(hertz_from), {}, within_fifth});
    if (high > max_dimensionless_pressure<T>)
        findings.push_back(
            {Finding::crowded_peaks, high, max_dimensionless_pressure<T>, {}, ratio_of_crowded_peaks});
    if (high > T(max_validated_pressure)) findings.push_back(beyond);
}

template <Real T>
void add_contacts(T fewest, std::vector<LawFinding<T>>& findings) {
    if (!(fewest < T(many_contacts))) return;
    if (fewest < T(1)) return findings.push_back({Finding::no_contact, fewest, T(1)});
    const auto row = std::find_if(contact_scatter.begin(), contact_scatter.end(),
                                  [&](const ContactScatter& one) { return fewest > T(one.above); });
    findings.push_back({Finding::few_contacts, fewest, T(many_contacts), {}, {1 - row->share, 1 + row->share}});
}

/// What \p question has to be told of the laws, the most important finding first. Empty where nothing is known that
/// decides.
template <Real T>
[[nodiscard]] std::vector<LawFinding<T>> law_findings(const LawQuestion<T>& question) {
    std::vector<LawFinding<T>> findings;
    const std::optional<LawFinding<T>> heights = finding_of_heights(question);
    if (question.has_lay)
        findings.push_back({Finding::profile_with_lay, T(lay_factor), T(1), {}, {1 / lay_factor, 1}});
    else if (heights)
        findings.push_back(*heights);
    if (question.plasticity_index && *question.plasticity_index > max_elastic_plasticity_index<T>) {
        LawFinding<T> flow{Finding::peaks_flow, *question.plasticity_index, max_elastic_plasticity_index<T>,
                           question.first_of({LawName::plastic, LawName::plastic_peaks})};
        if (flow.law == LawName::plastic) flow.ratio = within_fifth;  // p from 0.003 to 0.1 H (docs/validation.md)
        findings.push_back(flow);
    }
    if (!question.has_lay && !(heights && heights->finding == Finding::far_from_gaussian))
        add_pressures(question, findings);
    add_contacts(question.fewest_contacts, findings);
    return findings;
}

}  // namespace parts

/// The law that holds, and why.
template <Real T = double>
struct LawAdvice {
    std::optional<LawName> law{};  ///< none: no law, or none that the surface has, or no gradient is known
    std::vector<LawFinding<T>> findings{};
};

namespace parts {

/// That of \p findings, of which the first that recommends a law counts.
template <Real T>
[[nodiscard]] LawAdvice<T> law_advice(std::vector<LawFinding<T>> findings) {
    LawAdvice<T> advice{{}, std::move(findings)};
    for (const LawFinding<T>& one : advice.findings) {
        if (one.finding == Finding::profile_with_lay) break;
        if (advice.law = one.law; advice.law) break;
    }
    return advice;
}

/// The laws of numbers, or of a map without missing points, that \p surface has.
template <Real T>
[[nodiscard]] std::vector<LawName> laws_of(const Surface<T>& surface, std::size_t summits, bool yields) {
    std::vector<LawName> laws{LawName::greenwood_williamson};
    if (surface.r && surface.theta) laws.push_back(LawName::hertz);
    bool spectrum = surface.heights && surface.heights->moments.bandwidth() > T(1.5);
    if (surface.map) {
        const HeightMap<T>& map = surface.map->map;
        const bool whole = map.present() == map.size();
        const Eigen::Index side = (std::min)(map.rows(), map.columns());
        spectrum = whole && side >= 4 && summits > 0;
        if (whole && side >= 16) laws.push_back(LawName::boundary_elements);
        if (summits > 0) laws.push_back(LawName::summits);
    }
    if (spectrum) laws.insert(laws.end(), {LawName::hybrid, LawName::persson});
    if (spectrum && yields) laws.push_back(LawName::plastic);
    if (yields && surface.r && surface.theta) laws.push_back(LawName::plastic_peaks);
    return laws;
}

}  // namespace parts

/// The law that holds for \p surface against a smooth flat under \p pressures [Pa], with the effective modulus [Pa]
/// and, where it is known, the yield strength of the softer body [Pa]. The number of contacts is not asked.
/// \throws domain_error for a pressure, a modulus or a yield strength that is not positive.
template <Real T, class Pressures>
[[nodiscard]] LawAdvice<T> recommended_law(const Surface<T>& surface, std::type_identity_t<T> effective_modulus,
                                           const Pressures& pressures,
                                           std::type_identity_t<std::optional<T>> yield_strength = {}) {
    require_positive("effective_modulus", effective_modulus);
    parts::LawQuestion<T> question;
    if (surface.map) question.summits = summits_of(surface.map->map).summits.size();
    question.available = parts::laws_of(surface, question.summits, yield_strength.has_value());
    for (const T pressure : pressures) {
        require_positive("pressure", pressure);
        question.add_pressure(pressure, effective_modulus,
                              surface.rms_gradient.value > T(0) ? std::optional(surface.rms_gradient.value)
                                                                : std::nullopt);
    }
    if (surface.heights) {
        question.skewness = surface.heights->skewness;
        question.kurtosis = surface.heights->kurtosis;
        if (!surface.map && !parts::counted_shape(*surface.heights, surface.shape_share).is_gaussian())
            question.heights = parts::HeightsKnown::measured_shape;
    }
    question.highest_point = surface.max_peak_height.value / surface.rms_height.value;
    question.has_lay = parts::is_profile_with_lay(surface);
    if (yield_strength)
        question.plasticity_index = parts::plasticity_index<T>(
            {surface.rms_height.value, surface.peak_radius.value, surface.peak_density.value}, effective_modulus,
            *yield_strength);
    return parts::law_advice(parts::law_findings(question));
}

}  // namespace fstiff
