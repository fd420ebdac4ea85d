// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of a surface whose pressures end at the hardness H, from elastic to all yielded: K is that of unloading.
///
///     K    = c (e^L - 1) 1.5^w       L^n = L_flow^n + L_el^n    w = L_el/L    n = 2.8 - 1.65 s    L_flow = -ln(1 - s)
///     A/A0 = 1 - e^-L_A              L_A^2 = L_flow^2 + ln(1 - A_el/A0)^2     L_el = ln(1 + K_el/(1.5 c))
///     -dd/dp = 1/K + (1 - w)^(1.2 - 0.6 s) (-dd_cut/dp)         s = p/H       c = K_cut (1 - s)/s
///
/// K_cut is K of the highest points of the share s, held together, d_cut their level. d is negative above p = H/2. The
/// number of contacts is not available: it is 0. Derivation: docs/theory-contact.md, section 10.
/// Reference   this project, docs/validation.md; Pullen, Williamson, Proc. R. Soc. A 327 (1972) 159
/// Units       SI
/// Valid       0 < p < H within the reach of the elastic contact; compared up to 0.95 H, H/(E g) from 0.02 to 3
/// Accuracy    p(d) 1e-10 of the rms height, 1e-5 where K has kinks or H is above 2 E g; K of Gaussian numbers within
///             15 % of boundary elements at 95 of 100 points (tests/contact/plastic_contact_map_test.cpp); of other
///             heights: docs/accuracy.md

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/halfspace/bonded_contact.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <memory>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// The highest parts of a surface as a flat cuts them, of a share of the area: K of them held together [Pa/m], and the
/// level of the flat over the mean plane [m] with its fall as the share grows [m].
template <class C, class T>
concept CutSurface = requires(const C& cut, T share) {
    { cut.stiffness(share) } -> std::convertible_to<T>;
    { cut.level(share) } -> std::convertible_to<std::pair<T, T>>;
};

/// K [Pa/m], and the factor of the approach by yield.
template <Real T>
struct Yielded {
    T stiffness, flow;
};
/// Elastic contacts over yielded ones of the same area.
template <Real T>
inline constexpr T stiffer_than_flowed = T(1.5);

/// The contact at p/H = \p share < 1 of which K would be \p cut if all yielded and \p elastic if nothing did.
template <Real T>
[[nodiscard]] Yielded<T> yielded(T share, T cut, T elastic) {
    constexpr T stiffer = stiffer_than_flowed<T>;
    const T of_odds = cut * ((1 - share) / share), n = T(2.8) - T(1.65) * share;
    const T flow = -std::log1p(-share), alone = std::log1p(elastic / (stiffer * of_odds));
    if (std::isinf(alone)) return {alone, 0};
    const T most = (std::max)(flow, alone);
    const T log_more = std::log1p(std::pow((std::min)(flow, alone) / most, n)) / n;  // of L over most
    const T log_w = std::log(alone / most) - log_more;
    return {of_odds * std::expm1(most * std::exp(log_more)) * std::pow(stiffer, std::exp(log_w)),
            std::pow(-std::expm1(log_w), T(1.2) - T(0.6) * share)};
}

/// Cut of a Gaussian surface: K_cut = E g/sigma s/(1-s) sqrt(0.55^2 + 0.28^2 (z - 0.65)^2), z = Phi^-1(1-s). For light
/// loads 0.28 z, which is 1/(2 sqrt(pi)), is exact of separate contacts.
template <Real T = double>
class GaussianCut {
public:
    /// \throws domain_error unless all are finite and positive.
    GaussianCut(T rms_height, T rms_gradient, T effective_modulus)
        : rms_height_(rms_height), stiffness_(effective_modulus * rms_gradient / rms_height) {
        require_positive("rms_height", rms_height);
        require_positive("rms_gradient", rms_gradient);
        require_positive("effective_modulus", effective_modulus);
    }
    [[nodiscard]] T stiffness(T share) const {
        return stiffness_ * share / (1 - share) *
               std::hypot(T(0.55), T(0.28) * (-math::normal_quantile(share) - T(0.65)));
    }
    [[nodiscard]] std::pair<T, T> level(T share) const {
        const T z = 0 - math::normal_quantile(share);  // no -0 at the half
        return {rms_height_ * z, rms_height_ / math::normal_density(z)};
    }
    [[nodiscard]] T rms_height() const { return rms_height_; }
    [[nodiscard]] T closing() const { return stiffness_ * rms_height_; }  ///< E g [Pa]

private:
    T rms_height_, stiffness_;
};

