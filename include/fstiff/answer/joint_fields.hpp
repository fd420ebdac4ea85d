// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The numbers of a joint and of its load as fields: each with its name, unit, range and meaning, in one list. The
/// checks of the library, the keys of a scene, the keywords of Python, the names of C, the axes of a sweep and the
/// tables of docs/scene.md are loops over them.
///
///     each_field(face, [](std::string_view name, auto& value, const NumberFacts& facts) { ... });
///
/// Reference   answer/joint.hpp, whose members they are
/// Units       SI

#include <fstiff/answer/joint.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/parameter.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {
/// The greatest D of a face: K of the fractal laws, which goes as 1/(2 - D), is 67 times that of hertz there.
inline constexpr double greatest_dimension = 1.99;
}  // namespace detail

/// What is known of a number next to its name and its value.
struct NumberFacts {
    std::string_view unit{};  ///< SI; empty: a plain number
    std::string_view help{};  ///< what it is
    double low = 0, high = (std::numeric_limits<double>::max)();
    bool low_too = false;                       ///< low itself is allowed
    const detail::ParameterRow* row = nullptr;  ///< of a parameter of a surface, whose range it has
    std::span<const std::string_view> words{};  ///< other names, as drawings and instruments write
    /// Where its standard error is; null: it has none. Numbers of one error are one number in several ways.
    std::optional<double> JointFace::Errors::*error = nullptr;

    /// Whether it is another name.
    [[nodiscard]] bool has_word(std::string_view name) const {
        return std::find(words.begin(), words.end(), name) != words.end();
    }
    [[nodiscard]] bool holds(double value) const {
        if (row && !detail::parameter_in_range(row->parameter, value)) return false;
        return (low_too ? value >= low : value > low) && value <= high;
    }
    /// "finite and greater than 0": to follow "must be".
    [[nodiscard]] std::string allowed() const {
        constexpr double most = (std::numeric_limits<double>::max)();
        if (row && high == most) return row->range();
        const std::string from = detail::rounded_text(low, 6), to = detail::rounded_text(high, 6);
        if (high < most) return low_too ? "from " + from + " to " + to : "greater than " + from + " and at most " + to;
        if (low_too && low == 0) return "finite and not negative";
        return low_too ? "finite and at least " + from : "finite and greater than " + from;
    }
    /// \throws domain_error naming \p name for a value that is not allowed.
    void require(std::string_view name, double value) const {
        if (!holds(value)) detail::refuse(name, value, allowed());
    }
    void require(std::string_view name, const std::optional<double>& value) const {
        if (value) require(name, *value);
    }
};

namespace detail::fields {
using Words = const std::string_view[];
inline constexpr Words heights{"Rq", "Sq"}, mean_heights{"Ra", "Sa"}, areal_gradients{"Sdq"}, profile_gradients{"Rdq"},
    spacings{"RSm"}, skewnesses{"Ssk", "Rsk"}, kurtoses{"Sku", "Rku"}, pressures{"pressure"};
/// \p T, as it is or const.
template <class Given, class T>
concept Of = std::is_same_v<std::remove_const_t<Given>, T>;
}  // namespace detail::fields

