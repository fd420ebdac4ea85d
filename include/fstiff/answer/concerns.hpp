// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What does not hold of an answer, and what to measure next.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/request.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The parameters of \p problem on which no result can rest, because they are not known to a factor of two; an answer
/// rests on the rms height and the gradient alone.
[[nodiscard]] std::vector<Parameter> unknown_parameters(const ResolvedJoint& problem, bool of_answer);
/// What of \p problem and of \p pressures [Pa] is likely in another unit: an rms height above 1 mm, a modulus below
/// 1 kPa, pressures below 1e-9 of the effective modulus.
[[nodiscard]] std::vector<Check<double>> unlikely_units(const ResolvedJoint& problem,
                                                        std::span<const double> pressures);
/// "rms height 0.8 m is above 1 mm: a unit is likely wrong", of a check of unlikely_units().
[[nodiscard]] std::string sentence_of_unit(const Check<double>& check);
/// Whether \p check, which does not hold of an answer at \p points, makes it doubtful.
[[nodiscard]] bool makes_doubtful(const Check<double>& check, std::size_t points);
/// How far the states of \p curve by law plastic are beyond all that it was compared with; none: not at all.
[[nodiscard]] std::optional<Check<double>> beyond_comparison(const ResolvedJoint& problem, const LawCurve& curve);
/// The rms gradient of \p face, whose peaks have the correlation of the greatest entry of ResolvedJoint::peaks, where
/// no surface has it.
[[nodiscard]] std::optional<ImplausibleGradient> implausible_gradient(const ResolvedJoint& problem, const Face& face);
/// All checks that do not hold of \p curve, the answer to \p request; `first` is a place among Request::points, or 0 of
/// the surface.
[[nodiscard]] std::vector<Check<double>> concerns_of(const ResolvedJoint& problem, const LawCurve& curve);

/// The measurement that narrows the band of \p answer, which \p request asked for, most at \p point of it; none where
/// nothing narrows it by a twentieth.
[[nodiscard]] std::optional<Answer::Next> next_measurement(const ResolvedJoint& problem, const Request& request,
                                                           const Answer& answer, const AnswerPoint& point);

}}}  // namespace fstiff::detail
