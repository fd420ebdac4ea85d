// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What does not hold of an answer, and what to measure next.

#include <fstiff/answer/curves.hpp>

#include <optional>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// The measured parameters of \p problem on which no result can rest; an answer rests on the rms height alone.
[[nodiscard]] std::vector<Parameter> unknown_parameters(const Problem& problem, bool of_answer);
/// How far the states of \p curve by law plastic are beyond all that it was compared with; none: not at all.
[[nodiscard]] std::optional<parts::Check<double>> beyond_comparison(const Problem& problem, const LawCurve& curve);
/// The rms gradient of \p face, whose peaks have the correlation of the greatest entry of Problem::peaks, where no
/// surface has it.
[[nodiscard]] std::optional<ImplausibleGradient> implausible_gradient(const Problem& problem, const Face& face);
/// All checks that do not hold of \p curve, the answer to \p request; `first` is a place among Request::points, or 0 of
/// the surface.
[[nodiscard]] std::vector<parts::Check<double>> concerns_of(const Problem& problem, const LawCurve& curve);

/// The measurement that narrows the band most.
struct NextMeasurement {
    std::optional<parts::Unknown> which{};  ///< none: the same measurement of four times the length or the area
    double factor = 0;                      ///< high over low of the band once it finds what is assumed now
};
/// Of the band of \p answer at its state \p at; none where nothing narrows that factor by a twentieth.
[[nodiscard]] std::optional<NextMeasurement> next_measurement(const Problem& problem, const Request& request,
                                                              const LawCurve& answer, const AnswerFacts& facts,
                                                              std::size_t at);

}  // namespace fstiff::inline v0_1::detail
