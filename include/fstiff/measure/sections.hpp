// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sections of a map: profiles along x and along y, D and G of each direction, and a test whether the two differ.
///
///     S_x(n dx) = mean of (z(j, i+n) - z(j, i))^2 over all rows j and all i that exist           and S_y likewise
///
/// One mean structure function of second differences per direction is fitted. A map is anisotropic when D along x and
/// y, over the lags of both windows, differ by more than 3 standard errors and 0.05, or the mean of ln S_x - ln S_y
/// differs from 0 by more than 3 standard errors and 0.1. Errors: docs/theory-surface.md.
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.3)-(2.8)
/// Units       lengths, G [m], S [m^2]
/// Valid       maps of at least 16 points a side; remove the form first, at least a plane, with level()
/// Accuracy    S 1e-13. D of self-affine maps of 256 x 256 points, H = 0.3 to 0.8: 2 - H within 0.06 in the mean (ends
///             of the spectrum); sampling errors are 0.6 to 1.1 times the scatter; 1 of 240 isotropic maps of 128 x 128
///             points is called anisotropic (tests/measure/sections_test.cpp)

#include <fstiff/math/random.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/topography/form.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Direction of a section: along a row, or along a column.
enum class Direction { x, y };

/// Profile along x in row \p place, or along y in column \p place. \throws domain_error unless the map has it.
template <Real T>
[[nodiscard]] Profile<T> section(const HeightMap<T>& map, Direction direction, Eigen::Index place);

/// Options of the error of a mean structure function.
struct SectionResampling {
    int resamples = 200;        ///< of the rows; 0 leaves the bootstrap out
    std::uint64_t seed = 2014;  ///< of the bootstrap
    ProgressHook progress{};    ///< of the bootstrap
};

/// Mean structure function of all sections of \p map along \p direction, at logarithmic_lags up to a quarter of their
/// points, for fit_fractal().
/// \throws domain_error for a map or an option out of range.
template <Real T>
[[nodiscard]] MeasuredStructureFunction<T> section_structure(const HeightMap<T>& map, Direction direction,
                                                             const SectionResampling& resampling = {});

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// D and G along x and along y. A direction without a fit has the reason instead.
template <Real T = double>
struct DirectionalFit {
    std::optional<FractalFit<T>> x, y;
    std::string why_no_fit_x, why_no_fit_y;  ///< empty when there is one
    T dimension_difference{};        ///< D along x less D along y, over the lags of both windows; 0 unless both exist
    T dimension_difference_error{};  ///< its standard deviation
    LengthRange<T> common;           ///< lags at which S is compared [m]; 0 to 0: both directions share too few
    T log_level_difference{};        ///< mean of ln S_x - ln S_y over them
    T log_level_difference_error{};  ///< its standard deviation
    bool dimension_differs{};
    bool level_differs{};

    [[nodiscard]] bool anisotropic() const { return dimension_differs || level_differs; }
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Mean structure functions of the sections of one map, with its sides.
template <Real T = double>
struct SectionStructures {
    MeasuredStructureFunction<T> x, y;
    T side{};  ///< the shorter one [m]
};

/// Resamples, seed and progress of \p options are those of the rows. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] SectionStructures<T> section_structures(const HeightMap<T>& map, const FractalFitOptions<T>& options,
                                                      const ParallelHook& parallel = {});

/// Fits both directions of \p sections. A window or a resolution applies to both.
/// \throws domain_error for an option out of range; a tip radius is refused, because the lags that the tip changed need
/// the heights of one profile: give the resolution.
template <Real T>
[[nodiscard]] DirectionalFit<T> fit_directions(const SectionStructures<T>& sections,
                                               const FractalFitOptions<T>& options);
/// Same as above of \p map.
template <Real T>
[[nodiscard]] DirectionalFit<T> fit_directions(const HeightMap<T>& map, const FractalFitOptions<T>& options = {}) {
    return fit_directions(section_structures(map, options), options);
}
/// \p options for \p levelled: lags above lambda_c are not roughness.
template <Real T>
[[nodiscard]] FractalFitOptions<T> fit_options(const LevelledMap<T>& levelled, FractalFitOptions<T> options) {
    if (levelled.lambda_c > T(0) && !(options.longest > T(0) && options.longest < levelled.lambda_c))
        options.longest = levelled.lambda_c;
    return options;
}
/// Same as fit_directions() for a map whose form and cut-offs are known.
template <Real T>
[[nodiscard]] DirectionalFit<T> fit_directions(const LevelledMap<T>& levelled,
                                               const FractalFitOptions<T>& options = {}) {
    return fit_directions(levelled.of_structure(), fit_options(levelled, options));
}

