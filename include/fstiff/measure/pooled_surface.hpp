// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Several measurements of one surface, such as parallel traces, pooled as one surface.
///
///     m0, m2, m4, S, triples    means, weighted by the share w of the length or area;    R_p    maximum
///     D and r, theta            means over the measurements that have them
///     error^2       max(sum w^2 error^2, k^2 sum w^2/(1 - sum w^2) sum w (x - mean)^2)  (logarithms: sigma, R, D_p)
///     k                         t_(n-1)(0.95)/1.645 (Student): 3.84 for two measurements, 1.30 for five
///
/// Where the tables choose different cut-offs, the longest is used for all measurements, and none where one has none.
/// Derivation  docs/theory-surface.md
/// Reference   Student, Biometrika 6 (1908) 1 (math/statistics.hpp); surface/moments.hpp
/// Units       SI
/// Valid       at least one measurement, all of one kind and with the same cut-offs; sizes > 0
/// Accuracy    1e-13 of the formulae (tests/measure/pooled_surface_test.cpp, tests/scene/one_measurement_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/measure/uncertain_sum.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Property in which two measurements of one surface differ, so that they cannot be pooled.
enum class Unlikeness { none, kind, lambda_s, lambda_c, step };

}  // namespace detail

template <>
inline constexpr auto enum_names<detail::Unlikeness> =
    detail::name_list<detail::Unlikeness>({{detail::Unlikeness::none, "nothing"},
                                           {detail::Unlikeness::kind, "kind"},
                                           {detail::Unlikeness::lambda_s, "lambda_s"},
                                           {detail::Unlikeness::lambda_c, "lambda_c"},
                                           {detail::Unlikeness::step, "step"}});

namespace detail {

/// First of kind, lambda_s, lambda_c and, without lambda_s, the steps in which \p other differs from \p first.
template <Real T>
[[nodiscard]] Unlikeness unlikeness(const Surface<T>& first, const Surface<T>& other);

/// Distance of neighbouring heights of a measured surface, the shorter one for a map [m].
template <Real T>
[[nodiscard]] T step_of(const Surface<T>& surface) {
    return surface.profile ? surface.profile->profile.spacing : (std::min)(surface.map->map.dx, surface.map->map.dy);
}

/// Common \p cut_off for all \p surfaces where \p asked leaves it to the tables and these differ: the longest, or none
/// where one has none. Else \p asked.
template <Real T, class Measured>
[[nodiscard]] CutOff<T> shared_cut_off(const CutOff<T>& asked, const std::vector<Measured>& surfaces,
                                       std::optional<T> CutOffs<T>::*cut_off);

}  // namespace detail

/// Pools \p parts as one surface, which keeps them. \throws domain_error for no part, parts that differ in kind or
/// cut-offs, or parameters out of range.
template <Real T>
[[nodiscard]] Surface<T> pooled(std::vector<Surface<T>> parts);

/// Measures and pools several profiles of one surface. \throws domain_error as measure() of one profile and pooled().
template <Real T>
[[nodiscard]] Surface<T> measure(const std::vector<Profile<T>>& profiles, const MeasureOptions<T>& options = {});
/// Same as above for maps.
template <Real T>
[[nodiscard]] Surface<T> measure(const std::vector<HeightMap<T>>& maps, const MeasureOptions<T>& options = {});

namespace detail {

/// One number of a measurement, weighted by its length [m] or area [m^2].
template <Real T = double>
struct SizedMeasurement {
    Measurement<T> measured{};
    T size{};
};

/// Error of the mean of \p measurements: from the errors of the measurements or from their scatter.
/// \throws domain_error for no measurement.
template <Real T>
[[nodiscard]] T pooled_error(const std::vector<SizedMeasurement<T>>& measurements) {
    require(!measurements.empty(), "number of measurements", measurements.size(), "at least 1");
    T size = 0, mean = 0, within = 0, squares = 0, scatter = 0;
    for (const auto& part : measurements) size += part.size;
    for (const auto& part : measurements) mean += part.size / size * part.measured.value;
    for (const auto& part : measurements) {
        const T w = part.size / size, away = part.measured.value - mean;
        within += w * w * part.measured.error * part.measured.error;
        squares += w * w;
        scatter += w * away * away;
    }
    if (measurements.size() == 1) return std::sqrt(within);
    const T k = math::student_quantile(math::normal_95<T>, static_cast<int>(measurements.size()) - 1) /
                math::normal_95<T>.value;
    return std::sqrt((std::max)(within, k * k * squares / (1 - squares) * scatter));
}

}  // namespace detail

