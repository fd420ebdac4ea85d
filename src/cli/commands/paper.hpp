// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The reference paper from its own parameters: surfaces, figures, conclusions and the numbers for them.

#include "document/rows.hpp"
#include "picture/plot.hpp"

#include <fstiff/asperity/material.hpp>
#include <fstiff/surface/roughness.hpp>
#include <fstiff/surface/structure_constant.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace fstiff::cli::paper {

inline constexpr double nominal_area = 195e-6;  // [m^2]
inline constexpr std::uint64_t seed = 2014;
inline constexpr const char* no_points =
    "Experimental points are not drawn: they are only in the paper's figures, not in its text or tables.";

/// A row of Tables 1 and 2; the scenes in data/ hold the same numbers.
struct Surface {
    const char *name, *figure;
    Roughness<double> roughness;
    Fractal<double> fractal;
};
inline const std::array<Surface, 3> surfaces{
    Surface{"sand blasted (fine)", "fig7", {0.832e-6, 40e-6, 500e6, 5.3e-6}, {1.62, 1.2e-8}},
    Surface{"sand blasted (coarse)", "fig8", {5.13e-6, 30e-6, 230e6, 15.3e-6}, {1.58, 1.1e-7}},
    Surface{"electrical discharge machining", "fig9", {8.94e-6, 19e-6, 160e6, 48e-6}, {1.70, 8.2e-7}}};
inline const Material<double> steel{205e9, 0.3};
inline constexpr double yield_strength = 400e6;  // [Pa]

struct Bounds {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// Quantities of the conclusions: the key for machines, its conclusion, and the words for people.
enum class Measure { over_elastic, over_greenwood_williamson, theta_at_pressure, theta_at_separation, shift };
struct Words {
    const char *key, *text;
    int conclusion;
};
inline constexpr std::array<Words, 5> measures{
    Words{"fractal_over_elastic", "K fractal over K statistical elastic, at equal pressure", 1},
    Words{"fractal_over_greenwood_williamson", "K fractal over K Greenwood-Williamson, at equal pressure", 1},
    Words{"theta_at_equal_pressure", "K(θ = π/3) over K(θ = π/4), at equal pressure", 2},
    Words{"theta_at_equal_separation", "K(θ = π/3) over K(θ = π/4), at equal separation, η from 0 to 3", 2},
    Words{"interaction_shift", "shift Δη of the separation (4.11), from 0.1 to 100 MPa", 3}};

/// One number for a conclusion.
struct Finding {
    Measure measure;
    std::string surface;
    Bounds range;
    const Words& words() const { return measures[static_cast<std::size_t>(measure)]; }
};

struct Conclusion {
    int number;
    std::string paper, result, because;
};

struct Picture {
    std::string name, caption;
    Figure figure;
};

struct Reproduction {
    std::vector<Finding> findings;
    std::vector<Conclusion> conclusions;
    Rows generated;  ///< what came out of the generated surfaces
    std::vector<Picture> pictures;
};

/// The figures, which are computed in some seconds, and what follows from them.
[[nodiscard]] Reproduction reproduce();

}  // namespace fstiff::cli::paper
