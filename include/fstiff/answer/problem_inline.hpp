// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/problem.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/problem.hpp>
#include <fstiff/answer/state_table.hpp>
#include <fstiff/asperity/plastic_laws.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fstiff::inline v0_1::detail {

FSTIFF_INLINE PeakDistribution<double> peak_density(const Peaks& peaks) {
    try {
        return peaks.r ? PeakDistribution<double>(*peaks.r, peaks.theta)
                       : PeakDistribution<double>::exponential(peaks.theta);
    } catch (const domain_error& error) {
        throw error.with_parameter(peaks.key + std::string(error.parameter())).with_place(peaks.where);
    }
}

FSTIFF_INLINE std::vector<const Face*> rough_faces(const Problem& problem) {
    if (problem.faces.empty()) return {&problem.face};
    return {&problem.faces[0], &problem.faces[1]};
}

FSTIFF_INLINE std::vector<const Face*> measured_faces(const Problem& problem) {
    std::vector<const Face*> faces = rough_faces(problem);
    std::erase_if(faces, [](const Face* face) { return !face->measured; });
    return faces;
}

FSTIFF_INLINE bool is_of_traces(const Problem& problem) {
    const std::vector<const Face*> faces = measured_faces(problem);
    return !faces.empty() &&
           std::all_of(faces.begin(), faces.end(), [](const Face* face) { return face->measured->is_profile; });
}

FSTIFF_INLINE bool has_lay(const Problem& problem) {
    const std::vector<const Face*> measured = measured_faces(problem);
    return std::any_of(measured.begin(), measured.end(),
                       [](const Face* face) { return detail::is_profile_with_lay(*face->measured); });
}

FSTIFF_INLINE std::optional<double> gradient(const Problem& problem) {
    const Face& face = problem.face;
    if (face.map && face.spectrum_of_map && face.map->spectra)
        return face.map->taller * face.map->spectra->shells(problem.law_options.edges).rms_gradient();
    if (face.has_own_gradient()) return face.rms_gradient;
    if (face.has_peaks())
        if (const auto of_own = detail::rms_gradient(
                face.roughness(), PeakDistribution(face.parameters.r->value, face.parameters.theta->value)))
            return of_own;
    if (face.rms_gradient) return face.rms_gradient;
    if (lack_of_spectrum(face) == Lack::nothing) return std::sqrt(2 * spectral_moments(face).m2);
    std::optional<double> of_peaks;
    for (const Peaks& peaks : problem.peaks)
        if (const auto gradient = detail::rms_gradient(face.roughness(), peak_density(peaks))) of_peaks = gradient;
    return of_peaks;
}

FSTIFF_INLINE Interaction<double> interaction(const Problem& problem) {
    Interaction<double> result;
    result.reading = problem.reading;
    if (result.reading != InteractionReading::none)
        result.length = problem.length == InteractionLength::nominal
                            ? detail::interaction_length_of_area(*problem.nominal_area)
                        : problem.length == InteractionLength::peak_spacing
                            ? detail::interaction_length_of_peaks(problem.face.parameters.peak_density.value)
                            : problem.given_length;
    return result;
}

/// The hardness of \p body [Pa]: given, by Tabor's factor 2.8 (1951), or its range.
FSTIFF_INLINE PriorRange hardness_of(const Body& body) {
    const auto known = [](double value) { return PriorRange{value, value, value}; };
    if (body.hardness) return known(*body.hardness);
    if (body.yield_strength) return known(detail::hardness_over_yield_strength<double> * *body.yield_strength);
    return body.hardness_range.value_or(detail::hardness_of_elastic(body.elastic));
}
/// Of the bodies of one material it is one number.
FSTIFF_INLINE PriorRange softer_hardness(const Body& upper, const Body& lower) {
    const auto a = hardness_of(upper), b = hardness_of(lower);
    const bool same = a.low == b.low && a.middle == b.middle && a.high == b.high;
    return same ? a : detail::softer(a, b);
}

