// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sums over the parts of a surface, the estimates from them, and their spread over resamples of the parts.
///
/// A resample draws blocks of neighbouring parts until it is as long as the whole. The error of an estimate is the
/// standard deviation over the resamples times sqrt(n/(n-1)) t_(n-1)(0.95)/1.645 for n blocks (Student), because few
/// blocks give an uncertain scatter and the error has to give a band from 5 % to 95 %.
///
/// Reference   Kunsch, Ann. Stat. 17 (1989) 1217; Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), section 4
/// Units       heights in any unit, lengths in samples
/// Valid       at least two blocks
/// Accuracy    that of plain sums (tests/measure/surface_parameters_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/surface/moments.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Sums over points and triples of neighbours; heights relative to the mean, in any unit.
template <Real S>
struct HeightSums {
    S points{}, first{}, square{}, highest = std::numeric_limits<S>::lowest();
    TripleSums<S> triples;
    S inner{}, summits{}, summit_curvature{};  // of a map: points with eight neighbours, those above them

    void add_point(S z) {
        if (std::isnan(z)) return;
        points += 1;
        first += z;
        square += z * z;
        highest = (std::max)(highest, z);
    }
    void add(const HeightSums& other) {
        points += other.points, first += other.first, square += other.square;
        triples.add(other.triples);
        highest = (std::max)(highest, other.highest);
        inner += other.inner, summits += other.summits, summit_curvature += other.summit_curvature;
    }
};

/// Kind of the peaks in the sums.
enum class PeakCount { profile, summits, none };

/// sigma, R, D_p, R_p, r, theta in the units of the sums: the unit of heights, and samples.
template <Real S>
using Estimates = std::array<S, 6>;

/// Estimates from the sums. R = D_p = 1 for sums without peaks; NaN or infinite where the sums have no value.
template <Real S>
Estimates<S> estimates(const HeightSums<S>& sums, PeakCount count) {
    const S mean = sums.first / sums.points;
    const S sigma = std::sqrt((std::max)(S(0), sums.square / sums.points - mean * mean));
    const S slope = std::sqrt(sums.triples.mean_square_slope());
    const S curvature = std::sqrt(sums.triples.mean_square_curvature());
    // curvature = 2 slope is a zigzag, but for rounding
    Estimates<S> e{sigma,
                   S(1),
                   S(1),
                   sums.highest - mean,
                   slope * (slope / (sigma * curvature)),
                   std::asin((std::min)(S(1), curvature / slope / 2))};
    if (count == PeakCount::profile) {
        const S share = static_cast<S>(sums.triples.peaks) / static_cast<S>(sums.triples.triples);
        e[1] = detail::radius_times_rms_curvature<S>() / curvature;
        e[2] = 2 * std::numbers::pi_v<S> / (3 * std::sqrt(S(3))) * share * share;
    } else if (count == PeakCount::summits) {
        e[1] = sums.summits / sums.summit_curvature;
        e[2] = sums.summits / sums.inner;
    }
    return e;
}

/// Standard deviations of the estimates, relative to the whole (for r and theta absolute), and their correlation.
template <Real S>
struct EstimateSpread {
    using Square = std::array<Estimates<S>, 6>;

    Estimates<S> error{};
    Square correlation{};
    std::size_t blocks{};

    EstimateSpread() {
        for (std::size_t i = 0; i < 6; ++i) correlation[i][i] = 1;
    }
    /// Sets both from \p covariance; an error up to \p least is 0, and has no correlation.
    void set(const Square& covariance, S least) {
        for (std::size_t i = 0; i < 6; ++i) {
            error[i] = std::sqrt(covariance[i][i]);
            if (!(error[i] > least)) error[i] = 0;
        }
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                if (const S product = error[i] * error[j]; i != j && product > S(0))
                    correlation[i][j] = std::clamp(covariance[i][j] / product, S(-1), S(1));
    }
};

/// Resamples of \p cells, drawn in runs of \p block neighbours, each as long as the whole.
template <Real S>
EstimateSpread<S> resample_cells(const std::vector<HeightSums<S>>& cells, std::size_t block, PeakCount count,
                                 std::size_t resamples, std::uint64_t seed, const ProgressHook& progress) {
    EstimateSpread<S> spread;
    math::BlockDraw draw_block(cells.size(), block, seed);
    spread.blocks = draw_block.blocks();
    HeightSums<S> total;
    for (const auto& cell : cells) total.add(cell);
    const Estimates<S> estimate = estimates(total, count);
    Estimates<S> unit = estimate;
    unit[4] = unit[5] = S(1);
    if (count == PeakCount::profile && !(estimate[2] > S(0))) unit[2] = S(1);  // no peak
    std::vector<Estimates<S>> draws;
    for (std::size_t k = 0; k < resamples; ++k) {
        if (progress) progress("resamples", k, resamples);
        HeightSums<S> sums;
        for (std::size_t b = 0; b < spread.blocks; ++b) {
            const std::size_t start = draw_block();
            for (std::size_t i = start; i < start + block; ++i) sums.add(cells[i]);
        }
        Estimates<S> draw = estimates(sums, count);
        bool finite = true;  // else one without peaks
        for (std::size_t i = 0; i < 6; ++i) {
            draw[i] = std::isfinite(estimate[i]) ? (draw[i] - estimate[i]) / unit[i] : S(0);
            finite = finite && std::isfinite(draw[i]);
        }
        if (finite) draws.push_back(draw);
    }
    if (spread.blocks < 2 || draws.size() < 2)
        detail::refuse("resamples of " + std::to_string(spread.blocks) + " parts of the surface that hold peaks",
                       draws.size(), "at least 2, of 2 parts at least, for an error");
    Estimates<S> mean{};
    for (const auto& draw : draws)
        for (std::size_t i = 0; i < 6; ++i) mean[i] += draw[i] / static_cast<S>(draws.size());
    typename EstimateSpread<S>::Square covariance{};
    for (const auto& draw : draws)
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) covariance[i][j] += (draw[i] - mean[i]) * (draw[j] - mean[j]);
    const S blocks = static_cast<S>(spread.blocks);
    const S few = math::student_quantile(math::normal_95<S>, static_cast<int>(blocks) - 1) / math::normal_95<S>.value;
    const S share = few * few * blocks / (blocks - 1) / static_cast<S>(draws.size() - 1);
    for (auto& row : covariance)
        for (S& product : row) product *= share;
    spread.set(covariance, S(1e-12));  // the rounding of sums that do not vary
    return spread;
}

}}}  // namespace fstiff::detail
