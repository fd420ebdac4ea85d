// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Measured maps as the laws take them.

#include <fstiff/answer/laws.hpp>
#include <fstiff/topography/height_map.hpp>
#include <memory>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Inputs of laws from \p maps, at least one, of one surface.
[[nodiscard]] std::shared_ptr<const MapOfSurface> map_of_surface(
    std::vector<std::shared_ptr<const HeightMap<double>>> maps);

}}}  // namespace fstiff::detail
