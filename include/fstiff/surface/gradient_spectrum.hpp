// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Spectrum as wave number q over the rms gradient G of all waves up to q: the measure dG/q of Persson's integrals.
///
///     band  G^2 = (pi/2) C (q^4 - q1^4) up to q_rolloff; then it rises by 2 pi C0 (q^(2-2H) - q_rolloff^(2-2H))/(2-2H)
///     shells   G^2 = the sum of q^2 |h_q|^2 up to the shell; inside a shell 1/q = sum q |h_q|^2 / sum q^2 |h_q|^2
///
/// Reference   this project; Persson, Phys. Rev. Lett. 99 (2007) 125502, for the integrals over it
/// Units       q [1/m]; G without a unit
/// Valid       what BandSpectrum and SpectrumShells take; \throws domain_error as their validate()
/// Accuracy    rounding, but 1e-8 ln(q2/q_rolloff) for a band of H so close to 1 that (2-2H) ln(q2/q_rolloff) < 1e-8
///             (tests/surface/gradient_spectrum_test.cpp)

#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/spectrum.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The measure dG/q of a spectrum in pieces: q(G) = (low + rate (G^2 - from^2))^power, smooth within each piece.
template <class S>
struct GradientPiece {
    S from, to;  ///< G
    S low, rate, power;
    /// 1/q at G.
    S inverse_q(S gradient) const {
        const S risen = rate * (gradient - from) * (gradient + from);
        if (power == 1) return 1 / (low + risen);   // a shell
        return power == 0 ? std::exp(-low - risen)  // H = 1: q = exp(low + rate (...))
                          : std::pow(low + risen, -power);
    }
};

template <class S, Real T>
std::vector<GradientPiece<S>> gradient_pieces(const BandSpectrum<T>& band) {
    band.validate();
    const S C0 = band.C0, H = band.hurst, q1 = band.q1, qr = band.q_rolloff, q2 = band.q2, pi = std::numbers::pi_v<S>;
    std::vector<GradientPiece<S>> pieces;
    S from = 0;
    if (qr > q1) {  // G^2 = (pi/2) C (q^4 - q1^4)
        const S C = C0 * std::pow(qr, -2 - 2 * H), unit = pi / 2 * C;
        const S to = std::sqrt(unit) * qr * qr * std::sqrt(-std::expm1(4 * std::log(q1 / qr)));
        pieces.push_back({S(0), to, q1 * q1 * q1 * q1, 1 / unit, S(0.25)});
        from = to;
    }
    // G^2 = from^2 + 2 pi C0 (q^a - qr^a)/a with a = 2 - 2H; ln(q/qr) for a = 0
    const S a = 2 - 2 * H, ratio = std::log(q2 / qr);
    const S rise = 2 * pi * C0 * std::pow(qr, a) * detail::power_integral(a, ratio);
    const S to = std::sqrt(from * from + rise);
    if (a * ratio < S(1e-8))  // the power is 1/a: as if a = 0, to 1e-8 a ratio
        pieces.push_back({from, to, std::log(qr), ratio / rise, S(0)});
    else
        pieces.push_back({from, to, std::pow(qr, a), a / (2 * pi * C0), 1 / a});
    return pieces;
}

template <class S, Real T>
std::vector<GradientPiece<S>> gradient_pieces(const SpectrumShells<T>& spectrum) {
    spectrum.validate();
    std::vector<GradientPiece<S>> pieces;
    S square = 0;
    for (const auto& shell : spectrum.shells) {
        const S from = std::sqrt(square);
        square += static_cast<S>(shell.q2_h2);
        pieces.push_back({from, std::sqrt(square), static_cast<S>(shell.q2_h2 / shell.q_h2), S(0), S(1)});
    }
    return pieces;
}

}}}  // namespace fstiff::detail
