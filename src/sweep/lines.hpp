// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Results of adjacent scenes: a row for each that `fstiff run --format csv` prints of a scene, and as a line of JSON.
//
//     {"index":17,"surface.rms_height":5e-07,"law":"hertz","theta":0.78...,"r":0,"pressure_Pa":1000000,...}
//     {"index":18,"surface.rms_height":6e-07,"error":"grid.toml: ..."}        a scene that cannot be computed

#include "sweep/scene_maker.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace fstiff::sweep {

/// One row of results, or why there is none.
struct Row {
    std::size_t scene = 0;        ///< its place in the block
    LawKind law = LawKind::none;  ///< none: the scene cannot be computed
    std::size_t header = 0;       ///< its place among those of the block
    std::size_t begin = 0;        ///< of theta, r and its columns among the numbers of the block
    bool answer = false;
    std::string error{};  ///< why the scene, or this point of it, has no results
};

/// Adjacent scenes of a grid.
struct Block {
    std::uint64_t first = 0, end = 0;                     ///< scenes from first up to end
    std::uint64_t failed = 0;                             ///< of them cannot be computed, or not at every point
    std::vector<std::vector<Value>> values{};             ///< of each scene, one for each axis
    std::vector<std::vector<scene::NumberOf>> headers{};  ///< columns
    std::vector<Row> rows{};                              ///< in the order of the scenes
    std::vector<double> numbers{};                        ///< of the rows, SI; NaN: none
    std::string lines{};                                  ///< the rows as text, where it is asked for
};

/// The scenes from \p first on, \p count of them. Scenes that differ in their point alone are computed together,
/// wherever they are among these.
[[nodiscard]] Block block_of(const Grid& grid, SceneMaker& maker, SceneMaker::Work& work, std::uint64_t first,
                             std::uint64_t count);

/// A line for each row of \p block.
[[nodiscard]] std::string lines_of(const Grid& grid, const Block& block);

}  // namespace fstiff::sweep