/// Cut of a surface whose heights over their rms have a bearing curve f:
///
///     K_cut = K_cut of GaussianCut ((t^2 + 0.36)/1.36)^-0.2     d_cut = sigma f(z)     t = s(z, 1/4) of f
///     K_el' = K_el/(1 + (K_el/B)^4)^(1/4)                       B = 1.5 K_cut (1 + (4 H/(E g))^2)
///
/// K_el' takes the place of K_el, which few numbers make too high at light loads of a plateau: contacts under p have
/// the area p/H, or more where H/(E g) is large, and elastic ones are 1.5 times as stiff as yielded ones of one area.
/// For a straight f K_cut is that of GaussianCut, and B changes K by less than 0.2 %. Without f the cut is GaussianCut,
/// without a bound.
/// Reference   this project: fitted to boundary elements of 21 kinds of faces; docs/theory-contact.md, section 10
/// Valid       compared at H/(E g) from 0.03 to 0.3, p/H from 0.003 to 0.8. Where K_el is far above B, K rises with H
///             at large H, to K_el, which has no such bound
/// Accuracy    372 points of 31 other kinds: within a factor of 2 at 98 of 100, 0.26 rms of ln K, 0.30 with GaussianCut
///             (tests/contact/bearing_cut_test.cpp)
template <Real T = double>
class BearingCut {
public:
    /// None of \p curve: Gaussian heights. Else its heights have the rms 1 and the mean 0.
    BearingCut(GaussianCut<T> gaussian, std::shared_ptr<const MaterialRatioSlope<T>> curve)
        : gaussian_(gaussian), curve_(std::move(curve)) {}

    [[nodiscard]] T stiffness(T share) const {
        if (!curve_) return gaussian_.stiffness(share);
        const T t = curve_->slope(-math::normal_quantile(share), width);
        return gaussian_.stiffness(share) * std::pow((t * t + T(0.36)) / T(1.36), T(-0.2));
    }
    [[nodiscard]] std::pair<T, T> level(T share) const {
        if (!curve_) return gaussian_.level(share);
        const T z = 0 - math::normal_quantile(share), sigma = gaussian_.rms_height();
        return {sigma * curve_->height(z), sigma * curve_->slope(z, width) / math::normal_density(z)};
    }
    /// K_el' of \p elastic, K_el, where K_cut is \p cut. Closed contacts remain closed.
    [[nodiscard]] T bounded(T elastic, T cut, T hardness) const {
        if (!curve_ || std::isinf(elastic)) return elastic;
        const T h = 4 * hardness / gaussian_.closing(), ratio = elastic / (stiffer_than_flowed<T> * cut * (1 + h * h)),
                square = ratio * ratio;
        return elastic / std::sqrt(std::sqrt(1 + square * square));
    }

private:
    static constexpr T width = T(0.25);  ///< of the level, in z

    GaussianCut<T> gaussian_;
    std::shared_ptr<const MaterialRatioSlope<T>> curve_;
};

/// The contact at p/H = \p share of the cut \p cut and of K_el \p elastic, which the cut may bound.
template <Real T, CutSurface<T> Cut>
[[nodiscard]] Yielded<T> yielded(const Cut& cut, T share, T elastic, T hardness) {
    const T K_cut = cut.stiffness(share);
    if constexpr (requires { cut.bounded(elastic, K_cut, hardness); }) elastic = cut.bounded(elastic, K_cut, hardness);
    return yielded(share, K_cut, elastic);
}

