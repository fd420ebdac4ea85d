// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The contact of a map's own summits that push each other down.
///
///     omega_i + sum_j G_ij F_j = z_i - delta,   F_i = (4/3) E sqrt(R_i) omega_i^(3/2),   p = sum F_i/A0
///     G_ij = sum over the images of j of 1/(pi E r)         j repeats or is mirrored at the edges of the map
///     d = delta + p C,   1/K = 1/K_delta - C,   C = int dA/(pi E r) over the cell of the images
///     K_delta = 1/A0 1^T (diag(1/(2 E a_i)) + G)^(-1) 1,   a_i = sqrt(R_i omega_i)
///
/// A force F lowers the surface at the distance r by F/(pi E r), itself and what it pushes down. The mean of that over the
/// cell lowers the mean plane, from which the separation is counted, and is taken away again: without this K is 0.3 of the
/// truth where hundreds of summits touch. Summits closer than the sum of their contact radii are one: the higher.
///
/// Reference   Afferrante, Carbone, Demelio, Wear 278-279 (2012) 28 (summits that interact and merge), here with images and
///             without the mean field; Ciavarella, Greenwood, Paggi, Wear 265 (2008) 729.
/// Units       SI
/// Valid       up to 1000 summits in contact, on 6 % of the area: p/(E g) of 0.03 or so, where K is 0.8 of the truth
/// Accuracy    K over boundary elements, three maps of 256 points a side (one of skewed heights), p/(E g) = 0.0003 to 0.01: 0.91 to
///             1.03, where summits that do not feel each other give 0.77 to 1.05 (tests/contact/mutual_summits_test.cpp); the
///             equations to 1e-10

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/quantity.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/halfspace/surface_compliance.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/topography/summits.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff {

/// The contact of the summits of one map, each of which sinks under the loads of all others.
template <Real T = double>
class MutualSummits : public SlopeContact<MutualSummits<T>, T> {
    using Values = Eigen::Array<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

public:
    /// \throws domain_error for no summits and a modulus that is not finite and positive.
    MutualSummits(Summits<T> of, std::type_identity_t<T> effective_modulus, Edges edges = Edges::mirrored)
        : of_(std::move(of)), modulus_(effective_modulus), edges_(edges) {
        require_positive("effective_modulus", effective_modulus);
        require_positive("rms_height", of_.rms_height);
        require(!of_.summits.empty(), "summits", of_.summits.size(), "at least 1");
        const T fold = edges == Edges::mirrored ? T(2) : T(1), a = fold * of_.width, b = fold * of_.height;
        require_positive("width", a);
        require_positive("height", b);
        mean_compliance_ = 2 * (a * std::asinh(b / a) + b * std::asinh(a / b)) / (numbers::pi_v<T> * modulus_);
    }

    /// \throws domain_error unless the pressure [Pa] is positive and at most as many summits carry it as Valid says.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity wanted = Quantity::all) const {
        require_positive("pressure", pressure);
        const Summit<T>& top = of_.summits.front();
        const T target = std::cbrt(pressure) * std::cbrt(pressure);
        const T single = std::cbrt(T(0.75) * pressure * of_.area / modulus_ / std::sqrt(top.radius()));
        T low = top.height - single * single;
        while (solve(low).load < pressure) low -= (std::max)(top.height - low, of_.rms_height * T(1e-9));
        const auto residual = [&](T delta) {
            const Solution s = solve(delta);
            const T root = (std::max)(std::cbrt(s.load), (std::numeric_limits<T>::min)());
            return std::pair(root * root - target, -2 * s.stiffness / (3 * root));
        };
        const auto found = newton_bracketed(residual, low, top.height, (low + top.height) / 2, tolerance());
        require(found.converged(), "pressure", pressure, "within the range of numbers for the scales of this map");
        ContactState<T> state = state_of(solve(found.root), found.root, found.error, wanted);
        state.pressure = {pressure, 0, state.pressure.evaluations};
        return state;
    }

    /// \throws domain_error for a separation at which no summit touches, and as at_pressure.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity wanted = Quantity::all) const {
        const T delta = delta_of(separation);
        ContactState<T> state = state_of(solve(delta), delta, tolerance(), wanted);
        state.separation.value = separation;
        state.eta = separation / of_.rms_height;
        return state;
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height. \throws domain_error as at_separation.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        const Solution s = solve(delta_of(eta * of_.rms_height));
        return {std::log(s.load), -stiffness_of(s) / s.load * of_.rms_height, T(1e-9)};
    }

    [[nodiscard]] T rms_height() const { return of_.rms_height; }
    /// Area that the summits stand on [m^2].
    [[nodiscard]] T area() const { return of_.area; }

