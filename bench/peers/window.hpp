// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What every peer in two dimensions is given: the substitutions t = s^2 and zeta = eta + c w^2, which remove the branch
// points, and a box that moves with the Gaussian, so that no method wastes its nodes on zeros.
//
//     J[a,b] = c^a/(2 theta) int 2 s^(2b+1) erf(k s^2) int 2 w^(2a+1) exp(-(w^2 + x)^2/2 - s^4/2) dw ds
//     x = (eta - r s^2)/c
#include "../problems.hpp"

namespace bench {

struct Window {
    double r, theta, eta, c, k;
    double floor;  ///< exp(-floor^2/2) is the size of J
    double depth;  ///< exp(-depth) may be neglected in a row
    double s_from, s_to;

    Window(const Problem& p, double depth_of_rows, double depth_of_columns)
        : r(p.r),
          theta(p.theta),
          eta(p.eta),
          c(std::sqrt((1 - p.r) * (1 + p.r))),
          k(std::tan(p.theta) / std::sqrt(2.0)),
          floor(std::max(p.eta, 0.0)),
          depth(depth_of_rows) {
        const double reach = std::sqrt(2 * depth_of_columns) * c;
        double to = r * eta + reach;  // the end of the Gaussian, or of exp(-t^2/2) where the former lies beyond x = 0
        if (to * r > eta) to = std::sqrt(floor * floor + 2 * depth_of_columns);
        s_from = eta > 0 ? std::sqrt(std::max(0.0, r * eta - reach)) : 0.0;
        s_to = std::sqrt(to);
    }

    [[nodiscard]] double x(double t) const { return (eta - r * t) / c; }

    struct Row {
        double from, to;  ///< of w
    };
    [[nodiscard]] Row row(double x_of_row) const {
        const double ahead = std::max(x_of_row, 0.0);
        const double radius = std::sqrt(ahead * ahead + 2 * depth);
        return {std::sqrt(std::max(0.0, -x_of_row - radius)), std::sqrt(radius - x_of_row)};
    }

    /// log of the integrand over its algebraic factors, exp(-floor^2/2) taken out.
    [[nodiscard]] double exponent(double t, double x_of_row, double w_square) const {
        const double z = w_square + x_of_row;
        return (floor * floor - t * t - z * z) / 2;
    }

    /// What is left in front of the sum over s and w for the power a.
    [[nodiscard]] double factor(double a) const { return 2 * std::pow(c, a) / theta * std::exp(-floor * floor / 2); }
};

/// The cheapest setting of a peer that meets a tolerance on the plain grid: how deep its window is, and the relative
/// tolerances that it is given for the outer and the inner integral. All were found by search; an error estimate is
/// often so cautious that a peer delivers many digits more than it was asked for.
struct Setting {
    double tolerance, depth, outer, inner;
};

}  // namespace bench
