// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/surface/band_spectrum.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::scene {

using detail::Lack, detail::Origin;

std::vector<NamedFace> named_faces(const Scene& scene) {
    const auto measured = [&](std::size_t i) { return i < scene.measured.size() ? scene.measured[i].get() : nullptr; };
    if (scene.faces.empty()) return {{"surface", &scene.face, measured(0)}};
    return {{"upper", &scene.faces[0], measured(0)}, {"lower", &scene.faces[1], measured(1)}};
}

std::vector<Assumed> assumed(const Scene& scene) {
    std::vector<Assumed> assumptions;
    const bool of_map = scene.face.map && scene.face.spectrum_of_map;
    if (of_map ||
        std::none_of(scene.laws.begin(), scene.laws.end(), [](const detail::Law* law) { return law->needs_spectrum; }))
        return assumptions;
    if (!scene.face.hurst) {
        const double hurst = hurst_exponent(scene.face),
                     least = detail::least_hurst(spectral_moments(scene.face), scene.face.widest_band);
        assumptions.push_back({"hurst", "Hurst",
                               hurst == least           ? "of a band as wide as what was measured"
                               : scene.face.dimension() ? "2 - D"
                                                        : "assumed, since D is not known",
                               hurst});
    }
    if (!scene.face.alpha)
        assumptions.push_back({"alpha", "alpha",
                               scene.face.rms_gradient ? "of sigma, R and rms_gradient" : "of sigma, R and D_p",
                               spectral_moments(scene.face).bandwidth()});
    return assumptions;
}

std::vector<NamedFace> measured_files(const Scene& scene) {
    std::vector<NamedFace> faces = named_faces(scene);
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
    const std::string of_process =
        face.process == Process::unknown ? "of any process" : "of a " + std::string(name_of(face.process)) + " face";
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

std::string phrase_of_hardness(const Scene& scene) {
    const auto& [low, middle, high] = *scene.hardness_range;
    const auto name = [](const NamedMaterial* material) { return std::string(material ? material->name : ""); };
    const std::string upper = name(scene.upper_name), lower = name(scene.lower_name);
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

std::string refusal_of(const detail::Law& law, const Scene& scene) {
    const std::string name(scene.upper_name ? scene.upper_name->name : "");
    const std::string section = name.empty() ? "" : "; name = \"" + name + "\" in that section keeps the rest";
    switch (const Lack lack = lack_of(law, scene, scene.at_separations)) {
        case Lack::nothing: return "";
        case Lack::separation: return detail::reason_of(lack) + "; give contact.pressures";
        case Lack::peaks:
            return "needs surface.peak_radius and surface.peak_density, which are not known: " +
                   scene.face.parameters.why_no_density;
        case Lack::map:
            return "needs a map: surface.from, or --surface, must name the file of one (the JSON of fstiff measure "
                   "holds its numbers alone)";
        case Lack::sum_of_maps:
            return "needs two maps of one grid, whose heights can be added: " +
                   no_sum_of_maps(scene.faces.front(), scene.faces.back());
        case Lack::side: return detail::reason_of(lack);
        case Lack::hardness:
            return "needs material.upper.hardness or material.upper.yield_strength (hardness = 2.8 times it)" + section;
        case Lack::yield_strength: return "needs material.upper.yield_strength" + section;
        default:
            return (law.needs_whole_map ? "needs a map without missing points: "
                    : law.needs_summits ? "needs summits: "
                                        : "needs a spectrum: ") +
                   no_spectrum(scene.face, lack);
    }
}

std::vector<const detail::Law*> offered_laws(const Scene& scene) {
    if (!scene.best) return scene.laws;
    std::vector<const detail::Law*> laws;
    for (const ChosenLaw& law : detail::all_laws())
        if (refusal_of(law.row(), scene).empty()) laws.push_back(&law.row());
    return laws;
}

std::vector<std::size_t> points_of_answer(const Scene& scene) {
    constexpr std::size_t most = 12;
    const std::vector<double>& points = scene.points;
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double decade = points[i] > 0 ? std::log10(points[i]) : 0.5;
        const bool is_decade = !scene.at_separations && std::abs(decade - std::round(decade)) < 1e-6;
        if (scene.listed || points.size() <= most || is_decade || points[i] == *least || points[i] == *greatest)
            chosen.push_back(i);
    }
    if (chosen.size() > 2 || points.size() <= most) return chosen;
    constexpr std::size_t few = 4;  // of separations, or of a range without a decade
    chosen.clear();
    for (std::size_t k = 0; k < few; ++k) chosen.push_back((k * (points.size() - 1) + 1) / (few - 1));
    return chosen;
}

detail::Request request_of(const Scene& scene) {
    detail::Request request{.points = scene.points,
                            .at_separations = scene.at_separations,
                            .answered = points_of_answer(scene),
                            .approach = scene.asks(CurveQuantity::approach),
                            .log_slopes = scene.asks(CurveQuantity::loss_factor),
                            .seating = scene.seating,
                            .samples = scene.samples,
                            .seed = scene.seed,
                            .solves_map = scene.solves_map};
    if (scene.best) return request;
    request.laws = scene.laws;
    request.quantities = Quantity::pressure | Quantity::separation;
    const auto add = [&](bool wanted, Quantity more) {
        if (wanted) request.quantities = request.quantities | more;
    };
    add(scene.needs_stiffness(), Quantity::stiffness);
    add(scene.asks(CurveQuantity::real_area) || scene.conduction.thermal_film > 0 ||
            scene.conduction.electrical_film > 0,
        Quantity::real_area_fraction);
    add(scene.asks(CurveQuantity::contacts), Quantity::contact_density | Quantity::real_area_fraction);
    add(scene.asks(CurveQuantity::loading_stiffness), Quantity::loading_stiffness);
    return request;
}

}  // namespace fstiff::scene
