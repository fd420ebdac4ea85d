// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Three-point statistics of a profile, from which the density of its peaks follows.
///
///     sigma_m^2     = mean (z_(i+1) - z_i)^2 / h^2                = 2 sigma^2 (1 - rho1) / h^2
///     sigma_kappa^2 = mean (z_(i-1) - 2 z_i + z_(i+1))^2 / h^4    = sigma^2 (6 - 8 rho1 + 2 rho2) / h^4
///     r = sigma_m^2 / (sigma sigma_kappa)        sin(theta) = h sigma_kappa / (2 sigma_m)
///     peaks / ordinates = theta/pi                                                  eq. (4.3)
///
/// Means are over the triples that exist; each gives both of its differences to sigma_m, so that sin(theta) <= 1.
///
/// Reference   Greenwood, Proc. R. Soc. Lond. A 393 (1984) 133-157; Buczkowski et al. (2014), eqs. (4.1)-(4.3)
/// Units       sigma [m], sigma_m dimensionless, sigma_kappa [1/m], peaks per length [1/m]
/// Valid       16 points and a triple at least; refuses r = 1 (a single sine) and theta = pi/2 (a zigzag)
/// Accuracy    identities between the statistics 1e-14 in double (tests/profile/peak_statistics_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/triples.hpp>

namespace fstiff {

/// What neighbours and triples of a profile say of its peaks.
template <Real T = double>
struct PeakStatistics {
    T rms_height{};          ///< sigma [m]
    T rms_slope{};           ///< sigma_m, of neighbours
    T rms_curvature{};       ///< sigma_kappa [1/m], of triples
    T rho1{}, rho2{};        ///< autocorrelation at one and two samples
    T r{}, theta{};          ///< of the peak density (4.4); theta in radians
    T counted_peak_ratio{};  ///< ordinates that stand above both neighbours, over ordinates with two neighbours
    T peaks_per_length{};    ///< the same, over the sampling interval [1/m]
    std::size_t triples{};   ///< of existing neighbours

    /// theta/pi: what (4.3) expects counted_peak_ratio to be on a Gaussian profile.
    [[nodiscard]] T peak_ratio() const { return theta / numbers::pi_v<T>; }
};

/// Statistics of \p profile about its mean: remove its form first, with detrend().
/// \throws domain_error for a profile that is out of range, or whose r or theta is.
template <Real T>
[[nodiscard]] PeakStatistics<T> peak_statistics(const Profile<T>& profile) {
    profile.validate(16);
    using S = Accumulator<T>;
    PeakStatistics<T> result;
    result.rms_height = rms_height(profile);
    const T scale = result.rms_height;  // heights below are in units of sigma
    detail::TripleSums<S, CompensatedSum<S>> sums;
    const std::vector<T>& z = profile.heights;
    for (std::size_t i = 1; i + 1 < z.size(); ++i) sums.add((z[i] - z[i - 1]) / scale, (z[i + 1] - z[i]) / scale);
    result.triples = sums.triples;
    if (result.triples == 0) throw domain_error("profile has 0 triples of neighbouring points: must be at least 1");
    const S slope2 = sums.mean_square_slope(), curvature2 = sums.mean_square_curvature();  // times h^2, h^4
    const S h = static_cast<S>(profile.spacing);
    const S sine = std::sqrt(curvature2 / slope2) / 2;
    const S r = slope2 / std::sqrt(curvature2);
    require(sine > S(0) && sine < S(1), "sin(theta) of the profile", sine,
            "between 0 and 1, both excluded: neither straight nor zigzag");
    require(r < S(1), "r of the profile", r, "less than 1: this profile is too near to a single sine, or too short");
    result.rms_slope = static_cast<T>(static_cast<S>(scale) * (std::sqrt(slope2) / h));
    result.rms_curvature = static_cast<T>(static_cast<S>(scale) / h * (std::sqrt(curvature2) / h));
    result.rho1 = static_cast<T>(1 - slope2 / 2);
    result.rho2 = static_cast<T>(1 - 2 * slope2 + curvature2 / 2);
    result.r = static_cast<T>(r);
    result.theta = static_cast<T>(std::asin(sine));
    require(result.r < T(1), "r of the profile", result.r,
            "less than 1: this profile is too near to a single sine, or too short");
    require(result.theta < numbers::pi_v<T> / 2, "theta of the profile", result.theta, "less than pi/2: no zigzag");
    result.counted_peak_ratio = static_cast<T>(sums.peaks) / static_cast<T>(result.triples);
    result.peaks_per_length = result.counted_peak_ratio / profile.spacing;
    return result;
}

}  // namespace fstiff
