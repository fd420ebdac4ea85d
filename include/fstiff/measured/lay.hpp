// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Whether a surface has a lay, as a turned, milled or ground face has: its heights repeat themselves, or are
/// stretched.
///
///     of a profile    the greatest sum z(x) z(x + t)/sum z^2 beyond its first zero, at lags t up to a quarter of the profile
///     of a map        Str = min r(phi)/max r(phi), or less (topography/areal_autocorrelation.hpp)
///
/// Across a lay a profile repeats itself; along it a profile shows nothing of it. Either way a single profile does not
/// know how far the ridges reach, on which K hangs: a turned face was 10 to 18 times stiffer than an isotropic one with
/// the statistics of its profile. Divided by the sum over all points, and not by the pairs of a lag, the
/// autocorrelation of few pairs scatters less.
///
/// Reference   ISO 25178-2:2021 (Str); the limits 0.5 and 0.3 are this project's
/// Units       lags [m], the others dimensionless
/// Valid       profiles of 16 points at least; remove the form first
/// Accuracy    of 9,600 self-affine profiles (H = 0.2 to 1, longest wave the profile to a 32nd of it) 0.1 % repeat
///             themselves to 0.5; a sine or parabolic grooves with isotropic roughness of 0.5 of their rms height all
///             do (tests/measured/lay_test.cpp has some of them)

#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/topography/areal_autocorrelation.hpp>
#include <fstiff/topography/coarsen.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fstiff::inline v0_1::detail {

/// How well a profile agrees with itself one period further on.
template <Real T = double>
struct Repetition {
    T correlation{};  ///< 1 for a periodic profile; 0 where the autocorrelation has no zero within a quarter of it
    T period{};       ///< [m]

    /// Whether that is a lay, and no chance.
    [[nodiscard]] bool is_lay() const { return correlation > T(0.5); }
};

/// Of \p profile. \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] Repetition<T> repetition(const Profile<T>& profile) {
    const Autocorrelation<T> all = autocorrelation(profile);
    const std::size_t reach = profile.size() / 4;
    const auto share = [&](std::size_t n) {
        return all.pairs[n] == 0 ? T(0)
                                 : all.value[n] * static_cast<T>(all.pairs[n]) / static_cast<T>(all.pairs.front());
    };
    std::size_t n = 0;
    while (n < reach && share(n) > T(0)) ++n;
    Repetition<T> found;
    for (; n < reach; ++n)
        if (const T here = share(n); here > found.correlation) found = {here, all.lag[n]};
    return found;
}

/// Str of \p map, on 256 points a side where it has more and none is missing; the upper bound that its lags give where
/// Str is less than they show; 1 where no direction falls to 0.2. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] T texture_aspect_ratio(const HeightMap<T>& map) {
    const bool whole = !map.heights.isNaN().any();
    const parts::TextureParameters<T> texture =
        parts::texture_parameters(parts::areal_autocorrelation(whole ? parts::coarsened(map, 256) : map));
    if (texture.aspect_ratio) return *texture.aspect_ratio;
    return texture.shortest ? *texture.shortest / texture.longest : T(1);
}

/// Whether a map of this Str has a lay.
template <Real T>
[[nodiscard]] constexpr bool is_lay(T texture_aspect_ratio) {
    return texture_aspect_ratio < T(0.3);
}

}  // namespace fstiff::inline v0_1::detail
