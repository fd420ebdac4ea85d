// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One stiffness for one pressure: the law that gives it, and the causes of its band.
///
///     q.known = KnownAs::map;  q.available = {LawName::hybrid, LawName::boundary_elements};
///     answering_law(q)                       boundary_elements, where 20 points of the grid or more touch
///     const auto band = band_of(causes);     K exp(band.low), K exp(band.high): 5 and 95 %
///
///     band     low = -sqrt(sum low_i^2), high = sqrt(sum high_i^2) over the causes i, in ln K
///     scatter  0.77/sqrt(n) of ln K of one surface with n contacts, one standard deviation
///
/// Reference   sum by squares: independent errors (JCGM 100:2008, 5.1.2), in logarithms; docs/accuracy.md (scatter 7.7,
///             11, 20 and 36 % at 100, 40, 15 and 5 contacts)
/// Units       p* = p/(E g_rms), ln K
/// Valid       any contact; numbers that are not known are NaN or 0, as each member describes
/// Accuracy    of the causes (tests/answer/causes_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/height_shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

// The laws of contact by their names, as scenes, commands and documents have them.
//
//     name_of(fstiff::LawName::hybrid)          "hybrid"

namespace fstiff::inline v0_1 {

/// The laws of contact.
enum class LawName {
    none = -1,  ///< of a point without a result; it has no word
    fractal,
    fractal_consistent,
    hertz,
    greenwood_williamson,
    hybrid,
    persson,
    summits,
    plastic,
    plastic_peaks,
    jackson_green,
    kogut_etsion,
    boundary_elements,
    proportional
};

template <>
inline constexpr auto names<LawName> = detail::name_list<LawName>({{LawName::fractal, "fractal"},
                                                                   {LawName::fractal_consistent, "fractal_consistent"},
                                                                   {LawName::hertz, "hertz"},
                                                                   {LawName::greenwood_williamson,
                                                                    "greenwood_williamson"},
                                                                   {LawName::hybrid, "hybrid"},
                                                                   {LawName::persson, "persson"},
                                                                   {LawName::summits, "summits"},
                                                                   {LawName::plastic, "plastic"},
                                                                   {LawName::plastic_peaks, "plastic_peaks"},
                                                                   {LawName::jackson_green, "jackson_green"},
                                                                   {LawName::kogut_etsion, "kogut_etsion"},
                                                                   {LawName::boundary_elements, "boundary_elements"},
                                                                   {LawName::proportional, "proportional"}});

}  // namespace fstiff::inline v0_1

// Error of a law by itself: the interval of K of the contact about K of the law, other errors apart.
//
//     const auto error = fstiff::detail::law_error<double>({.law = fstiff::LawName::hybrid, .p_star = 0.01});
//     use(K * std::exp(error.low), K * std::exp(error.high));       5 and 95 %
//
//     low  = -sqrt(low(p*)^2 + sum low_i^2),  high = sqrt(high(p*)^2 + sum high_i^2)
//
// low(p*), high(p*): a table for each law and kind of knowledge, linear in ln p*; plastic: p/H in place of p*, and by
// squares ever more of hybrid as H/(E g) rises. Other terms: docs/theory-contact.md, section 15.
//
// Reference   docs/accuracy.md: boundary elements of maps of 19 kinds, seeds 10 to 13, and of 13 kinds of faces
// Units       p* = p/(E g_rms), ln K
// Valid       any p*; the widest of the table where it is NaN
// Accuracy    coverage on other kinds and seeds: docs/accuracy.md

namespace fstiff::inline v0_1::detail {

/// The form in which a law has a surface.
enum class KnownAs {
    map,      ///< every height
    trace,    ///< a profile
    numbers,  ///< height and gradient at least
    height    ///< the height alone
};

/// Inputs of the error of a law.
template <Real T = double>
struct LawErrorQuestion {
    LawName law{};
    KnownAs known = KnownAs::map;
    T p_star = std::numeric_limits<T>::quiet_NaN(), hardness{};  ///< hardness: H/(E g); 0: not known
    std::optional<Measurement<T>> skewness{}, kurtosis{};        ///< of heights, measured or taken
    T long_waves{};  ///< relative error of sigma that waves as long as the piece make; 0: none
};

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

/// Ends of a band, the part of one cause or the error of a law, as ln of K over the value: 5 and 95 %, low at most 0,
/// high at least 0.
template <Real T = double>
struct CauseSpread {
    T low{}, high{};
};

}  // namespace fstiff::inline v0_1

