// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Spectral moments of a profile, and Nayak's bandwidth parameter.
///
///     m0 = mean (z - mean)^2                                    = integral of C(q) dq
///     m2 = mean ((z_(i+1) - z_i)/h)^2                           = integral of q^2 C(q) [sin(qh/2)/(qh/2)]^2 dq
///     m4 = mean ((z_(i-1) - 2 z_i + z_(i+1))/h^2)^2             = integral of q^4 C(q) [sin(qh/2)/(qh/2)]^4 dq
///     alpha = m0 m4/m2^2 >= 1 in the limit h -> 0
///
/// Means are over the pairs and triples that exist. Where waves are shorter than the spacing, m2 and m4 depend on it.
///
/// Reference   Nayak, J. Lubr. Technol. 93 (1971) 398-407; Longuet-Higgins, Phil. Trans. A 250 (1957) 157
/// Units       m0 [m^2], m2 dimensionless, m4 [1/m^2], alpha dimensionless
/// Valid       16 points and a triple at least, heights that vary
/// Accuracy    1e-13 in double (tests/profile/spectral_moments_test.cpp)

#include <fstiff/profile/structure_function.hpp>
#include <fstiff/profile/triples.hpp>
#include <fstiff/surface/moments.hpp>

#include <utility>

namespace fstiff {

/// Moments of \p profile about its mean: remove its form first, with detrend(). \throws domain_error for a profile out
/// of range, without a triple of neighbours, or whose moments leave the range of numbers.
template <Real T>
[[nodiscard]] SpectralMoments<T> spectral_moments(const Profile<T>& profile) {
    profile.validate(16);
    using S = Accumulator<T>;
    const T scale = detail::height_scale(profile);
    CompensatedSum<S> slope;
    detail::TripleSums<S, CompensatedSum<S>> sums;
    std::size_t pairs = 0;
    S before = std::numeric_limits<S>::quiet_NaN();
    const std::vector<T>& z = profile.heights;
    for (std::size_t i = 0; i + 1 < z.size(); ++i) {
        const S rise = (z[i + 1] - z[i]) / scale;
        sums.add(std::exchange(before, rise), rise);
        if (std::isnan(rise)) continue;
        slope.add(rise * rise);
        ++pairs;
    }
    if (sums.triples == 0) throw domain_error("profile has 0 triples of neighbouring points: must be at least 1");
    const S ratio = static_cast<S>(scale) / static_cast<S>(profile.spacing);
    SpectralMoments<T> moments;
    const T rms = rms_height(profile);
    moments.m0 = rms * rms;
    moments.m2 = static_cast<T>(slope.value() / static_cast<S>(pairs) * ratio * ratio);
    const S rms_bend = std::sqrt(sums.mean_square_curvature()) * ratio / static_cast<S>(profile.spacing);
    moments.m4 = static_cast<T>(rms_bend * rms_bend);
    const auto usable = [](T value) {
        return value >= (std::numeric_limits<T>::min)() && value <= (std::numeric_limits<T>::max)();
    };
    require(usable(moments.m0), "m0", moments.m0, "a positive number of normal size");
    require(usable(moments.m2), "m2", moments.m2, "a positive number of normal size");
    require(moments.m4 == T(0) || usable(moments.m4), "m4", moments.m4, "a number of normal size");
    require(moments.bandwidth() <= (std::numeric_limits<T>::max)(), "Nayak's alpha", moments.bandwidth(), "finite");
    return moments;
}

}  // namespace fstiff
