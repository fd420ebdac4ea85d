// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Crowded contacts with any bearing curve: Persson's theory at the local scale of the curve where the faces touch.
///
///     K(p) = K_g(p/rho)      A/A0 = A_g(p/rho)      n = n_g(p/rho)      d = int_p dp'/K
///     rho = s(c, w)/sigma    c = d_g(p/rho)/sigma + 0.2 - 0.3 P    w = sqrt(1/4 + P^2)    P = erf(sqrt(2) p/(rho E g))
///
/// g marks the Gaussian surface of the same order of heights, sigma its rms height, s the slope of the bearing curve
/// about the level c. rho is a fixed point, found anew at each pressure in 10 us; without a bearing curve the contact
/// is PerssonContact to the last bit. ScaledContact takes any Gaussian contact at that rho.
///
/// Reference   Persson, Phys. Rev. Lett. 99 (2007) 125502; the scale and its numbers: this project, docs/validation.md
/// Units       SI: m, Pa, Pa/m
/// Valid       pressures as the Gaussian contact at p/rho; K rises with p but for steps of the heights by several sigma
/// Accuracy    rho 1e-6, K 2e-5, separation 1e-5 of the rms height, of ScaledContact 1e-4
///             (tests/contact/bearing_contact_test.cpp, tests/contact/scaled_contact_test.cpp)

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/math/quadrature.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <memory>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// d_g/sigma of Persson's contact over ln p, by cubics between knots, up to 2 E g and down to where it is \p furthest.
template <Real T>
class PerssonSeparation {
public:
    PerssonSeparation(const PerssonContact<T>& contact, T rms_height, T furthest)
        : last_(std::log(2 * contact.effective_modulus() * contact.rms_gradient())) {
        const auto& rule = math::GaussLegendre<T, 4>::get();
        const auto rise = [&](T places) {  // the slope of d times width
            const T p = std::exp(last_ - width * places);
            return width * p / contact.stiffness(p) / rms_height;
        };
        T d = contact.separation(std::exp(last_)).value / rms_height;
        for (std::size_t k = 0;; ++k) {
            if (k == knots_.size()) knots_.push_back({T(0), rise(T(k))});
            knots_[k].d = d;
            if (d > furthest) {
                knots_.resize(k + 1);
                return;
            }
            if (k < by_points) {
                for (std::size_t i = 0; i < 4; ++i) d += rule.weight[i] / 2 * rise(T(k) + (1 + rule.node[i]) / 2);
                continue;
            }
            while (knots_.size() < k + 4) knots_.push_back({T(0), rise(T(knots_.size()))});
            const auto two = [&](std::size_t below, std::size_t above) {
                return knots_[below].rise + knots_[above].rise;
            };
            d += (802 * two(k, k + 1) - 93 * two(k - 1, k + 2) + 11 * two(k - 2, k + 3)) / 1440;
        }
    }
    /// Constant beyond both ends.
    [[nodiscard]] T operator()(T pressure) const {
        const T place = std::clamp((last_ - std::log(pressure)) / width, T(0), T(knots_.size() - 1));
        const std::size_t i = (std::min)(static_cast<std::size_t>(place), knots_.size() - 2);
        const T t = place - T(i), rise = knots_[i + 1].d - knots_[i].d, left = knots_[i].rise,
                right = knots_[i + 1].rise;
        return knots_[i].d + t * (left + t * (3 * rise - 2 * left - right + t * (left + right - 2 * rise)));
    }

private:
    static constexpr T width = T(1) / 8;  ///< of ln p
    /// Knot of p = E g/24: below it the slope varies so slowly that six of its values at knots are enough.
    static constexpr std::size_t by_points = 31;
    struct Knot {
        T d, rise;  ///< rise: slope times width, towards lower pressures
    };
    T last_;
    std::vector<Knot> knots_;
};

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// The dense contact of a surface with a bearing curve, or without one.
template <Real T = double>
class MaterialRatioContact : public detail::SlopeContact<MaterialRatioContact<T>, T> {
public:
    /// Contact of a Gaussian surface: Persson's.
    MaterialRatioContact(PerssonContact<T> gaussian)  // NOLINT(google-explicit-constructor): one is the other
        : gaussian_(std::move(gaussian)), rms_height_(gaussian_.rms_height()) {}

