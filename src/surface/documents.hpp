// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured surface as JSON, as the command prints it and a scene reads it back.

#include "document/json.hpp"
#include "document/rows.hpp"
#include "surface/measured_surface.hpp"
#include "surface/roughness.hpp"

#include <cstddef>
#include <string>

namespace fstiff::scene {

/// The file, its SHA-256 and what was decided about it, for a JSON document.
[[nodiscard]] Json json_source(const SurfaceOptions& options, const SurfaceInput& input);
/// The options as they were given, for a JSON document; \p form is the one that was removed.
[[nodiscard]] Json json_inputs(const SurfaceOptions& options, const std::string& form);
/// lambda_s_m, lambda_c_m and the filter of lambda_c of a JSON document: null where there is none.
void put_cut_offs(Json& document, const parts::CutOffs<double>& cut_offs);
/// The grid of \p map, how many points were \p missing as it was read, and its cut-offs, for a JSON document.
void put_grid(Json& document, const HeightMap<double>& map, std::size_t missing,
              const parts::CutOffs<double>& cut_offs);

/// Measured parameters of a surface, for a JSON document that read_measured_document takes.
[[nodiscard]] Json measured_document(const MeasuredSurface& surface);

/// The roughness parameters of \p surface; of several files the means of theirs with one lambda_c, the longest that the
/// table chooses. \throws as roughness_table().
[[nodiscard]] RoughnessTable roughness_of(const MeasuredSurface& surface, const CutOff<double>& lambda_c = {});
/// The whole document of fstiff measure, \p surface being measured by \p options.
[[nodiscard]] Json measure_json(const MeasureOptions& options, const MeasuredSurface& surface);

}  // namespace fstiff::scene
