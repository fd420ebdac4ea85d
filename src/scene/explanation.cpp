// SPDX-License-Identifier: BSD-3-Clause
#include "scene/explanation.hpp"

#include "document/shown_unit.hpp"

#include <fstiff/measured/unmeasured_waves.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

/// " of copper", where one body alone has a hardness and the other is copper; else empty.
std::string of_open_body(const Scene& scene) { return scene.open_body.empty() ? "" : " of " + scene.open_body; }

/// The kind of stiffness that K is, and where it applies.
std::vector<std::string> nature(const Scene& scene, const Results& results) {
    const StiffnessAnswer& answer = *results.answer;
    const std::optional<double>& ratio = answer.relative_hardness;
    const std::string limit = rounded(parts::flowing_hardness);
    int digits = 2;  // as many as differ from the limit
    while (ratio && digits < 9 && rounded(*ratio, digits) == limit) ++digits;
    const std::string number = ratio ? "(H/(E g) = " + rounded(*ratio, digits) : "";
    const std::string flow = "The peaks yield at first loading " + number + " is below " + limit + ")";
    const bool loads = std::any_of(answer.reasons.begin(), answer.reasons.end(),
                                   [](const AnswerReason& one) { return one.loading_stiffness.has_value(); });
    if (answer.flows)
        return {flow + ": K is the unloading stiffness.",
                std::string("Vibration and waves depend on K; the first static loading ") +
                    (loads ? "depends on the loading K/A0." : "has another, which is not known.")};
    if (ratio && *ratio < parts::flowing_hardness)
        return {flow + ", but K is that of an elastic contact; for vibration and waves it is higher."};
    if (ratio)
        return {"The contact is elastic " + number + " is above " + limit +
                "): K is the same for loading, vibration and waves."};
    if (scene.open_body.empty() && (scene.hardness || scene.yield_strength))
        return {
            "The gradient of the surface is not known, so K is elastic; where peaks yield K for vibration is higher."};
    if (const auto& g = answer.curve.rms_gradient)
        return {"No hardness" + of_open_body(scene) + " is given, so K is elastic; if H < " +
                with_unit(parts::flowing_hardness * scene.effective_modulus * *g, "Pa", 2) +
                ", peaks yield and K for vibration is higher."};
    return {"No hardness" + of_open_body(scene) +
            " is given, so K is elastic; where peaks yield K for vibration is higher."};
}

/// Source of K beyond the names of the laws; may be empty.
std::string source_of(const Scene& scene, const StiffnessAnswer& answer) {
    const Curve& curve = answer.curve;
    const auto solved = [](const Law* law) { return law->which == LawName::boundary_elements; };
    const auto count = static_cast<std::size_t>(std::count_if(curve.by.begin(), curve.by.end(), solved));
    const auto& map = scene.face.map;
    const std::string missing = missing_phrase(scene.face), least = rounded(parts::min_points_in_contact);
    std::string text;
    if (!missing.empty())
        text = "K is computed from the map's numbers: " + missing;
    else if (count > 0)
        text = "Boundary elements solve the map itself" +
               (count == curve.by.size()
                    ? ""
                    : (points_of_answer(scene).size() < scene.points.size() ? " at the pressures of the summary" : "") +
                          std::string(" where ") + least +
                          " points touch; elsewhere K is computed from its summits and bearing "
                          "curve");
    else if (map && scene.face.spectrum_of_map)
        text = curve.law->needs_spectrum
                   ? "K is computed from the map's summits and bearing curve"
                   : "K is computed from R and D_p of the map, which has no summits for law hybrid";
    else if (has_lay(scene))
        text = "The profile repeats itself, like one across a lay: K may be up to " + rounded(parts::lay_factor) +
               " times higher; only a map shows this";
    return text.empty() ? text : text + ".";
}

/// A measurement, and the factor between the ends of the band at one point once it was made.
struct Measuring {
    std::string what;
    double factor = 0;
};

/// The factor at the point \p place of \p scene once \p which of its faces is known; infinite without a band.
double factor_of(Scene scene, std::size_t place, parts::Unknown which) {
    scene.best = true;
    scene.points = {scene.points[place]};
    if (!scene.forces.empty()) scene.forces = {scene.forces[place]};
    for (Face& face : scene.faces) face = with_measured(std::move(face), which);
    scene.face = with_measured(std::move(scene.face), which);
    try {
        Request request = request_of(scene);
        request.checked = false;
        const LawCurve curve = *curves_of(scene, request).answer;
        if (!curve.band.empty()) return curve.band.front().high / curve.band.front().low;
    } catch (const domain_error&) {  // as where some drawn surfaces have other peaks than the rest
    }
    return std::numeric_limits<double>::infinity();
}

