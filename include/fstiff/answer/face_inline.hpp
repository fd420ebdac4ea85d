// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/face.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/face.hpp>

#include <fstiff/answer/checks.hpp>
#include <fstiff/measure/uncertain_sum.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

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

FSTIFF_INLINE std::string no_sum_of_maps(const Face& upper, const Face& lower) {
    if (!upper.map || !lower.map) return "not both faces are maps";
    return upper.map->no_sum(*lower.map);
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
    face.whole = upper.whole && lower.whole;
    for (std::size_t k = 0; k < (std::max)(upper.neighbours.size(), lower.neighbours.size()); ++k) {
        const auto neighbour = [k](const Face& part) -> const Face& {
            return part.neighbours.empty() ? part : part.neighbours[(std::min)(k, part.neighbours.size() - 1)];
        };
        face.neighbours.push_back(sum_in_order(neighbour(upper), neighbour(lower), shifts, seed));
    }
    if (!no_sum_of_maps(upper, lower).empty()) return face;
    face.map = upper.map->sum(*lower.map, shifts, seed);
    return face;
}

FSTIFF_INLINE Face sum_of_faces(const Face& upper, const Face& lower, int shifts, std::uint64_t seed) {
    const bool in_order = upper.parameters.rms_height.value >= lower.parameters.rms_height.value;
    return in_order ? sum_in_order(upper, lower, shifts, seed) : sum_in_order(lower, upper, shifts, seed);
}

}}}  // namespace fstiff::detail
