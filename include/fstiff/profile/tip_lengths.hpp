// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Lengths of a profile that are not affected by the shape of a round tip.
///
///     kappa_min(n h) = min of (z_(i-n) - 2 z_i + z_(i+n)) / (n h)^2                 the sharpest peak at that scale
///     cut-off        = 2 n h, the shortest stencil from which on kappa_min > -1/(2 R_tip)
///
/// The trace of a tip of radius R has kappa_min >= -1/R at every scale; scales within a factor of two of it show the
/// shape of the tip.
///
/// Reference   Sanner, Nohring, Thimons, Jacobs, Pastewka, Appl. Surf. Sci. Adv. 7 (2022) 100190,
///             doi:10.1016/j.apsadv.2021.100190; here twelve scales an octave
/// Units       lengths [m], curvature [1/m]
/// Valid       R > 0; a triple of existing points at the given scale
/// Accuracy    rounding of three heights (tests/profile/tip_cutoff_test.cpp)

#include <fstiff/profile/structure_function.hpp>

#include <optional>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Minimum (most peaked) curvature of \p profile over triples \p step samples apart [1/m]; empty when there is none.
/// \throws domain_error for a step of 0, a spacing that is not positive or an infinite height.
template <Real T>
[[nodiscard]] std::optional<T> min_curvature(const Profile<T>& profile, std::size_t step) {
    require_positive("spacing", profile.spacing);
    if (step == 0) detail::refuse("step of the curvature", "0 samples", "at least 1");
    const std::vector<T>& z = profile.heights;
    const T scale = detail::height_scale(profile);  // refuses infinite heights, and keeps the differences in range
    std::optional<T> least;
    for (std::size_t i = step; i < z.size() && z.size() - i > step; ++i) {
        const T bend = (z[i + step] - z[i]) / scale - (z[i] - z[i - step]) / scale;
        if (!std::isnan(bend) && (!least || bend < *least)) least = bend;
    }
    const T width = static_cast<T>(step) * profile.spacing;
    if (least) *least = *least * (scale / width) / width;
    return least;
}

/// Length below which \p profile may show the tip instead of the surface [m]; 0 when it does not at any scale, infinity
/// when it does at every scale up to a quarter of its length.
/// \throws domain_error unless the radius is positive, and as above.
template <Real T>
[[nodiscard]] T tip_cutoff(const Profile<T>& profile, T tip_radius) {
    require_positive("tip radius", tip_radius);
    const std::vector<std::size_t> steps = detail::logarithmic_lags(std::max<std::size_t>(profile.size() / 8, 1));
    // from the longest scale down to the first that is too sharp
    std::size_t reliable = 0;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        const auto curvature = min_curvature(profile, *step);
        if (curvature && !(*curvature * tip_radius > T(-0.5)))
            return reliable == 0 ? std::numeric_limits<T>::infinity() : 2 * static_cast<T>(reliable) * profile.spacing;
        reliable = *step;
    }
    return T(0);
}

}}}  // namespace fstiff::detail