namespace fstiff::inline v0_1::detail {

/// p/H to which plastic was compared (tests/contact/plastic_contact_map_test.cpp).
inline constexpr double max_compared_flow = 0.95;
/// p* of the tables.
inline constexpr std::array<double, 7> law_error_pressures{3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.25};
/// Numbers at these, in per cent of ln K.
using LawErrorTable = std::array<int, law_error_pressures.size()>;

/// Errors of one law.
// clang-format off
struct LawErrorRow { LawErrorTable low, high; };
/// Of heights that are far from Gaussian: faces of one skewness and kurtosis differ where few points carry and, by
/// their patches, where many do.
inline constexpr LawErrorRow shape_errors_of_traces{{60, 60, 60, 60, 60, 60, 60}, {60, 60, 60, 60, 60, 60, 60}},
    shape_errors_of_numbers{{120, 120, 110, 55, 33, 33, 25}, {75, 75, 50, 33, 20, 50, 42}};
// clang-format on

/// The row of \p law.
[[nodiscard]] constexpr LawErrorRow law_error_row(LawName law, KnownAs known) {
    if (known == KnownAs::height) return {{35, 35, 35, 55, 73, 35, 25}, {80, 70, 60, 60, 64, 50, 35}};
    switch (law) {
        case LawName::boundary_elements: return {{12, 9, 7, 7, 7, 5, 7}, {8, 6, 5, 4, 3, 3, 3}};
        case LawName::hybrid:
            if (known == KnownAs::map) return {{22, 18, 9, 6, 4, 13, 20}, {20, 12, 9, 9, 11, 3, 2}};
            if (known == KnownAs::trace) return {{50, 50, 50, 50, 45, 35, 30}, {25, 25, 25, 20, 20, 25, 30}};
            return {{25, 20, 16, 15, 12, 12, 18}, {25, 20, 18, 15, 14, 20, 28}};
        case LawName::plastic:
            if (known == KnownAs::map) return {{22, 20, 12, 10, 8, 8, 16}, {14, 12, 10, 11, 12, 11, 20}};
            if (known == KnownAs::trace) return {{30, 30, 26, 22, 20, 20, 20}, {36, 34, 28, 20, 12, 12, 14}};
            return {{30, 30, 24, 17, 14, 11, 14}, {32, 31, 20, 12, 10, 9, 12}};
        case LawName::persson: return {{22, 18, 14, 12, 14, 14, 20}, {80, 70, 55, 35, 20, 15, 16}};
        case LawName::summits: return {{22, 18, 14, 12, 10, 10, 10}, {20, 14, 14, 16, 30, 60, 100}};
        default: return {{45, 40, 35, 30, 25, 20, 20}, {30, 30, 30, 35, 55, 90, 150}};
    }
}

/// Value of \p table, in per cent, at \p p_star; its greatest where that is NaN.
template <Real T>
[[nodiscard]] T at_pressure(const LawErrorTable& table, T p_star) {
    const auto& pressures = law_error_pressures;
    if (std::isnan(p_star)) return T(*std::max_element(table.begin(), table.end())) / 100;
    const T first = T(pressures.front()), last = T(pressures.back());
    const T p = (std::max)(p_star, (std::numeric_limits<T>::min)());
    if (p < first) return T(table.front()) / 100 * std::sqrt(first / p);
    if (p > last) return T(table.back()) / 100 * (1 + std::log(p / last));
    std::size_t i = 1;
    while (i + 1 < pressures.size() && p > T(pressures[i])) ++i;
    const T share = std::log(p / T(pressures[i - 1])) / std::log(T(pressures[i]) / T(pressures[i - 1]));
    return ((1 - share) * T(table[i - 1]) + share * T(table[i])) / 100;
}

/// The error of the law of \p question.
template <Real T>
[[nodiscard]] CauseSpread<T> law_error(const LawErrorQuestion<T>& question) {
    const T H = question.hardness;
    const bool yields = question.law == LawName::plastic && H > T(0);
    const LawErrorRow flowed = law_error_row(question.law, question.known),
                      elastic = yields ? law_error_row(LawName::hybrid, question.known) : flowed;
    const T share = std::clamp(question.p_star / H, T(1.5e-4), T(law_error_pressures.back())),  // K goes as p/H below
        of_elastic = H * H / (H * H + T(0.25));
    const auto spread = [&](const LawErrorTable& of_flowed, const LawErrorTable& of_elastic_peaks, T least) {
        const T alone = at_pressure(of_elastic_peaks, (std::max)(question.p_star, least));
        if (!yields) return alone;
        return std::hypot(std::sqrt(1 - of_elastic) * at_pressure(of_flowed, (std::max)(share, least)),
                          std::sqrt(of_elastic) * alone);
    };
    // of a map to both sides; of a trace whose peaks yield to the taller one, to which sigma of few waves is skewed
    const bool map = question.known == KnownAs::map, trace = question.known == KnownAs::trace && yields;
    T low = std::hypot(spread(flowed.low, elastic.low, 0), (map ? T(0.8) : T(trace)) * question.long_waves),
      high = std::hypot(spread(flowed.high, elastic.high, 0), (map ? T(0.8) : T(0)) * question.long_waves);
    if (question.known != KnownAs::map && question.skewness && question.kurtosis) {
        const auto& table = question.known == KnownAs::trace ? shape_errors_of_traces : shape_errors_of_numbers;
        const T m = (std::min)(std::hypot(question.skewness->value, question.kurtosis->value - 3), T(1));
        const T first = T(law_error_pressures.front());  // it does not grow below
        low = std::hypot(low, m * spread(table.low, table.low, first)),
        high = std::hypot(high, m * spread(table.high, table.high, first));
    }
    return {-(std::min)(low, T(3)), (std::min)(high, T(3))};
}

/// p* to which hybrid and persson were compared (tests/contact/hybrid_of_band_test.cpp); beyond it the contact is
/// closed.
inline constexpr double max_compared_pressure = 0.75;
/// Points of the grid in contact from which boundary elements resolve a contact and not the pixel.
inline constexpr double min_points_in_contact = 20;
/// Weight of boundary elements next to the law of the summits, where \p touching points of their grid do by the latter:
/// 1/2 at min_points_in_contact, and linear in the logarithm, from 0 at 7 points to 1 at 57.
template <Real T>
[[nodiscard]] T weight_of_elements(T touching) {
    return std::clamp(T(0.5) + std::log(touching / T(min_points_in_contact)) / std::log(T(8)), T(0), T(1));
}

/// Facts on a contact at one pressure.
template <Real T = double>
struct AnswerQuestion {
    std::vector<LawName> available{};  ///< laws that can be computed of the surface
    KnownAs known = KnownAs::map;
    T points_in_contact{};  ///< of the grid of boundary elements; 0: not solved

