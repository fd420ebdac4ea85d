// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Joint density of the heights and curvatures of the peaks of a Gaussian profile that is sampled at a finite step.
///
///     p_peak(zeta, t) = erf(t tan(theta)/sqrt 2)/(2 theta c) exp(-(zeta - r t)^2/(2 c^2)) exp(-t^2/2)   eq. (4.4)
///     c^2 = 1 - r^2,   zeta height over the rms height,  t curvature over the rms curvature of the ordinates
///     sin^2(theta) = (3 - 4 rho1 + rho2)/(4 (1 - rho1))      r^2 = 2 (1 - rho1)^2/(3 - 4 rho1 + rho2)
///
/// rho1, rho2: autocorrelation at one and two steps. r and theta are independent (docs/errata.md). Derivation, moments
/// of t and limits: docs/theory-contact.md, section 4.
///
/// Reference   Greenwood, Proc. R. Soc. Lond. A 393 (1984) 133-157; Buczkowski et al. (2014), eqs. (4.1)-(4.4), Fig. 2
/// Units       dimensionless, theta in radians
/// Valid       0 <= r < 1, 0 < theta < pi/2
/// Accuracy    density 20 epsilon, moments of t 8 epsilon; central moments lose 1/Var^2 t
///             (tests/peaks/peak_distribution_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/math/gaussian_moment.hpp>

#include <algorithm>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// The distribution of peaks (4.4) for one r and one theta: its density, its moments and its marginal.
template <Real T = double>
class PeakDistribution {
public:
    /// \throws domain_error unless 0 <= r < 1 and 0 < theta < pi/2.
    PeakDistribution(T r, T theta) : r_(r), theta_(theta) {
        detail::require(r >= 0 && r < 1, "r", r, "at least 0 and less than 1");
        detail::require(theta > 0 && theta < std::numbers::pi_v<T> / 2, "theta", theta,
                        "between 0 and pi/2, both excluded (radians)");
    }

    /// Distribution from the autocorrelation of the profile at one and at two sampling steps.
    /// \throws domain_error unless -1 < rho1 < 1 and 2 rho1^2 - 1 < rho2 < 1, as three ordinates allow.
    static PeakDistribution from_autocorrelation(T rho1, T rho2) {
        detail::require(rho1 > -1 && rho1 < 1, "rho1", rho1, "between -1 and 1, both excluded");
        detail::require(rho2 > 2 * rho1 * rho1 - 1 && rho2 < 1, "rho2", rho2,
                        "between 2 rho1^2 - 1 and 1, both excluded");
        const T curvature = (3 - 4 * rho1) + rho2;  // sigma_kappa^2 h^4 / (2 sigma^2)
        const T slope = 1 - rho1;                   // sigma_m^2 h^2 / (2 sigma^2)
        return {std::sqrt(2 / curvature) * slope, std::asin(std::sqrt(curvature / slope) / 2)};
    }

    /// The peaks of a profile of exponential autocorrelation: 1 - r^2 = cot^2(theta). \throws domain_error unless pi/4
    /// <= theta <= pi/3, as rho2 = rho1^2 allows (a rounding beyond an end counts as the end).
    static PeakDistribution exponential(T theta) {
        constexpr T pi = std::numbers::pi_v<T>;
        constexpr T slack = 4 * std::numeric_limits<T>::epsilon();
        detail::require(theta >= pi / 4 - slack && theta <= pi / 3 + slack, "theta", theta,
                        "between pi/4 and pi/3 (radians) for an exponential autocorrelation");
        const T cot = std::cos(theta) / std::sin(theta);
        return {std::sqrt((std::max)(T(0), (1 - cot) * (1 + cot))), theta};
    }

    /// The peaks of an isotropic surface of Nayak's alpha, measured at a vanishing step: r = 1/sqrt(alpha) and theta =
    /// 0.001, whose density is within 1e-6 of that of the limit 0. \throws domain_error unless alpha > 1.
    static PeakDistribution isotropic(T alpha) {
        detail::require(alpha > 1 && std::isfinite(alpha), "Nayak's alpha", alpha, "finite and greater than 1");
        return {1 / std::sqrt(alpha), T(1e-3)};
    }

    /// Correlation of the height and the curvature of an ordinate, sigma_m^2/(sigma sigma_kappa).
    [[nodiscard]] T r() const { return r_; }
    /// Angle of the sampling [rad]: sin(theta) = h sigma_kappa/(2 sigma_m); 0 for a vanishing step h.
    [[nodiscard]] T theta() const { return theta_; }
    /// c = sqrt(1 - r^2): the standard deviation of the height of a peak of given curvature.
    [[nodiscard]] T c() const { return std::sqrt((1 - r_) * (1 + r_)); }

