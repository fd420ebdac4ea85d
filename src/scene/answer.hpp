// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The answer of a scene: one K for each of its points, by the law that holds there, with a band and its causes.

#include "scene/results.hpp"

namespace fstiff::scene {

/// Gives \p scene the one law that answers where no boundary elements do: plastic where the peaks yield, hybrid where
/// they do not. A map with missing points answers by its numbers.
void set_law_of_answer(Scene& scene);

/// The indentation hardness of the softer body [Pa], of its yield strength where that alone is known; 0: neither is.
[[nodiscard]] double hardness_of(const Scene& scene);
/// H/(E g), of the softer body and the surface; none where one of them is not known. Where one body alone has a
/// hardness, that of the softer one is no greater: known as far as it makes the peaks flow.
[[nodiscard]] std::optional<double> relative_hardness(const Scene& scene);

/// \p base, a curve of set_law_of_answer() with its states and its band, made the answer: at points where boundary
/// elements of the map know more they take its place, and the band takes in every cause. \p progress is called while
/// they are solved.
[[nodiscard]] StiffnessAnswer answer_of(const Scene& scene, const Results& results, Curve base,
                                        const ProgressHook& progress);

/// The points that the answer of a table and boundary elements are of, in their order: all up to twelve or of a list;
/// else the ends and the decades.
[[nodiscard]] std::vector<std::size_t> points_of_answer(const Scene& scene);

}  // namespace fstiff::scene