/// The hardness of the joint, \p range, whose softer body is \p softer.
FSTIFF_INLINE void take_hardness(const Body& softer, const PriorRange& range, Problem& problem) {
    problem.hardness = softer.hardness, problem.hardness_range.reset();
    if (range.low < range.high)
        problem.hardness.reset(), problem.hardness_range = range;
    else if (!std::isfinite(range.middle))
        problem.hardness = range.middle;
}

FSTIFF_INLINE void take_bodies(const Body& upper, const Body& lower, const std::optional<double>& modulus,
                               Problem& problem) {
    if (modulus) {
        Body of_contact = upper;  // two bodies of one metal
        of_contact.elastic = {2 * (1 - 0.3 * 0.3) * *modulus, 0.3};
        problem.effective_modulus = *modulus;
        problem.softer_poisson = upper.elastic.poisson_ratio;
        problem.yield_strength = upper.yield_strength;
        return take_hardness(upper, hardness_of(of_contact), problem);
    }
    problem.effective_modulus = effective_modulus(upper.elastic, lower.elastic);
    problem.upper = upper.elastic, problem.lower = lower.elastic;
    const Body& softer = hardness_of(lower).middle < hardness_of(upper).middle ? lower : upper;
    problem.softer_poisson = softer.elastic.poisson_ratio;
    take_hardness(softer, softer_hardness(upper, lower), problem);
    for (const Body* body : {&upper, &lower})
        if (body->yield_strength)
            problem.yield_strength =
                (std::min)(problem.yield_strength.value_or(*body->yield_strength), *body->yield_strength);
}

FSTIFF_INLINE double hardness_of(const Problem& problem) {
    if (problem.hardness_range) return problem.hardness_range->middle;
    return problem.hardness.value_or(detail::hardness_over_yield_strength<double> * problem.yield_strength.value_or(0));
}

/// As the laws take it: 0 where it follows from the yield strength, infinite nowhere.
FSTIFF_INLINE double hardness_of_material(const Problem& problem) {
    const double hardness = problem.hardness_range ? problem.hardness_range->middle : problem.hardness.value_or(0);
    return std::isfinite(hardness) ? hardness : 0;
}

FSTIFF_INLINE std::optional<double> relative_hardness(const Problem& problem) {
    const std::optional<double> g = gradient(problem);
    if (!g) return std::nullopt;
    const double relative = hardness_of(problem) / (problem.effective_modulus * *g);
    return relative > 0 && std::isfinite(relative) ? std::optional(relative) : std::nullopt;
}

FSTIFF_INLINE bool flows(const Problem& problem, const Law& law) {
    return law.needs_hardness || law.needs_yield || (law.needs_whole_map && problem.law_options.hardness > 0);
}

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

