// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Roughness parameters of a profile by ISO 21920-2: Ra, Rq, Rsk, Rku, Rt, Rz, Rp, Rv, Rdq, RSm.
///
///     Ra = <|z|>    Rq^2 = <z^2>    Rsk = <z^3>/Rq^3    Rku = <z^4>/Rq^4    Rt = max z - min z    z about the mean
///     Rp, Rv, Rz = means over five sections of max z, -min z and max z - min z
///     RSm = mean width of the elements, each a pit below -Rz/10 and a peak above Rz/10, at least 1 % of a section wide
///     Rdq^2 = <z'^2>   z' = (z_(i+3) - 9 z_(i+2) + 45 z_(i+1) - 45 z_(i-1) + 9 z_(i-2) - z_(i-3))/(60 h)
///
/// The sections are the five lengths lambda_c in the middle of the profile where it is long enough, else fifths of it.
/// Means are over the points that exist; a slope needs seven points.
///
/// Reference   ISO 21920-2:2021, -3 (five sections); ISO 4287:1997, 3.2.7 and 4.3.1 (widths), 4.4.1 (the slope)
/// Units       heights, spacing, cut-off [m]; Rsk, Rku, Rdq dimensionless
/// Valid       at least 16 points, not all of one height; remove the form first
/// Accuracy    1e-13 relative, and the rounding of an offset (tests/profile/roughness_parameters_test.cpp)

#include <fstiff/math/fft.hpp>
#include <fstiff/profile/profile.hpp>

#include <optional>

namespace fstiff { inline namespace v0_1 {

/// Roughness parameters of a profile by ISO 21920-2.
template <Real T = double>
struct RoughnessParameters {
    T mean_deviation{};               ///< Ra [m]
    T rms_height{};                   ///< Rq [m]
    T skewness{};                     ///< Rsk
    T kurtosis{};                     ///< Rku
    T total_height{};                 ///< Rt [m]
    T section_height{};               ///< Rz [m]
    T section_peak_height{};          ///< Rp [m]
    T section_pit_depth{};            ///< Rv [m]
    std::optional<T> rms_slope{};     ///< Rdq; none where no seven points follow one another
    std::optional<T> mean_spacing{};  ///< RSm [m]; none where no element is complete

