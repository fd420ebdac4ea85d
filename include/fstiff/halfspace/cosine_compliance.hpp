// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Deflection of an elastic half space by a pressure on a small grid that is mirrored at its edges, by products of
/// matrices: what surface_compliance computes by transforms, for the forms of joints, without their headers.
///
///     u = Y' ((Y p X') * 2/q) X      Y, X: orthonormal cosines of half periods along y and x, q their wave numbers
///
/// Reference   halfspace/surface_compliance.hpp
/// Units       lengths [m], pressure in units of E: u [m] = deflect(p/E)
/// Valid       2 points a side at least; some 64, beyond which transforms are faster
/// Accuracy    1e-13 of SurfaceCompliance (tests/halfspace/formed_joint_test.cpp)

#include <fstiff/core/error.hpp>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

class CosineCompliance {
public:
    using Field = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// Compliance of \p rows by \p columns cells of the size \p dy by \p dx [m]. \throws domain_error for less than 2 a
    /// side and sizes that are not positive.
    CosineCompliance(Eigen::Index rows, Eigen::Index columns, double dx, double dy)
        : along_x_(cosines(columns)), along_y_(cosines(rows)), factors_(rows, columns) {
        require_positive("dx", dx);
        require_positive("dy", dy);
        for (Eigen::Index j = 0; j < rows; ++j)
            for (Eigen::Index i = 0; i < columns; ++i) {
                const double q =
                    std::numbers::pi * std::hypot(static_cast<double>(i) / (static_cast<double>(columns) * dx),
                                                  static_cast<double>(j) / (static_cast<double>(rows) * dy));
                factors_(j, i) = q > 0 ? 2 / q : 0;
            }
    }

    /// \p field, pressures over E, becomes the deflection [m], whose mean is 0.
    void deflect(Field& field) const {
        const Matrix waves = ((along_y_ * field.matrix() * along_x_.transpose()).array() * factors_).matrix();
        field = (along_y_.transpose() * waves * along_x_).array();
    }

private:
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// A row for each number of half periods.
    [[nodiscard]] static Matrix cosines(Eigen::Index points) {
        require(points >= 2, "points a side", points, "at least 2");
        const auto n = static_cast<double>(points);
        return Matrix::NullaryExpr(points, points, [n](Eigen::Index k, Eigen::Index i) {
            const double wave =
                std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / n);
            return (k == 0 ? std::sqrt(1 / n) : std::sqrt(2 / n)) * wave;
        });
    }

    Matrix along_x_, along_y_;
    Field factors_;
};

}}}  // namespace fstiff::detail
