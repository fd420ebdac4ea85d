// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/bands.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/band_parts.hpp>
#include <fstiff/answer/bands.hpp>
#include <fstiff/answer/curves.hpp>

#include <fstiff/answer/band.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/quick_hybrids.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// What a band draws of a surface in addition to its parameters.
struct FurtherDraw {
    double gradient_factor = 1;        ///< gradient by its own error, over what it was
    std::size_t shift = 0;             ///< of the map
    std::vector<std::size_t> tiles{};  ///< how often each of the map is there
};
inline constexpr std::size_t tiles_a_side = 4;

/// The rms gradient of \p face drawn by its own error, over what it was; lognormal as rms height.
FSTIFF_INLINE double drawn_gradient(const Face& face, std::uint64_t& state) {
    if (!(face.gradient_error > 0)) return 1;
    const double relative = face.gradient_error / *face.rms_gradient;
    return std::exp(std::sqrt(std::log1p(relative * relative)) * math::normal_pair<double>(state).real());
}

/// Those of \p count surfaces about \p face.
FSTIFF_INLINE std::vector<FurtherDraw> further_draws(const Face& face, std::size_t count, std::uint64_t seed) {
    std::uint64_t of_tiles = seed, of_gradients = ~seed;
    std::vector<FurtherDraw> draws(count);
    for (FurtherDraw& draw : draws) {
        if (face.rms_gradient) draw.gradient_factor = drawn_gradient(face, of_gradients);
        if (!face.map) continue;
        if (const std::size_t shifts = face.map->summits.size(); shifts > 1)
            draw.shift = math::splitmix64(of_tiles) % shifts;
        draw.tiles = detail::drawn_tiles(tiles_a_side * tiles_a_side, of_tiles);
    }
    return draws;
}

/// \p problem with the surface \p drawn about its own. Of a map the tiles are drawn anew.
FSTIFF_INLINE ResolvedJoint with_surface(ResolvedJoint problem,
                                         const std::array<double, detail::surface_parameter_count>& drawn,
                                         const FurtherDraw& further) {
    Face& face = problem.face;
    const double rms_height = face.parameters.rms_height.value;
    const auto value = [&](Parameter parameter) { return drawn[detail::index_of(parameter)]; };
    face.draw(drawn);
    const double height_factor = face.parameters.rms_height.value / rms_height;
    if (face.rms_gradient) {
        *face.rms_gradient *= further.gradient_factor * std::pow(height_factor, face.gradient_growth);
        face.follow();
    }
    if (face.map) face.map = face.map->resampled(further.shift, tiles_a_side, further.tiles, height_factor);
    for (Peaks& peaks : problem.peaks)
        if (peaks.of_surface) peaks.r = value(Parameter::r), peaks.theta = value(Parameter::theta);
    return problem;
}

/// \p problem with a neighbour of its surface.
FSTIFF_INLINE ResolvedJoint with_face(ResolvedJoint problem, const Face& face) {
    problem.face = face;
    for (Peaks& peaks : problem.peaks)
        if (peaks.of_surface && face.has_peaks())
            peaks.r = face.value(Parameter::r), peaks.theta = *face.value(Parameter::theta);
    return problem;
}

/// \p face with the waves of its own that went with the form, as far as its long waves show there may be.
FSTIFF_INLINE Face with_form(Face face) {
    face.parameters.rms_height.value *= std::hypot(1.0, face.parameters.long_end.form_share);
    face.neighbours.clear();
    return face;
}

/// K at the points of \p request, of which there are many, by a polynomial through ln K at some over ln p or d, in
/// steps of \p unit: of a law each of whose states is an integral in two dimensions. Empty where a state is missing.
FSTIFF_INLINE std::vector<double> by_few(Request request, const Law& law, const AnyContact& contact, double unit) {
    const auto x_of = [&](double point) { return request.at_separations ? point : std::log(point); };
    const std::vector<double> points = std::move(request.points);
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
    const double from = x_of(*least), half = (x_of(*greatest) - from) / 2;
    const double steps = 2 * half / (request.at_separations ? unit : 1);
    const int last = 12 + static_cast<int>((std::min)(steps, 30.0));  // of Chebyshev's points
    std::vector<double> nodes, logs, interpolated;
    for (int k = 0; k <= last; ++k) nodes.push_back(from + half * (1 - std::cos(std::numbers::pi * k / last)));
    request.points.clear();
    for (const double x : nodes) request.points.push_back(request.at_separations ? x : std::exp(x));
    for (const auto& point : points_of(request, law, contact, Quantity::pressure | Quantity::stiffness)) {
        if (!point.ok() || !(point.state.stiffness.value > 0)) return {};
        logs.push_back(std::log(point.state.stiffness.value));
    }
    for (const double point : points) {
        double sum = 0, weights = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const double apart = x_of(point) - nodes[k], end = k == 0 || k + 1 == nodes.size() ? 0.5 : 1.0;
            const double weight = (k % 2 == 0 ? end : -end) / (apart == 0 ? 1e-300 : apart);
            sum += weight * logs[k], weights += weight;
        }
        interpolated.push_back(std::exp(sum / weights));
    }
    return interpolated;
}

