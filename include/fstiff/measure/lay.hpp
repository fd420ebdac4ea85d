// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Detection of a lay, as turned, milled or ground faces have: the heights repeat themselves or are stretched.
///
///     profile    maximum of sum z(x) z(x + t)/sum z^2 beyond its first zero, at lags t up to a quarter of the profile;
///                the period is the first lag that comes near it, no multiple
///     map        Str = min r(phi)/max r(phi), or an upper bound (topography/areal_autocorrelation.hpp)
///
/// A single profile does not contain the length of the ridges, and K depends on it: by boundary elements a turned face
/// is 10 to 18 times stiffer than an isotropic one with the statistics of its profile.
/// Derivation  docs/theory-surface.md
/// Reference   ISO 25178-2:2021 (Str); the limits 0.5 and 0.3 are this project's
/// Units       lags [m], the others dimensionless
/// Valid       profiles of at least 16 points; remove the form first
/// Accuracy    0.1 % of 9,600 self-affine profiles (H = 0.2 to 1) repeat themselves to 0.5; all sines and parabolic
///             grooves with isotropic roughness of 0.5 of their rms height do (tests/measure/lay_test.cpp)

#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/topography/areal_autocorrelation.hpp>
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/height_map.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace fstiff { inline namespace v0_1 {

/// Agreement of a profile with itself, shifted by one period.
template <Real T = double>
struct Repetition {
    T correlation{};  ///< 1 for a periodic profile; 0 where the autocorrelation has no zero within a quarter of it
    T period{};       ///< [m]

    /// Whether the agreement is a lay and not chance.
    [[nodiscard]] bool is_lay() const { return correlation > T(0.5); }
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Repetition of a profile with the autocorrelation \p acf.
template <Real T>
[[nodiscard]] Repetition<T> repetition(const Autocorrelation<T>& acf) {
    const std::size_t reach = (acf.size() - 1) / 2;  // a quarter of the profile
    const auto share = [&](std::size_t n) {
        return acf.pairs[n] == 0 ? T(0)
                                 : acf.value[n] * static_cast<T>(acf.pairs[n]) / static_cast<T>(acf.pairs.front());
    };
    std::size_t n = 0;
    while (n < reach && share(n) > T(0)) ++n;
    const std::size_t zero = n;
    Repetition<T> result;
    for (; n < reach; ++n)
        if (const T correlation = share(n); correlation > result.correlation) result = {correlation, acf.lag[n]};
    for (n = zero; result.correlation > T(0) && share(n) < T(0.9) * result.correlation;) ++n;
    T highest = 0;  // near the first lag that comes near the maximum
    for (const std::size_t end = (std::min)(reach, n + n / 3 + 1); n < end; ++n)
        if (share(n) > highest) highest = share(n), result.period = acf.lag[n];
    return result;
}

/// Str of \p map, on 256 points along the longer side, and at least 4 along the shorter one, where it has more and no
/// point is missing. Returns an upper bound where the longest lag of the map limits Str, and 1 where no direction falls
/// to 0.2. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] T texture_aspect_ratio(const HeightMap<T>& map) {
    const auto [shorter, longer] = std::minmax({map.columns(), map.rows()});
    const Eigen::Index points = (std::max)(Eigen::Index(256), 4 * longer / (std::max)(shorter, Eigen::Index(1)));
    const bool complete = !map.heights.isNaN().any();
    const TextureParameters<T> texture =
        detail::texture_parameters(detail::areal_autocorrelation(complete ? detail::coarsened(map, points) : map));
    if (texture.aspect_ratio) return *texture.aspect_ratio;
    return texture.shortest ? *texture.shortest / texture.longest : T(1);
}

/// Whether a map of this Str has a lay.
template <Real T>
[[nodiscard]] constexpr bool is_lay(T texture_aspect_ratio) {
    return texture_aspect_ratio < T(0.3);
}

}}}  // namespace fstiff::detail
