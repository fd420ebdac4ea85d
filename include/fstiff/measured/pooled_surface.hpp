// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Several measurements of one surface, such as traces side by side, as one.
///
///     spectra are averaged, each weighted by its share w of the length or area: m0, m2, m4, S and the triples are means
///     D and r, theta    of the measurements that know them
///     R_p               the highest
///     error^2           the greater of   sum of w^2 error^2                                     errors of the measurements
///                       and              k^2 sum of w^2/(1 - sum of w^2) sum of w (x - mean)^2    their scatter
///     k                 t_(n-1)(0.95)/1.645 by Student, because the scatter of a few is badly known: 3.84 of two, 1.30 of five
///
/// The average of n surfaces is their sum (surface/two_faces.hpp) with each of the heights sqrt(w) times as great. sigma, R and
/// D_p scatter by their logarithms. Correlations of the errors are means.
///
/// Reference   Student, Biometrika 6 (1908) 1 (math/statistics.hpp); surface/two_faces.hpp.
/// Units       SI
/// Valid       one measurement at least, of one kind and behind the same cut-offs; sizes > 0
/// Accuracy    1e-13 of the formulae (tests/measured/pooled_surface_test.cpp)

#include <fstiff/math/statistics.hpp>
#include <fstiff/measured/uncertain_sum.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace fstiff {

/// One measurement of a surface.
template <Real T = double>
struct MeasuredFace {
    RoughFace<T> face{};
    UncertainSurface<T> uncertain{};
    T size{};  ///< length of a profile [m], or area of a map [m^2]
};

/// The same with one value only.
template <Real T = double>
struct SizedMeasurement {
    Measurement<T> measured{};
    T size{};
};

/// The error of the mean of \p all, of the measurements themselves or of their scatter.
/// \throws domain_error for no measurement.
template <Real T>
[[nodiscard]] T pooled_error(const std::vector<SizedMeasurement<T>>& all) {
    require(!all.empty(), "number of measurements", all.size(), "at least 1");
    T size = 0, mean = 0, within = 0, squares = 0, scatter = 0;
    for (const auto& one : all) size += one.size;
    for (const auto& one : all) mean += one.size / size * one.measured.value;
    for (const auto& one : all) {
        const T w = one.size / size, away = one.measured.value - mean;
        within += w * w * one.measured.error * one.measured.error;
        squares += w * w;
        scatter += w * away * away;
    }
    if (all.size() == 1) return std::sqrt(within);
    const T k = student_quantile(normal_95<T>, static_cast<int>(all.size()) - 1) / normal_95<T>.value;
    return std::sqrt((std::max)(within, k * k * squares / (1 - squares) * scatter));
}

namespace detail {

/// The average of the faces of \p all that \p knows picks.
template <Real T, class Knows>
[[nodiscard]] std::optional<RoughFace<T>> mean_face(const std::vector<MeasuredFace<T>>& all, const Knows& knows) {
    T size = 0;
    for (const auto& one : all)
        if (knows(one.face)) size += one.size;
    std::optional<RoughFace<T>> mean;
    for (const auto& one : all) {
        if (!knows(one.face)) continue;
        const RoughFace<T> share = scaled(one.face, std::sqrt(one.size / size));
        mean = mean ? sum_of_faces(*mean, share) : share;
    }
    return mean;
}

}  // namespace detail

/// \p all as one. \throws domain_error for no measurement, or parameters out of range.
template <Real T>
[[nodiscard]] MeasuredFace<T> pooled(const std::vector<MeasuredFace<T>>& all) {
    require(!all.empty(), "number of measurements", all.size(), "at least 1");
    if (all.size() == 1) return all.front();
    MeasuredFace<T> out;
    out.face = *detail::mean_face(all, [](const RoughFace<T>&) { return true; });
    out.face.fractal_dimension.reset(), out.face.fractal_roughness.reset();
    out.face.r.reset(), out.face.theta.reset();
    const auto with_dimension =
        detail::mean_face(all, [](const auto& one) { return one.fractal_dimension.has_value(); });
    if (with_dimension) {
        out.face.fractal_dimension = with_dimension->fractal_dimension;
        out.face.fractal_roughness = with_dimension->fractal_roughness;
    }
    if (const auto with_triples = detail::mean_face(all, [](const auto& one) { return one.r.has_value(); })) {
        out.face.r = with_triples->r;
        out.face.theta = with_triples->theta;
    }
    out.face.roughness.max_peak_height = 0;
    for (const auto& one : all) {
        out.size += one.size;
        out.face.roughness.max_peak_height =
            (std::max)(out.face.roughness.max_peak_height, one.face.roughness.max_peak_height);
    }
    const std::array<T, surface_parameter_count> centre = detail::coordinates(out.face);
    for (std::size_t i = 0; i < surface_parameter_count; ++i) {
        const bool log = parameter_table[i].variation == Variation::log;
        std::vector<SizedMeasurement<T>> known;  // in coordinates: logarithms where the parameter varies by a factor
        for (const auto& one : all) {
            if (!one.uncertain.known[i]) continue;
            const T error = one.uncertain.error[i], relative = error / one.uncertain.value[i];
            known.push_back(
                {{detail::coordinates(one.face)[i], log ? std::sqrt(std::log1p(relative * relative)) : error},
                 one.size});
        }
        if (known.empty()) continue;
        const T error = pooled_error(known), value = log ? std::exp(centre[i]) : centre[i];
        out.uncertain.set(parameter_table[i].parameter,
                          {value, log ? value * std::sqrt(std::expm1(error * error)) : error});
    }
    for (std::size_t i = 0; i < surface_parameter_count; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            T mean = 0;
            for (const auto& one : all) mean += one.size / out.size * one.uncertain.correlation[i][j];
            out.uncertain.correlation[i][j] = out.uncertain.correlation[j][i] = mean;
        }
    return out;
}

/// Of the heights of several measurements of one surface, each about its own mean, of \p sizes.
/// \throws domain_error for none, or unlike numbers of them.
template <Real T>
[[nodiscard]] HeightStatistics<T> pooled(const std::vector<HeightStatistics<T>>& all, const std::vector<T>& sizes) {
    require(!all.empty() && all.size() == sizes.size(), "number of measurements", all.size(),
            "at least 1, as the sizes");
    T size = 0;
    for (const T one : sizes) size += one;
    HeightStatistics<T> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const T w = sizes[i] / size;
        out.moments =
            out.moments + SpectralMoments<T>{w * all[i].moments.m0, w * all[i].moments.m2, w * all[i].moments.m4};
    }
    T third = 0, fourth = 0;
    std::vector<SizedMeasurement<T>> skewness, kurtosis, gradient;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const T w = sizes[i] / size, ratio = all[i].moments.m0 / out.moments.m0;
        third += w * ratio * std::sqrt(ratio) * all[i].skewness.value;
        fourth += w * ratio * ratio * all[i].kurtosis.value;
        skewness.push_back({all[i].skewness, sizes[i]});
        kurtosis.push_back({all[i].kurtosis, sizes[i]});
        gradient.push_back({all[i].rms_gradient, sizes[i]});
    }
    T squares = 0;
    for (const auto& one : gradient) squares += one.size / size * one.measured.value * one.measured.value;
    out.skewness = {third, pooled_error(skewness)};
    out.kurtosis = {fourth, pooled_error(kurtosis)};
    out.rms_gradient = {std::sqrt(squares), pooled_error(gradient)};
    return out;
}

}  // namespace fstiff
