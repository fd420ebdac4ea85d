// SPDX-License-Identifier: BSD-3-Clause
#include "actions/explanation.hpp"

#include "document/shown_unit.hpp"

#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/face.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace fstiff::actions {

using scene::Scene;

namespace {

/// \p cause for people.
std::string_view words_of(Cause cause) {
    switch (cause) {
        case Cause::measurement: return "measurement";
        case Cause::cut_offs: return "cut-offs";
        case Cause::shape: return "shape of heights";
        case Cause::prior: return "assumptions";
        case Cause::lay: return "lay";
        case Cause::law: return "law";
        case Cause::contacts: return "few contacts";
        case Cause::long_waves: return "longer waves";
        case Cause::hardness: return "hardness";
        case Cause::noise: return "noise";
    }
    return "";
}

/// Whether the loading stiffness is K to a twentieth at every point: what yields hardly counts.
bool is_nearly_elastic(const StiffnessAnswer& answer) {
    bool nearly = answer.flows;
    for (std::size_t i = 0; i < answer.reasons.size(); ++i)
        nearly =
            nearly && answer.reasons[i].loading_stiffness.value_or(0) > 0.95 * answer.curve.states[i].stiffness.value;
    return nearly;
}

/// The kind of stiffness that K is, and where it applies.
std::vector<std::string> nature(const Scene& scene, const Results& results) {
    const StiffnessAnswer& answer = *results.answer;
    const std::optional<double>& ratio = answer.relative_hardness;
    const std::string number = ratio ? " (H/(E g) = " + document::rounded(*ratio, 2) + ")" : "";
    const bool loads =
        std::any_of(answer.reasons.begin(), answer.reasons.end(),
                    [](const detail::AnswerReason& reason) { return reason.loading_stiffness.has_value(); });
    if (is_nearly_elastic(answer))
        return {"The contact is nearly elastic" + number +
                ": K is the same for loading, vibration and waves, within 5 %."};
    if (answer.flows)
        return {"The peaks yield at first loading" + number + ": K is the unloading stiffness.",
                std::string("Vibration and waves depend on K; the first static loading ") +
                    (loads ? "depends on the loading K/A0." : "has another, which is not known.")};
    if (ratio) return {"K is that of an elastic contact; where peaks yield" + number + " K for vibration is higher."};
    if (std::isfinite(hardness_of(scene)))
        return {
            "The gradient of the surface is not known, so K is elastic; where peaks yield K for vibration is higher."};
    return {"The bodies never yield, so K is elastic: the same for loading, vibration and waves."};
}

/// Why a measured map is not solved; empty where it is, or there is none.
std::string instead_of_map(const Scene& scene) {
    for (const detail::Face* face : measured_faces(scene)) {
        if (face->measured->is_profile) continue;
        if (!face->map) return "the JSON of fstiff measure does not contain them: give the file of the map";
        if (!face->instead_of_map.empty()) return std::string(face->instead_of_map) + " is given";
    }
    return "";
}

/// Source of K beyond the names of the laws; may be empty.
std::string source_of(const Scene& scene, const StiffnessAnswer& answer) {
    const Curve& curve = answer.curve;
    const auto solved = [](const detail::Law* law) { return law->which == LawName::boundary_elements; };
    const auto count = static_cast<std::size_t>(std::count_if(curve.by.begin(), curve.by.end(), solved));
    const auto& map = scene.face.map;
    const std::string missing = scene::missing_phrase(scene.face),
                      least = document::rounded(detail::min_points_in_contact);
    std::string text;
    if (!missing.empty())
        text = "K is computed from the map's numbers: " + missing;
    else if (const std::string given = instead_of_map(scene); !given.empty())
        text = "K is computed from numbers, not from the heights of the map, because " + given;
    else if (count > 0)
        text = "Boundary elements solve " +
               (map->maps.size() == 1 ? "the map itself"
                                      : "the sum of both maps at " + std::to_string(map->maps.size()) + " shifts") +
               (count == curve.by.size() ? ""
                                         : " where " + least +
                                               " points touch; elsewhere K is computed from its summits and bearing "
                                               "curve");
    else if (map && scene.face.spectrum_of_map)
        text = curve.law->needs_spectrum
                   ? "K is computed from the map's summits and bearing curve"
                   : "K is computed from R and D_p of the map, which has no summits for law hybrid";
    else if (has_lay(scene))
        text = "The profile repeats itself, like one across a lay: K may be up to " +
               document::rounded(detail::lay_factor) + " times higher; only a map shows this";
    return text.empty() ? text : text + ".";
}

/// What to measure, for people.
std::string words_of(const detail::NextMeasurement& next, const detail::ResolvedJoint& problem) {
    const bool lay = detail::prior_of(rough_faces(problem).front()->process).has_lay;
    if (!next.which && !measured_faces(problem).front()->measured->is_profile) return "four times the area";
    if (!next.which) return lay || has_lay(problem) ? "a map" : "four times the length";
    const auto what = [&]() -> std::string {
        switch (*next.which) {
            case Unknown::height: return "Rq or Sq";
            case Unknown::gradient: return lay ? "Sdq" : "Sdq or Rdq";
            case Unknown::alpha: return "alpha";
            case Unknown::hurst: return "D or H";
            default: return "skewness and kurtosis";
        }
    };
    if (next.which == Unknown::hardness) return "the hardness of the softer body";
    return what() + (problem.faces.empty() ? "" : " of both faces");
}

}  // namespace

