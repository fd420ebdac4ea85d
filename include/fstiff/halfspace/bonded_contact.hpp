// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Stiffness of a set of points that are held together on an elastic half space, such as the highest points of a map.
///
///     u[t] = 1/K on the set, t = 0 elsewhere, mean t = 1
///
/// The problem is linear and is solved by conjugate gradients, without a search for the contact. 1/K is the mean of t
/// u[t], which has its minimum there, so that its error is a square. A rigid flat leaves the highest points of area p/H
/// of peaks that yield at the hardness H; their K is that of unloading.
///
/// Reference   halfspace/boundary_elements.hpp; Stanley, Kato, J. Tribol. 119 (1997) 481
/// Units       heights [m], K [Pa/m]
/// Valid       maps without missing points; shares of the area above 0 and below 1
/// Accuracy    of K: up to 200 times the square of the scatter of u on the set, which is 1e-6 by default
///             (tests/halfspace/bonded_contact_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/halfspace/surface_compliance.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Result of conjugate gradients.
template <Real T = double>
struct BondedContact {
    T compliance{};  ///< u on the set [m], for E = 1: 1/K
    T residual{};    ///< scatter of u on the set over its mean
    int iterations{};
};

/// Conjugate gradients for pressures of one mean on a set of points, which level the gap u[p] - h there. Pressures may
/// become less than 0.
template <Real T>
class SetGradients {
    using Field = GridField<T>;
    using Values = Eigen::Array<T, Eigen::Dynamic, 1>;

public:
    /// Under \p heights. \p inverse is that of \p compliance.
    SetGradients(SurfaceCompliance<T>& compliance, WaveFactors<float>& inverse, const Field& heights)
        : compliance_(&compliance),
          inverse_(&inverse),
          heights_(&heights),
          response_(heights.rows(), heights.cols()),
          single_(heights.rows(), heights.cols()) {}

    /// Another set, and the gaps there where the deflection is \p u.
    void start(std::vector<Eigen::Index> points, const Field& u) {
        points_ = std::move(points);
        gap_.resize(static_cast<Eigen::Index>(points_.size()));
        direction_ = Values::Zero(gap_.size());
        last_norm_ = 1;
        find_gaps(u);
    }

    [[nodiscard]] const std::vector<Eigen::Index>& points() const { return points_; }
    /// Mean gap on the set, and the rms deviation from it.
    [[nodiscard]] T level() const { return level_; }
    [[nodiscard]] T scatter() const { return std::sqrt(gap_.square().sum() / T(gap_.size())); }

    /// One iteration: \p p on the set and \p u change. \returns the sum of the changes of \p p; 0 without any.
    T step(Field& p, Field& u) {
        if (points_.empty()) return 0;
        const Values pull = preconditioned();
        const T norm = (gap_ * pull).sum();
        direction_ = pull + norm / last_norm_ * direction_;
        last_norm_ = norm;
        response_.setZero();
        for_each([&](Eigen::Index k, Eigen::Index i) { response_.data()[k] = direction_[i]; });
        compliance_->deflect(response_);
        T curvature = 0;
        for_each([&](Eigen::Index k, Eigen::Index i) { curvature += response_.data()[k] * direction_[i]; });
        if (!(curvature > 0)) return 0;
        const T length = norm / curvature;
        for_each([&](Eigen::Index k, Eigen::Index i) { p.data()[k] -= length * direction_[i]; });
        u -= length * response_;
        find_gaps(u);
        return std::abs(length) * direction_.abs().sum();
    }

private:
    template <class Use>
    void for_each(const Use& use) const {
        Eigen::Index i = 0;
        for (const Eigen::Index k : points_) use(k, i++);
    }

    void find_gaps(const Field& u) {
        for_each([&](Eigen::Index k, Eigen::Index i) { gap_[i] = u.data()[k] - heights_->data()[k]; });
        level_ = gap_.sum() / T(gap_.size());  // no number where there are no points
        gap_ -= level_;
    }

    /// Pressures that would close the gaps if all points were in the set, of mean 0 on it: the operator is 1/|q|, so
    /// that |q| leaves few different eigenvalues.
    [[nodiscard]] Values preconditioned() {
        const T scale = gap_.abs().maxCoeff();
        Values pull = Values::Zero(gap_.size());
        if (!(scale > 0)) return pull;
        single_.setZero();
        for_each([&](Eigen::Index k, Eigen::Index i) { single_.data()[k] = static_cast<float>(gap_[i] / scale); });
        inverse_->apply(single_);
        for_each([&](Eigen::Index k, Eigen::Index i) { pull[i] = scale * static_cast<T>(single_.data()[k]); });
        pull -= pull.mean();
        return pull;
    }