/// The factor that \p reason makes of a profile or map four times as large: half the errors, and fewer waves that are
/// longer.
double factor_of_larger(const Scene& scene, const AnswerReason& reason, bool itself) {
    parts::Causes<double> causes = reason.causes;
    const auto scale = [&](parts::Cause cause, double by) {
        auto& one = causes[static_cast<std::size_t>(cause)];
        one = {by * one.low, by * one.high};
    };
    scale(parts::Cause::measurement, 0.5), scale(parts::Cause::shape, 0.5);
    if (scene.nominal_area && !itself) {
        parts::LongEnd<double> end = scene.face.parameters.long_end;
        end.side *= measured_faces(scene).front()->measured->is_profile ? 4 : 2, end.error /= 2;
        causes[static_cast<std::size_t>(parts::Cause::long_waves)] = {
            -parts::unmeasured_waves(end, std::sqrt(*scene.nominal_area)).growth, 0};
    } else {
        scale(parts::Cause::contacts, measured_faces(scene).front()->measured->is_profile ? 0.25 : 0.5);
    }
    const auto [low, high] = parts::band_of(causes);
    return std::exp(high - low);
}

/// Measurements that narrow the band of the answer at its state \p at.
std::vector<Measuring> measurings(const Scene& scene, const Results& results, std::size_t at) {
    using parts::Unknown;
    std::vector<Measuring> all;
    const bool map = scene.face.map && scene.face.spectrum_of_map, measured = !measured_faces(scene).empty();
    const std::size_t place = results.answer->curve.places[at];
    const bool lay = parts::prior_of(rough_faces(scene).front()->process).has_lay;
    const std::pair<Unknown, const char*> candidates[]{{Unknown::height, "Rq or Sq"},
                                                       {Unknown::gradient, lay ? "Sdq" : "Sdq or Rdq"},
                                                       {Unknown::alpha, "alpha"},
                                                       {Unknown::hurst, "D or H"},
                                                       {Unknown::skewness, "skewness and kurtosis"}};
    for (const auto& [which, what] : candidates)
        if (!map && scene.face.is_open(which) && !(measured && parts::is_of_shape(which)))
            all.push_back(
                {what + std::string(scene.faces.empty() ? "" : " of both faces"), factor_of(scene, place, which)});
    if (measured && !results.answer->of_map_itself)
        all.push_back(
            {measured_faces(scene).front()->measured->is_profile ? "four times the length" : "four times the area",
             factor_of_larger(scene, results.answer->reasons[at], false)});
    return all;
}

}  // namespace

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
    if (!scene.nominal_area)
        text += std::string(results.answer && results.answer->of_map_itself ? ", other parts of the face"
                            : measured_faces(scene).empty()                 ? ", few contacts"
                                                                            : ", long waves") +
                " (give contact.nominal_area)";
    for (const Face* face : rough_faces(scene))
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
    if (!at) return "";
    const double wide = std::log(curve.band[*at].high / curve.band[*at].low);
    Measuring most{"", 0.95 * std::exp(wide)};  // nothing that narrows the factor by less
    for (const Measuring& one : measurings(scene, results, *at))
        if (one.factor < most.factor) most = one;
    if (most.what.empty()) return "";
    const auto factor = [&](double value) {
        return rounded(value, rounded(std::exp(wide), 2) == rounded(most.factor, 2) ? 3 : 2);
    };
    return "measure " + most.what + ": the band at " + with_unit(curve.states[*at].pressure.value, "Pa", 3) +
           " narrows from a factor of " + factor(std::exp(wide)) + " to " + factor(most.factor);
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
    Explanation all{nature(scene, results), {}};
    if (std::string source = source_of(scene, answer); !source.empty()) all.sentences.push_back(std::move(source));
    const std::optional<double>& hardness = answer.relative_hardness;
    all.shorter = {answer.flows ? std::string("The peaks yield: K is that of unloading.")
                   : !hardness  ? "Taken as elastic: no hardness" + of_open_body(scene) + " is given."
                   : *hardness < parts::flowing_hardness ? "The peaks yield, but K is that of an elastic contact."
                                                         : "The contact is elastic."};
    if (has_lay(scene)) all.shorter = {"A profile across a lay does not determine K."};
    return all;
}

}  // namespace fstiff::scene
