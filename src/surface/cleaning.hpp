// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What is done to a surface before its form is removed: a part of it, points out of use, spikes, holes.

#include <fstiff/io/surface_file.hpp>

namespace fstiff::scene {

struct SurfaceOptions;

/// Crops, masks, takes spikes out and fills, in this order, as the options say; each is told in the details of the record.
/// \throws domain_error, file_error for the mask.
void clean(const SurfaceOptions& options, io::Surface& surface);

/// What could have been asked of clean() and was not: of spikes and of \p missing points, with the option's name.
[[nodiscard]] std::vector<std::string> cleaning_hints(const SurfaceOptions& options, const io::Surface& surface);

}  // namespace fstiff::scene
