// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A contact by its table (contact/contact_law), for very many points on one surface: [sweep] tabulate = true.

#include "scene/results.hpp"

#include <array>

namespace fstiff::sweep {

/// Puts the table of each of \p contacts over \p range of pressures [Pa], or of separations [m] where the scene has these,
/// in its place; a law that has no table stays. K and the separation of a table are within the error that it carries,
/// which the results tell as that of K.
void tabulate(std::vector<scene::MadeContact>& contacts, const scene::Scene& scene, std::array<double, 2> range);

}  // namespace fstiff::sweep
