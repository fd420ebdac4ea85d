// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Window of lags over which the structure function S2 of second differences is a power law: automatic, or given.
///
/// An automatic window is the longest range, at least half a decade, over which the local slope of ln S2 differs from
/// the slope of the range by at most 0.2, or by twice its sampling error; 0.3 and then 0.45 where no range satisfies
/// that. The slope is between 0.2 and 1.95. The search uses lags from 4 samples to a tenth of the points that
/// resolution, lambda_s and tip (profile/structure_function) allow, up to three quarters of the saturation of S2. A
/// range after a plateau (a shorter lag with a slope below 0.2 and 0.3 less than the range) is the last choice.
///
/// Units       lags [m]; inside, in samples
/// Valid       at least 4 lags at which S2 > 0
/// Accuracy    ends of pieces of a power law (tests/profile/lag_window_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/decompositions.hpp>
#include <fstiff/profile/structure_function.hpp>

#include <Eigen/Core>

namespace fstiff { inline namespace v0_1 {

/// Reason for the beginning or the end of a window.
enum class WindowEnd {
    given,       ///< by hand
    sampling,    ///< the first lag searched: shorter ones have only a few samples
    resolution,  ///< of the instrument
    lambda_s,    ///< the cut-off of the filter of the short waves
    tip,         ///< of the instrument, by its radius
    smooth,      ///< beyond it S2 grows as the square of the lag or faster: no roughness at this scale
    saturated,   ///< beyond it S2 does not grow
    bend,        ///< beyond it the slope of S2 is another one
    length,      ///< the longest lag searched: the profile has too few longer ones
};

/// Short name, to follow "begins" or "ends".
template <>
inline constexpr auto enum_names<WindowEnd> = detail::name_list<WindowEnd>({
    {WindowEnd::given, "as given"},
    {WindowEnd::sampling, "at the first lag searched"},
    {WindowEnd::resolution, "at the resolution"},
    {WindowEnd::lambda_s, "at lambda_s"},
    {WindowEnd::tip, "where the tip no longer shows"},
    {WindowEnd::smooth, "where the profile becomes smooth"},
    {WindowEnd::saturated, "where the structure function saturates"},
    {WindowEnd::bend, "where the slope changes"},
    {WindowEnd::length, "at the longest lag searched"},
});

namespace detail {

/// Description in words, to follow "begins" or "ends".
[[nodiscard]] constexpr std::string_view describe(WindowEnd end) { return name_of(end); }

template <Real T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <Real T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// Half a decade of lags; slightly less, because lags are whole numbers of samples.
inline constexpr double min_window_ratio = 3.1;
inline constexpr std::size_t min_window_lags = 4;

/// Lower limit of the lags: those below \p from are not used.
template <Real T>
struct ReliableLags {
    T from{};           // [m]; 0: all are used
    WindowEnd limit{};  // what sets it: the tip, the resolution or lambda_s

    /// A lag at the limit is in, whatever the rounding.
    bool holds(T lag) const { return lag >= from * T(0.9999); }
    /// End of the error message for a profile of length \p length [m].
    std::string note(T length) const {
        if (from == T(0)) return "";
        return "; lags below " + (from * T(0.9999) <= length ? rounded_text(from, 4) + " m" : "any of this profile") +
               " are left out for " +
               (limit == WindowEnd::tip        ? "the tip radius"
                : limit == WindowEnd::lambda_s ? "lambda_s"
                                               : "the resolution");
    }
};

/// Ordinary slope of y over x for the points first ... last.
template <Real T>
T regression_slope(const Vector<T>& x, const T* y, Eigen::Index first, Eigen::Index last) {
    const Eigen::Index count = last - first + 1;
    const T mean = math::sum_in_lanes(&x[first], count) / static_cast<T>(count);
    const Vector<T> dx = math::vector_of<T>(count, [&](Eigen::Index i) { return x[first + i] - mean; });
    return math::dot_in_lanes(dx.data(), y + first, count) / math::dot_in_lanes(dx.data(), dx.data(), count);
}

/// Slope about point k, over the lags within a factor 1.84 of it and at least its two neighbours.
template <Real T>
T local_slope(const Vector<T>& x, const T* y, Eigen::Index k) {
    const T reach = std::log(T(1.84)) * T(1.001);
    Eigen::Index first = k, last = k;
    while (first > 0 && (x[k] - x[first - 1] <= reach || first == k)) --first;
    while (last + 1 < x.size() && (x[last + 1] - x[k] <= reach || last == k)) ++last;
    return regression_slope(x, y, first, last);
}

/// ln S2 over ln n at the lags that are used, without units.
template <Real F>
struct LogStructure {
    std::vector<std::size_t> step, pairs;
    Vector<F> lag, value, slope;  // ln n, ln(S2/h^2), local slope
    Vector<F> slope_error;        // of the local slopes by sampling, one standard deviation; empty: none
    std::size_t points{};         // of one profile
    F saturated = std::numeric_limits<F>::infinity();  // ln of what S2/h^2 ends at; infinite: not known
    F profiles = 1, apart = 0;                         // how many, and samples between neighbours; 0: nothing in common