    [[nodiscard]] bool can(LawName law) const {
        return std::find(available.begin(), available.end(), law) != available.end();
    }
};

/// The law that answers: boundary elements of the map if min_points_in_contact touch, else plastic, which needs a
/// hardness, hybrid, hertz, greenwood_williamson. \throws domain_error where none of them is available.
template <Real T>
[[nodiscard]] LawName answering_law(const AnswerQuestion<T>& question) {
    if (question.can(LawName::boundary_elements) && question.points_in_contact >= T(min_points_in_contact))
        return LawName::boundary_elements;
    for (const LawName law : {LawName::plastic, LawName::hybrid, LawName::hertz, LawName::greenwood_williamson})
        if (question.can(law)) return law;
    throw domain_error("no law answers: the surface must have a height and a gradient, or a map");
}

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

/// Causes of a K that differs from the printed one.
enum class Cause {
    measurement,  ///< errors of the measured parameters: another piece of the same surface
    cut_offs,     ///< choice of lambda_s and of the form
    shape,        ///< shape of the heights, which the measurement does not show
    prior,        ///< parameters that were not measured
    lay,          ///< a profile does not show the length of ridges
    law,          ///< the law by itself
    contacts,     ///< few contacts on the nominal area
    long_waves,   ///< waves longer than the measured piece
    hardness,     ///< of the softer body, which is not known
    noise         ///< of the instrument that measured a map
};

}  // namespace fstiff::inline v0_1

namespace fstiff::inline v0_1::detail {

inline constexpr std::size_t cause_count = 10;

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

/// One spread for each Cause.
template <Real T = double>
using Causes = std::array<CauseSpread<T>, detail::cause_count>;

/// The word of \p cause, as JSON has it.
[[nodiscard]] constexpr std::string_view name_of(Cause cause) {
    constexpr std::array<std::string_view, detail::cause_count> names{
        "measurement", "cut_offs", "shape", "prior", "lay", "law", "contacts", "long_waves", "hardness", "noise"};
    return names[static_cast<std::size_t>(cause)];
}

}  // namespace fstiff::inline v0_1

namespace fstiff::inline v0_1::detail {

/// The whole of \p causes.
template <Real T>
[[nodiscard]] CauseSpread<T> band_of(const Causes<T>& causes) {
    CauseSpread<T> total;
    for (const CauseSpread<T>& cause : causes) {
        total.low = -std::hypot(total.low, cause.low);
        total.high = std::hypot(total.high, cause.high);
    }
    return total;
}

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

/// The share that each of \p causes has of the band, by squares; they add up to 1, or are 0 where there is no band.
template <Real T>
[[nodiscard]] std::array<T, detail::cause_count> shares_of(const Causes<T>& causes) {
    std::array<T, detail::cause_count> shares{};
    T total = 0;
    for (std::size_t i = 0; i < detail::cause_count; ++i)
        total += shares[i] = causes[i].low * causes[i].low + causes[i].high * causes[i].high;
    if (total > T(0))
        for (T& share : shares) share /= total;
    return shares;
}

}  // namespace fstiff::inline v0_1

namespace fstiff::inline v0_1::detail {

/// Uncertainty of K by the number of \p contacts on an area, 5 and 95 %; fewer than one count as one.
template <Real T>
[[nodiscard]] CauseSpread<T> scatter_of_contacts(T contacts) {
    const T width = math::normal_95<T>.value * T(0.77) / std::sqrt((std::max)(contacts, T(1)));
    return {-width, width};
}

}  // namespace fstiff::inline v0_1::detail
