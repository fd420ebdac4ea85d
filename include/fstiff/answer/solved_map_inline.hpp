// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The map of a joint solved by boundary elements at the points of a request: where they count, K there and between
/// solved points, and how it changes with the cut-offs. For answer/answer_curve_inline.hpp.

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/band_parts.hpp>
#include <fstiff/answer/curves.hpp>

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/halfspace/flattened_map.hpp>
#include <fstiff/halfspace/solve_half_space.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/white_noise.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Whether the share \p area can carry \p pressure at \p hardness (0: elastic): of few points the solver may find too
/// few.
FSTIFF_INLINE bool is_carried(double pressure, double area, double hardness) {
    return area * hardness * (1 + 1e-6) >= pressure || hardness == 0;
}

/// A point at which boundary elements count.
struct ElementPoint {
    std::size_t place;  ///< among Request::points
    double log_pressure, weight;
};

/// The points of \p request at which boundary elements of the map count, in the order of their pressures: where more
/// than a few points of the grid touch, and at pressures beyond the states of \p base.
FSTIFF_INLINE std::vector<ElementPoint> element_points(const ResolvedJoint& problem, const Request& request,
                                                       const LawCurve& base, double hardness) {
    std::vector<ElementPoint> points;
    if (!request.solves_map || !is_map(problem.face) ||
        lack_of(laws::boundary_elements.row(), problem, request.at_separations) != Lack::nothing)
        return points;
    const HeightMap<double>& map = *problem.face.map->maps.front();
    const double coarser =
        (std::min)(1.0, problem.law_options.points / static_cast<double>((std::max)(map.rows(), map.columns())));
    const double size = coarser * coarser * static_cast<double>(map.size());
    for (std::size_t i = 0; i < base.states.size(); ++i) {
        const double touching = base.states[i].real_area_fraction.value * size;
        const double weight = touching > 0 ? detail::weight_of_elements(touching) : 1;
        if (weight > 0) points.push_back({base.places[i], std::log(base.states[i].pressure.value), weight});
    }
    for (const MissedPoint& missed : base.missed)
        if (const double p = request.points[missed.place];
            !request.at_separations && missed.why == Miss::closed && !(hardness > 0 && p >= hardness))
            points.push_back({missed.place, std::log(p), 1});
    std::stable_sort(points.begin(), points.end(),
                     [](const ElementPoint& a, const ElementPoint& b) { return a.log_pressure < b.log_pressure; });
    return points;
}

/// \p points, or so many of them, at equal steps of ln p, that a curve goes through the others.
FSTIFF_INLINE std::vector<ElementPoint> solved_points(const std::vector<ElementPoint>& points) {
    constexpr std::size_t most = 60, few = 24;
    if (points.size() <= most) return points;
    std::vector<ElementPoint> nodes;
    const double first = points.front().log_pressure, step = (points.back().log_pressure - first) / (few - 1);
    for (const ElementPoint& point : points)
        if (nodes.empty() || point.place == points.back().place ||
            point.log_pressure >= first + (static_cast<double>(nodes.size()) - 0.5) * step)
            nodes.push_back(point);
    return nodes;
}

/// \p solved of \p nodes at each of \p points between them: ln K, ln of the area, d by cubics over ln p.
FSTIFF_INLINE void interpolate(const std::vector<ElementPoint>& nodes, const std::vector<ElementPoint>& points,
                               LawCurve& solved) {
    using State = ContactState<double>;
    const auto through = [&](const auto& value_of) {
        std::vector<std::pair<double, double>> pairs;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            pairs.push_back({nodes[i].log_pressure, value_of(solved.states[i])});
        return RisingCurve(std::move(pairs));
    };
    constexpr double least = (std::numeric_limits<double>::min)();
    const auto log_through = [&](Estimate<double> State::*member) {
        return through([&](const State& state) { return std::log((std::max)((state.*member).value, least)); });
    };
    const RisingCurve K = log_through(&State::stiffness), area = log_through(&State::real_area_fraction),
                      density = log_through(&State::contact_density), loading = log_through(&State::loading_stiffness),
                      error = through([](const State&state) { return state.stiffness.error / state.stiffness.value; }),
                      gap = through([](const State&state) { return state.separation.value; });
    LawCurve curve{.law = solved.law,
                   .missed = std::move(solved.missed),
                   .separation_at_seating = std::move(solved.separation_at_seating)};
    for (const ElementPoint& point : points) {
        const double x = point.log_pressure;
        if (x < nodes.front().log_pressure || x > nodes.back().log_pressure) continue;
        State& state = curve.states.emplace_back();
        state.pressure.value = std::exp(x);
        state.separation.value = gap.at(x);
        state.stiffness = {std::exp(K.at(x)), 0};
        state.stiffness.error = error.at(x) * state.stiffness.value;
        state.real_area_fraction.value = std::exp(area.at(x));
        state.contact_density.value = std::exp(density.at(x));
        state.loading_stiffness.value = (std::min)(std::exp(loading.at(x)), state.stiffness.value);
        curve.places.push_back(point.place);
    }
    if (!curve.separation_at_seating.empty())
        curve.separation_at_seating.resize(curve.states.size(), curve.separation_at_seating.front());
    solved = std::move(curve);
}

