// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A scene: what `fstiff run` computes, read from TOML. Every key, unit and default is in docs/scene.md.

#include "measured_surface.hpp"

#include <fstiff/asperity/material.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/peaks/peak_density.hpp>
#include <fstiff/surface/roughness.hpp>
#include <fstiff/ultrasound/spring_interface.hpp>

#include <algorithm>
#include <cstdint>
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

/// One peak density to compute; the values are checked when the PeakDensity is made.
struct Peaks {
    double theta = 0;         ///< [rad]
    std::optional<double> r;  ///< none: of an exponential autocorrelation
    bool of_surface = false;  ///< theta and r are those of [surface], with their errors
    std::string where;        ///< file, line and key for messages
};

/// \throws domain_error naming the place of the value that no peak density has.
PeakDensity<double> peak_density(const Peaks& peaks);

enum class InteractionLength { nominal, peak_spacing, given };

}  // namespace fstiff::cli

namespace fstiff {

template <>
inline constexpr auto names<cli::Law> = name_list<cli::Law>({
    {cli::Law::fractal, "fractal"},
    {cli::Law::fractal_consistent, "fractal_consistent"},
    {cli::Law::hertz, "hertz"},
    {cli::Law::greenwood_williamson, "greenwood_williamson"},
});
/// A given length is written as such.
template <>
inline constexpr auto names<cli::InteractionLength> = name_list<cli::InteractionLength>(
    {{cli::InteractionLength::nominal, "nominal"}, {cli::InteractionLength::peak_spacing, "peak_spacing"}});

}  // namespace fstiff

namespace fstiff::cli {
/// The waves that meet the contact: longitudinal ones see K, shear waves the tangential stiffness.
struct Waves {
    double frequency = 0;                     ///< [Hz]
    Impedances<double> longitudinal{};        ///< the wave comes from material.upper
    std::optional<Impedances<double>> shear;  ///< none: not known

    [[nodiscard]] double angular() const { return angular_frequency(frequency); }
};

struct Scene {
    std::string name;
    std::string file;    ///< as given, or "built-in scene"
    std::string sha256;  ///< of the text of the scene

    Roughness<double> surface;
    std::optional<double> fractal_dimension;
    std::optional<double> fractal_roughness;  ///< [m]

    std::optional<double> r, theta;           ///< of the surface [1, rad]; both or none
    UncertainSurface<double> uncertain;       ///< the same with errors
    std::optional<MeasuredSurface> measured;  ///< where surface.from says, or --surface
    int samples = 400;                        ///< of the band; 0: no band
    std::uint64_t seed = 2014;
    std::vector<std::string> warnings;

    /// Whether a band can be given: some parameter that enters has an error.
    [[nodiscard]] bool has_errors() const {
        return std::any_of(uncertain.error.begin(), uncertain.error.end(), [](double error) { return error > 0; });
    }

    Material<double> upper, lower;
    std::optional<double> yield_strength;  ///< the smaller of the two that are given [Pa]

    std::optional<double> nominal_area;  ///< [m^2]
    bool at_separations = false;         ///< points are separations [m], not pressures [Pa]
    std::vector<double> points;
    std::string points_where;  ///< file, line and key for messages
    std::vector<Law> laws;
    std::vector<Peaks> peaks;
    InteractionReading reading = InteractionReading::none;
    InteractionLength length = InteractionLength::nominal;
    double given_length = 0;  ///< [m], for InteractionLength::given

    std::optional<Waves> ultrasound;

    /// output.quantities
    bool stiffness = false, separation = false, real_area = false, contacts = false;
    bool tangential_stiffness = false, reflection = false, shear_reflection = false;

    /// Whether K is computed, though it may not be shown.
    [[nodiscard]] bool needs_stiffness() const {
        return stiffness || tangential_stiffness || reflection || shear_reflection;
    }

    std::vector<Input> inputs;  ///< every key that was written or filled in by a default
};

/// Reads \p text, which messages call \p file. When \p surface is not empty, it names the file that the surface is
/// measured from, instead of the section [surface]; then contact.peaks are those of that file.
/// \throws domain_error "<file>:<line>: <key> = <value>: must be ...".
Scene parse_scene(const std::string& text, const std::string& file, const std::string& surface = "");

}  // namespace fstiff::cli
