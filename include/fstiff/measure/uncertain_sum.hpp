// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sum of two faces whose parameters have errors, and the skewness and kurtosis of the sum.
///
///     errors and their correlation: of 4000 pairs of faces drawn by SurfaceSampler, added by sum_of_faces()
///     skewness: sum of sigma^3 skewness over sigma^3         kurtosis - 3: sum of sigma^4 (kurtosis - 3) over sigma^4
///
/// The faces are independent, so that cumulants add. D is drawn with the shares of both faces in the structure
/// function.
///
/// Reference   surface/moments.hpp; Kendall, Stuart, The Advanced Theory of Statistics 1 (Griffin, 1977) (cumulants).
/// Units       SI
/// Valid       as SurfaceParameters and RoughFace
/// Accuracy    errors 2 % (4000 draws); values exact (tests/measure/uncertain_sum_test.cpp)

#include <fstiff/measure/height_shape.hpp>
#include <fstiff/measure/uncertain_surface.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Values of \p surface, whose spectrum has \p moments, without their errors.
template <Real T>
[[nodiscard]] RoughFace<T> rough_face(const SurfaceParameters<T>& surface, const SpectralMoments<T>& moments) {
    const auto value = [](const std::optional<Measurement<T>>& measurement) {
        return measurement ? std::optional<T>(measurement->value) : std::nullopt;
    };
    return {{surface.rms_height.value, surface.peak_radius.value, surface.peak_density.value,
             surface.max_peak_height.value},
            moments,
            value(surface.fractal_dimension),
            value(surface.fractal_roughness),
            value(surface.r),
            value(surface.theta)};
}

/// Parameters of \p face, without errors.
template <Real T>
[[nodiscard]] SurfaceParameters<T> stated(const RoughFace<T>& face) {
    SurfaceParameters<T> result;
    result.rms_height.value = face.roughness.rms_height;
    result.peak_radius.value = face.roughness.peak_radius;
    result.peak_density.value = face.roughness.peak_density;
    result.max_peak_height.value = face.roughness.max_peak_height;
    if (face.fractal_dimension) result.fractal_dimension = {*face.fractal_dimension, 0};
    if (face.fractal_roughness) result.fractal_roughness = {*face.fractal_roughness, 0};
    if (face.r) result.r = {*face.r, 0};
    if (face.theta) result.theta = {*face.theta, 0};
    return result;
}

/// \p face with the parameters \p drawn about its own. An error of the height is that of its longest waves, which have
/// no gradient.
template <Real T>
[[nodiscard]] RoughFace<T> redrawn(RoughFace<T> face, const std::array<T, surface_parameter_count>& drawn) {
    const auto value = [&](Parameter parameter) { return drawn[index_of(parameter)]; };
    const T taller = value(Parameter::rms_height) / face.roughness.rms_height;
    const T bent = face.has_peaks() ? face.roughness.peak_radius / value(Parameter::peak_radius) : T(1);
    face.moments = {face.moments.m0 * taller * taller, face.moments.m2, face.moments.m4 * bent * bent};
    face.roughness = {value(Parameter::rms_height), value(Parameter::peak_radius), value(Parameter::peak_density),
                      face.roughness.max_peak_height};
    if (face.fractal_dimension) face.fractal_dimension = value(Parameter::fractal_dimension);
    face.fractal_roughness.reset();
    if (face.r) face.r = value(Parameter::r), face.theta = value(Parameter::theta);
    return face;
}

/// Parameters of \p face in the order of Parameter, logarithms for those that vary by a factor; 0 where not known.
template <Real T>
[[nodiscard]] std::array<T, surface_parameter_count> coordinates(const RoughFace<T>& face) {
    std::array<T, surface_parameter_count> x{};
    const auto put = [&](Parameter p, T value) {
        if (value == T(0)) return;
        x[index_of(p)] = parameter_table[index_of(p)].variation == Variation::log ? std::log(value) : value;
    };
    put(Parameter::rms_height, face.roughness.rms_height);
    put(Parameter::peak_radius, face.roughness.peak_radius);
    put(Parameter::peak_density, face.roughness.peak_density);
    if (face.fractal_dimension) put(Parameter::fractal_dimension, *face.fractal_dimension);
    if (face.r) put(Parameter::r, *face.r), put(Parameter::theta, *face.theta);
    return x;
}

