// SPDX-License-Identifier: BSD-3-Clause
#include "scene/explanation.hpp"

#include "document/shown_unit.hpp"
#include "scene/answer.hpp"

#include <fstiff/measured/widened_band.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fstiff::scene {
namespace {

/// \p cause for people.
std::string_view words_of(parts::Cause cause) {
    switch (cause) {
        case parts::Cause::measurement: return "measurement";
        case parts::Cause::cut_offs: return "cut-offs";
        case parts::Cause::shape: return "shape of heights";
        case parts::Cause::prior: return "assumptions";
        case parts::Cause::lay: return "lay";
        case parts::Cause::law: return "law";
        case parts::Cause::contacts: return "few contacts";
        case parts::Cause::long_waves: return "longer waves";
    }
    return "";
}

/// The kind of stiffness that K is, and where it applies.
std::vector<std::string> nature(const Results& results) {
    const StiffnessAnswer& answer = *results.answer;
    const std::optional<double>& ratio = answer.relative_hardness;
    const std::string number = ratio ? "(H/(E g) = " + rounded(*ratio, 2) : "",
                      limit = rounded(parts::flowing_hardness);
    const std::string flow = "The peaks yield at first loading " + number + " is below " + limit + ")";
    if (answer.flows)
        return {flow + ": K is the unloading stiffness.",
                "Vibration and waves depend on K; the first static loading depends on the loading K/A0."};
    if (ratio && *ratio < parts::flowing_hardness)
        return {flow + ", but K is that of an elastic contact; for vibration and waves it is higher."};
    if (ratio)
        return {"The contact is elastic " + number + " is above " + limit +
                "): K is the same for loading, vibration and waves."};
    if (const auto& g = answer.curve.rms_gradient)
        return {"No hardness is given, so K is elastic; if H < " +
                with_unit(parts::flowing_hardness * results.modulus * *g, "Pa", 2) +
                ", peaks yield and K for vibration is higher."};
    return {};
}

/// Source and range of K beyond the names of the laws; may be empty.
std::string source_of(const Scene& scene, const StiffnessAnswer& answer) {
    const Curve& curve = answer.curve;
    const auto solved = [](const Law* law) { return law->which == LawName::boundary_elements; };
    const auto count = static_cast<std::size_t>(std::count_if(curve.by.begin(), curve.by.end(), solved));
    const auto& map = scene.face.map;
    const std::string missing = map ? missing_points(*map) : "", least = rounded(parts::min_points_in_contact);
    std::string text;
    if (!missing.empty())
        text = "K is computed from the numbers of the map: " + missing;
    else if (count > 0)
        text = "Boundary elements solve the map itself" +
               (count == curve.by.size() ? ""
                                         : " where " + least + " points touch; elsewhere K is computed from its peaks");
    else if (map && scene.face.spectrum_of_map)
        text = "K is computed from the map's summits and bearing curve";
    else if (scene.has_lay)
        text = "The profile repeats itself, like one across a lay: K may be up to " + rounded(parts::lay_factor) +
               " times higher; only a map shows this";
    if (const auto greatest = closed_above(scene, curve))
        text += (text.empty() ? "Above " : "; above ") + with_unit(*greatest, "Pa", 3) +
                " the contact is closed and the bulk carries the load";
    return text.empty() ? text : text + ".";
}

}  // namespace

std::optional<double> closed_above(const Scene& scene, const Curve& curve) {
    double greatest = 0;
    for (const auto& state : curve.states) greatest = std::max(greatest, state.pressure.value);
    if (scene.at_separations || curve.missed.empty() || scene.points[curve.missed.front().place] <= greatest) return {};
    return greatest;
}

std::string shown_causes(const AnswerReason& reason, std::size_t most) {
    const auto shares = parts::shares_of(reason.causes);
    std::array<std::size_t, parts::cause_count> order{};
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
    std::string text;
    for (std::size_t k = 0; k < most; ++k)
        if (const std::size_t i = order[k]; shares[i] >= 0.1)
            text += (text.empty() ? "" : ", ") + std::string(words_of(static_cast<parts::Cause>(i))) + " " +
                    shown_percent(shares[i]);
    return text;
}

std::string outside_band(const Scene& scene, const Results& results) {
    std::string text = "Not in the band: wear, dirt, films, misaligned faces";
    if (const bool whole = results.answer && results.answer->of_map_itself; whole || !scene.nominal_area)
        text += std::string(whole                           ? ", other pieces"
                            : measured_faces(scene).empty() ? ", few contacts"
                                                            : ", long waves") +
                " (give contact.nominal_area)";
    for (const auto& [name, face] : rough_faces(scene))
        if (!face->measured && face->process == parts::Process::unknown && face->is_open(parts::Unknown::skewness))
            return text +
                   "; for a worn or honed face K may be several times higher (give process, or skewness and "
                   "kurtosis).";
    return text + ".";
}

std::string measure_next(const Scene& scene, const Results& results) {
    if (!results.answer) return "";
    const Curve& curve = results.answer->curve;
    const std::vector<std::size_t> points = points_of_answer(scene);
    const auto at = curve.state_at(points[points.size() / 2]);
    if (!at || *at >= curve.band_parts.size()) return "";
    parts::Causes<double> others = results.answer->reasons[*at].causes;
    for (const auto one : {parts::Cause::shape, parts::Cause::prior}) others[static_cast<std::size_t>(one)] = {};
    const auto [low, high] = parts::band_of(others);
    const auto greatest = parts::greatest_unknown<double>(
        {.errors_low = low, .errors_high = high, .of_unknown = curve.band_parts[*at].of_unknown});
    if (!greatest || greatest->share < 0.1) return "";
    constexpr std::array<std::string_view, 4> names{"Rq or Sq", "Rdq or Sdq", "alpha", "D or H"};
    const auto what = !parts::is_of_shape(greatest->which) ? names[static_cast<std::size_t>(greatest->which)]
                      : measured_faces(scene).empty()      ? "skewness and kurtosis"
                                                           : "a longer profile or map";
    const double wide = std::log(curve.band[*at].high / curve.band[*at].low);
    return "measure " + std::string(what) + ": the band at " + with_unit(curve.states[*at].pressure.value, "Pa", 3) +
           " narrows from a factor of " + rounded(std::exp(wide), 2) + " to " +
           rounded(std::exp(greatest->narrower * wide), 2);
}

std::string origin_of_band(const Scene& scene) {
    if (scene.best) return "the 90 % band of the answer";
    std::string text;
    if (scene.face.has_measured_errors())
        text = "; " + rounded(scene.samples) + " surfaces sampled from the errors, seed " + std::to_string(scene.seed);
    if (!scene.face.neighbours.empty()) text += "; the choice of lambda_s";
    if (!scene.face.priors.empty()) text += "; unknown parameters of the surface";
    return text.substr(std::min<std::size_t>(2, text.size()));
}

Explanation explanation(const Scene& scene, const Results& results) {
    if (!results.answer) return {};
    const StiffnessAnswer& answer = *results.answer;
    Explanation all{nature(results), {}};
    if (std::string source = source_of(scene, answer); !source.empty()) all.sentences.push_back(std::move(source));
    const std::optional<double>& hardness = answer.relative_hardness;
    all.shorter = {answer.flows                          ? "The peaks yield: K is that of unloading."
                   : !hardness                           ? "Taken as elastic: no hardness is given."
                   : *hardness < parts::flowing_hardness ? "The peaks yield, but K is that of an elastic contact."
                                                         : "The contact is elastic."};
    if (scene.has_lay) all.shorter = {"A profile across a lay does not determine K."};
    return all;
}

}  // namespace fstiff::scene