/// Hands over the numbers of \p face, a JointFace: all are std::optional<double>.
template <detail::fields::Of<JointFace> Face, class Take>
void each_field(Face& face, const Take& take) {
    using Errors = JointFace::Errors;
    const auto parameter = [](Parameter which, std::string_view help, std::optional<double> Errors::*error) {
        const detail::ParameterRow& row = detail::row_of(which);
        return NumberFacts{.unit = row.unit, .help = help, .low_too = row.low_included, .row = &row, .error = error};
    };
    take("rms_height", face.rms_height,
         NumberFacts{.unit = "m", .help = "rms height", .words = detail::fields::heights, .error = &Errors::height});
    take("mean_height", face.mean_height,
         NumberFacts{.unit = "m",
                     .help = "mean height; the process gives its ratio to the rms height",
                     .words = detail::fields::mean_heights,
                     .error = &Errors::height});
    take("rms_gradient", face.rms_gradient,
         NumberFacts{
             .help = "rms gradient of the face", .words = detail::fields::areal_gradients, .error = &Errors::gradient});
    take("profile_gradient", face.profile_gradient,
         NumberFacts{.help = "rms gradient of a profile across the lay",
                     .words = detail::fields::profile_gradients,
                     .error = &Errors::gradient});
    take("profile_spacing", face.profile_spacing,
         NumberFacts{.unit = "m",
                     .help = "mean spacing of a profile",
                     .words = detail::fields::spacings,
                     .error = &Errors::gradient});
    take("alpha", face.alpha, NumberFacts{.help = "Nayak's m0 m4/m2^2", .low = 1.5});
    take("hurst", face.hurst, NumberFacts{.help = "Hurst exponent", .high = 1});
    take("peak_radius", face.peak_radius,
         parameter(Parameter::peak_radius, "mean radius R of the peaks", &Errors::peak_radius));
    take("peak_density", face.peak_density,
         parameter(Parameter::peak_density, "peaks per area, D_p", &Errors::peak_density));
    NumberFacts dimension =
        parameter(Parameter::fractal_dimension, "fractal dimension D of a profile", &Errors::fractal_dimension);
    dimension.low = 1, dimension.high = detail::greatest_dimension;
    take("fractal_dimension", face.fractal_dimension, dimension);
    take("r", face.r, parameter(Parameter::r, "correlation of heights and curvatures of the peaks", &Errors::r));
    take("theta", face.theta, parameter(Parameter::theta, "sampling angle of the peaks", &Errors::theta));
    take("max_peak_height", face.max_peak_height, NumberFacts{.unit = "m", .help = "height of the highest peak, R_p"});
    take("fractal_roughness", face.fractal_roughness, NumberFacts{.unit = "m", .help = "fractal roughness G"});
    take("skewness", face.skewness,
         NumberFacts{.help = "skewness of the heights",
                     .low = -detail::most_skewness<double>,
                     .high = detail::most_skewness<double>,
                     .low_too = true,
                     .words = detail::fields::skewnesses});
    take("kurtosis", face.kurtosis,
         NumberFacts{.help = "kurtosis of the heights, 3 of Gaussian ones",
                     .low = 1,
                     .high = detail::most_kurtosis<double>,
                     .low_too = true,
                     .words = detail::fields::kurtoses});
}

namespace detail {

/// Hands over what is true or false of \p face, a JointFace.
template <fields::Of<JointFace> Face, class Take>
void each_flag(Face& face, const Take& take) {
    take("worn", face.worn, "it has run against another face: its tops are worn");
    take("whole", face.whole, "the measured map is the whole face, not a piece of it");
}

}  // namespace detail

/// Hands over the numbers of \p body, a Body.
template <detail::fields::Of<Body> B, class Take>
void each_field(B& body, const Take& take) {
    take("youngs_modulus", body.elastic.youngs_modulus, NumberFacts{.unit = "Pa", .help = "Young's modulus E"});
    take("poisson_ratio", body.elastic.poisson_ratio, NumberFacts{.help = "Poisson's ratio", .low = -1, .high = 0.5});
    take("yield_strength", body.yield_strength, NumberFacts{.unit = "Pa", .help = "yield strength"});
    take("hardness", body.hardness,
         NumberFacts{
             .unit = "Pa", .help = "mean pressure of an indentation", .high = std::numeric_limits<double>::infinity()});
    take("density", body.density, NumberFacts{.unit = "kg/m^3", .help = "density"});
    take("velocity", body.velocity, NumberFacts{.unit = "m/s", .help = "velocity of longitudinal waves"});
    take("shear_velocity", body.shear_velocity, NumberFacts{.unit = "m/s", .help = "velocity of shear waves"});
    take("thermal_conductivity", body.thermal_conductivity,
         NumberFacts{.unit = "W/(m K)", .help = "thermal conductivity"});
    take("electrical_conductivity", body.electrical_conductivity,
         NumberFacts{.unit = "S/m", .help = "electrical conductivity, 0 of an insulator", .low_too = true});
}

/// Hands over the numbers of \p waves, UltrasonicWaves, but the impedances, which are fields of their own.
template <detail::fields::Of<UltrasonicWaves> Waves, class Take>
void each_field(Waves& waves, const Take& take) {
    take("frequency", waves.frequency, NumberFacts{.unit = "Hz", .help = "frequency of the waves"});
    take("film_stiffness", waves.film_stiffness,
         NumberFacts{.unit = "Pa/m", .help = "stiffness of a fluid film, in addition to K", .low_too = true});
}

/// Hands over the numbers of \p impedances, Impedances: 0 where both are of the bodies.
template <detail::fields::Of<Impedances<double>> Media, class Take>
void each_field(Media& impedances, const Take& take) {
    constexpr std::string_view unit = "kg/(m^2 s)";
    take("incident", impedances.incident,
         NumberFacts{.unit = unit, .help = "impedance of the upper body", .low_too = true});
    take("beyond", impedances.beyond,
         NumberFacts{.unit = unit, .help = "impedance of the lower body", .low_too = true});
}

