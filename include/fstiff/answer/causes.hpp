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

#include <fstiff/answer/law_error.hpp>
#include <fstiff/math/statistics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace fstiff::inline v0_1::parts {

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
inline constexpr std::size_t cause_count = 10;

/// Ends of a band, or the part of one cause, as ln of K over the value: low at most 0, high at least 0.
template <Real T = double>
using CauseSpread = LawError<T>;
/// One spread for each Cause.
template <Real T = double>
using Causes = std::array<CauseSpread<T>, cause_count>;

/// The word of \p cause, as JSON has it.
[[nodiscard]] constexpr std::string_view name_of(Cause cause) {
    constexpr std::array<std::string_view, cause_count> names{
        "measurement", "cut_offs", "shape", "prior", "lay", "law", "contacts", "long_waves", "hardness", "noise"};
    return names[static_cast<std::size_t>(cause)];
}

/// The whole of \p causes.
template <Real T>
[[nodiscard]] CauseSpread<T> band_of(const Causes<T>& causes) {
    CauseSpread<T> whole;
    for (const CauseSpread<T>& one : causes) {
        whole.low = -std::hypot(whole.low, one.low);
        whole.high = std::hypot(whole.high, one.high);
    }
    return whole;
}

/// The share that each of \p causes has of the band, by squares; they add up to 1, or are 0 where there is no band.
template <Real T>
[[nodiscard]] std::array<T, cause_count> shares_of(const Causes<T>& causes) {
    std::array<T, cause_count> shares{};
    T all = 0;
    for (std::size_t i = 0; i < cause_count; ++i)
        all += shares[i] = causes[i].low * causes[i].low + causes[i].high * causes[i].high;
    if (all > T(0))
        for (T& one : shares) one /= all;
    return shares;
}

/// Uncertainty of K by the number of \p contacts on an area, 5 and 95 %; fewer than one count as one.
template <Real T>
[[nodiscard]] CauseSpread<T> scatter_of_contacts(T contacts) {
    const T width = math::normal_95<T>.value * T(0.77) / std::sqrt((std::max)(contacts, T(1)));
    return {-width, width};
}

}  // namespace fstiff::inline v0_1::parts
