// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Heights that no surface has: many equal ones at an end of a file (padding), and many at both ends of the range (a
// gauge at its stops).
//
//     padding    an end has 16 equal heights and 1 % of all, ten times as many as any other run of equal ones, which a
//                plateau or heights of coarse steps have too; a map also line by line along y
//     stops      each end of the range has 2 % of all heights, five times as many as the next level; both together have
//                5 to 60 %: two-level faces have more

#include "surface/surface_options.hpp"

#include <string>
#include <vector>

namespace fstiff::surface {

/// A warning for each of them, which names what removes it.
[[nodiscard]] std::vector<std::string> equal_heights_hints(const SurfaceOptions& options, const io::Surface& surface);

}  // namespace fstiff::surface
