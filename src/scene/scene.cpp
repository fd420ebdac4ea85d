// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/surface/band_spectrum.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fstiff::scene {

using detail::Lack, detail::Origin;

std::vector<NamedFace> Scene::named_faces() const {
    const auto file = [&](std::size_t i) { return i < measured.size() ? measured[i].get() : nullptr; };
    if (joint.faces.empty()) return {{"surface", &joint.face, file(0)}};
    return {{"upper", &joint.faces[0], file(0)}, {"lower", &joint.faces[1], file(1)}};
}

std::vector<Assumed> Scene::assumed() const {
    std::vector<Assumed> assumptions;
    const bool of_map = joint.face.map && joint.face.spectrum_of_map;
    if (of_map || std::none_of(laws.begin(), laws.end(), [](const detail::Law* law) { return law->needs_spectrum; }))
        return assumptions;
    if (!joint.face.hurst) {
        const double hurst = hurst_exponent(joint.face),
                     least = detail::least_hurst(spectral_moments(joint.face), joint.face.widest_band);
        assumptions.push_back({"hurst", "Hurst",
                               hurst == least           ? "of a band as wide as what was measured"
                               : joint.face.dimension() ? "2 - D"
                                                        : "assumed, since D is not known",
                               hurst});
    }
    if (!joint.face.alpha)
        assumptions.push_back({"alpha", "alpha",
                               joint.face.rms_gradient ? "of sigma, R and rms_gradient" : "of sigma, R and D_p",
                               spectral_moments(joint.face).bandwidth()});
    return assumptions;
}

std::vector<NamedFace> Scene::measured_files() const {
    std::vector<NamedFace> faces = named_faces();
    std::erase_if(faces, [](const NamedFace& named_face) { return !named_face.measured; });
    return faces;
}

std::string phrase_of(const detail::Prior& prior, const detail::Face& face) {
    const auto name = [&]() -> std::string_view {
        switch (prior.which) {
            case Unknown::height: return prior.origin == Origin::mean_height ? "Ra/Rq" : "Sa/Sq";
            case Unknown::gradient: return "rms gradient";
            case Unknown::alpha: return "alpha";
            case Unknown::hurst: return "Hurst";
            case Unknown::hardness: break;  // of no face
            case Unknown::skewness: return "skewness";
            case Unknown::kurtosis: return "kurtosis";
        }
        return "";
    };
    const std::string worn = face.worn ? "worn " : "", process(name_of(face.process)),
                      of_process = face.process != Process::unknown ? "of a " + worn + process + " face"
                                   : face.worn                      ? "of a worn face"
                                                                    : "of any process";
    const auto from = [&]() -> std::string {
        switch (prior.origin) {
            case Origin::islands: return "of peak_radius and peak_density as those of islands";
            case Origin::spacing: return "of RSm, which counts the long waves alone";
            case Origin::slope: return "of Rdq across the lay " + of_process;
            case Origin::measurement: return "";
            default: return of_process;
        }
    };
    const auto& [low, middle, high] = prior.range;
    if (prior.origin == Origin::measurement) return "";
    return std::string(name()) + " " + document::rounded(middle, 2) + " (" + document::rounded(low, 2) + " to " +
           document::rounded(high, 2) + "), " + from();
}

std::string Scene::phrase_of_hardness() const {
    const auto& [low, middle, high] = *joint.hardness_range;
    const auto name = [](const NamedMaterial* material) { return std::string(material ? material->name : ""); };
    const std::string upper = name(upper_name), lower = name(lower_name);
    return "hardness " + document::with_unit(middle, "Pa", 2) + " (" + document::with_unit(low, "Pa", 2) + " to " +
           document::with_unit(high, "Pa", 2) + "), of " +
           (upper.empty() || lower.empty() ? "the softer body"
            : upper == lower               ? upper
                                           : "the softer of " + upper + " and " + lower);
}

std::string missing_phrase(const detail::Face& face) {
    const Eigen::Index missing = face.map ? missing_points(*face.map) : 0;
    if (missing == 0) return "";
    return std::to_string(missing) + (missing == 1 ? " point is" : " points are") +
           " missing; fill = true next to surface.from, or --fill, fills them";
}

namespace {

/// Why \p face has no spectrum, by \p lack.
std::string no_spectrum(const detail::Face& face, Lack lack) {
    switch (lack) {
        case Lack::points: return missing_phrase(face);
        case Lack::small_map: return "the map has fewer than 4 points a side";
        case Lack::summits: return "no point of the map is above its eight neighbours";
        case Lack::moments: return "R and D_p of the surface are not known: " + face.parameters.why_no_density;
        case Lack::range:
            return "the moments of rms_height, R, D_p and rms_gradient are beyond the range of double precision; these "
                   "numbers must be less extreme";
        default:
            return "rms_height, R and D_p make alpha = m0 m4/m2^2 = " +
                   document::rounded(spectral_moments(face).bandwidth(), 3) +
                   ", but isotropic surfaces have more than 1.5; set " +
                   (face.rms_gradient ? "surface.alpha" : "surface.rms_gradient and surface.alpha");
    }
}

}  // namespace