/// Statistics of the heights of several measurements of one surface, each about its own mean, of \p sizes.
/// \throws domain_error for none, or for different numbers of them.
template <Real T>
[[nodiscard]] HeightStatistics<T> pooled(const std::vector<HeightStatistics<T>>& parts, const std::vector<T>& sizes) {
    detail::require(!parts.empty() && parts.size() == sizes.size(), "number of measurements", parts.size(),
                    "at least 1, as the sizes");
    T size = 0;
    for (const T length : sizes) size += length;
    HeightStatistics<T> out;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const T w = sizes[i] / size;
        out.moments =
            out.moments + SpectralMoments<T>{w * parts[i].moments.m0, w * parts[i].moments.m2, w * parts[i].moments.m4};
    }
    T third = 0, fourth = 0;
    std::vector<detail::SizedMeasurement<T>> skewness, kurtosis, gradient;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const T w = sizes[i] / size, ratio = parts[i].moments.m0 / out.moments.m0;
        third += w * ratio * std::sqrt(ratio) * parts[i].skewness.value;
        fourth += w * ratio * ratio * parts[i].kurtosis.value;
        skewness.push_back({parts[i].skewness, sizes[i]});
        kurtosis.push_back({parts[i].kurtosis, sizes[i]});
        gradient.push_back({parts[i].rms_gradient, sizes[i]});
    }
    T squares = 0;
    for (const auto& part : gradient) squares += part.size / size * part.measured.value * part.measured.value;
    out.skewness = {third, detail::pooled_error(skewness)};
    out.kurtosis = {fourth, detail::pooled_error(kurtosis)};
    out.rms_gradient = {std::sqrt(squares), detail::pooled_error(gradient)};
    return out;
}

