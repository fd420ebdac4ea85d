// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Two-dimensional roughness spectra of isotropic surfaces: a band with a power law, and shells measured on a map.
///
///     sigma^2 = 2 pi int q C dq      G(q)^2 = 2 pi int_q1^q q'^3 C dq'      G(q2) = g, the rms gradient
///     m0 = sigma^2      m2 = g^2/2      m4 = (3/4) pi int q^5 C dq          the moments of a profile of the surface
///     C(q) = C0 q_rolloff^(-2-2H)  from q1 to q_rolloff,   C0 q^(-2-2H)  from there to q2
///     q_rolloff = q1:  m0 = 2 pi C0 F(-2H)   m2 = pi C0 F(2-2H)   m4 = (3/4) pi C0 F(4-2H),  F(s) = (q2^s - q1^s)/s
///
/// alpha = m0 m4/m2^2 fixes q2/q1 alone. Derivation: docs/theory-surface.md.
/// Reference   Nayak, J. Lubr. Technol. 93 (1971) 398 (moments, alpha); Persson et al., J. Phys. Condens. Matter 17
///             (2005) R1 (spectrum, Hurst exponent)
/// Units       q [rad/m], C0 such that C is in m^4, m0 [m^2], m2 dimensionless, m4 [1/m^2]
/// Valid       0 < H <= 1, 0 < q1 <= q_rolloff < q2; alpha > 3/2, the lower limit of isotropic surfaces
/// Accuracy    1e-13 relative in double (tests/surface/roughness_spectrum_test.cpp)

#include <fstiff/surface/spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Integral int_1^x q^(s-1) dq = (x^s - 1)/s with log_x = ln x.
template <Real T>
[[nodiscard]] T power_integral(T s, T log_x) {
    return std::abs(s * log_x) < (std::numeric_limits<T>::min)() ? log_x : std::expm1(s * log_x) / s;
}

/// Logarithmic derivative of power_integral by x: x^s/power_integral.
template <Real T>
[[nodiscard]] T power_integral_slope(T s, T log_x) {
    return std::exp(s * log_x) / power_integral(s, log_x);
}

}  // namespace detail

/// Band C(q) = C0 q^(-2-2H) from q_rolloff to q2, constant from q1 to q_rolloff.
template <Real T = double>
struct BandSpectrum {
    T C0{};         ///< [m^(2-2H)]
    T hurst{};      ///< H
    T q1{};         ///< least wave number [rad/m]
    T q_rolloff{};  ///< where the power law begins; q1 where there is no flat part [rad/m]
    T q2{};         ///< greatest wave number [rad/m]

    /// \throws domain_error naming the parameter that is out of range.
    void validate() const {
        detail::require_positive("C0", C0);
        detail::require(hurst > 0 && hurst <= 1, "hurst", hurst, "greater than 0 and at most 1");
        detail::require_positive("q1", q1);
        detail::require(q_rolloff >= q1 && q_rolloff <= (std::numeric_limits<T>::max)(), "q_rolloff", q_rolloff,
                        "q1 or more");
        detail::require(q2 > q_rolloff && q2 <= (std::numeric_limits<T>::max)(), "q2", q2,
                        "greater than q1 and q_rolloff");
    }

    /// Integral of q^n C dq over the band.
    [[nodiscard]] T integral(int n) const {
        const T s = T(n) - 1 - 2 * hurst, begin = std::pow(q_rolloff, s);
        const T flat = begin * -std::expm1(T(n + 1) * std::log(q1 / q_rolloff)) / T(n + 1);
        return C0 * (flat + begin * detail::power_integral(s, std::log(q2 / q_rolloff)));
    }
    [[nodiscard]] T m0() const { return 2 * std::numbers::pi_v<T> * integral(1); }
    [[nodiscard]] T m2() const { return std::numbers::pi_v<T> * integral(3); }
    [[nodiscard]] T m4() const { return std::numbers::pi_v<T> * T(0.75) * integral(5); }
    [[nodiscard]] SpectralMoments<T> moments() const { return {m0(), m2(), m4()}; }
    [[nodiscard]] T rms_height() const { return std::sqrt(m0()); }
    [[nodiscard]] T rms_gradient() const { return std::sqrt(2 * m2()); }
};

/// Spectrum in shells of |q|, in ascending order: sums over the modes of a map between two wave numbers.
template <Real T = double>
struct SpectrumShells {
    /// One ring of wave vectors.
    struct Shell {
        T q2_h2{};  ///< sum of q^2 |h_q|^2, dimensionless
        T q_h2{};   ///< sum of q |h_q|^2 [m]
    };
    std::vector<Shell> shells;
    T rms_height{};  ///< root of the sum of |h_q|^2 [m]

    /// \throws domain_error for no shells, or one whose sums are not positive and finite.
    void validate() const {
        if (shells.empty()) throw domain_error("shells of a spectrum = 0: must be at least 1");
        detail::require_positive("rms_height", rms_height);
        for (const Shell& shell : shells) {
            detail::require_positive("q2_h2 of a shell", shell.q2_h2);
            detail::require_positive("q_h2 of a shell", shell.q_h2);
        }
    }
    [[nodiscard]] T rms_gradient() const {
        T sum = 0;
        for (const Shell& shell : shells) sum += shell.q2_h2;
        return std::sqrt(sum);
    }
};

