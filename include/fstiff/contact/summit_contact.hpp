// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of the summits of a map: a sum over them in place of the integral over a distribution.
///
///     p = E/A0 sum c_i (z_i - d)^(3/2)         K = E/A0 sum (3/2) c_i (z_i - d)^(1/2)
///     A/A0 = 1/A0 sum pi a b                   n = number of z_i > d, over A0
///
/// c_i = (4/3) (k1 k2)^(-1/4) F2^(-3/2) of the principal curvatures of each summit, a b of its ellipse
/// (asperity/elliptic_hertz.hpp). Neighbours do not push each other down: contact/mutual_summits.hpp adds it.
///
/// Reference   Greenwood, Tripp, Proc. Inst. Mech. Eng. 185 (1970) 625; Johnson, Contact Mechanics (1985), eq. (4.26)
/// Units       SI
/// Valid       separations below the highest summit; pressures > 0
/// Accuracy    sums 1e-14 (tests/contact/summit_contact_test.cpp)

#include <fstiff/asperity/elliptic_hertz.hpp>
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/topography/summits.hpp>

#include <iterator>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// The same summits with the factors of their ellipses, so that many contacts of them, and of what is resampled from
/// them, need not find these again. \throws domain_error for curvatures that are not positive.
template <Real T>
[[nodiscard]] Summits<T> with_hertz_factors(Summits<T> summits) {
    for (Summit<T>& summit : summits.summits) {
        const EllipticHertz<T> hertz = elliptic_hertz(summit.max_curvature, summit.min_curvature);
        summit.load_factor = hertz.load_factor, summit.area_factor = hertz.area_factor;
    }
    return summits;
}

}  // namespace detail

/// The contact of the summits of one map, each by itself: ellipses of Hertz.
template <Real T = double>
class SummitContact : public detail::SlopeContact<SummitContact<T>, T> {
    using Values = Eigen::Map<const Eigen::Array<T, Eigen::Dynamic, 1>>;

public:
    /// \throws domain_error for no summits and a modulus that is not finite and positive.
    SummitContact(const Summits<T>& summits, std::type_identity_t<T> effective_modulus)
        : modulus_(effective_modulus), area_(summits.area), rms_height_(summits.rms_height) {
        detail::require_positive("effective_modulus", effective_modulus);
        detail::require_positive("rms_height", summits.rms_height);
        detail::require(!summits.summits.empty(), "summits", summits.summits.size(), "at least 1");
        for (const Summit<T>& summit : summits.summits) {
            height_.push_back(summit.height);
            const bool known = summit.load_factor > 0;
            const auto hertz = known ? detail::EllipticHertz<T>{summit.load_factor, summit.area_factor, T(0)}
                                     : detail::elliptic_hertz(summit.max_curvature, summit.min_curvature);
            load_factor_.push_back(hertz.load_factor);
            area_factor_.push_back(hertz.area_factor);
        }
    }

    /// \throws domain_error for a separation at which no summit touches.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        if (!(separation < height_[0]))
            detail::refuse("separation", separation, "less than the height of the highest summit (m)");
        return state(separation, 0, quantities);
    }

    /// \throws domain_error unless the pressure [Pa] is finite and positive.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        detail::require_positive("pressure", pressure);
        // p^(2/3) is nearly linear in d
        const T target = std::cbrt(pressure) * std::cbrt(pressure), top = height_[0];
        const T single = std::cbrt(pressure * area_ / modulus_ / load_factor_[0]);
        T low = top - single * single;  // the highest alone would carry it there, so that all together do
        const auto residual = [&](T d) {
            const Sums j = sums(d);
            const T root = std::cbrt(j.load);
            return std::pair(root * root - target,
                             -2 * j.stiffness / (3 * (std::max)(root, (std::numeric_limits<T>::min)())));
        };
        const auto solution =
            math::newton_bracketed(residual, low - std::abs(top - low) * T(1e-9), top, low,
                                   4 * std::numeric_limits<T>::epsilon() * (std::abs(top) + rms_height_));
        detail::require(solution.converged(), "pressure", pressure,
                        "within the range of numbers for the scales of this map");
        ContactState<T> result = state(solution.root, solution.error, quantities);
        result.pressure = {pressure, 0, static_cast<int>(result.pressure.evaluations)};
        return result;
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height. \throws domain_error as at_separation.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        if (!(eta * rms_height_ < height_[0]))
            detail::refuse("eta", eta, "less than the height of the highest summit over the rms height");
        const Sums j = sums(eta * rms_height_);
        return {std::log(j.load), -j.stiffness / j.load * rms_height_, rounding};
    }

    [[nodiscard]] T rms_height() const { return rms_height_; }
    /// K has a kink wherever another summit touches.
    [[nodiscard]] static constexpr bool has_kinks() { return true; }
    [[nodiscard]] Eigen::Index summits() const { return std::ssize(height_); }
    /// Nominal area of the summits [m^2].
    [[nodiscard]] T area() const { return area_; }

private:
    static constexpr T rounding = 64 * std::numeric_limits<T>::epsilon();

    struct Sums {
        T load, stiffness, area, count;
    };

    [[nodiscard]] Sums sums(T d) const {
        const auto touching = std::partition_point(height_.begin(), height_.end(), [d](T z) { return z > d; });
        const auto n = static_cast<Eigen::Index>(touching - height_.begin());
        if (n == 0) return {0, 0, 0, 0};
        const Eigen::Array<T, Eigen::Dynamic, 1> omega = Values(height_.data(), n) - d;
        const Eigen::Array<T, Eigen::Dynamic, 1> slope = Values(load_factor_.data(), n) * omega.sqrt();
        const T per_area = 1 / area_;
        return {modulus_ * per_area * (slope * omega).sum(), T(1.5) * modulus_ * per_area * slope.sum(),
                per_area * (Values(area_factor_.data(), n) * omega).sum(), per_area * T(n)};
    }

    [[nodiscard]] ContactState<T> state(T d, T error, Quantity quantities) const {
        const Sums j = sums(d);
        const T relative = rounding + error * j.stiffness / j.load;
        const auto given = [&](Quantity quantity, T value) {
            return detail::has(quantities, quantity)
                       ? Estimate<T>{value, relative * value, static_cast<int>(height_.size())}
                       : Estimate<T>{};
        };
        ContactState<T> result;
        result.eta = d / rms_height_;
        result.separation = {d, error, 0};
        result.pressure = given(Quantity::pressure, j.load);
        result.stiffness = given(Quantity::stiffness, j.stiffness);
        result.loading_stiffness = given(Quantity::loading_stiffness, j.stiffness);
        result.real_area_fraction = given(Quantity::real_area_fraction, j.area);
        result.contact_density = given(Quantity::contact_density, j.count);
        return result;
    }

    T modulus_, area_, rms_height_;
    std::vector<T> height_, load_factor_, area_factor_;  ///< the highest first
};

}}  // namespace fstiff
