// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sensitivity of D and G to the window of lags: its bends, its halves, and the straight windows next to it.
///
///     D = 2 - slope/2        ln G by (2.4) from ln S2 at the reference lag of the line
///     window error^2 = mean of max(0, d^2 - 2 sampling^2) over halves and neighbours, by their widths in ln tau
///                      + t^2 s^2/(t^2 + s^2) of a found window shorter than two half decades:
///                        t = tolerance/sqrt(12), s error of the difference of the halves
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.4), (2.5); the rules are this project's
/// Units       ln of lags in samples; G in units of the spacing
/// Valid       lines of profile/structure_fit; G for 1 < D < 2
/// Accuracy    G of an exact power law 1e-12, its derivative 1e-7 (tests/profile/window_spread_test.cpp)

#include <fstiff/profile/fractal_result.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

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

}}}  // namespace fstiff::detail
