// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The law that answers at one pressure, and how far boundary elements of the map do.
///
///     q.known = KnownAs::map;  q.available = {LawKind::hybrid, LawKind::boundary_elements};
///     answering_law(q)                       boundary_elements, where 20 points of the grid or more touch
///
/// Reference   docs/accuracy.md
/// Units       p* = p/(E g_rms)
/// Valid       any contact; numbers that are not known are 0

#include <fstiff/answer/law_errors.hpp>
#include <fstiff/core/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

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

/// The laws that answer where no boundary elements do, the preferred ones first.
inline constexpr std::array laws_of_numbers{LawKind::plastic, LawKind::hybrid, LawKind::hertz,
                                            LawKind::greenwood_williamson};

/// Facts on a contact at one pressure.
template <Real T = double>
struct AnswerQuestion {
    std::vector<LawKind> available{};  ///< laws that can be computed of the surface
    KnownAs known = KnownAs::map;
    T points_in_contact{};  ///< of the grid of boundary elements; 0: not solved

    [[nodiscard]] bool can(LawKind law) const {
        return std::find(available.begin(), available.end(), law) != available.end();
    }
};

/// The law that answers: boundary elements of the map if min_points_in_contact touch, else plastic, which needs a
/// hardness, hybrid, hertz, greenwood_williamson. \throws domain_error where none of them is available.
template <Real T>
[[nodiscard]] LawKind answering_law(const AnswerQuestion<T>& question) {
    if (question.can(LawKind::boundary_elements) && question.points_in_contact >= T(min_points_in_contact))
        return LawKind::boundary_elements;
    for (const LawKind law : laws_of_numbers)
        if (question.can(law)) return law;
    throw domain_error("no law answers: the surface must have a height and a gradient, or a map");
}

}}}  // namespace fstiff::detail
