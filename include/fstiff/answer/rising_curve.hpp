// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// K over the pressure between a few points, and the approach that it makes.
///
///     y(x) = ln K,  x = ln p       cubics through the points, with slopes that keep it monotone where the points are
///     fall(a, b) = integral of p/K over x from a to b                                                          [m]
///
/// Reference   Fritsch, Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, eq. (5) (slopes)
/// Units       SI
/// Valid       two points at least, with different pressures; between the first and the last
/// Accuracy    K at the points; between them, of ten points a decade of a smooth law, 1e-3
///             (tests/scene/joint_test.cpp)

#include <fstiff/answer/curves.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

class RisingCurve {
public:
    /// \p points are ln p and ln K in any order. \throws domain_error for fewer than two pressures.
    explicit RisingCurve(std::vector<std::pair<double, double>> points) : points_(std::move(points)) {
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end(),
                                  [](const auto& a, const auto& b) { return a.first == b.first; }),
                      points_.end());
        require(points_.size() >= 2, "points with a stiffness", points_.size(), "at least 2 for a law");
        const auto chord = [&](std::size_t i) {
            return (points_[i + 1].second - points_[i].second) / (points_[i + 1].first - points_[i].first);
        };
        slopes_.push_back(chord(0));
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
            const double left = points_[i].first - points_[i - 1].first,
                         right = points_[i + 1].first - points_[i].first;
            const double a = chord(i - 1), b = chord(i), share = (left + 2 * right) / (3 * (left + right));
            slopes_.push_back(a * b > 0 ? a * b / (share * b + (1 - share) * a) : 0);
        }
        slopes_.push_back(chord(points_.size() - 2));
    }

    /// \throws domain_error unless \p from and \p to [Pa] are between the points.
    void require_within(double from, double to) const {
        constexpr double rounding = 1e-12;
        const double least = std::exp(points_.front().first), most = std::exp(points_.back().first);
        const std::string range = "from " + detail::rounded_text(least, 6) + " to " + detail::rounded_text(most, 6) +
                                  ", between the points (Pa)";
        require(from >= least * (1 - rounding), "min_pressure", from, range);
        require(to <= most * (1 + rounding), "max_pressure", to, range);
    }

    [[nodiscard]] double at(double x) const { return in_piece(piece_of(x), x); }

    [[nodiscard]] double fall(double from, double to) const {
        double sum = 0;
        for (std::size_t i = piece_of(from); i + 1 < points_.size(); ++i) {
            const double a = i == piece_of(from) ? from : points_[i].first;
            const double b = i + 2 == points_.size() ? to : (std::min)(to, points_[i + 1].first);
            const auto& rule = math::GaussLegendre<double, 12>::get();
            for (std::size_t k = 0; k < rule.node.size() && b > a; ++k) {
                const double x = std::lerp(a, b, (1 + rule.node[k]) / 2);
                sum += rule.weight[k] * (b - a) / 2 * std::exp(x - in_piece(i, x));
            }
        }
        return sum;
    }

private:
    [[nodiscard]] std::size_t piece_of(double x) const {
        std::size_t i = 0;
        while (i + 2 < points_.size() && points_[i + 1].first <= x) ++i;
        return i;
    }
    [[nodiscard]] double in_piece(std::size_t i, double x) const {
        const auto [x0, y0] = points_[i];
        const auto [x1, y1] = points_[i + 1];
        const double h = x1 - x0, t = (x - x0) / h, rise = y1 - y0, left = h * slopes_[i], right = h * slopes_[i + 1];
        return y0 + t * (left + t * (3 * rise - 2 * left - right + t * (left + right - 2 * rise)));
    }

    std::vector<std::pair<double, double>> points_;
    std::vector<double> slopes_;
};

}}}  // namespace fstiff::detail
