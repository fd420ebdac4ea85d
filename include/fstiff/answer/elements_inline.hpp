// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/elements.hpp: inline, or compiled in fstiff::double.

#include <fstiff/answer/elements.hpp>
#include <fstiff/answer/unknowns.hpp>

#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/halfspace/truth.hpp>
#include <fstiff/measured/band_parts.hpp>
#include <fstiff/topography/map_noise.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::inline v0_1::detail {

FSTIFF_INLINE bool is_map(const Face& face) { return face.map && face.spectrum_of_map; }

/// Whether the share \p area can carry \p pressure at \p hardness (0: elastic): of few points the solver may find too
/// few.
FSTIFF_INLINE bool is_carried(double pressure, double area, double hardness) {
    return area * hardness * (1 + 1e-6) >= pressure || hardness == 0;
}

/// The side [m] of what was measured: of a profile its length, of a map the root of its area; 0 for numbers.
FSTIFF_INLINE double measured_side(const Problem& problem) {
    double least = 0;
    for (const Face* face : measured_faces(problem)) {
        const double size = face->measured->size, side = face->measured->is_profile ? size : std::sqrt(size);
        if (side > 0) least = least > 0 ? (std::min)(least, side) : side;
    }
    return least;
}

FSTIFF_INLINE bool is_map_itself(const Problem& problem) {
    return is_map(problem.face) &&
           (!problem.nominal_area || *problem.nominal_area <= (1 + 1e-6) * problem.face.map->maps.front()->area());
}

/// The area [m^2] on which contacts are counted: the nominal one, else a square as long as what was measured; 0: not
/// known.
FSTIFF_INLINE double counted_area(const Problem& problem) {
    return problem.nominal_area ? *problem.nominal_area : std::pow(measured_side(problem), 2);
}

/// Uncertainty of \p value by \p band, with its \p parts where they are known.
FSTIFF_INLINE void take_band(parts::Causes<double>& causes, double value, const parts::SampledBand<double>& band,
                             const parts::BandParts<double>* parts, bool sampled) {
    const auto put = [&](parts::Cause cause, double low, double high) {
        causes[static_cast<std::size_t>(cause)] = {low, high};
    };
    if (parts) {
        if (sampled)
            put(parts::Cause::measurement, -std::hypot(parts->errors_low, parts->window_low),
                std::hypot(parts->errors_high, parts->window_high));
        put(parts::Cause::cut_offs, parts->scale_low, parts->scale_high);
        put(parts::Cause::shape, parts->shape_low, parts->shape_high);
        put(parts::Cause::prior, parts->prior_low, parts->prior_high);
        const parts::BandPart<double>& hardness = parts->part_of(parts::Unknown::hardness);
        put(parts::Cause::hardness, hardness.low, hardness.high);
    } else if (sampled && band.low > 0) {
        put(parts::Cause::measurement, (std::min)(0.0, std::log(band.low / value)),
            (std::max)(0.0, std::log(band.high / value)));
    }
}

/// K of boundary elements, on 256 points a side, which take seconds, unless another number is given, at the points that
/// are answered where they resolve more than a pixel.
FSTIFF_INLINE LawCurve solved(const Problem& problem, const Request& request, const LawCurve& base,
                              const AnswerFacts& facts, const ProgressHook& progress) {
    const Law& law = find_law(LawName::boundary_elements);
    LawCurve curve{.law = &law};
    if (!request.solves_map || !is_map(problem.face) || problem.face.map->maps.size() > 1 ||
        lack_of(law, problem, request.at_separations) != Lack::nothing)
        return curve;
    const HeightMap<double>& map = *problem.face.map->maps.front();
    const double coarser =
        (std::min)(1.0, problem.law_options.points / static_cast<double>((std::max)(map.rows(), map.columns())));
    const double size = coarser * coarser * static_cast<double>(map.size());
    Request of{.at_separations = request.at_separations, .seating = request.seating, .parallel = request.parallel};
    std::vector<std::size_t> places;
    for (const std::size_t place : request.answered) {
        const auto state = base.state_at(place);
        if (!state || facts.reasons[*state].p_star.value_or(0) > parts::max_compared_pressure) continue;
        const double touching = base.states[*state].real_area_fraction.value * size;
        if (touching > 0 && touching < parts::min_points_in_contact / 4) continue;
        of.points.push_back(request.points[place]);
        places.push_back(place);
    }
    if (places.empty()) return curve;
    Problem flowing = problem;
    const double hardness = flowing.law_options.hardness = facts.flows ? hardness_of(problem) : 0;
    for_each_contact(flowing, {&law}, {}, [&](const ContactOfLaw& one) {
        const auto made = one.make();
        const auto points = points_of(of, law, *made, Quantity::all, progress);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const double area = points[i].state.real_area_fraction.value;
                points[i].ok() && area * size >= parts::min_points_in_contact &&
                is_carried(points[i].state.pressure.value, area, hardness))
                curve.states.push_back(points[i].state), curve.places.push_back(places[i]);
        if (request.approach) seat(of, *made, curve);
    });
    return curve;
}

