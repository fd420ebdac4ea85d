// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The map that a contact of yielded peaks leaves: pressed again, it is elastic up to the pressure that it has carried.
///
///     h' = min(h, u[p] + d)         p, d of the solution with p <= H; above H the face overlaps what it is pressed to
///
/// Units       [m], [Pa]
/// Valid       as halfspace/boundary_elements; what yields moves no other material
/// Accuracy    of the solution that it is of: K and the area of h' at its pressure are those of unloading
///             (tests/halfspace/unloading_test.cpp)

#include <fstiff/halfspace/boundary_elements.hpp>

#include <type_traits>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// \p map after it has carried \p pressure at the hardness of \p options. \throws domain_error as
/// BoundaryElements::at_pressure.
template <Real T>
[[nodiscard]] HeightMap<T> flattened(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus,
                                     std::type_identity_t<T> pressure, BoundaryElementOptions<T> options) {
    options.loading = false;
    BoundaryElements<T> solver(map, effective_modulus, options);
    const T gap = solver.at_pressure(pressure).mean_gap;
    GridField<T> deflected = solver.pressures() / effective_modulus;
    SurfaceCompliance<T>(map.rows(), map.columns(), map.dx, map.dy, options.edges).deflect(deflected);
    HeightMap<T> flat = map;
    const T level = gap + map.heights.mean();
    flat.heights = (map.heights.min)(deflected + level);
    return flat;
}

}}}  // namespace fstiff::detail
