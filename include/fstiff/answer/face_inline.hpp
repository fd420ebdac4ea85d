// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/problem.hpp: inline, or compiled in fstiff::double.

#include <fstiff/answer/problem.hpp>

#include <fstiff/answer/checks.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/measure/uncertain_sum.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fstiff::inline v0_1::detail {

/// The shells of both, in ascending order of |q|.
FSTIFF_INLINE SpectrumShells<double> sum_of_spectra(const SpectrumShells<double>& a, const SpectrumShells<double>& b) {
    SpectrumShells<double> sum{a.shells, std::hypot(a.rms_height, b.rms_height)};
    sum.shells.insert(sum.shells.end(), b.shells.begin(), b.shells.end());
    std::stable_sort(sum.shells.begin(), sum.shells.end(), [](const auto& left, const auto& right) {
        return left.q2_h2 * right.q_h2 < right.q2_h2 * left.q_h2;
    });
    return sum;
}

/// Whether sigma, R and D_p of \p face are those that were measured.
FSTIFF_INLINE bool is_as_measured(const Face& face) {
    if (!face.measured) return false;
    return std::all_of(detail::parameter_table.begin(), detail::parameter_table.begin() + 3,
                       [&](const ParameterRow& row) {
                           const std::size_t i = detail::index_of(row.parameter);
                           return face.parameters.values()[i] == face.measured->values()[i];
                       });
}

FSTIFF_INLINE Roughness<double> Face::roughness() const {
    return {parameters.rms_height.value, parameters.peak_radius.value, parameters.peak_density.value,
            parameters.max_peak_height.value};
}

FSTIFF_INLINE std::optional<double> Face::value(Parameter parameter) const {
    const Measurement<double>* known = parameters.find(parameter);
    return known ? std::optional(known->value) : std::nullopt;
}

FSTIFF_INLINE bool Face::has_measured_errors() const {
    return gradient_error > 0 || std::any_of(detail::surface_parameter_table.begin(),
                                             detail::surface_parameter_table.end(), [&](const ParameterRow& row) {
                                                 const auto* known = parameters.find(row.parameter);
                                                 return known && known->error > 0;
                                             });
}

FSTIFF_INLINE void Face::write(Parameter parameter, double value) {
    write([&](Face& face) {
        face.parameters.set(parameter, {value, 0});
        if (parameter == Parameter::rms_height) face.parameters.long_end = {};
        const std::size_t i = detail::index_of(parameter);
        for (std::size_t j = 0; j < detail::surface_parameter_count; ++j)
            face.parameters.correlation[i][j] = face.parameters.correlation[j][i] = i == j ? 1 : 0;
    });
}

FSTIFF_INLINE void Face::draw(const std::array<double, detail::surface_parameter_count>& drawn) {
    for (const ParameterRow& row : detail::surface_parameter_table)
        if (auto* known = parameters.find(row.parameter)) known->value = drawn[detail::index_of(row.parameter)];
}

FSTIFF_INLINE bool Face::is_open(Unknown unknown) const {
    return std::any_of(priors.begin(), priors.end(), [&](const Prior& prior) { return prior.which == unknown; });
}

FSTIFF_INLINE void Face::follow() {
    if (!radius_follows && !density_follows) return;
    const double sigma = parameters.rms_height.value;
    SpectralMoments<double> moments;
    if (rms_gradient && alpha) {
        moments = detail::moments_of_gradient(sigma, *rms_gradient, *alpha);
    } else if (density_follows) {  // of R, and of the gradient or alpha
        const double curvature = detail::radius_times_rms_curvature<double>() / parameters.peak_radius.value;
        moments.m4 = curvature * curvature;
        moments.m2 = rms_gradient ? *rms_gradient * *rms_gradient / 2 : sigma * std::sqrt(moments.m4 / *alpha);
    } else {  // of D_p, and of the gradient or alpha
        const double ratio = parameters.peak_density.value / detail::peak_density_of<double>({1, 1, 1});
        moments.m2 = rms_gradient ? *rms_gradient * *rms_gradient / 2 : sigma * sigma * (ratio / *alpha);
        moments.m4 = ratio * moments.m2;
    }
    if (radius_follows) parameters.peak_radius.value = detail::peak_radius_of(moments);
    if (density_follows) parameters.peak_density.value = detail::peak_density_of(moments);
}