/// Cut of a Gaussian surface as rough as \p map is over its mean plane.
template <Real T>
[[nodiscard]] GaussianCut<T> gaussian_cut(const HeightMap<T>& map, T effective_modulus, Edges edges) {
    return {fstiff::rms_height(map), map_spectrum(map, edges).rms_gradient(), effective_modulus};
}

/// K of the highest points of a map of at most 256 points a side over that of a Gaussian cut: at knots of z, each
/// computed when it is first asked for, and by a power of it between them.
template <Real T>
class CutKnots {
public:
    CutKnots(const HeightMap<T>& map, T effective_modulus, Edges edges)
        : points_(map, effective_modulus, edges),
          gaussian_(gaussian_cut(map, effective_modulus, edges)),
          last_(-math::normal_quantile(T(1.5) / static_cast<T>(points_.count()))),
          log_ratio_(static_cast<std::size_t>(2 * last_ / step) + 2) {}
    [[nodiscard]] T ratio(T share) const {
        const T place = (last_ - std::clamp(-math::normal_quantile(share), -last_, last_)) / step;
        const auto i = static_cast<std::size_t>(place);
        return std::exp(std::lerp(log_at(i), log_at(i + 1), place - static_cast<T>(i)));
    }

private:
    static constexpr T step = T(0.75);  ///< of z

    [[nodiscard]] T log_at(std::size_t knot) const {
        return log_ratio_.at(knot, [&] {
            const T share = math::normal_share((std::min)(static_cast<T>(knot) * step - last_, last_));
            return std::log(points_.stiffness(share, T(1e-3)) / gaussian_.stiffness(share));
        });
    }

    HighestPoints<T> points_;
    GaussianCut<T> gaussian_;
    T last_;               ///< z of one and a half points
    Panels<T> log_ratio_;  ///< from z = last_ down
};

/// Cut of a map. Copies share the computed numbers.
template <Real T = double>
class MapCut {
public:
    /// \throws domain_error as HighestPoints and map_spectrum.
    MapCut(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus, Edges edges)
        : gaussian_(gaussian_cut(map, effective_modulus, edges)),
          knots_(std::make_shared<const CutKnots<T>>(coarsened(map, 256), effective_modulus, edges)),
          curve_(std::make_shared<const MaterialRatioSlope<T>>(MaterialRatioSlope<T>::of_heights(
              std::span<const T>(map.heights.data(), static_cast<std::size_t>(map.heights.size()))))),
          mean_(mean_height(map)) {}

    /// Cut of a map \p factor times as high: the same points.
    [[nodiscard]] MapCut scaled(T factor) const {
        MapCut taller = *this;
        taller.factor_ *= factor;
        return taller;
    }
    [[nodiscard]] T stiffness(T share) const { return gaussian_.stiffness(share) * knots_->ratio(share); }
    /// The fall by the slope of the bearing curve about the level.
    [[nodiscard]] std::pair<T, T> level(T share) const {
        const T z = -math::normal_quantile(share);
        return {factor_ * (curve_->height(z) - mean_), factor_ * curve_->slope(z, T(0.25)) / math::normal_density(z)};
    }

private:
    GaussianCut<T> gaussian_;
    std::shared_ptr<const CutKnots<T>> knots_;
    std::shared_ptr<const MaterialRatioSlope<T>> curve_;
    T mean_, factor_ = 1;  ///< mean height [m]; heights over those of the map
};

}  // namespace detail