/// Sums of squared differences, or second differences, and their numbers, for every section (rows) and lag (columns).
template <Real F>
struct SectionSums {
    std::vector<std::size_t> step;
    Matrix<F> sum, pairs;
};

/// Distance of the sections used at the lag \p n; sections closer together contain the same waves.
constexpr Eigen::Index rows_apart(Eigen::Index n) { return std::max<Eigen::Index>(1, n / 16); }

template <Real T>
SectionSums<double> section_sums(const HeightMap<T>& map, Direction direction, bool second, double unit) {
    using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const bool x = direction == Direction::x;
    const Eigen::Index sections = x ? map.rows() : map.columns(), points = x ? map.columns() : map.rows();
    SectionSums<double> sums;
    sums.step = logarithmic_lags(static_cast<std::size_t>(points) / 4);
    const auto lags = static_cast<Eigen::Index>(sums.step.size());
    sums.sum.resize(sections, lags);
    sums.pairs.resize(sections, lags);
    constexpr Eigen::Index together = 16;  // columns are fetched by so many, which share lines of the cache
    Rows z;
    Eigen::Array<double, 1, Eigen::Dynamic> squares;
    sums.sum.setZero();
    sums.pairs.setZero();
    for (Eigen::Index j = 0; j < sections; ++j) {
        const Eigen::Index place = j % together, many = (std::min)(together, sections - j);
        if (place == 0 && x) z = map.heights.middleRows(j, many).template cast<double>() / unit;
        if (place == 0 && !x) z = map.heights.middleCols(j, many).transpose().template cast<double>() / unit;
        const bool complete = !z.row(place).isNaN().any();
        for (Eigen::Index k = 0; k < lags; ++k) {
            const auto n = static_cast<Eigen::Index>(sums.step[static_cast<std::size_t>(k)]);
            if (j % rows_apart(n) != 0) continue;
            const Eigen::Index count = points - (second ? 2 * n : n);
            const auto add = [&](const auto& square) {
                if (complete) {
                    sums.pairs(j, k) = static_cast<double>(count);
                    sums.sum(j, k) = square.sum();
                } else {
                    squares = square;
                    sums.pairs(j, k) = static_cast<double>(count - squares.isNaN().count());
                    sums.sum(j, k) = squares.isNaN().select(0.0, squares).sum();
                }
            };
            const auto row = z.row(place);
            if (second)
                add((row.tail(count) - 2 * row.segment(n, count) + row.head(count)).square());
            else
                add((row.tail(count) - row.head(count)).square());
        }
    }
    return sums;
}

/// ln of the means of S over resamples of the sections: steps by rows, resamples by columns.
template <Real F>
Matrix<F> resample_sections(const SectionSums<F>& sums, const std::vector<std::size_t>& steps, std::size_t block,
                            const SectionResampling& resampling) {
    const auto sections = static_cast<std::size_t>(sums.sum.rows());
    block = std::clamp<std::size_t>(block, 1, std::max<std::size_t>(1, sections / 4));
    math::BlockBootstrap<F> bootstrap(sections, block, static_cast<std::size_t>(resampling.resamples), resampling.seed);
    Matrix<F> resampled(static_cast<Eigen::Index>(steps.size()), resampling.resamples);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (resampling.progress) resampling.progress("bootstrap", k, steps.size());
        const auto lag = std::find(sums.step.begin(), sums.step.end(), steps[k]) - sums.step.begin();
        const std::vector<F>& means = bootstrap.means([&](std::size_t j) {
            const auto row = static_cast<Eigen::Index>(j);
            return std::pair{sums.sum(row, lag), sums.pairs(row, lag)};
        });
        resampled.row(static_cast<Eigen::Index>(k)) =
            Eigen::Map<const Vector<F>>(means.data(), resampled.cols()).transpose().array().log();
    }
    return resampled;
}

/// Fits into \p fit; returns the reason where no fit is possible, else an empty string.
template <class Fit, class Call>
std::string fit_or_reason(std::optional<Fit>& fit, const Call& call) {
    try {
        fit = call();
        return {};
    } catch (const domain_error& error) {
        return error.what();
    }
}

/// Mean of ln S over the lags from ... to, and its standard deviation, the larger of bootstrap and model.
template <Real F>
struct LogLevel {
    F mean{}, error{};
};

