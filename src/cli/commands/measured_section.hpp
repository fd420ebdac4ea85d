// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The part of a report that shows a measured surface: parameters, heights, bearing curve, structure function and peaks.

#include "picture/page.hpp"
#include "surface/measured_surface.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace fstiff::cli {

/// A figure as wide as a phone can show, with its legend below.
void show(Page& page, std::vector<Panel> panels, std::string_view caption = "",
          std::vector<std::string> explanation = {});
void measured_section(Page& page, const MeasuredSurface& surface);

}  // namespace fstiff::cli
