// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// K and -dp/dd of the faces over the pressure at the points of an answer, of which its laws and those of balls are
/// made.

#include <fstiff/answer/answer.hpp>
#include <fstiff/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

using LogNodes = std::vector<std::pair<double, double>>;  ///< of a quantity over the pressure

/// ln K and ln(-dp/dd) of the faces over ln p at the points of an answer, at a value or an end of its band: -dp/dd is
/// as far from its value as K. Where it is not known, as of boundary elements of peaks that yield, it is that of the
/// separations on both sides.
class NodesOfAnswer {
public:
    /// An end of the band is at most \p most times its value. \throws domain_error for another quantile.
    NodesOfAnswer(const Answer& answer, double quantile, double most = std::numeric_limits<double>::infinity()) {
        if (!(quantile == 0.05 || quantile == 0.5 || quantile == 0.95))
            detail::refuse("quantile", quantile, 3, "0.05, 0.5 or 0.95");
        for (const AnswerPoint& point : answer.points)
            if (point.ok()) known.push_back(&point);
        for (std::size_t i = 0; i < known.size(); ++i) {
            const auto& [low, value, high] = known[i]->of_faces();
            const double K = quantile < 0.5   ? low
                             : quantile > 0.5 ? (std::min)(high, most * value)
                                              : value,
                         x = std::log(known[i]->pressure);
            const auto& loading = known[i]->faces ? known[i]->loading_of_faces : known[i]->loading_stiffness;
            const double slope = !answer.flows ? value : loading ? *loading : slope_about(known, i, value);
            stiffnesses.emplace_back(x, std::log(K));
            slopes.emplace_back(x, std::log((std::min)(slope, value) * (K / value)));
        }
    }
    std::vector<const AnswerPoint*> known{};  ///< the points with a K, one for each node
    LogNodes stiffnesses{}, slopes{};

private:
    static double slope_about(const std::vector<const AnswerPoint*>& points, std::size_t i, double unknown) {
        const AnswerPoint &a = *points[i > 0 ? i - 1 : 0], &b = *points[(std::min)(i + 1, points.size() - 1)];
        const double fall = a.state.separation.value - b.state.separation.value,
                     log_rise = std::log(b.pressure / a.pressure);
        return fall / log_rise > 0 ? points[i]->pressure * log_rise / fall : unknown;
    }
};

}}}  // namespace fstiff::detail
