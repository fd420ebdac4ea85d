// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/request.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <algorithm>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/state_table.hpp>
#include <span>

namespace fstiff { inline namespace v0_1 { namespace detail {

FSTIFF_INLINE void for_each_contact(const ResolvedJoint& problem, const std::vector<const Law*>& laws,
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
                         .peak_heights = face.peak_heights,
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

}}}  // namespace fstiff::detail