FSTIFF_INLINE Lack lack_of(const Law& law, const Problem& problem, bool at_separations) {
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

FSTIFF_INLINE void require_possible(const Law& law, const Problem& problem) {
    const std::string name = "law " + std::string(law.name) + ": ";
    if (law.needs_dimension && !problem.face.dimension()) throw domain_error(name + "needs fractal_dimension");
    if (const Lack lack = lack_of(law, problem); lack != Lack::nothing) throw domain_error(name + reason_of(lack));
}

FSTIFF_INLINE const Law& possible_law(const ChosenLaw& law, const Problem& problem) {
    if (!law.row) throw domain_error("law: must be one of " + choices_text<LawName>());
    require_possible(law.row(), problem);
    return law.row();
}

FSTIFF_INLINE std::vector<Peaks> peaks_of(const Law& law, const Problem& problem) {
    if (!law.has_peaks) return {};
    if (!problem.default_peaks || law.needs_dimension || !has_isotropic_peaks(problem.face)) return problem.peaks;
    const auto peaks = PeakDistribution<double>::isotropic(spectral_moments(problem.face).bandwidth());
    return {{.theta = peaks.theta(), .r = peaks.r(), .key = "contact.peaks."}};
}

FSTIFF_INLINE void for_each_contact(const Problem& problem, const std::vector<const Law*>& laws,
                                    const ProgressHook& progress,
                                    const std::function<void(const ContactOfLaw&)>& visit) {
    const Face& face = problem.face;
    ContactInputs inputs{.surface = face.roughness(),
                         .effective_modulus = problem.effective_modulus,
                         .fractal_dimension = face.dimension().value_or(0),
                         .interaction = interaction(problem),
                         .options = problem.law_options,
                         .moments = spectral_moments(face),
                         .hurst = hurst_exponent(face),
                         .map = face.map.get(),
                         .spectrum_of_map = face.spectrum_of_map,
                         .bearing = face.bearing.get(),
                         .similar = problem.similar.get(),
                         .material = {.effective_modulus = problem.effective_modulus,
                                      .yield_strength = problem.yield_strength.value_or(0),
                                      .poisson_ratio = problem.softer_poisson,
                                      .hardness = hardness_of_material(problem)},
                         .progress = progress};
    for (const Law* law : laws) {
        const auto make = [&] { return law->contact(inputs); };
        if (!law->has_peaks) visit({.law = law, .make = make});
        for (const Peaks& parameters : peaks_of(*law, problem)) {
            const PeakDistribution<double> peaks = peak_density(parameters);
            inputs.peaks = &peaks;
            visit({law, peaks.theta(), peaks.r(), make});
        }
    }
}

/// points_of(), however many there are.
FSTIFF_INLINE std::vector<ContactPoint<double>> every_point_of(const Request& request, const Law& law,
                                                               const AnyContact& contact, Quantity quantities,
                                                               const ProgressHook& progress) {
    const std::size_t part = law.varies ? 64 : 1;
    std::vector<ContactPoint<double>> points;
    if (request.parallel && !law.varies) {
        points.resize(request.points.size());
        detail::run_pieces(request.parallel, points.size(), [&](std::size_t i) {
            const std::span<const double> point(&request.points[i], 1);
            points[i] = (request.at_separations ? contact.at_separations(point, quantities)
                                                : contact.at_pressures(point, quantities))
                            .front();
        });
        return points;
    }
    for (std::span<const double> rest = request.points; !rest.empty();) {
        if (progress) progress("points", request.points.size() - rest.size(), request.points.size());
        const auto batch = rest.first((std::min)(part, rest.size()));
        const auto more = request.at_separations ? contact.at_separations(batch, quantities)
                                                 : contact.at_pressures(batch, quantities);
        points.insert(points.end(), more.begin(), more.end());
        rest = rest.subspan(batch.size());
    }
    return points;
}

/// The states at \p pressures, of which there are many, by a StateTable; where it has none, those of \p compute.
template <class Compute>
std::vector<ContactPoint<double>> points_of_many(const std::vector<double>& pressures, const Compute& compute) {
    const auto [least, greatest] = std::minmax_element(pressures.begin(), pressures.end());
    const std::vector<double> nodes = StateTable::pressures(*least, *greatest);
    const StateTable table(nodes, compute(nodes));
    std::vector<ContactPoint<double>> points(pressures.size());
    std::vector<std::size_t> places;
    std::vector<double> others;
    for (std::size_t i = 0; i < pressures.size(); ++i)
        if (const auto state = table.at(pressures[i]))
            points[i] = ContactPoint<double>::of(*state);
        else
            places.push_back(i), others.push_back(pressures[i]);
    const std::vector<ContactPoint<double>> computed = compute(others);
    for (std::size_t i = 0; i < places.size(); ++i) points[places[i]] = computed[i];
    return points;
}

FSTIFF_INLINE std::vector<ContactPoint<double>> points_of(const Request& request, const Law& law,
                                                          const AnyContact& contact, Quantity quantities,
                                                          const ProgressHook& progress) {
    if (!law.varies || request.at_separations || request.points.size() <= many_points)
        return every_point_of(request, law, contact, quantities, progress);
    return points_of_many(request.points, [&](const std::vector<double>& pressures) {
        return every_point_of({.points = pressures}, law, contact, quantities, progress);
    });
}

}  // namespace fstiff::inline v0_1::detail
