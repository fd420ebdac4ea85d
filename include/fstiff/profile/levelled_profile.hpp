// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A profile without its form, with the removed form and the profile before the filters.
///
///     const auto flat = fstiff::detail::level(profile, fstiff::Form::line);
///     const auto fit = fstiff::fit_fractal(flat);
///
/// Units       heights, cut-off [m]
/// Valid       as detrend(), gaussian_low_pass() and gaussian_roughness()
/// Accuracy    that of detrend() and gaussian_roughness() (tests/profile/level_test.cpp)

#include <fstiff/math/upper_half.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/profile_form.hpp>

namespace fstiff { inline namespace v0_1 {

/// A profile without its form, and the cut-offs of its filters.
template <Real T = double>
struct LevelledProfile {
    Profile<T> profile;
    Form removed = Form::none;
    T radius{};                   ///< of a removed circle [m], below 0 where it is hollow
    bool settled = false;         ///< the line or parabola is that of the upper half (math/upper_half.hpp)
    std::optional<T> cutoff{};    ///< of the Gaussian filter that belongs to the form and took its long waves [m]
    std::optional<T> lambda_s{};  ///< of the filter that then took the short waves [m]
    std::optional<T> lambda_c{};  ///< and of the one that took the long ones, of without_waviness() [m]
    std::optional<Profile<T>> unfiltered{};  ///< the profile before lambda_s and lambda_c, where there is one

    /// Profile for the structure function: it compares points at a lag, and lags from lambda_s to lambda_c need no
    /// filter. lambda_s would reduce S at every lag by the shorter waves, and lambda_c would bend it.
    [[nodiscard]] const Profile<T>& of_structure() const { return unfiltered ? *unfiltered : profile; }
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Removes the \p form of \p profile, a line or a parabola by its upper half where it is a plateau with valleys, then,
/// with \p lambda_s, its short waves, and then, with a \p cutoff, the waviness of the Gaussian filter. \p resolution
/// [m] is the step in which the heights were printed or counted; 0 where it is not known. A \p radius [m] above 0 is
/// that of the circle. \throws domain_error as detrend(), remove_circle(), gaussian_low_pass() and
/// gaussian_roughness(), and for a profile that is constant, apart from rounding, after the removal of its form.
template <Real T>
[[nodiscard]] LevelledProfile<T> level(const Profile<T>& profile, Form form,
                                       std::optional<std::type_identity_t<T>> cutoff = {},
                                       std::type_identity_t<T> resolution = 0,
                                       std::optional<std::type_identity_t<T>> lambda_s = {},
                                       std::type_identity_t<T> radius = 0) {
    LevelledProfile<T> flat{.profile = form == Form::circle ? profile : detail::detrend(profile, form),
                            .removed = form,
                            .cutoff = cutoff,
                            .lambda_s = lambda_s};
    if (form == Form::circle) flat.radius = remove_circle(flat.profile, radius);
    if (form == Form::line || form == Form::parabola)
        flat.settled = math::settle_on_upper_half(flat.profile.heights.data(), 1,
                                                  static_cast<Eigen::Index>(profile.size()), form == Form::line ? 1 : 2)
                           .has_value();
    if (form != Form::none)
        math::require_more_than_rounding<T>("profile", name_of(form), profile.heights.data(),
                                            flat.profile.heights.data(), profile.size(), resolution);
    if (lambda_s) {
        flat.unfiltered = cutoff ? gaussian_roughness(flat.profile, *cutoff) : flat.profile;
        flat.profile = gaussian_low_pass(flat.profile, *lambda_s);
    }
    if (cutoff) flat.profile = gaussian_roughness(flat.profile, *cutoff);
    return flat;
}

/// Removes the waves of \p levelled above \p lambda_c and keeps the profile before it for the structure function.
/// \throws domain_error as gaussian_roughness().
template <Real T>
[[nodiscard]] LevelledProfile<T> without_waviness(LevelledProfile<T> levelled, std::type_identity_t<T> lambda_c) {
    Profile<T> roughness = gaussian_roughness(levelled.profile, lambda_c);
    if (!levelled.unfiltered) levelled.unfiltered = std::move(levelled.profile);
    levelled.profile = std::move(roughness);
    levelled.lambda_c = lambda_c;
    return levelled;
}

}}}  // namespace fstiff::detail