/// K of boundary elements at \p points of \p request, in the order of their pressures; `missed` has those that the
/// solver does not reach.
FSTIFF_INLINE LawCurve solved(const ResolvedJoint& problem, const Request& request,
                              const std::vector<ElementPoint>& points, double hardness, const ProgressHook& progress) {
    const Law& law = laws::boundary_elements.row();
    LawCurve curve{.law = &law};
    if (points.empty()) return curve;
    std::vector<ElementPoint> nodes = solved_points(points);
    const bool complete = nodes.size() == points.size();
    Request sparse{.at_separations = request.at_separations, .seating = request.seating, .parallel = request.parallel};
    for (const ElementPoint& node : nodes) sparse.points.push_back(request.points[node.place]);
    ResolvedJoint flowing = problem;
    flowing.law_options.hardness = hardness;
    std::vector<ElementPoint> reached;
    for_each_contact(flowing, {&law}, {}, [&](const ContactOfLaw& recipe) {
        const auto contact = recipe.make();
        const auto solved = points_of(sparse, law, *contact, Quantity::all, progress);
        for (std::size_t i = 0; i < solved.size(); ++i) {
            const ContactState<double>& state = solved[i].state;
            if (!solved[i].ok()) {
                curve.missed.push_back({nodes[i].place, Miss::law, solved[i].reason});
            } else if (is_carried(state.pressure.value, state.real_area_fraction.value, hardness)) {
                curve.states.push_back(state), curve.places.push_back(nodes[i].place);
                reached.push_back(nodes[i]);
            }
        }
        if (request.approach) add_seating(sparse, *contact, curve);
    });
    if (!complete && reached.size() > 1) interpolate(reached, points, curve);
    return curve;
}

/// ln K of boundary elements of \p map over K of \p solved at each of its states: solved at \p most of them, the
/// others lie on lines over ln p.
FSTIFF_INLINE std::vector<double> changes(const ResolvedJoint& problem, const HeightMap<double>& map,
                                          const LawCurve& solved, double hardness, std::size_t most,
                                          const ParallelHook& parallel, const ProgressHook& progress) {
    const std::size_t count = solved.states.size();
    std::vector<double> pressures;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < (std::min)(most, count); ++k) {
        places.push_back(count <= most ? k : k * (count - 1) / (most - 1));
        pressures.push_back(solved.states[places.back()].pressure.value);
    }
    const HeightMap<double> grid = detail::map_for_truth(map, problem.law_options.points);
    const HalfSpaceOptions<double> settings{.points = problem.law_options.points,
                                            .edges = problem.law_options.edges,
                                            .hardness = hardness,
                                            .grid_error = false,
                                            .loading = false,
                                            .progress = parallel ? ProgressHook() : progress};
    std::vector<HalfSpacePoint<double>> truths(pressures.size());
    detail::run_pieces(parallel, truths.size(), [&](std::size_t k) {
        truths[k] = solve_half_space(grid, problem.effective_modulus, std::array{pressures[k]}, settings).front();
    });
    std::vector<double> out(count);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double change = std::log(truths[k].state.stiffness / solved.states[places[k]].stiffness.value);
        const bool carried = is_carried(pressures[k], truths[k].state.contact_fraction, hardness);
        out[places[k]] = carried && std::isfinite(change) ? change : 0;
        for (std::size_t i = k > 0 ? places[k - 1] + 1 : places[k]; i < places[k]; ++i) {
            const double p = solved.states[i].pressure.value, from = pressures[k - 1];
            out[i] = std::lerp(out[places[k - 1]], out[places[k]], std::log(p / from) / std::log(pressures[k] / from));
        }
    }
    return out;
}

/// Solutions for a cause of the band: with a \p hardness one takes as long as four.
FSTIFF_INLINE std::size_t few_changes(double hardness) { return hardness > 0 ? 2 : 6; }

