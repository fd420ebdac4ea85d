// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Fractal dimension D and roughness G of a profile, from its structure function, with errors.
///
///     ln S(tau) = (4-2D) ln tau + ln C                                              eq. (2.5)
///
/// A weighted least-squares line (profile/structure_fit) over a window of lags that is found or given
/// (profile/lag_window). A profile that knows what form was removed of it has the loss put right (profile/form_loss).
///
/// Errors (one standard deviation): the larger of
///  - what the covariance of S of a Gaussian self-affine profile with the fitted D gives, in closed form: the limit of
///    many simulations at the fitted parameters;
///  - a moving-block bootstrap over the profile, seeded, which sees what is not Gaussian;
/// and the textbook regression error, more than ten times too small on random walks because S at neighbouring lags is
/// correlated, beside them.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.3)-(2.8); Kunsch, Ann. Stat. 17 (1989)
///             for the bootstrap; docs/errata.md for the constant C.
/// Units       lags, window, G [m]
/// Valid       16 points at least, heights that vary; D strictly between 1 and 2
/// Accuracy    Weierstrass-Mandelbrot profiles of 2^16 points waves from their length to two samples, D = 1.3 to 1.8:
///             D within 0.02 and its own 3 sigma, G within a factor 1.5; 200 random walks of 1000 points: the error of
///             D is 0.8 to 1.25 times the scatter of D (tests/profile/fractal_fit_test.cpp)

#include <fstiff/core/progress.hpp>
#include <fstiff/profile/form_loss.hpp>
#include <fstiff/profile/lag_window.hpp>
#include <fstiff/profile/level.hpp>
#include <fstiff/profile/structure_errors.hpp>
#include <fstiff/profile/structure_fit.hpp>
#include <fstiff/profile/tip_cutoff.hpp>
#include <fstiff/surface/structure_constant.hpp>

#include <functional>

