// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A profile without its form, which knows what was removed: what is measured of it can make up for the loss.
///
///     const auto flat = fstiff::level(profile, fstiff::Form::line);
///     const auto fit = fstiff::fit_fractal(flat);  // makes up for what the line took of the long waves
///
/// Units       heights, cut-off [m]
/// Valid       as detrend(), gaussian_low_pass() and gaussian_roughness()
/// Accuracy    that of detrend() and gaussian_roughness() (tests/profile/level_test.cpp)

#include <fstiff/math/rounding.hpp>
#include <fstiff/profile/detrend.hpp>
#include <fstiff/profile/gaussian_filter.hpp>

#include <optional>

namespace fstiff {

template <Real T = double>
struct LevelledProfile {
    Profile<T> profile;
    Form removed = Form::none;
    std::optional<T> cutoff{};    ///< lambda_c of the Gaussian filter that took the long waves [m]
    std::optional<T> lambda_s{};  ///< of the one that took the short waves before it [m]
};

/// \p profile without the \p form, then, with \p lambda_s, without its short waves, and then, with a \p cutoff, without
/// the waviness of the Gaussian filter.
/// \p resolution [m] is the step in which the heights were printed or counted; 0 where it is not known.
/// \throws domain_error as detrend(), gaussian_low_pass() and gaussian_roughness(), and for a profile that is constant, but for its rounding,
/// once its form is removed.
template <Real T>
[[nodiscard]] LevelledProfile<T> level(const Profile<T>& profile, Form form,
                                       std::optional<std::type_identity_t<T>> cutoff = {},
                                       std::type_identity_t<T> resolution = 0,
                                       std::optional<std::type_identity_t<T>> lambda_s = {}) {
    LevelledProfile<T> flat{detrend(profile, form), form, cutoff, lambda_s};
    if (form != Form::none && detail::is_rounding(profile.heights.data(), flat.profile.heights.data(), profile.size(),
                                                  static_cast<T>(resolution)))
        throw domain_error("profile of constant height once its form (" + std::string(name_of(form)) +
                           ") is removed: what is left is the rounding of its heights; must be of varying height");
    if (lambda_s) flat.profile = gaussian_low_pass(flat.profile, *lambda_s);
    if (cutoff) flat.profile = gaussian_roughness(flat.profile, *cutoff);
    return flat;
}

}  // namespace fstiff
