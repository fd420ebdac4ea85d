// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Least-squares circle, sphere or cylinder of points, by their distances along its normal.
///
///     P = kappa/2 (u^2 + v^2 + w^2) + b_u u + b_v v + c w + e,   c = sqrt(1 - b_u^2 - b_v^2 + 2 kappa e)
///     distance = 2 P/(1 + sqrt(1 + 2 kappa P))
///
/// w is the height, u and v are the place; a circle and a cylinder have no v. Of a cylinder u is across the axis, which
/// has the direction phi in the plane of the map and the inclination psi, and w is perpendicular to both. With kappa =
/// 0 this is a plane, so that a shallow arc costs no digits. Gauss-Newton from a plane; of a cylinder from the axis of
/// the least-squares quadratic surface.
///
/// Reference   Pratt, Comput. Graph. 21 (1987) 145 (the parameters); ISO 12181-1:2011 (least-squares circle)
/// Units       lengths in one unit of about the size of the patch
/// Valid       points that determine the surface, their normals at most 30 degrees from the height
/// Accuracy    1e-14 of the patch (tests/math/round_fit_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/decompositions.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace math {

enum class RoundShape { circle, sphere, cylinder };

struct RoundSurface {
    using Terms = std::array<double, 5>;

    RoundShape shape{};
    Terms terms{};  ///< kappa, e, b_u, then b_v of a sphere, or phi and psi

    [[nodiscard]] std::size_t count() const { return 3 + static_cast<std::size_t>(shape); }
    /// Above 0 where it is convex from above.
    [[nodiscard]] double curvature() const { return terms[0]; }

    /// Distance of the point (\p x, \p y, \p z), above 0 above the surface; its derivatives by the terms, and the sine
    /// of the angle between its normal and the height.
    double distance(double x, double y, double z, Terms* derivatives = nullptr, double* sine = nullptr) const {
        const double kappa = terms[0], e = terms[1], b_u = terms[2];
        const bool ball = shape == RoundShape::sphere, rod = shape == RoundShape::cylinder;
        const double b_v = ball ? terms[3] : 0, v = ball ? y : 0;
        const double cos_phi = rod ? std::cos(terms[3]) : 0, sin_phi = rod ? std::sin(terms[3]) : -1;
        const double sin_psi = rod ? std::sin(terms[4]) : 0, cos_psi = rod ? std::cos(terms[4]) : 1;
        const double u = -x * sin_phi + y * cos_phi, s = x * cos_phi + y * sin_phi, w = z * cos_psi - s * sin_psi;
        const double c = std::sqrt(1 - b_u * b_u - b_v * b_v + 2 * kappa * e), squares = u * u + v * v + w * w;
        const double p = kappa / 2 * squares + b_u * u + b_v * v + c * w + e;
        const double root = std::sqrt((std::max)(0.0, 1 + 2 * kappa * p)), distance = 2 * p / (1 + root);
        if (derivatives) {
            const double across = kappa * u + b_u, up = kappa * w + c;
            *derivatives = {(squares - distance * distance) / 2 + w * e / c, 1 + w * kappa / c, u - w * b_u / c,
                            rod ? -across * s - up * sin_psi * u : v - w * b_v / c,
                            rod ? -up * (z * sin_psi + s * cos_psi) : 0};
            for (double& derivative : *derivatives) derivative /= root;
        }
        if (sine) *sine = std::hypot(kappa * u + b_u, kappa * v + b_v, sin_psi);
        return distance;
    }
};

/// Normal equations of a linear least-squares fit of N terms.
template <std::size_t N>
struct NormalEquations {
    std::array<std::array<double, N>, N> matrix{};  ///< up to the diagonal
    std::array<double, N> moments{};
    double points = 0;

