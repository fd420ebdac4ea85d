// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The contact of Greenwood and Williamson: peaks of one radius R, their heights Gaussian or exponential.
///
///     G_n(h) = int_h^inf (s-h)^n phi(s) ds            Gaussian: F_n(h)/sqrt(2 pi);  exponential: exp(-h) Gamma(n+1, max(-h, 0))
///     p = (4/3) E D_p sigma^(3/2) R^(1/2) G_{3/2}(h)       K = 2 E D_p sigma^(1/2) R^(1/2) G_{1/2}(h)
///     A = pi R sigma D_p G_1(h)                            n = D_p G_0(h)
///
/// all per nominal area; h is the separation over sigma. Exponential heights begin at the mean plane: phi(s) = exp(-s), s >= 0.
///
/// Reference   Greenwood, Williamson, Proc. R. Soc. Lond. A 295 (1966) 300-319.
/// Units       SI
/// Valid       separations from -1000 to 1e6 rms heights; pressures as for RoughContact
/// Accuracy    moments 16 epsilon (tests/contact/greenwood_williamson_test.cpp)

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/quantity.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/gaussian_moment.hpp>
#include <fstiff/surface/roughness.hpp>

#include <cmath>

namespace fstiff {

enum class Heights { gaussian, exponential };
template <>
inline constexpr auto names<Heights> = name_list<Heights>({{Heights::gaussian, "gaussian"},
                                                           {Heights::exponential, "exponential"}});

namespace detail {

/// exp(x) Gamma(n+1, x) for n = TwiceN/2 and x >= 0.
template <int TwiceN, Real T>
T scaled_upper_gamma(T x) {
    if constexpr (TwiceN == 0) return T(1);
    if constexpr (TwiceN == -1)
        return numbers::sqrt2_v<T> * scaled_moment<0>(std::sqrt(2 * x));  // sqrt(pi) erfcx(sqrt x)
    if constexpr (TwiceN > 0) return T(TwiceN) / 2 * scaled_upper_gamma<TwiceN - 2>(x) + std::pow(x, T(TwiceN) / 2);
}

}  // namespace detail

/// G_n(h), the mean of (s-h)^n over the heights s above h. \throws domain_error unless n is 0, 1/2, 1, 3/2 or 5/2, h a number.
template <Real T>
[[nodiscard]] T height_moment(T n, T h, Heights heights = Heights::gaussian) {
    if (heights == Heights::gaussian) return gaussian_moment(n, h) / (numbers::sqrt2_v<T> / numbers::inv_sqrtpi_v<T>);
    require(!std::isnan(h), "h", h, "a number");
    return detail::with_power(n, [h]<int TwiceN>() {
        return detail::scaled_upper_gamma<TwiceN>(std::max(-h, T(0))) * std::exp(-std::max(h, T(0)));
    });
}

template <Real T>
class GreenwoodWilliamson {
public:
    /// \throws domain_error naming the parameter that is out of range.
    GreenwoodWilliamson(const Roughness<T>& surface, T effective_modulus, Heights heights = Heights::gaussian)
        : surface_(surface), heights_(heights) {
        surface.validate();
        require_positive("effective_modulus", effective_modulus);
        const T root = std::sqrt(surface.peak_radius / surface.rms_height);
        const T dimensionless = surface.peak_density * surface.rms_height * surface.rms_height;  // D_p sigma^2
        pressure_scale_ = T(4) / 3 * effective_modulus * dimensionless * root;
        stiffness_scale_ = 2 * effective_modulus * surface.peak_density * surface.rms_height * root;
        area_scale_ = numbers::pi_v<T> * surface.peak_radius * surface.rms_height * surface.peak_density;
    }

    /// The contact at the separation \p separation of the mean planes [m]. \throws domain_error outside the range.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity wanted = Quantity::all) const {
        const T h = separation / surface_.rms_height;
        require(h >= detail::lowest_eta && h <= T(1e6), "separation", separation,
                "between -1000 and 1e6 rms heights (m)");
        ContactState<T> state = at_eta({h, 0}, wanted);
        state.separation = {separation, 0, 0};
        return state;
    }

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive and within the reach of the model, which the message tells.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity wanted = Quantity::all) const {
        require_positive("pressure", pressure);
        const T highest =
            heights_ == Heights::gaussian ? detail::highest_gaussian_eta<T>() : detail::highest_exponential_eta<T>();
        const auto eta = detail::eta_of(std::log(pressure / pressure_scale_), pressure, highest,
                                        [this](T h, bool) { return log_load(h); });
        ContactState<T> state = at_eta(eta, wanted);
        state.pressure = {pressure, 0, 0};
        return state;
    }

    /// log(p/Pa) and its slope against the separation over the rms height.
    [[nodiscard]] LogSlope<T> log_pressure(T h) const {
        LogSlope<T> p = log_load(h);
        p.log += std::log(pressure_scale_);
        return p;
    }

    [[nodiscard]] T rms_height() const { return surface_.rms_height; }
    [[nodiscard]] Interaction<T> interaction() const { return {}; }
    [[nodiscard]] T bulk_compliance() const { return T(0); }
    [[nodiscard]] T stiffness_over_slope() const { return T(1); }

private:
    LogSlope<T> log_load(T h) const {
        const auto [load, scale] = scaled<3>(h);
        return {std::log(load) + scale, T(-1.5) * scaled<1>(h).first / load, rounding};
    }

    static constexpr T rounding = 16 * std::numeric_limits<T>::epsilon();

    /// G_n(h) = first * exp(second)
    template <int TwiceN>
    std::pair<T, T> scaled(T h) const {
        if (heights_ == Heights::gaussian)
            return {detail::scaled_moment<TwiceN>(h) * numbers::inv_sqrtpi_v<T> / numbers::sqrt2_v<T>,
                    h > 0 ? -h * h / 2 : T(0)};
        return {detail::scaled_upper_gamma<TwiceN>(std::max(-h, T(0))), -std::max(h, T(0))};
    }

    ContactState<T> at_eta(const detail::EtaEstimate<T>& eta, Quantity wanted) const {
        const T relative = rounding + eta.error * (2 + std::max(eta.value, T(0)));
        const auto moment = [&](Quantity quantity, T n, T scale) {
            if (!has(wanted, quantity)) return Estimate<T>{};
            const T value = scale * height_moment(n, eta.value, heights_);
            return Estimate<T>{value, relative * value, 0};
        };
        return {eta.value,
                {eta.value * surface_.rms_height, eta.error * surface_.rms_height, 0},
                moment(Quantity::pressure, T(1.5), pressure_scale_),
                moment(Quantity::stiffness, T(0.5), stiffness_scale_),
                moment(Quantity::real_area, T(1), area_scale_),
                moment(Quantity::contacts, T(0), surface_.peak_density)};
    }

    Roughness<T> surface_;
    Heights heights_;
    T pressure_scale_{};   ///< p/G_{3/2} [Pa]
    T stiffness_scale_{};  ///< K/G_{1/2} [Pa/m]
    T area_scale_{};       ///< A/G_1
};

}  // namespace fstiff
