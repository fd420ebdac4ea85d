// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The form of a joint from a map of the gap between its faces, such as the difference of two flatness measurements.
///
///     const auto form = fstiff::measured_form(map);     JointForm, as Joint::form takes it
///
/// The plane is removed, as faces turn until they touch; the waves that the grid does not hold are left to the
/// roughness.
///
/// Units       [m]
/// Valid       maps of 8 points a side or more, none of them missing, most of whose mean square is in waves that the
///             grid
///             holds: a map of roughness is no form
/// Accuracy    of the grid: halfspace/formed_joint.hpp

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/halfspace/joint_form.hpp>
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/form.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff { inline namespace v0_1 {

/// The form of the gap \p map on a grid of at most \p points a side. \throws domain_error for fewer than 8 points a
/// side, for missing points, as HeightMap::validate, and for a map of roughness.
[[nodiscard]] inline JointForm measured_form(const HeightMap<double>& map, Eigen::Index points = 64) {
    detail::require_form_points((std::min)({points, map.columns(), map.rows()}));
    map.validate(8);
    map.require_whole("before it is the form of a joint");
    const HeightMap<double> level = detail::remove_form(map, MapForm::plane);
    JointForm form;
    HeightMap<double>& grid = form.gap =
        detail::coarsened(level, (std::min)(points, map.columns()), (std::min)(points, map.rows()));
    const double kept = grid.heights.square().mean() / level.heights.square().mean();
    if (kept < 0.5)
        throw domain_error("form whose waves are for the most part shorter than " +
                           detail::rounded_text(2 * (std::max)(grid.dx, grid.dy), 2) +
                           " m: must be the gap of the whole faces, and not their roughness");
    grid.heights -= grid.heights.minCoeff();
    return form;
}

}}  // namespace fstiff
