// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Fractal dimension D and roughness G of a profile from its second differences, with standard errors.
///
///     ln S2(tau) = (4-2D) ln tau + ln C + ln(4 - 2^(4-2D))                          eq. (2.5), of second differences
///     error^2 = max(model, bootstrap)^2 v/(v-2) + window^2      v: length of the profile over the longest lag
///
/// ```cpp
/// #include <fstiff/profile/fractal_fit.hpp>
/// #include <fstiff/synthetic/weierstrass_mandelbrot.hpp>
///
/// #include <cstdio>
///
/// int main() {
///     const fstiff::WeierstrassMandelbrot<double> waves({.dimension = 1.4, .roughness = 1e-10},
///                                                       {.longest_wavelength = 1e-3, .shortest_wavelength = 1e-6});
///     const auto fit = fstiff::fit_fractal(waves.sample(4096, 0.5e-6));
///     const double error = fit.dimension_error;
///     std::printf("D = %.3f +- %.3f, G = %.1e m\n", fit.fractal.dimension, error, fit.fractal.roughness);
/// }
/// ```
/// ```text
/// D = 1.399 +- 0.028, G = 9.9e-11 m
/// ```
///
/// The model is the covariance of a Gaussian self-affine profile (profile/structure_fit), the bootstrap resamples
/// moving blocks, and the window error comes from other windows (profile/fractal_result).
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.3)-(2.8); Kunsch, Ann. Stat. 17 (1989)
///             1217 (bootstrap); docs/errata.md (the constant C)
/// Units       lags, window, G [m]
/// Valid       at least 16 points, heights that vary; 1 < D < 2
/// Accuracy    Weierstrass-Mandelbrot profiles of 2^16 points, D = 1.3 to 1.8: D within 0.02, G within a factor of 1.5
///             (tests/profile/fractal_fit_test.cpp); coverage of the errors in tests/profile/coverage_test.cpp

#include <fstiff/profile/fractal_result.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/lag_window.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_structure.hpp>
#include <fstiff/profile/structure_fit.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/profile/tip_lengths.hpp>
#include <fstiff/profile/window_sensitivity.hpp>