namespace detail {

/// Whether two lengths differ by more than rounding.
template <Real T>
[[nodiscard]] bool lengths_differ(T a, T b) {
    return std::abs(a - b) > T(1e-6) * std::abs(a);
}
template <Real T>
[[nodiscard]] bool lengths_differ(const std::optional<T>& a, const std::optional<T>& b) {
    return a.has_value() != b.has_value() || (a && lengths_differ(*a, *b));
}

/// Values of \p surface, with the moments of its heights where these are known.
template <Real T>
[[nodiscard]] RoughFace<T> rough_face(const Surface<T>& surface) {
    return rough_face<T>(surface, surface.heights
                                      ? surface.heights->moments
                                      : moments_of_peaks(surface.rms_height.value, surface.peak_radius.value,
                                                         surface.peak_density.value));
}

/// Mean over those of \p parts that \p knows selects.
template <Real T, class Knows>
[[nodiscard]] std::optional<RoughFace<T>> mean_face(const std::vector<Surface<T>>& parts, const Knows& knows) {
    T size = 0;
    for (const auto& part : parts)
        if (knows(part)) size += part.size;
    std::optional<RoughFace<T>> mean;
    for (const auto& part : parts) {
        if (!knows(part)) continue;
        const RoughFace<T> share = scaled(rough_face(part), std::sqrt(part.size / size));
        mean = mean ? sum_of_faces(*mean, share) : share;
    }
    return mean;
}

/// Mean over all \p parts; R and D_p, D and G, and r and theta, over the parts that have them.
template <Real T>
[[nodiscard]] RoughFace<T> mean_of_known(const std::vector<Surface<T>>& parts) {
    RoughFace<T> mean = *mean_face(parts, [](const auto&) { return true; });
    mean.fractal_dimension.reset(), mean.fractal_roughness.reset(), mean.r.reset(), mean.theta.reset();
    if (const auto face = mean_face(parts, [](const auto& part) { return part.fractal_dimension.has_value(); }))
        mean.fractal_dimension = face->fractal_dimension, mean.fractal_roughness = face->fractal_roughness;
    if (const auto face = mean_face(parts, [](const auto& part) { return part.r.has_value(); }))
        mean.r = face->r, mean.theta = face->theta;
    if (const auto face = mean_face(parts, [](const auto& part) { return rough_face(part).has_peaks(); }))
        mean.roughness.peak_radius = face->roughness.peak_radius,
        mean.roughness.peak_density = face->roughness.peak_density;
    mean.roughness.max_peak_height = 0;
    for (const auto& part : parts)
        mean.roughness.max_peak_height = (std::max)(mean.roughness.max_peak_height, part.max_peak_height.value);
    return mean;
}

/// Sets the error of the parameter \p row of \p pool to that of its mean over \p parts; logarithms for parameters that
/// vary by a factor.
template <Real T>
void pool_error(Surface<T>& pool, const std::vector<Surface<T>>& parts, const ParameterRow& row) {
    const bool log = row.variation == Variation::log;
    std::vector<SizedMeasurement<T>> known;
    for (const auto& part : parts) {
        const Measurement<T>* m = part.find(row.parameter);
        if (!m) continue;
        const T relative = m->error / m->value;
        known.push_back(
            {log ? Measurement<T>{std::log(m->value), std::sqrt(std::log1p(relative * relative))} : *m, part.size});
    }
    if (known.empty() || !pool.find(row.parameter)) return;
    const T error = pooled_error(known);
    Measurement<T>& mean = *pool.find(row.parameter);
    if (log) mean.value = std::exp(std::log(mean.value));
    mean.error = log ? mean.value * std::sqrt(std::expm1(error * error)) : error;
}

/// Errors of \p pool, whose values are means over \p parts.
template <Real T>
void pool_errors(Surface<T>& pool, const std::vector<Surface<T>>& parts) {
    for (std::size_t i = 0; i < surface_parameter_count; ++i) pool_error(pool, parts, parameter_table[i]);
    for (std::size_t i = 0; i < surface_parameter_count; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            T mean = 0;
            for (const auto& part : parts) mean += part.size / pool.size * part.correlation[i][j];
            pool.correlation[i][j] = pool.correlation[j][i] = mean;
        }
    std::vector<SizedMeasurement<T>> highest, log_roughness;
    T sizes = 0, window = 0;
    for (const auto& part : parts) {
        highest.push_back({part.max_peak_height, part.size});
        if (part.fractal_dimension)
            sizes += part.size, window = std::hypot(window, part.size * part.dimension_window_error);
        if (const auto& g = part.fractal_roughness)
            log_roughness.push_back({{std::log(g->value), g->error / g->value}, part.size});
    }
    pool.max_peak_height.error = pooled_error(highest);
    if (sizes > T(0)) pool.dimension_window_error = window / sizes;
    if (pool.fractal_roughness) {
        pool.log_fractal_roughness_error = pooled_error(log_roughness);
        pool.fractal_roughness->error = pool.fractal_roughness->value * pool.log_fractal_roughness_error;
    }
}

/// Concerns of all \p parts, and parameter_unknown for \p pool; form, step, scan_lines and implausible_gradient of one
/// are enough.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> pooled_concerns(const Surface<T>& pool,
                                                           const std::vector<Surface<T>>& parts) {
    using enum MeasuredConcern;
    const auto has = [](const Surface<T>& part, MeasuredConcern concern) {
        return std::find(part.concerns.begin(), part.concerns.end(), concern) != part.concerns.end();
    };
    std::vector<MeasuredConcern> concerns;
    for (const MeasuredConcern concern : parts.front().concerns) {
        if (concern == few_peaks || concern == radius_uncertain || concern == density_uncertain ||
            concern == parameter_unknown || concern == form || concern == step || concern == scan_lines ||
            concern == implausible_gradient)
            continue;
        if (std::all_of(parts.begin(), parts.end(), [&](const auto& part) { return has(part, concern); }))
            concerns.push_back(concern);
    }
    for (const MeasuredConcern concern : {form, step, scan_lines, implausible_gradient})
        if (std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return has(part, concern); }))
            concerns.push_back(concern);
    add_peak_concerns(concerns, pool.peaks_counted, pool.peak_radius, pool.peak_density);
    if (!unknown_parameters(pool).empty()) concerns.push_back(parameter_unknown);
    return concerns;
}

/// Share of the shape of all heights of \p parts; the mean of the shares where some heights are not kept.
template <Real T>
[[nodiscard]] T pooled_share(const std::vector<Surface<T>>& parts) {
    ShapeOfHeights<T> shape;
    T sum = 0, size = 0;
    for (const auto& part : parts) {
        if (part.profile) shape.add(part.profile->profile, autocorrelation(part.profile->profile));
        if (part.map) shape.add(part.map->map);
        sum += part.size * part.shape_share, size += part.size;
    }
    const bool kept =
        std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.profile || part.map; });
    return kept ? shape.share() : size > T(0) ? sum / size : T(0);
}

/// Surfaces of \p heights, each measured with the common cut-offs.
template <Real T, class Heights>
[[nodiscard]] Surface<T> measure_several(const std::vector<Heights>& heights, MeasureOptions<T> options) {
    const auto measured = [&] {
        std::vector<Surface<T>> parts;
        for (const Heights& sample : heights) parts.push_back(measure(sample, options));
        return parts;
    };
    std::vector<Surface<T>> parts = measured();
    const CutOff<T> lambda_s = shared_cut_off(options.lambda_s, parts, &CutOffs<T>::lambda_s);
    const CutOff<T> lambda_c =
        options.form_cut_off ? options.lambda_c : shared_cut_off(options.lambda_c, parts, &CutOffs<T>::lambda_c);
    const bool again =
        lambda_s.automatic() != options.lambda_s.automatic() || lambda_c.automatic() != options.lambda_c.automatic();
    options.lambda_s = lambda_s, options.lambda_c = lambda_c;
    if (again) parts = measured();
    return pooled(std::move(parts));
}

