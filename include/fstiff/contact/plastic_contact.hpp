// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of a surface whose peaks have flowed at the hardness H, and its stiffness on unloading, as a wave sees it.
///
///     K    = (K_cut^1.9 + K_elastic^1.9)^(1/1.9)            at equal pressure, K_cut at the share p/H
///     A/A0 = p sqrt(1/H^2 + 4/(E g)^2)                      g at the local scale of a bearing curve
///     p(d) = (p_cut^-1.3 + p_elastic^-1.3)^(-1/1.3)         p_cut = H times the share of the surface above d
///
/// The number of contacts is not available: it is 0. Derivation: docs/theory.md, section 10.
/// Reference   this project, docs/validation.md; Pullen, Williamson, Proc. R. Soc. A 327 (1972) 159; Cooper, Mikic,
///             Yovanovich, Int. J. Heat Mass Transf. 12 (1969) 279
/// Units       SI
/// Valid       0 < p < H. Compared for p/H from 0.003 to 0.1, H/(E g) from 0.02 to 0.5
/// Accuracy    p(d) 1e-10 of the rms height; K of a map within 15 % of boundary elements at 138 of 140 points, of
///             numbers at 115 (tests/contact/plastic_contact_map_test.cpp)

#include <fstiff/contact/contact_concept.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/halfspace/held_contact.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/surface/bearing_slope.hpp>
#include <fstiff/topography/height_map.hpp>

#include <atomic>
#include <memory>

namespace fstiff::inline v0_1 {

namespace parts {

/// The highest parts of a surface as a flat cuts them: K of a share of the area [Pa/m], and the share above a level [m]
/// over the mean plane with its change [1/m].
template <class C, class T>
concept CutSurface = requires(const C& cut, T x) {
    { cut.stiffness(x) } -> std::convertible_to<T>;
    { cut.share_above(x) } -> std::convertible_to<std::pair<T, T>>;
};

/// K [Pa/m] of the cut and of the elastic contact together: (a^1.9 + b^1.9)^(1/1.9), without overflow.
template <Real T>
[[nodiscard]] T plastic_stiffness(T cut, T elastic) {
    constexpr T n = T(1.9);
    const T most = (std::max)(cut, elastic);
    return most * std::exp(std::log1p(std::pow((std::min)(cut, elastic) / most, n)) / n);
}

/// Logarithm of the pressure on first loading, of those of the elastic contact and of the cut at one separation:
/// log((p_elastic^-1.3 + p_cut^-1.3)^(-1/1.3)), from the lesser of the two.
template <Real T>
[[nodiscard]] T plastic_log_pressure(T elastic, T cut) {
    constexpr T n = T(1.3);
    return (std::min)(elastic, cut) - std::log1p(std::exp(-std::abs(n * (elastic - cut)))) / n;
}

/// Cut of a Gaussian surface.
template <Real T = double>
class GaussianCut {
public:
    /// \throws domain_error unless all are finite and positive.
    GaussianCut(T rms_height, T rms_gradient, T effective_modulus)
        : rms_height_(rms_height), stiffness_(T(0.68) * effective_modulus * rms_gradient / rms_height) {
        require_positive("rms_height", rms_height);
        require_positive("rms_gradient", rms_gradient);
        require_positive("effective_modulus", effective_modulus);
    }
    [[nodiscard]] T stiffness(T share) const { return stiffness_ * share; }
    [[nodiscard]] std::pair<T, T> share_above(T level) const {
        const T z = level / rms_height_;
        return {math::normal_share(-z), -math::normal_density(z) / rms_height_};
    }

private:
    T rms_height_, stiffness_;
};

/// K of the highest points of a map at numbers of points that are 5 % apart, each computed when it is first asked for.
/// Threads that ask at once compute the same number.
template <Real T>
class CutKnots {
public:
    explicit CutKnots(HighestPoints<T> points) : points_(std::move(points)) {
        const std::size_t all = points_.count();
        for (std::size_t n = 1; n < all; n = (std::max)(n + 1, static_cast<std::size_t>(T(1.05) * static_cast<T>(n))))
            counts_.push_back(n);
        log_stiffness_ = std::vector<std::atomic<T>>(counts_.size());
        for (auto& at : log_stiffness_) at.store(std::numeric_limits<T>::quiet_NaN(), std::memory_order_relaxed);
    }
    /// K by a power of the share between two knots. \throws domain_error as HighestPoints.
    [[nodiscard]] T stiffness(T share) const {
        const T points = share * static_cast<T>(points_.count());
        if (!(points > 1 && share < 1) || counts_.size() < 2) return points_.stiffness(share);
        const auto above = std::partition_point(counts_.begin() + 1, counts_.end() - 1,
                                                [points](std::size_t n) { return static_cast<T>(n) < points; });
        const auto i = static_cast<std::size_t>(above - counts_.begin());
        const T from = std::log(static_cast<T>(counts_[i - 1])), to = std::log(static_cast<T>(counts_[i]));
        const T a = log_at(i - 1), b = log_at(i);
        return std::exp(a + (std::log(points) - from) / (to - from) * (b - a));
    }

private:
    [[nodiscard]] T log_at(std::size_t knot) const {
        T known = log_stiffness_[knot].load(std::memory_order_relaxed);
        if (std::isnan(known)) {
            known = std::log(points_.stiffness(static_cast<T>(counts_[knot]) / static_cast<T>(points_.count())));
            log_stiffness_[knot].store(known, std::memory_order_relaxed);
        }
        return known;
    }