namespace fstiff { inline namespace v0_1 {

namespace detail {

template <Real T>
FractalFit<T> fit_measured(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options,
                           T tip_length);

/// Covariance of log.value for a Gaussian profile whose S grows as n^\p power.
template <Real F>
Matrix<F> covariance_of(const LogStructure<F>& log, F power) {
    Matrix<F> covariance = log_covariance(log.step, log.pairs, std::clamp(power, F(0.05), F(1.95)));
    const Vector<F> root = math::vector_of<F>(
        log.lag.size(), [&](Eigen::Index k) { return std::sqrt(log.independent(std::exp(log.lag[k]))); });
    for (Eigen::Index i = 0; i < root.size(); ++i)
        for (Eigen::Index j = 0; j < root.size(); ++j) covariance(i, j) /= root[i] * root[j];
    return covariance;
}

/// Scatter of the local slopes.
template <Real F>
void set_slope_error(LogStructure<F>& log) {
    Matrix<F> sampled = covariance_of(log, F(1));
    for (Eigen::Index k = 0; k < sampled.cols(); ++k) sampled(k, k) += F(1e-8);
    const Matrix<F> root = detail::cholesky(sampled);
    log.slope_error = math::vector_of<F>(log.lag.size(), [&](Eigen::Index i) {
        F squares = 0;
        for (Eigen::Index k = 0; k < root.cols(); ++k) {
            const F slope = local_slope(log.lag, &root(0, k), i);
            squares += slope * slope;
        }
        return std::sqrt(squares);
    });
}

/// D and G of \p profile, whose structure function is \p measured.
template <Real T>
FractalFit<T> fit_profile(const Profile<T>& profile, const MeasuredStructureFunction<T>& measured,
                          const FractalFitOptions<T>& options) {
    check_options(options);
    const T tip_length = options.tip_radius > T(0) ? detail::tip_cutoff(profile, options.tip_radius) : T(0);
    FractalFit<T> result = fit_measured(measured, options, tip_length);
    result.seed = options.seed;
    return result;
}

template <Real T>
FractalFit<T> fit_profile(const Profile<T>& profile, const FractalFitOptions<T>& options) {
    return fit_profile(profile, profile_structure(profile, options), options);
}

/// \p options for \p levelled: its cut-offs limit the lags.
template <Real T>
[[nodiscard]] FractalFitOptions<T> fit_options(const LevelledProfile<T>& levelled, FractalFitOptions<T> options) {
    options.lambda_s = (std::max)(options.lambda_s, levelled.lambda_s.value_or(T(0)));
    if (levelled.lambda_c && !(options.longest > T(0) && options.longest < *levelled.lambda_c))
        options.longest = *levelled.lambda_c;
    return options;
}

}  // namespace detail

/// D and G of a profile after removal of its form and before its filters, from lags between its lambda_s and lambda_c.
/// \throws domain_error for a profile or an option out of range, a window with too few lags, when no half decade of
/// lags follows a power law, or when D is not between 1 and 2.
template <Real T>
[[nodiscard]] FractalFit<T> fit_fractal(const LevelledProfile<T>& levelled, const FractalFitOptions<T>& options = {}) {
    return detail::fit_profile(levelled.of_structure(), detail::fit_options(levelled, options));
}

/// D and G of \p profile as it is. \throws domain_error as above.
template <Real T>
[[nodiscard]] FractalFit<T> fit_fractal(const Profile<T>& profile, const FractalFitOptions<T>& options = {}) {
    return detail::fit_profile(profile, options);
}

/// D and G of a structure function, with its resamples; options.divisor, .seed and .resamples are not used.
/// \throws domain_error as above, and when options.tip_radius is given: a tip needs heights, see tip_cutoff().
template <Real T>
[[nodiscard]] FractalFit<T> fit_fractal(const MeasuredStructureFunction<T>& measured,
                                        const FractalFitOptions<T>& options = {}) {
    detail::check_options(options);
    detail::require_positive("spacing", measured.spacing);
    detail::require(measured.profiles >= T(1) && measured.profiles <= (std::numeric_limits<T>::max)(), "profiles",
                    measured.profiles, "finite and at least 1");
    detail::require(measured.rms_height >= T(0) && measured.rms_height <= (std::numeric_limits<T>::max)(), "rms height",
                    measured.rms_height, "finite and not negative");
    detail::require(measured.apart >= T(0) && measured.apart <= (std::numeric_limits<T>::max)(), "apart",
                    measured.apart, "finite and not negative");
    detail::require(options.tip_radius == T(0), "tip radius", options.tip_radius,
                    "left out for a structure function: a tip needs heights");
    const StructureFunction<T>& s = measured.second_differences;
    if (s.step.size() != s.size() || s.value.size() != s.size() || s.pairs.size() != s.size())
        throw domain_error("structure function: its vectors must have one length");
    for (std::size_t k = 0; k < s.size(); ++k) {
        if (s.step[k] < 1 || 2 * s.step[k] >= measured.points || (k > 0 && s.step[k] <= s.step[k - 1]) ||
            s.pairs[k] < 1)
            throw domain_error("structure function, lag = " + std::to_string(s.step[k]) +
                               " samples: lags must rise between 1 and less than half the points, each with a triple");
        detail::require(s.value[k] >= T(0) && s.value[k] <= (std::numeric_limits<T>::max)(), "structure function",
                        s.value[k], "finite and not negative");
    }
    if (options.window) detail::check_window(*options.window, static_cast<T>(measured.points - 1) * measured.spacing);
    return detail::fit_measured(measured, options, T(0));
}

namespace detail {

/// Adds the properties of the window to the result.
template <Real T>
void set_window(FractalFit<T>& result, const LogStructure<double>& log, const ChosenRange<double>& chosen, T spacing,
                const ReliableLags<T>& reliable) {
    const IndexRange& range = chosen.range;
    const auto lag = [&](Eigen::Index k) { return static_cast<T>(log.step[static_cast<std::size_t>(k)]) * spacing; };
    result.reliable_from = reliable.from;
    result.slope_tolerance = static_cast<T>(chosen.tolerance);
    result.after_plateau = chosen.after_plateau;
    result.window = {lag(range.first), lag(range.last)};
    result.lags = static_cast<std::size_t>(range.count());
    result.slope_shortest = static_cast<T>(log.slope[range.first]);
    result.slope_longest = static_cast<T>(log.slope[range.last]);
    result.min_slope = result.max_slope = result.slope_shortest;
    for (Eigen::Index k = 0; k <= range.last; ++k) {
        const T slope = static_cast<T>(log.slope[k]);
        if (k >= range.first) {
            result.min_slope = (std::min)(result.min_slope, slope);
            result.max_slope = (std::max)(result.max_slope, slope);
        } else if (log.lag[k] >= std::log(log.shortest()) &&
                   (result.flattest_lag == T(0) || slope < result.flattest_slope)) {
            result.flattest_lag = lag(k);
            result.flattest_slope = slope;
        }
    }
    const auto why = [&](Eigen::Index next, WindowEnd outermost) {
        return result.automatic_window ? why_there(log, range, next, outermost) : WindowEnd::given;
    };
    const bool limited = reliable.from > T(0) && range.first == 0;
    result.begins = limited ? reliable.limit : why(range.first - 1, WindowEnd::sampling);
    result.ends = why(range.last + 1, WindowEnd::length);
}

/// Computes D, G, and their errors.
template <Real T>
void set_fractal(FractalFit<T>& result, const LogFit<double>& line, const LogStructure<double>& log,
                 const LineFitter<double>& fitter, const Matrix<double>& resampled, T spacing,
                 const FractalFitOptions<T>& options) {
    const IndexRange& range = line.range;
    const FractalLine<double> main =
        detail::fractal_line<double>(line, options.convention, static_cast<double>(options.gamma));
    const auto expected = [&](const Vector<double>& row) { return std::sqrt(fitter.covariance_of(row, row, range)); };
    // the scatter of a profile with few of the longest lags is uncertain: deviation of Student's t
    const double longest = std::exp(log.lag[range.last]);
    const double pieces = (std::max)(4.0, static_cast<double>(log.points) / longest * log.independent(longest));
    const double few = std::sqrt(pieces / (pieces - 2));
    double of_dimension = expected(main.dimension_row), of_log_g = expected(main.log_g_row);
    double correlation = fitter.covariance_of(main.dimension_row, main.log_g_row, range) / of_dimension / of_log_g;
    result.model_dimension_error = static_cast<T>(of_dimension);
    double beyond_model = 1;  // how much more the variance is than that of a Gaussian profile
    if (resampled.size() > 0) {
        const auto part = [&](const Vector<double>& row) {
            return math::vector_of<double>(range.count(), [&](Eigen::Index i) { return row[range.first + i]; });
        };
        const double bootstrap = sample_spread(part(main.dimension_row), resampled);
        result.bootstrap_dimension_error = static_cast<T>(bootstrap);
        beyond_model = (std::max)(1.0, bootstrap * bootstrap / (of_dimension * of_dimension));
        of_dimension = (std::max)(of_dimension, bootstrap);
        of_log_g = (std::max)(of_log_g, sample_spread(part(main.log_g_row), resampled));
    }
    of_dimension *= few, of_log_g *= few;
    result.sampling_dimension_error = static_cast<T>(of_dimension);
    result.sampling_log_roughness_error = static_cast<T>(of_log_g);
    double product = 0;  // of the shares of the window
    detail::set_neighbours(result, main, range, log, fitter, spacing, beyond_model, product, options);
    const double dimension_error = std::hypot(of_dimension, static_cast<double>(result.window_dimension_error));
    const double log_g_error = std::hypot(of_log_g, static_cast<double>(result.window_log_roughness_error));
    result.dimension_roughness_correlation = static_cast<T>(
        std::clamp((correlation * of_dimension * of_log_g + product) / (dimension_error * log_g_error), -1.0, 1.0));
    result.fractal.dimension = static_cast<T>(main.dimension);
    const double roughness = std::exp(main.log_g) * static_cast<double>(spacing);
    result.fractal.roughness = static_cast<T>(roughness);
    require(result.fractal.roughness >= (std::numeric_limits<T>::min)() &&
                result.fractal.roughness <= (std::numeric_limits<T>::max)(),
            "fractal dimension of the window", main.dimension, "further from 1: G is beyond the range of numbers");
    result.dimension_error = static_cast<T>(dimension_error);
    result.log_roughness_error = static_cast<T>(log_g_error);
    const double absolute = roughness * log_g_error;
    require(absolute <= static_cast<double>((std::numeric_limits<T>::max)()), "fractal dimension of the window",
            main.dimension, "further from 1: the error of G is beyond the range of numbers");
    result.roughness_error = static_cast<T>(absolute);
}

/// \p measured, restricted to lags up to \p longest [m].
template <Real T>
StructureFunction<T> up_to(StructureFunction<T> measured, T longest) {
    while (measured.size() > 0 && measured.lag.back() > longest * T(1.0001)) {
        measured.step.pop_back();
        measured.lag.pop_back();
        measured.value.pop_back();
        measured.pairs.pop_back();
    }
    return measured;
}

/// Sets D of the ordinary straight line over \p range, and its error. Returns the slope.
template <Real T>
double set_ordinary_line(FractalFit<T>& result, const LogStructure<double>& log, const IndexRange& range) {
    const Eigen::Index size = range.count();
    const auto part = [&](const Vector<double>& all) {
        return math::vector_of<double>(size, [&](Eigen::Index i) { return all[range.first + i]; });
    };
    const auto mean = [&](const Vector<double>& v) {
        return math::sum_in_lanes(v.data(), size) / static_cast<double>(size);
    };
    const auto squares = [&](const Vector<double>& v) { return math::dot_in_lanes(v.data(), v.data(), size); };
    const Vector<double> x = part(log.lag), y = part(log.value);
    const double slope = regression_slope(x, y.data(), 0, size - 1), mean_x = mean(x), mean_y = mean(y);
    const Vector<double> centred = math::vector_of<double>(size, [&](Eigen::Index i) { return x[i] - mean_x; });
    const Vector<double> rest =
        math::vector_of<double>(size, [&](Eigen::Index i) { return y[i] - mean_y - slope * centred[i]; });
    result.line_dimension = static_cast<T>(2 - slope / 2);
    result.regression_dimension_error =
        static_cast<T>(std::sqrt(squares(rest) / static_cast<double>(result.lags - 2) / squares(centred)) / 2);
    return slope;
}

/// \throws domain_error for a window that was found on a plateau.
template <Real T>
[[noreturn]] FSTIFF_COLD void refuse_plateau(const FractalFit<T>& fit, T dimension) {
    throw domain_error({.parameter = "fractal dimension of the window",
                        .value = rounded_text(dimension, 4),
                        .reason = "the slope goes from " + rounded_text(fit.slope_shortest, 3) + " to " +
                                  rounded_text(fit.slope_longest, 3) + " between the lags " +
                                  rounded_text(fit.window.from, 3) + " m and " + rounded_text(fit.window.to, 3) +
                                  " m: a plateau; must be at most 1.9 in a window that is found"});
}

/// S2 of the fitted \p line at the lags of its window.
template <Real T>
void set_fitted(FractalFit<T>& result, const LogFit<double>& line, const LogStructure<double>& log, T spacing) {
    for (Eigen::Index k = 0; k < line.range.count(); ++k) {
        const auto index = static_cast<std::size_t>(line.range.first + k);
        result.fitted.step.push_back(log.step[index]);
        result.fitted.pairs.push_back(log.pairs[index]);
        result.fitted.lag.push_back(static_cast<T>(log.step[index]) * spacing);
        result.fitted.value.push_back(
            static_cast<T>(std::exp(line.fitted[k] + 2 * std::log(static_cast<double>(spacing)))));
    }
}

template <Real T>
FractalFit<T> fit_measured(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options,
                           T tip_length) {
    FractalFit<T> result;
    result.structure_function = measured.structure_function;
    result.second_differences = measured.second_differences;
    result.automatic_window = !options.window;
    const T spacing = measured.spacing;
    ReliableLags<T> reliable{options.resolution, WindowEnd::resolution};
    if (options.lambda_s > reliable.from) reliable = {options.lambda_s, WindowEnd::lambda_s};
    if (tip_length > reliable.from) reliable = {tip_length, WindowEnd::tip};
    const T longest = !options.window && options.longest > T(0) ? options.longest : std::numeric_limits<T>::infinity();
    LogStructure<double> log =
        log_structure(up_to(measured.second_differences, longest), spacing, measured.points, reliable);
    log.profiles = static_cast<double>(measured.profiles);
    log.apart = static_cast<double>(measured.apart);
    if (measured.rms_height > T(0))  // the variance of z - 2 z' + z'' where the three have nothing in common
        log.saturated = std::log(6.0) + 2 * std::log(static_cast<double>(measured.rms_height / spacing));
    set_slope_error(log);
    const ChosenRange<double> chosen =
        options.window ? given_range(log, *options.window, spacing, reliable) : automatic_range(log, spacing, reliable);
    set_window(result, log, chosen, spacing, reliable);

    const IndexRange& range = chosen.range;
    double power = std::clamp(set_ordinary_line(result, log, range), 0.05, 1.95);
    const double log_gamma = std::log(static_cast<double>(options.gamma));
    std::optional<LineFitter<double>> fitter;
    LogFit<double> line;
    for (int round = 0; round < 4; ++round) {  // covariance, filter and band ends depend weakly on the slope
        const bool band_ends = range.first > 0 && log.slope[0] > power + 0.3;  // S2 is steeper at shorter lags
        fitter.emplace(log, covariance_of(log, power), power, log_gamma, band_ends);
        line = fitter->fit(range, range);
        if (std::abs(line.slope - power) < 0.01) break;
        power = std::clamp(line.slope, 0.05, 1.95);
    }
    result.finite_band = line.finite_band;
    result.log_periodic = line.log_periodic;
    const double dimension = 2 - line.slope / 2;
    require(dimension > 1.0 && dimension < 2.0, "fractal dimension of the window", dimension,
            "between 1 and 2, both excluded: this window holds no fractal profile");
    if (result.automatic_window && line.slope < 0.2) refuse_plateau(result, static_cast<T>(dimension));
    Matrix<double> resampled;
    if (measured.resample) {
        resampled = measured.resample({log.step.begin() + range.first, log.step.begin() + range.last + 1});
        if (resampled.rows() != range.count() || resampled.cols() < 2 ||
            !std::all_of(resampled.data(), resampled.data() + resampled.size(),
                         [](double value) { return std::isfinite(value); }))
            refuse("resamples of the structure function", "", "finite, a row for every lag, two columns or more");
    }
    set_fractal(result, line, log, *fitter, resampled, spacing, options);
    set_fitted(result, line, log, spacing);
    result.curved = detail::is_curved(*fitter, log, range) || result.slope_tolerance > T(0.21) || line.slope < 0.2 ||
                    detail::flattens(log, range, line.slope) ||
                    std::any_of(result.neighbours.begin(), result.neighbours.end(),
                                [](const auto& neighbour) { return neighbour.disagrees; });
    return result;
}

}  // namespace detail

}}  // namespace fstiff
