// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint: what is pressed together, as plain values in SI.
///
///     const fstiff::Joint joint{.face = {.rms_height = 0.8e-6, .rms_gradient = 0.1},
///                               .upper = {.elastic = {210e9, 0.3}, .hardness = 2e9},
///                               .lower = {.elastic = {110e9, 0.26}},
///                               .nominal_area = 145e-6};
///
/// Reference   surface/process_prior.hpp: what is assumed where a number is not given
/// Units       SI
/// Valid       each member as it states; fstiff::answer() refuses others, and names the member
/// Accuracy    that of the numbers

#include <fstiff/asperity/material.hpp>
#include <fstiff/measured/measure.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <memory>
#include <optional>

namespace fstiff::inline v0_1 {

/// A rough face: a measured surface, or numbers. A number that is given takes the place of what was measured; one that
/// is neither given nor measured has the prior of `process`, whose width is in the band.
struct JointFace {
    std::shared_ptr<const Surface<double>> measured{};  ///< of measure(), of a profile or a map
    std::optional<double> rms_height{};                 ///< Rq, Sq [m], above 0
    std::optional<double> mean_height{};                ///< Ra, Sa [m], above 0, in place of rms_height
    std::optional<double> rms_gradient{};               ///< Sdq [1], above 0
    std::optional<double> alpha{};                      ///< Nayak's m0 m4/m2^2, above 1.5
    std::optional<double> hurst{};                      ///< above 0, at most 1
    std::optional<double> skewness{}, kurtosis{};       ///< of the heights: both or none, from -3 to 3 and up to 100
    std::optional<double> peak_radius{};                ///< R [m], above 0
    std::optional<double> peak_density{};               ///< D_p [1/m^2], above 0
    std::optional<double> fractal_dimension{};          ///< D of a profile, above 1 and at most 1.99
    parts::Process process = parts::Process::unknown;
    double rms_height_error = 0, rms_gradient_error = 0;  ///< standard errors of the numbers that are given
};

/// A body.
struct Body {
    Material<double> elastic{};              ///< E [Pa] and nu
    std::optional<double> yield_strength{};  ///< [Pa], above 0
    std::optional<double> hardness{};        ///< of an indentation [Pa], above 0; none: 2.8 times the yield strength
};

/// Two bodies, and the rough faces between them.
struct Joint {
    JointFace face{};                  ///< of one body; the other is smooth, unless
    std::optional<JointFace> other{};  ///< it is rough too
    Body upper{}, lower{};
    std::optional<double> nominal_area{};  ///< [m^2], above 0
    int shifts = 4;                        ///< of the map of the other face over that of the first, where both are maps
};

}  // namespace fstiff::inline v0_1
