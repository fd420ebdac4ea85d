// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The answer of a scene, with the sentences on what does not hold of it.
//
//     const Scene scene = read_scene(text, {.name = "scene.toml"});
//     const Answered answered = compute(scene);
//     for (const AnswerPoint& point : answered.answer.points) use(point.pressure, point.stiffness.value);

#include "scene/scene.hpp"

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/ball.hpp>
#include <fstiff/answer/curves.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fstiff::actions {

/// A scene, and what was computed of it.
struct Answered {
    std::shared_ptr<const scene::Scene> scene{};
    Answer answer{};
    std::vector<Answer::Ball> balls{};             ///< one for each force, where the scene has a ball
    std::vector<std::string> warnings{};           ///< sentences on the checks that do not hold, and on the scene
    std::vector<std::string> explanation{};        ///< three sentences at most: the kind of K, its uses and its source
    std::vector<std::string> short_explanation{};  ///< the same for a picture: one or two short sentences
    /// A real area above the nominal one, integrals that did not converge, points that a law does not reach, an rms
    /// gradient that no surface has, or a measured surface with detail::unknown_parameters().
    bool doubtful = false;

    /// The curves that the scene names, or that of the answer; and that of the answer, where it has one, before those.
    [[nodiscard]] std::span<const AnswerCurve> curves() const {
        const AnswerCurve* best = &answer;
        return answer.laws.empty() ? std::span(best, 1) : std::span(answer.laws);
    }
    [[nodiscard]] std::vector<const AnswerCurve*> shown_curves() const;
    /// Whether an answer has a K at some point.
    [[nodiscard]] bool has_answer() const;
    /// Whether \p curve is the answer's.
    [[nodiscard]] bool is_answer(const AnswerCurve& curve) const { return &curve == &answer; }
    /// Whether any of curves() has a band.
    [[nodiscard]] bool has_band() const;
};

/// Everything the scene asks for. A point that a law does not reach leaves the others alone, with a warning.
/// \p progress is called while a band is sampled; \p parallel runs what takes long.
/// \throws domain_error where the model cannot give it, or no law reaches any point, naming the place in the scene.
[[nodiscard]] Answered compute(scene::Scene scene, const ProgressHook& progress = {},
                               const ParallelHook& parallel = {});
/// The curves of compute() with their points, but without checks and warnings. \p contacts are those of the scene, or
/// of one with other points. \throws domain_error as compute().
[[nodiscard]] std::vector<AnswerCurve> curves_of(const scene::Scene& scene,
                                                 const std::vector<detail::MadeContact>& contacts);
/// The checks of \p joint that need no state.
[[nodiscard]] std::vector<Check<double>> surface_checks(const detail::ResolvedJoint& joint);
/// \p scene with enough points for a smooth curve through those it has, which it keeps, or \p between them alone.
[[nodiscard]] scene::Scene with_finer_points(scene::Scene scene, bool between = false);

/// The names of the laws that gave the points of \p curve: "boundary_elements and hybrid".
[[nodiscard]] std::string laws_of(const AnswerCurve& curve);
/// "fractal, theta = 0.7854, r = 0.5".
[[nodiscard]] std::string title(const AnswerCurve& curve);
/// The number of points of \p curve that have a K.
[[nodiscard]] std::size_t count_of(const AnswerCurve& curve);

}  // namespace fstiff::actions
