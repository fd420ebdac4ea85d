// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Waviness and roughness of a profile by the Gaussian filter, and the profile without its short waves.
///
///     w_i = sum_k s((i-k) h) z_k / sum_k s((i-k) h),   s(x) = exp(-pi (x/(a c))^2),  a = sqrt(ln 2/pi)    cut-off c
///     a sine of wavelength l passes into the waviness by exp(-pi (a c/l)^2): 50 % at l = c
///
/// Both sums run over the points that exist, so that a constant is kept at the ends and beside gaps; a tilt is not:
/// remove the line first. A missing point stays missing.
///
/// Reference   ISO 16610-21:2011, 4.2-4.3 (weights, transmission); ISO 16610-28:2016 (ends)
/// Units       heights, cut-off [m]
/// Valid       5 spacings (of the low pass 2) <= cut-off <= length of the profile; every height finite or NaN (missing)
/// Accuracy    transmission 1e-6 for a cut-off of 5 spacings, 1e-13 from 10 spacings on
///             (tests/profile/gaussian_filter_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/gaussian_smoother.hpp>
#include <fstiff/profile/structure_function.hpp>

namespace fstiff {

/// Share of a wave of \p wavelength that the waviness keeps. \throws domain_error unless both lengths are positive.
template <Real T>
[[nodiscard]] T gaussian_transmission(T wavelength, T cutoff) {
    require_positive("wavelength", wavelength);
    require_positive("cut-off", cutoff);
    const T ratio = cutoff / wavelength;
    return std::exp(-numbers::ln2_v<T> * ratio * ratio);  // pi a^2 = ln 2
}

/// \p profile without its long waves. \throws domain_error as above.
template <Real T>
[[nodiscard]] Profile<T> gaussian_roughness(const Profile<T>& profile, T cutoff) {
    Profile<T> roughness = gaussian_waviness(profile, cutoff);
    for (std::size_t i = 0; i < profile.size(); ++i) roughness.heights[i] = profile.heights[i] - roughness.heights[i];
    return roughness;
}

namespace detail {

/// The weighted means of the head of this file, with a cut-off of \p least spacings at least.
template <Real T>
Profile<T> gaussian_means(const Profile<T>& profile, T cutoff, int least) {
    using F = Accumulator<T>;
    require_positive("spacing", profile.spacing);
    // a cut-off of exactly so many spacings is in, whatever its rounding
    if (!(cutoff >= static_cast<T>(least) * profile.spacing * (1 - 4 * std::numeric_limits<T>::epsilon()) &&
          cutoff <= profile.length()))
        detail::refuse("cut-off", cutoff,
                       "at least " + std::to_string(least) + " spacings and at most the length of the profile");
    const T scale = detail::height_scale(profile);
    const T mean = mean_height(profile);
    const std::size_t size = profile.size();
    GaussianSmoother<F> smooth(size, static_cast<F>(cutoff) / static_cast<F>(profile.spacing));
    std::vector<F> heights(size), mask(size);
    for (std::size_t i = 0; i < size; ++i) {
        const bool exists = !std::isnan(profile.heights[i]);
        heights[i] = exists ? static_cast<F>((profile.heights[i] - mean) / scale) : F(0);
        mask[i] = exists ? F(1) : F(0);
    }
    smooth(heights);
    smooth(mask);
    Profile<T> means = profile;
    for (std::size_t i = 0; i < size; ++i)  // the weight of the point itself keeps the divisor from 0
        if (!std::isnan(profile.heights[i])) means.heights[i] = static_cast<T>(heights[i] / mask[i]) * scale + mean;
    return means;
}

}  // namespace detail

/// The long waves of \p profile. \throws domain_error for a cut-off or a profile out of range.
template <Real T>
[[nodiscard]] Profile<T> gaussian_waviness(const Profile<T>& profile, T cutoff) {
    return detail::gaussian_means(profile, cutoff, 5);
}

/// \p profile without its short waves: the same sums, for a cut-off of two spacings and more. Below five spacings the
/// weights are few, and waves of less than twice the cut-off pass better than the closed form says.
/// \throws domain_error as above.
template <Real T>
[[nodiscard]] Profile<T> gaussian_low_pass(const Profile<T>& profile, T cutoff) {
    return detail::gaussian_means(profile, cutoff, 2);
}

}  // namespace fstiff