    std::size_t sections{};  ///< that hold a point: five, or fewer where points are missing
    T section_length{};      ///< [m]
    bool by_cutoff{};        ///< whether that is the cut-off
};

namespace detail {

/// Adds the means over the sections of [\p first, \p first + \p count) of \p z to \p result.
template <Real F, Real T>
void measure_sections(const std::vector<F>& z, std::size_t first, std::size_t count, F unit,
                      RoughnessParameters<T>& result) {
    F peaks = 0, pits = 0;
    for (std::size_t k = 0; k < 5; ++k) {
        F high = -std::numeric_limits<F>::infinity(), low = -high;
        for (std::size_t i = first + k * count / 5; i < first + (k + 1) * count / 5; ++i) {
            if (std::isnan(z[i])) continue;
            high = (std::max)(high, z[i]);
            low = (std::min)(low, z[i]);
        }
        if (high < low) continue;  // no point
        peaks += high;
        pits -= low;
        ++result.sections;
    }
    const F sections = static_cast<F>(result.sections);
    result.section_peak_height = static_cast<T>(peaks / sections * unit);
    result.section_pit_depth = static_cast<T>(pits / sections * unit);
    result.section_height = static_cast<T>((peaks + pits) / sections * unit);
}

/// Mean square of the slopes by seven points, times the square of the spacing; none where there is no slope.
template <Real F>
[[nodiscard]] std::optional<F> mean_square_rise(const std::vector<F>& z) {
    math::CompensatedSum<F> squares;
    std::size_t slopes = 0;
    for (std::size_t i = 3; i + 3 < z.size(); ++i) {
        const F rise = ((z[i + 3] - z[i - 3]) - 9 * (z[i + 2] - z[i - 2]) + 45 * (z[i + 1] - z[i - 1])) / 60;
        if (std::isnan(rise) || std::isnan(z[i])) continue;
        squares.add(rise * rise);
        ++slopes;
    }
    if (slopes == 0) return {};
    return squares.value() / static_cast<F>(slopes);
}

/// A part of a profile between two crossings of 0, or up to an end or a missing point.
template <Real F>
struct ProfileRun {
    F begin{}, end{};  // in points
    F extreme{};
    bool is_cut{};  // by an end or a missing point
    bool after_gap{};
};

/// The runs of \p z on one side of 0, from the first point on.
template <Real F>
[[nodiscard]] std::vector<ProfileRun<F>> runs_of(const std::vector<F>& z) {
    std::vector<ProfileRun<F>> runs;
    for (std::size_t i = 0; i < z.size(); ++i) {
        if (std::isnan(z[i])) continue;
        const bool after_gap = i == 0 || std::isnan(z[i - 1]);
        const F place = static_cast<F>(i);
        if (after_gap) {
            if (!runs.empty()) runs.back().is_cut = true;
            runs.push_back({place, place, z[i], true, true});
        } else if ((z[i] < 0) != (z[i - 1] < 0)) {
            const F crossing = place - z[i] / (z[i] - z[i - 1]);
            runs.back().end = crossing;
            runs.push_back({crossing, place, z[i], false, false});
        } else {
            ProfileRun<F>& run = runs.back();
            run.end = place;
            run.extreme = run.extreme < 0 ? (std::min)(run.extreme, z[i]) : (std::max)(run.extreme, z[i]);
        }
    }
    if (!runs.empty()) runs.back().is_cut = true;
    return runs;
}

/// Mean distance of the rises of \p z through 0, in points; none where there are none without a missing point between
/// them. A rise leads from a pit below -\p least to the next peak above \p least, both at least \p narrowest wide; at
/// an end any width counts.
template <Real F>
[[nodiscard]] std::optional<F> mean_element_width(const std::vector<F>& z, F least, F narrowest) {
    F width = 0, elements = 0, crossing = 0, last = -1;  // last: the rise that counted; < 0 for none
    bool below = false;
    for (const ProfileRun<F>& run : runs_of(z)) {
        if (run.after_gap) below = false, last = -1;
        if (!run.is_cut && run.end - run.begin < narrowest) continue;
        if (run.extreme < -least) below = true, crossing = run.end;
        if (!below || !(run.extreme > least)) continue;
        if (last >= 0) width += crossing - last, elements += 1;
        last = crossing, below = false;
    }
    if (elements == 0) return {};
    return width / elements;
}

}  // namespace detail

/// Roughness parameters of \p profile, which was filtered with \p cutoff [m] or not at all.
/// \throws domain_error for a profile out of range, or a cut-off that is not positive.
template <Real T>
[[nodiscard]] RoughnessParameters<T> roughness_parameters(const Profile<T>& profile,
                                                          std::optional<std::type_identity_t<T>> cutoff = {}) {
    profile.validate(16);
    if (cutoff) detail::require_positive("cut-off", *cutoff);
    const std::size_t size = profile.size();
    RoughnessParameters<T> result;
    result.rms_height = rms_height(profile);
    const double unit = static_cast<double>(math::power_of_two_below(result.rms_height));
    const T mean = detail::mean_height(profile);
    std::vector<double> z(size);
    math::CompensatedSum<double> rest;
    for (std::size_t i = 0; i < size; ++i) {
        z[i] = static_cast<double>(profile.heights[i] - mean) / unit;
        if (!std::isnan(z[i])) rest.add(z[i]);
    }
    const double points = static_cast<double>(profile.present());
    const double offset = rest.value() / points;  // residual of the rounding of the mean
    math::CompensatedSum<double> firsts, squares, thirds, fourths;
    double high = -std::numeric_limits<double>::infinity(), low = -high;
    for (double& height : z) {
        if (std::isnan(height)) continue;
        height -= offset;
        firsts.add(std::abs(height));
        squares.add(height * height);
        thirds.add(height * height * height);
        fourths.add(height * height * height * height);
        high = (std::max)(high, height);
        low = (std::min)(low, height);
    }
    const double variance = squares.value() / points;
    result.mean_deviation = static_cast<T>(firsts.value() / points * unit);
    result.skewness = static_cast<T>(thirds.value() / points / (variance * std::sqrt(variance)));
    result.kurtosis = static_cast<T>(fourths.value() / points / (variance * variance));
    result.total_height = static_cast<T>((high - low) * unit);
    if (const auto rise = detail::mean_square_rise(z))
        result.rms_slope = static_cast<T>(std::sqrt(*rise) * unit / static_cast<double>(profile.spacing));

    const T steps = cutoff ? std::round(*cutoff / profile.spacing) : T(0);
    result.by_cutoff = steps >= 1 && 5 * steps <= static_cast<T>(size);
    const std::size_t count = result.by_cutoff ? 5 * static_cast<std::size_t>(steps) : size;
    result.section_length = result.by_cutoff ? *cutoff : static_cast<T>(size) * profile.spacing / 5;
    detail::measure_sections(z, (size - count) / 2, count, unit, result);
    const double narrowest = static_cast<double>(result.section_length / profile.spacing) / 100;
    if (const auto width =
            detail::mean_element_width(z, static_cast<double>(result.section_height) / unit / 10, narrowest))
        result.mean_spacing = static_cast<T>(*width * static_cast<double>(profile.spacing));
    return result;
}

}}  // namespace fstiff