FSTIFF_INLINE void Face::set_shape(const HeightShape<double>& height_shape) {
    shape = height_shape;
    bearing = bearing_of_shape(height_shape);
}

FSTIFF_INLINE std::optional<ImplausibleGradient> implausible_gradient(const Face& face, double r) {
    using enum ImplausibleGradient::Source;
    std::vector<ImplausibleGradient> gradients;
    const auto is_own = [&](const auto& waves) { return waves && waves->rms_gradient.value == *face.rms_gradient; };
    const bool as_measured =
        face.measured && face.rms_gradient && (is_own(face.measured->heights) || is_own(face.measured->all_waves));
    if (face.has_own_gradient()) gradients.push_back({as_measured ? measured : given, *face.rms_gradient});
    if (face.has_radius_and_density() && !is_as_measured(face)) {
        const auto [of_density, of_height] = detail::implied_gradients(face.roughness(), r);
        gradients.push_back({peaks, of_density});
        if (!face.has_own_gradient()) gradients.push_back({height, of_height});
    }
    for (const ImplausibleGradient& gradient : gradients)
        if (!detail::is_plausible_gradient(gradient.value)) return gradient;
    return std::nullopt;
}

FSTIFF_INLINE SpectralMoments<double> spectral_moments(const Face& face) {
    const Roughness<double> peaks = face.roughness();
    if (face.rms_gradient && face.alpha)
        return detail::moments_of_gradient(peaks.rms_height, *face.rms_gradient, *face.alpha);
    SpectralMoments<double> moments{peaks.rms_height * peaks.rms_height, 0, 0};
    if (face.has_radius_and_density())
        moments = moments_of_peaks(peaks.rms_height, peaks.peak_radius, peaks.peak_density);
    if (face.rms_gradient) moments.m2 = *face.rms_gradient * *face.rms_gradient / 2;
    if (face.alpha) moments.m2 = peaks.rms_height * std::sqrt(moments.m4 / *face.alpha);
    return moments;
}

FSTIFF_INLINE double hurst_exponent(const Face& face) {
    if (face.hurst) return *face.hurst;
    const double of_dimension = face.dimension() ? 2 - *face.dimension() : 0.8;
    return (std::max)(of_dimension, detail::least_hurst(spectral_moments(face), face.widest_band));
}

FSTIFF_INLINE bool has_isotropic_peaks(const Face& face) {
    return (face.has_own_gradient() || (face.alpha && !face.rms_gradient)) && spectral_moments(face).bandwidth() > 1.5;
}

FSTIFF_INLINE Eigen::Index missing_points(const MapOfSurface& map) {
    Eigen::Index missing = 0;
    for (const auto& part : map.maps) missing += part->size() - part->present();
    return missing;
}

/// The summits of \p map; where none is above its eight neighbours, because the highest points are equal, one of these.
FSTIFF_INLINE Summits<double> summits_or_highest(const HeightMap<double>& map) {
    Summits<double> result = summits_of(map);
    if (!result.summits.empty() || map.rows() < 5 || map.columns() < 5) return result;
    Eigen::Index j = 0, i = 0;
    const auto inner = map.heights.block(1, 1, map.rows() - 2, map.columns() - 2);
    inner.isNaN().select(-std::numeric_limits<double>::infinity(), inner).maxCoeff(&j, &i);
    ++j, ++i;
    if (map.heights.block(j - 1, i - 1, 3, 3).isNaN().any()) return result;
    auto top = detail::top_of(detail::shape_by_differences<double>(map.heights, j, i), map.dx, map.dy, 1.0);
    if (!(top.min_curvature > detail::min_curvature_ratio<double> * top.max_curvature)) return result;
    const MapHeights<double> heights(map);
    top.height += (heights.in_units(map.heights(j, i)) - heights.mean) * heights.unit;
    top.x += static_cast<double>(i) * map.dx, top.y += static_cast<double>(j) * map.dy;
    result.summits.push_back(top);
    return result;
}