private:
    static constexpr std::size_t max_summits = 1000;
    static constexpr T max_area = T(0.06);  ///< K is 0.8 of the truth there

    struct Solution {
        T load = 0, stiffness = 0, area = 0;  ///< p, K_delta, A/A0
        T count = 0;
    };

    [[nodiscard]] T tolerance() const { return T(1e-12) * of_.rms_height; }

    /// The delta of a separation: d grows with it until the contacts are too crowded.
    [[nodiscard]] T delta_of(T separation) const {
        const T top = of_.summits.front().height;
        if (!(separation < top))
            detail::refuse("separation", separation, "less than the height of the highest summit (m)");
        const auto residual = [&](T delta) {
            const Solution s = solve(delta);
            return std::pair(delta + s.load * mean_compliance_ - separation, 1 - s.stiffness * mean_compliance_);
        };
        T low = separation;
        for (T step = top - separation; residual(low).first > 0; step *= T(1.5)) low -= step;
        const auto found = newton_bracketed(residual, low, top, separation, tolerance());
        require(found.converged(), "separation", separation, "one at which the contacts are not too crowded");
        return found.root;
    }

    [[nodiscard]] T stiffness_of(const Solution& s) const {
        const T compliance = 1 / s.stiffness - mean_compliance_;
        if (!(s.area <= max_area && compliance > T(0.05) / s.stiffness))
            detail::refuse(
                "pressure", s.load,
                "so small that the summits are not too crowded to be told apart (hybrid and boundary_elements "
                "go on)");
        return 1 / compliance;
    }

    [[nodiscard]] ContactState<T> state_of(const Solution& s, T delta, T error, Quantity wanted) const {
        const T K = stiffness_of(s), relative = T(1e-9) + error * s.stiffness / s.load;
        const auto given = [&](Quantity quantity, T value) {
            return has(wanted, quantity) ? Estimate<T>{value, relative * value, static_cast<int>(s.count)}
                                         : Estimate<T>{};
        };
        ContactState<T> state;
        state.separation = {delta + s.load * mean_compliance_, error, 0};
        state.eta = state.separation.value / of_.rms_height;
        state.pressure = given(Quantity::pressure, s.load);
        state.stiffness = given(Quantity::stiffness, K);
        state.loading_stiffness = given(Quantity::loading_stiffness, K);
        state.real_area_fraction = given(Quantity::real_area, s.area);
        state.contact_density = given(Quantity::contacts, s.count / of_.area);
        return state;
    }

    /// What a unit force on \p from lowers \p at by, through all images of it [m/N].
    [[nodiscard]] T influence(const Summit<T>& at, const Summit<T>& from, bool itself) const {
        const bool mirrored = edges_ == Edges::mirrored;
        const T width = mirrored ? 2 * of_.width : of_.width, height = mirrored ? 2 * of_.height : of_.height;
        T sum = 0;
        for (int image = itself ? 1 : 0; image < (mirrored ? 4 : 1); ++image) {
            const T x = image % 2 == 1 ? width - from.x : from.x, y = image > 1 ? height - from.y : from.y;
            const T r = std::hypot(std::remainder(at.x - x, width), std::remainder(at.y - y, height));
            sum += 1 / (std::max)(r, (of_.width + of_.height) * T(1e-3));  // not on itself at an edge
        }
        return sum / (numbers::pi_v<T> * modulus_);
    }

    /// Summits above \p delta; of two closer than their contact radii the higher.
    [[nodiscard]] std::vector<Summit<T>> touching(T delta) const {
        std::vector<Summit<T>> kept;
        for (const Summit<T>& one : of_.summits) {
            if (!(one.height > delta)) break;
            const T radius = std::sqrt(one.radius() * (one.height - delta));
            const bool merged = std::any_of(kept.begin(), kept.end(), [&](const Summit<T>& other) {
                return std::hypot(one.x - other.x, one.y - other.y) <
                       radius + std::sqrt(other.radius() * (other.height - delta));
            });
            if (!merged) kept.push_back(one);
        }
        require(kept.size() <= max_summits, "summits in contact", kept.size(),
                "at most 1000 that push each other down (hybrid and boundary_elements go on)");
        return kept;
    }

    /// Gauss and Seidel's method for the forces, then conjugate gradients for the stiffness.
    [[nodiscard]] Solution solve(T delta) const {
        const std::vector<Summit<T>> on = touching(delta);
        const auto n = std::ssize(on);
        if (n == 0) return {};
        Matrix influences(n, n);
        Values force = Values::Zero(n), omega = Values::Zero(n), unit(n);  // F = unit omega^(3/2)
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto& one = on[static_cast<std::size_t>(i)];
            unit[i] = T(4) / 3 * modulus_ * std::sqrt(one.radius());
            for (Eigen::Index j = 0; j <= i; ++j)
                influences(i, j) = influences(j, i) = influence(one, on[static_cast<std::size_t>(j)], i == j);
        }
        for (int sweep = 0; sweep < 300; ++sweep) {
            T change = 0;
            for (Eigen::Index i = 0; i < n; ++i) {
                const T self = influences(i, i) * unit[i];
                const T free = on[static_cast<std::size_t>(i)].height - delta -
                               influences.col(i).dot(force.matrix()) + influences(i, i) * force[i];
                T w = (std::max)(omega[i], T(0));
                if (!(free > 0)) {
                    w = 0;
                } else {  // w + self w^(3/2) = free, convex and rising: from above Newton's method cannot miss
                    w = free;
                    for (int k = 0; k < 20; ++k) {
                        const T root = std::sqrt(w), step = (w + self * w * root - free) / (1 + T(1.5) * self * root);
                        w = (std::max)(w - step, T(0));
                        if (std::abs(step) <= 4 * std::numeric_limits<T>::epsilon() * w) break;
                    }
                }
                const T f = unit[i] * w * std::sqrt(w);
                change = (std::max)(change, std::abs(f - force[i]));
                omega[i] = w;
                force[i] = f;
            }
            if (change <= T(1e-12) * force.maxCoeff()) break;
        }
        Solution s;
        s.load = force.sum() / of_.area;
        s.count = static_cast<T>((force > T(0)).count());
        for (Eigen::Index i = 0; i < n; ++i) s.area += on[static_cast<std::size_t>(i)].radius() * omega[i];
        s.area *= numbers::pi_v<T> / of_.area;
        s.stiffness = response(influences, unit, omega) / of_.area;
        return s;
    }

    /// 1^T (diag(1/k) + G)^(-1) 1 over the summits that carry, k = (3/2) unit sqrt(omega).
    [[nodiscard]] static T response(const Matrix& influences, const Values& unit, const Values& omega) {
        const Values k = T(1.5) * unit * omega.sqrt();
        // x = k y: (1 + k G) k-symmetrised, so that rows that carry nothing drop out
        const Values root = k.sqrt();
        Values y = Values::Zero(k.size()), rest = root, direction = rest;
        T norm = rest.square().sum();
        const T end = norm * T(1e-24);
        for (int i = 0; i < 400 && norm > end; ++i) {
            const Values image = direction + root * (influences * (root * direction).matrix()).array();
            const T along = norm / (direction * image).sum();
            y += along * direction;
            rest -= along * image;
            const T next = rest.square().sum();
            direction = rest + next / norm * direction;
            norm = next;
        }
        return (root * y).sum();
    }

    Summits<T> of_;
    T modulus_, mean_compliance_{};
    Edges edges_;
};

}  // namespace fstiff
