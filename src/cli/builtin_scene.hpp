// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The scene of `fstiff run` without a file: the text of data/sand_blasted_fine.toml (a test holds the two equal).

namespace fstiff::cli {

inline constexpr const char* builtin_scene =
    R"toml(# Fine sand-blasted steel on a smooth steel face: Tables 1 and 2 of Buczkowski, Kleiber and Starzynski,
# "Normal contact stiffness of fractal rough surfaces", Arch. Mech. 66 (2014).
name = "sand blasted (fine)"

[surface]
rms_height        = "0.832 um"
peak_radius       = "40 um"
peak_density      = "500 /mm^2"
max_peak_height   = "5.3 um"
fractal_dimension = 1.62
fractal_roughness = "1.2e-8 m"

[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio  = 0.3
yield_strength = "400 MPa"

[material.lower]
youngs_modulus = "205 GPa"
poisson_ratio  = 0.3
yield_strength = "400 MPa"

[contact]
nominal_area = "195 mm^2"
pressures    = { from = "0.1 MPa", to = "100 MPa", count = 31, spacing = "log" }
laws         = ["fractal", "hertz", "greenwood_williamson"]
peaks        = [ { theta = "pi/4", r = "exponential" }, { theta = "pi/3", r = "exponential" } ]
interaction  = "none"

[output]
quantities = ["stiffness", "separation", "real_area", "contacts"]
)toml";

}  // namespace fstiff::cli