    SurfaceCompliance<T>* compliance_;
    WaveFactors<float>* inverse_;
    const Field* heights_;
    std::vector<Eigen::Index> points_;
    Values gap_, direction_;
    Field response_;
    GridField<float> single_;
    T level_{}, last_norm_ = 1;
};

/// The points where \p field is not 0.
template <Real T>
[[nodiscard]] std::vector<Eigen::Index> points_of(const GridField<T>& field) {
    std::vector<Eigen::Index> points;
    for (Eigen::Index k = 0; k < field.size(); ++k)
        if (field.data()[k] != 0) points.push_back(k);
    return points;
}

/// Connected parts of the points where \p rest is above 0, joined through edges and corners.
template <Real T>
[[nodiscard]] Eigen::Index count_spots(GridField<T> rest, Edges edges) {
    const Eigen::Index rows = rest.rows(), columns = rest.cols();
    std::vector<Eigen::Index> open;
    Eigen::Index spots = 0;
    for (Eigen::Index k = 0; k < rest.size(); ++k) {
        if (!(std::exchange(rest.data()[k], T(0)) > 0)) continue;
        ++spots;
        for (open = {k}; !open.empty();) {
            const Eigen::Index j = open.back() / columns, i = open.back() % columns;
            open.pop_back();
            for (Eigen::Index y = j - 1; y <= j + 1; ++y)
                for (Eigen::Index x = i - 1; x <= i + 1; ++x) {
                    const bool beyond = y < 0 || x < 0 || y >= rows || x >= columns;
                    if (beyond && edges != Edges::periodic) continue;
                    const Eigen::Index next = (y + rows) % rows * columns + (x + columns) % columns;
                    if (std::exchange(rest.data()[next], T(0)) > 0) open.push_back(next);
                }
        }
    }
    return spots;
}

/// bonded, with the inverse of \p compliance.
template <Real T>
[[nodiscard]] BondedContact<T> bonded(SurfaceCompliance<T>& compliance, WaveFactors<float>& inverse,
                                      const GridField<T>& mask, const GridField<T>& start, T tolerance,
                                      int max_iterations) {
    using Field = GridField<T>;
    // start over its mean has the mean 1; corrections of mean 0 take u to one value on the set
    Field t = start / start.mean(), u = t;
    compliance.deflect(u);
    const Field flat = Field::Zero(mask.rows(), mask.cols());
    SetGradients<T> gradients(compliance, inverse, flat);
    gradients.start(points_of(mask), u);
    BondedContact<T> held;
    for (;; ++held.iterations) {
        const T level = gradients.level();  // of the start it may be below 0
        held.residual = level > T(0) ? gradients.scatter() / level : std::numeric_limits<T>::infinity();
        if (held.residual <= tolerance || held.iterations == max_iterations || !(gradients.step(t, u) > 0)) break;
    }
    held.compliance = (t * u).mean();  // twice the energy: least where u is one value, so that its error is a square
    return held;
}

/// Result for the points where \p mask is 1 (others 0), from the pressures \p start on them, not all 0.
template <Real T>
[[nodiscard]] BondedContact<T> bonded(SurfaceCompliance<T>& compliance, const GridField<T>& mask,
                                      const GridField<T>& start, T tolerance = T(1e-6), int max_iterations = 2000) {
    WaveFactors<float> inverse = compliance.inverse();
    return bonded(compliance, inverse, mask, start, tolerance, max_iterations);
}

/// The highest points of one map, held together at one share of the area after another.
template <Real T = double>
class HighestPoints {
public:
    /// \throws domain_error for missing points and as HeightMap::validate.
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

    /// K [Pa/m] of the points of \p share of the area; in proportion to it between whole numbers of points. Its error
    /// is the square of \p tolerance. \throws domain_error unless 0 < share < 1.
    [[nodiscard]] T stiffness(T share, T tolerance = T(1e-6)) const {
        require(share > 0 && share < 1, "share of the area", share, "greater than 0 and less than 1");
        const T points = share * static_cast<T>(order_.size());
        const auto count =
            static_cast<std::size_t>(std::clamp(std::round(points), T(1), static_cast<T>(order_.size() - 1)));
        GridField<T> mask = GridField<T>::Zero(rows_, static_cast<Eigen::Index>(order_.size()) / rows_);
        for (std::size_t i = 0; i < count; ++i) mask.data()[order_[i]] = 1;
        SurfaceCompliance<T> compliance = compliance_;
        return modulus_ / bonded<T>(compliance, mask, mask, tolerance).compliance * (points / T(count));
    }

private:
    T modulus_;
    Eigen::Index rows_;
    std::vector<Eigen::Index> order_;  ///< the highest first
    SurfaceCompliance<T> compliance_;
};

}}}  // namespace fstiff::detail
