// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Bearing curve on probability paper, where a Gaussian surface is a straight line, and its slope about a level.
///
///     h = f(zeta),  zeta = Phi^-1((rank + 1/2)/N)       heights in rising order; equal heights have their mean rank
///     s(c, w) = slope of the straight line through f that fits best with the weights exp(-(zeta - c)^2/(2 w^2))
///
/// About the level c a surface f(zeta) is a Gaussian surface of rms height s. The line is fitted at 61 equidistant zeta
/// in [c - 3 w, c + 3 w] within the points; a level beyond them is moved to the last point. Knots closer than 1/512 in
/// zeta are left out: a million heights give some 4000 knots, with all points of the tails.
/// Reference   Abbott, Firestone, Mech. Eng. 55 (1933) 569; probability paper as in ISO 13565-3; slope: this project
/// Units       heights in any unit; zeta dimensionless
/// Valid       at least two different heights; missing ones (NaN) are left out; w > 0
/// Accuracy    slope within 2e-4 of that of all heights (tests/surface/bearing_slope_test.cpp)

#include <fstiff/surface/material_ratio_curve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// f as straight lines between knots.
template <Real T = double>
class MaterialRatioSlope {
public:
    /// One point of the curve.
    struct Knot {
        T score;   ///< zeta
        T height;  ///< f(zeta)
    };

    /// Curve of heights in any order; knots closer than \p spacing are left out.
    /// \throws domain_error unless two of them differ, and all that exist are finite.
    [[nodiscard]] static MaterialRatioSlope of_heights(std::span<const T> heights, T spacing = T(1) / 512) {
        std::vector<T> sorted;
        for (const T z : heights)
            if (!std::isnan(z)) sorted.push_back(z);
        math::sort_falling<T>(sorted, [](T z) { return -z; });
        return of_sorted(
            sorted, [](std::size_t, std::size_t, T) {}, spacing);
    }

    /// Curve of heights in rising order, none missing; \p use(from, to, zeta) is called for each run [from, to) of
    /// equal ones.
    template <class Use>
    [[nodiscard]] static MaterialRatioSlope of_sorted(std::span<const T> sorted, const Use& use,
                                                      T spacing = T(1) / 512) {
        std::vector<Knot> knots;
        const auto count = static_cast<T>(sorted.size());
        for (std::size_t from = 0, to = 0; from < sorted.size(); from = to) {
            to = from + 1;
            while (to < sorted.size() && sorted[to] == sorted[from]) ++to;
            const T score = math::normal_quantile((static_cast<T>(from) + static_cast<T>(to)) / (2 * count));
            use(from, to, score);
            if (to == sorted.size() || knots.empty() || score - knots.back().score >= spacing)
                knots.push_back({score, sorted[from]});
        }
        return MaterialRatioSlope(std::move(knots));
    }

    /// Curve of knots with rising scores and heights. \throws domain_error unless there are two, and both rise.
    explicit MaterialRatioSlope(std::vector<Knot> knots) : knots_(std::move(knots)) {
        detail::require(knots_.size() >= 2, "different heights of a bearing curve", knots_.size(), "at least 2");
        for (std::size_t i = 0; i < knots_.size(); ++i) {
            detail::require(std::isfinite(knots_[i].height), "height of a bearing curve", knots_[i].height, "finite");
            if (i > 0)
                detail::require(knots_[i].score > knots_[i - 1].score && knots_[i].height > knots_[i - 1].height,
                                "height of a bearing curve", knots_[i].height, "more than that of the score below");
        }
        cells_per_score_ = T(knots_.size() - 1) / (highest() - lowest());
        first_.reserve(knots_.size());
        for (std::size_t cell = 0, i = 1; cell < knots_.size(); ++cell) {
            while (i + 1 < knots_.size() && cell_of(knots_[i].score) < cell) ++i;
            first_.push_back(i);
        }
    }

    /// Curve with heights times \p factor. \throws domain_error unless they also rise after rounding.
    [[nodiscard]] MaterialRatioSlope scaled(T factor) const {
        std::vector<Knot> knots = knots_;
        for (Knot& knot : knots) knot.height *= factor;
        return MaterialRatioSlope(std::move(knots));
    }

    /// Curve between two scores: levels beyond them are moved to the nearer one.
    /// \throws domain_error unless low < high, and the curve has a part between them.
    [[nodiscard]] MaterialRatioSlope between(T low, T high) const {
        const T from = (std::max)(low, lowest()), to = (std::min)(high, highest());
        detail::require(from < to, "higher score of a part of a bearing curve", high,
                        "above the lower one, within the curve");
        std::vector<Knot> knots{{from, height(from)}};
        for (const Knot& knot : knots_)
            if (knot.score > from && knot.score < to) knots.push_back(knot);
        knots.push_back({to, height(to)});
        return MaterialRatioSlope(std::move(knots));
    }

    /// f(zeta), extended by straight lines beyond the ends.
    [[nodiscard]] T height(T score) const { return on_line(above(score), score); }

    /// s: slope of the curve about \p center over the width \p width.
    [[nodiscard]] T slope(T center, T width) const {
        const T c = std::clamp(center, lowest(), highest());
        const T from = (std::max)(c - 3 * width, lowest()), to = (std::min)(c + 3 * width, highest());
        T mass = 0, score = 0, rise = 0, square = 0, product = 0;
        const T base = height(from), step = (to - from) / (nodes - 1);
        // Gaussian weights at even steps: each is the one before times a factor that falls by a constant ratio
        const T first = (from - c) / width, apart = step / width, fall = std::exp(-apart * apart);
        T weight = std::exp(-first * first / 2), factor = std::exp(-apart * (first + apart / 2));
        for (int k = 0; k < nodes; ++k, weight *= factor, factor *= fall) {
            const T x = step * T(k), y = height(from + x) - base;
            mass += weight, score += weight * x, rise += weight * y;
            square += weight * x * x, product += weight * x * y;
        }
        return (product - score * rise / mass) / (square - score * score / mass);
    }

    [[nodiscard]] T lowest() const { return knots_.front().score; }
    [[nodiscard]] T highest() const { return knots_.back().score; }
    [[nodiscard]] std::span<const Knot> knots() const { return knots_; }

private:
    static constexpr int nodes = 61;

    /// Cell of \p score, of equal cells between the ends of the curve, as many as there are lines.
    [[nodiscard]] std::size_t cell_of(T score) const {
        return static_cast<std::size_t>(std::clamp((score - lowest()) * cells_per_score_, T(0), T(knots_.size() - 1)));
    }
    /// Knot at the end of the line that contains \p score.
    [[nodiscard]] std::size_t above(T score) const {
        std::size_t i = first_[cell_of(score)];
        while (i + 1 < knots_.size() && knots_[i].score < score) ++i;
        return i;
    }
    [[nodiscard]] T on_line(std::size_t end, T score) const {
        const Knot &a = knots_[end - 1], &b = knots_[end];
        return a.height + (b.height - a.height) * ((score - a.score) / (b.score - a.score));
    }

    std::vector<Knot> knots_;
    T cells_per_score_{};
    std::vector<std::size_t> first_;  ///< of each cell, the first knot that can end a line there
};

}}  // namespace fstiff
