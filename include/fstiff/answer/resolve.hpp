// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint resolved: what is written counts before what was measured, and that before a prior.

#include <fstiff/answer/resolved_joint.hpp>
#include <optional>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// A parameter of a surface in a JointFace, and its error.
struct FaceParameter {
    Parameter which;
    std::optional<double> JointFace::*value;
    std::optional<double> JointFace::Errors::*error;
};
/// In the order of Parameter.
inline constexpr FaceParameter face_parameters[]{
    {Parameter::rms_height, &JointFace::rms_height, &JointFace::Errors::height},
    {Parameter::peak_radius, &JointFace::peak_radius, &JointFace::Errors::peak_radius},
    {Parameter::peak_density, &JointFace::peak_density, &JointFace::Errors::peak_density},
    {Parameter::fractal_dimension, &JointFace::fractal_dimension, &JointFace::Errors::fractal_dimension},
    {Parameter::r, &JointFace::r, &JointFace::Errors::r},
    {Parameter::theta, &JointFace::theta, &JointFace::Errors::theta}};

/// The face of \p spec as the contact has it: what is written counts before what was measured, and that before a prior.
/// \throws domain_error naming the member of \p spec.
[[nodiscard]] Face face_of(const JointFace& spec);
/// \p joint resolved. Two maps have the shifts that a scene has: those of the seed of Request, whatever the draws have.
/// \throws domain_error naming the member that is out of range.
[[nodiscard]] ResolvedJoint problem_of(const Joint& joint, const LawOptions& options);
/// The joint peaks that were measured or given of the surface; where none are, those of the paper.
void take_peaks(ResolvedJoint& problem);

}}}  // namespace fstiff::detail
