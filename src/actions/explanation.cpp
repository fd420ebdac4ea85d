// SPDX-License-Identifier: BSD-3-Clause
#include "actions/explanation.hpp"

#include "document/shown_unit.hpp"

#include <fstiff/answer/answer_of.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/laws.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace fstiff::actions {

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
        case Cause::form: return "form";
    }
    return "";
}

/// Whether the loading stiffness is K to a twentieth at every point: what yields hardly counts.
bool is_nearly_elastic(const Answer& answer) {
    return answer.flows && std::all_of(answer.points.begin(), answer.points.end(), [](const AnswerPoint& point) {
               return !point.ok() || point.loading_stiffness.value_or(0) > 0.95 * point.stiffness.value;
           });
}

/// Whether the peaks have yielded under more than the pressure of every point.
bool has_carried_more(const detail::ResolvedJoint& joint, const Answer& answer) {
    const double carried = joint.greatest_pressure.value_or(0);
    return answer.flows && std::all_of(answer.points.begin(), answer.points.end(),
                                       [&](const AnswerPoint& point) { return point.pressure < carried; });
}

/// The kind of stiffness that K is, and where it applies.
std::vector<std::string> nature(const detail::ResolvedJoint& joint, const Answer& answer) {
    const std::optional<double>& ratio = answer.relative_hardness;
    const std::string number = ratio ? " (H/(E g) = " + document::rounded(*ratio, 2) + ")" : "";
    const bool loads = std::any_of(answer.points.begin(), answer.points.end(),
                                   [](const AnswerPoint& point) { return point.loading_stiffness.has_value(); });
    if (has_carried_more(joint, answer))
        return {"The peaks yielded under " + document::with_unit(*joint.greatest_pressure, "Pa", 3) + number + ".",
                "Below it K is the same for loading, vibration and waves."};
    if (is_nearly_elastic(answer))
        return {"The contact is nearly elastic" + number +
                ": K is the same for loading, vibration and waves, within 5 %."};
    if (answer.flows)
        return {"The peaks yield at first loading" + number + ": K is the unloading stiffness.",
                std::string("Vibration and waves depend on K; the first static loading ") +
                    (loads ? "depends on the loading K/A0." : "has another, which is not known.")};
    if (ratio) return {"K is that of an elastic contact; where peaks yield" + number + " K for vibration is higher."};
    if (std::isfinite(answer.hardness))
        return {
            "The gradient of the surface is not known, so K is elastic; where peaks yield K for vibration is higher."};
    return {"The bodies never yield, so K is elastic: the same for loading, vibration and waves."};
}

/// Why a measured map is not solved; empty where it is, or there is none.
std::string instead_of_map(const detail::ResolvedJoint& joint) {
    for (const detail::Face* face : measured_faces(joint)) {
        if (face->measured->is_profile) continue;
        if (!face->map) return "the JSON of fstiff measure does not contain them: give the file of the map";
        if (!face->instead_of_map.empty()) return std::string(face->instead_of_map) + " is given";
    }
    return "";
}

/// Source of K beyond the names of the laws; may be empty.
std::string source_of(const detail::ResolvedJoint& joint, const Answer& answer) {
    const auto solved = [](const AnswerPoint& point) { return point.law == LawKind::boundary_elements; };
    const auto count = static_cast<std::size_t>(std::count_if(answer.points.begin(), answer.points.end(), solved));
    const auto& map = joint.face.map;
    const std::string missing = scene::missing_phrase(joint.face),
                      least = document::rounded(detail::min_points_in_contact);
    std::string text;
    if (!missing.empty())
        text = "K is computed from the map's numbers: " + missing;
    else if (const std::string given = instead_of_map(joint); !given.empty())
        text = "K is computed from numbers, not from the heights of the map, because " + given;
    else if (count > 0)
        text = "Boundary elements solve " +
               (map->maps.size() == 1 ? "the map itself"
                                      : "the sum of both maps at " + std::to_string(map->maps.size()) + " shifts") +
               (count == count_of(answer) ? ""
                                          : " where " + least +
                                                " points touch; elsewhere K is computed from its summits and bearing "
                                                "curve");
    else if (map && joint.face.spectrum_of_map)
        text = detail::find_law(answer.law).needs_spectrum
                   ? "K is computed from the map's summits and bearing curve"
                   : "K is computed from R and D_p of the map, which has no summits for law hybrid";
    else if (has_lay(joint))
        text = "The profile repeats itself, like one across a lay: K may be up to " +
               document::rounded(detail::lay_factor) + " times higher; only a map shows this";
    if (answer.long_waves < 0.95)
        text += (text.empty() ? "Longer" : "; longer") + std::string(" waves of a face of this size lower K to ") +
                document::rounded(answer.long_waves, 2) + " of that of what was measured";
    return text.empty() ? text : text + ".";
}

