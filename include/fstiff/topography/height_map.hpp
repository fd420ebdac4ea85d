// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured map: heights on a rectangular grid, some of which may be missing.
///
/// Units       heights, dx and dy [m]
/// Valid       dx, dy > 0; every height finite, or NaN where the point is missing

#include <fstiff/core/error.hpp>

#include <Eigen/Core>

#include <string>

namespace fstiff {

/// A map in SI units. heights(j, i) is the height at x = i dx, y = j dy: a row of the array is a profile along x.
template <Real T>
struct HeightMap {
    using Array = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    Array heights;  ///< [m], rows along y, columns along x; NaN marks a missing point
    T dx{};         ///< between neighbouring columns [m]
    T dy{};         ///< between neighbouring rows [m]

    [[nodiscard]] Eigen::Index columns() const { return heights.cols(); }
    [[nodiscard]] Eigen::Index rows() const { return heights.rows(); }
    /// Points, missing ones included.
    [[nodiscard]] Eigen::Index size() const { return heights.size(); }
    /// Points that are not missing.
    [[nodiscard]] Eigen::Index present() const { return heights.size() - heights.isNaN().count(); }
    /// Nominal area: every point stands for one cell dx dy [m^2].
    [[nodiscard]] T area() const { return static_cast<T>(heights.size()) * dx * dy; }

    /// \throws domain_error unless both spacings are positive, no height is infinite, the map has \p least points a
    /// side, as many exist, and they are not all of one height.
    void validate(Eigen::Index least = 3) const;
};

template <Real T>
void HeightMap<T>::validate(Eigen::Index least) const {
    require_positive("dx", dx);
    require_positive("dy", dy);
    if (rows() < least || columns() < least)
        throw domain_error("map of " + std::to_string(columns()) + " x " + std::to_string(rows()) +
                           " points: must have at least " + std::to_string(least) + " a side");
    if (heights.isInf().any()) throw domain_error("map with an infinite height: must be finite, or NaN where missing");
    if (present() < least)
        throw domain_error("map of which " + std::to_string(present()) + " points exist: must be at least " +
                           std::to_string(least));
    const T low = heights.isNaN().select(std::numeric_limits<T>::max(), heights).minCoeff();
    const T high = heights.isNaN().select(std::numeric_limits<T>::lowest(), heights).maxCoeff();
    require(high > low, "map of constant height", low, "of varying height");
}

}  // namespace fstiff