    /// Number of independent profiles at the lag \p n: neighbours closer than half the lag contain the same waves.
    F independent(F n) const { return apart > 0 ? std::clamp(2 * profiles * apart / n, F(1), profiles) : profiles; }

    /// Lags of the search for a window, in samples.
    F shortest() const { return points < 400 ? F(1) : F(4); }
    F longest() const {
        const auto steps = points / (apart > 0 ? 5u : points < 400 ? 8u : 10u);
        return static_cast<F>(steps);
    }
    /// Upper limit of ln S2 in a window: three quarters of its saturation, allowing for 5 % of scatter.
    F highest() const {
        return (std::min)(*std::max_element(value.data(), value.data() + value.size()), saturated) + F(0.05) - F(0.3);
    }
};

/// Omits lags at which nothing differs (S2 = 0), which have no logarithm, and unreliable lags.
template <Real T>
LogStructure<double> log_structure(const StructureFunction<T>& s, T spacing, std::size_t points,
                                   const ReliableLags<T>& reliable) {
    LogStructure<double> log;
    log.points = points;
    std::vector<double> value;
    for (std::size_t k = 0; k < s.size(); ++k) {
        if (!(s.value[k] > T(0) && reliable.holds(static_cast<T>(s.step[k]) * spacing))) continue;
        log.step.push_back(s.step[k]);
        log.pairs.push_back(s.pairs[k]);
        value.push_back(std::log(static_cast<double>(s.value[k])) - 2 * std::log(static_cast<double>(spacing)));
    }
    const bool limited = reliable.from > T(0);
    if (limited && (log.step.size() < min_window_lags ||
                    static_cast<double>(log.step.back()) < min_window_ratio * static_cast<double>(log.step.front())))
        throw domain_error(
            {.parameter = "window",
             .reason = "no half decade of lags is left" + reliable.note(static_cast<T>(points - 1) * spacing)});
    if (log.step.size() < min_window_lags)
        throw domain_error("profile has differing heights at " + std::to_string(log.step.size()) +
                           " lags: must be at least " + std::to_string(min_window_lags));
    const auto of_lags = [&](const auto& number) {
        return math::vector_of<double>(static_cast<Eigen::Index>(value.size()), number);
    };
    const auto place = [](Eigen::Index k) { return static_cast<std::size_t>(k); };
    log.lag = of_lags([&](Eigen::Index k) { return std::log(static_cast<double>(log.step[place(k)])); });
    log.value = of_lags([&](Eigen::Index k) { return value[place(k)]; });
    log.slope = of_lags([&](Eigen::Index k) { return local_slope(log.lag, log.value.data(), k); });
    return log;
}

struct IndexRange {
    Eigen::Index first{}, last{};

