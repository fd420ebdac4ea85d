// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Options, input and result of a fit of D and G.
///
/// Reference   profile/fractal_fit.hpp, which fills it
/// Units       lags, window, G [m]; structure functions [m^2]
/// Valid       as profile/fractal_fit.hpp
/// Accuracy    that of the fit

#include <fstiff/core/parallel.hpp>
#include <fstiff/profile/lag_window.hpp>
#include <fstiff/profile/structure_fit.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/surface/fractal.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

#include <cstdint>

namespace fstiff { inline namespace v0_1 {

/// Options of the fit of D and G.
template <Real T = double>
struct FractalFitOptions {
    std::optional<LengthRange<T>> window{};  ///< automatic when not given
    StructureConvention convention = StructureConvention::exact;
    T gamma = T(1.5);  ///< of the log-periodic terms and of the constant C
    Divisor divisor = Divisor::pairs;
    std::uint64_t seed = 2014;  ///< of the bootstrap
    int resamples = 200;        ///< of the bootstrap; 0 leaves it out
    T tip_radius{};             ///< of the stylus [m]: lags that may show it are left out; 0: not known
    T resolution{};             ///< of the instrument [m]: shorter lags are left out; 0: not known
    T lambda_s{};               ///< shortest wave of the roughness [m]: shorter lags are left out; 0: none
    T longest{};                ///< lag that an automatic window may reach [m]; 0: not limited
    ProgressHook progress{};    ///< of the bootstrap
};

/// S and S2 of one profile or the mean of several, for fit_fractal().
template <Real T = double>
struct MeasuredStructureFunction {
    StructureFunction<T> structure_function;  ///< to be shown
    StructureFunction<T>
        second_differences;  ///< that is fitted, at some lags, rising; `pairs` are those of one profile
    T spacing{};             ///< [m]
    T rms_height{};          ///< of the profiles [m], the saturation of S2; 0: not known
    std::size_t points{};    ///< of one profile, missing ones included
    T profiles = T(1);       ///< number of profiles in the means
    T apart{};  ///< distance between neighbouring profiles [spacings]: below half the lag they have the same waves;
                ///< 0: they are independent
    /// ln S2 at the given steps (rows) for resamples (columns), for the errors; may be empty. ln S2 in any unit.
    std::function<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>(const std::vector<std::size_t>&)> resample{};
};

/// D of a half of the window, or of a straight window next to it.
template <Real T = double>
struct NeighbourWindow {
    LengthRange<T> window;  ///< [m]
    T dimension{};          ///< D; of a half that is no self-affine profile it may lie outside (1, 2)
    T difference{};         ///< from D of the fit
    T difference_error{};   ///< its standard deviation by sampling
    bool half{};            ///< of the window itself
    bool disagrees{};       ///< by more than 2.5 standard deviations and by 0.05
};

/// D and G of a structure function, with their errors and the data of the fit.
template <Real T = double>
struct FractalFit {
    Fractal<T> fractal;                   ///< D and G [m]
    T dimension_error{};                  ///< standard deviation of D: of sampling and of the choice of the window
    T sampling_dimension_error{};         ///< its share of sampling
    T window_dimension_error{};           ///< and of the window
    T roughness_error{};                  ///< standard deviation of G [m]: G times that of ln G
    T log_roughness_error{};              ///< standard deviation of ln G; G is known to a factor exp of this
    T sampling_log_roughness_error{};     ///< its share of sampling
    T window_log_roughness_error{};       ///< and of the window
    T dimension_roughness_correlation{};  ///< of the errors of D and ln G
    std::vector<NeighbourWindow<T>> neighbours;  ///< that the share of the window comes from
    T regression_dimension_error{};  ///< ordinary least-squares error of D, as if all lags were independent: too small
    T model_dimension_error{};       ///< from the covariance of a Gaussian self-affine profile
    T bootstrap_dimension_error{};   ///< from the moving-block bootstrap; 0 when left out
    T line_dimension{};              ///< D of the ordinary straight line over the same window
    LengthRange<T> window;           ///< shortest and longest lag used [m]
    bool automatic_window{};
    WindowEnd begins{};    ///< why the window begins there
    WindowEnd ends{};      ///< and ends there
    T reliable_from{};     ///< shortest lag that resolution and tip allow [m]; 0: not restricted
    bool after_plateau{};  ///< the window is steeper than a plateau at shorter lags: waviness, not roughness
    T slope_tolerance{};   ///< that the automatic window took; 0 for a window given
    std::size_t lags{};    ///< lags used
    bool finite_band{};    ///< whether the waves beyond the ends of the band show
    bool log_periodic{};   ///< whether these terms entered
    bool curved{};  ///< no clean power law: the slope changes by more than 0.2 and 3 standard deviations from end
                    ///< to end of the window or from its ends to its middle, a half of the window or a window
                    ///< next to it disagrees, the slope is below 0.2, or that of a part is, and less than that of the
                    ///< whole by 0.3 and by 1.5 standard deviations, or the automatic window had to allow more than 0.2
    T slope_shortest{};  ///< local slope of ln S2 at the shortest lag used
    T slope_longest{};   ///< and at the longest
    T min_slope{};       ///< least local slope over the lags used
    T max_slope{};       ///< and greatest
    T flattest_lag{};    ///< where the local slope is least among the lags searched that are shorter than the window
                         ///< [m]; 0: there are none
    T flattest_slope{};  ///< that slope: near 0, a roughness that has saturated below the waviness of the window
    std::uint64_t seed{};
    StructureFunction<T> structure_function;  ///< all lags up to a quarter of the points, beyond the window too
    StructureFunction<T> second_differences;  ///< S2, which is fitted, at all its lags
    StructureFunction<T> fitted;              ///< S2 of the fit at the lags of the window, ends of the band included
};

}}  // namespace fstiff