    HighestPoints<T> points_;
    std::vector<std::size_t> counts_;
    mutable std::vector<std::atomic<T>> log_stiffness_;  ///< NaN: not yet
};

/// Cut of a map, K by knots 5 % of the share apart, so that it is continuous. Copies share the computed numbers.
template <Real T = double>
class MapCut {
public:
    /// \throws domain_error as HighestPoints.
    MapCut(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus, Edges edges)
        : knots_(std::make_shared<const parts::CutKnots<T>>(HighestPoints<T>(map, effective_modulus, edges))),
          curve_(std::make_shared<const BearingSlope<T>>(BearingSlope<T>::of_heights(
              std::span<const T>(map.heights.data(), static_cast<std::size_t>(map.heights.size()))))),
          mean_(mean_height(map)) {}

    /// Cut of a map \p factor times as high: the same points.
    [[nodiscard]] MapCut scaled(T factor) const {
        MapCut taller = *this;
        taller.factor_ *= factor;
        return taller;
    }
    [[nodiscard]] T stiffness(T share) const { return knots_->stiffness(share); }
    /// Share by straight lines of the bearing curve; that of the highest knot beyond it.
    [[nodiscard]] std::pair<T, T> share_above(T level) const {
        const auto knots = curve_->knots();
        const T height = level / factor_ + mean_;
        const auto above = std::partition_point(knots.begin() + 1, knots.end() - 1,
                                                [&](const auto& knot) { return knot.height < height; });
        const auto &a = *(above - 1), &b = *above;
        const T per_height = (b.score - a.score) / (b.height - a.height);
        const T score = a.score + (height - a.height) * per_height;
        return {math::normal_share(-score), -math::normal_density(score) * per_height / factor_};
    }

private:
    std::shared_ptr<const parts::CutKnots<T>> knots_;
    std::shared_ptr<const BearingSlope<T>> curve_;
    T mean_, factor_ = 1;  ///< mean height [m]; heights over those of the map
};

}  // namespace parts

/// \p Elastic is the contact of the same surface without flow, at light and heavy loads, which gives K and the
/// separation under a pressure beyond what was compared too: HybridContact.
template <Real T, Contact<T> Elastic, parts::CutSurface<T> Cut>
class PlasticContact : private detail::SlopeContact<PlasticContact<T, Elastic, Cut>, T> {
    using Base = detail::SlopeContact<PlasticContact<T, Elastic, Cut>, T>;
    friend Base;

public:
    /// \throws domain_error unless hardness [Pa], modulus [Pa] and gradient are finite and positive.
    PlasticContact(Elastic elastic, Cut cut, std::type_identity_t<T> hardness,
                   std::type_identity_t<T> effective_modulus, std::type_identity_t<T> rms_gradient)
        : elastic_(std::move(elastic)), cut_(std::move(cut)), hardness_(hardness) {
        require_positive("hardness", hardness);
        require_positive("effective_modulus", effective_modulus);
        require_positive("rms_gradient", rms_gradient);
        modulus_times_gradient_ = effective_modulus * rms_gradient;
    }

    using Base::bulk_compliance;
    using Base::interaction;
    using Base::point_at_pressure;
    using Base::point_at_separation;

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive, less than H, and within the reach of the elastic contact.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity wanted = Quantity::all) const {
        require_positive("pressure", pressure);
        require(pressure < hardness_, "pressure", pressure, "less than the hardness (Pa): all has flowed there");
        ContactState<T> state;
        state.pressure = {pressure, 0, 0};
        if (parts::has(wanted, Quantity::stiffness)) {
            const Estimate<T> elastic = elastic_.at_pressure(pressure, Quantity::stiffness).stiffness;
            const T K = parts::plastic_stiffness(cut_.stiffness(pressure / hardness_), elastic.value);
            state.stiffness = {K, (elastic.error / elastic.value + error_of_cut) * K, elastic.evaluations};
        }
        if (parts::has(wanted, Quantity::real_area_fraction)) {
            const T share = (std::min)(std::hypot(1 / hardness_, 2 / elastic_scale(pressure)) * pressure, T(1));
            state.real_area_fraction = {share, 4 * std::numeric_limits<T>::epsilon() * share, 0};
        }
        if (parts::has(wanted, Quantity::separation | Quantity::loading_stiffness)) {
            const Loading at = loading(pressure);
            state.separation = {at.separation, T(1e-9) * rms_height(), 0};
            if (parts::has(wanted, Quantity::loading_stiffness) && at.separation > 0)
                state.loading_stiffness = {at.stiffness, T(1e-6) * at.stiffness, 0};
        }
        state.eta = state.separation.value / rms_height();
        return state;
    }

