// SPDX-License-Identifier: BSD-3-Clause
#include "actions/answered.hpp"

#include "actions/explanation.hpp"
#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/answer_of.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace fstiff::actions {

using scene::Scene;

namespace {

/// \throws domain_error where no point of \p curves has a K, with the reason of the first law at its first point.
void require_points(const Scene& scene, std::span<const AnswerCurve> curves) {
    const auto is_empty = [](const AnswerCurve& curve) { return count_of(curve) == 0; };
    if (!std::all_of(curves.begin(), curves.end(), is_empty)) return;
    for (const AnswerCurve& curve : curves)
        if (!curve.points.empty())
            throw domain_error(scene.points_where + "law " + std::string(name_of(curve.law)) + ": " +
                               curve.points.front().reason);
}

void add_balls(Answered& answered) {
    const auto& [radius, forces] = *answered.scene->ball;
    answered.balls = answered.answer.balls(radius, forces);
    for (const Answer::Ball& ball : answered.balls) {
        const std::string under = "the ball under " + document::with_unit(ball.hertz.load, "N");
        if (!ball.reason.empty()) {
            answered.warnings.push_back(under + " has no contact: " + ball.reason);
            answered.doubtful = true;
        } else if (ball.yields) {
            answered.warnings.push_back(under +
                                        " yields below its face, but is computed as elastic: its pressure is above 1.6 "
                                        "times the yield strength");
        }
    }
}

}  // namespace

std::vector<const AnswerCurve*> Answered::shown_curves() const {
    std::vector<const AnswerCurve*> shown;
    if (!answer.laws.empty() && has_answer()) shown.push_back(&answer);
    for (const AnswerCurve& curve : curves()) shown.push_back(&curve);
    return shown;
}

bool Answered::has_answer() const { return count_of(answer) > 0; }

bool Answered::has_band() const {
    const auto all = curves();
    return std::any_of(all.begin(), all.end(), [](const AnswerCurve& curve) { return curve.has_band; });
}

std::size_t count_of(const AnswerCurve& curve) {
    return static_cast<std::size_t>(
        std::count_if(curve.points.begin(), curve.points.end(), [](const AnswerPoint& point) { return point.ok(); }));
}

std::string laws_of(const AnswerCurve& curve) {
    std::vector<LawKind> laws;
    for (const AnswerPoint& point : curve.points)
        if (point.ok() && std::find(laws.begin(), laws.end(), point.law) == laws.end()) laws.push_back(point.law);
    if (laws.empty()) laws.push_back(curve.law);
    std::string text;
    for (const LawKind law : laws) text += (text.empty() ? "" : " and ") + std::string(name_of(law));
    return text;
}

std::string title(const AnswerCurve& curve) {
    std::string text = laws_of(curve);
    if (curve.theta) text += ", theta = " + document::rounded(*curve.theta) + ", r = " + document::rounded(*curve.r);
    return text;
}

std::vector<AnswerCurve> curves_of(const Scene& scene, const std::vector<detail::MadeContact>& contacts) {
    AnswerOptions options = scene.options();
    options.laws_alone = true;
    Answer answer = answer_of(scene.joint, scene.points, options, &contacts);
    if (!answer.laws.empty()) {
        require_points(scene, answer.laws);
        return std::move(answer.laws);
    }
    std::vector<AnswerCurve> best;
    best.push_back(std::move(static_cast<AnswerCurve&>(answer)));
    require_points(scene, best);
    return best;
}

std::vector<Check<double>> surface_checks(const detail::ResolvedJoint& joint) {
    if (!joint.face.has_radius_and_density()) return {};
    return detail::check_surface(joint.face.roughness(), joint.effective_modulus, joint.yield_strength);
}

Answered compute(Scene given, const ProgressHook& progress, const ParallelHook& parallel) {
    AnswerOptions options = given.options();
    options.progress = progress, options.parallel = parallel;
    Answered answered{.scene = std::make_shared<const Scene>(std::move(given))};
    const Scene& scene = *answered.scene;
    answered.answer = answer_of(scene.joint, scene.points, options);
    answered.warnings = scene.warnings;
    for (const AnswerCurve& curve : answered.curves())
        if (!curve.no_approach.empty())
            answered.warnings.push_back("law " + std::string(name_of(curve.law)) +
                                        " has no approach: " + curve.no_approach);
    require_points(scene, answered.curves());
    if (answered.answer.failed > 0)
        answered.warnings.push_back(
            "up to " + std::to_string(answered.answer.failed) + " of " + std::to_string(scene.samples) +
            " sampled surfaces are outside the range of the model at some point: the band there is from the others");
    if (!answered.has_answer()) {
        const std::string& refusal = answered.answer.refusal;
        answered.warnings.push_back("the answer has no K: " +
                                    (refusal.empty()
                                         ? scene.points_where + "law " + std::string(name_of(answered.answer.law)) +
                                               ": " + answered.answer.points.front().reason
                                         : refusal));
        answered.doubtful = true;
    }
    add_warnings(answered);
    if (scene.ball) add_balls(answered);
    std::tie(answered.explanation, answered.short_explanation) = explanation_of(answered);
    return answered;
}

Scene with_finer_points(Scene scene, bool between) {
    const std::size_t enough = scene.joint.face.map ? 9 : 41;  // boundary elements are solved at each of a map
    std::vector<double> points = scene.points;
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (between) scene.points.clear();
    if (points.size() < 2 || points.size() >= enough) return scene;
    const std::size_t steps = (enough - 1 + points.size() - 2) / (points.size() - 1);
    scene.points.clear();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        for (std::size_t k = between ? 1 : 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(steps);
            const double low = points[i], high = points[i + 1];
            scene.points.push_back(k == 0                 ? low
                                   : scene.at_separations ? low + t * (high - low)
                                                          : low * std::pow(high / low, t));
        }
    if (!between) scene.points.push_back(points.back());
    scene.listed = true;
    if (!scene.forces.empty()) scene.forces = scene.points;
    for (double& force : scene.forces) force *= *scene.joint.nominal_area;
    return scene;
}

}  // namespace fstiff::actions