template <Real T>
LogLevel<double> log_level(const MeasuredStructureFunction<T>& measured, const LengthRange<T>& window) {
    const StructureFunction<T>& s = measured.second_differences;
    // trapezoids over ln(lag), at 24 points of the window that both directions share
    constexpr int points = 24;
    std::vector<double> weight(s.size(), 0.0);
    const double from = std::log(static_cast<double>(window.from)), to = std::log(static_cast<double>(window.to));
    for (int p = 0; p < points; ++p) {
        const double log_lag = from + (to - from) * static_cast<double>(p) / static_cast<double>(points - 1);
        std::size_t k = 1;
        while (k + 1 < s.size() && std::log(static_cast<double>(s.lag[k])) < log_lag) ++k;
        const double below = std::log(static_cast<double>(s.lag[k - 1])),
                     above = std::log(static_cast<double>(s.lag[k]));
        const double share = std::clamp((log_lag - below) / (above - below), 0.0, 1.0);
        weight[k - 1] += (1 - share) / static_cast<double>(points);
        weight[k] += share / static_cast<double>(points);
    }
    LogStructure<double> log;
    log.points = measured.points;
    log.profiles = static_cast<double>(measured.profiles);
    log.apart = static_cast<double>(measured.apart);
    std::vector<double> used, log_lag, log_s;
    LogLevel<double> level;
    for (std::size_t k = 0; k < s.size(); ++k) {
        if (weight[k] == 0.0) continue;
        log.step.push_back(s.step[k]);
        log.pairs.push_back(s.pairs[k]);
        used.push_back(weight[k]);
        log_lag.push_back(std::log(static_cast<double>(s.step[k])));
        log_s.push_back(std::log(static_cast<double>(s.value[k])));
        level.mean += weight[k] * log_s.back();
    }
    const auto size = static_cast<Eigen::Index>(log.step.size());
    const Vector<double> row = Eigen::Map<const Vector<double>>(used.data(), size);
    log.lag = Eigen::Map<const Vector<double>>(log_lag.data(), size);
    const Vector<double> y = Eigen::Map<const Vector<double>>(log_s.data(), size);
    level.error = expected_spread(row, covariance_of(log, regression_slope(log.lag, y.data(), 0, size - 1)));
    if (measured.resample)
        level.error = (std::max)(level.error, sample_spread(row, Matrix<double>(measured.resample(log.step))));
    return level;
}

template <Real T>
Profile<T> section(const HeightMap<T>& map, Direction direction, Eigen::Index place) {
    const bool x = direction == Direction::x;
    const Eigen::Index sections = x ? map.rows() : map.columns();
    if (place < 0 || place >= sections)
        refuse(x ? "row" : "column", place, "between 0 and " + std::to_string(sections - 1));
    const auto values = [](const auto& line) { return std::vector<T>(line.begin(), line.end()); };
    return x ? Profile<T>{values(map.heights.row(place)), map.dx} : Profile<T>{values(map.heights.col(place)), map.dy};
}

template <Real T>
MeasuredStructureFunction<T> section_structure(const HeightMap<T>& map, Direction direction,
                                               const SectionResampling& resampling) {
    map.validate(16);
    require(resampling.resamples >= 0 && resampling.resamples <= 100000, "resamples", resampling.resamples,
            "between 0 and 100000");
    const bool x = direction == Direction::x;
    const double unit = 4 * static_cast<double>(height_scale(map));  // the differences are at most 1
    const SectionSums<double> first = section_sums(map, direction, false, unit);
    SectionSums<double> sums = section_sums(map, direction, true, unit);

    MeasuredStructureFunction<T> measured;
    measured.spacing = x ? map.dx : map.dy;
    measured.rms_height = rms_height(map);
    measured.points = static_cast<std::size_t>(x ? map.columns() : map.rows());
    const auto sections = static_cast<double>(sums.sum.rows());
    const auto means = [&](StructureFunction<T>& s, const SectionSums<double>& totals) {
        for (std::size_t k = 0; k < totals.step.size(); ++k) {
            const auto lag = static_cast<Eigen::Index>(k);
            const double pairs = totals.pairs.col(lag).sum(), sum = totals.sum.col(lag).sum();
            if (pairs == 0.0) continue;
            const T value = mean_square<T>(sum, pairs, unit);
            s.step.push_back(totals.step[k]);
            s.lag.push_back(static_cast<T>(totals.step[k]) * measured.spacing);
            s.value.push_back(value);
            const auto apart = static_cast<double>(rows_apart(static_cast<Eigen::Index>(totals.step[k])));
            const double used = std::ceil(sections / apart);
            s.pairs.push_back(std::max<std::size_t>(1, static_cast<std::size_t>(pairs / used + 0.5)));
        }
    };
    means(measured.structure_function, first);
    means(measured.second_differences, sums);
    const double apart =
        static_cast<double>(x ? map.dy : map.dx) / static_cast<double>(measured.spacing);  // rows, in samples
    measured.profiles = static_cast<T>(sections);
    measured.apart = static_cast<T>(apart);
    if (resampling.resamples > 1)
        measured.resample = [sums = std::move(sums), resampling, apart](const std::vector<std::size_t>& steps) {
            const double reach = 4 * static_cast<double>(*std::max_element(steps.begin(), steps.end())) / apart;
            const auto block = static_cast<std::size_t>((std::min)(reach, static_cast<double>(sums.sum.rows()))) + 1;
            return resample_sections(sums, steps, block, resampling);
        };
    return measured;
}

