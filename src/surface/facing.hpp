// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Two faces that look at each other, measured in one coordinate system.
//
//     h = z_lower - z_upper       sum of the heights of both faces, each outwards from its body
//     gap = -h                    but for a constant, by which the faces move until they touch

#include "surface/surface_file.hpp"

#include <string>

namespace fstiff::surface {

/// Makes \p lower the sum of both faces, on the points that both have.
/// \throws domain_error for profiles, for maps of unlike steps or places, and for an upper face below the lower one.
void add_facing(io::Surface& lower, const io::Surface& upper);

/// Reads the \p bytes of options.file, and the face that options.facing names, which is added, into \p input.
/// \throws domain_error, file_error.
void read_faces(const SurfaceOptions& options, std::string bytes, io::SurfaceOptions reading, SurfaceInput& input);

}  // namespace fstiff::surface