template <Real T>
Unlikeness unlikeness(const Surface<T>& first, const Surface<T>& other) {
    if (!first.profile != !other.profile) return Unlikeness::kind;
    if (lengths_differ(other.cut_offs.lambda_s, first.cut_offs.lambda_s)) return Unlikeness::lambda_s;
    if (lengths_differ(other.cut_offs.lambda_c, first.cut_offs.lambda_c)) return Unlikeness::lambda_c;
    if (other.cut_offs.lambda_s || !(first.profile || (first.map && other.map))) return Unlikeness::none;
    const auto longer_step = [](const Surface<T>& surface) {
        return surface.map ? (std::max)(surface.map->map.dx, surface.map->map.dy) : step_of(surface);
    };
    return lengths_differ(step_of(other), step_of(first)) || lengths_differ(longer_step(other), longer_step(first))
               ? Unlikeness::step
               : Unlikeness::none;
}

template <Real T, class Measured>
CutOff<T> shared_cut_off(const CutOff<T>& asked, const std::vector<Measured>& surfaces,
                         std::optional<T> CutOffs<T>::*cut_off) {
    if (!asked.automatic() || surfaces.empty()) return asked;
    const auto [low, high] = std::minmax_element(surfaces.begin(), surfaces.end(), [&](const auto& a, const auto& b) {
        return (a.cut_offs.*cut_off).value_or(0) < (b.cut_offs.*cut_off).value_or(0);
    });
    const std::optional<T> least = low->cut_offs.*cut_off, most = high->cut_offs.*cut_off;
    if (!most || (least && !lengths_differ(*least, *most))) return asked;
    return CutOff<T>::of(least ? most : least);
}

}  // namespace detail

template <Real T>
Surface<T> pooled(std::vector<Surface<T>> parts) {
    detail::require(!parts.empty(), "number of measurements", parts.size(), "at least 1");
    if (parts.size() == 1) return std::move(parts.front());
    const Surface<T>& first = parts.front();
    for (const auto& part : parts)
        if (const auto kind = detail::unlikeness(first, part); kind != detail::Unlikeness::none)
            throw domain_error("measurements of unlike " + std::string(name_of(kind)) + ": must be alike to be pooled");
    Surface<T> pool{detail::stated(detail::mean_of_known(parts))};
    pool.cut_offs = first.cut_offs;
    pool.is_profile = first.is_profile;
    pool.widest_band = 0;
    std::vector<HeightStatistics<T>> heights, all_waves;
    std::vector<T> sizes;
    for (const auto& part : parts) {
        pool.long_end = detail::mean_of_ends(pool.long_end, part.long_end, pool.size / (pool.size + part.size));
        pool.size += part.size, pool.peaks_counted += part.peaks_counted, pool.blocks += part.blocks;
        pool.widest_band = (std::max)(pool.widest_band, part.widest_band);
        if (part.heights) heights.push_back(*part.heights);
        if (part.all_waves) all_waves.push_back(*part.all_waves);
        sizes.push_back(part.size);
    }
    detail::pool_errors(pool, parts);
    if (!pool.fractal_roughness) pool.why_no_dimension = first.why_no_dimension;
    if (!pool.r) pool.why_no_peaks = first.why_no_peaks;
    if (!pool.find(Parameter::peak_density)) pool.why_no_density = first.why_no_density;
    if (heights.size() == parts.size()) {
        pool.heights = pooled(heights, sizes);
        pool.rms_gradient = pool.heights->rms_gradient;
        pool.shape_share = detail::pooled_share(parts);
        if (all_waves.size() == parts.size()) pool.all_waves = pooled(all_waves, sizes);
    }
    for (const Surface<T>& neighbour : first.neighbours) {
        std::vector<Surface<T>> alike;  // one of every part
        for (const auto& part : parts)
            for (const Surface<T>& candidate : part.neighbours)
                if (detail::unlikeness(neighbour, candidate) == detail::Unlikeness::none) alike.push_back(candidate);
        if (alike.size() == parts.size()) pool.neighbours.push_back(pooled(std::move(alike)));
    }
    pool.concerns = detail::pooled_concerns(pool, parts);
    pool.parts = std::move(parts);
    return pool;
}

template <Real T>
Surface<T> measure(const std::vector<Profile<T>>& profiles, const MeasureOptions<T>& options) {
    return detail::measure_several<T>(profiles, options);
}

template <Real T>
Surface<T> measure(const std::vector<HeightMap<T>>& maps, const MeasureOptions<T>& options) {
    return detail::measure_several<T>(maps, options);
}

}}  // namespace fstiff