/// K of every curve and point of \p request, one after the other; NaN for a surface that the law does not take, such as
/// a D next to 2.
FSTIFF_INLINE std::vector<double> stiffnesses(const ResolvedJoint& problem, const Request& request) {
    std::vector<double> result;
    for_each_contact(problem, request.laws, {}, [&](const ContactOfLaw& recipe) {
        try {
            constexpr std::size_t many = 48;
            const auto model = recipe.make();
            if (problem.similar && recipe.law->needs_yield && request.points.size() > many)
                if (const auto few = by_few(request, *recipe.law, *model, problem.face.parameters.rms_height.value);
                    !few.empty())
                    return void(result.insert(result.end(), few.begin(), few.end()));
            for (const auto& point : points_of(request, *recipe.law, *model, Quantity::pressure | Quantity::stiffness))
                result.push_back(point.ok() ? point.state.stiffness.value : std::numeric_limits<double>::quiet_NaN());
        } catch (const domain_error&) {
            result.insert(result.end(), request.points.size(), std::numeric_limits<double>::quiet_NaN());
        }
    });
    return result;
}

/// \p problem as it is copied with every surface: with what the laws of \p request take in their quick form.
FSTIFF_INLINE ResolvedJoint lean_problem(const ResolvedJoint& problem, const Request& request) {
    ResolvedJoint lean = problem;
    lean.face.measured.reset();
    lean.face.heights.reset();
    lean.faces.clear();
    lean.face.neighbours.clear();
    lean.law_options.mutual = false;
    if (std::none_of(request.laws.begin(), request.laws.end(),
                     [](const Law* law) { return law->needs_map || law->needs_spectrum; }))
        lean.face.map.reset();  // nothing takes its tiles
    return lean;
}

/// K of every curve and point with D greater and smaller by what the windows of lags leave open: 5 % and 95 % of it.
FSTIFF_INLINE std::vector<std::vector<double>> curves_of_other_windows(const ResolvedJoint& lean,
                                                                       const Request& request) {
    std::vector<std::vector<double>> curves;
    const SurfaceParameters<double>& surface = lean.face.parameters;
    if (!surface.fractal_dimension || !(surface.dimension_window_error > 0)) return curves;
    for (const double dimension :
         detail::dimensions_of_other_windows(surface.fractal_dimension->value, surface.dimension_window_error)) {
        ResolvedJoint other = lean;
        other.face.parameters.fractal_dimension->value = dimension;
        curves.push_back(stiffnesses(other, request));
    }
    return curves;
}

/// K of every curve and point of the surfaces that have one unknown of \p problem at its ends, over that of \p lean.
FSTIFF_INLINE std::vector<UnknownCurves<double>> curves_at_ends_of_unknowns(const ResolvedJoint& problem,
                                                                            const std::vector<const Law*>& laws,
                                                                            ResolvedJoint lean,
                                                                            const Request& request) {
    std::vector<UnknownCurves<double>> curves;
    const std::vector<Alternative> others = alternatives(problem, laws);
    const bool of_hardness = problem.hardness_range && depends_on_hardness(problem, laws);
    if (others.empty() && !of_hardness) return curves;
    lean.similar = hybrids_of_numbers(lean.law_options.gamma);
    const std::vector<double> own = stiffnesses(lean, request);
    const auto over_own = [&](const ResolvedJoint& variant) {
        std::vector<double> other = stiffnesses(variant, request);
        other.resize(own.size(), std::numeric_limits<double>::quiet_NaN());
        std::transform(other.begin(), other.end(), own.begin(), other.begin(), std::divides<>());
        return other;
    };
    for (const Alternative& range : others)
        curves.push_back({range.which, over_own(with_face(lean, range.low)), over_own(with_face(lean, range.high))});
    if (of_hardness)
        curves.push_back({Unknown::hardness, over_own(with_hardness(lean, problem.hardness_range->low)),
                          over_own(with_hardness(lean, problem.hardness_range->high))});
    return curves;
}

