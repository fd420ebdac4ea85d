// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Fractal dimension D and roughness G of a profile, from its structure function, with errors.
///
///     ln S(tau) = (4-2D) ln tau + ln C                                              eq. (2.5)
///               + a tau^-(4-2D) + b tau^(2D-2)                                      finite band
///               + harmonics 1, 2 of cos, sin(2 pi ln tau / ln gamma)                log-periodic
///
/// A weighted least-squares line over a window of lags. Two kinds of terms are added where they matter:
///  - finite band, in windows of two decades and more: a the waves below the resolution, or noise; b the waves longer
///    than the profile, or removed with its form. Left out, they bias D of Weierstrass-Mandelbrot profiles by 0.02 or
///    more;
///  - log-periodic, where they explain more than half of the scatter about the line.
/// The weights 1/(n/N + 0.0009) for a lag of n of N samples follow the sampling error, with a floor for what the model
/// misses.
///
/// Automatic window: the longest range of lags, half a decade at least, over which the local slope of ln S (over a
/// factor of 2.25) keeps to the slope of the range within 0.2, or 1.5 sqrt(n/N) where that is more, and lies between
/// 0.05 and 1.9: 2 is a profile that is smooth below its resolution, or tilted; 0 one that has saturated. When there is
/// none, 0.2 becomes 0.3, 0.45, 0.6, and the result is flagged as curved. Lags of 4 samples to a tenth of the points
/// are searched; 1 sample to a quarter for a profile of fewer than 400 points. Lags below the resolution, or that may show
/// the tip (profile/tip_cutoff.hpp), are left out of everything.
/// A range behind a plateau is waviness over a roughness that has saturated: some shorter lag has a slope below 0.2, and
/// the range is steeper by 0.3 or more. It is taken only when no range before the plateau is as straight, and at a
/// tolerance above 0.2 only when there is none at all.
///
/// A form that was removed took long waves of the roughness along: S of a self-affine profile without its line is low by a
/// tenth and more at a tenth of the length, the more the smoother it is, and D would come out high, by 0.04 at D = 1.2.
/// Told of it (FractalFitOptions::removed), the fit divides S by what the removal leaves of it in the mean, at the D fitted.
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

#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/decompositions.hpp>
#include <fstiff/profile/detrend.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/profile/tip_cutoff.hpp>
#include <fstiff/surface/structure_constant.hpp>
#include <fstiff/surface/weierstrass_mandelbrot.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fstiff {

/// A range of lags [m], both ends included.
template <Real T>
struct LagWindow {
    T from{}, to{};
};

/// Why a window begins or ends where it does.
enum class WindowEnd {
    given,       ///< by hand
    sampling,    ///< the first lag searched: shorter ones know only a few samples
    resolution,  ///< of the instrument
    tip,         ///< of the instrument, by its radius
    smooth,      ///< beyond it S grows as the square of the lag: smooth, or tilted
    saturated,   ///< beyond it S does not grow
    bend,        ///< beyond it the slope of S is another one
    length,      ///< the longest lag searched: of longer ones the profile holds too few
};

/// To follow "begins" or "ends".
template <>
inline constexpr auto names<WindowEnd> = name_list<WindowEnd>({
    {WindowEnd::given, "as given"},
    {WindowEnd::sampling, "at the first lag searched"},
    {WindowEnd::resolution, "at the resolution"},
    {WindowEnd::tip, "where the tip no longer shows"},
    {WindowEnd::smooth, "where the profile becomes smooth"},
    {WindowEnd::saturated, "where the structure function saturates"},
    {WindowEnd::bend, "where the slope changes"},
    {WindowEnd::length, "at the longest lag searched"},
});

/// In words, to follow "begins" or "ends".
[[nodiscard]] constexpr std::string_view describe(WindowEnd end) { return name_of(end); }

template <Real T>
struct FractalFitOptions {
    std::optional<LagWindow<T>> window{};  ///< automatic when not given
    StructureConvention convention = StructureConvention::exact;
    T gamma = T(1.5);  ///< of the log-periodic terms and of the constant C
    Divisor divisor = Divisor::pairs;
    std::uint64_t seed = 2014;  ///< of the bootstrap
    int resamples = 200;        ///< of the bootstrap; 0 leaves it out
    Form removed = Form::none;  ///< what detrend() took off the profile: its mark on the long lags is put right
    T tip_radius{};             ///< of the stylus [m]: lags that may show it are left out; 0: not known
    T resolution{};             ///< of the instrument [m]: shorter lags are left out; 0: not known
    ProgressHook progress{};    ///< of the bootstrap
};