    /// Contact of the surface f(zeta) = \p curve with the rms height \p rms_height [m]: \p gaussian is that of
    /// rms_height zeta. \throws domain_error unless \p rms_height is finite and positive.
    MaterialRatioContact(PerssonContact<T> gaussian, MaterialRatioSlope<T> curve, std::type_identity_t<T> rms_height)
        : gaussian_(std::move(gaussian)), rms_height_(rms_height) {
        detail::require_positive("rms_height", rms_height);
        const T furthest = (std::min)(curve.highest(), T(6)) + 1;  // at 7 sigma p is 1e-12 E g
        set_curve(std::move(curve), detail::PerssonSeparation<T>(gaussian_, rms_height, furthest), rms_height);
    }

    /// Contact of another surface with the same Gaussian one, in a tenth of the time. Its curve \p curve must end as
    /// high, and this contact must not be scaled. \throws domain_error unless this one has a bearing curve.
    [[nodiscard]] MaterialRatioContact with_curve(MaterialRatioSlope<T> curve) const {
        detail::require(has_bearing_curve(), "bearing curve", has_bearing_curve(), "there");
        MaterialRatioContact other = *this;
        other.set_curve(std::move(curve), bearing_->separation, bearing_->rms_height);
        return other;
    }

    /// The contact of a surface \p factor times as high: K under p is that of this one under p/factor.
    /// \throws domain_error unless it is finite and positive.
    [[nodiscard]] MaterialRatioContact scaled(T factor) const {
        detail::require_positive("factor of the heights", factor);
        MaterialRatioContact taller = *this;
        taller.factor_ *= factor, taller.rms_height_ *= factor, taller.last_scale_ *= factor;
        taller.panels_ = detail::Panels<T>(panels);
        return taller;
    }

    /// The same contact with eta over \p rms_height [m]: of several maps of one surface, over that of all.
    /// \throws domain_error unless it is finite and positive.
    [[nodiscard]] MaterialRatioContact over_rms_height(T rms_height) const {
        detail::require_positive("rms_height", rms_height);
        MaterialRatioContact other = *this;
        other.rms_height_ = rms_height;
        return other;
    }

    /// K [Pa/m] under \p pressure [Pa]. \throws domain_error as PerssonContact at p/rho.
    [[nodiscard]] T stiffness(T pressure) const { return gaussian_.stiffness(pressure / local_scale(pressure)); }

    /// K [Pa/m] and dK/dp [1/m]: by the chain rule, with d rho/dp as the difference between pressures 1.5 % below and
    /// above. \throws domain_error as stiffness.
    [[nodiscard]] detail::PerssonStiffness<T> stiffness_and_slope(T pressure) const {
        if (is_plain()) return gaussian_.stiffness_and_slope(pressure);
        const T rho = local_scale(pressure), apart = T(1) / 64;
        const T change =
            std::log(local_scale(pressure * (1 + apart)) / local_scale(pressure * (1 - apart))) / (2 * apart);
        const detail::PerssonStiffness<T> unscaled = gaussian_.stiffness_and_slope(pressure / rho);
        return {unscaled.stiffness, unscaled.slope * (1 - change) / rho};
    }

    /// rho under \p pressure [Pa]: at p/rho the Gaussian surface is in the same state.
    /// \throws domain_error unless it is positive.
    [[nodiscard]] T local_scale(T pressure) const {
        detail::require_positive("pressure", pressure);
        if (!bearing_) return factor_;
        const auto missing = [&](T log_rho) {  // of ln rho; falls as it rises
            const T p = pressure / factor_ * std::exp(-log_rho), P = gaussian_.real_area_fraction(p);
            const T center = bearing_->separation(p) + T(0.2) - T(0.3) * P, width = std::sqrt(T(0.25) + P * P);
            return std::log(bearing_->curve.slope(center, width) / bearing_->rms_height) - log_rho;
        };
        T log_rho = 0;
        for (int round = 0; round < 16; ++round) {  // every other one to where a geometric series would end (Aitken)
            const T first = missing(log_rho) / 2;
            log_rho += first;
            if (std::abs(first) < scale_tolerance) return factor_ * std::exp(log_rho);
            const T second = missing(log_rho) / 2, ratio = second / first;
            log_rho += std::abs(ratio) < T(0.9) ? second / (1 - ratio) : second;
        }
        T low = -60, high = 60;  // of a curve with a step, over which the rounds leap to and fro
        while (high - low > scale_tolerance) {
            log_rho = (low + high) / 2;
            (missing(log_rho) > T(0) ? low : high) = log_rho;
        }
        return factor_ * std::exp(log_rho);
    }

