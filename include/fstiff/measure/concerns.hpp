// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Concerns about D and G of a fit and about the parameters of a measured surface, each with a name.
///
/// Reference   profile/fractal_fit.hpp, profile/power_spectrum.hpp, measure/parameters.hpp; the limits are
///             this project's
/// Units       none: slopes, ratios and counts
/// Valid       results of fit_fractal(), fit_spectrum() and surface_parameters()

#include <fstiff/measure/lay.hpp>
#include <fstiff/measure/parameters.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/surface/moments.hpp>

namespace fstiff { inline namespace v0_1 {

/// Reasons to doubt a measured surface; the limits are this project's.
///
///     curved               structure function is no single power law over the window; D is a mean over it
///     saturated            a shorter lag has a slope below 0.2, and the automatic window follows it as a plateau,
///                          or is steeper by 0.5 everywhere: D is that of the waviness
///     roughness_uncertain  G is uncertain by more than a factor of 10
///     filtered             the window exceeds a tenth of lambda_c, where the filter reduces S: a lag includes waves up
///                          to some ten times as long
///     spectrum_differs     D of the power spectrum differs by 0.1 and by three standard deviations
///     anisotropic          a map differs along x and y; the models assume isotropy
///     lay                  a profile repeats itself, or Str of a map is below 0.3 (measure/lay.hpp): a profile
///                          does not contain the length of the ridges, and K may be 20 times higher
///     long_waves           at least three quarters of the mean square height are in waves longer than an eighth of the
///                          surface: sigma is valid for this length
///     few_peaks            R and D_p come from fewer than 30 peaks: their errors are rough
///     radius_uncertain, density_uncertain     the error of R, of D_p is above 30 %
///     no_densest_level     the island density is greatest at the lowest or the highest level, no maximum: R and
///                          D_p must not be used as a pair
///     parameter_unknown    the standard error of sigma, R, D_p, D, r or theta exceeds half the value
///     form, step           one parabola (of a map: a quadratic surface) or one step is more than half of the mean
///                          square height: sigma is that of a part and not of its roughness
///     bowed                a plateau with valleys has more than 5 % of its mean square height in one parabola: the
///                          middle or the edges of a form carry first
///     scan_lines           lines of a map have offsets (topography/scan_lines.hpp): K may be off by a factor of two
///     implausible_gradient the rms gradient is above 1 or below 1e-6: a unit of length is likely wrong
enum class MeasuredConcern {
    curved,
    saturated,
    roughness_uncertain,
    filtered,
    spectrum_differs,
    anisotropic,
    lay,
    long_waves,
    few_peaks,
    radius_uncertain,
    density_uncertain,
    no_densest_level,
    parameter_unknown,
    form,
    step,
    bowed,
    scan_lines,
    implausible_gradient
};

template <>
inline constexpr auto enum_names<MeasuredConcern> = detail::name_list<MeasuredConcern>({
    {MeasuredConcern::curved, "curved"},
    {MeasuredConcern::saturated, "saturated"},
    {MeasuredConcern::roughness_uncertain, "roughness_uncertain"},
    {MeasuredConcern::filtered, "filtered"},
    {MeasuredConcern::spectrum_differs, "spectrum_differs"},
    {MeasuredConcern::anisotropic, "anisotropic"},
    {MeasuredConcern::lay, "lay"},
    {MeasuredConcern::long_waves, "long_waves"},
    {MeasuredConcern::few_peaks, "few_peaks"},
    {MeasuredConcern::radius_uncertain, "radius_uncertain"},
    {MeasuredConcern::density_uncertain, "density_uncertain"},
    {MeasuredConcern::no_densest_level, "no_densest_level"},
    {MeasuredConcern::parameter_unknown, "parameter_unknown"},
    {MeasuredConcern::form, "form"},
    {MeasuredConcern::step, "step"},
    {MeasuredConcern::bowed, "bowed"},
    {MeasuredConcern::scan_lines, "scan_lines"},
    {MeasuredConcern::implausible_gradient, "implausible_gradient"},
});

namespace detail {

/// Concerns curved, saturated and roughness_uncertain.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const FractalFit<T>& fit) {
    std::vector<MeasuredConcern> concerns;
    if (fit.curved) concerns.push_back(MeasuredConcern::curved);
    if (fit.automatic_window && fit.flattest_lag > T(0) && fit.flattest_slope < T(0.2) &&
        (fit.after_plateau || fit.min_slope > fit.flattest_slope + T(0.5)))
        concerns.push_back(MeasuredConcern::saturated);
    if (fit.log_roughness_error > std::numbers::ln10_v<T>) concerns.push_back(MeasuredConcern::roughness_uncertain);
    return concerns;
}

/// Adds filtered, for the profile that was fitted, and spectrum_differs, for its \p spectrum where it could be fitted.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const FractalFit<T>& fit, const LevelledProfile<T>& levelled,
                                                       const std::optional<SpectralFit<T>>& spectrum) {
    std::vector<MeasuredConcern> concerns = concerns_of(fit);
    if (levelled.cutoff && fit.window.to > *levelled.cutoff / 10) concerns.push_back(MeasuredConcern::filtered);
    if (spectrum) {
        const T difference = std::abs(spectrum->dimension - fit.fractal.dimension);
        if (difference > 3 * std::hypot(spectrum->dimension_error, fit.dimension_error) && difference > T(0.1))
            concerns.push_back(MeasuredConcern::spectrum_differs);
    }
    return concerns;
}

/// Whether \p m is known to a factor of two: its standard error is at most half its value.
template <Real T>
[[nodiscard]] constexpr bool is_known(const Measurement<T>& m) {
    return m.error <= m.value / 2;
}

template <Real T>
void add_peak_concerns(std::vector<MeasuredConcern>& concerns, std::size_t peaks, const Measurement<T>& radius,
                       const Measurement<T>& density) {
    const auto uncertain = [](const Measurement<T>& m) { return m.error > T(0.3) * m.value; };
    if (peaks < 30 && density.value > T(0)) concerns.push_back(MeasuredConcern::few_peaks);  // else D_p is not known
    if (uncertain(radius)) concerns.push_back(MeasuredConcern::radius_uncertain);
    if (uncertain(density)) concerns.push_back(MeasuredConcern::density_uncertain);
}

/// Whether the islands are densest at the first or the last level of the curve.
template <Real T>
[[nodiscard]] bool is_densest_at_end(const RepresentativeIslands<T>& islands) {
    return islands.index == 0 || islands.index + 1 == islands.curve.size();
}

/// Concerns few_peaks, radius_uncertain, density_uncertain, no_densest_level and parameter_unknown.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const RepresentativeIslands<T>& islands) {
    std::vector<MeasuredConcern> concerns;
    const Measurement<T> radius{islands.radius, islands.radius_error}, density{islands.density, islands.density_error};
    add_peak_concerns(concerns, islands.islands, radius, density);
    if (is_densest_at_end(islands)) concerns.push_back(MeasuredConcern::no_densest_level);
    if (!is_known(radius) || !is_known(density)) concerns.push_back(MeasuredConcern::parameter_unknown);
    return concerns;
}

