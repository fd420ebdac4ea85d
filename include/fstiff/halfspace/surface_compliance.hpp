// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How a pressure on a grid deflects an elastic half space that goes on beyond the grid: by repeating it, or mirrored at its edges.
///
///     u_k = 2/(E |q_k|) p_k      for every wave but the mean, which moves the whole body: u_0 = 0
///
/// The kernel is even in x and in y, so that products of cosines and sines are its eigenfunctions: a real transform along x and
/// one along y, of N numbers into N, replace complex ones (topography/line_transform.hpp).
///
/// Reference   Stanley, Kato, J. Tribol. 119 (1997) 481 (repeating half space by transforms).
/// Units       lengths [m], pressure in units of E: u [m] = deflect(p/E)
/// Valid       2 points a side at least; sides that are products of 2, 3 and 5 are fast, others take a transform of 2N or more
/// Accuracy    1e-14 relative to the largest deflection in double (tests/halfspace/surface_compliance_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/topography/line_transform.hpp>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace fstiff {

/// Displacement of the surface of an elastic half space under pressures on a grid.
template <Real T = double>
class SurfaceCompliance {
public:
    /// For \p rows by \p columns cells of the size \p dy by \p dx [m]. \throws domain_error for less than 2 a side and sizes
    /// that are not finite and positive.
    SurfaceCompliance(Eigen::Index rows, Eigen::Index columns, T dx, T dy, Edges edges)
        : SurfaceCompliance(rows, columns, dx, dy, edges, [](T) { return T(1); }, [](T) { return T(1); }) {}

    /// With each wave taken \p radial(|q|) \p along(q_x dx) \p along(q_y dy) times: a part of the half space, seen through a
    /// window of points.
    template <class Radial, class Along>
    SurfaceCompliance(Eigen::Index rows, Eigen::Index columns, T dx, T dy, Edges edges, const Radial& radial,
                      const Along& along)
        : along_x_(static_cast<std::size_t>(columns), edges), along_y_(static_cast<std::size_t>(rows), edges) {
        require_positive("dx", dx);
        require_positive("dy", dy);
        using Line = Eigen::Array<T, Eigen::Dynamic, 1>;
        const auto waves = [](const detail::LineTransform<T>& line, Eigen::Index points, T step) -> Line {
            return Line::NullaryExpr(points, [&](Eigen::Index k) {
                return 2 * numbers::pi_v<T> / (step * T(points)) * line.wave_number(static_cast<std::size_t>(k));
            });
        };
        const Line qx = waves(along_x_, columns, dx), qy = waves(along_y_, rows, dy);
        const Line share_x = (qx * dx).unaryExpr(along), share_y = (qy * dy).unaryExpr(along);
        compliance_.resize(columns, rows);  // a line along y side by side: NOLINT(readability-suspicious-call-argument)
        for (Eigen::Index i = 0; i < columns; ++i)
            for (Eigen::Index j = 0; j < rows; ++j) {
                const T q = std::hypot(qx[i], qy[j]);
                compliance_(i, j) = 2 / q * radial(q) * share_x[i] * share_y[j];
            }
        stiffness_ = 1 / compliance_;
        compliance_(0, 0) = stiffness_(0, 0) = 0;
    }

    /// \p field becomes the deflection [m] under it, taken as pressure over E. Its mean becomes 0.
    void deflect(GridField<T>& field) { multiply(field, compliance_); }
    /// \p field becomes the pressure over E that deflects all points by it [m], its mean left out: the inverse of deflect().
    void press(GridField<T>& field) { multiply(field, stiffness_); }

private:
    void multiply(GridField<T>& field, const GridField<T>& factors) {
        for (Eigen::Index j = 0; j < field.rows(); ++j) along_x_.forward(&field(j, 0));
        turned_ = field.transpose();
        for (Eigen::Index i = 0; i < turned_.rows(); ++i) {
            along_y_.forward(&turned_(i, 0));
            turned_.row(i) *= factors.row(i);
            along_y_.inverse(&turned_(i, 0));
        }
        field = turned_.transpose();
        for (Eigen::Index j = 0; j < field.rows(); ++j) along_x_.inverse(&field(j, 0));
    }

    detail::LineTransform<T> along_x_, along_y_;
    GridField<T> compliance_, stiffness_, turned_;  ///< columns by rows
};

}  // namespace fstiff