FSTIFF_INLINE std::shared_ptr<const MapOfSurface> map_of_surface(
    std::vector<std::shared_ptr<const HeightMap<double>>> maps) {
    MapOfSurface result;
    result.maps = std::move(maps);
    double area = 0;
    bool complete = true;
    for (const auto& map : result.maps) {
        result.summits.push_back(detail::with_hertz_factors(summits_or_highest(*map)));
        const double rms = result.summits.back().rms_height;
        result.mean_square_height += map->area() * rms * rms;
        area += map->area();
        complete = complete && map->present() == map->size() && map->rows() >= 4 && map->columns() >= 4;
    }
    result.mean_square_height /= area;
    if (complete)
        result.spectra = std::make_shared<const SpectraOfMaps>([maps = result.maps, area](Edges edges) {
            SpectrumShells<double> sum;
            for (const auto& map : maps)
                sum = sum_of_spectra(sum, detail::scaled(map_spectrum(*map, edges), std::sqrt(map->area() / area)));
            return sum;
        });
    result.bearings = std::make_shared<const BearingsOfMaps>(result.maps, result.summits);
    return std::make_shared<const MapOfSurface>(std::move(result));
}

FSTIFF_INLINE std::string no_sum_of_maps(const Face& upper, const Face& lower) {
    if (!upper.map || !lower.map) return "not both faces are maps";
    for (const auto& map : upper.map->maps)
        for (const auto& other : lower.map->maps)
            if (std::string why = detail::no_sum_of(*map, *other); !why.empty()) return why;
    return "";
}

/// The map of \p surface in a contact: with all of its short waves, unless a lambda_s was given.
FSTIFF_INLINE std::shared_ptr<const HeightMap<double>> map_of_contact(const Surface<double>& surface) {
    const auto& [cut_offs, map] = std::tie(surface.cut_offs, surface.map);
    if (cut_offs.why_s != LambdaSReason::by_table || !map->unfiltered) return {map, &map->map};
    if (!cut_offs.lambda_c) return map->unfiltered;
    if (cut_offs.filter == CutOffFilter::robust) return {map, &map->map};
    return std::make_shared<const HeightMap<double>>(detail::gaussian_high_pass(*map->unfiltered, *cut_offs.lambda_c));
}

/// \p surface as the contact sees it, with the maps of \p shared, where there are any, in place of its own.
FSTIFF_INLINE Face face_as_found(const Surface<double>& surface,
                                 const std::shared_ptr<const MapOfSurface>& shared = nullptr) {
    Face face;
    face.parameters = surface;
    face.parameters.profile_fit.reset(), face.parameters.map_fit.reset(), face.parameters.islands.reset();
    if (!face.has_peaks()) face.parameters.r.reset(), face.parameters.theta.reset();
    face.widest_band = surface.widest_band;
    face.lambda_s = surface.cut_offs.lambda_s;
    face.heights = surface.heights;
    if (surface.heights) {
        const bool all = surface.all_waves && surface.all_waves->moments.bandwidth() > 1.5;  // else of no spectrum
        const HeightStatistics<double>& waves = all ? *surface.all_waves : *surface.heights;
        face.rms_gradient = waves.rms_gradient.value;
        face.gradient_error = waves.rms_gradient.error;
        face.alpha = waves.moments.bandwidth();
        face.set_shape(detail::counted_shape(*surface.heights, surface.shape_share));
    }
    std::vector<std::shared_ptr<const HeightMap<double>>> maps;  // which live as long as what was measured
    if (surface.map) maps.push_back(map_of_contact(surface));
    for (const Surface<double>& part : surface.parts)
        if (part.map) maps.push_back(map_of_contact(part));
    if (surface.map && maps.front().get() != &surface.map->map) face.filtered = {surface.map, &surface.map->map};
    if (shared)
        face.map = shared;
    else if (!maps.empty())
        face.map = map_of_surface(std::move(maps));
    const bool has_all_waves = surface.cut_offs.why_s == LambdaSReason::by_table;  // K does not depend on lambda_s
    for (const Surface<double>& neighbour : surface.neighbours) {
        face.neighbours.push_back(face_as_found(neighbour, has_all_waves ? face.map : nullptr));
        Face& other = face.neighbours.back();
        if (!other.has_peaks()) other.parameters.r = face.parameters.r, other.parameters.theta = face.parameters.theta;
        if (surface.all_waves) other.rms_gradient = face.rms_gradient, other.alpha = face.alpha;
    }
    return face;
}

FSTIFF_INLINE Face face_of(std::shared_ptr<const Surface<double>> measured) {
    Face face = face_as_found(*measured);
    face.measured = std::move(measured);
    return face;
}