/// S of one profile or the mean of several, for fit_fractal().
template <Real T>
struct MeasuredStructureFunction {
    StructureFunction<T> structure_function;  ///< at some lags, rising; `pairs` are those of one profile
    T spacing{};                              ///< [m]
    std::size_t points{};                     ///< of one profile, missing ones included
    T profiles = T(1);                        ///< independent ones that S is the mean of: their number divides the
                                              ///< variance that the model expects
    /// ln S at the steps given (rows) of resamples (columns), for the errors; may be empty. ln S in any unit.
    std::function<Eigen::Matrix<detail::Sum<T>, Eigen::Dynamic, Eigen::Dynamic>(const std::vector<std::size_t>&)>
        resample{};
};

template <Real T>
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
    T slope_least{};     ///< least local slope over the lags used
    T slope_greatest{};  ///< and greatest
    T flattest_lag{};    ///< where the local slope is least among the lags searched that are shorter than the window
                         ///< [m]; 0: there are none
    T flattest_slope{};  ///< that slope: near 0, a roughness that has saturated below the waviness of the window
    std::uint64_t seed{};
    StructureFunction<T> structure_function;  ///< all lags up to a quarter of the points, beyond the window too
};

/// D and G of \p profile, as it is: remove its form first, with detrend().
/// \throws domain_error for a profile or an option out of range, a window that holds too few lags, when no half decade
/// of lags follows a power law, or when D is not between 1 and 2.
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
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <Real T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// Half a decade of lags; a little less, because lags are whole numbers of samples.
inline constexpr double least_window_ratio = 3.1;
inline constexpr std::size_t least_window_lags = 4;

/// Number as text for an error message, four digits, whatever the locale.
template <Real T>
std::string shown(T value) {
    return rounded_text(value, 4);
}

/// Ordinary slope of y over x for the points first ... last.
template <Real T>
T slope(const Vector<T>& x, const Vector<T>& y, Eigen::Index first, Eigen::Index last) {
    const Eigen::Index count = last - first + 1;
    const auto dx = (x.segment(first, count).array() - x.segment(first, count).mean()).eval();
    return (dx * y.segment(first, count).array()).sum() / dx.square().sum();
}

/// Slope about point k, over the lags within a factor 1.5 of it and its two neighbours at least.
template <Real T>
T local_slope(const Vector<T>& x, const Vector<T>& y, Eigen::Index k) {
    const T reach = std::log(T(1.5)) * T(1.001);
    Eigen::Index first = k, last = k;
    while (first > 0 && (x[k] - x[first - 1] <= reach || first == k)) --first;
    while (last + 1 < x.size() && (x[last + 1] - x[k] <= reach || last == k)) ++last;
    return slope(x, y, first, last);
}

struct IndexRange {
    Eigen::Index first{}, last{};
};

/// Whether a range of slope \p slope stands behind a lag where S was as flat as \p flattest.
template <Real T>
bool is_behind_plateau(T flattest, T slope) {
    return flattest < T(0.2) && slope > flattest + T(0.3);
}

/// The longest straight range among the lags lower ... upper (in samples) of x = ln n, y = ln S, where the local slopes
/// may differ from that of the range by \p tolerance, before a plateau or (\p behind_plateau) behind one; see the head of
/// this file.
template <Real T>
std::optional<IndexRange> straight_range(const Vector<T>& x, const Vector<T>& y, const Vector<T>& local, T points,
                                         T lower, T upper, T tolerance, bool behind_plateau) {
    const Eigen::Index size = x.size();
    Vector<T> allowed(size);
    for (Eigen::Index k = 0; k < size; ++k)
        allowed[k] = std::max(tolerance, T(1.5) * std::sqrt(std::exp(x[k]) / points));
    const T from = std::log(lower) - T(1e-9), to = std::log(upper) + T(1e-9);
    const T least = std::log(static_cast<T>(least_window_ratio));
    std::optional<IndexRange> best;
    T best_length = 0, flattest = std::numeric_limits<T>::infinity();
    for (Eigen::Index a = 0; a < size; ++a) {
        if (x[a] < from) continue;
        flattest = std::min(flattest, local[a]);
        for (Eigen::Index b = size - 1; b > a; --b) {
            if (x[b] > to) continue;
            const T length = x[b] - x[a];
            if (length < least || length <= best_length || b - a + 1 < static_cast<Eigen::Index>(least_window_lags))
                break;
            const T mean = slope(x, y, a, b);
            const Eigen::Index count = b - a + 1;
            const auto slopes = local.segment(a, count).array();
            const bool straight = is_behind_plateau(flattest, mean) == behind_plateau && (slopes > T(0.05)).all() &&
                                  (slopes < T(1.9)).all() &&
                                  ((slopes - mean).abs() <= allowed.segment(a, count).array()).all();
            if (straight) {
                best = IndexRange{a, b};
                best_length = length;
                break;
            }
        }
    }
    return best;
}

