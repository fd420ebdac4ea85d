// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/lacks.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <cmath>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <string>

namespace fstiff { inline namespace v0_1 { namespace detail {

FSTIFF_INLINE Lack lack_of_spectrum(const Face& face) {
    if (face.map && face.spectrum_of_map) {
        if (missing_points(*face.map) > 0) return Lack::points;
        return !face.map->spectra                          ? Lack::small_map
               : face.map->summits.front().summits.empty() ? Lack::summits
                                                           : Lack::nothing;
    }
    if (!face.has_radius_and_density() && !(face.rms_gradient && face.alpha)) return Lack::moments;
    const SpectralMoments<double> moments = spectral_moments(face);
    const double alpha = moments.bandwidth();
    for (const double number : {moments.m0, moments.m2, moments.m4, alpha})
        if (!(number > 0) || !std::isfinite(number)) return Lack::range;
    return alpha > 1.5 ? Lack::nothing : Lack::alpha;
}

FSTIFF_INLINE Lack lack_of(const Law& law, const ResolvedJoint& problem, bool at_separations) {
    const Face& face = problem.face;
    if (at_separations && !detail::has(law.quantities, Quantity::separation)) return Lack::separation;
    if (law.needs_radius() && !face.has_radius_and_density()) return Lack::peaks;
    if (law.needs_map && !face.map) return problem.faces.empty() ? Lack::map : Lack::sum_of_maps;
    if (law.needs_summits && face.map->summits.front().summits.empty()) return Lack::summits;
    if (law.needs_whole_map) {
        if (missing_points(*face.map) > 0) return Lack::points;
        for (const auto& map : face.map->maps)
            if ((std::min)(map->rows(), map->columns()) < 16) return Lack::side;
    }
    if (law.needs_spectrum)
        if (const Lack lack = lack_of_spectrum(face); lack != Lack::nothing) return lack;
    if (law.needs_hardness && !(hardness_of(problem) > 0 && std::isfinite(hardness_of(problem)))) return Lack::hardness;
    return law.needs_yield && !problem.yield_strength ? Lack::yield_strength : Lack::nothing;
}

FSTIFF_INLINE std::string reason_of(Lack lack) {
    switch (lack) {
        case Lack::nothing: break;
        case Lack::separation: return "gives no separation";
        case Lack::peaks: return "needs peak_radius and peak_density, which are not known";
        case Lack::map: return "needs a measured map";
        case Lack::sum_of_maps: return "needs two measured maps of one grid";
        case Lack::summits: return "needs summits: no point of the map is above its eight neighbours";
        case Lack::points: return "needs a map without missing points, such as one whose points were filled";
        case Lack::side: return "needs a map of at least 16 points a side";
        case Lack::small_map: return "needs a map of at least 4 points a side";
        case Lack::moments: return "needs a spectrum: rms_gradient and alpha, or peak_radius and peak_density";
        case Lack::range: return "needs moments in the range of double precision";
        case Lack::alpha: return "needs an alpha above 1.5, which rms_height, peak_radius and peak_density must make";
        case Lack::hardness: return "needs a body with a finite hardness";
        case Lack::yield_strength: return "needs yield_strength of a body";
    }
    return "";
}

FSTIFF_INLINE void require_possible(const Law& law, const ResolvedJoint& problem, bool at_separations) {
    const std::string name = "law " + std::string(law.name) + ": ";
    if (law.needs_dimension && !problem.face.dimension()) throw domain_error(name + "needs fractal_dimension");
    if (const Lack lack = lack_of(law, problem, at_separations); lack != Lack::nothing)
        throw domain_error(name + reason_of(lack));
}

FSTIFF_INLINE const Law& possible_law(const ChosenLaw& law, const ResolvedJoint& problem, bool at_separations) {
    if (!law.row) throw domain_error("law: must be one of " + choices_text<LawKind>());
    require_possible(law.row(), problem, at_separations);
    return law.row();
}

FSTIFF_INLINE std::vector<Peaks> peaks_of(const Law& law, const ResolvedJoint& problem) {
    if (!law.has_peaks) return {};
    if (!problem.default_peaks || law.needs_dimension || !has_isotropic_peaks(problem.face)) return problem.peaks;
    const auto peaks = PeakDistribution<double>::isotropic(spectral_moments(problem.face).bandwidth());
    return {{.theta = peaks.theta(), .r = peaks.r(), .key = "contact.peaks."}};
}

}}}  // namespace fstiff::detail
