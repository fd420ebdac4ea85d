// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The table of fstiff run: the answer first, what it was computed of, and the laws that are named.

#include "document/output.hpp"
#include "scene/results.hpp"

#include <string>

namespace fstiff::cli {

/// A summary of \p results at the points of the answer; or, \p full, every point and quantity.
[[nodiscard]] std::string run_table(const Scene& scene, const Results& results, bool full);

}  // namespace fstiff::cli