/// Parameters of \p surface that are not known to a factor of two; without r where long waves leave it open with sigma.
template <Real T>
[[nodiscard]] std::vector<Parameter> unknown_parameters(const SurfaceParameters<T>& surface) {
    std::vector<Parameter> parameters;
    for (std::size_t i = 0; i < surface_parameter_count; ++i) {
        const Parameter parameter = parameter_table[i].parameter;
        if (parameter == Parameter::r && surface.long_wave_share > T(0.75)) continue;
        if (const auto* m = surface.find(parameter); m && !is_known(*m)) parameters.push_back(parameter);
    }
    return parameters;
}

/// Concerns curved, anisotropic, lay, long_waves, few_peaks, radius_uncertain, density_uncertain, no_densest_level,
/// parameter_unknown, form, step, bowed and scan_lines.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const SurfaceParameters<T>& surface) {
    std::vector<MeasuredConcern> concerns;
    if (surface.curved) concerns.push_back(MeasuredConcern::curved);
    if (surface.anisotropic) concerns.push_back(MeasuredConcern::anisotropic);
    if (surface.repetition.is_lay() || is_lay(surface.texture_aspect_ratio)) concerns.push_back(MeasuredConcern::lay);
    if (surface.long_wave_share > T(0.75)) concerns.push_back(MeasuredConcern::long_waves);
    add_peak_concerns(concerns, surface.peaks_counted, surface.peak_radius, surface.peak_density);
    if (surface.islands && is_densest_at_end(*surface.islands)) concerns.push_back(MeasuredConcern::no_densest_level);
    if (!unknown_parameters(surface).empty()) concerns.push_back(MeasuredConcern::parameter_unknown);
    if (surface.plain_form.is_parabola()) concerns.push_back(MeasuredConcern::form);
    if (surface.plain_form.is_step()) concerns.push_back(MeasuredConcern::step);
    if (surface.plain_form.is_bow()) concerns.push_back(MeasuredConcern::bowed);
    if (surface.offset_lines != ScanAxis::automatic) concerns.push_back(MeasuredConcern::scan_lines);
    return concerns;
}

/// Same as above, with implausible_gradient for the measured rms gradient.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const SurfaceParameters<T>& surface, T rms_gradient) {
    std::vector<MeasuredConcern> concerns = concerns_of(surface);
    if (!is_plausible_gradient(rms_gradient)) concerns.push_back(MeasuredConcern::implausible_gradient);
    return concerns;
}

/// Whether results for the surface are in doubt: no_densest_level, parameter_unknown, form, step and
/// implausible_gradient.
[[nodiscard]] constexpr bool is_fatal(MeasuredConcern concern) {
    using enum MeasuredConcern;
    return concern == no_densest_level || concern == parameter_unknown || concern == form || concern == step ||
           concern == implausible_gradient;
}

}  // namespace detail

}}  // namespace fstiff