std::string shown_causes(const detail::AnswerReason& reason, std::size_t most) {
    const auto shares = shares_of(reason.causes);
    std::array<std::size_t, detail::cause_count> order{};
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
    std::string text;
    for (std::size_t k = 0; k < most; ++k)
        if (const std::size_t i = order[k]; shares[i] >= 0.1)
            text += (text.empty() ? "" : ", ") + std::string(words_of(static_cast<Cause>(i))) + " " +
                    document::shown_percent(shares[i]);
    return text;
}

std::string outside_band(const Scene& scene, const Results& results) {
    std::string text = "Not in the band: wear, dirt, films, misaligned faces";
    if (!scene.nominal_area)
        text += std::string(results.answer && results.answer->of_map_itself ? ", other parts of the face"
                            : measured_faces(scene).empty()                 ? ", few contacts"
                                                                            : ", long waves") +
                (scene.ball ? "" : " (give contact.nominal_area)");
    for (const detail::Face* face : rough_faces(scene))
        if (!face->measured && face->process == Process::unknown && face->is_open(Unknown::skewness))
            return text +
                   "; for a worn or honed face K may be several times higher (give process, or skewness and "
                   "kurtosis).";
    return text + ".";
}

std::string measure_next(const Scene& scene, const Results& results) {
    if (!results.answer) return "";
    const Curve& curve = results.answer->curve;
    const std::vector<std::size_t> points = points_of_answer(scene);
    const auto state = curve.state_at(points[points.size() / 2]);
    if (!state) return "";
    const auto next = next_measurement(scene, request_of(scene), curve, *results.answer, *state);
    if (!next) return "";
    const double wide = curve.band[*state].high / curve.band[*state].low;
    const auto factor = [&](double value) {
        return document::rounded(value, document::rounded(wide, 2) == document::rounded(next->factor, 2) ? 3 : 2);
    };
    return "measure " + words_of(*next, scene) + ": the band at " +
           document::with_unit(curve.states[*state].pressure.value, "Pa", 3) + " narrows from a factor of " +
           factor(wide) + " to " + factor(next->factor);
}

std::string origin_of_band(const Scene& scene) {
    if (scene.best) return "the 90 % band of the answer";
    std::string text;
    if (scene.face.has_measured_errors())
        text = "; " + document::rounded(scene.samples) + " surfaces sampled from the errors, seed " +
               std::to_string(scene.seed);
    if (!scene.face.neighbours.empty()) text += "; the choice of lambda_s";
    if (!scene.face.priors.empty()) text += "; unknown parameters of the surface";
    return text.substr(std::min<std::size_t>(2, text.size()));
}

std::string why_no_band(const Scene& scene, const Results& results) {
    if (scene.samples == 0) return "the scene asks for no samples";
    if (!scene.face.has_errors()) return "no error of a parameter of the surface is given";
    const bool varies =
        std::any_of(results.curves.begin(), results.curves.end(), [](const Curve& curve) { return curve.law->varies; });
    return varies ? "they depend on no parameter that is uncertain" : "they are computed of the measured map alone";
}

Explanation explanation(const Scene& scene, const Results& results) {
    if (!results.answer) return {};
    const StiffnessAnswer& answer = *results.answer;
    Explanation text{nature(scene, results), {}};
    if (std::string source = source_of(scene, answer); !source.empty()) text.sentences.push_back(std::move(source));
    text.shorter = {is_nearly_elastic(answer)   ? std::string("The contact is nearly elastic.")
                    : answer.flows              ? "The peaks yield: K is that of unloading."
                    : !answer.relative_hardness ? "Taken as elastic."
                                                : "K is that of an elastic contact; peaks may yield."};
    if (has_lay(scene)) text.shorter = {"A profile across a lay does not determine K."};
    return text;
}

}  // namespace fstiff::actions