/// Covariance of ln S at the lags \p step of a Gaussian profile of \p points whose S grows as n^\p power.
///
///     Cov(S_n, S_m) = 2/(N_n N_m) sum over pairs of Cov(increment n at i, increment m at j)^2,
///     Cov = (|d+s|^p + |d-s|^p - |d+t|^p - |d-t|^p)/2,   d distance of the centres, s = (n+m)/2, t = (n-m)/2
///
/// The sum over d takes every sample where an increment is short, and strides of an eighth of it or of d elsewhere.
template <Real T>
Matrix<T> log_covariance(const std::vector<std::size_t>& step, const std::vector<std::size_t>& pairs,
                         std::size_t points, T power) {
    std::vector<T> powers(4 * points + 4);  // of half samples
    for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = std::pow(static_cast<T>(k) / 2, power);
    const auto at = [&](std::size_t halves) { return powers[std::min(halves, powers.size() - 1)]; };
    const auto distance = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    const auto size = static_cast<Eigen::Index>(step.size());
    Matrix<T> covariance(size, size);
    for (Eigen::Index row = 0; row < size; ++row)
        for (Eigen::Index column = 0; column <= row; ++column) {
            const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
            const std::size_t n = step[i], m = step[j];  // n >= m
            const std::size_t all_n = points - n, all_m = points - m;
            const std::size_t s = n + m, t = n - m;  // halves, like every distance below
            T sum = 0;
            for (std::size_t d = s % 2; d < 2 * points;) {
                const std::size_t reach = std::max(m / 8, d > 4 * s ? d / 16 : 0);
                const std::size_t stride = std::max<std::size_t>(1, reach);  // samples
                const std::size_t centre = d + (stride - 1);                 // of the cell [d, d + 2 stride)
                const T overlap =
                    std::min(static_cast<T>(all_n), static_cast<T>(points) - static_cast<T>(s + centre) / 2);
                if (overlap <= T(0)) break;
                const T c = (at(centre + s) + at(distance(centre, s)) - at(centre + t) - at(distance(centre, t))) / 2;
                // distances count on both sides, but zero counts once
                const T count = 2 * static_cast<T>(stride) - (d == 0 ? T(1) : T(0));
                sum += count * overlap * c * c;
                d += 2 * stride;
            }
            const T missing = std::sqrt(static_cast<T>(all_n) / static_cast<T>(pairs[i]) * static_cast<T>(all_m) /
                                        static_cast<T>(pairs[j]));
            const T value = 2 * sum * missing / (static_cast<T>(all_n) * static_cast<T>(all_m) * at(2 * n) * at(2 * m));
            covariance(row, column) = covariance(column, row) = value;
        }
    return covariance;
}

