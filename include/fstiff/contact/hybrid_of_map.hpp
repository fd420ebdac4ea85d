// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The law `hybrid` for a map, from its heights: elliptic summits at light loads, Persson's theory at the local slope
/// of the bearing curve at heavy ones, and the hand-over between them. It is a fstiff::Contact, so that it has a table.
///
/// Reference   contact/hybrid_contact.hpp, contact/material_ratio_contact.hpp
/// Units       SI
/// Valid       heights after form and cut-offs (measure/prepare.hpp), without missing points; p/(E g) up to 0.75
/// Accuracy    within 15 % of boundary elements at 97 of 100 points of 25 kinds of maps (docs/validation.md); the same
///             number as `fstiff run` (tests/scene/one_measurement_test.cpp)

#include <fstiff/contact/crossover.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/topography/gaussian_order.hpp>

namespace fstiff { inline namespace v0_1 {

/// Returns the contact of \p map under the effective modulus \p effective_modulus [Pa]; \p edges continues the map
/// beyond its edges. \throws domain_error for missing points, a map without summits, or a modulus that is not positive.
template <Real T>
[[nodiscard]] HybridContact<T, SummitContact<T>, Crossover<T>> hybrid_of_map(const HeightMap<T>& map,
                                                                             std::type_identity_t<T> effective_modulus,
                                                                             Edges edges = Edges::mirrored) {
    const detail::GaussianOrder<T> order = detail::gaussian_order(map);
    const Summits<T> summits = summits_of(map);
    const MaterialRatioContact<T> crowded(PerssonContact<T>(map_spectrum(order.map, edges), effective_modulus),
                                          order.curve, order.rms_height);
    return {SummitContact<T>(summits, effective_modulus), crowded, detail::hand_over_of(summits, crowded, edges)};
}

}}  // namespace fstiff
