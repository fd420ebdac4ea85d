// SPDX-License-Identifier: BSD-3-Clause
#include "actions/explanation.hpp"
#include "actions/run.hpp"
#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/curves.hpp>

#include <algorithm>
#include <string_view>

namespace fstiff::actions {
namespace {

/// A warning for each law that is named and lacks points. One that ends above some pressure is expected to.
void warn_of_missed(const scene::Scene& scene, Results& results) {
    for (const detail::Law* law : scene.laws) {
        std::size_t count = 0, points = 0;
        const Curve* first = nullptr;
        for (const Curve& curve : results.curves) {
            if (curve.law != law) continue;
            points += scene.points.size();
            count += curve.missed.size();
            if (!first && !curve.missed.empty()) first = &curve;
        }
        if (count == 0) continue;
        const detail::MissedPoint& missed = first->missed.front();
        const std::string name = "law " + std::string(law->name),
                          place =
                              document::shortest(scene.points[missed.place]) + (scene.at_separations ? " m" : " Pa");
        const bool ends = law->ends && !first->states.empty();
        results.doubtful = results.doubtful || !ends;
        results.warnings.push_back(
            ends ? name + " ends before " + place + ": its contacts are too many or too crowded beyond"
                 : name + " has no result at " + std::to_string(count) + " of " + std::to_string(points) +
                       " points, the first of them " + place + ": " + reason_of(scene, missed));
    }
}

/// A warning where the answer lacks points.
void warn_of_lost(const scene::Scene& scene, Results& results) {
    const std::vector<detail::MissedPoint>& missed = results.answer->curve.missed;
    if (missed.empty()) return;
    results.doubtful = true;
    const std::size_t count = missed.size() + results.answer->curve.states.size();
    results.warnings.push_back((scene.best ? "no K at " : "the answer has no K at ") +
                               (missed.size() == 1
                                    ? shown_point(scene, missed.front().place)
                                    : std::to_string(missed.size()) + " of " + std::to_string(count) +
                                          " points, the first of them " + shown_point(scene, missed.front().place)) +
                               ": " + reason_of(scene, missed.front()));
}

/// A warning where law plastic is nearer to the hardness than any comparison of it.
void warn_of_hardness(const detail::ResolvedJoint& problem, Results& results) {
    for (const Curve* curve : shown_curves(results))
        if (const auto check = beyond_comparison(problem, *curve)) {
            results.doubtful = results.doubtful || !curve->by.empty();
            return results.warnings.push_back(
                "law plastic was compared up to " + document::with_unit(check->limit, "Pa", 3) + ", " +
                document::shown_percent(detail::max_compared_flow) + " of the hardness: K at " +
                document::with_unit(curve->states[check->first].pressure.value, "Pa", 3) +
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
void warn_if_any(Results& results, Concern concern) {
    std::size_t count = 0;
    std::string where;
    for (const Curve& curve : results.curves) {
        const Check<double>* check = detail::find_check(curve.checks, concern);
        if (check && !check->holds() && count++ == 0)
            where =
                title(curve) + " at p = " + document::rounded(curve.states[check->first].pressure.value / 1e6) + " MPa";
    }
    if (count > 0)
        results.warnings.push_back(std::string(sentence(concern)) + " (" + std::to_string(count) + " of " +
                                   std::to_string(results.curves.size()) + " curves, the first " + where + ")");
}

/// The part of \p means outside of the range of \p law; may be empty.
std::string outside_range(const detail::Law& law, const LoadMeans<double>& means) {
    const double s = means.interference.value, ratio = means.radius_ratio.value;
    std::string text;
    const auto say = [&](const char* name, double value, const char* side, double limit) {
        text += (text.empty() ? "" : " and ") + std::string(name) + " = " + document::rounded(value, 4) + ", " + side +
                " " + document::rounded(limit, 3);
    };
    if (s < law.range.least_interference) say("omega/omega_c", s, "below", law.range.least_interference);
    if (s > law.range.most_interference) say("omega/omega_c", s, "above", law.range.most_interference);
    if (ratio > law.range.most_radius_ratio) say("a/R", ratio, "above", law.range.most_radius_ratio);
    return text;
}

/// A warning for each plastic law with a point where its peaks, each weighted by its load, are outside of its range.
void warn_of_plastic_ranges(const std::vector<const detail::Law*>& laws, Results& results) {
    for (const detail::Law* law : laws) {
        std::size_t count = 0, points = 0;
        std::string first;
        for (const Curve& curve : results.curves) {
            if (curve.law != law) continue;
            points += curve.means.size();
            for (std::size_t i = 0; i < curve.means.size(); ++i) {
                const std::string outside = outside_range(*curve.law, curve.means[i]);
                if (!outside.empty() && count++ == 0)
                    first = "at p = " + document::rounded(curve.states[i].pressure.value / 1e6) + " MPa (" +
                            title(curve) + ") the mean over the load is " + outside;
            }
        }
        if (count > 0)
            results.warnings.push_back("law " + std::string(law->name) + " is outside of its range at " +
                                       std::to_string(count) + " of " + std::to_string(points) +
                                       " points, and may be far off there: first " + first);
    }
}

/// Warnings for the laws that are named: the band of an answer includes their causes.
void warn_of_named_laws(const scene::Scene& scene, Results& results) {
    for (const Check<double>& check : results.surface_checks) {
        if (check.holds()) continue;
        const std::string value = document::rounded(check.least, 3);
        results.warnings.push_back(
            check.concern == Concern::plasticity
                ? "plasticity index " + value + " is above 1: " + std::string(yielding_peaks)
                : "sigma R D_p = " + value + " is below " + document::rounded(check.limit, 3) +
                      ", the minimum for the summits of an isotropic Gaussian surface: R and D_p may be those of "
                      "islands");
    }
    for (const Concern concern : {Concern::interacting_asperities, Concern::mean_planes_crossed,
                                  Concern::above_highest_peak, Concern::few_contacts})
        warn_if_any(results, concern);
    warn_of_plastic_ranges(scene.laws, results);
    if ((scene.asks(scene::CurveQuantity::reflection) || scene.asks(scene::CurveQuantity::shear_reflection)) &&
        scene.reading != InteractionReading::none)
        results.warnings.push_back(
            "K with interaction includes the elasticity of the bulk over the interaction length: its reflection is not "
            "that of the interface alone");
}

}  // namespace

void add_warnings(const scene::Scene& scene, Results& results) {
    if (!scene.best) warn_of_missed(scene, results);
    if (results.answer) warn_of_lost(scene, results);
    warn_of_hardness(scene, results);
    const std::vector<Parameter> unknown = unknown_parameters(scene, scene.best);
    if (!scene.best)
        warn_of_named_laws(scene, results);
    else if (scene.reading != InteractionReading::none && scene.laws.front()->holds_when_crowded)
        results.warnings.push_back(
            "contact.interaction does not affect the answer, whose laws include their own interaction");
    if (scene.best && !unknown.empty() && !detail::is_known(scene.face.parameters.rms_height))
        results.warnings.push_back(results.answer && results.answer->of_map_itself
                                       ? "sigma is not known to a factor of two: K is that of this map alone"
                                       : "sigma is not known to a factor of two, so K and its band are doubtful");
    if (std::count(unknown.begin(), unknown.end(), Parameter::rms_gradient) > 0)
        results.warnings.push_back(
            "the rms gradient is not known to a factor of two, so K and its band are doubtful where it counts");
    const std::size_t before = results.warnings.size();
    for (const Concern concern : {Concern::area_above_nominal, Concern::not_converged}) warn_if_any(results, concern);
    const double noise =
        scene.best ? noise_of(scene.face, scene.law_options.edges) / scene.face.parameters.rms_height.value : 0;
    if (results.warnings.size() > before || scene.implausible || has_lay(scene) || !unknown.empty())
        results.doubtful = true;
    if (noise > detail::most_noise)
        results.warnings.push_back("the shortest waves of the map are noise, some " +
                                   document::rounded(100 * noise, 1) +
                                   " % of sigma: K without it is higher (surface.lambda_s filters it)");
}

}  // namespace fstiff::actions