/// ln of what S keeps in the mean, at the lags \p step, when the \p form of a self-affine profile whose S grows as
/// n^\p power is removed. The covariance -|i-j|^p/2 between the points of a coarse profile, without its share in the
/// polynomials; the loss goes as n^(2-p) times a smooth function of n, which is interpolated.
template <Real T>
Vector<T> log_kept(const std::vector<std::size_t>& step, std::size_t points, T power, Form form) {
    using Eigen::Index;
    Vector<T> kept = Vector<T>::Zero(static_cast<Index>(step.size()));
    if (form == Form::none || form == Form::mean) return kept;  // differences do not see the mean
    constexpr Index size = 96;
    Matrix<T> covariance(size, size), basis(size, static_cast<Index>(coefficients(form)));
    for (Index i = 0; i < size; ++i) {
        for (Index j = 0; j < size; ++j)
            covariance(i, j) = i == j ? T(0) : -std::pow(std::abs(static_cast<T>(i - j)), power) / 2;
        const T u = 2 * static_cast<T>(i) / static_cast<T>(size - 1) - 1;
        for (Index k = 0; k < basis.cols(); ++k) basis(i, k) = std::pow(u, static_cast<T>(k));
    }
    for (Index k = 0; k < basis.cols(); ++k) {  // made orthonormal, then covariance (1 - q q^T) from both sides
        for (Index other = 0; other < k; ++other) basis.col(k) -= basis.col(other).dot(basis.col(k)) * basis.col(other);
        const Vector<T> q = basis.col(k) / basis.col(k).norm();
        basis.col(k) = q;
        Vector<T> share(size);
        for (Index j = 0; j < size; ++j) share[j] = covariance.col(j).dot(q);
        share -= share.dot(q) / 2 * q;
        for (Index j = 0; j < size; ++j) covariance.col(j) -= share[j] * q + q[j] * share;
    }
    const auto loss = [&](Index m) {  // over m^(2-p)
        T sum = 0;
        for (Index i = 0; i + m < size; ++i)
            sum += covariance(i, i) + covariance(i + m, i + m) - 2 * covariance(i, i + m);
        const T lag = static_cast<T>(m);
        return (1 - sum / static_cast<T>(size - m) / std::pow(lag, power)) / std::pow(lag, 2 - power);
    };
    Vector<T> losses(size / 2);
    for (Index m = 1; m <= losses.size(); ++m) losses[m - 1] = loss(m);
    for (Index k = 0; k < kept.size(); ++k) {
        const T lag = static_cast<T>(step[static_cast<std::size_t>(k)]) * static_cast<T>(size) / static_cast<T>(points);
        const T place = std::clamp(lag, T(1), static_cast<T>(losses.size())) - 1;
        const Index below = std::min(static_cast<Index>(place), losses.size() - 2);
        const T share = place - static_cast<T>(below);
        const T lost = (losses[below] * (1 - share) + losses[below + 1] * share) * std::pow(lag, 2 - power);
        kept[k] = std::log(std::max(T(0.05), 1 - lost));
    }
    return kept;
}

/// A weighted linear fit of ln S.
template <Real T>
struct LogFit {
    Matrix<T> solver;  ///< coefficients = solver * y; row 0 gives ln S at the reference lag, row 1 the slope
    Vector<T> coefficients;
    T residual{};  ///< weighted sum of squares
    bool finite_band{}, log_periodic{};
};

/// Fits \p y over \p x = ln(n / reference) with the columns that are asked for; \p power shapes those of the finite
/// band.
template <Real T>
LogFit<T> log_fit(const Vector<T>& x, const Vector<T>& y, const Vector<T>& root_weight, T power, bool finite_band,
                  bool log_periodic, T log_gamma) {
    Matrix<T> columns(x.size(), 2 + (finite_band ? 2 : 0) + (log_periodic ? 4 : 0));
    columns.col(0).setOnes();
    columns.col(1) = x;
    Eigen::Index next = 2;
    if (finite_band) {  // each is 1 at its own end of the window
        columns.col(next++) = (-power * (x.array() - x[0])).exp();
        columns.col(next++) = ((2 - power) * (x.array() - x[x.size() - 1])).exp();
    }
    if (log_periodic)
        for (const int harmonic : {1, 2}) {
            const auto angle = (2 * static_cast<T>(harmonic) * numbers::pi_v<T> / log_gamma * x.array()).eval();
            columns.col(next++) = angle.cos();
            columns.col(next++) = angle.sin();
        }
    LogFit<T> fit;
    const Matrix<T> weighted = root_weight.asDiagonal() * columns;
    fit.solver = PivotedQr<T>(weighted).solver() * root_weight.asDiagonal();
    fit.coefficients = fit.solver.lazyProduct(y);
    fit.residual = (root_weight.array() * (y - columns.lazyProduct(fit.coefficients)).array()).square().sum();
    fit.finite_band = finite_band;
    fit.log_periodic = log_periodic;
    return fit;
}

