// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Bearing faces of bolts: the ring that a head or a washer presses on, beyond the clearance hole.

#include <fstiff/core/error.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace fstiff::scene {

// One size. Diameters in mm: medium clearance holes of ISO 273; least bearing faces d_w of hexagon heads, ISO 4014 (to
// M24 grade A, read in a maker's table of the standard; B above), and of socket heads, ISO 4762; plain washers, ISO
// 7089 (these three quoted).
struct BoltSize {
    std::string_view name;
    double hole, head, socket, washer;
};
inline constexpr std::array<BoltSize, 12> bolt_sizes{{{"M3", 3.4, 4.57, 5.07, 7},
                                                      {"M4", 4.5, 5.88, 6.53, 9},
                                                      {"M5", 5.5, 6.88, 8.03, 10},
                                                      {"M6", 6.6, 8.88, 9.38, 12},
                                                      {"M8", 9, 11.63, 12.33, 16},
                                                      {"M10", 11, 14.63, 15.33, 20},
                                                      {"M12", 13.5, 16.63, 17.23, 24},
                                                      {"M16", 17.5, 22.49, 23.17, 30},
                                                      {"M20", 22, 28.19, 28.87, 37},
                                                      {"M24", 26, 33.61, 34.81, 44},
                                                      {"M30", 33, 42.75, 43.61, 56},
                                                      {"M36", 39, 51.11, 52.54, 66}}};

}  // namespace fstiff::scene
