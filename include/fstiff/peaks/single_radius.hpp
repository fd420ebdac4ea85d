// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Peaks of one radius, their heights Gaussian or exponential: the distribution of Greenwood and Williamson. Or heights
/// that were measured, by PeakHeights.
///
///     G_n(h) = int_h^inf (s-h)^n phi(s) ds   Gaussian: F_n(h)/sqrt(2 pi);  exponential: exp(-h) Gamma(n+1, max(-h, 0))
///
/// h is the separation over sigma. Exponential heights begin at the mean plane: phi(s) = exp(-s), s >= 0.
///
/// Reference   Greenwood, Williamson, Proc. R. Soc. Lond. A 295 (1966) 300-319.
/// Units       dimensionless
/// Valid       n in {-1/2, 0, 1/2, 1, 3/2, 5/2} (exponential: from 0 on), any h that is a number
/// Accuracy    16 epsilon (tests/contact/greenwood_williamson_test.cpp)

#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/peak_heights.hpp>

#include <algorithm>
#include <memory>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Distribution of the heights of the peaks.
enum class Heights { gaussian, exponential };

template <>
inline constexpr auto enum_names<Heights> = detail::name_list<Heights>({{Heights::gaussian, "gaussian"},
                                                                        {Heights::exponential, "exponential"}});

namespace detail {

/// exp(x) Gamma(n+1, x) for n = TwiceN/2 and x >= 0.
template <int TwiceN, Real T>
T scaled_upper_gamma(T x) {
    if constexpr (TwiceN == 0) return T(1);
    if constexpr (TwiceN == -1)
        return std::numbers::sqrt2_v<T> * math::scaled_moment<0>(std::sqrt(2 * x));  // sqrt(pi) erfcx(sqrt x)
    if constexpr (TwiceN > 0) return T(TwiceN) / 2 * scaled_upper_gamma<TwiceN - 2>(x) + std::pow(x, T(TwiceN) / 2);
}

/// G_n(h), the mean of (s-h)^n over the heights s above h. \throws domain_error unless n is 0, 1/2, 1, 3/2, 5/2.
template <Real T>
[[nodiscard]] T height_moment(T n, T h, Heights heights = Heights::gaussian) {
    if (heights == Heights::gaussian)
        return math::gaussian_moment(n, h) / (std::numbers::sqrt2_v<T> / std::numbers::inv_sqrtpi_v<T>);
    require(!std::isnan(h), "h", h, "a number");
    return math::with_power(n, [h]<int TwiceN>() {
        return scaled_upper_gamma<TwiceN>((std::max)(-h, T(0))) * std::exp(-(std::max)(h, T(0)));
    });
}

}  // namespace detail

/// All peaks have the radius R of the surface.
template <Real T = double>
struct SingleRadius {
    Heights heights = Heights::gaussian;
    std::shared_ptr<const PeakHeights<T>> measured{};  ///< in place of them

    /// G_n(h) = first * exp(second): neither under- nor overflows. n = TwiceN/2.
    template <int TwiceN>
    [[nodiscard]] std::pair<T, T> scaled_height_moment(T h) const {
        if (measured) return measured->template scaled_moment<TwiceN>(h);
        if (heights == Heights::gaussian)
            return {math::scaled_moment<TwiceN>(h) * std::numbers::inv_sqrtpi_v<T> / std::numbers::sqrt2_v<T>,
                    h > 0 ? -h * h / 2 : T(0)};
        return {detail::scaled_upper_gamma<TwiceN>((std::max)(-h, T(0))), -(std::max)(h, T(0))};
    }
    /// phi(s).
    [[nodiscard]] T density(T s) const {
        if (measured) return measured->density(s);
        return heights == Heights::gaussian
                   ? std::exp(-s * s / 2) * std::numbers::inv_sqrtpi_v<T> / std::numbers::sqrt2_v<T>
               : s >= 0 ? std::exp(-s)
                        : T(0);
    }
    [[nodiscard]] bool operator==(const SingleRadius&) const = default;
};

}}  // namespace fstiff
