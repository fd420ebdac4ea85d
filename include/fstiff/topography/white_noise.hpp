// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// White noise of an instrument in a map, by what its spectrum does not fall at the shortest waves.
///
///     C(q) = a q^-s + n  at q_N/4, q_N/2, q_N   ->   n = (C1 C3 - C2^2)/(C1 + C3 - 2 C2)
///
/// q_N is pi over the coarser step; each C is the mean over shells from 0.8 of that place to it. Noise that the
/// instrument smooths counts as the surface, and a surface whose spectrum flattens as noise.
/// Reference   n: Aitken's extrapolation, exact for a power law
/// Units       lengths [m]
/// Valid       spectra of map_spectrum(); 0 where C falls as a power or faster
/// Accuracy    256 x 256 points, H 0.8: 15 % of a noise of 3 % of sigma; without noise below 1.5 % of sigma
///             (tests/topography/map_noise_test.cpp)

#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Rms height [m] of the white noise in a map with the steps \p dx, \p dy and the spectrum \p spectrum.
template <Real T>
[[nodiscard]] T white_noise(const SpectrumShells<T>& spectrum, std::type_identity_t<T> dx, std::type_identity_t<T> dy) {
    const T x = std::numbers::pi_v<T> / dx, y = std::numbers::pi_v<T> / dy, top = (std::min)(x, y);
    const T width = std::hypot(x, y) / static_cast<T>(spectrum.shells.size());
    std::array<T, 3> level{}, count{};  // of h^2 if all waves of the map had what those of the place have
    for (const auto& shell : spectrum.shells) {
        const T q = shell.q2_h2 / shell.q_h2, share = std::numbers::pi_v<T> * q * width / (2 * x * y);
        for (std::size_t i = 0; i < 3; ++i)
            if (const T place = q / std::ldexp(top, static_cast<int>(i) - 2); place > T(0.8) && place <= T(1))
                level[i] += shell.q_h2 * shell.q_h2 / shell.q2_h2 / share, ++count[i];
    }
    for (std::size_t i = 0; i < 3; ++i) level[i] /= (std::max)(count[i], T(1));
    const auto [a, b, c] = level;
    const T n = (a * c - b * b) / (a + c - 2 * b);
    return n > T(0) && n < c * (1 + T(1e-6)) ? std::sqrt(n) : T(0);
}

/// Rms gradient of white noise of the rms height \p noise [m] in a map with the steps \p dx, \p dy.
template <Real T>
[[nodiscard]] T gradient_of_noise(T noise, std::type_identity_t<T> dx, std::type_identity_t<T> dy) {
    return noise * std::numbers::pi_v<T> * std::hypot(1 / dx, 1 / dy) / std::sqrt(T(3));
}

}}}  // namespace fstiff::detail