/// Hands over the numbers of \p filling, GapFilling.
template <detail::fields::Of<GapFilling<double>> Filling, class Take>
void each_field(Filling& filling, const Take& take) {
    take("conductivity", filling.conductivity,
         NumberFacts{.unit = "W/(m K)", .help = "thermal conductivity of the filling", .low_too = true});
    take("temperature_jump", filling.temperature_jump,
         NumberFacts{
             .unit = "m", .help = "length of the temperature jump at both faces, 0 of a liquid", .low_too = true});
}

/// Hands over the number of \p interaction, Interaction.
template <detail::fields::Of<Interaction<double>> I, class Take>
void each_field(I& interaction, const Take& take) {
    take("length", interaction.length,
         NumberFacts{.unit = "m", .help = "length over which peaks interact", .low_too = true});
}

/// Hands over the numbers of \p conduction, Conduction, but those of the gap, a GapFilling.
template <detail::fields::Of<Conduction> C, class Take>
void each_field(C& conduction, const Take& take) {
    take("thermal", conduction.thermal, NumberFacts{.unit = "W/(m K)", .help = "thermal conductivity of both bodies"});
    take("electrical", conduction.electrical,
         NumberFacts{.unit = "S/m", .help = "electrical conductivity of both bodies"});
    take("radiation", conduction.radiation,
         NumberFacts{.unit = "W/(m^2 K)", .help = "radiative conductance", .low_too = true});
    take("thermal_film", conduction.thermal_film,
         NumberFacts{.unit = "m^2 K/W", .help = "thermal resistance of a film on the contacts", .low_too = true});
    take("electrical_film", conduction.electrical_film,
         NumberFacts{.unit = "ohm m^2", .help = "electrical resistance of a film on the contacts", .low_too = true});
}

/// Hands over the numbers of \p friction, Friction.
template <detail::fields::Of<Friction> F, class Take>
void each_field(F& friction, const Take& take) {
    take("coefficient", friction.coefficient, NumberFacts{.help = "coefficient of friction", .high = 10});
    take("amplitude", friction.amplitude,
         NumberFacts{.unit = "m", .help = "amplitude of the tangential displacement, mean to peak"});
}

/// Hands over the numbers of \p joint itself, a Joint.
template <detail::fields::Of<Joint> J, class Take>
void each_field(J& joint, const Take& take) {
    take("nominal_area", joint.nominal_area, NumberFacts{.unit = "m^2", .help = "nominal area"});
    take("aspect_ratio", joint.aspect_ratio,
         NumberFacts{.help = "long side over short side of the nominal area, a rectangle",
                     .low = 1,
                     .high = 1000,
                     .low_too = true});
    take("flatness", joint.flatness,
         NumberFacts{
             .unit = "m", .help = "height of the gap between both faces in touch, before load", .low_too = true});
    take("greatest_pressure", joint.greatest_pressure,
         NumberFacts{.unit = "Pa", .help = "greatest nominal pressure of any earlier load"});
    take("effective_modulus", joint.effective_modulus,
         NumberFacts{.unit = "Pa", .help = "effective modulus, in place of the elastic constants"});
}

namespace detail {

/// What a joint is asked for: its points, of one kind, and the ball on the face, which has forces.
struct Load {
    std::vector<double> pressures{}, separations{}, forces{};  ///< the points [Pa], [m], [N]
    double seating = 1e3;                                      ///< [Pa]
    std::optional<double> ball_radius{};                       ///< [m]; none: flat faces
};

/// Hands over the points of \p load, a Load, of each kind: what is known of one holds for all of a list.
template <fields::Of<Load> L, class Take>
void each_points(L& load, const Take& take) {
    constexpr double most = (std::numeric_limits<double>::max)();
    take("pressures", load.pressures,
         NumberFacts{.unit = "Pa", .help = "nominal pressures", .words = fields::pressures});
    take("separations", load.separations,
         NumberFacts{.unit = "m", .help = "separations of the mean planes", .low = -most, .low_too = true});
    take("force", load.forces, NumberFacts{.unit = "N", .help = "forces on the nominal area, or on the ball"});
}

}  // namespace detail

/// Hands over the numbers of \p load, a detail::Load, but its points.
template <detail::fields::Of<detail::Load> L, class Take>
void each_field(L& load, const Take& take) {
    take("seating", load.seating, NumberFacts{.unit = "Pa", .help = "pressure at which the approach is 0"});
    take("ball_radius", load.ball_radius,
         NumberFacts{.unit = "m", .help = "radius of a ball on the face, of two balls 1/(1/R1 + 1/R2)"});
}

}}  // namespace fstiff
