// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint resolved: what is written counts before what was measured, and that before a prior.

#include <fstiff/answer/resolved_joint.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The face of \p spec as the contact has it: what is written counts before what was measured, and that before a prior.
/// \throws domain_error naming the member of \p spec.
[[nodiscard]] Face face_of(const JointFace& spec);
/// \p joint resolved. Two maps have the shifts that a scene has: those of the seed of Request, whatever the draws have.
/// \throws domain_error naming the member that is out of range.
[[nodiscard]] ResolvedJoint problem_of(const Joint& joint, const LawOptions& options);
/// Gives \p conduction the conductivities of both bodies where it has none.
void take_conductivities(const Body& upper, const Body& lower, Conduction& conduction);
/// The joint peaks that were measured or given of the surface; where none are, those of the paper.
void take_peaks(ResolvedJoint& problem);

}}}  // namespace fstiff::detail
