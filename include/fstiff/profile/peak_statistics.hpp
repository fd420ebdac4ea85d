// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Spectral moments and three-point statistics of a profile, which give the density of its peaks.
///
///     m0 = <(z - <z>)^2>  m2 = <((z_(i+1) - z_i)/h)^2>  m4 = <((z_(i-1) - 2 z_i + z_(i+1))/h^2)^2>  alpha = m0 m4/m2^2
///     sigma_m^2     = mean (z_(i+1) - z_i)^2 / h^2                = 2 sigma^2 (1 - rho1) / h^2
///     sigma_kappa^2 = mean (z_(i-1) - 2 z_i + z_(i+1))^2 / h^4    = sigma^2 (6 - 8 rho1 + 2 rho2) / h^4
///     r = sigma_m^2 / (sigma sigma_kappa)   sin(theta) = h sigma_kappa / (2 sigma_m)   peaks over ordinates = theta/pi
///
/// sigma_m uses both differences of each triple, so that sin(theta) <= 1. Derivation: docs/theory-surface.md.
/// Reference   Nayak (1971); Longuet-Higgins, Phil. Trans. A 250 (1957) 157; Greenwood, Proc. R. Soc. Lond. A 393
///             (1984) 133-157; Buczkowski et al., Arch. Mech. 66 (2014), eqs. (4.1)-(4.3)
/// Units       m0 [m^2], m2 [1], m4 [1/m^2]; sigma [m], sigma_m [1], sigma_kappa [1/m], peaks per length [1/m]
/// Valid       at least 16 points and a triple; peak_statistics() refuses r = 1 (single sine), theta = pi/2 (zigzag)
/// Accuracy    1e-13 in double (tests/profile/spectral_moments_test.cpp, tests/profile/peak_statistics_test.cpp)

#include <fstiff/math/rounding.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/surface/moments.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Sums over the triples of a profile; \p Sum is the scalar or a compensated sum of it.
template <Real S, class Sum = S>
struct TripleSums {
    Sum slope{}, curvature{};  // of squared differences, and of squared second differences
    std::size_t triples{}, peaks{};

    /// Adds a triple with its two differences; skips one with a missing point.
    void add(S rise, S fall) {
        if (std::isnan(rise) || std::isnan(fall)) return;
        put(slope, (rise * rise + fall * fall) / 2);
        put(curvature, (fall - rise) * (fall - rise));
        peaks += rise > S(0) && fall < S(0) ? 1 : 0;
        ++triples;
    }
    void add(const TripleSums& other) requires std::is_same_v<Sum, S> {
        slope += other.slope, curvature += other.curvature;
        triples += other.triples, peaks += other.peaks;
    }
    S mean_square_slope() const { return total(slope) / static_cast<S>(triples); }
    S mean_square_curvature() const { return total(curvature) / static_cast<S>(triples); }

private:
    static void put(S& sum, S term) { sum += term; }
    static void put(math::CompensatedSum<S>& sum, S term) { sum.add(term); }
    static S total(S sum) { return sum; }
    static S total(const math::CompensatedSum<S>& sum) { return sum.value(); }
};

}  // namespace detail

/// Statistics of neighbours and triples of a profile, which describe its peaks.
template <Real T = double>
struct PeakStatistics {
    T rms_height{};          ///< sigma [m]
    T rms_slope{};           ///< sigma_m, of neighbours
    T rms_curvature{};       ///< sigma_kappa [1/m], of triples
    T rho1{}, rho2{};        ///< autocorrelation at one and two samples
    T r{}, theta{};          ///< of the peak density (4.4); theta in radians
    T counted_peak_ratio{};  ///< ordinates above both neighbours, over ordinates with two neighbours
    T peaks_per_length{};    ///< the same, over the sampling interval [1/m]
    std::size_t triples{};   ///< of existing neighbours

    /// theta/pi: expected counted_peak_ratio of a Gaussian profile by (4.3).
    [[nodiscard]] T peak_ratio() const { return theta / std::numbers::pi_v<T>; }
};