/// Sum of \p of_a and \p of_b, whose spectra have the moments \p moments_a and \p moments_b. R_p and G of the sum have
/// no errors.
/// \throws domain_error for parameters or errors out of range.
template <Real T>
[[nodiscard]] SurfaceParameters<T> uncertain_sum(const SurfaceParameters<T>& of_a, const SpectralMoments<T>& moments_a,
                                                 const SurfaceParameters<T>& of_b, const SpectralMoments<T>& moments_b,
                                                 std::uint64_t seed = 2014) {
    constexpr std::size_t draws = 4000, size = surface_parameter_count;
    const RoughFace<T> a = rough_face(of_a, moments_a), b = rough_face(of_b, moments_b), nominal = sum_of_faces(a, b);
    SurfaceSampler<T> draw_a(of_a, seed), draw_b(of_b, ~seed);
    const T share = share_of_face(a, b);
    std::array<T, size> mean{};
    std::array<std::array<T, size>, size> square{};
    const std::array<T, size> centre = coordinates(nominal);
    for (std::size_t n = 0; n < draws; ++n) {
        const RoughFace<T> first = redrawn(a, draw_a()), second = redrawn(b, draw_b());
        RoughFace<T> sum = sum_of_faces(first, second);
        if (sum.fractal_dimension)
            sum.fractal_dimension = share * *first.fractal_dimension + (1 - share) * *second.fractal_dimension;
        std::array<T, size> x = coordinates(sum);
        for (std::size_t i = 0; i < size; ++i) x[i] -= centre[i];
        for (std::size_t i = 0; i < size; ++i) {
            mean[i] += x[i] / T(draws);
            for (std::size_t j = 0; j < size; ++j) square[i][j] += x[i] * x[j] / T(draws);
        }
    }
    SurfaceParameters<T> out = stated(nominal);
    out.long_end = mean_of_ends(of_a.long_end, of_b.long_end, moments_a.m0 / (moments_a.m0 + moments_b.m0));
    if (out.fractal_dimension)
        out.dimension_window_error =
            std::hypot(share * of_a.dimension_window_error, (1 - share) * of_b.dimension_window_error);
    const auto variance = [&](std::size_t i) { return (std::max)(T(0), square[i][i] - mean[i] * mean[i]); };
    for (std::size_t i = 0; i < size; ++i)
        if (auto* known = out.find(parameter_table[i].parameter)) {
            const bool log = parameter_table[i].variation == Variation::log;  // then s^2 = ln(1 + (error/value)^2)
            known->error = log ? known->value * std::sqrt(std::expm1(variance(i))) : std::sqrt(variance(i));
        }
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const T norm = std::sqrt(variance(i) * variance(j)), shared = square[i][j] - mean[i] * mean[j];
            if (norm > T(0)) out.correlation[i][j] = out.correlation[j][i] = std::clamp(shared / norm, T(-1), T(1));
        }
    return out;
}

/// Height statistics of the sum of two faces with independent heights.
template <Real T>
[[nodiscard]] HeightStatistics<T> sum_of_faces(const HeightStatistics<T>& a, const HeightStatistics<T>& b) {
    HeightStatistics<T> sum;
    sum.moments = a.moments + b.moments;
    const T share_a = a.moments.m0 / sum.moments.m0, share_b = b.moments.m0 / sum.moments.m0;
    const auto cumulant = [&](const Measurement<T>& first, const Measurement<T>& second, T power, T gaussian) {
        const T of_a = std::pow(share_a, power), of_b = std::pow(share_b, power);
        return Measurement<T>{gaussian + of_a * (first.value - gaussian) + of_b * (second.value - gaussian),
                              std::hypot(of_a * first.error, of_b * second.error)};
    };
    sum.skewness = cumulant(a.skewness, b.skewness, T(1.5), T(0));
    sum.kurtosis = cumulant(a.kurtosis, b.kurtosis, T(2), T(3));
    const T gradient = std::hypot(a.rms_gradient.value, b.rms_gradient.value);
    sum.rms_gradient = {gradient, std::hypot(a.rms_gradient.value / gradient * a.rms_gradient.error,
                                             b.rms_gradient.value / gradient * b.rms_gradient.error)};
    return sum;
}

}  // namespace detail

}}  // namespace fstiff
