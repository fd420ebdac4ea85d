// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What a law lacks of a joint.

#include <fstiff/answer/resolved_joint.hpp>
#include <string>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Why a law cannot be computed of a joint.
enum class Lack {
    nothing,
    separation,   ///< the law gives none
    peaks,        ///< R and D_p are not known
    map,          ///< the face is not a map
    sum_of_maps,  ///< two faces are not maps of one grid
    summits,      ///< no point of the map is above its eight neighbours
    points,       ///< of the map, of which some are missing
    side,         ///< the map has fewer than 16 points a side
    small_map,    ///< the map has fewer than 4 points a side, too few for a spectrum
    moments,      ///< R and D_p, or gradient and alpha, are not known
    range,        ///< the moments are beyond the range of double precision
    alpha,        ///< that the moments make is 1.5 or less
    hardness,     ///< is infinite
    yield_strength
};

/// Why \p face has no spectrum for Persson's theory.
[[nodiscard]] Lack lack_of_spectrum(const Face& face);
/// Why \p law cannot be computed of \p problem.
[[nodiscard]] Lack lack_of(const Law& law, const ResolvedJoint& problem, bool at_separations = false);

/// \p lack as the reason of a law.
[[nodiscard]] std::string reason_of(Lack lack);
/// \throws domain_error where \p law cannot be computed of \p problem.
void require_possible(const Law& law, const ResolvedJoint& problem, bool at_separations = false);
/// The row of \p law. \throws as require_possible, and where \p law is none.
[[nodiscard]] const Law& possible_law(const ChosenLaw& law, const ResolvedJoint& problem, bool at_separations = false);

/// The joint distributions of peaks of which \p law has a curve each; none for a law that has none. Where none are
/// given, those of an isotropic surface of its alpha; the laws of the paper keep the paper's pair.
[[nodiscard]] std::vector<Peaks> peaks_of(const Law& law, const ResolvedJoint& problem);

}}}  // namespace fstiff::detail
