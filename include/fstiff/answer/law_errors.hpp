// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Error of a law by itself: the interval of K of the contact about K of the law, other errors apart.
///
///     const auto error = fstiff::detail::law_error<double>({.law = fstiff::LawKind::hybrid, .p_star = 0.01});
///     use(K * std::exp(error.low), K * std::exp(error.high));       5 and 95 %
///
///     low  = -sqrt(low(p*)^2 + sum low_i^2),  high = sqrt(high(p*)^2 + sum high_i^2)
///     scatter  0.77/sqrt(n) of ln K of one surface with n contacts, one standard deviation
///
/// low(p*), high(p*): a table for each law and kind of knowledge, linear in ln p*; plastic: p/H in place of p*, and by
/// squares ever more of hybrid as H/(E g) rises. Other terms: docs/theory-contact.md, section 12.
///
/// Reference   docs/accuracy.md: boundary elements of maps of 19 kinds and of 13 kinds of faces, and the scatter
/// Units       p* = p/(E g_rms), ln K
/// Valid       any p*; the widest of the table where it is NaN

#include <fstiff/answer/causes.hpp>
#include <fstiff/answer/law_names.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/measurement.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace fstiff { inline namespace v0_1 { namespace detail {

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
    LawKind law{};
    KnownAs known = KnownAs::map;
    T p_star = std::numeric_limits<T>::quiet_NaN(), hardness{};  ///< hardness: H/(E g); 0: not known
    std::optional<Measurement<T>> skewness{}, kurtosis{};        ///< of heights, measured or taken
    bool shape_known = true;   ///< of numbers: skewness and kurtosis are given, not the far end of their prior
    bool alpha_known = false;  ///< of numbers, Nayak's m0 m4/m2^2
    T long_waves{};            ///< relative error of sigma that waves as long as the piece make; 0: none
};

/// p/H to which plastic was compared (tests/contact/plastic_contact_map_test.cpp).
inline constexpr double max_compared_flow = 0.95;
/// p* of the tables.
inline constexpr std::array<double, 7> law_error_pressures{3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.25};
/// Numbers at these, in per cent of ln K.
using LawErrorTable = std::array<int, law_error_pressures.size()>;

/// Errors of one law.
// clang-format off
struct LawErrorRow { LawErrorTable low, high; };
/// Of heights that are far from Gaussian: faces of one skewness and kurtosis differ where few points touch and, by
/// their patches, where many do. Those of yield are read at p/H, and were set on the law with its bearing curve.
inline constexpr LawErrorRow shape_errors_of_traces{{60, 60, 60, 60, 60, 60, 60}, {60, 60, 60, 60, 60, 60, 60}},
    shape_errors_of_numbers{{120, 120, 110, 78, 33, 33, 25}, {75, 75, 50, 45, 28, 54, 55}},
    shape_errors_with_alpha{{120, 120, 110, 78, 33, 33, 20}, {75, 75, 50, 45, 28, 54, 44}},
    shape_errors_of_flow{{130, 130, 130, 94, 94, 52, 52}, {46, 46, 46, 46, 46, 0, 0}};
// clang-format on

/// The row of \p law.
[[nodiscard]] constexpr LawErrorRow law_error_row(LawKind law, KnownAs known) {
    if (known == KnownAs::height) return {{35, 35, 35, 55, 73, 35, 25}, {80, 70, 60, 60, 64, 50, 35}};
    switch (law) {
        case LawKind::boundary_elements: return {{12, 9, 7, 7, 7, 5, 7}, {8, 6, 5, 4, 3, 3, 3}};
        case LawKind::hybrid:
            if (known == KnownAs::map) return {{22, 18, 9, 6, 4, 13, 20}, {20, 12, 9, 9, 11, 3, 2}};
            if (known == KnownAs::trace) return {{50, 50, 50, 50, 45, 35, 30}, {25, 25, 25, 20, 20, 25, 30}};
            return {{25, 20, 16, 15, 12, 12, 18}, {25, 20, 18, 15, 14, 20, 28}};
        case LawKind::plastic:
            if (known == KnownAs::map) return {{22, 20, 12, 10, 8, 8, 16}, {14, 12, 10, 11, 12, 11, 20}};
            if (known == KnownAs::trace) return {{30, 30, 26, 22, 20, 20, 20}, {36, 34, 28, 20, 12, 12, 14}};
            return {{39, 39, 35, 30, 29, 27, 29}, {41, 40, 32, 28, 27, 27, 28}};
        case LawKind::persson: return {{22, 18, 14, 12, 14, 14, 20}, {80, 70, 55, 35, 20, 15, 16}};
        case LawKind::summits: return {{22, 18, 14, 12, 10, 10, 10}, {20, 14, 14, 16, 30, 60, 100}};
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
    const bool yields = question.law == LawKind::plastic && H > T(0);
    const LawErrorRow flowed = law_error_row(question.law, question.known),
                      elastic = yields ? law_error_row(LawKind::hybrid, question.known) : flowed;
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
        const bool of_trace = question.known == KnownAs::trace;
        const LawErrorRow &alone = of_trace               ? shape_errors_of_traces
                                   : question.alpha_known ? shape_errors_with_alpha
                                                          : shape_errors_of_numbers,
                          &flowing = of_trace || !question.shape_known ? alone : shape_errors_of_flow;
        const T m = (std::min)(std::hypot(question.skewness->value, question.kurtosis->value - 3), T(1));
        const T first = T(law_error_pressures.front());  // it does not grow below
        low = std::hypot(low, m * spread(flowing.low, alone.low, first)),
        high = std::hypot(high, m * spread(flowing.high, alone.high, first));
    }
    return {-(std::min)(low, T(3)), (std::min)(high, T(3))};
}

/// p/(E g) up to which the contacts of a law, its peaks, count those of the face: they are 1 to 4 times as many there.
inline constexpr double most_of_spots = 0.03;

/// Uncertainty of K by the number of \p contacts on an area, 5 and 95 %; fewer than one count as one.
template <Real T>
[[nodiscard]] CauseSpread<T> scatter_of_contacts(T contacts) {
    const T width = math::normal_95<T>.value * T(0.77) / std::sqrt((std::max)(contacts, T(1)));
    return {-width, width};
}

}}}  // namespace fstiff::detail