/// Statistics of \p profile about its mean: remove its form first, with detrend().
/// \throws domain_error for a profile that is out of range, or whose r or theta is.
template <Real T>
[[nodiscard]] PeakStatistics<T> peak_statistics(const Profile<T>& profile) {
    profile.validate(16);
    PeakStatistics<T> result;
    result.rms_height = rms_height(profile);
    const T scale = result.rms_height;  // heights below are in units of sigma
    detail::TripleSums<double, math::CompensatedSum<double>> sums;
    const std::vector<T>& z = profile.heights;
    for (std::size_t i = 1; i + 1 < z.size(); ++i) sums.add((z[i] - z[i - 1]) / scale, (z[i + 1] - z[i]) / scale);
    result.triples = sums.triples;
    if (result.triples == 0) throw domain_error("profile has 0 triples of neighbouring points: must be at least 1");
    const double slope2 = sums.mean_square_slope(), curvature2 = sums.mean_square_curvature();  // times h^2, h^4
    const double h = static_cast<double>(profile.spacing);
    const double sine = std::sqrt(curvature2 / slope2) / 2;
    const double r = slope2 / std::sqrt(curvature2);
    detail::require(sine > 0.0 && sine < 1.0, "sin(theta) of the profile", sine,
                    "between 0 and 1, both excluded: neither straight nor zigzag");
    detail::require(r < 1.0, "r of the profile", r,
                    "less than 1: this profile is too near to a single sine, or too short");
    result.rms_slope = static_cast<T>(static_cast<double>(scale) * (std::sqrt(slope2) / h));
    result.rms_curvature = static_cast<T>(static_cast<double>(scale) / h * (std::sqrt(curvature2) / h));
    result.rho1 = static_cast<T>(1 - slope2 / 2);
    result.rho2 = static_cast<T>(1 - 2 * slope2 + curvature2 / 2);
    result.r = static_cast<T>(r);
    result.theta = static_cast<T>(std::asin(sine));
    detail::require(result.r < T(1), "r of the profile", result.r,
                    "less than 1: this profile is too near to a single sine, or too short");
    detail::require(result.theta < std::numbers::pi_v<T> / 2, "theta of the profile", result.theta,
                    "less than pi/2: no zigzag");
    result.counted_peak_ratio = static_cast<T>(sums.peaks) / static_cast<T>(result.triples);
    result.peaks_per_length = result.counted_peak_ratio / profile.spacing;
    return result;
}

namespace detail {

/// Moments of \p profile about its mean: remove its form first, with detrend(). \throws domain_error for a profile out
/// of range, without a triple of neighbours, or whose moments leave the range of numbers.
template <Real T>
[[nodiscard]] SpectralMoments<T> spectral_moments(const Profile<T>& profile) {
    profile.validate(16);
    const T scale = height_scale(profile);
    math::CompensatedSum<double> slope;
    TripleSums<double, math::CompensatedSum<double>> sums;
    std::size_t pairs = 0;
    double before = std::numeric_limits<double>::quiet_NaN();
    const std::vector<T>& z = profile.heights;
    for (std::size_t i = 0; i + 1 < z.size(); ++i) {
        const double rise = (z[i + 1] - z[i]) / scale;
        sums.add(std::exchange(before, rise), rise);
        if (std::isnan(rise)) continue;
        slope.add(rise * rise);
        ++pairs;
    }
    if (sums.triples == 0) throw domain_error("profile has 0 triples of neighbouring points: must be at least 1");
    const double ratio = static_cast<double>(scale) / static_cast<double>(profile.spacing);
    SpectralMoments<T> moments;
    const T rms = rms_height(profile);
    moments.m0 = rms * rms;
    moments.m2 = static_cast<T>(slope.value() / static_cast<double>(pairs) * ratio * ratio);
    const double rms_bend = std::sqrt(sums.mean_square_curvature()) * ratio / static_cast<double>(profile.spacing);
    moments.m4 = static_cast<T>(rms_bend * rms_bend);
    const auto usable = [](T value) {
        return value >= (std::numeric_limits<T>::min)() && value <= (std::numeric_limits<T>::max)();
    };
    require(usable(moments.m0), "m0", moments.m0, "a positive number of normal size");
    require(usable(moments.m2), "m2", moments.m2, "a positive number of normal size");
    require(moments.m4 == T(0) || usable(moments.m4), "m4", moments.m4, "a number of normal size");
    require(moments.bandwidth() <= (std::numeric_limits<T>::max)(), "Nayak's alpha", moments.bandwidth(), "finite");
    return moments;
}

}  // namespace detail

}}  // namespace fstiff