/// Gives \p of_place the change of ln K at each state of \p solved by the greatest pressure that \p problem has
/// carried: its map, flattened by that, is elastic below. None of a sum of two maps, which is there in several shifts.
FSTIFF_INLINE void add_earlier_load(const ResolvedJoint& problem, const LawCurve& solved, double hardness,
                                    const ParallelHook& parallel, const ProgressHook& progress,
                                    std::vector<Solved>& of_place) {
    if (!problem.greatest_pressure || !(hardness > 0) || problem.face.map->maps.size() > 1) return;
    const double greatest = (std::min)(*problem.greatest_pressure, 0.95 * hardness);
    LawCurve below{.law = solved.law};
    for (std::size_t k = 0; k < solved.states.size(); ++k)
        if (solved.states[k].pressure.value < greatest)
            below.states.push_back(solved.states[k]), below.places.push_back(solved.places[k]);
    if (below.states.empty()) return;
    const HeightMap<double> grid = detail::map_for_truth(*problem.face.map->maps.front(), problem.law_options.points);
    const HeightMap<double> flat = flattened(grid, problem.effective_modulus, greatest,
                                             {.edges = problem.law_options.edges, .hardness = hardness});
    const std::vector<double> of_load = changes(problem, flat, below, 0, 12, parallel, progress);
    for (std::size_t k = 0; k < of_load.size(); ++k) of_place[below.places[k]].earlier_load = of_load[k];
}

/// Change of ln K at each state of \p solved once the noise of the map is gone: that of the lambda_s of the tables, as
/// far as the gradient which this takes away is noise.
FSTIFF_INLINE std::vector<double> spread_without_noise(const ResolvedJoint& problem, const LawCurve& solved,
                                                       double hardness, const ParallelHook& parallel,
                                                       const ProgressHook& progress) {
    const Face& face = problem.face;
    const Edges edges = problem.law_options.edges;
    const double noise = solved.states.empty() ? 0 : noise_of(face, edges);
    std::vector<double> result(solved.states.size());
    if (!(noise > 0)) return result;
    const HeightMap<double>& map = *face.map->maps.front();
    const double gradient = face.map->spectra->shells(edges).rms_gradient(),
                 kept = map_spectrum(*face.filtered, edges).rms_gradient(),
                 of_noise = detail::gradient_of_noise(noise, map.dx, map.dy),
                 share = (std::min)(1.0, of_noise * of_noise / ((gradient - kept) * (gradient + kept)));
    if (!(share > 0.01)) return result;
    result = changes(problem, *face.filtered, solved, hardness, few_changes(hardness), parallel, progress);
    for (double& change : result) change = share * (std::max)(0.0, change);
    return result;
}

/// Changes of K of \p solved that the filter of a lambda_s that was given, and the removed plane may have caused: the
/// filter by the neighbour with the next shorter lambda_s, as its change goes as lambda_s^2; the plane where it may be
/// the surface's own, and where that of least squares gives another K.
FSTIFF_INLINE std::vector<CauseSpread<double>> spread_of_cut_offs(const ResolvedJoint& problem, const LawCurve& solved,
                                                                  double hardness, const ParallelHook& parallel,
                                                                  const ProgressHook& progress) {
    std::vector<CauseSpread<double>> causes(solved.states.size());
    const auto widen = [&](const HeightMap<double>& map, double factor, bool both_ways) {
        const std::vector<double> of_map =
            changes(problem, map, solved, hardness, few_changes(hardness), parallel, progress);
        for (std::size_t i = 0; i < causes.size(); ++i) {
            const double change = factor * of_map[i];
            causes[i].low = -std::hypot(causes[i].low, both_ways ? change : (std::min)(0.0, change));
            causes[i].high = std::hypot(causes[i].high, both_ways ? change : (std::max)(0.0, change));
        }
    };
    if (causes.empty() || !problem.face.measured || !problem.face.measured->map) return causes;
    for (const Face& other : problem.face.neighbours)
        if (const double ratio = other.lambda_s.value_or(0) / problem.face.lambda_s.value_or(0);
            ratio < 1 && !problem.face.filtered && other.map)
            widen(*other.map->maps.front(), 1 / (1 - ratio * ratio), false);
    const PreparedMap<double>& flat = *problem.face.measured->map;
    const double sigma = problem.face.parameters.rms_height.value;
    const auto rms_of = [](const std::array<double, 2>& tilt) {
        return std::hypot(tilt[0], tilt[1]) / std::sqrt(12.0);
    };
    const auto tilted = [&](const std::array<double, 2>& tilt, double share) {
        HeightMap<double> map = *problem.face.map->maps.front();
        const double x = share * tilt[0] / 2, y = share * tilt[1] / 2;
        map.heights.rowwise() += Eigen::ArrayXd::LinSpaced(map.columns(), -x, x).transpose();
        map.heights.colwise() += Eigen::ArrayXd::LinSpaced(map.rows(), -y, y);
        return map;
    };
    if (flat.removed != MapForm::plane) return causes;
    if (const double whole = rms_of(flat.tilt) / sigma; whole > 0) {
        const double share = (std::min)(1.0, problem.face.parameters.long_end.form_share / whole);
        widen(tilted(flat.tilt, share), 1, share < 0.99);
    }
    if (!flat.settled || rms_of(*flat.settled) < 0.02 * sigma) return causes;
    // a plane that is askew lowers K: half of what the plane of least squares takes, and all that it adds, where it
    // is more than the rest
    const std::vector<double> askew =
        changes(problem, tilted(*flat.settled, 1), solved, hardness, few_changes(hardness), parallel, progress);
    for (std::size_t i = 0; i < causes.size(); ++i) {
        double& end = askew[i] < 0 ? causes[i].low : causes[i].high;
        const double part = askew[i] < 0 ? askew[i] / 2 : askew[i];
        if (std::abs(askew[i]) > std::abs(end)) end = std::copysign(std::hypot(end, part), askew[i]);
    }
    return causes;
}

