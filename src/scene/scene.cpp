// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene.hpp"

#include "document/file.hpp"

#include <algorithm>

namespace fstiff::scene {
std::vector<NamedFace> rough_faces(const Scene& scene) {
    if (scene.faces.empty()) return {{"surface", &scene.face}};
    return {{"upper", &scene.faces[0]}, {"lower", &scene.faces[1]}};
}

std::vector<Assumed> assumed(const Scene& scene) {
    std::vector<Assumed> all;
    const bool of_map = scene.face.map && scene.face.spectrum_of_map;
    if (of_map ||
        std::none_of(scene.laws.begin(), scene.laws.end(), [](const Law* law) { return law->needs_spectrum; }))
        return all;
    if (!scene.face.hurst) {
        const double hurst = hurst_exponent(scene.face),
                     least = parts::least_hurst(spectral_moments(scene.face), scene.face.widest_band);
        all.push_back({"hurst", "H",
                       hurst == least           ? "of a band as wide as what was measured"
                       : scene.face.dimension() ? "2 - D"
                                                : "assumed, since D is not known",
                       hurst});
    }
    if (!scene.face.alpha)
        all.push_back({"alpha", "alpha",
                       scene.face.rms_gradient ? "of sigma, R and rms_gradient" : "of sigma, R and D_p",
                       spectral_moments(scene.face).bandwidth()});
    return all;
}

std::vector<NamedFace> measured_faces(const Scene& scene) {
    std::vector<NamedFace> all = rough_faces(scene);
    std::erase_if(all, [](const NamedFace& one) { return !one.face->measured; });
    return all;
}

PeakDistribution<double> peak_density(const Peaks& peaks) {
    try {
        return peaks.r ? PeakDistribution<double>(*peaks.r, peaks.theta)
                       : PeakDistribution<double>::exponential(peaks.theta);
    } catch (const domain_error& error) {
        throw error.with_parameter(peaks.key + std::string(error.parameter())).with_place(peaks.where);
    }
}

bool flows(const Scene& scene, const Law& law) {
    return law.needs_hardness || law.needs_yield || (law.needs_whole_map && scene.law_options.hardness > 0);
}

std::string refusal_of(const Law& law, const Scene& scene) {
    if (scene.at_separations && !parts::has(law.quantities, Quantity::separation))
        return "gives no separation; give contact.pressures";
    if (law.needs_radius() && !scene.face.has_radius_and_density())
        return "needs surface.peak_radius and surface.peak_density, which are not known: " +
               scene.face.parameters.why_no_density;
    if (law.needs_map && !scene.face.map)
        return scene.faces.empty() ? "needs a map: surface.from, or --surface, must name the file of one (the JSON of "
                                     "fstiff measure holds its numbers alone)"
                                   : "needs two maps of one grid, whose heights can be added: " +
                                         no_sum_of_maps(scene.faces.front(), scene.faces.back());
    if (law.needs_summits && scene.face.map->summits.front().summits.empty())
        return "needs summits: no point of the map is above its eight neighbours";
    if (law.needs_whole_map) {
        if (const std::string missing = missing_points(*scene.face.map); !missing.empty())
            return "needs a map without missing points: " + missing;
        for (const auto& map : scene.face.map->maps)
            if (std::min(map->rows(), map->columns()) < 16) return "needs a map of at least 16 points a side";
    }
    if (law.needs_spectrum)
        if (const std::string why = no_spectrum(scene.face); !why.empty()) return "needs a spectrum: " + why;
    const std::string name(scene.upper_name ? scene.upper_name->name : "");
    const std::string section = name.empty() ? "" : "; name = \"" + name + "\" in that section keeps the rest";
    if (law.needs_hardness && !scene.hardness && !scene.yield_strength)
        return "needs material.upper.hardness or material.upper.yield_strength (hardness = 2.8 times it)" + section;
    if (law.needs_yield && !scene.yield_strength) return "needs material.upper.yield_strength" + section;
    return "";
}

std::vector<const Law*> offered_laws(const Scene& scene) {
    if (!scene.best) return scene.laws;
    std::vector<const Law*> all;
    for (const Law& law : laws())
        if (refusal_of(law, scene).empty()) all.push_back(&law);
    return all;
}

}  // namespace fstiff::scene
