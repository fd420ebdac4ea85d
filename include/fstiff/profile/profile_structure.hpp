// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Structure function of a profile with its resamples, as a fit of D and G takes it.

#include <fstiff/profile/fractal_result.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/structure_fit.hpp>
#include <fstiff/profile/structure_function.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real T>
void check_options(const FractalFitOptions<T>& options) {
    require(options.gamma > T(1) && options.gamma <= (std::numeric_limits<T>::max)(), "gamma", options.gamma,
            "finite and greater than 1");
    require(options.resamples >= 0 && options.resamples <= 100000, "resamples", options.resamples,
            "between 0 and 100000");
    for (const auto& [name, value] : {std::pair{"tip radius", options.tip_radius},
                                      {"resolution", options.resolution},
                                      {"lambda_s", options.lambda_s}})
        require(value >= T(0) && value <= (std::numeric_limits<T>::max)(), name, value,
                "finite and greater than 0, or 0 when it is not known");
}

template <Real T>
void check_window(const LengthRange<T>& window, T length) {
    require_positive("window from", window.from);
    require(window.to > window.from && window.to <= length, "window to", window.to,
            "greater than the beginning of the window and at most the length of the profile");
}

/// S and S2 of \p profile with their resamples, for the lags of \p options. \throws domain_error as fit_fractal().
template <Real T>
MeasuredStructureFunction<T> profile_structure(const Profile<T>& profile, const FractalFitOptions<T>& options) {
    profile.validate(16);
    check_options(options);
    const std::size_t points = profile.size();
    // beyond the usual quarter of the points only when the window asks for it
    std::size_t longest = points / 4;
    if (options.window) {
        check_window(*options.window, profile.length());
        const auto last = static_cast<std::size_t>(options.window->to / profile.spacing * T(1.0001));
        longest = (std::max)(longest, (std::min)(points - 2, last));
    }
    const std::vector<std::size_t> lags = logarithmic_lags(longest);
    MeasuredStructureFunction<T> measured;
    measured.structure_function = structure_function(profile, std::span<const std::size_t>(lags), options.divisor);
    const std::vector<std::size_t> triples = logarithmic_lags((std::min)(longest, (points - 1) / 2));
    measured.second_differences = second_differences(profile, std::span<const std::size_t>(triples));
    measured.spacing = profile.spacing;
    measured.rms_height = rms_height(profile);
    measured.points = points;
    if (options.resamples > 1)
        measured.resample = [heights = Profile<double>{{profile.heights.begin(), profile.heights.end()},
                                                       static_cast<double>(profile.spacing)},
                             resamples = options.resamples, seed = options.seed,
                             progress = options.progress](const std::vector<std::size_t>& steps) {
            return bootstrap_log_structure(heights, steps, resamples, seed, progress);
        };
    return measured;
}

}}}  // namespace fstiff::detail
