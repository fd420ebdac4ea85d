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

#include <cstdint>

namespace fstiff::inline v0_1 {

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
    WindowEnd begins{};     ///< why the window begins there
    WindowEnd ends{};       ///< and ends there
    T reliable_from{};      ///< shortest lag that resolution and tip allow [m]; 0: not restricted
    bool behind_plateau{};  ///< the window is steeper than a plateau at shorter lags: waviness, not roughness
    T slope_tolerance{};    ///< that the automatic window took; 0 for a window given
    std::size_t lags{};     ///< lags used
    bool finite_band{};     ///< whether the waves beyond the ends of the band show
    bool log_periodic{};    ///< whether these terms entered
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

}  // namespace fstiff::inline v0_1

// Sensitivity of D and G to the window of lags: its bends, its halves, and the straight windows next to it.
//
//     D = 2 - slope/2        ln G by (2.4) from ln S2 at the reference lag of the line
//     window error^2 = mean of max(0, d^2 - 2 sampling^2) over halves and neighbours, by their widths in ln tau
//                      + t^2 s^2/(t^2 + s^2) of a found window shorter than two half decades:
//                        t = tolerance/sqrt(12), s error of the difference of the halves
//
// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.4), (2.5); the rules are this project's
// Units       ln of lags in samples; G in units of the spacing
// Valid       lines of profile/structure_fit; G for 1 < D < 2
// Accuracy    G of an exact power law 1e-12, its derivative 1e-7 (tests/profile/window_spread_test.cpp)

