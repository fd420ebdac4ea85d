// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fstiff identify: parameters of a scene from a measured K(p) or R(p), one fit a law and joint distribution of peaks.

#include "actions/measured_curve.hpp"
#include "document/document.hpp"
#include "scene/scene.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/identify/barton_bandis.hpp>
#include <fstiff/identify/concerns.hpp>
#include <fstiff/identify/identify.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

/// The laws that can be fitted.
[[nodiscard]] std::vector<std::string_view> fitted_law_names();

/// How parameters are called in requests and documents.
inline constexpr auto parameter_short_names = [] {
    std::array<std::string_view, detail::parameter_table.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = detail::parameter_table[i].short_name;
    return names;
}();

struct IdentifyRequest {
    std::string measured{};          ///< file of the curve
    std::vector<std::string> fit{};  ///< parameters, by their short names or their keys in a scene
    std::string law{};               ///< alone; empty: the laws that somebody chose, or the one whose K is the answer
    WaveKind wave = WaveKind::longitudinal;
    bool barton_bandis = false;  ///< its hyperbola is fitted too
    std::string_view prefix{};   ///< of the names of options in messages: "--" on a command line

    template <class Take>
    void each_field(Take take) {
        std::string names;
        for (const std::string_view name : parameter_short_names)
            names += (names.empty() ? "" : ", ") + std::string(name);
        take("measured", measured,
             {.help = "file (CSV) of pressure and stiffness or reflection, with their errors if they are known",
              .required = true,
              .type = "FILE"});
        take("fit", fit,
             {.help = "parameters to fit, among " + names +
                      " (g: rms gradient, offset: of the pressure); the others keep their values",
              .required = true,
              .type = "NAME,..."});
        take("law", law,
             {.help = "law to fit; the default is contact.laws or, without it, plastic or hybrid",
              .words = fitted_law_names()});
        take("wave", wave,
             {"kind of wave whose reflection coefficients were measured: longitudinal (default) or shear"});
        take("barton_bandis", barton_bandis,
             {"fit K_n0 and V_m of rock joints too, by Barton and Bandis: K = K_n0 (1 - p/(V_m K_n0 + p))^-2"});
    }
};

/// Parameters to fit, and the data.
struct FitRequest {
    std::vector<Parameter> wanted;
    std::string law{};          ///< alone; empty: the laws that somebody chose, or else the one whose K is the answer
    bool shear = false;         ///< measured reflections are of shear waves
    std::string_view prefix{};  ///< of the names of options in messages
};

struct Fit {
    const detail::Law* law = nullptr;
    std::optional<double> theta, r;  ///< of the scene; none: a law without a joint distribution of peaks
    ContactParameters<double> start{};
    std::vector<MeasuredPoint> points;  ///< that were fitted
    Identification<double> found{};
};

/// "hertz, theta = 0.7854, r = 0.5", or the law alone.
[[nodiscard]] std::string title(const Fit& fit);
/// What \p finding means for \p fit.
[[nodiscard]] std::string sentence(const Fit& fit, const detail::FitFinding<double>& finding);

struct Fits {
    std::vector<Fit> fits;
    std::optional<ObservedWave<double>> wave;  ///< of measured reflections
    std::vector<std::string> warnings;         ///< sentences on the scene and on every fit
    bool doubtful = false;  ///< a fit failed, all are doubtful, or a parameter that is held is not known
};

/// \throws option_error for a request that the curve has no use for, domain_error naming what the scene or the curve
/// lacks.
[[nodiscard]] Fits identify(const scene::Scene& scene, const MeasuredCurve& curve, const FitRequest& request);

/// The contact that \p fit found, under \p pressures [Pa], with its stiffness alone.
[[nodiscard]] std::vector<ContactPoint<double>> fitted_points(const detail::ResolvedJoint& problem, const Fit& fit,
                                                              std::span<const double> pressures);

struct Identified {
    MeasuredCurve curve;
    std::vector<Parameter> wanted;
    Fits found;
    std::optional<detail::BartonBandis<double>> hyperbola{};
};

/// The parameters that \p request fits. \throws option_error for a name that is none, or is listed twice.
[[nodiscard]] std::vector<Parameter> parameters_of(const IdentifyRequest& request);
/// Fits \p curve, or the one in the file of \p request, which is read. \throws as parameters_of(),
/// read_measured_curve() and identify().
[[nodiscard]] Identified identify_scene(const scene::Scene& scene, const IdentifyRequest& request,
                                        std::optional<MeasuredCurve> curve = {});
/// The hyperbola of Barton and Bandis for the points of \p curve. \throws option_error for reflections and for several
/// computed curves, domain_error for points that no stiffness has.
[[nodiscard]] detail::BartonBandis<double> hyperbola_of(const MeasuredCurve& curve, const IdentifyRequest& request);
/// Adds \p fit to \p document.
void add_hyperbola(document::Document& document, const detail::BartonBandis<double>& fit);
/// The document of fstiff identify.
[[nodiscard]] document::Document document_of(const scene::Scene& scene, const Identified& identified);

}  // namespace fstiff::actions