/// Gives \p curve the states of \p of_place at points that its law does not reach.
FSTIFF_INLINE void reach_further(const std::vector<Solved>& of_place, LawCurve& curve) {
    std::vector<MissedPoint> missed;
    for (MissedPoint& miss : curve.missed) {
        const Solved& solved = of_place[miss.place];
        if (!(solved.weight > 0)) {
            missed.push_back(std::move(miss));
            continue;
        }
        const auto i = std::lower_bound(curve.places.begin(), curve.places.end(), miss.place) - curve.places.begin();
        const auto insert = [&](auto& into, const auto& value, bool known) {
            if (known) into.insert(into.begin() + i, value);
        };
        const double K = solved.state.stiffness.value;
        insert(curve.band, SampledBand<double>{K, K, K}, !curve.band.empty());
        insert(curve.band_parts, BandParts<double>{}, !curve.band_parts.empty());
        insert(curve.log_slopes, 0.0, !curve.log_slopes.empty());
        insert(curve.separation_at_seating, solved.separation_at_seating.value_or(0),
               solved.separation_at_seating && curve.separation_at_seating.size() == curve.states.size());
        insert(curve.states, solved.state, true);
        insert(curve.places, miss.place, true);
    }
    curve.missed = std::move(missed);
}

/// Boundary elements at each point of \p request where they count, of peaks that yield where it \p flows; \p curve has
/// the states that its law reaches, and gets those that only they reach.
FSTIFF_INLINE std::vector<Solved> boundary_elements_of(const ResolvedJoint& problem, const Request& request, bool flows,
                                                       LawCurve& curve, const ProgressHook& progress) {
    const double hardness = flows ? hardness_of(problem) : 0;
    const std::vector<ElementPoint> points = element_points(problem, request, curve, hardness);
    const LawCurve elements = solved(problem, request, points, hardness, progress);
    const auto cut_offs = spread_of_cut_offs(problem, elements, hardness, request.parallel, progress);
    const auto quiet = spread_without_noise(problem, elements, hardness, request.parallel, progress);
    std::vector<Solved> solved(request.points.size());
    for (const ElementPoint& point : points) solved[point.place].weight = point.weight;
    std::vector<char> known(solved.size(), 0);
    for (std::size_t k = 0; k < elements.states.size(); ++k) {
        Solved& entry = solved[elements.places[k]];
        known[elements.places[k]] = 1;
        entry.state = elements.states[k], entry.cut_offs = cut_offs[k], entry.noise = quiet[k];
        if (!elements.separation_at_seating.empty()) entry.separation_at_seating = elements.separation_at_seating[k];
    }
    for (std::size_t i = 0; i < solved.size(); ++i) solved[i].weight *= known[i];
    add_earlier_load(problem, elements, hardness, request.parallel, progress, solved);
    for (MissedPoint& missed : curve.missed)
        for (const MissedPoint& other : elements.missed)
            if (other.place == missed.place) missed = other;
    reach_further(solved, curve);
    return solved;
}

}}}  // namespace fstiff::detail
