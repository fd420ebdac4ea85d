// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Results of a scene: one curve for each law and joint distribution of peaks, with bands, checks and reflections.
//
//     const Scene scene = read_scene(text, {.name = "scene.toml"});
//     const Results results = compute(scene);
//     for (const Curve& curve : results.curves)
//         for (const Column& column : curve.columns) use(curve.law->name, column.key(), column.values);

#include "scene/column.hpp"
#include "scene/scene.hpp"

#include <fstiff/answer/ball.hpp>
#include <fstiff/core/parallel.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// A curve with what Scene asks for.
struct Curve : detail::LawCurve {
    std::vector<scene::Column> columns{};  ///< the same keys in every curve

    /// \p statistic of \p quantity at the point \p place of the scene; none where there is no such column or state.
    [[nodiscard]] std::optional<double> value_at(std::size_t place, scene::CurveQuantity quantity,
                                                 scene::Statistic statistic = scene::Statistic::value) const;
};

/// The names of the laws that gave the states of \p curve: "boundary_elements and hybrid".
[[nodiscard]] std::string laws_of(const Curve& curve);
/// "fractal, theta = 0.7854, r = 0.5".
[[nodiscard]] std::string title(const Curve& curve);

/// One K for each point, by the law that holds there.
struct StiffnessAnswer : detail::AnswerFacts {
    Curve curve;  ///< its band is that of the surface
};

/// The ball of the scene under one force, and that of smooth faces.
struct BallUnderForce : detail::BallOnFace {
    ContactOfBall<double> hertz{};
};

struct Results {
    double modulus = 0;           ///< effective [Pa]
    double tangential_ratio = 0;  ///< of the tangential stiffness to K
    std::optional<double> plasticity_index;
    std::vector<Check<double>> surface_checks;
    std::optional<StiffnessAnswer> answer;  ///< none: no law answers at any point
    std::vector<Curve> curves;             ///< of the laws that are named; where none is, the curve of the answer alone
    std::vector<BallUnderForce> balls{};   ///< one for each force, where the scene has a ball
    std::vector<std::string> warnings;     ///< sentences on the checks that do not hold, and on the scene
    std::vector<std::string> explanation;  ///< three sentences at most: the kind of K, its uses and its source
    std::vector<std::string> short_explanation;  ///< the same for a picture: one or two short sentences
    /// A real area above the nominal one, integrals that did not converge, points that a law does not reach, an rms
    /// gradient that no surface has, or a measured surface with detail::unknown_parameters().
    bool doubtful = false;
};

/// The curve of the answer, then those of the laws that are named.
[[nodiscard]] std::vector<const Curve*> shown_curves(const Results& results);

/// What was assumed of \p scene for \p results.
[[nodiscard]] std::vector<std::string> assumptions_of(const scene::Scene& scene, const Results& results);

/// Whether any curve has a band.
[[nodiscard]] bool has_band(const Results& results);

/// \p scene with enough points for a smooth curve through those it has, which it keeps, or \p between them alone.
[[nodiscard]] scene::Scene with_finer_points(scene::Scene scene, bool between = false);

/// Why \p missed, a point of \p scene, has no state.
[[nodiscard]] std::string reason_of(const scene::Scene& scene, const detail::MissedPoint& missed);

}  // namespace fstiff::actions
