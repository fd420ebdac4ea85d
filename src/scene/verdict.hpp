// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Which law to believe of a scene, and to about what: sentences for people, the most important one first.
//
// What stands behind the numbers: docs/validation.md (boundary elements of Gaussian surfaces, skewed ones, plastic ones).

#include "scene/results.hpp"

#include <string>
#include <vector>

namespace fstiff::scene {

/// Empty where nothing is known that decides: no gradient, no measured heights, no yield strength.
[[nodiscard]] std::vector<std::string> verdict(const Scene& scene, const Results& results);

/// The same for a picture: two short sentences at most, and one where nothing decides.
[[nodiscard]] std::vector<std::string> short_verdict(const Scene& scene, const Results& results);

}  // namespace fstiff::scene