/// What to measure, for people.
std::string words_of(const Answer::Next& next, const detail::ResolvedJoint& problem) {
    const bool lay = detail::prior_of(rough_faces(problem).front()->process).has_lay;
    if (next.flatness) return "the flatness of the faces";
    if (!next.which) {
        const Surface<double>& measured = *measured_faces(problem).front()->measured;
        if (!measured.is_profile) return "four times the area";
        if (lay || has_lay(problem)) return "a map";
        return std::to_string(3 * (std::max)(std::size_t(1), measured.parts.size())) + " more traces at other places";
    }
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

std::string shown_causes(const Causes<double>& causes, std::size_t most) {
    const auto shares = shares_of(causes);
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

namespace {

/// How flat faces of no known size must be to conform at the middle pressure, as the answer takes them; empty where
/// their form is known or in the band. A crown of the height F over the half width b conforms at p/E = F/(1.2 b).
std::string form_taken(const Answered& answered) {
    constexpr double side = 0.05;
    const auto& scene = *answered.scene;
    const AnswerPoint* middle = answered.answer.at(scene.points.size() / 2);
    if (scene.joint.nominal_area || scene.ball || !middle) return "";
    const double flatness = 1.2 * middle->pressure * (side / 2) / scene.joint.effective_modulus;
    return "faces not flat within " + document::shown_length(flatness, 2) + " over 50 mm at " +
           document::with_unit(middle->pressure, "Pa", 3);
}

}  // namespace

std::string outside_band(const Answered& answered) {
    const auto& scene = *answered.scene;
    std::string text = "Not in the band: wear, dirt, films, misaligned faces";
    if (const std::string form = form_taken(answered); !form.empty()) text += ", " + form;
    if (!scene.joint.nominal_area)
        text += std::string(answered.answer.of_map_itself         ? ", other parts of the face"
                            : measured_faces(scene.joint).empty() ? ", few contacts"
                                                                  : ", long waves") +
                (scene.ball ? "" : " (give contact.nominal_area)");
    for (const detail::Face* face : rough_faces(scene.joint))
        if (!face->measured && face->process == Process::unknown && face->is_open(Unknown::skewness))
            return text +
                   "; for a worn or honed face K may be several times higher (give process, or skewness and "
                   "kurtosis).";
    return text + ".";
}

std::string measure_next(const Answered& answered) {
    const auto& scene = *answered.scene;
    const auto next = next_of(scene.joint, scene.points, scene.options(), answered.answer);
    if (!next) return "";
    const auto factor = [&](double value) {
        return document::rounded(value,
                                 document::rounded(next->factor, 2) == document::rounded(next->narrowed, 2) ? 3 : 2);
    };
    return "measure " + words_of(*next, scene.joint) + ": the band at " + document::with_unit(next->pressure, "Pa", 3) +
           " narrows from a factor of " + factor(next->factor) + " to " + factor(next->narrowed);
}

std::string origin_of_band(const Answered& answered) {
    const auto& scene = *answered.scene;
    if (scene.best) return "the 90 % band of the answer";
    std::string text;
    if (scene.joint.face.has_measured_errors())
        text = "; " + document::rounded(scene.samples) + " surfaces sampled from the errors, seed " +
               std::to_string(scene.seed);
    if (!scene.joint.face.neighbours.empty()) text += "; the choice of lambda_s";
    if (!scene.joint.face.priors.empty()) text += "; unknown parameters of the surface";
    return text.substr(std::min<std::size_t>(2, text.size()));
}

std::string why_no_band(const Answered& answered) {
    const auto& scene = *answered.scene;
    if (scene.samples == 0) return "the scene asks for no samples";
    if (!scene.joint.face.has_errors()) return "no error of a parameter of the surface is given";
    const auto curves = answered.curves();
    const bool varies = std::any_of(curves.begin(), curves.end(),
                                    [](const AnswerCurve& curve) { return detail::find_law(curve.law).varies; });
    return varies ? "they depend on no parameter that is uncertain" : "they are computed of the measured map alone";
}

std::pair<std::vector<std::string>, std::vector<std::string>> explanation_of(const Answered& answered) {
    const auto& joint = answered.scene->joint;
    if (!answered.has_answer()) return {};
    const Answer& answer = answered.answer;
    std::vector<std::string> sentences = nature(joint, answer);
    if (std::string source = source_of(joint, answer); !source.empty()) sentences.push_back(std::move(source));
    const std::string shorter = has_lay(joint)                    ? "A profile across a lay does not determine K."
                                : has_carried_more(joint, answer) ? "The peaks have yielded before: K is elastic."
                                : is_nearly_elastic(answer)       ? "The contact is nearly elastic."
                                : answer.flows                    ? "The peaks yield: K is that of unloading."
                                : !answer.relative_hardness       ? "Taken as elastic."
                                                                  : "K is that of an elastic contact; peaks may yield.";
    return {std::move(sentences), {shorter}};
}

}  // namespace fstiff::actions