    /// The contact under the nominal pressure \p pressure [Pa]. \throws domain_error as stiffness.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        if (is_plain()) return gaussian_.at_pressure(pressure, quantities);
        ContactState<T> state =
            gaussian_.at_pressure(pressure / local_scale(pressure), detail::without(quantities, Quantity::separation));
        for (Estimate<T>* e : {&state.stiffness, &state.loading_stiffness, &state.real_area_fraction})
            e->error += 3 * scale_tolerance * e->value;
        state.pressure = {pressure, 0, 0};
        state.separation = detail::has(quantities, Quantity::separation) ? separation(pressure) : Estimate<T>{};
        state.eta = state.separation.value / rms_height_;
        return state;
    }

    /// The contact at the separation \p separation [m] of the mean planes.
    /// \throws domain_error unless it is positive and its pressure within reach.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        return is_plain() ? gaussian_.at_separation(separation, quantities)
                          : detail::SlopeContact<MaterialRatioContact<T>, T>::at_separation(separation, quantities);
    }

    /// The separation of the mean planes under \p pressure [Pa]: the integral of 1/K up to full_pressure(), and that of
    /// the Gaussian surface beyond. \throws domain_error as stiffness.
    [[nodiscard]] Estimate<T> separation(T pressure) const {
        if (is_plain()) return gaussian_.separation(pressure);
        const T full = full_pressure(), rho = last_scale_;
        if (pressure >= full)
            return {rho * gaussian_.separation(pressure / rho).value, error_of_separation * rms_height_, 0};
        T d = rho * gaussian_.separation(full / rho).value;
        const T from = std::log(pressure), to = std::log(full);
        const auto count = static_cast<int>((to - from) * 4);  // at the same places for every pressure
        for (int i = 1; i <= count; ++i)
            d += panels_.at(static_cast<std::size_t>(i - 1),
                            [&] { return this->template fall_of_separation<4>(to - T(i) / 4, T(1) / 4); });
        d += this->template fall_of_separation<4>(from, to - T(count) / 4 - from);
        return {d, error_of_separation * (d + rms_height_), 4 * (count + 1)};
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless the pressure of \p eta is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        if (is_plain()) return gaussian_.log_pressure(eta);
        detail::require(eta > 0 && std::isfinite(eta), "eta", eta,
                        "finite and greater than 0 (separation over rms height)");
        const T most = std::log(largest_pressure());
        return this->searched_log_pressure(eta, most + std::log(std::numeric_limits<T>::epsilon()) - 60, most,
                                           std::log(full_pressure()) - T(1.5) - 2 * eta,
                                           "within the reach of the model: pressures up to 18 E g");
    }

    [[nodiscard]] T rms_height() const { return rms_height_; }
    /// g of the Gaussian surface.
    [[nodiscard]] T rms_gradient() const { return gaussian_.rms_gradient() * factor_; }
    [[nodiscard]] T effective_modulus() const { return gaussian_.effective_modulus(); }
    [[nodiscard]] bool has_bearing_curve() const { return bearing_ != nullptr; }
    /// The bearing curve is one of straight lines.
    [[nodiscard]] bool has_kinks() const { return has_bearing_curve(); }
    [[nodiscard]] const PerssonContact<T>& gaussian() const { return gaussian_; }
    /// 2 rho E g [Pa], where all is in contact.
    [[nodiscard]] T full_pressure() const { return 2 * effective_modulus() * gaussian_.rms_gradient() * last_scale_; }
    /// \throws domain_error unless \p pressure [Pa] is positive and the Gaussian surface was compared at p/rho.
    void require_compared(T pressure) const { gaussian_.require_compared(pressure / local_scale(pressure)); }
    /// Pressure beyond which there is no state [Pa].
    [[nodiscard]] T largest_pressure() const { return gaussian_.largest_pressure() * last_scale_; }

