// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Which law to believe of a scene, and to about what: the findings of validity/law_findings.hpp as sentences for
// people, the most important one first.

#include "scene/results.hpp"

#include <string>
#include <vector>

namespace fstiff::scene {

struct Verdict {
    std::vector<std::string> sentences;  ///< empty where nothing is known that decides
    std::vector<std::string> shorter;    ///< for a picture: one or two, and one where nothing decides
};
[[nodiscard]] Verdict verdict(const Scene& scene, const Results& results);

}  // namespace fstiff::scene