/// ln K of boundary elements of \p map over K of \p solved at each of its states: solved at a few of them, the others
/// lie on lines over ln p.
FSTIFF_INLINE std::vector<double> changes(const Problem& problem, const HeightMap<double>& map, const LawCurve& solved,
                                          double hardness, const ParallelHook& parallel, const ProgressHook& progress) {
    const std::size_t count = solved.states.size(),
                      most = hardness > 0 ? 2 : 6;  // with a hardness one takes as long as four
    std::vector<double> pressures;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < (std::min)(most, count); ++k) {
        places.push_back(count <= most ? k : k * (count - 1) / (most - 1));
        pressures.push_back(solved.states[places.back()].pressure.value);
    }
    const LawOptions& of = problem.law_options;
    const parts::TruthOptions<double> how{of.points, of.edges, hardness, false, parallel ? ProgressHook() : progress};
    std::vector<TruthPoint<double>> found(pressures.size());
    if (parallel)
        parts::run_pieces(parallel, found.size(), [&](std::size_t k) {
            found[k] = truth(map, problem.effective_modulus, std::span(&pressures[k], 1), how).front();
        });
    else
        found = truth(map, problem.effective_modulus, pressures, how);
    std::vector<double> all(count);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double change = std::log(found[k].state.stiffness / solved.states[places[k]].stiffness.value);
        const bool carried = is_carried(pressures[k], found[k].state.contact_fraction, hardness);
        all[places[k]] = carried && std::isfinite(change) ? change : 0;
        for (std::size_t i = k > 0 ? places[k - 1] + 1 : places[k]; i < places[k]; ++i) {
            const double p = solved.states[i].pressure.value, from = pressures[k - 1];
            all[i] = std::lerp(all[places[k - 1]], all[places[k]], std::log(p / from) / std::log(pressures[k] / from));
        }
    }
    return all;
}

FSTIFF_INLINE double noise_of(const Face& face, Edges edges) {
    if (!is_map(face) || !face.filtered || !face.map->spectra) return 0;
    const HeightMap<double>& map = *face.map->maps.front();
    return parts::white_noise(face.map->spectra->of(edges), map.dx, map.dy);
}

/// The part that \p noise [m] has of the gradient squared of \p face that the lambda_s of the tables takes away.
FSTIFF_INLINE double share_of_noise(const Face& face, Edges edges, double noise) {
    if (!(noise > 0)) return 0;
    const HeightMap<double>& map = *face.map->maps.front();
    const double all = face.map->spectra->of(edges).rms_gradient(),
                 kept = map_spectrum(*face.filtered, edges).rms_gradient(),
                 of_noise = parts::gradient_of_noise(noise, map.dx, map.dy);
    return (std::min)(1.0, of_noise * of_noise / ((all - kept) * (all + kept)));
}