    Eigen::Index count() const { return last - first + 1; }
};

/// Whether a range of slope \p slope follows a plateau, a lag where the slope of S was \p flattest.
template <Real T>
bool is_after_plateau(T flattest, T slope) {
    return flattest < T(0.2) && slope > flattest + T(0.3);
}

/// Longest straight range among the lags \p within of the search, where the local slopes may differ from that of the
/// range by \p tolerance, before a plateau or (\p after_plateau) after one.
template <Real T>
std::optional<IndexRange> straight_range(const LogStructure<T>& log, T tolerance, bool after_plateau,
                                         const IndexRange& within) {
    const Vector<T>&x = log.lag, &y = log.value, &local = log.slope;
    const Eigen::Index size = x.size();
    const bool scatters = log.slope_error.size() == size;
    const Vector<T> scatter =
        math::vector_of<T>(size, [&](Eigen::Index k) { return scatters ? 2 * log.slope_error[k] : T(0); });
    const T from = std::log(log.shortest()) - T(1e-9), to = std::log(log.longest()) + T(1e-9);
    const T least = std::log(static_cast<T>(min_window_ratio)), min_slope = T(0.2), max_slope = T(1.95),
            highest = log.highest();
    std::optional<IndexRange> best;
    T best_length = 0, flattest = std::numeric_limits<T>::infinity();
    for (Eigen::Index a = 0; a <= within.last; ++a) {
        if (x[a] < from) continue;
        flattest = (std::min)(flattest, local[a]);
        if (a < within.first) continue;
        for (Eigen::Index b = within.last; b > a; --b) {
            if (x[b] > to) continue;
            const T length = x[b] - x[a];
            if (length < least || length <= best_length || b - a + 1 < static_cast<Eigen::Index>(min_window_lags))
                break;
            const T mean = regression_slope(x, y.data(), a, b);
            bool straight = is_after_plateau(flattest, mean) == after_plateau && mean > min_slope && mean < max_slope &&
                            y[b] <= highest;
            for (Eigen::Index k = a; straight && k <= b; ++k)
                straight = local[k] > min_slope / 2 - scatter[k] && local[k] < max_slope + scatter[k] &&
                           std::abs(local[k] - mean) <= (std::max)(scatter[k], tolerance);
            if (straight) {
                best = IndexRange{a, b};
                best_length = length;
                break;
            }
        }
    }
    return best;
}

/// A window, and the tolerance of the search for it.
template <Real F>
struct ChosenRange {
    IndexRange range;
    F tolerance{};  // of the local slopes; 0: given
    bool after_plateau{};
};

/// Given window. \throws domain_error when it holds too few lags.
template <Real T>
ChosenRange<double> given_range(const LogStructure<double>& log, const LengthRange<T>& window, T spacing,
                                const ReliableLags<T>& reliable) {
    const double slack = 1e-4;
    const double from = std::log(static_cast<double>(window.from / spacing)) - slack;
    const double to = std::log(static_cast<double>(window.to / spacing)) + slack;
    IndexRange range{log.lag.size(), -1};
    for (Eigen::Index k = 0; k < log.lag.size(); ++k)
        if (log.lag[k] >= from && log.lag[k] <= to) {
            range.first = (std::min)(range.first, k);
            range.last = k;
        }
    const auto held = range.last < range.first ? Eigen::Index(0) : range.count();
    if (held < static_cast<Eigen::Index>(min_window_lags) ||
        log.lag[range.last] - log.lag[range.first] < std::log(static_cast<double>(min_window_ratio))) {
        const T length = static_cast<T>(log.points - 1) * spacing;
        const auto metres = [](T value) { return rounded_text(value, 4) + " m"; };
        throw domain_error({.parameter = "window",
                            .value = metres(window.from) + " to " + metres(window.to),
                            .reason = "holds " + std::to_string(held) + " lags; must hold at least " +
                                      std::to_string(min_window_lags) + " and half a decade, between " +
                                      metres(spacing) + " and " + metres(length) + reliable.note(length)});
    }
    return {range, 0.0, false};
}

/// Automatic window. \throws domain_error when there is none.
template <Real T>
ChosenRange<double> automatic_range(const LogStructure<double>& log, T spacing, const ReliableLags<T>& reliable) {
    for (const auto& [tolerance, after_plateau] :
         {std::pair{0.2, false}, {0.2, true}, {0.3, false}, {0.45, false}, {0.3, true}, {0.45, true}})
        if (const auto range = straight_range(log, tolerance, after_plateau, {0, log.lag.size() - 1}))
            return {*range, tolerance, after_plateau};
    const std::string first = rounded_text(log.slope[0], 4), last = rounded_text(log.slope[log.slope.size() - 1], 4);
    throw domain_error(
        {.parameter = "window",
         .value = "automatic",
         .reason = "no half decade of lags follows a power law (local slope of the second differences, " + first +
                   " at the shortest and " + last +
                   " at the longest lag); must be a profile whose slope keeps to one value between 0.2 and "
                   "1.95 over half a decade, or a window given by hand" +
                   reliable.note(static_cast<T>(log.points - 1) * spacing)});
}

/// Reason why an automatic window ends before lag \p next: \p outermost at the end of the search.
template <Real F>
WindowEnd why_there(const LogStructure<F>& log, const IndexRange& range, Eigen::Index next, WindowEnd outermost) {
    if (next < 0 || next >= log.slope.size()) return outermost;
    const F lag = std::exp(log.lag[next]) * F(1 + 1e-9), slope = log.slope[next];
    if (lag < log.shortest() || lag > log.longest() * F(1 + 1e-8)) return outermost;
    if (slope > F(1.8) && slope > log.slope[next < range.first ? range.first : range.last]) return WindowEnd::smooth;
    return slope < F(0.2) ? WindowEnd::saturated : WindowEnd::bend;
}

}  // namespace detail

}}  // namespace fstiff
