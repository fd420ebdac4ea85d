// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Surface parameters that a scene does not give: assumed values, their uncertainty, and its effect on K.

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace fstiff::scene {

/// "of any process", "of a ground face".
[[nodiscard]] std::string of_process(const Face& face);
/// "alpha 8 (2 to 50), of any process".
[[nodiscard]] std::string assumed_phrase(const std::string& name, const parts::PriorRange& range,
                                         const std::string& origin);

/// Gives \p face, whose rms height is known, the numbers that a spectrum needs beyond those it has, by its process,
/// with a prior for each; the shape of the heights too unless \p shape_known. R or D_p that is not known follows.
void fill_unknown(Face& face, bool shape_known);

/// \p face with \p which at \p value, and with all that follows from it.
[[nodiscard]] Face with_value(Face face, parts::Unknown which, double value);

/// \p face as it is with \p which measured, and found at its middle; skewness and kurtosis come from one measurement.
[[nodiscard]] Face with_measured(Face face, parts::Unknown which);

/// The surface of a scene with one unknown at its 5 and at its 95 %.
struct Alternative {
    parts::Unknown which{};
    Face low, high;
};
/// Unknowns that a law of \p scene depends on; none where its laws take the spectrum of a map.
[[nodiscard]] std::vector<Alternative> alternatives(const Scene& scene);

/// An assumed number that the scene does not give, and that a law of it depends on.
struct AssumedNumber {
    std::string key;  ///< in the scene: "surface.alpha"
    double value = 0;
    std::string phrase;  ///< for Scene::assumptions
};
[[nodiscard]] std::vector<AssumedNumber> assumed_numbers(const Scene& scene);

}  // namespace fstiff::scene
