// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The joint of a caller as the library has it.

#include "c/guard.hpp"

#include <fstiff/answer/joint.hpp>

#include <optional>

namespace fstiff::c {

/// A number that is not known where it is 0.
inline std::optional<double> known(double value) { return value == 0 ? std::nullopt : std::optional(value); }

/// The joint \p from, whose heights are measured; \p with_band: what the band of K takes of them, too.
[[nodiscard]] Joint joint_of(const fstiff_joint& from, bool with_band);

}  // namespace fstiff::c
