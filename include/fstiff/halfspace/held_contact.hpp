// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The stiffness of a set of points that are held together on an elastic half space, and of the highest points of a map.
///
///     u[t] = 1/K on the set, t = 0 elsewhere, mean t = 1
///
/// It is a linear problem, solved by conjugate gradients: no contact is searched for. The highest points of area p/H are what
/// a rigid flat leaves of peaks that flow at the hardness H; their K is that of unloading.
///
/// Reference   halfspace/boundary_elements.hpp; Stanley, Kato, J. Tribol. 119 (1997) 481
/// Units       heights [m], K [Pa/m]
/// Valid       maps without missing points; shares of the area above 0 and below 1
/// Accuracy    scatter of u on the set 1e-6 by default, of which the error of K is the square
///             (tests/halfspace/held_contact_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/halfspace/surface_compliance.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff {

/// What conjugate gradients found.
template <Real T = double>
struct HeldContact {
    T compliance{};  ///< u on the set [m], for E = 1: 1/K
    T residual{};    ///< scatter of u on the set over its mean
    int iterations{};
};

/// Of the points where \p on is 1 (others 0), from the pressures \p start on them, which are not 0 altogether.
template <Real T>
[[nodiscard]] HeldContact<T> held_together(SurfaceCompliance<T>& compliance, const GridField<T>& on,
                                           const GridField<T>& start, T tolerance = T(1e-6), int max_iterations = 2000) {
    using Field = GridField<T>;
    const T count = on.sum();
    // start over its mean has the mean 1; corrections of mean 0 take u to one value on the set
    Field t = start / start.mean(), u = t, direction = Field::Zero(t.rows(), t.cols()), response;
    compliance.deflect(u);
    T last_norm = 0, level = 0, share = 1;
    int iteration = 0;
    for (; iteration < max_iterations; ++iteration) {
        level = (u * on).sum() / count;
        const Field residual = (u - level) * on;
        share = std::sqrt(residual.square().sum() / count) / level;
        if (share <= tolerance) break;
        // the operator is 1/|q|, so that |q| leaves few different eigenvalues
        Field pull = residual;
        compliance.press(pull);
        pull = ((pull * on) - (pull * on).sum() / count) * on;
        const T norm = (residual * pull).sum();
        direction = pull + (iteration > 0 ? norm / last_norm : T(0)) * direction;
        last_norm = norm;
        response = direction;
        compliance.deflect(response);
        const T curvature = (response * direction).sum();
        if (!(curvature > 0)) break;
        t -= norm / curvature * direction;
        u -= norm / curvature * response;
    }
    return {level, share, iteration};
}

/// The highest points of one map, held together at one share of the area after another.
template <Real T = double>
class HighestPoints {
public:
    /// \throws domain_error for missing points and what HeightMap::validate says.
    HighestPoints(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus, Edges edges)
        : modulus_(effective_modulus),
          rows_(map.rows()),
          order_(static_cast<std::size_t>(map.size())),
          compliance_(map.rows(), map.columns(), map.dx, map.dy, edges) {
        map.validate();
        map.require_whole("before its highest points are held together");
        require_positive("effective_modulus", effective_modulus);
        std::iota(order_.begin(), order_.end(), Eigen::Index(0));
        const T* const z = map.heights.data();
        std::sort(order_.begin(), order_.end(), [z](Eigen::Index a, Eigen::Index b) { return z[a] > z[b]; });
    }

    /// Points of the map.
    [[nodiscard]] std::size_t count() const { return order_.size(); }

    /// K [Pa/m] of the points of \p share of the area; in proportion to it between whole numbers of points.
    /// \throws domain_error unless 0 < share < 1.
    [[nodiscard]] T stiffness(T share) const {
        require(share > 0 && share < 1, "share of the area", share, "greater than 0 and less than 1");
        const T points = share * static_cast<T>(order_.size());
        const auto count = static_cast<std::size_t>(
            std::clamp(std::round(points), T(1), static_cast<T>(order_.size() - 1)));
        GridField<T> on = GridField<T>::Zero(rows_, static_cast<Eigen::Index>(order_.size()) / rows_);
        for (std::size_t i = 0; i < count; ++i) on.data()[order_[i]] = 1;
        SurfaceCompliance<T> compliance = compliance_;
        return modulus_ / held_together<T>(compliance, on, on).compliance * (points / static_cast<T>(count));
    }

private:
    T modulus_;
    Eigen::Index rows_;
    std::vector<Eigen::Index> order_;  ///< the highest first
    SurfaceCompliance<T> compliance_;
};

}  // namespace fstiff
