// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The three surfaces of the paper, Tables 1 and 2, and their counterface: Buczkowski, Kleiber, Starzynski,
// Arch. Mech. 66 (2014). The scenes of data/ and examples/paper/reproduce.py hold the same numbers once more.
#include <fstiff/surface/moments.hpp>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace test {

struct PaperSurface {
    const char* key;   ///< in tests/data/table1_curves.csv
    const char* name;  ///< in the figures
    double rms_height, peak_radius, peak_density, max_peak_height;
    double fractal_dimension, fractal_roughness;

    template <fstiff::Real T = double>
    [[nodiscard]] constexpr fstiff::Roughness<T> roughness() const {
        return {static_cast<T>(rms_height), static_cast<T>(peak_radius), static_cast<T>(peak_density),
                static_cast<T>(max_peak_height)};
    }
};

inline constexpr std::array<PaperSurface, 3> paper_surfaces{
    {{"sand_blasted_fine", "sand blasted (fine)", 0.832e-6, 40e-6, 500e6, 5.3e-6, 1.62, 1.2e-8},
     {"sand_blasted_coarse", "sand blasted (coarse)", 5.13e-6, 30e-6, 230e6, 15.3e-6, 1.58, 1.1e-7},
     {"electrical_discharge", "electrical discharge machining", 8.94e-6, 19e-6, 160e6, 48e-6, 1.70, 8.2e-7}}};
inline constexpr const PaperSurface& sand_blasted_fine = paper_surfaces[0];

inline const PaperSurface& paper_surface(std::string_view key) {
    for (const PaperSurface& surface : paper_surfaces)
        if (surface.key == key) return surface;
    throw std::runtime_error("the paper has no surface " + std::string(key));
}

/// Effective modulus of steel on steel, 205 GPa and 0.3 both, eq. (3.15), written out again.
inline constexpr double paper_modulus = 205e9 / (2 * (1 - 0.3 * 0.3));

}  // namespace test