/// Contact that yields at a hardness. \p Elastic is the contact of the same surface without yield, at light and
/// heavy loads: HybridContact.
template <Real T, class Elastic, detail::CutSurface<T> Cut>
class PlasticContact : private detail::SlopeContact<PlasticContact<T, Elastic, Cut>, T> {
    using Base = detail::SlopeContact<PlasticContact<T, Elastic, Cut>, T>;
    friend Base;

public:
    /// \throws domain_error unless hardness [Pa] is finite and positive.
    PlasticContact(Elastic elastic, Cut cut, std::type_identity_t<T> hardness)
        : elastic_(std::move(elastic)), cut_(std::move(cut)), hardness_(hardness) {
        detail::require_positive("hardness", hardness);
    }

    using Base::at_separation;  // on loading; the separation may be negative
    using Base::bulk_compliance;
    using Base::interaction;
    using Base::point_at_pressure;
    using Base::point_at_separation;

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive, less than H, and within the reach of the elastic contact.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        detail::require_positive("pressure", pressure);
        detail::require(pressure < hardness_, "pressure", pressure,
                        "less than the hardness (Pa): all peaks have yielded there");
        const T share = pressure / hardness_;
        ContactState<T> state;
        state.pressure = {pressure, 0, 0};
        const bool area = detail::has(quantities, Quantity::real_area_fraction);
        const ContactState<T> elastic = elastic_.at_pressure(
            pressure, area ? Quantity::stiffness | Quantity::real_area_fraction : Quantity::stiffness);
        if (detail::has(quantities, Quantity::stiffness | Quantity::loading_stiffness)) {
            const Estimate<T>& alone = elastic.stiffness;
            const detail::Yielded<T> yield = detail::yielded(cut_, share, alone.value, hardness_);
            const T K = yield.stiffness, loading = 1 / compliance(share, yield),
                    error = alone.error / alone.value + T(1e-9);
            if (detail::has(quantities, Quantity::stiffness)) state.stiffness = {K, error * K, alone.evaluations};
            if (detail::has(quantities, Quantity::loading_stiffness))
                state.loading_stiffness = {loading, error * loading, alone.evaluations};
        }
        if (area) {
            const T of_elastic = elastic.real_area_fraction.value;
            const T alone = of_elastic < T(1) ? -std::log1p(-of_elastic) : std::numeric_limits<T>::infinity();
            const T fraction = -std::expm1(-std::hypot(std::log1p(-share), alone));
            state.real_area_fraction = {fraction, elastic.real_area_fraction.error, 0};
        }
        if (detail::has(quantities, Quantity::separation)) state.separation = separation(pressure);
        state.eta = state.separation.value / rms_height();
        return state;
    }

    /// Separation [m] of the mean planes on loading under \p pressure [Pa] < H.
    [[nodiscard]] Estimate<T> separation(T pressure) const {
        const T u = std::log(pressure / (hardness_ - pressure)), side = u < 0 ? -1 : 1;
        const detail::PanelEdges<T> edge = edges();
        const std::size_t panels = edge.before(std::abs(u));
        T fall = 0;
        for (std::size_t i = 0; i < panels; ++i) fall += panel(side, i);
        fall += side * fall_between(side * edge(panels), u);
        const T d = at_half() - side * fall;
        return {d, error_share() * (std::abs(d) + rms_height()), 16};
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless the pressure of eta is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        detail::require(std::isfinite(eta), "eta", eta, "finite (separation over rms height)");
        const detail::PanelEdges<T> edge = edges();
        const T start = at_half(), side = eta * rms_height() > start ? -1 : 1;
        const T target = std::abs(eta * rms_height() - start);
        std::size_t n = 0;
        T fall = 0;
        for (T next; edge(n) < furthest && (next = fall + panel(side, n)) <= target; ++n) fall = next;
        detail::require(edge(n) < furthest, "eta", eta, "within the reach of the laws");
        const T from = side * edge(n), to = side * edge(n + 1);
        const auto residual = [&](T u) {
            return std::pair(side * fall_between(from, u) + fall - target, side * fall_at(u));
        };
        const auto u = math::newton_bracketed(residual, (std::min)(from, to), (std::max)(from, to), (from + to) / 2,
                                              64 * std::numeric_limits<T>::epsilon() * (1 + std::abs(from)));
        detail::require(u.converged(), "eta", eta, "within the reach of the laws");
        const T slope = -rms_height() / (1 + std::exp(u.root)) / fall_at(u.root);
        return {std::log(hardness_) - std::log1p(std::exp(-u.root)), slope, u.error - error_share() * slope};
    }

    /// log(K/(Pa/m)) at eta. \throws domain_error as log_pressure.
    [[nodiscard]] Estimate<T> log_stiffness(T eta) const {
        const LogSlope<T> p = log_pressure(eta);
        const Estimate<T> K = at_pressure(std::exp(p.log), Quantity::stiffness).stiffness;
        return {std::log(K.value), p.error + K.error / K.value};
    }

    [[nodiscard]] T rms_height() const { return elastic_.rms_height(); }
    [[nodiscard]] bool has_kinks() const { return detail::has_kinks(elastic_); }

