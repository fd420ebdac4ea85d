// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The columns of results, as the CSV, the JSON and the table of fstiff run have them.

#include "scene/results.hpp"
#include "document/rows.hpp"
#include "document/shown_unit.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace fstiff::scene {

/// The units of the columns, by the sizes of the scene.
struct Units {
    ShownUnit pressure, height, density, stiffness = unit_of_stiffness;
};

/// The name, the file and the SHA-256 of \p scene, for a JSON document.
[[nodiscard]] Json scene_json(const Scene& scene);

[[nodiscard]] Units units_of(const Scene& scene, const Results& results);
/// How people read \p column; one that is not for them is in CSV and JSON alone.
[[nodiscard]] Heading heading_of(const Column& column, const Units& units);
/// Every column of \p curve: law, theta, r, and what the scene asks for; the same keys for every curve of \p results.
[[nodiscard]] Rows rows_of(const Results& results, const Curve& curve, const Units& units = {});

/// The points of a summary, in their order: all of a list of up to twelve, and of a range of up to four; of more pressures
/// the least, the greatest and the decades; of more separations, or without a decade, four in even steps.
[[nodiscard]] std::vector<std::size_t> summary_points(const Scene& scene);

}  // namespace fstiff::scene
