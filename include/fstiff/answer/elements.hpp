// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The answer: one K for each point, by the law that holds there, with the causes of its band.

#include <fstiff/answer/curves.hpp>

namespace fstiff::inline v0_1::detail {

/// In which form the laws have the surface.
[[nodiscard]] parts::KnownAs known_as(const Problem& problem);

/// The error of \p law at the p* of \p reason, with that of the grid \p relative to K.
[[nodiscard]] parts::CauseSpread<double> law_error(const Problem& problem, LawName law, const AnswerReason& reason,
                                                   double relative = 0);
/// Noise over the rms height, above which it is a concern.
inline constexpr double most_noise = 0.05;
/// Rms height [m] of the noise in the map of \p face; 0 of none, and where lambda_s was given.
[[nodiscard]] double noise_of(const Face& face, Edges edges);

/// Where the approach of \p curve, which has its states, begins, or why \p contact has no separation there.
void seat(const Request& request, const AnyContact& contact, LawCurve& curve);

/// Makes \p curve, of law_of_answer() with its states and its band, the answer: at points where boundary elements of
/// the map know more they take its place, and the band takes in every cause. \p progress is called while they are
/// solved.
[[nodiscard]] AnswerFacts make_answer(const Problem& problem, const Request& request, LawCurve& curve,
                                      const ProgressHook& progress);

}  // namespace fstiff::inline v0_1::detail
