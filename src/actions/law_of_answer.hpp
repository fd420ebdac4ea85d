// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The law of the answer of a scene, whose slope is K: for a table of a finite-element program, or as text.

#include "actions/answered.hpp"
#include "scene/scene.hpp"

#include <fstiff/core/parallel.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <optional>
#include <vector>

namespace fstiff::actions {

/// The law of the answer, or of an end of its band, and the answer that it goes through.
struct LawOfAnswer {
    Answered answered;       ///< of the nodes
    ContactLaw<double> law;  ///< from the first node with a K to the last; separations from that of the last on
};

/// The law at \p quantile of the answer of \p scene, 0.05, 0.5 or 0.95, from \p from to \p to [Pa]; after the greatest
/// pressure \p after [Pa] if that is given. Its nodes are the points of the answer of the scene, and so many between
/// them that cubics follow K within 1e-3.
/// \throws domain_error as compute(), Answer::law_at() and Answer::law_after().
[[nodiscard]] LawOfAnswer law_of_answer(const scene::Scene& scene, double quantile, double from, double to,
                                        const std::optional<double>& after, const ProgressHook& progress);

/// \p found at the pressures \p pressures [Pa] with the columns of \p scene. The loading stiffness is K: the law of a
/// contact that has closed. The mean planes are as far apart as in the answer at the greatest pressure, and recede from
/// there by the law. Pressures without a K are left out.
[[nodiscard]] AnswerCurve curve_at(const LawOfAnswer& found, const scene::Scene& scene,
                                   const std::vector<double>& pressures);

}  // namespace fstiff::actions