/// Bands over the errors of the surface, one for each value of stiffnesses().
FSTIFF_INLINE std::vector<SampledBand<double>> drawn_bands(ResolvedJoint lean, const Request& request,
                                                           const ProgressHook& progress) {
    lean.similar = hybrids_of_draws(lean.face.bearing.get(), lean.law_options.gamma);
    const auto samples = static_cast<std::size_t>(request.samples);
    const std::vector<FurtherDraw> further = further_draws(lean.face, samples, request.seed);
    return detail::sampled_band(
        lean.face.parameters,
        [&](const auto& drawn, std::size_t i) { return stiffnesses(with_surface(lean, drawn, further[i]), request); },
        {samples, request.seed, progress, request.parallel});
}

FSTIFF_INLINE void make_contacts(const ResolvedJoint& problem, const Request& request) {
    std::vector<const MapOfSurface*> maps;
    std::vector<std::function<void()>> parts;
    const auto add = [&](const Face& face) {  // neighbours may have the map of the surface itself
        const MapOfSurface* const map = face.map.get();
        if (!map || !face.spectrum_of_map || std::count(maps.begin(), maps.end(), map) > 0) return;
        maps.push_back(map);
        for (auto& part : map->pieces(problem, request)) parts.push_back(std::move(part));
    };
    add(problem.face);
    for (const Face& neighbour : problem.face.neighbours) add(neighbour);
    detail::run_pieces(request.parallel, parts.size(), [&](std::size_t i) {
        try {
            parts[i]();
        } catch (const domain_error&) {  // whoever needs it finds it again
        }
    });
}

/// add_bands() at every point of \p request.
FSTIFF_INLINE std::size_t add_every_band(const ResolvedJoint& problem, Request request, std::vector<LawCurve>& curves,
                                         const ProgressHook& progress) {
    const std::vector<const Law*> laws = request.laws;
    std::erase_if(request.laws, [](const Law* law) { return !law->varies; });
    const ResolvedJoint lean = lean_problem(problem, request);
    const bool has_errors = problem.face.has_measured_errors();
    const auto of_unknowns = curves_at_ends_of_unknowns(problem, laws, lean, request);
    if (!has_errors && of_unknowns.empty()) return 0;
    std::vector<SampledBand<double>> bands;
    if (has_errors) bands = drawn_bands(lean, request, progress);
    const std::vector<double> quick = has_errors ? stiffnesses(lean, request) : std::vector<double>();
    std::vector<std::vector<double>> of_neighbours;
    for (const Face& face : problem.face.neighbours) {
        of_neighbours.push_back(stiffnesses(with_face(lean, face), request));
        if (of_neighbours.back().size() != quick.size()) of_neighbours.pop_back();  // no map, or no D: other curves
    }
    if (is_of_traces(problem) && problem.face.parameters.long_end.form_share > 0.01)
        of_neighbours.push_back(stiffnesses(with_face(lean, with_form(problem.face)), request));
    const auto of_windows = curves_of_other_windows(lean, request);
    const bool lay = has_lay(problem);
    std::size_t failed = 0, next = 0;
    for (LawCurve& curve : curves) {
        if (!curve.law->varies) continue;
        bool wide_anywhere = has_errors;
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            const std::size_t index = next + curve.places[i];
            const double value = curve.states[i].stiffness.value;
            SampledBand<double> band{value, value, value};
            double factor = 1;
            if (has_errors) {
                band = bands[index];
                failed = (std::max)(failed, band.failed);
                if (std::isfinite(quick[index])) factor = value / quick[index];
                if (curve.law->has_quick_form) band.low *= factor, band.median *= factor, band.high *= factor;
            }
            const WidenedBand<double> wide =
                detail::widened(value, band, of_neighbours, of_windows, index, lay, factor, of_unknowns);
            wide_anywhere = wide_anywhere || wide.band.high > wide.band.low;
            if (!of_neighbours.empty() || !of_unknowns.empty()) curve.band_parts.push_back(wide.parts);
            curve.band.push_back(wide.band);
        }
        if (!wide_anywhere) curve.band.clear(), curve.band_parts.clear();  // depends on no unknown
        next += request.points.size();
    }
    return failed;
}

/// Weights of the polynomial through up to four of \p nodes around \p x, which rise, and the place of the first.
FSTIFF_INLINE std::pair<std::size_t, std::vector<double>> weights_around(const std::vector<double>& nodes, double x) {
    const std::size_t count = (std::min)(nodes.size(), std::size_t(4));
    const auto above = std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin();
    const auto first = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - 2, 0, static_cast<std::ptrdiff_t>(nodes.size() - count)));
    std::vector<double> weights(count, 1.0);
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t j = 0; j < count; ++j)
            if (j != k) weights[k] *= (x - nodes[first + j]) / (nodes[first + k] - nodes[first + j]);
    return {first, weights};
}

