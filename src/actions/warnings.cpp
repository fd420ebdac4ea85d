// SPDX-License-Identifier: BSD-3-Clause
#include "actions/explanation.hpp"
#include "actions/run.hpp"
#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/law_errors.hpp>

#include <algorithm>
#include <string_view>

namespace fstiff::actions {
namespace {

const AnswerPoint& first_missed(const AnswerCurve& curve) {
    return *std::find_if(curve.points.begin(), curve.points.end(),
                         [](const AnswerPoint& point) { return !point.ok(); });
}

/// A warning for each law that is named and lacks points. One that ends above some pressure is expected to.
void warn_of_missed(Answered& answered) {
    const auto& scene = *answered.scene;
    for (const detail::Law* law : scene.laws) {
        std::size_t count = 0, points = 0;
        const AnswerCurve* first = nullptr;
        for (const AnswerCurve& curve : answered.answer.laws) {
            if (curve.law != law->which) continue;
            points += curve.points.size();
            const std::size_t missed = curve.points.size() - count_of(curve);
            if (count == 0 && missed > 0) first = &curve;
            count += missed;
        }
        if (count == 0) continue;
        const AnswerPoint& missed = first_missed(*first);
        const std::string name = "law " + std::string(law->name),
                          place =
                              document::shortest(scene.points[missed.place]) + (scene.at_separations ? " m" : " Pa");
        const bool ends = law->ends && count_of(*first) > 0;
        answered.doubtful = answered.doubtful || !ends;
        answered.warnings.push_back(
            ends ? name + " ends before " + place + ": its contacts are too many or too dense beyond"
                 : name + " has no result at " + std::to_string(count) + " of " + std::to_string(points) +
                       " points, the first of them " + place + ": " + missed.reason);
    }
}

/// A warning where the answer lacks points.
void warn_of_lost(Answered& answered) {
    const auto& scene = *answered.scene;
    const std::size_t count = answered.answer.points.size(), lost = count - count_of(answered.answer);
    if (lost == 0) return;
    answered.doubtful = true;
    const AnswerPoint& first = first_missed(answered.answer);
    const std::string point = scene.shown_point(first.place);
    answered.warnings.push_back(
        (scene.best ? "no K at " : "the answer has no K at ") +
        (lost == 1 ? point
                   : std::to_string(lost) + " of " + std::to_string(count) + " points, the first of them " + point) +
        ": " + first.reason);
}

/// A warning where law plastic is nearer to the hardness than any comparison of it.
void warn_of_hardness(Answered& answered) {
    for (const AnswerCurve* curve : answered.shown_curves())
        if (const Check<double>* check = detail::find_check(curve->checks, Concern::beyond_comparison)) {
            answered.doubtful = answered.doubtful || answered.is_answer(*curve);
            return answered.warnings.push_back(
                "law plastic was compared up to " + document::with_unit(check->limit, "Pa", 3) + ", " +
                document::shown_percent(detail::max_compared_flow) + " of the hardness: K at " +
                document::with_unit(curve->at(check->first)->pressure, "Pa", 3) +
                " may be far off, and outside of its band");
        }
}

/// Begins the sentence about what does not hold at some points of a curve.
std::string_view sentence(Concern concern) {
    switch (concern) {
        case Concern::interacting_asperities:
            return "p* is above 0.01: laws without interaction of the asperities give too small a K there";
        case Concern::mean_planes_crossed: return "the separation is below 0: the mean planes have passed each other";
        case Concern::above_highest_peak:
            return "the separation is above the highest peak: real surfaces do not touch there";
        case Concern::few_contacts:
            return "fewer than 10 contacts on the nominal area: a mean over peaks is unreliable there";
        case Concern::area_above_nominal:
            return "the real area exceeds the nominal area: the model does not hold there";
        case Concern::not_converged:
            return "the stiffness has an error above 1e-6 of its size: the integrals did not converge there";
        default: return "";
    }
}

/// A warning for all curves that have a point where \p concern does not hold.
void warn_if_any(Answered& answered, Concern concern) {
    std::size_t count = 0;
    std::string where;
    for (const AnswerCurve& curve : answered.curves()) {
        const Check<double>* check = detail::find_check(curve.checks, concern);
        if (check && !check->holds() && count++ == 0)
            where = title(curve) + " at p = " + document::rounded(curve.at(check->first)->pressure / 1e6) + " MPa";
    }
    if (count > 0)
        answered.warnings.push_back(std::string(sentence(concern)) + " (" + std::to_string(count) + " of " +
                                    std::to_string(answered.curves().size()) + " curves, the first " + where + ")");
}

/// A warning for each plastic law with a point where its peaks, each weighted by its load, are outside of its range.
void warn_of_plastic_ranges(const std::vector<const detail::Law*>& laws, Answered& answered) {
    for (const detail::Law* law : laws) {
        std::size_t count = 0, points = 0;
        std::string first;
        for (const AnswerCurve& curve : answered.answer.laws) {
            if (curve.law != law->which) continue;
            points += count_of(curve);
            for (const AnswerPoint& point : curve.points)
                if (!point.doubt.empty() && count++ == 0)
                    first = "at p = " + document::rounded(point.pressure / 1e6) + " MPa (" + title(curve) +
                            ") the mean over the load is " + point.doubt;
        }
        if (count > 0)
            answered.warnings.push_back("law " + std::string(law->name) + " is outside of its range at " +
                                        std::to_string(count) + " of " + std::to_string(points) +
                                        " points, and may be far off there: first " + first);
    }
}

/// Warnings for the laws that are named: the band of an answer includes their causes.
void warn_of_named_laws(Answered& answered) {
    const auto& scene = *answered.scene;
    for (const Check<double>& check : surface_checks(scene.joint)) {
        if (check.holds()) continue;
        const std::string value = document::rounded(check.least, 3);
        answered.warnings.push_back(
            check.concern == Concern::plasticity
                ? "plasticity index " + value + " is above 1: " + std::string(yielding_peaks)
                : "sigma R D_p = " + value + " is below " + document::rounded(check.limit, 3) +
                      ", the minimum for the summits of an isotropic Gaussian surface: R and D_p may be those of "
                      "islands");
    }
    for (const Concern concern : {Concern::interacting_asperities, Concern::mean_planes_crossed,
                                  Concern::above_highest_peak, Concern::few_contacts})
        warn_if_any(answered, concern);
    warn_of_plastic_ranges(scene.laws, answered);
    if ((scene.asks("reflection") || scene.asks("shear_reflection")) && scene.joint.reading != InteractionReading::none)
        answered.warnings.push_back(
            "K with interaction includes the elasticity of the bulk over the interaction length: its reflection is not "
            "that of the interface alone");
}

}  // namespace

void add_warnings(Answered& answered) {
    const auto& scene = *answered.scene;
    if (!scene.best) warn_of_missed(answered);
    if (answered.has_answer()) warn_of_lost(answered);
    warn_of_hardness(answered);
    const std::vector<Parameter> unknown = unknown_parameters(scene.joint, scene.best);
    if (!scene.best)
        warn_of_named_laws(answered);
    else if (scene.joint.reading != InteractionReading::none && scene.laws.front()->holds_when_crowded)
        answered.warnings.push_back(
            "contact.interaction does not affect the answer, whose laws include their own interaction");
    if (scene.best && !unknown.empty() && !detail::is_known(scene.joint.face.parameters.rms_height))
        answered.warnings.push_back(answered.answer.of_map_itself
                                        ? "sigma is not known to a factor of two: K is that of this map alone"
                                        : "sigma is not known to a factor of two, so K and its band are doubtful");
    if (std::count(unknown.begin(), unknown.end(), Parameter::rms_gradient) > 0)
        answered.warnings.push_back(
            "the rms gradient is not known to a factor of two, so K and its band are doubtful where it counts");
    const std::size_t before = answered.warnings.size();
    for (const Concern concern : {Concern::area_above_nominal, Concern::not_converged}) warn_if_any(answered, concern);
    const double noise = scene.best ? noise_of(scene.joint.face, scene.joint.law_options.edges) /
                                          scene.joint.face.parameters.rms_height.value
                                    : 0;
    if (answered.warnings.size() > before || scene.implausible || has_lay(scene.joint) || !unknown.empty())
        answered.doubtful = true;
    if (noise > detail::most_noise)
        answered.warnings.push_back("the shortest waves of the map are noise, some " +
                                    document::rounded(100 * noise, 1) +
                                    " % of sigma: K without it is higher (surface.lambda_s filters it)");
}

}  // namespace fstiff::actions
