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
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace fstiff::inline v0_1::math {

enum class RoundShape { circle, sphere, cylinder };

struct RoundSurface {
    using Terms = Eigen::Matrix<double, 5, 1>;

    RoundShape shape{};
    Terms terms = Terms::Zero();  ///< kappa, e, b_u, then b_v of a sphere, or phi and psi

    [[nodiscard]] Eigen::Index count() const { return 3 + static_cast<Eigen::Index>(shape); }
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
            *derivatives << (squares - distance * distance) / 2 + w * e / c, 1 + w * kappa / c, u - w * b_u / c,
                v - w * b_v / c, 0;
            const double across = kappa * u + b_u, up = kappa * w + c;
            if (rod) derivatives->tail<2>() << -across * s - up * sin_psi * u, -up * (z * sin_psi + s * cos_psi);
            *derivatives /= root;
        }
        if (sine) *sine = std::hypot(kappa * u + b_u, kappa * v + b_v, sin_psi);
        return distance;
    }
};

/// A cylinder with the axis and the curvature of the least-squares quadratic surface of the points of \p each.
template <class EachPoint>
[[nodiscard]] RoundSurface cylinder_of_quadratic(const EachPoint& each) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> moments = Eigen::Matrix<double, 6, 1>::Zero();
    each([&](double x, double y, double z) {
        const Eigen::Matrix<double, 6, 1> powers{1, x, y, x * x, x * y, y * y};
        normal += powers * powers.transpose();
        moments += powers * z;
    });
    const Eigen::VectorXd c = PivotedQr<double>(normal, 1e-12).solve(moments);
    const double highest = std::atan2(c[4], c[3] - c[5]) / 2;  // direction of the algebraically greatest curvature
    const double axis = c[3] + c[5] > 0 ? highest + std::numbers::pi / 2 : highest;
    const double across = std::hypot(c[4], c[3] - c[5]) + std::abs(c[3] + c[5]);
    return {RoundShape::cylinder, {c[3] + c[5] > 0 ? -across : across, 0, 0, axis, 0}};
}

/// The \p shape that fits the points of \p each best; \p each(use) calls use(x, y, z) for every point. With a \p radius
/// above 0 that is kept, on the side where a free fit has its own.
/// \throws domain_error for points that do not determine it, or whose normals are beyond 30 degrees.
template <class EachPoint>
[[nodiscard]] RoundSurface fit_round(RoundShape shape, double radius, const EachPoint& each) {
    RoundSurface surface = shape == RoundShape::cylinder ? cylinder_of_quadratic(each) : RoundSurface{shape};
    for (const bool kept : {false, true}) {
        if (kept && !(radius > 0)) break;
        if (kept) surface.terms[0] = std::copysign(1 / radius, surface.terms[0]);
        const Eigen::Index count = surface.count() - (kept ? 1 : 0), first = kept ? 1 : 0;
        double last = std::numeric_limits<double>::infinity();
        for (int iteration = 0; iteration < 50; ++iteration) {
            Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
            RoundSurface::Terms slopes, moments = RoundSurface::Terms::Zero();
            double points = 0;
            each([&](double x, double y, double z) {
                moments += surface.distance(x, y, z, &slopes) * slopes;
                normal += slopes * slopes.transpose();
                points += 1;
            });
            const PivotedQr<double> solver(normal.block(first, first, count, count) / points, 1e-14);
            if (solver.rank() < count)
                throw domain_error("surface whose points determine " + std::to_string(solver.rank()) + " of the " +
                                   std::to_string(count) +
                                   " terms of this form: must be curved, and more of it measured");
            const Eigen::VectorXd step = solver.solve(moments.segment(first, count) / points);
            surface.terms.segment(first, count) -= step;
            const double length = step.norm();
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

}  // namespace fstiff::inline v0_1::math