namespace fstiff::inline v0_1::detail {

/// Whether ln S2 bends: its quadratic or its cubic term, each compared with its own sampling error.
template <Real F>
bool is_curved(const LineFitter<F>& fitter, const LogStructure<F>& log, const IndexRange& range) {
    const F middle = (log.lag[range.first] + log.lag[range.last]) / 2;
    const Vector<F> x =
        math::vector_of<F>(range.count(), [&](Eigen::Index i) { return log.lag[range.first + i] - middle; });
    const auto bends = [&](Eigen::Index degree, F change_of_slope) {  // that one of the term gives
        Matrix<F> powers(x.size(), degree + 1);
        for (Eigen::Index k = 0; k <= degree; ++k) math::raise(x.data(), static_cast<F>(k), &powers(0, k), x.size());
        const Matrix<F> solver = math::PivotedQr<F>(powers).solver();
        const Vector<F> row = math::vector_of<F>(log.lag.size(), [&](Eigen::Index i) {
            return i >= range.first && i <= range.last ? solver(degree, i - range.first) : F(0);
        });
        const F bend = std::abs(math::dot_in_lanes(row.data(), fitter.y().data(), row.size()));
        return bend * change_of_slope > F(0.2) && bend > 3 * std::sqrt(fitter.covariance_of(row, row, range));
    };
    const F width = x[x.size() - 1] - x[0];
    return bends(2, 2 * width) || bends(3, 3 * width * width / 4);
}

/// Whether a part of the window is a plateau: a local slope below 0.2, below \p slope of the fit by 0.3 and by more
/// than chance.
template <Real F>
bool flattens(const LogStructure<F>& log, const IndexRange& range, F slope) {
    for (Eigen::Index k = range.first; k <= range.last; ++k)
        if (log.slope[k] < F(0.2) && slope - log.slope[k] > (std::max)(F(0.3), F(1.5) * log.slope_error[k]))
            return true;
    return false;
}

/// D and ln G of a line, and their derivatives by the values of ln S2.
template <Real F>
struct FractalLine {
    F dimension{}, log_g{};  // G in units of the spacing
    F log_g_of_dimension{};  // how ln G changes with D, at one level of S2
    Vector<F> dimension_row, log_g_row;
};

/// D and G of a line; without G unless its slope is between 0 and 2.
template <Real F>
FractalLine<F> fractal_line(const LogFit<F>& line, StructureConvention convention, F gamma) {
    FractalLine<F> fractal;
    fractal.dimension = 2 - line.slope / 2;
    const Eigen::Index size = line.slope_row.size();
    fractal.dimension_row = math::vector_of<F>(size, [&](Eigen::Index i) { return -line.slope_row[i] / 2; });
    fractal.log_g_row = Vector<F>::Zero(size);
    if (!(fractal.dimension > F(1) && fractal.dimension < F(2))) return fractal;
    // of D and ln(S2/lag^2) at the reference lag
    const F level = line.level - 2 * line.reference;
    const auto log_g = [&](F d) {
        return (level - std::log(4 - std::pow(F(2), 4 - 2 * d)) -
                std::log(detail::structure_constant<F>(d, convention, gamma))) /
               (2 * (d - 1));
    };
    const F nearby = F(1e-4) * (std::min)(fractal.dimension - 1, 2 - fractal.dimension);
    const F slope = (log_g(fractal.dimension + nearby) - log_g(fractal.dimension - nearby)) / (2 * nearby);
    fractal.log_g_of_dimension = slope;
    fractal.log_g = log_g(fractal.dimension) + line.reference;
    for (Eigen::Index i = 0; i < size; ++i)
        fractal.log_g_row[i] = line.level_row[i] / (2 * (fractal.dimension - 1)) + slope * fractal.dimension_row[i];
    return fractal;
}

/// The halves of \p range that hold enough lags, and the straight windows on either side of it.
template <Real F>
std::vector<IndexRange> neighbours_of(const LogStructure<F>& log, const IndexRange& range, bool automatic) {
    std::vector<IndexRange> ranges;
    const F middle = (log.lag[range.first] + log.lag[range.last]) / 2;
    Eigen::Index centre = range.first;
    while (centre < range.last && log.lag[centre] < middle) ++centre;
    const auto enough = static_cast<Eigen::Index>(detail::min_window_lags);
    for (const IndexRange half : {IndexRange{range.first, centre}, {centre, range.last}})
        if (half.count() >= enough) ranges.push_back(half);
    if (!automatic) return ranges;
    const Eigen::Index end = log.lag.size() - 1;
    for (const IndexRange side : {IndexRange{0, range.first}, {range.last, end}})
        for (const F tolerance : {F(0.2), F(0.3)}) {
            std::optional<IndexRange> beside = detail::straight_range(log, tolerance, false, side);
            if (!beside) beside = detail::straight_range(log, tolerance, true, side);
            if (!beside) continue;
            ranges.push_back(*beside);
            break;
        }
    return ranges;
}

/// Shares of the window in the errors of D and ln G, from the windows next to that of \p main.
template <Real T>
void set_neighbours(FractalFit<T>& result, const FractalLine<double>& main, const IndexRange& range,
                    const LogStructure<double>& log, const LineFitter<double>& fitter, T spacing, double beyond_model,
                    double& product, const FractalFitOptions<T>& options) {
    double weights = log.lag[range.last] - log.lag[range.first], of_dimension = 0, of_log_g = 0;
    product = 0;
    const auto lag = [&](Eigen::Index k) { return static_cast<T>(log.step[static_cast<std::size_t>(k)]) * spacing; };
    for (const IndexRange& lags : neighbours_of(log, range, result.automatic_window)) {
        const FractalLine<double> other =
            fractal_line<double>(fitter.fit(lags, range), options.convention, static_cast<double>(options.gamma));
        NeighbourWindow<T> neighbour;
        neighbour.window = {lag(lags.first), lag(lags.last)};
        neighbour.half = lags.first >= range.first && lags.last <= range.last;
        neighbour.dimension = static_cast<T>(other.dimension);
        const bool fractal = other.dimension > 1.0 && other.dimension < 2.0;
        if (!neighbour.half && !fractal) continue;  // no window of a self-affine profile
        const double width = log.lag[lags.last] - log.lag[lags.first];
        if (!neighbour.half) weights += width;
        const auto excess = [&](const Vector<double>& a, const Vector<double>& b, double difference) {
            const Vector<double> row = math::vector_of<double>(a.size(), [&](Eigen::Index i) { return a[i] - b[i]; });
            const double expected = fitter.covariance_of(row, row, range) * beyond_model;
            return std::pair{(std::max)(0.0, difference * difference - 2 * expected), std::sqrt(expected)};
        };
        const double off = other.dimension - main.dimension;
        const auto [excess_d, expected] = excess(other.dimension_row, main.dimension_row, off);
        neighbour.difference = static_cast<T>(off);
        neighbour.difference_error = static_cast<T>(expected);
        neighbour.disagrees = std::abs(off) > 2.5 * expected && std::abs(off) > 0.05;
        of_dimension += width * excess_d;
        if (fractal) {
            const double off_g = other.log_g - main.log_g;
            const double excess_g = excess(other.log_g_row, main.log_g_row, off_g).first;
            of_log_g += width * excess_g;
            product += width * std::copysign(std::sqrt(excess_d * excess_g), off * off_g);
        }
        result.neighbours.push_back(neighbour);
    }
    of_dimension /= weights, of_log_g /= weights, product /= weights;
    if (result.automatic_window &&
        log.lag[range.last] - log.lag[range.first] < 2 * std::log(static_cast<double>(detail::min_window_ratio))) {
        // In so short a window the search allows a bend that changes D by up to half the tolerance, with the standard
        // deviation t. The difference of the halves, with the error s, contributes its part to their share; the rest
        // t^2 s^2/(t^2 + s^2) is added here.
        const double t = static_cast<double>(result.slope_tolerance) / std::sqrt(12.0);
        double s = 0;  // the halves depart from the whole in opposite directions
        int halves = 0;
        for (const auto& neighbour : result.neighbours)
            if (neighbour.half) s += static_cast<double>(neighbour.difference_error), ++halves;
        const double unseen = halves == 2 ? t * t * s * s / (t * t + s * s) : t * t, moved = main.log_g_of_dimension;
        of_dimension += unseen, of_log_g += unseen * moved * moved, product += unseen * moved;
    }
    result.window_dimension_error = static_cast<T>(std::sqrt(of_dimension));
    result.window_log_roughness_error = static_cast<T>(std::sqrt(of_log_g));
}

}  // namespace fstiff::inline v0_1::detail