    /// p_peak(zeta, t), 0 for t < 0.
    [[nodiscard]] T operator()(T zeta, T t) const {
        if (!(t > 0)) return T(0);
        const T z = (zeta - r_ * t) / c();
        return std::erf(t * std::tan(theta_) / std::numbers::sqrt2_v<T>) / (2 * theta_ * c()) *
               std::exp(-(z * z + t * t) / 2);
    }

    /// Density of the peak height zeta alone (Fig. 2).
    [[nodiscard]] T height_marginal(T zeta) const {
        // exp(-zeta^2/2) times erf(k t) under a Gaussian in t of mean r zeta and width c: the trapezoidal rule in t
        // where that Gaussian stays clear of t = 0; elsewhere in u, t = s exp(u - exp(-u)) with s the smaller of c and
        // 1/k, which grades the nodes towards t = 0
        const T reach = std::sqrt(-2 * std::log(std::numeric_limits<T>::epsilon())) + T(0.5);
        const T k = std::tan(theta_) / std::numbers::sqrt2_v<T>;
        const T width = c();
        const T mean = r_ * zeta;
        const auto integrand = [&](T t) {
            const T z = (t - mean) / width;
            return std::erf(k * t) * std::exp(-z * z / 2);
        };
        T sum = 0;
        if (mean > (reach + 1) * width) {
            const T first = mean - reach * width, step = width / 3;
            for (int i = 0; T(i) < 6 * reach; ++i) sum += integrand(first + T(i) * step) * step;
        } else if (mean > -2 * reach) {
            const T step = T(0.06);
            const T scale = (std::min)(width, 1 / k);
            const T first = T(-3.9), last = std::log((std::max)(mean + reach * width, scale) / scale) + step;
            for (int i = 0; T(i) < (last - first) / step; ++i) {
                const T u = first + T(i) * step;
                const T fall = std::exp(-u);
                const T t = scale * std::exp(u - fall);
                sum += integrand(t) * t * (1 + fall) * step;
            }
        }
        return sum * std::exp(-zeta * zeta / 2) / (2 * theta_ * width);
    }

    /// E t^n. \throws domain_error unless 1 <= n <= 4.
    [[nodiscard]] T curvature_moment(int n) const {
        const T s = std::sin(theta_);
        const T half = std::sqrt(std::numbers::pi_v<T> / 2);
        switch (n) {
            case 1: return half * s / theta_;
            case 2: return 1 + std::sin(2 * theta_) / (2 * theta_);
            case 3: return 3 * half * (s - s * s * s / 3) / theta_;
            case 4: return 3 + 2 * std::sin(2 * theta_) / theta_ + std::sin(4 * theta_) / (4 * theta_);
            default: detail::refuse("moment order", n, "1, 2, 3 or 4");
        }
    }

    /// E t: mean curvature of the peaks over the rms curvature of the ordinates.
    [[nodiscard]] T mean_curvature() const { return curvature_moment(1); }
    /// E zeta: mean height of the peaks over the rms height.
    [[nodiscard]] T mean_height() const { return r_ * curvature_moment(1); }
    /// Variance V of zeta.
    [[nodiscard]] T height_variance() const { return (1 - r_) * (1 + r_) + r_ * r_ * curvature_variance(); }
    /// Third central moment of zeta over V^1.5; 0 for Gaussian heights.
    [[nodiscard]] T height_skewness() const {
        const T m1 = curvature_moment(1);
        const T third = curvature_moment(3) - m1 * (3 * curvature_variance() + m1 * m1);
        return r_ * r_ * r_ * third / (height_variance() * std::sqrt(height_variance()));
    }
    /// Fourth central moment of zeta over V^2; 3 for Gaussian heights.
    [[nodiscard]] T height_kurtosis() const {
        const T m1 = curvature_moment(1);
        const T square = m1 * m1;
        const T variance = curvature_variance();
        const T fourth =
            curvature_moment(4) - 4 * m1 * curvature_moment(3) + 6 * square * curvature_moment(2) - 3 * square * square;
        const T ratio = r_ * r_ / height_variance();
        return 3 + ratio * ratio * (fourth - 3 * variance * variance);
    }

    /// Peaks per ordinate, eq. (4.3).
    [[nodiscard]] T peak_ratio() const { return theta_ / std::numbers::pi_v<T>; }

private:
    [[nodiscard]] T curvature_variance() const {
        const T m1 = curvature_moment(1);
        return curvature_moment(2) - m1 * m1;
    }

    T r_;
    T theta_;
};

}}  // namespace fstiff