/// ln S of moving-block resamples of the profile, one resample a column.
/// A pair belongs to the cell in which it begins; a resample is made of blocks of neighbouring cells.
template <Real T>
Matrix<T> bootstrap_log_structure(const Profile<T>& profile, const std::vector<std::size_t>& step, int resamples,
                                  std::uint64_t seed, const ProgressHook& progress) {
    constexpr std::size_t cells_wanted = 256;
    const std::vector<T>& z = profile.heights;
    const std::size_t cell = std::max<std::size_t>(1, z.size() / cells_wanted);
    const std::size_t cells = (z.size() + cell - 1) / cell;
    // twice the longest lag, so that what a block holds is nearly independent of its neighbours
    const std::size_t block = std::min(cells - 1, 2 * step.back() / cell + 1);
    const std::size_t blocks = (cells + block - 1) / block;
    std::vector<std::size_t> starts(static_cast<std::size_t>(resamples) * blocks);
    std::uint64_t state = seed;
    for (std::size_t& start : starts) start = static_cast<std::size_t>(splitmix64(state) % (cells - block + 1));

    const T scale = height_scale(profile);
    Matrix<T> resampled(static_cast<Eigen::Index>(step.size()), resamples);
    std::vector<T> sum_to(cells + 1), count_to(cells + 1);  // over all cells before this one
    for (std::size_t k = 0; k < step.size(); ++k) {
        if (progress) progress("bootstrap", k, step.size());
        const std::size_t n = step[k];
        for (std::size_t c = 0; c < cells; ++c) {
            T sum = 0, count = 0;
            const std::size_t end = std::min((c + 1) * cell, z.size() - n);
            for (std::size_t i = c * cell; i < end; ++i) {
                const T difference = (z[i + n] - z[i]) / scale;
                if (std::isnan(difference)) continue;
                sum += difference * difference;
                ++count;
            }
            sum_to[c + 1] = sum_to[c] + sum;
            count_to[c + 1] = count_to[c] + count;
        }
        const T mean = sum_to[cells] / count_to[cells];
        for (int r = 0; r < resamples; ++r) {
            T sum = 0, count = 0;
            for (std::size_t b = 0; b < blocks; ++b) {
                const std::size_t start = starts[static_cast<std::size_t>(r) * blocks + b];
                sum += sum_to[start + block] - sum_to[start];
                count += count_to[start + block] - count_to[start];
            }
            // a resample that holds nothing at this lag says nothing about it
            const T resampled_mean = count > 0 && sum > 0 ? sum / count : mean;
            resampled(static_cast<Eigen::Index>(k), r) = std::log(resampled_mean);
        }
    }
    return resampled;
}

/// Standard deviation of row * column over the columns of \p samples.
template <Real T>
T spread(const Vector<T>& row, const Matrix<T>& samples) {
    const Vector<T> values = samples.transpose().lazyProduct(row);
    const T variance =
        (values.array() - values.mean()).square().sum() / static_cast<T>(std::max<Eigen::Index>(1, values.size() - 1));
    return std::sqrt(variance);
}

inline std::vector<std::size_t> part(const std::vector<std::size_t>& all, IndexRange range) {
    return {all.begin() + range.first, all.begin() + range.last + 1};
}

}  // namespace detail