    /// The contact on loading at the separation \p separation [m] of the mean planes.
    /// \throws domain_error unless it is positive and its pressure within reach.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity wanted = Quantity::all) const {
        return this->state_at_separation(separation, wanted);
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height. \throws domain_error unless 0 < eta,
    /// where a part of the surface is above it, and its pressure is within reach.
    [[nodiscard]] parts::LogSlope<T> log_pressure(T eta) const {
        const T to_elastic = rms_height() / elastic_.rms_height();
        const parts::LogSlope<T> elastic = elastic_.log_pressure(eta * to_elastic);
        const auto [share, change] = cut_.share_above(eta * rms_height());
        require(share > 0, "eta", eta, "where a part of the surface is above the separation");
        const T cut = std::log(share * hardness_), apart = loading_exponent * (elastic.log - cut);
        const T of_elastic = 1 / (1 + std::exp(apart));  // its part in the sum of the inverse powers
        const T slope = of_elastic * elastic.slope * to_elastic + (1 - of_elastic) * change / share * rms_height();
        return {parts::plastic_log_pressure(elastic.log, cut), slope, elastic.error};
    }

    /// log(K/(Pa/m)) at eta. \throws domain_error as log_pressure.
    [[nodiscard]] Estimate<T> log_stiffness(T eta) const {
        const parts::LogSlope<T> p = log_pressure(eta);
        const Estimate<T> K = at_pressure(std::exp(p.log), Quantity::stiffness).stiffness;
        return {std::log(K.value), p.error + K.error / K.value};
    }

    [[nodiscard]] T rms_height() const { return elastic_.rms_height(); }
    [[nodiscard]] bool has_kinks() const { return parts::has_kinks(elastic_); }
    [[nodiscard]] T hardness() const { return hardness_; }
    [[nodiscard]] const Elastic& elastic() const { return elastic_; }
    [[nodiscard]] const Cut& cut() const { return cut_; }

private:
    static constexpr T loading_exponent = T(1.3), error_of_cut = T(1e-9);

    /// E g [Pa]; with a bearing curve that of the surface at its local scale.
    [[nodiscard]] T elastic_scale(T pressure) const {
        if constexpr (requires { elastic_.crowded().gaussian(); }) {
            const auto& crowded = elastic_.crowded();
            if (crowded.has_bearing_curve())
                return crowded.effective_modulus() * crowded.gaussian().rms_gradient() * crowded.local_scale(pressure);
        }
        return modulus_times_gradient_;
    }

    struct Loading {
        T separation, stiffness;  ///< stiffness: -dp/dd
    };
    /// p(d) where the elastic contact has the pressure q: its logarithm, the slope of it against log q, d, -dd/d log q.
    struct AtElastic {
        T log_p, slope, separation, stiffness, fall;
    };
    [[nodiscard]] AtElastic at_elastic(T log_q) const {
        const T q = std::exp(log_q), d = elastic_.separation(q).value, K = elastic_.stiffness(q);
        const auto [share, change] = cut_.share_above(d);
        if (!(share > 0)) return {-std::numeric_limits<T>::max_exponent, T(1), d, T(0), q / K};
        const T cut = std::log(share * hardness_), apart = loading_exponent * (log_q - cut);
        const T of_elastic = 1 / (1 + std::exp(apart)),
                per_height = of_elastic * K / q - (1 - of_elastic) * change / share;
        const T log_p = parts::plastic_log_pressure(log_q, cut);
        return {log_p, per_height * q / K, d, per_height * std::exp(log_p), q / K};
    }
    /// The root of p(d) = p by Newton's steps of the elastic pressure there, which is more than p: flow brings the
    /// planes together. 0 where p at 0 is less.
    [[nodiscard]] Loading loading(T pressure) const {
        const T target = std::log(pressure);
        T low = target, high = std::numeric_limits<T>::infinity(), log_q = target;
        for (int i = 0; i < 100; ++i) {
            const AtElastic at = at_elastic(log_q);
            const T step = (target - at.log_p) / at.slope, next = log_q + (std::min)(step, T(1));
            if (step > 0 && !(at.separation > T(1e-6) * rms_height())) break;
            if (std::abs(step) < T(1e-7)) return {at.separation - step * at.fall, at.stiffness};
            (step > 0 ? low : high) = log_q;
            log_q = i < 50 && next > low && next < high ? next : std::midpoint(low, (std::min)(high, low + 1));
        }
        return {0, 0};
    }

    Elastic elastic_;
    Cut cut_;
    T hardness_, modulus_times_gradient_{};  ///< [Pa]
};

template <class Elastic, class Cut, class... Numbers>
PlasticContact(Elastic, Cut, Numbers...)
    -> PlasticContact<std::remove_cvref_t<decltype(std::declval<Elastic>().rms_height())>, Elastic, Cut>;

}  // namespace fstiff::inline v0_1
