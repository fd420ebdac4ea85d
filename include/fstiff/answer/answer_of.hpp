// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The answer of a joint that is resolved, as fstiff::answer() and the command have it.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/resolved_joint.hpp>

#include <optional>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// fstiff::answer() of \p joint at \p points. \p contacts, where they are given, are those of its laws; there are no
/// checks then. A joint whose laws are named has them where no law answers.
/// \throws domain_error as answer().
[[nodiscard]] Answer answer_of(const ResolvedJoint& joint, std::span<const double> points, const AnswerOptions& options,
                               const std::vector<MadeContact>* contacts = nullptr);

/// The point of \p state by \p law, without a band, with the quantities of \p options that it has.
[[nodiscard]] AnswerPoint point_of(const ResolvedJoint& joint, const Law& law, const ContactState<double>& state,
                                   const AnswerOptions& options);
/// Answer::next of \p answer, which answer_of() gave of the same arguments.
[[nodiscard]] std::optional<Answer::Next> next_of(const ResolvedJoint& joint, std::span<const double> points,
                                                  const AnswerOptions& options, const Answer& answer);

}}}  // namespace fstiff::detail
