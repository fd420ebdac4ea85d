// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One stiffness with its band for a joint: declarations, which cost a file no more than Eigen does. The functions come
/// from fstiff::double, from one file of the program that includes fstiff/implementation.hpp, or with
/// fstiff/answer_inline.hpp into the file itself (docs/linking-cpp.md).
///
/// ```cpp
/// #include <fstiff/answer_inline.hpp>
///
/// #include <cstdio>
///
/// int main() {
///     const fstiff::Body steel = body_of(*fstiff::find_material("C45"));
///     const fstiff::Joint joint{.face = {.rms_height = 0.5e-6, .rms_gradient = 0.1}, .upper = steel, .lower = steel};
///     for (const fstiff::AnswerPoint& point : fstiff::answer(joint, {10e6, 30e6}).points)
///         if (point.ok())
///             std::printf("%.0f MPa: K/A0 = %.3g Pa/m (%.3g to %.3g)\n", point.pressure * 1e-6, point.stiffness.value,
///                         point.stiffness.low, point.stiffness.high);
/// }
/// ```
/// ```text
/// 10 MPa: K/A0 = 8.71e+13 Pa/m (2.5e+13 to 3.07e+14)
/// 30 MPa: K/A0 = 2.39e+14 Pa/m (8.83e+13 to 7.26e+14)
/// ```

#include <fstiff/answer/answer.hpp>

#ifdef FSTIFF_COMPILED
#include <fstiff/double/alignment.hpp>
#endif