private:
    static constexpr int furthest = 36;  ///< ln(p/(H - p)) to either side: 2e-16 of H

    /// Of panels of ln(p/(H - p)) to either side of p = H/2: short ones with few points where K has kinks.
    [[nodiscard]] detail::PanelEdges<T> edges() const {
        return has_kinks() ? detail::PanelEdges<T>(T(1) / 8) : detail::PanelEdges<T>();
    }

    /// The contact under \p share of H, compared with boundary elements or not: closed where the elastic one is.
    [[nodiscard]] detail::Yielded<T> yielded(T share) const {
        const T p = share * hardness_;
        return detail::yielded(
            cut_, share, p < elastic_.full_pressure() ? elastic_.stiffness(p) : std::numeric_limits<T>::infinity(),
            hardness_);
    }
    /// -dd/dp [m/Pa] on loading.
    [[nodiscard]] T compliance(T share, const detail::Yielded<T>& yield) const {
        return 1 / yield.stiffness + (yield.flow > 0 ? yield.flow * cut_.level(share).second / hardness_ : T(0));
    }
    /// -dd/du [m] where u = ln(p/(H - p)).
    [[nodiscard]] T fall_at(T u) const {
        const T share = 1 / (1 + std::exp(-u));
        return compliance(share, yielded(share)) * hardness_ * share / (1 + std::exp(u));
    }
    /// Its integral.
    [[nodiscard]] T fall_between(T from, T to) const {
        return has_kinks() ? by_rule<4>(from, to) : by_rule<16>(from, to);
    }
    template <std::size_t points>
    [[nodiscard]] T by_rule(T from, T to) const {
        const auto& rule = math::GaussLegendre<T, points>::get();
        T sum = 0;
        for (std::size_t i = 0; i < points; ++i)
            sum += rule.weight[i] * fall_at(std::lerp(from, to, (1 + rule.node[i]) / 2));
        return (to - from) / 2 * sum;
    }
    /// The same over panel \p i beyond p = H/2, at more (\p side is 1) or less (-1).
    [[nodiscard]] T panel(T side, std::size_t i) const {
        const detail::PanelEdges<T> edge = edges();
        return panels_.at(2 * i + (side > 0), [&] { return side * fall_between(side * edge(i), side * edge(i + 1)); });
    }
    /// d at p = H/2.
    [[nodiscard]] T at_half() const { return yielded(T(0.5)).flow * cut_.level(T(0.5)).first; }
    /// Error of the separation over the rms height.
    [[nodiscard]] T error_share() const {
        return has_kinks() || hardness_ > elastic_.full_pressure() ? T(1e-5) : T(1e-10);
    }

    Elastic elastic_;
    Cut cut_;
    T hardness_;  ///< [Pa]
    detail::Panels<T> panels_{2 * edges().before(furthest)};
};

template <class Elastic, class Cut, class Number>
PlasticContact(Elastic, Cut, Number)
    -> PlasticContact<std::remove_cvref_t<decltype(std::declval<Elastic>().rms_height())>, Elastic, Cut>;

}}  // namespace fstiff