/// Changes of K of \p solved that the filter of a lambda_s that was given, and the removed plane may have caused: the
/// filter by the neighbour with the next shorter lambda_s, as its change goes as lambda_s^2; the plane where it may be
/// the surface's own.
FSTIFF_INLINE std::vector<parts::CauseSpread<double>> of_cut_offs(const Problem& problem, const LawCurve& solved,
                                                                  double hardness, const ParallelHook& parallel,
                                                                  const ProgressHook& progress) {
    std::vector<parts::CauseSpread<double>> all(solved.states.size());
    const auto widen = [&](const HeightMap<double>& map, double factor, bool both_ways) {
        const std::vector<double> of_map = changes(problem, map, solved, hardness, parallel, progress);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double change = factor * of_map[i];
            all[i].low = -std::hypot(all[i].low, both_ways ? change : (std::min)(0.0, change));
            all[i].high = std::hypot(all[i].high, both_ways ? change : (std::max)(0.0, change));
        }
    };
    if (all.empty() || !problem.face.measured || !problem.face.measured->map) return all;
    for (const Face& other : problem.face.neighbours)
        if (const double ratio = other.lambda_s.value_or(0) / problem.face.lambda_s.value_or(0);
            ratio < 1 && !problem.face.filtered && other.map)
            widen(*other.map->maps.front(), 1 / (1 - ratio * ratio), false);
    const parts::PreparedMap<double>& flat = *problem.face.measured->map;
    const auto [x, y] = flat.tilt;
    const double tilted = std::hypot(x, y) / std::sqrt(12.0) / problem.face.parameters.rms_height.value;
    if (flat.removed != MapForm::plane || !(tilted > 0)) return all;
    const double share = (std::min)(1.0, problem.face.parameters.long_end.form_share / tilted);
    HeightMap<double> map = *problem.face.map->maps.front();
    map.heights.rowwise() += share * Eigen::ArrayXd::LinSpaced(map.columns(), -x / 2, x / 2).transpose();
    map.heights.colwise() += share * Eigen::ArrayXd::LinSpaced(map.rows(), -y / 2, y / 2);
    widen(map, 1, share < 0.99);
    return all;
}

/// Uncertainty of a profile of a face with a lay: the length of the ridges if it is across the lay, else the profile
/// across.
FSTIFF_INLINE parts::CauseSpread<double> of_lay(const Problem& problem) {
    constexpr double softer = 4, stiffer = 2, heavy = 1.5;  // along and across turned, milled, planed and ground maps
    if (has_lay(problem)) return {-std::log(heavy), std::log(parts::lay_factor)};
    for (const Face* face : measured_faces(problem))
        if (face->measured->is_profile && parts::prior_of(face->process).has_lay)
            return {-std::log(softer), std::log(stiffer)};
    return {};
}

/// The shape of the heights of \p face; where it is open, the one of its prior that is farthest from Gaussian.
FSTIFF_INLINE parts::HeightShape<double> farthest_shape(const Face& face) {
    parts::HeightShape<double> shape = face.shape;
    for (const Prior& prior : face.priors)
        if (prior.which == parts::Unknown::skewness)
            for (const double end : {prior.low, prior.high})
                if (std::abs(end) > std::abs(shape.skewness)) shape = with_value(face, prior.which, end).shape;
    return shape;
}

FSTIFF_INLINE parts::CauseSpread<double> law_error(const Problem& problem, LawName law, const AnswerReason& reason,
                                                   double grid) {
    parts::LawErrorQuestion<double> question{.law = law, .known = known_as(problem)};
    if (reason.p_star) question.p_star = *reason.p_star, question.hardness = relative_hardness(problem).value_or(0);
    const parts::HeightShape<double> shape = farthest_shape(problem.face);
    if (const auto& heights = problem.face.heights; heights && heights->kurtosis.value != 0)
        question.skewness = heights->skewness, question.kurtosis = heights->kurtosis;
    else if (question.known == parts::KnownAs::numbers || question.known == parts::KnownAs::height)
        question.skewness = {shape.skewness, 0}, question.kurtosis = {shape.kurtosis, 0};
    if (const Measurement<double>& height = problem.face.parameters.rms_height; height.value > 0)
        question.long_waves = height.error / height.value;
    const parts::LawError<double> error = parts::law_error(question);
    return {-std::hypot(error.low, grid), std::hypot(error.high, grid)};
}

FSTIFF_INLINE parts::KnownAs known_as(const Problem& problem) {
    if (is_map(problem.face)) return parts::KnownAs::map;
    if (!measured_faces(problem).empty()) return parts::KnownAs::trace;
    constexpr double spread_of_height = 4;  // of a gradient by the height alone, 95 % over 5 %; all else gives less
    for (const Prior& prior : problem.face.priors)
        if (prior.which == parts::Unknown::gradient && prior.high > spread_of_height * prior.low)
            return parts::KnownAs::height;
    return parts::KnownAs::numbers;
}