namespace fstiff {

template <Real T = double>
struct FractalFitOptions {
    std::optional<LagWindow<T>> window{};  ///< automatic when not given
    StructureConvention convention = StructureConvention::exact;
    T gamma = T(1.5);  ///< of the log-periodic terms and of the constant C
    Divisor divisor = Divisor::pairs;
    std::uint64_t seed = 2014;  ///< of the bootstrap
    int resamples = 200;        ///< of the bootstrap; 0 leaves it out
    T tip_radius{};             ///< of the stylus [m]: lags that may show it are left out; 0: not known
    T resolution{};             ///< of the instrument [m]: shorter lags are left out; 0: not known
    T longest{};                ///< lag that an automatic window may reach [m]; 0: not limited
    ProgressHook progress{};    ///< of the bootstrap
};

/// S of one profile or the mean of several, for fit_fractal().
template <Real T = double>
struct MeasuredStructureFunction {
    StructureFunction<T> structure_function;  ///< at some lags, rising; `pairs` are those of one profile
    T spacing{};                              ///< [m]
    std::size_t points{};                     ///< of one profile, missing ones included
    Form removed = Form::none;                ///< of the profiles: what its removal took of S is made up for
    T profiles = T(1);                        ///< independent ones that S is the mean of: their number divides the
                                              ///< variance that the model expects
    /// ln S at the steps given (rows) of resamples (columns), for the errors; may be empty. ln S in any unit.
    std::function<Eigen::Matrix<Accumulator<T>, Eigen::Dynamic, Eigen::Dynamic>(const std::vector<std::size_t>&)>
        resample{};
};

template <Real T = double>
struct FractalFit {
    Fractal<T> fractal;              ///< D and G [m]
    T dimension_error{};             ///< standard deviation of D
    T roughness_error{};             ///< standard deviation of G [m]: G times that of ln G
    T log_roughness_error{};         ///< standard deviation of ln G; G is known to a factor exp of this
    T regression_dimension_error{};  ///< ordinary least-squares error of D, as if all lags were independent: too small
    T model_dimension_error{};       ///< from the covariance of a Gaussian self-affine profile
    T bootstrap_dimension_error{};   ///< from the moving-block bootstrap; 0 when left out
    T line_dimension{};              ///< D of the ordinary straight line over the same window
    LagWindow<T> window;             ///< shortest and longest lag used [m]
    bool automatic_window{};
    WindowEnd begins{};     ///< why the window begins there
    WindowEnd ends{};       ///< and ends there
    T reliable_from{};      ///< shortest lag that resolution and tip allow [m]; 0: not restricted
    bool behind_plateau{};  ///< the window is steeper than a plateau at shorter lags: waviness, not roughness
    T slope_tolerance{};    ///< that the automatic window took; 0 for a window given
    std::size_t lags{};     ///< lags used
    bool finite_band{};     ///< whether these terms entered
    bool log_periodic{};    ///< whether these terms entered
    bool curved{};       ///< no clean power law: the slope changes by more than 0.2 and 3 standard deviations from end
                         ///< to end of the window or from its ends to its middle, or the automatic window had to
                         ///< allow more than 0.2
    T slope_shortest{};  ///< local slope of ln S at the shortest lag used
    T slope_longest{};   ///< and at the longest
    T min_slope{};       ///< least local slope over the lags used
    T max_slope{};       ///< and greatest
    T flattest_lag{};    ///< where the local slope is least among the lags searched that are shorter than the window
                         ///< [m]; 0: there are none
    T flattest_slope{};  ///< that slope: near 0, a roughness that has saturated below the waviness of the window
    std::uint64_t seed{};
    StructureFunction<T> structure_function;  ///< all lags up to a quarter of the points, beyond the window too
};

/// D and G of a profile without its form. What the removal of the form took of the long lags is made up for.
/// \throws domain_error for a profile or an option out of range, a window that holds too few lags, when no half decade
/// of lags follows a power law, or when D is not between 1 and 2.
template <Real T>
[[nodiscard]] FractalFit<T> fit_fractal(const LevelledProfile<T>& levelled, const FractalFitOptions<T>& options = {});

/// D and G of \p profile as it is, of which nothing was removed. \throws domain_error as above.
template <Real T>
[[nodiscard]] FractalFit<T> fit_fractal(const Profile<T>& profile, const FractalFitOptions<T>& options = {});

/// D and G of a structure function, with the resamples that come with it; options.divisor, .seed and .resamples have no
/// part in it.
/// \throws domain_error as above, and when options.tip_radius is given: a tip needs heights, see tip_cutoff().
template <Real T>
[[nodiscard]] FractalFit<T> fit_fractal(const MeasuredStructureFunction<T>& measured,
                                        const FractalFitOptions<T>& options = {});

namespace detail {

template <Real T>
void check_options(const FractalFitOptions<T>& options) {
    require(options.gamma > T(1) && options.gamma <= std::numeric_limits<T>::max(), "gamma", options.gamma,
            "finite and greater than 1");
    require(options.resamples >= 0 && options.resamples <= 100000, "resamples", options.resamples,
            "between 0 and 100000");
    for (const auto& [name, value] : {std::pair{"tip radius", options.tip_radius}, {"resolution", options.resolution}})
        require(value >= T(0) && value <= std::numeric_limits<T>::max(), name, value,
                "finite and greater than 0, or 0 when it is not known");
}

template <Real T>
void check_window(const LagWindow<T>& window, T length) {
    require_positive("window from", window.from);
    require(window.to > window.from && window.to <= length, "window to", window.to,
            "greater than the beginning of the window and at most the length of the profile");
}

template <Real T>
FractalFit<T> fit_profile(const Profile<T>& profile, Form removed, const FractalFitOptions<T>& options);

template <Real T>
FractalFit<T> fit_measured(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options,
                           T tip_length);

}  // namespace detail

template <Real T>
FractalFit<T> detail::fit_profile(const Profile<T>& profile, Form removed, const FractalFitOptions<T>& options) {
    using F = Accumulator<T>;
    profile.validate(16);
    detail::check_options(options);
    const std::size_t points = profile.size();
    // beyond the usual quarter of the points only when the window asks for it
    std::size_t longest = points / 4;
    if (options.window) {
        detail::check_window(*options.window, profile.length());
        longest = std::max(
            longest, std::min(points - 2, static_cast<std::size_t>(options.window->to / profile.spacing * T(1.0001))));
    }
    const std::vector<std::size_t> wanted = logarithmic_lags(longest);
    MeasuredStructureFunction<T> measured;
    measured.structure_function = structure_function(profile, std::span<const std::size_t>(wanted), options.divisor);
    measured.spacing = profile.spacing;
    measured.points = points;
    measured.removed = removed;
    if (options.resamples > 1)
        measured.resample = [&](const std::vector<std::size_t>& steps) {
            const Profile<F> heights{std::vector<F>(profile.heights.begin(), profile.heights.end()),
                                     static_cast<F>(profile.spacing)};
            return detail::bootstrap_log_structure(heights, steps, options.resamples, options.seed, options.progress);
        };
    const T tip_length = options.tip_radius > T(0) ? tip_cutoff(profile, options.tip_radius) : T(0);
    FractalFit<T> result = detail::fit_measured(measured, options, tip_length);
    result.seed = options.seed;
    return result;
}

template <Real T>
FractalFit<T> fit_fractal(const LevelledProfile<T>& levelled, const FractalFitOptions<T>& options) {
    FractalFitOptions<T> how = options;
    if (levelled.lambda_c && !(how.longest > T(0) && how.longest < *levelled.lambda_c))
        how.longest = *levelled.lambda_c;
    return detail::fit_profile(levelled.of_structure(), levelled.mark(), how);
}

template <Real T>
FractalFit<T> fit_fractal(const Profile<T>& profile, const FractalFitOptions<T>& options) {
    return detail::fit_profile(profile, Form::none, options);
}

template <Real T>
FractalFit<T> fit_fractal(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options) {
    detail::check_options(options);
    require_positive("spacing", measured.spacing);
    require(measured.profiles > T(0) && measured.profiles <= std::numeric_limits<T>::max(), "profiles",
            measured.profiles, "finite and greater than 0");
    require(options.tip_radius == T(0), "tip radius", options.tip_radius,
            "left out for a structure function: a tip needs heights");
    const StructureFunction<T>& s = measured.structure_function;
    if (s.step.size() != s.size() || s.value.size() != s.size() || s.pairs.size() != s.size())
        throw domain_error("structure function: its vectors must have one length");
    for (std::size_t k = 0; k < s.size(); ++k) {
        if (s.step[k] < 1 || s.step[k] >= measured.points || (k > 0 && s.step[k] <= s.step[k - 1]) || s.pairs[k] < 1)
            throw domain_error("structure function, lag = " + std::to_string(s.step[k]) +
                               " samples: lags must rise between 1 and one less than the points, each with a pair");
        require(s.value[k] >= T(0) && s.value[k] <= std::numeric_limits<T>::max(), "structure function", s.value[k],
                "finite and not negative");
    }
    if (options.window) detail::check_window(*options.window, static_cast<T>(measured.points - 1) * measured.spacing);
    return detail::fit_measured(measured, options, T(0));
}

namespace detail {

/// What the result says of its window.
template <Real T>
void set_window(FractalFit<T>& result, const LogStructure<Accumulator<T>>& log,
                const ChosenRange<Accumulator<T>>& chosen, T spacing, const ReliableLags<T>& reliable) {
    const IndexRange& range = chosen.range;
    const auto lag = [&](Eigen::Index k) { return static_cast<T>(log.step[static_cast<std::size_t>(k)]) * spacing; };
    result.reliable_from = reliable.from;
    result.slope_tolerance = static_cast<T>(chosen.tolerance);
    result.behind_plateau = chosen.behind_plateau;
    result.window = {lag(range.first), lag(range.last)};
    result.lags = static_cast<std::size_t>(range.count());
    result.slope_shortest = static_cast<T>(log.slope[range.first]);
    result.slope_longest = static_cast<T>(log.slope[range.last]);
    result.min_slope = result.max_slope = result.slope_shortest;
    for (Eigen::Index k = 0; k <= range.last; ++k) {
        const T here = static_cast<T>(log.slope[k]);
        if (k >= range.first) {
            result.min_slope = std::min(result.min_slope, here);
            result.max_slope = std::max(result.max_slope, here);
        } else if (log.lag[k] >= std::log(log.shortest()) &&
                   (result.flattest_lag == T(0) || here < result.flattest_slope)) {
            result.flattest_lag = lag(k);
            result.flattest_slope = here;
        }
    }
    const auto why = [&](Eigen::Index next, WindowEnd outermost) {
        return result.automatic_window ? why_there(log, range, next, outermost) : WindowEnd::given;
    };
    const bool limited = reliable.from > T(0) && range.first == 0;
    result.begins = limited ? reliable.limit : why(range.first - 1, WindowEnd::sampling);
    result.ends = why(range.last + 1, WindowEnd::length);
}

/// Whether ln S bends: its quadratic or its cubic term, each against its own sampling error.
template <Real F>
bool is_curved(const WindowFit<F>& window, const Matrix<F>& covariance) {
    const auto bends = [&](Eigen::Index degree, F change_of_slope) {  // that one of the term gives
        Matrix<F> powers(window.x().size(), degree + 1);
        for (Eigen::Index k = 0; k <= degree; ++k) powers.col(k) = window.x().array().pow(static_cast<F>(k)).matrix();
        const Vector<F> row = PivotedQr<F>(powers).solver().row(degree).transpose();
        const F bend = std::abs(row.dot(window.y()));
        return bend * change_of_slope > F(0.2) && bend > 3 * expected_spread(row, covariance);
    };
    const F width = window.width();
    return bends(2, 2 * width) || bends(3, 3 * width * width / 4);
}

/// G, and the errors of it and of D.
template <Real T>
void set_fractal(FractalFit<T>& result, const WindowFit<Accumulator<T>>& window, const LogFit<Accumulator<T>>& fit,
                 const FitRows<Accumulator<T>>& rows, const Matrix<Accumulator<T>>& covariance,
                 const Matrix<Accumulator<T>>& resampled, T spacing, const FractalFitOptions<T>& options) {
    using F = Accumulator<T>;
    const F dimension = 2 - fit.coefficients[1] / 2;
    // ln(G/reference lag) of D and ln(S/lag^2) at the reference lag
    const F level = fit.coefficients[0] - 2 * window.log_reference();
    const auto log_g = [&](F d) {
        return (level - std::log(structure_constant<F>(d, options.convention, static_cast<F>(options.gamma)))) /
               (2 * (d - 1));
    };
    const F nearby = F(1e-4) * std::min(dimension - 1, 2 - dimension);
    const F log_g_slope = (log_g(dimension + nearby) - log_g(dimension - nearby)) / (2 * nearby);
    const Vector<F> roughness_row = rows.level / (2 * (dimension - 1)) + log_g_slope * rows.dimension;
    F dimension_error = expected_spread(rows.dimension, covariance);
    F roughness_error = expected_spread(roughness_row, covariance);
    result.model_dimension_error = static_cast<T>(dimension_error);
    if (resampled.size() > 0) {
        const F bootstrap = sample_spread(rows.dimension, resampled);
        result.bootstrap_dimension_error = static_cast<T>(bootstrap);
        dimension_error = std::max(dimension_error, bootstrap);
        roughness_error = std::max(roughness_error, sample_spread(roughness_row, resampled));
    }
    result.fractal.dimension = static_cast<T>(dimension);
    const F roughness = std::exp(log_g(dimension) + window.log_reference()) * static_cast<F>(spacing);
    result.fractal.roughness = static_cast<T>(roughness);
    require(result.fractal.roughness >= std::numeric_limits<T>::min() &&
                result.fractal.roughness <= std::numeric_limits<T>::max(),
            "fractal dimension of the window", dimension, "further from 1: G is beyond the range of numbers");
    result.dimension_error = static_cast<T>(dimension_error);
    result.log_roughness_error = static_cast<T>(roughness_error);
    const F absolute = roughness * roughness_error;
    require(absolute <= static_cast<F>(std::numeric_limits<T>::max()), "fractal dimension of the window", dimension,
            "further from 1: the error of G is beyond the range of numbers");
    result.roughness_error = static_cast<T>(absolute);
}

}  // namespace detail

template <Real T>
FractalFit<T> detail::fit_measured(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options,
                                   T tip_length) {
    using F = Accumulator<T>;  // the fit of a float profile is done in double
    FractalFit<T> result;
    result.structure_function = measured.structure_function;
    result.automatic_window = !options.window;
    const T spacing = measured.spacing;
    const ReliableLags<T> reliable{std::max(tip_length, options.resolution),
                                   tip_length > options.resolution ? WindowEnd::tip : WindowEnd::resolution};
    StructureFunction<T> searched = measured.structure_function;
    if (!options.window && options.longest > T(0))
        while (searched.size() > 0 && searched.lag.back() > options.longest * T(1.0001)) {
            searched.step.pop_back();
            searched.lag.pop_back();
            searched.value.pop_back();
            searched.pairs.pop_back();
        }
    const LogStructure<F> log = log_structure(searched, spacing, measured.points, reliable);
    const ChosenRange<F> chosen =
        options.window ? given_range(log, *options.window, spacing, reliable) : automatic_range(log, spacing, reliable);
    set_window(result, log, chosen, spacing, reliable);

    const auto part = [&](const std::vector<std::size_t>& all) {
        return std::vector<std::size_t>{all.begin() + chosen.range.first, all.begin() + chosen.range.last + 1};
    };
    const std::vector<std::size_t> step = part(log.step), pairs = part(log.pairs);
    WindowFit<F> window(log, chosen.range, std::log(static_cast<F>(options.gamma)));
    const LogFit<F>& ordinary = window.ordinary();
    result.line_dimension = static_cast<T>(2 - ordinary.coefficients[1] / 2);
    result.regression_dimension_error =
        static_cast<T>(std::sqrt(ordinary.residual / static_cast<F>(result.lags - 2) /
                                 (window.x().array() - window.x().mean()).square().sum()) /
                       2);
    const bool has_no_form = measured.removed == Form::none || measured.removed == Form::mean;
    const auto retained = [&](F power) {
        return log_retained<F>(step, measured.points, std::clamp(power, F(0.02), F(1.98)), measured.removed);
    };
    const LogFit<F> fit = window.fit(retained, has_no_form);
    result.finite_band = fit.finite_band;
    result.log_periodic = fit.log_periodic;
    const F power = fit.coefficients[1], dimension = 2 - power / 2;
    require(dimension > F(1) && dimension < F(2), "fractal dimension of the window", dimension,
            "between 1 and 2, both excluded: this window holds no fractal profile");

    const Matrix<F> covariance =
        log_covariance(step, pairs, measured.points, power) / static_cast<F>(measured.profiles);
    Matrix<F> resampled;
    if (measured.resample) {
        resampled = measured.resample(step);
        if (resampled.rows() != chosen.range.count() || resampled.cols() < 2 || !resampled.allFinite())
            refuse("resamples of the structure function", "",
                   "finite, a row for every lag asked for, two columns or more");
    }
    set_fractal(result, window, fit, window.rows(fit, retained, has_no_form), covariance, resampled, spacing, options);
    result.curved = is_curved(window, covariance) || result.slope_tolerance > T(0.21);
    return result;
}

}  // namespace fstiff