/// Gives \p curve the bands of \p few, which has some of its states: their ratios to K, and the parts, by cubics.
/// \p x_of is the place of a point on a line, and \p nodes are the places of the points of \p few.
template <class PlaceOnLine>
void spread_bands(const LawCurve& few, const std::vector<std::size_t>& nodes, const PlaceOnLine& x_of,
                  LawCurve& curve) {
    using Band = SampledBand<double>;
    using Parts = BandParts<double>;
    constexpr double most = (std::numeric_limits<double>::max)() / 2;
    if (few.band.empty()) return;
    std::vector<double> x;
    for (const std::size_t place : few.places) x.push_back(x_of(nodes[place]));
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const auto [first, weights] = weights_around(x, x_of(curve.places[i]));
        const auto mean = [&, &first = first, &weights = weights](const auto& value_of) {
            double sum = 0;
            for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * value_of(first + k);
            return sum;
        };
        const auto end = [&](double Band::*member) {
            const double log_ratio =
                mean([&](std::size_t k) { return std::log(few.band[k].*member / few.states[k].stiffness.value); });
            return std::isfinite(log_ratio) ? (std::min)(most, std::exp(log_ratio) * curve.states[i].stiffness.value)
                                            : 0;  // no surface gives a value
        };
        curve.band.push_back({end(&Band::low), end(&Band::median), end(&Band::high), few.band[first].failed});
        if (few.band_parts.empty()) continue;
        Parts& parts = curve.band_parts.emplace_back();
        for (double Parts::*low :
             {&Parts::errors_low, &Parts::scale_low, &Parts::window_low, &Parts::prior_low, &Parts::shape_low})
            parts.*low = (std::min)(0.0, mean([&](std::size_t k) { return few.band_parts[k].*low; }));
        for (double Parts::*high :
             {&Parts::errors_high, &Parts::scale_high, &Parts::window_high, &Parts::prior_high, &Parts::shape_high})
            parts.*high = (std::max)(0.0, mean([&](std::size_t k) { return few.band_parts[k].*high; }));
        for (std::size_t u = 0; u < unknown_count; ++u)
            parts.of_unknown[u] = {
                (std::min)(0.0, mean([&](std::size_t k) { return few.band_parts[k].of_unknown[u].low; })),
                (std::max)(0.0, mean([&](std::size_t k) { return few.band_parts[k].of_unknown[u].high; }))};
    }
}

FSTIFF_INLINE std::size_t add_bands(const ResolvedJoint& problem, Request request, std::vector<LawCurve>& curves,
                                    const ProgressHook& progress) {
    if (request.points.size() <= many_points) return add_every_band(problem, std::move(request), curves, progress);
    constexpr double step = 1.0 / 16;
    const auto x_of = [&](std::size_t place) {
        const double point = request.points[place];
        return request.at_separations ? point / problem.face.parameters.rms_height.value : std::log(point);
    };
    std::vector<std::size_t> order(request.points.size()), nodes;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return x_of(i) < x_of(j); });
    std::vector<bool> kept(order.size());  // the ends of every curve
    for (const LawCurve& curve : curves) {
        const auto has_state = [&](std::size_t place) { return curve.state_at(place).has_value(); };
        if (const auto first = std::find_if(order.begin(), order.end(), has_state); first != order.end())
            kept[*first] = kept[*std::find_if(order.rbegin(), order.rend(), has_state)] = true;
    }
    for (const std::size_t place : order) {
        const double apart = nodes.empty() ? step : x_of(place) - x_of(nodes.back());
        if (apart >= (kept[place] ? step / 4 : step))
            nodes.push_back(place);
        else if (kept[place] && !kept[nodes.back()])
            nodes.back() = place;
    }
    Request some = request;
    some.points.clear();
    for (const std::size_t place : nodes) some.points.push_back(request.points[place]);
    std::vector<LawCurve> few;
    for (const LawCurve& curve : curves) {
        LawCurve& thin = few.emplace_back(LawCurve{.law = curve.law, .theta = curve.theta, .r = curve.r});
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (const auto state = curve.state_at(nodes[k]))
                thin.states.push_back(curve.states[*state]), thin.places.push_back(k);
    }
    const std::size_t failed = add_every_band(problem, std::move(some), few, progress);
    for (std::size_t i = 0; i < curves.size(); ++i) spread_bands(few[i], nodes, x_of, curves[i]);
    return failed;
}

}}}  // namespace fstiff::detail