FSTIFF_INLINE AnswerFacts make_answer(const Problem& problem, const Request& request, LawCurve& curve,
                                      const ProgressHook& progress) {
    AnswerFacts facts;
    facts.relative_hardness = relative_hardness(problem);
    facts.flows = flows(problem, *curve.law);
    facts.of_map_itself = is_map_itself(problem);
    const double area = counted_area(problem);
    parts::UnmeasuredWaves<double> longer;
    if (problem.nominal_area) longer = problem.face.unmeasured(std::sqrt(*problem.nominal_area));
    facts.waves_at_least = longer.at_least;
    for (const auto& state : curve.states) {
        AnswerReason& reason = facts.reasons.emplace_back();
        if (curve.rms_gradient)
            reason.p_star =
                parts::dimensionless_pressure(state.pressure.value, problem.effective_modulus, *curve.rms_gradient);
        if (const double contacts = area * state.contact_density.value; contacts > 0) reason.contacts = contacts;
        if (facts.flows && state.loading_stiffness.value > 0) reason.loading_stiffness = state.loading_stiffness.value;
    }
    const LawCurve elements = solved(problem, request, curve, facts, progress);
    const Edges edges = problem.law_options.edges;
    const double noise = share_of_noise(problem.face, edges, noise_of(problem.face, edges));
    const double hardness = facts.flows ? hardness_of(problem) : 0;
    const auto cut_offs = of_cut_offs(problem, elements, hardness, request.parallel, progress);
    std::vector<double> smoother(elements.states.size());  // change of ln K without the short waves
    if (noise > 0.01 && !elements.states.empty())
        smoother = changes(problem, *problem.face.filtered, elements, hardness, request.parallel, progress);
    std::vector<parts::SampledBand<double>> bands;
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        AnswerReason& reason = facts.reasons[i];
        if (i < curve.band.size())
            take_band(reason.causes, curve.states[i].stiffness.value, curve.band[i],
                      i < curve.band_parts.size() ? &curve.band_parts[i] : nullptr, !facts.of_map_itself);
        const auto put = [&](parts::Cause cause, const parts::CauseSpread<double>& spread) {
            reason.causes[static_cast<std::size_t>(cause)] = spread;
        };
        put(parts::Cause::lay, of_lay(problem));
        if (reason.contacts && !facts.of_map_itself)
            put(parts::Cause::contacts, parts::scatter_of_contacts(*reason.contacts));
        put(parts::Cause::long_waves, {-longer.growth, 0});
        const Law* law = curve.law;
        double grid = 0;
        if (const auto at = elements.state_at(curve.places[i])) {
            law = elements.law;
            put(parts::Cause::cut_offs, {cut_offs[*at].low, std::hypot(reason.causes[1].high, cut_offs[*at].high)});
            put(parts::Cause::noise, {0, noise * (std::max)(0.0, smoother[*at])});
            curve.states[i].stiffness = elements.states[*at].stiffness;
            curve.states[i].real_area_fraction = elements.states[*at].real_area_fraction;
            curve.states[i].separation = elements.states[*at].separation;
            if (!curve.seated.empty() && !elements.seated.empty()) curve.seated[i] = elements.seated[*at];
            grid = curve.states[i].stiffness.error / curve.states[i].stiffness.value;
        }
        put(parts::Cause::law, law_error(problem, law->which, reason, std::isfinite(grid) ? grid : 0));
        const double K = curve.states[i].stiffness.value;
        if (reason.loading_stiffness) {  // that of the law, next to K of boundary elements
            *reason.loading_stiffness = (std::min)(*reason.loading_stiffness, K);
            curve.states[i].loading_stiffness.value = *reason.loading_stiffness;
        }
        const auto whole = parts::band_of(reason.causes);
        constexpr double most = (std::numeric_limits<double>::max)() / 2;  // as in_range() of a state
        bands.push_back({K * std::exp(whole.low), K, (std::min)(most, K * std::exp(whole.high))});
        curve.by.push_back(law);
    }
    curve.band = std::move(bands);
    return facts;
}

}  // namespace fstiff::inline v0_1::detail