namespace detail {

template <Real T>
void check_options(const FractalFitOptions<T>& options) {
    require(options.gamma > T(1) && options.gamma <= std::numeric_limits<T>::max(), "gamma", options.gamma,
            "finite and greater than 1");
    if (options.resamples < 0 || options.resamples > 100000)
        throw domain_error("resamples = " + std::to_string(options.resamples) + ": must be between 0 and 100000");
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
FractalFit<T> fit_measured(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options,
                           T tip_length);

}  // namespace detail

template <Real T>
FractalFit<T> fit_fractal(const Profile<T>& profile, const FractalFitOptions<T>& options) {
    using F = detail::Sum<T>;
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

template <Real T>
FractalFit<T> detail::fit_measured(const MeasuredStructureFunction<T>& measured, const FractalFitOptions<T>& options,
                                   T tip_length) {
    using F = detail::Sum<T>;  // the fit of a float profile is done in double
    using Eigen::Index;
    FractalFit<T> result;
    result.structure_function = measured.structure_function;
    const StructureFunction<T>& s = result.structure_function;
    const std::size_t points = measured.points;
    const T spacing = measured.spacing, length = static_cast<T>(points - 1) * spacing;
    const WindowEnd limit = tip_length > options.resolution ? WindowEnd::tip : WindowEnd::resolution;
    result.reliable_from = std::max(tip_length, options.resolution);
    const T reliable = result.reliable_from * T(0.9999);  // a lag at the limit is in, whatever the rounding

    // x = ln n, y = ln(S/h^2): numbers without a unit; lags at which nothing differs (S = 0) have no logarithm
    std::vector<std::size_t> step, pairs;
    std::vector<F> log_value;
    for (std::size_t k = 0; k < s.size(); ++k)
        if (s.value[k] > T(0) && static_cast<T>(s.step[k]) * spacing >= reliable) {
            step.push_back(s.step[k]);
            pairs.push_back(s.pairs[k]);
            log_value.push_back(std::log(static_cast<F>(s.value[k])) - 2 * std::log(static_cast<F>(spacing)));
        }
    const auto only_reliable = [&]() -> std::string {
        if (reliable == T(0)) return "";
        return std::string("; lags below ") +
               (reliable <= length ? detail::shown(result.reliable_from) + " m" : "any of this profile") +
               " are left out for the " + (limit == WindowEnd::tip ? "tip radius" : "resolution");
    };
    if (reliable > T(0) &&
        (step.size() < detail::least_window_lags ||
         static_cast<double>(step.back()) < detail::least_window_ratio * static_cast<double>(step.front())))
        throw domain_error("window: no half decade of lags is left" + only_reliable());
    if (step.size() < detail::least_window_lags)
        throw domain_error("profile has differing heights at " + std::to_string(step.size()) +
                           " lags: must be at least " + std::to_string(detail::least_window_lags));
    detail::Vector<F> log_lag(static_cast<Index>(step.size()));
    for (Index k = 0; k < log_lag.size(); ++k) log_lag[k] = std::log(static_cast<F>(step[static_cast<std::size_t>(k)]));
    const detail::Vector<F> log_s = Eigen::Map<const detail::Vector<F>>(log_value.data(), log_lag.size());

    detail::Vector<F> local(log_lag.size());
    for (Index k = 0; k < local.size(); ++k) local[k] = detail::local_slope(log_lag, log_s, k);

    // the window
    const bool few = points < 400;
    const F shortest = few ? F(1) : F(4), farthest = static_cast<F>(few ? points / 4 : points / 10);  // searched
    detail::IndexRange range;
    result.automatic_window = !options.window;
    if (options.window) {
        const F slack = F(1e-4);
        const F from = std::log(static_cast<F>(options.window->from / spacing)) - slack;
        const F to = std::log(static_cast<F>(options.window->to / spacing)) + slack;
        range = {log_lag.size(), -1};
        for (Index k = 0; k < log_lag.size(); ++k)
            if (log_lag[k] >= from && log_lag[k] <= to) {
                range.first = std::min(range.first, k);
                range.last = k;
            }
        const auto held = range.last < range.first ? Index(0) : range.last - range.first + 1;
        if (held < static_cast<Index>(detail::least_window_lags) ||
            log_lag[range.last] - log_lag[range.first] < std::log(static_cast<F>(detail::least_window_ratio)))
            throw domain_error("window = " + detail::shown(options.window->from) + " m to " +
                               detail::shown(options.window->to) + " m: holds " + std::to_string(held) +
                               " lags; must hold at least " + std::to_string(detail::least_window_lags) +
                               " and half a decade, between " + detail::shown(spacing) + " m and " +
                               detail::shown(length) + " m" + only_reliable());
    } else {
        struct Choice {
            F tolerance;
            bool behind_plateau;
        };
        std::optional<detail::IndexRange> straight;
        for (const Choice choice :
             {Choice{F(0.2), false}, Choice{F(0.2), true}, Choice{F(0.3), false}, Choice{F(0.45), false},
              Choice{F(0.6), false}, Choice{F(0.3), true}, Choice{F(0.45), true}, Choice{F(0.6), true}}) {
            straight = detail::straight_range(log_lag, log_s, local, static_cast<F>(points), shortest, farthest,
                                              choice.tolerance, choice.behind_plateau);
            result.slope_tolerance = static_cast<T>(choice.tolerance);
            result.behind_plateau = choice.behind_plateau;
            if (straight) break;
        }
        if (!straight)
            throw domain_error(
                "window = automatic: no half decade of lags follows a power law (local slope of ln S " +
                detail::shown(detail::local_slope(log_lag, log_s, 0)) + " at the shortest and " +
                detail::shown(detail::local_slope(log_lag, log_s, log_lag.size() - 1)) +
                " at the longest lag); must be a profile whose slope stays between 0.05 and 1.9, without tilt, "
                "or a window given by hand" +
                only_reliable());
        range = *straight;
    }
    const Index count = range.last - range.first + 1;
    const std::vector<std::size_t> used_step = detail::part(step, range), used_pairs = detail::part(pairs, range);
    result.window = {static_cast<T>(used_step.front()) * spacing, static_cast<T>(used_step.back()) * spacing};
    result.lags = static_cast<std::size_t>(count);
    result.slope_shortest = static_cast<T>(local[range.first]);
    result.slope_longest = static_cast<T>(local[range.last]);
    result.slope_least = result.slope_greatest = result.slope_shortest;
    for (Index k = 0; k <= range.last; ++k) {
        const T here = static_cast<T>(local[k]);
        if (k >= range.first) {
            result.slope_least = std::min(result.slope_least, here);
            result.slope_greatest = std::max(result.slope_greatest, here);
        } else if (log_lag[k] >= std::log(shortest) && (result.flattest_lag == T(0) || here < result.flattest_slope)) {
            result.flattest_lag = static_cast<T>(step[static_cast<std::size_t>(k)]) * spacing;
            result.flattest_slope = here;
        }
    }

    // why there
    const auto beyond = [&](Index next, F searched_from, F searched_to, WindowEnd outermost) {
        if (next < 0 || next >= local.size()) return outermost;
        const F lag = std::exp(log_lag[next]) * F(1 + 1e-9);
        if (lag < searched_from || lag > searched_to * F(1 + 1e-8)) return outermost;
        if (local[next] > F(1.8) && local[next] > local[next < range.first ? range.first : range.last])
            return WindowEnd::smooth;
        return local[next] < F(0.2) ? WindowEnd::saturated : WindowEnd::bend;
    };
    const bool limited = reliable > T(0) && range.first == 0;
    result.begins = limited ? limit
                            : (options.window ? WindowEnd::given
                                              : beyond(range.first - 1, shortest, farthest, WindowEnd::sampling));
    result.ends = options.window ? WindowEnd::given : beyond(range.last + 1, shortest, farthest, WindowEnd::length);

    // the fit, about the middle of the window
    const F log_reference = (log_lag[range.first] + log_lag[range.last]) / 2;
    const detail::Vector<F> x = log_lag.segment(range.first, count).array() - log_reference;
    const detail::Vector<F> measured_y = log_s.segment(range.first, count);
    detail::Vector<F> y = measured_y;
    const detail::Vector<F> ones = detail::Vector<F>::Ones(count);
    const detail::Vector<F> root_weight =
        (log_lag.segment(range.first, count).array().exp() / static_cast<F>(points) + F(0.0009)).rsqrt();
    const F log_gamma = std::log(static_cast<F>(options.gamma));
    const F width = x[count - 1] - x[0];

    const detail::LogFit<F> ordinary = detail::log_fit(x, y, ones, F(1), false, false, log_gamma);
    result.line_dimension = static_cast<T>(2 - ordinary.coefficients[1] / 2);
    result.regression_dimension_error = static_cast<T>(
        std::sqrt(ordinary.residual / static_cast<F>(count - 2) / (x.array() - x.mean()).square().sum()) / 2);

    const auto fit_at = [&](F power, bool band, bool waves) {
        return detail::log_fit(x, y, root_weight, power, band, waves, log_gamma);
    };
    // the columns of the finite band depend on the slope: repeat until it stays
    const auto settled_fit = [&](bool band, bool waves) -> std::optional<detail::LogFit<F>> {
        F power = std::clamp(ordinary.coefficients[1], F(0.1), F(1.9));
        detail::LogFit<F> fit = fit_at(power, band, waves);
        if (!band) return fit;
        for (int round = 0; round < 50; ++round) {
            const F next = fit.coefficients[1];
            if (!(next > F(0.02) && next < F(1.98))) return std::nullopt;
            const bool settled = std::abs(next - power) < F(1e-10);
            power = next;
            fit = fit_at(power, band, waves);
            // a correction, not the main thing: at its own end of the window each term stays below the power law
            if (settled)
                return std::abs(fit.coefficients[2]) < F(1) && std::abs(fit.coefficients[3]) < F(1) ? std::optional(fit)
                                                                                                    : std::nullopt;
        }
        return std::nullopt;
    };
    const auto with_waves = [&](bool band) {
        auto fit = settled_fit(band, false);
        const bool room = width > 2 * log_gamma && count >= 12;
        if (fit && room)
            if (auto waves = settled_fit(band, true); waves && waves->residual < fit->residual / 2) fit = waves;
        return fit;
    };
    const auto kept = [&](F at_power) {
        return detail::log_kept<F>(used_step, points, std::clamp(at_power, F(0.02), F(1.98)), options.removed);
    };
    std::optional<detail::LogFit<F>> chosen;
    const bool formless = options.removed == Form::none || options.removed == Form::mean;
    F shaped_by = ordinary.coefficients[1];
    for (int round = 0; round < (formless ? 1 : 6); ++round) {
        y = measured_y - kept(shaped_by);
        chosen.reset();
        if (width > std::log(F(100)) * F(0.999)) chosen = with_waves(true);
        if (!chosen) chosen = with_waves(false);
        shaped_by = chosen->coefficients[1];
    }
    const detail::LogFit<F>& fit = *chosen;
    result.finite_band = fit.finite_band;
    result.log_periodic = fit.log_periodic;
    const F power = fit.coefficients[1], dimension = 2 - power / 2;
    require(dimension > F(1) && dimension < F(2), "fractal dimension of the window", dimension,
            "between 1 and 2, both excluded: this window holds no fractal profile");

    // how D and ln C move with the data: directly, and through the columns, which move with D
    detail::Vector<F> dimension_row = -fit.solver.row(1).transpose() / 2, level_row = fit.solver.row(0).transpose();
    if (fit.finite_band) {
        const F small = F(1e-4);
        const detail::LogFit<F> up = fit_at(power + small, true, fit.log_periodic);
        const detail::LogFit<F> down = fit_at(power - small, true, fit.log_periodic);
        const F feedback = (up.coefficients[1] - down.coefficients[1]) / (2 * small);
        const F level_feedback = (up.coefficients[0] - down.coefficients[0]) / (2 * small);
        dimension_row /= 1 - std::min(feedback, F(0.9));
        level_row += -2 * level_feedback * dimension_row;
    }
    if (!formless) {  // so does what the form is taken to have left
        const F small = F(1e-3);
        const detail::Vector<F> change = (kept(power + small) - kept(power - small)) / (2 * small);
        const F feedback = 2 * dimension_row.dot(change);  // of D on itself: d power = -2 dD
        dimension_row /= std::max(F(0.3), 1 - feedback);
        level_row += 2 * level_row.dot(change) * dimension_row;
    }
    // ln(G/reference lag) of D and ln(S/lag^2) at the reference lag
    const F level = fit.coefficients[0] - 2 * log_reference;
    const auto log_g = [&](F d) {
        return (level - std::log(structure_constant<F>(d, options.convention, static_cast<F>(options.gamma)))) /
               (2 * (d - 1));
    };
    const F nearby = F(1e-4) * std::min(dimension - 1, 2 - dimension);
    const F log_g_slope = (log_g(dimension + nearby) - log_g(dimension - nearby)) / (2 * nearby);
    const detail::Vector<F> roughness_row = level_row / (2 * (dimension - 1)) + log_g_slope * dimension_row;

    const detail::Matrix<F> covariance =
        detail::log_covariance(used_step, used_pairs, points, power) / static_cast<F>(measured.profiles);
    const auto from_model = [&](const detail::Vector<F>& row) {
        return std::sqrt(std::max(F(0), row.dot(covariance.lazyProduct(row))));
    };
    F dimension_error = from_model(dimension_row), roughness_error = from_model(roughness_row);
    result.model_dimension_error = static_cast<T>(dimension_error);
    if (measured.resample) {
        const detail::Matrix<F> resampled = measured.resample(used_step);
        if (resampled.rows() != count || resampled.cols() < 2 || !resampled.allFinite())
            throw domain_error(
                "resamples of the structure function: must be finite, a row for every lag asked for, two "
                "columns or more");
        const F bootstrap = detail::spread(dimension_row, resampled);
        result.bootstrap_dimension_error = static_cast<T>(bootstrap);
        dimension_error = std::max(dimension_error, bootstrap);
        roughness_error = std::max(roughness_error, detail::spread(roughness_row, resampled));
    }

    // curvature: the quadratic and the cubic term of ln S, each against its own sampling error
    const auto highest_row = [&](Index degree) -> detail::Vector<F> {
        detail::Matrix<F> powers(count, degree + 1);
        for (Index k = 0; k <= degree; ++k) powers.col(k) = x.array().pow(static_cast<F>(k)).matrix();
        return PivotedQr<F>(powers).solver().row(degree).transpose();
    };
    const auto bends = [&](const detail::Vector<F>& row, F change_of_slope) {  // that one of the term gives
        const F bend = std::abs(row.dot(y));
        return bend * change_of_slope > F(0.2) && bend > 3 * from_model(row);
    };
    result.curved = bends(highest_row(2), 2 * width) || bends(highest_row(3), 3 * width * width / 4) ||
                    result.slope_tolerance > T(0.21);

    result.fractal.dimension = static_cast<T>(dimension);
    const F roughness = std::exp(log_g(dimension) + log_reference) * static_cast<F>(spacing);
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
    return result;
}

}  // namespace fstiff
