// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What speaks against D and G of a fit, and against the parameters of a measured surface: every concern by its name.
///
///     curved               the structure function is no single power law over the window: D is a mean over it
///     saturated            a shorter lag has a slope below 0.2, and the automatic window stands behind it as behind a
///                          plateau, or is steeper by 0.5 everywhere: D is that of the waviness
///     roughness_uncertain  G is known to no better than a factor of 10
///     filtered             the window reaches beyond a tenth of the cut-off, where S has lost some of what the filter took:
///                          a lag shows waves up to some ten times as long
///     spectrum_differs     D of the power spectrum differs by 0.1 and three standard deviations
///     anisotropic          a map differs along x and y: the models take it for isotropic
///     few_peaks            R and D_p come from fewer than 30 peaks: their errors are rough
///     radius_uncertain, density_uncertain     the error of R, of D_p is above 30 %
///
/// Reference   profile/fractal_fit.hpp, profile/power_spectrum.hpp, measured/surface_parameters.hpp; the limits are
///             this project's.
/// Units       none: slopes, ratios and counts
/// Valid       what fit_fractal(), fit_spectrum() and surface_parameters() return

#include <fstiff/measured/surface_parameters.hpp>
#include <fstiff/profile/power_spectrum.hpp>

namespace fstiff {

enum class MeasuredConcern {
    curved,
    saturated,
    roughness_uncertain,
    filtered,
    spectrum_differs,
    anisotropic,
    few_peaks,
    radius_uncertain,
    density_uncertain
};

template <>
inline constexpr auto names<MeasuredConcern> = name_list<MeasuredConcern>({
    {MeasuredConcern::curved, "curved"},
    {MeasuredConcern::saturated, "saturated"},
    {MeasuredConcern::roughness_uncertain, "roughness_uncertain"},
    {MeasuredConcern::filtered, "filtered"},
    {MeasuredConcern::spectrum_differs, "spectrum_differs"},
    {MeasuredConcern::anisotropic, "anisotropic"},
    {MeasuredConcern::few_peaks, "few_peaks"},
    {MeasuredConcern::radius_uncertain, "radius_uncertain"},
    {MeasuredConcern::density_uncertain, "density_uncertain"},
});

/// Of curved, saturated and roughness_uncertain.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const FractalFit<T>& fit) {
    std::vector<MeasuredConcern> found;
    if (fit.curved) found.push_back(MeasuredConcern::curved);
    if (fit.automatic_window && fit.flattest_lag > T(0) && fit.flattest_slope < T(0.2) &&
        (fit.behind_plateau || fit.min_slope > fit.flattest_slope + T(0.5)))
        found.push_back(MeasuredConcern::saturated);
    if (fit.log_roughness_error > numbers::ln10_v<T>) found.push_back(MeasuredConcern::roughness_uncertain);
    return found;
}

/// Also filtered, of the profile that was fitted, and spectrum_differs, of its \p spectrum where that could be fitted.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const FractalFit<T>& fit, const LevelledProfile<T>& levelled,
                                                       const std::optional<SpectralFit<T>>& spectrum) {
    std::vector<MeasuredConcern> found = concerns_of(fit);
    if (levelled.cutoff && fit.window.to > *levelled.cutoff / 10) found.push_back(MeasuredConcern::filtered);
    if (spectrum) {
        const T difference = std::abs(spectrum->dimension - fit.fractal.dimension);
        if (difference > 3 * std::hypot(spectrum->dimension_error, fit.dimension_error) && difference > T(0.1))
            found.push_back(MeasuredConcern::spectrum_differs);
    }
    return found;
}

/// Of curved, anisotropic, few_peaks, radius_uncertain and density_uncertain.
template <Real T>
[[nodiscard]] std::vector<MeasuredConcern> concerns_of(const SurfaceParameters<T>& surface) {
    std::vector<MeasuredConcern> found;
    if (surface.curved) found.push_back(MeasuredConcern::curved);
    if (surface.anisotropic) found.push_back(MeasuredConcern::anisotropic);
    if (surface.peaks_counted < 30) found.push_back(MeasuredConcern::few_peaks);
    const auto uncertain = [](const Measurement<T>& one) { return one.error > T(0.3) * one.value; };
    if (uncertain(surface.peak_radius)) found.push_back(MeasuredConcern::radius_uncertain);
    if (uncertain(surface.peak_density)) found.push_back(MeasuredConcern::density_uncertain);
    return found;
}

}  // namespace fstiff
