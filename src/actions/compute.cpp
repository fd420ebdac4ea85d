// SPDX-License-Identifier: BSD-3-Clause
#include "actions/compute.hpp"

#include "actions/explanation.hpp"
#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/request.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>

#include <algorithm>
#include <utility>

namespace fstiff::actions {

using detail::LawCurve, scene::Scene;

namespace {

/// \throws domain_error where no curve has a state, with the reason of the first law at its first point.
void require_states(const Scene& scene, const std::vector<LawCurve>& curves) {
    if (std::any_of(curves.begin(), curves.end(), [](const LawCurve& curve) { return !curve.states.empty(); })) return;
    for (const LawCurve& curve : curves)
        if (!curve.missed.empty())
            throw domain_error(scene.points_where + "law " + std::string(curve.law->name) + ": " +
                               reason_of(scene, curve.missed.front()));
}

std::vector<LawCurve> moved(detail::Curves& from) {
    if (from.named.empty()) from.named.push_back(*from.answer);
    return std::move(from.named);
}

/// \p curves with the columns of \p scene.
std::vector<Curve> with_columns(const Scene& scene, std::vector<LawCurve> curves) {
    const bool bands =
        std::any_of(curves.begin(), curves.end(), [](const LawCurve& curve) { return !curve.band.empty(); });
    std::vector<Curve> computed;
    for (LawCurve& curve : curves) {
        computed.push_back({std::move(curve)});
        computed.back().columns = columns_of(scene, computed.back(), bands);
    }
    return computed;
}

/// The answer that \p curves has next to the laws that are named, or a warning.
void take_answer(const Scene& scene, detail::Curves& curves, Results& results) {
    const auto refuse = [&](const std::string& why) {
        results.warnings.push_back("the answer has no K: " + why);
        results.doubtful = true;
    };
    if (!curves.answer) return refuse(curves.no_answer);
    try {
        require_states(scene, {*curves.answer});
    } catch (const domain_error& error) {
        return refuse(error.what());
    }
    StiffnessAnswer& answer = results.answer.emplace();
    static_cast<detail::AnswerFacts&>(answer) = std::move(curves.facts);
    static_cast<LawCurve&>(answer.curve) = std::move(*curves.answer);
    answer.curve.columns = columns_of(scene, answer.curve, true);
}

/// The ball of \p scene under each force, with warnings where the law does not reach its pressures, and where the
/// bodies yield below their faces (Johnson, Contact Mechanics, section 6.2).
void add_balls(const Scene& scene, Results& results) {
    const auto& [radius, forces] = *scene.ball;
    const StiffnessAnswer& answer = *results.answer;
    const std::vector<detail::BallOnFace> faces = detail::balls_on_answer(scene, answer.curve, answer, radius, forces);
    const double strength =
        scene.yield_strength.value_or(hardness_of(scene) / detail::hardness_over_yield_strength<double>);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        results.balls.push_back({faces[i], detail::hertz_ball(radius, scene.effective_modulus, forces[i])});
        const std::string under = "the ball under " + document::with_unit(forces[i], "N");
        if (!faces[i].reason.empty()) {
            results.warnings.push_back(under + " has no contact: " + faces[i].reason);
            results.doubtful = true;
        } else if (faces[i].contact.pressure > 1.6 * strength) {
            results.warnings.push_back(under +
                                       " yields below its face, but is computed as elastic: its pressure is "
                                       "above 1.6 times the yield strength");
        }
    }
}

}  // namespace

std::vector<Curve> curves_of(const Scene& scene, const std::vector<detail::MadeContact>& contacts) {
    detail::Request request = request_of(scene);
    request.answers = request.checked = false;
    detail::Curves computed = curves_of(scene, request, {}, &contacts);
    std::vector<LawCurve> curves = moved(computed);
    require_states(scene, curves);
    return with_columns(scene, std::move(curves));
}

Results compute(const Scene& scene, const ProgressHook& progress, const ParallelHook& parallel) {
    Results results;
    results.modulus = scene.effective_modulus;
    results.warnings = scene.warnings;
    const bool has_peaks = scene.face.has_radius_and_density();
    if (scene.yield_strength && has_peaks)
        results.plasticity_index =
            detail::plasticity_index(scene.face.roughness(), scene.effective_modulus, *scene.yield_strength);
    results.tangential_ratio = tangential_ratio(scene.upper, scene.lower);
    if (has_peaks)
        results.surface_checks =
            detail::check_surface(scene.face.roughness(), scene.effective_modulus, scene.yield_strength);
    detail::Request request = request_of(scene);
    request.parallel = parallel;
    // warnings and the explanation need the contacts and the area, whichever columns are shown
    request.quantities = request.quantities | Quantity::contact_density | Quantity::real_area_fraction;
    detail::Curves computed = curves_of(scene, request, progress);
    const bool best = computed.named.empty();
    std::vector<LawCurve> curves = moved(computed);
    for (const LawCurve& curve : curves)
        if (!curve.no_separation_at_seating.empty())
            results.warnings.push_back("law " + std::string(curve.law->name) +
                                       " has no approach: " + curve.no_separation_at_seating);
    require_states(scene, curves);
    if (computed.failed > 0)
        results.warnings.push_back(
            "up to " + std::to_string(computed.failed) + " of " + std::to_string(scene.samples) +
            " sampled surfaces are outside the range of the model at some point: the band there is from the others");
    results.curves = with_columns(scene, std::move(curves));
    if (best) {
        StiffnessAnswer& answer = results.answer.emplace();
        static_cast<detail::AnswerFacts&>(answer) = std::move(computed.facts);
        answer.curve = results.curves.front();
    } else {
        take_answer(scene, computed, results);
    }
    add_warnings(scene, results);
    if (scene.ball) add_balls(scene, results);
    Explanation sentences = explanation(scene, results);
    results.explanation = std::move(sentences.sentences);
    results.short_explanation = std::move(sentences.shorter);
    return results;
}

}  // namespace fstiff::actions
