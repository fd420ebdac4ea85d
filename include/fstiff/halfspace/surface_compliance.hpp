// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Deflection of an elastic half space by a pressure on a grid, which repeats itself or is mirrored at its edges.
///
///     u_k = 2/(E |q_k|) p_k      for every wave but the mean, which moves the whole body: u_0 = 0
///
/// The kernel is even in x and in y, so that products of cosines and sines are its eigenfunctions: a real transform
/// along x and one along y, of N numbers into N, replace complex ones (topography/line_transform.hpp).
///
/// Reference   Stanley, Kato, J. Tribol. 119 (1997) 481 (repeating half space by transforms).
/// Units       lengths [m], pressure in units of E: u [m] = deflect(p/E)
/// Valid       2 points a side at least; sides that are products of 2, 3 and 5 are fast, others take a transform of 2N
///             or more
/// Accuracy    1e-14 relative to the largest deflection in double (tests/halfspace/surface_compliance_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/topography/line_transform.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Multiplies each wave of a field by a number.
template <Real T>
class WaveFactors {
public:
    /// \p factors: a row for each wave along x, in the order of LineTransform, in it one for each along y.
    WaveFactors(GridField<T> factors, Edges edges)
        : factors_(std::move(factors)),
          turned_(factors_.rows(), factors_.cols()),
          along_x_(static_cast<std::size_t>(factors_.rows()), edges),
          along_y_(static_cast<std::size_t>(factors_.cols()), edges) {}

    [[nodiscard]] const GridField<T>& factors() const { return factors_; }

    void apply(GridField<T>& field) {
        constexpr std::size_t lines = LinesTransform<T>::lines;
        const auto rows = static_cast<std::size_t>(field.rows()), columns = static_cast<std::size_t>(field.cols());
        for (std::size_t j = 0; j < rows; j += lines) {
            const std::size_t count = (std::min)(lines, rows - j);
            along_x_.load(field.data() + j * columns, 1, columns, count);
            along_x_.forward();
            along_x_.store(turned_.data() + j, rows, 1, count);
        }
        for (std::size_t i = 0; i < columns; i += lines) {
            const std::size_t count = (std::min)(lines, columns - i);
            along_y_.load(turned_.data() + i * rows, 1, rows, count);
            along_y_.forward();
            along_y_.multiply(factors_.data() + i * rows, 1, rows, count);
            along_y_.inverse();
            along_y_.store(turned_.data() + i * rows, 1, rows, count);
        }
        for (std::size_t j = 0; j < rows; j += lines) {
            const std::size_t count = (std::min)(lines, rows - j);
            along_x_.load(turned_.data() + j, rows, 1, count);
            along_x_.inverse();
            along_x_.store(field.data() + j * columns, 1, columns, count);
        }
    }

private:
    GridField<T> factors_, turned_;  ///< columns by rows of the field
    LinesTransform<T> along_x_, along_y_;
};

/// Displacement of the surface of an elastic half space under pressures on a grid.
template <Real T = double>
class SurfaceCompliance {
public:
    /// Compliance of \p rows by \p columns cells of the size \p dy by \p dx [m]. \throws domain_error for less than 2 a
    /// side and sizes that are not finite and positive.
    SurfaceCompliance(Eigen::Index rows, Eigen::Index columns, T dx, T dy, Edges edges)
        : SurfaceCompliance(
              rows, columns, dx, dy, edges, [](T) { return T(1); }, [](T) { return T(1); }) {}

    /// The same with each wave taken \p radial(|q|) \p along(q_x dx) \p along(q_y dy) times: a part of the half space,
    /// seen through a window of points.
    template <class Radial, class Along>
    SurfaceCompliance(Eigen::Index rows, Eigen::Index columns, T dx, T dy, Edges edges, const Radial& radial,
                      const Along& along)
        : edges_(edges), compliance_(factors(rows, columns, dx, dy, edges, radial, along), edges) {}

    /// \p field becomes the deflection [m] under it, taken as pressure over E. Its mean becomes 0.
    void deflect(GridField<T>& field) { compliance_.apply(field); }

    /// The inverse of deflect() over the stiffness of the stiffest wave, the mean left out, in single precision: a
    /// preconditioner.
    [[nodiscard]] WaveFactors<float> inverse() const {
        const GridField<T>& factors = compliance_.factors();
        const auto softness = [](T value) { return value > 0 ? value : std::numeric_limits<T>::infinity(); };
        const T least = factors.unaryExpr(softness).minCoeff();
        return {(least / factors.unaryExpr(softness)).template cast<float>(), edges_};
    }

private:
    template <class Radial, class Along>
    static GridField<T> factors(Eigen::Index rows, Eigen::Index columns, T dx, T dy, Edges edges, const Radial& radial,
                                const Along& along) {
        require_positive("dx", dx);
        require_positive("dy", dy);
        using Line = Eigen::Array<T, Eigen::Dynamic, 1>;
        const auto waves = [edges](Eigen::Index points, T step) -> Line {
            return Line::NullaryExpr(points, [&](Eigen::Index k) {
                return 2 * std::numbers::pi_v<T> / (step * T(points)) *
                       detail::wave_number<T>(static_cast<std::size_t>(k), edges);
            });
        };
        const Line qx = waves(columns, dx), qy = waves(rows, dy);
        const Line share_x = (qx * dx).unaryExpr(along), share_y = (qy * dy).unaryExpr(along);
        GridField<T> compliance(columns, rows);
        for (Eigen::Index i = 0; i < columns; ++i)
            for (Eigen::Index j = 0; j < rows; ++j) {
                const T q = std::hypot(qx[i], qy[j]);
                compliance(i, j) = 2 / q * radial(q) * share_x[i] * share_y[j];
            }
        compliance(0, 0) = 0;
        return compliance;
    }

    Edges edges_;
    WaveFactors<T> compliance_;
};

}}}  // namespace fstiff::detail