template <Real T>
SectionStructures<T> section_structures(const HeightMap<T>& map, const FractalFitOptions<T>& options,
                                        const ParallelHook& parallel) {
    map.validate(16);
    const SectionResampling resampling{options.resamples, options.seed, options.progress};
    SectionStructures<T> sections;
    sections.side = (std::min)(static_cast<T>(map.columns()) * map.dx, static_cast<T>(map.rows()) * map.dy);
    run_pieces(parallel, 2, [&](std::size_t i) {
        (i == 0 ? sections.x : sections.y) = section_structure(map, i == 0 ? Direction::x : Direction::y, resampling);
    });
    return sections;
}

template <Real T>
DirectionalFit<T> fit_directions(const SectionStructures<T>& sections, const FractalFitOptions<T>& options) {
    require(options.tip_radius == T(0), "tip radius", options.tip_radius, "left out for a map: give the resolution");
    const auto &along_x = sections.x, &along_y = sections.y;
    DirectionalFit<T> result;
    const auto fit = [&](std::optional<FractalFit<T>>& into, const MeasuredStructureFunction<T>& measured,
                         const FractalFitOptions<T>& settings) {
        std::string reason = fit_or_reason(into, [&] { return fit_fractal(measured, settings); });
        if (into) into->seed = options.seed;
        return reason;
    };
    result.why_no_fit_x = fit(result.x, along_x, options);
    result.why_no_fit_y = fit(result.y, along_y, options);
    if (result.x && result.y) {
        // over the lags of both windows: a curved S has another slope in another window
        FractalFitOptions<T> common = options;
        const std::vector<T>&lags_x = along_x.second_differences.lag, &lags_y = along_y.second_differences.lag;
        common.window = LengthRange<T>{
            (std::max)({(std::min)(result.x->window.from, result.y->window.from), lags_x.front(), lags_y.front()}),
            (std::min)({(std::max)(result.x->window.to, result.y->window.to), lags_x.back(), lags_y.back()})};
        std::optional<FractalFit<T>> x, y;
        (void)fit(x, along_x, common);
        (void)fit(y, along_y, common);
        if (!x || !y) x = result.x, y = result.y;  // where the spacings are so different that no such window exists
        result.dimension_difference = x->fractal.dimension - y->fractal.dimension;
        result.dimension_difference_error = std::hypot(x->dimension_error, y->dimension_error);
        const T difference = std::abs(result.dimension_difference);
        result.dimension_differs = difference > 3 * result.dimension_difference_error && difference > T(0.05);
    }
    const LengthRange<T> common{4 * (std::max)(along_x.spacing, along_y.spacing), sections.side / 10};
    const auto varies = [](const MeasuredStructureFunction<T>& m) {
        const std::vector<T>& s = m.second_differences.value;
        return s.size() >= 4 && std::all_of(s.begin(), s.end(), [](T value) { return value > T(0); });
    };
    if (common.from < common.to && varies(along_x) && varies(along_y)) {
        result.common = common;
        const auto x = log_level(along_x, common), y = log_level(along_y, common);
        result.log_level_difference = static_cast<T>(x.mean - y.mean);
        result.log_level_difference_error = static_cast<T>(std::hypot(x.error, y.error));
        const T difference = std::abs(result.log_level_difference);
        result.level_differs = difference > 3 * result.log_level_difference_error && difference > T(0.1);
    }
    return result;
}

}}}  // namespace fstiff::detail
