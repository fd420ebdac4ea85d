// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers of a face that are not given: assumed values, their uncertainty, and its effect on K.

#include <fstiff/answer/resolved_joint.hpp>

#include <cstddef>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Gives \p face, whose rms height is known, the numbers that a spectrum needs beyond those it has, by its process,
/// with a prior for each; the shape of the heights too unless \p shape_known. R or D_p that is not known follows.
void fill_unknown(Face& face, bool shape_known);

/// \p shape with its \p unknown, skewness or kurtosis, at \p value.
[[nodiscard]] HeightShape<double> with_value(const HeightShape<double>& shape, Unknown unknown, double value);
/// \p face with \p unknown at \p value, and with all that follows from it.
[[nodiscard]] Face with_value(Face face, Unknown unknown, double value);

/// \p face as it is with \p unknown measured, and found at its middle; skewness and kurtosis come from one measurement.
[[nodiscard]] Face with_measured(Face face, Unknown unknown);

/// A number of a face that is not known.
struct RelevantPrior {
    std::size_t face;  ///< its place among rough_faces()
    const Prior* prior;
};
/// Those that one of \p laws depends on; none where the laws take the spectrum of a map.
[[nodiscard]] std::vector<RelevantPrior> relevant_priors(const ResolvedJoint& problem,
                                                         const std::vector<const Law*>& laws);

/// Whether one of \p laws depends on the hardness.
[[nodiscard]] bool depends_on_hardness(const ResolvedJoint& problem, const std::vector<const Law*>& laws);
/// \p problem whose hardness is known to be \p value.
[[nodiscard]] ResolvedJoint with_hardness(ResolvedJoint problem, double value);

/// The surface of a joint with one unknown at its 5 and at its 95 %.
struct Alternative {
    Unknown which{};
    Face low, high;
};
/// One of each of relevant_priors().
[[nodiscard]] std::vector<Alternative> alternatives(const ResolvedJoint& problem, const std::vector<const Law*>& laws);

}}}  // namespace fstiff::detail