    void add(const std::array<double, N>& slopes, double value) {
        for (std::size_t i = 0; i < N; ++i) {
            moments[i] += value * slopes[i];
            for (std::size_t j = 0; j <= i; ++j) matrix[i][j] += slopes[i] * slopes[j];
        }
        points += 1;
    }
    /// Sums of the terms from \p first to below \p end over \p divisor, as a matrix and a vector.
    [[nodiscard]] std::pair<Eigen::MatrixXd, Eigen::VectorXd> over(double divisor, std::size_t first,
                                                                   std::size_t end) const {
        const auto count = static_cast<Eigen::Index>(end - first);
        std::pair<Eigen::MatrixXd, Eigen::VectorXd> result{Eigen::MatrixXd(count, count), Eigen::VectorXd(count)};
        for (std::size_t i = first; i < end; ++i) {
            const auto row = static_cast<Eigen::Index>(i - first);
            result.second[row] = moments[i] / divisor;
            for (std::size_t j = first; j < end; ++j)
                result.first(row, static_cast<Eigen::Index>(j - first)) =
                    matrix[(std::max)(i, j)][(std::min)(i, j)] / divisor;
        }
        return result;
    }
};

/// A cylinder with the axis and the curvature of the least-squares quadratic surface of the points of \p each.
template <class EachPoint>
[[nodiscard]] RoundSurface cylinder_of_quadratic(const EachPoint& each) {
    NormalEquations<6> sums;
    each([&](double x, double y, double z) { sums.add({1, x, y, x * x, x * y, y * y}, z); });
    auto [normal, moments] = sums.over(1, 0, 6);
    const Eigen::VectorXd c = PivotedQr<double>(std::move(normal), 1e-12).solve(std::move(moments));
    const double highest = std::atan2(c[4], c[3] - c[5]) / 2;  // direction of the algebraically greatest curvature
    const double axis = c[3] + c[5] > 0 ? highest + std::numbers::pi / 2 : highest;
    const double across = std::hypot(c[4], c[3] - c[5]) + std::abs(c[3] + c[5]);
    return {RoundShape::cylinder, {c[3] + c[5] > 0 ? -across : across, 0, 0, axis, 0}};
}

/// The surface that fits the points of \p each best, from \p surface; \p each(use) calls use(x, y, z) for every point.
/// With a \p radius above 0 that is kept, on the side where a free fit has its own.
/// \throws domain_error for points that do not determine it, or whose normals are beyond 30 degrees.
template <class EachPoint>
[[nodiscard]] RoundSurface fit_round(RoundSurface surface, double radius, const EachPoint& each) {
    for (const bool kept : {false, true}) {
        if (kept && !(radius > 0)) break;
        if (kept) surface.terms[0] = std::copysign(1 / radius, surface.terms[0]);
        const std::size_t first = kept ? 1 : 0, end = surface.count();
        const auto count = static_cast<Eigen::Index>(end - first);
        double last = std::numeric_limits<double>::infinity();
        for (int iteration = 0; iteration < 50; ++iteration) {
            NormalEquations<5> sums;
            each([&](double x, double y, double z) {
                RoundSurface::Terms slopes;
                const double distance = surface.distance(x, y, z, &slopes);
                sums.add(slopes, distance);
            });
            auto [normal, moments] = sums.over(sums.points, first, end);
            const PivotedQr<double> solver(std::move(normal), 1e-14);
            if (solver.rank() < count)
                throw domain_error("surface whose points determine " + std::to_string(solver.rank()) + " of the " +
                                   std::to_string(count) +
                                   " terms of this form: must be curved, and more of it measured");
            const Eigen::VectorXd step = solver.solve(std::move(moments));
            for (std::size_t i = first; i < end; ++i) surface.terms[i] -= step[static_cast<Eigen::Index>(i - first)];
            const double length = std::sqrt(dot_in_lanes(step.data(), step.data(), count));
            if (!(length < last) && length < 1e-9) break;  // rounding is reached
            last = length;
        }
    }
    double steepest = 0;
    each([&](double x, double y, double z) {
        double sine;
        surface.distance(x, y, z, nullptr, &sine);
        steepest = (std::max)(steepest, sine);
    });
    if (!(steepest < 0.5))
        throw domain_error("surface whose normal is up to " +
                           std::to_string(std::lround(std::asin((std::min)(1.0, steepest)) * 180 / std::numbers::pi)) +
                           " degrees from the height: must be at most 30 for this form; crop it");
    return surface;
}

/// The \p shape that fits the points of \p each best, as above.
template <class EachPoint>
[[nodiscard]] RoundSurface fit_round(RoundShape shape, double radius, const EachPoint& each) {
    return fit_round(shape == RoundShape::cylinder ? cylinder_of_quadratic(each) : RoundSurface{shape}, radius, each);
}

}}}  // namespace fstiff::math
