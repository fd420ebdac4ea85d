// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The lines of results: one JSON object for each row that `fstiff run --format csv` prints of a scene.
//
//     {"index":17,"surface.rms_height":5e-07,"law":"hertz","theta":0.78...,"r":0,"pressure_Pa":1000000,...}
//     {"index":18,"surface.rms_height":6e-07,"error":"grid.toml:12: ..."}        a scene that cannot be computed

#include "sweep/scene_maker.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fstiff::sweep {

/// Adjacent scenes of a grid, as lines.
struct Block {
    std::string text;
    std::uint64_t failed = 0;  ///< scenes that cannot be computed, or not at every point
};

/// The lines of the scenes from \p first on, \p count of them. Scenes that differ in their point alone are computed
/// together, wherever they are among these.
[[nodiscard]] Block lines_of(const Grid& grid, SceneMaker& maker, SceneMaker::Work& work, std::uint64_t first,
                             std::uint64_t count);

}  // namespace fstiff::sweep
