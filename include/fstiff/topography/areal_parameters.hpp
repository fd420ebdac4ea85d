// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of a map by ISO 25178-2: Sa, Sq, Ssk, Sku, Sp, Sv, Sz, Sdq, Sdr.
///
///     Sa = <|z|>    Sq^2 = <z^2>    Ssk = <z^3>/Sq^3    Sku = <z^4>/Sq^4          z about the mean of the map
///     Sp = max z    Sv = -min z     Sz = Sp + Sv        Sdr = <area of a cell>/(dx dy) - 1
///     Sdq^2 = <((z_(i+1) - z_i)/dx)^2> + the same along y                         each mean over its own neighbours
///
/// The area of a cell of four points is the mean of its two triangulations. Means are over what exists.
///
/// Reference   ISO 25178-2:2021, D.3, eq. (D.15) for the area
/// Units       heights [m]; Ssk, Sku, Sdq, Sdr dimensionless (the standard prints Sdr in per cent)
/// Valid       maps of 3 x 3 points at least with three neighbours along x and along y; remove the form first
/// Accuracy    1e-13 relative, beside the rounding of an offset (tests/topography/areal_parameters_test.cpp)

#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/height_map.hpp>

#include <optional>

namespace fstiff {

/// Roughness parameters of a map, ISO 25178-2.
template <Real T = double>
struct ArealParameters {
    T mean_deviation{};                     ///< Sa [m]
    T rms_height{};                         ///< Sq [m]
    T skewness{};                           ///< Ssk
    T kurtosis{};                           ///< Sku
    T max_peak_height{};                    ///< Sp [m]
    T max_pit_depth{};                      ///< Sv [m]
    T max_height{};                         ///< Sz [m]
    T rms_gradient{};                       ///< Sdq
    std::optional<T> developed_area_ratio;  ///< Sdr; none where no cell has its four points
};

/// Of \p map. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] ArealParameters<T> areal_parameters(const HeightMap<T>& map) {
    return areal_parameters(map, areal_statistics(map));
}

namespace detail {

/// Mean over the cells of their area over dx dy, less 1.
template <Real T>
[[nodiscard]] std::optional<T> developed_area_ratio(const HeightMap<T>& map) {
    using S = Accumulator<T>;
    const auto& z = map.heights;
    const S dx = static_cast<S>(map.dx), dy = static_cast<S>(map.dy);
    S all = 0;
    std::size_t cells = 0;
    for (Eigen::Index j = 0; j + 1 < map.rows(); ++j) {
        S row = 0;
        for (Eigen::Index i = 0; i + 1 < map.columns(); ++i) {
            const S a = static_cast<S>(z(j, i)), b = static_cast<S>(z(j, i + 1));
            const S c = static_cast<S>(z(j + 1, i)), d = static_cast<S>(z(j + 1, i + 1));
            if (std::isnan(a + b + c + d)) continue;
            const S top = (b - a) / dx, bottom = (d - c) / dx, left = (c - a) / dy, right = (d - b) / dy;
            const auto excess = [](S x, S y) {  // sqrt(1 + x^2 + y^2) - 1, to its last digit
                const S square = x * x + y * y;
                return square / (1 + std::sqrt(1 + square));
            };
            row += (excess(top, left) + excess(top, right) + excess(bottom, left) + excess(bottom, right)) / 4;
            ++cells;
        }
        all += row;
    }
    if (cells == 0) return {};
    return static_cast<T>(all / static_cast<S>(cells));
}

}  // namespace detail

/// Of \p map, whose statistics \p known are. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] ArealParameters<T> areal_parameters(const HeightMap<T>& map, const ArealStatistics<T>& known) {
    using S = Accumulator<T>;
    map.validate();
    const detail::MapHeights<T> heights(map);
    const auto mean_of = [&](const auto& term) {
        return detail::mean_over_points(map, [&](T z) { return term(heights.of(z) - heights.mean); });
    };
    const S unit = static_cast<S>(heights.unit), variance = heights.variance;
    S high = -std::numeric_limits<S>::infinity(), low = -high;
    const S deviation = mean_of([&](S z) {
        high = (std::max)(high, z);
        low = (std::min)(low, z);
        return std::abs(z);
    });
    ArealParameters<T> result;
    result.mean_deviation = static_cast<T>(deviation * unit);
    result.rms_height = known.rms_height;
    result.skewness = static_cast<T>(mean_of([](S z) { return z * z * z; }) / (variance * std::sqrt(variance)));
    result.kurtosis = static_cast<T>(mean_of([](S z) { return z * z * z * z; }) / (variance * variance));
    result.max_peak_height = static_cast<T>(high * unit);
    result.max_pit_depth = static_cast<T>(-low * unit);
    result.max_height = static_cast<T>((high - low) * unit);
    result.rms_gradient = known.rms_gradient;
    result.developed_area_ratio = detail::developed_area_ratio(map);
    return result;
}

}  // namespace fstiff