private:
    static constexpr T scale_tolerance = (std::max)(T(1e-9), 16 * std::numeric_limits<T>::epsilon());
    static constexpr T error_of_separation = T(1e-5);
    static constexpr std::size_t panels = 160;  ///< of a quarter of an e-fold

    [[nodiscard]] bool is_plain() const {
        return !bearing_ && factor_ == T(1) && rms_height_ == gaussian_.rms_height();
    }

    struct Bearing {
        MaterialRatioSlope<T> curve;
        detail::PerssonSeparation<T> separation;
        T rms_height;  ///< of the curve [m]
    };

    void set_curve(MaterialRatioSlope<T> curve, detail::PerssonSeparation<T> separation, T rms_height) {
        last_scale_ = curve.slope(T(-0.1), std::sqrt(T(1.25))) / rms_height;  // all in contact: P = 1, d = 0
        bearing_ = std::make_shared<const Bearing>(Bearing{std::move(curve), std::move(separation), rms_height});
        panels_ = detail::Panels<T>(panels);
    }

    PerssonContact<T> gaussian_;
    T rms_height_, factor_ = 1;               ///< [m]; heights over those of the curve
    T last_scale_ = 1;                        ///< rho where all is in contact
    std::shared_ptr<const Bearing> bearing_;  ///< none of a Gaussian surface; copies share it
    detail::Panels<T> panels_{0};             ///< of the separation
};

/// Contact of a surface whose heights are not Gaussian. \p C is the contact of the Gaussian surface: HybridContact of
/// its peaks and its spectrum.
template <Real T, Contact<T> C>
class ScaledContact : public detail::SlopeContact<ScaledContact<T, C>, T> {
public:
    ScaledContact(C g, MaterialRatioContact<T> bearing) : gaussian_(std::move(g)), bearing_(std::move(bearing)) {}

    /// The contact under the nominal pressure \p pressure [Pa]. \throws domain_error as \p C at p/rho.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        ContactState<T> state = gaussian_.at_pressure(pressure / bearing_.local_scale(pressure),
                                                      detail::without(quantities, Quantity::separation));
        state.pressure = {pressure, 0, 0};
        state.separation = detail::has(quantities, Quantity::separation) ? separation(pressure) : Estimate<T>{};
        state.eta = state.separation.value / rms_height();
        return state;
    }
    /// K [Pa/m] under \p pressure [Pa]. \throws domain_error as at_pressure.
    [[nodiscard]] T stiffness(T pressure) const {
        const T scaled = pressure / bearing_.local_scale(pressure);
        if constexpr (requires { gaussian_.stiffness(scaled); })  // beyond what was compared too
            return gaussian_.stiffness(scaled);
        else
            return gaussian_.at_pressure(scaled, Quantity::stiffness).stiffness.value;
    }
    /// Separation [m] of the mean planes; 0 from the full pressure on. \throws domain_error as at_pressure.
    [[nodiscard]] Estimate<T> separation(T pressure) const {
        detail::require_positive("pressure", pressure);
        const T to = std::log(full_pressure()), from = std::log(pressure);
        const T error = T(1e-4) * rms_height();
        if (from >= to) return {T(0), error, 0};
        const auto count = static_cast<int>((to - from) * 2);  // at the same places for every pressure
        T d = this->template fall_of_separation<8>(from, to - T(count) / 2 - from);
        for (int i = 1; i <= count; ++i)
            d += panels_.at(static_cast<std::size_t>(i - 1),
                            [&] { return this->template fall_of_separation<8>(to - T(i) / 2, T(1) / 2); });
        return {d, error, 8 * (count + 1)};
    }
    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless 0 < eta and its pressure is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        detail::require(eta > 0 && std::isfinite(eta), "eta", eta,
                        "finite and greater than 0 (separation over rms height)");
        const T high = std::log(full_pressure());
        return this->searched_log_pressure(eta, high - 60, high, high - T(1.5) - 2 * eta,
                                           "within the reach of the laws");
    }

    [[nodiscard]] T full_pressure() const { return bearing_.full_pressure(); }
    [[nodiscard]] T rms_height() const { return bearing_.rms_height(); }
    [[nodiscard]] bool has_kinks() const { return detail::has_kinks(gaussian_) || bearing_.has_kinks(); }
    [[nodiscard]] const C& gaussian() const { return gaussian_; }
    [[nodiscard]] const MaterialRatioContact<T>& bearing() const { return bearing_; }

private:
    C gaussian_;
    MaterialRatioContact<T> bearing_;
    detail::Panels<T> panels_{80};  ///< of the separation, of half an e-fold
};

template <class C, class Bearing>
ScaledContact(C, Bearing) -> ScaledContact<std::remove_cvref_t<decltype(std::declval<C>().rms_height())>, C>;

}}  // namespace fstiff
