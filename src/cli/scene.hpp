// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A scene: what `fstiff run` computes, read from TOML. Every key, unit and default is in docs/scene.md.

#include <fstiff/asperity/material.hpp>
#include <fstiff/surface/roughness.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fstiff::cli {

/// One key of the scene as its author wrote it, and what it came to in SI units.
struct Input {
    std::string key;      ///< path, such as "surface.rms_height"
    std::string written;  ///< the text of the scene
    std::optional<double> value;
    std::string unit;  ///< SI unit of value; empty when it has none
};

enum class Law { fractal, fractal_consistent, hertz, greenwood_williamson };
std::string_view name_of(Law law);

/// One peak density to compute; the values are checked when the PeakDensity is made.
struct Peaks {
    double theta = 0;         ///< [rad]
    std::optional<double> r;  ///< none: of an exponential autocorrelation
    std::string where;        ///< file, line and key for messages
};

enum class Reading { none, effective_separation, as_printed };
enum class InteractionLength { nominal, peak_spacing, given };

struct Scene {
    std::string name;
    std::string file;    ///< as given, or "built-in scene"
    std::string sha256;  ///< of the text of the scene

    Roughness<double> surface;
    std::optional<double> fractal_dimension;
    std::optional<double> fractal_roughness;  ///< [m]

    Material<double> upper, lower;
    std::optional<double> yield_strength;  ///< the smaller of the two that are given [Pa]

    std::optional<double> nominal_area;  ///< [m^2]
    bool at_separations = false;         ///< points are separations [m], not pressures [Pa]
    std::vector<double> points;
    std::string points_where;  ///< file, line and key for messages
    std::vector<Law> laws;
    std::vector<Peaks> peaks;
    Reading reading = Reading::none;
    InteractionLength length = InteractionLength::nominal;
    double given_length = 0;  ///< [m], for InteractionLength::given

    bool stiffness = false, separation = false, real_area = false, contacts = false;  ///< output.quantities

    std::vector<Input> inputs;  ///< every key that was written or filled in by a default
};

/// Reads \p text, which messages call \p file. \throws domain_error "<file>:<line>: <key> = <value>: must be ...".
Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace fstiff::cli