/// The sum of two faces with the parameters \p parameters, without maps, neighbours and measurements.
FSTIFF_INLINE Face sum_with(const Face& upper, const Face& lower, const SpectralMoments<double>& a,
                            const SpectralMoments<double>& b, SurfaceParameters<double> parameters) {
    const SpectralMoments<double> sum = a + b;
    Face face;
    face.parameters = std::move(parameters);
    if (upper.rms_gradient || lower.rms_gradient) {
        face.rms_gradient = std::sqrt(2 * sum.m2);
        face.gradient_error =
            std::hypot(std::sqrt(2 * a.m2) * upper.gradient_error, std::sqrt(2 * b.m2) * lower.gradient_error) /
            *face.rms_gradient;
        face.gradient_growth = (a.m2 * upper.gradient_growth + b.m2 * lower.gradient_growth) / sum.m2;
    }
    face.gradient_of_islands = upper.gradient_of_islands || lower.gradient_of_islands;
    if (upper.alpha || lower.alpha) face.alpha = sum.bandwidth();
    if (upper.hurst || lower.hurst) face.hurst = (a.m2 * hurst_exponent(upper) + b.m2 * hurst_exponent(lower)) / sum.m2;
    const HeightShape<double> shape = detail::sum_of_shapes(upper.shape, a.m0, lower.shape, b.m0);
    face.set_shape(detail::counted_shape(shape.skewness, shape.kurtosis, 1.0));
    for (const Face* part : {&upper, &lower}) {
        if (!part->parameters.why_no_density.empty()) face.parameters.why_no_density = part->parameters.why_no_density;
        face.priors.insert(face.priors.end(), part->priors.begin(), part->priors.end());
    }
    return face;
}

/// The sum of two faces, the lower of which is shifted.
FSTIFF_INLINE Face sum_in_order(const Face& upper, const Face& lower, int shifts, std::uint64_t seed) {
    const SpectralMoments<double> a = spectral_moments(upper), b = spectral_moments(lower);
    const auto of_values = [&] {
        return detail::stated(
            sum_of_faces(detail::rough_face(upper.parameters, a), detail::rough_face(lower.parameters, b)));
    };
    Face face = sum_with(upper, lower, a, b,
                         shifts == 0 ? of_values() : detail::uncertain_sum(upper.parameters, a, lower.parameters, b));
    if (shifts == 0) return face;
    if (upper.heights && lower.heights) face.heights = sum_of_faces(*upper.heights, *lower.heights);
    face.spectrum_of_map = upper.spectrum_of_map && lower.spectrum_of_map;
    for (std::size_t k = 0; k < (std::max)(upper.neighbours.size(), lower.neighbours.size()); ++k) {
        const auto neighbour = [k](const Face& part) -> const Face& {
            return part.neighbours.empty() ? part : part.neighbours[(std::min)(k, part.neighbours.size() - 1)];
        };
        face.neighbours.push_back(sum_in_order(neighbour(upper), neighbour(lower), shifts, seed));
    }
    if (!no_sum_of_maps(upper, lower).empty()) return face;
    MapOfSurface sum_map;
    const auto &above = upper.map->maps, &below = lower.map->maps;
    for (std::size_t k = 0; k < static_cast<std::size_t>(shifts); ++k) {  // of several maps each in turn
        HeightMap<double> map =
            detail::random_sum(*above[k % above.size()], *below[k / above.size() % below.size()], seed);
        sum_map.summits.push_back(summits_of(map));
        sum_map.maps.push_back(std::make_shared<const HeightMap<double>>(std::move(map)));
    }
    if (upper.map->spectra && lower.map->spectra)
        sum_map.spectra =
            std::make_shared<const SpectraOfMaps>([a = upper.map->spectra, b = lower.map->spectra](Edges edges) {
                return sum_of_spectra(a->shells(edges), b->shells(edges));
            });
    sum_map.mean_square_height = upper.map->mean_square_height + lower.map->mean_square_height;
    sum_map.bearings = std::make_shared<const BearingsOfMaps>(sum_map.maps, sum_map.summits);
    face.map = std::make_shared<const MapOfSurface>(std::move(sum_map));
    return face;
}

FSTIFF_INLINE Face sum_of_faces(const Face& upper, const Face& lower, int shifts, std::uint64_t seed) {
    const bool in_order = upper.parameters.rms_height.value >= lower.parameters.rms_height.value;
    return in_order ? sum_in_order(upper, lower, shifts, seed) : sum_in_order(lower, upper, shifts, seed);
}

}  // namespace fstiff::inline v0_1::detail