namespace detail {

/// \p spectrum with heights times \p factor.
template <Real T>
[[nodiscard]] SpectrumShells<T> scaled(SpectrumShells<T> spectrum, std::type_identity_t<T> factor) {
    for (auto& shell : spectrum.shells) shell.q2_h2 *= factor * factor, shell.q_h2 *= factor * factor;
    spectrum.rms_height *= factor;
    return spectrum;
}

/// Smallest Hurst exponent with which a band without a flat part has the moments \p moments and at most the ratio
/// \p widest = q2/q1, such as the length of a profile over two steps; 0 where any has, 1 where none has. To 1e-12.
template <Real T>
[[nodiscard]] T least_hurst(const SpectralMoments<T>& moments, std::type_identity_t<T> widest) {
    require(widest > 1, "widest band", widest, "greater than 1");
    const T log_ratio = std::log(widest);
    if (!std::isfinite(log_ratio)) return 0;
    const auto is_too_wide = [&](T hurst) {  // alpha of a band grows with H and with q2/q1
        const auto F = [&](T s) { return power_integral(s - 2 * hurst, log_ratio); };
        return moments.bandwidth() > T(1.5) * (F(T(0)) / F(T(2))) * (F(T(4)) / F(T(2)));
    };
    T low = 0, high = 1;
    if (!is_too_wide(low)) return low;
    if (is_too_wide(high)) return high;
    for (int i = 0; i < 40; ++i) {
        const T middle = (low + high) / 2;
        (is_too_wide(middle) ? low : high) = middle;
    }
    return high;
}

/// Band without a flat part with the moments \p moments and the Hurst exponent \p hurst.
/// \throws domain_error unless 0 < H <= 1 and alpha > 3/2, with ln(q2/q1) between 0.001 and 60.
template <Real T>
[[nodiscard]] BandSpectrum<T> band_of_moments(const SpectralMoments<T>& moments, std::type_identity_t<T> hurst) {
    require(hurst > 0 && hurst <= 1, "hurst", hurst, "greater than 0 and at most 1");
    require_positive("m0", moments.m0);
    require_positive("m2", moments.m2);
    require_positive("m4", moments.m4);
    const T alpha = moments.bandwidth(), low = T(1e-3), high = 60;
    const auto log_alpha = [hurst](T log_ratio) {
        const auto F = [&](T s) { return detail::power_integral(s, log_ratio); };
        const auto slope = [&](T s) { return detail::power_integral_slope(s, log_ratio); };
        const T zero = -2 * hurst, two = 2 - 2 * hurst, four = 4 - 2 * hurst;
        return std::pair(std::log(T(1.5)) + std::log(F(zero) / F(two)) + std::log(F(four) / F(two)),
                         slope(zero) + slope(four) - 2 * slope(two));
    };
    require(alpha > T(1.5), "Nayak's alpha = m0 m4/m2^2", alpha,
            "greater than 1.5, which every isotropic surface exceeds (rms_gradient states m2 in another way)");
    const T target = std::log(alpha);
    const auto solution = math::newton_bracketed(
        [&](T x) {
            const auto [value, slope] = log_alpha(x);
            return std::pair(value - target, slope);
        },
        low, high, std::clamp(std::log(alpha), low, high), 4 * std::numeric_limits<T>::epsilon());
    require(solution.converged(), "Nayak's alpha = m0 m4/m2^2", alpha,
            "that of a band with ln(q2/q1) between 0.001 and 60 at this Hurst exponent");
    const T log_ratio = solution.root;
    const T F0 = detail::power_integral(-2 * hurst, log_ratio), F2 = detail::power_integral(2 - 2 * hurst, log_ratio);
    BandSpectrum<T> band;
    band.hurst = hurst;
    band.q1 = band.q_rolloff = std::sqrt(2 * moments.m2 / moments.m0 * (F0 / F2));
    band.q2 = band.q1 * std::exp(log_ratio);
    band.C0 = moments.m0 / (2 * std::numbers::pi_v<T> * F0) * std::pow(band.q1, 2 * hurst);
    return band;
}

/// Waves of \p band up to the wave number at which Nayak's alpha reaches \p alpha; all of them where it does not. The
/// omitted short waves decide m4, and with it radius and density of the peaks, but hardly change the height.
/// \throws domain_error as BandSpectrum::validate, and unless alpha > 2, which a flat part alone does not reach.
template <Real T>
[[nodiscard]] BandSpectrum<T> cut_at_bandwidth(BandSpectrum<T> band, std::type_identity_t<T> alpha) {
    band.validate();
    require(alpha > 2 && std::isfinite(alpha), "alpha of the cut", alpha, "finite and greater than 2");
    if (band.moments().bandwidth() <= alpha) return band;
    const T highest = std::log(band.q2 / band.q_rolloff);
    const auto excess = [&](T x) {  // of ln alpha, and its slope against ln q2
        band.q2 = band.q_rolloff * std::exp(x);
        const SpectralMoments<T> m = band.moments();
        const T q = band.q2, C = band.C0 * std::pow(q, -2 - 2 * band.hurst), unit = std::numbers::pi_v<T> * C * q * q;
        const T slope = unit * (2 / m.m0 + T(0.75) * q * q * q * q / m.m4 - 2 * q * q / m.m2);
        return std::pair(std::log(m.bandwidth() / alpha), slope);
    };
    const auto solution = math::newton_bracketed(excess, 4 * std::numeric_limits<T>::epsilon(), highest, highest / 2,
                                                 4 * std::numeric_limits<T>::epsilon() * (1 + highest));
    if (!solution.converged()) throw domain_error("alpha of the cut: not found in the band");
    band.q2 = band.q_rolloff * std::exp(solution.root);
    return band;
}

}  // namespace detail

}}  // namespace fstiff