std::string Scene::refusal_of(const detail::Law& law) const {
    const std::string name(upper_name ? upper_name->name : "");
    const std::string section = name.empty() ? "" : "; name = \"" + name + "\" in that section keeps the rest";
    switch (const Lack lack = lack_of(law, joint, at_separations)) {
        case Lack::nothing: return "";
        case Lack::separation: return detail::reason_of(lack) + "; give contact.pressures";
        case Lack::peaks:
            return "needs surface.peak_radius and surface.peak_density, which are not known: " +
                   joint.face.parameters.why_no_density;
        case Lack::map:
            return "needs a map: surface.from, or --surface, must name the file of one (the JSON of fstiff measure "
                   "holds its numbers alone)";
        case Lack::sum_of_maps:
            return "needs two maps of one grid, whose heights can be added: " +
                   no_sum_of_maps(joint.faces.front(), joint.faces.back());
        case Lack::side: return detail::reason_of(lack);
        case Lack::hardness:
            return "needs material.upper.hardness or material.upper.yield_strength (hardness = 2.8 times it)" + section;
        case Lack::yield_strength: return "needs material.upper.yield_strength" + section;
        default:
            return (law.needs_whole_map ? "needs a map without missing points: "
                    : law.needs_summits ? "needs summits: "
                                        : "needs a spectrum: ") +
                   no_spectrum(joint.face, lack);
    }
}

std::vector<const detail::Law*> Scene::offered_laws() const {
    if (!best) return laws;
    std::vector<const detail::Law*> possible;
    for (const ChosenLaw& law : detail::all_laws())
        if (refusal_of(law.row()).empty()) possible.push_back(&law.row());
    return possible;
}

std::vector<std::size_t> Scene::points_of_answer() const {
    constexpr std::size_t most = 12;
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double decade = points[i] > 0 ? std::log10(points[i]) : 0.5;
        const bool is_decade = !at_separations && std::abs(decade - std::round(decade)) < 1e-6;
        if (listed || points.size() <= most || is_decade || points[i] == *least || points[i] == *greatest)
            chosen.push_back(i);
    }
    if (chosen.size() > 2 || points.size() <= most) return chosen;
    constexpr std::size_t few = 4;  // of separations, or of a range without a decade
    chosen.clear();
    for (std::size_t k = 0; k < few; ++k) chosen.push_back((k * (points.size() - 1) + 1) / (few - 1));
    return chosen;
}

AnswerOptions Scene::options() const {
    AnswerOptions options{.quantities = {quantities.begin(), quantities.end()},
                          .samples = samples,
                          .seed = seed,
                          .solve_map = solves_map,
                          .seating = seating,
                          .at_separations = at_separations,
                          .places = points_of_answer(),
                          .pressure_text = [](double pressure) { return document::with_unit(pressure, "Pa", 3); }};
    if (best) return options;
    for (const detail::Law* law : laws)
        for (const ChosenLaw& each : detail::all_laws())
            if (each.which == law->which) options.laws.push_back(each);
    return options;
}

std::string Scene::shown_point(std::size_t i) const {
    const std::string point = document::with_unit(points[i], at_separations ? "m" : "Pa", 3);
    return forces.empty() ? point : document::with_unit(forces[i], "N", 3) + ", " + point;
}

bool Scene::needs_stiffness() const {
    return std::any_of(quantities.begin(), quantities.end(), [](const std::string& word) {
        return detail::quantity_called(word).of_law == Quantity::stiffness;
    });
}

double NumberOf::operator()(const AnswerPoint& point) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const AnswerPoint::Value* value = point.find(quantity->word);
    if (!value) return none;
    if (part.empty()) return value->number.value;
    if (part == "_error") return value->error;
    return part == "_p05" ? value->number.low : value->number.high;
}

std::vector<NumberOf> Scene::columns(bool bands) const {
    std::vector<NumberOf> columns;
    for (const AnswerQuantity& quantity : answer_quantities()) {
        if (!asks(quantity.word)) continue;
        columns.push_back({&quantity});
        if (!quantity.follows_stiffness()) continue;
        columns.push_back({&quantity, "_error"});
        if (!bands) continue;
        columns.push_back({&quantity, "_p05"});
        columns.push_back({&quantity, "_p95"});
    }
    return columns;
}

NumberOf number_called(std::string_view key, std::string_view name) {
    std::string keys;
    for (const AnswerQuantity& quantity : answer_quantities()) {
        for (const std::string_view part : {"", "_error", "_p05", "_p95"})
            if ((part.empty() || quantity.follows_stiffness()) && quantity.key(part) == key) return {&quantity, part};
        keys += (keys.empty() ? "" : ", ") + quantity.key();
    }
    throw domain_error(std::string(name) + " = \"" + std::string(key.substr(0, 60)) + "\": must be one of " + keys +
                       ", with _p05 or _p95 before the unit for an end of a band");
}

std::vector<const AnswerQuantity*> words_for_quantities() {
    std::vector<const AnswerQuantity*> words;
    for (const AnswerQuantity& quantity : answer_quantities())
        if (quantity.place > 0) words.push_back(&quantity);
    std::sort(words.begin(), words.end(), [](auto* a, auto* b) { return a->place < b->place; });
    return words;
}

}  // namespace fstiff::scene
