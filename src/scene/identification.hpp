// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Parameters of a scene from a measured K(p) or R(p): one fit a law and joint distribution of peaks.

#include "scene/measured_curve.hpp"
#include "scene/scene.hpp"

#include <fstiff/fit/fit_concerns.hpp>
#include <fstiff/fit/identify.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

/// Parameters to fit, and the data.
struct FitRequest {
    std::vector<Parameter> wanted;
    std::string law{};          ///< alone; empty: the laws that somebody chose, or else the one whose K is the answer
    bool shear = false;         ///< measured reflections are of shear waves
    std::string_view prefix{};  ///< of the names of options in messages: "--" on a command line
};

struct Fit {
    const Law* law = nullptr;
    std::optional<double> theta, r;  ///< of the scene; none: a law without a joint distribution of peaks
    ContactParameters<double> start{};
    std::vector<MeasuredPoint> points;  ///< that were fitted
    Identification<double> found{};
};

/// "hertz, theta = 0.7854, r = 0.5", or the law alone.
[[nodiscard]] std::string title(const Fit& fit);

struct Fits {
    std::vector<Fit> fits;
    std::optional<Wave<double>> wave;   ///< of measured reflections
    std::vector<std::string> warnings;  ///< sentences on the scene and on every fit
    bool doubtful = false;              ///< a fit failed, all are doubtful, or a parameter that is held is not known
};

/// \throws option_error for a request that the curve has no use for, domain_error naming what the scene or the curve
/// lacks.
[[nodiscard]] Fits identify(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request);

/// The contact that \p fit found, under \p pressures [Pa], with its stiffness alone.
[[nodiscard]] std::vector<ContactPoint<double>> fitted_points(const Problem& problem, const Fit& fit,
                                                              std::span<const double> pressures);

}  // namespace fstiff::scene
