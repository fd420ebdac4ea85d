// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Ultrasonic waves at an interface that acts as a spring without mass: reflection coefficient from stiffness and back.
///
///     R = (z1 - z2 + i x) / (z1 + z2 + i x),   T = 2 z1 / (z1 + z2 + i x),   x = omega z1 z2 / K     normal incidence
///     |R| = 1 / sqrt(1 + (2K / (omega z))^2)                                    like media, eq. (5.1)
///     K = omega z1 z2 sqrt((1-R)(1+R)) / sqrt((R (z1+z2))^2 - (z1-z2)^2)        inverse, with R = |R|
///     K = (omega z/2) sqrt((1-R)(1+R)) / R                                      inverse, like media
///
/// The wave comes from the body of impedance z1; amplitudes of displacement, exp(+i omega t). |R|^2 + (z2/z1) |T|^2
/// = 1.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eq. (5.1); unlike media: this project
/// Units       K [Pa/m] per nominal area, omega = 2 pi f [rad/s], z = density * velocity [kg/(m^2 s)]
/// Valid       K >= 0, omega > 0, z > 0; inverse: |z1-z2|/(z1+z2) < R < 1, both excluded
/// Accuracy    spring_interface_ulps, both directions and any z1/z2 (tests/wave/spring_interface_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>

#include <algorithm>
#include <complex>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// The bound on the relative error of every function below (of the modulus where it is complex), in units of epsilon.
/// Measured: reflection 1.7, complex amplitudes 2.4, transmitted_energy 3.8, stiffness_from_reflection 2.1.
inline constexpr int spring_interface_ulps = 5;

}  // namespace detail

/// Acoustic impedances [kg/(m^2 s)] of the body that the wave comes from and of the body beyond.
template <Real T = double>
struct Impedances {
    T incident{};  ///< z1, > 0
    T beyond{};    ///< z2, > 0
};

/// z = density * velocity [kg/(m^2 s)] from [kg/m^3] and [m/s]. \throws domain_error unless both are positive.
template <Real T>
[[nodiscard]] T acoustic_impedance(T density, T velocity) {
    detail::require_positive("density", density);
    detail::require_positive("velocity", velocity);
    return density * velocity;
}

namespace detail {

/// omega = 2 pi f [rad/s] from [Hz]. \throws domain_error unless positive.
template <Real T>
[[nodiscard]] T angular_frequency(T frequency) {
    require_positive("frequency", frequency);
    return 2 * std::numbers::pi_v<T> * frequency;
}

}  // namespace detail

/// |R| of an interface of stiffness \p stiffness [Pa/m] between two bodies of one impedance, eq. (5.1).
/// \throws domain_error naming the argument that is out of range.
template <Real T>
[[nodiscard]] T reflection(T stiffness, T impedance, T angular_frequency) {
    return reflection(stiffness, Impedances<T>{impedance, impedance}, angular_frequency);
}

/// K [Pa/m] from the measured \p reflection = |R|, like media. \throws domain_error unless 0 < R < 1.
template <Real T>
[[nodiscard]] T stiffness_from_reflection(T reflection, T impedance, T angular_frequency) {
    return stiffness_from_reflection(reflection, Impedances<T>{impedance, impedance}, angular_frequency);
}

namespace detail {

template <Real T>
void require_wave(const Impedances<T>& media, T angular_frequency) {
    require_positive("impedance", media.incident);
    require_positive("impedance", media.beyond);
    require_positive("angular_frequency", angular_frequency);
}

/// z1 z2/(z1+z2); the products and sums of extreme impedances do not overflow.
template <Real T>
T joint_impedance(const Impedances<T>& media) noexcept {
    const auto [low, high] = std::minmax({media.incident, media.beyond});
    return low / (1 + low / high);
}

/// |z1-z2|/(z1+z2).
template <Real T>
T contrast(const Impedances<T>& media) noexcept {
    const auto [low, high] = std::minmax({media.incident, media.beyond});
    return (high - low) / high / (1 + low / high);
}

/// s = K (z1+z2)/(omega z1 z2): the stiffness against that of the wave. R = (i + s contrast)/(i + s).
template <Real T>
T relative_stiffness(T stiffness, const Impedances<T>& media, T angular_frequency) {
    require_wave(media, angular_frequency);
    require(stiffness >= 0 && stiffness <= (std::numeric_limits<T>::max)(), "stiffness", stiffness,
            "finite and not negative");
    return stiffness / angular_frequency / joint_impedance(media);
}

/// r(z1+z2) - |z1-z2|, exact but for a few roundings of the result: the sums and the product carry their errors along,
/// without loss where r is close to that of the perfect bond. Impedances of the order of 1.
template <Real T>
T above_welded(T r, T low, T high) noexcept {
    const T sum = high + low, sum_rest = low - (sum - high);
    const T difference = high - low, difference_rest = (high - difference) - low;
    const T product = r * sum, product_rest = std::fma(r, sum, -product);
    return (product - difference) + (product_rest + r * sum_rest - difference_rest);
}

}  // namespace detail

/// |R| between unlike bodies; the same from either side. \throws domain_error as above.
template <Real T>
[[nodiscard]] T reflection(T stiffness, const Impedances<T>& media, T angular_frequency) {
    const T s = detail::relative_stiffness(stiffness, media, angular_frequency);
    const T welded = detail::contrast(media);
    // Divided by the larger of 1 and s, so that s may be 0 or infinite.
    return s <= 1 ? std::hypot(T(1), s * welded) / std::hypot(T(1), s)
                  : std::hypot(1 / s, welded) / std::hypot(1 / s, T(1));
}

namespace detail {

/// |R| of the perfect bond, |z1-z2|/(z1+z2): the least reflection coefficient that any stiffness gives.
template <Real T>
[[nodiscard]] T welded_reflection(const Impedances<T>& media) {
    require_wave(media, T(1));
    return detail::contrast(media);
}

/// Share of the energy that passes, (z2/z1)|T|^2 = 1 - |R|^2, with all its digits where |R| is close to 1.
template <Real T>
[[nodiscard]] T transmitted_energy(T stiffness, const Impedances<T>& media, T angular_frequency) {
    const T s = relative_stiffness(stiffness, media, angular_frequency);
    const auto [low, high] = std::minmax({media.incident, media.beyond});
    const T share = s <= 1 ? s / std::hypot(T(1), s) : 1 / std::hypot(1 / s, T(1));
    return 4 * (low / high) * (share / (1 + low / high)) * (share / (1 + low / high));
}

/// R and T as complex amplitudes of displacement; K = 0 gives R = 1, T = 0.
template <Real T>
[[nodiscard]] std::complex<T> complex_reflection(T stiffness, const Impedances<T>& media, T angular_frequency) {
    const T s = relative_stiffness(stiffness, media, angular_frequency);
    const T contrast = std::copysign(detail::contrast(media), media.incident - media.beyond);
    const T rest = 2 / (1 + media.incident / media.beyond);  // 1 - contrast
    // (i + s contrast)/(i + s) with the denominator made real: only the real part can cancel, where it crosses 0.
    if (s <= 1) return {(1 + contrast * s * s) / (1 + s * s), rest * s / (1 + s * s)};
    const T y = 1 / s;
    return {(y * y + contrast) / (y * y + 1), rest * y / (y * y + 1)};
}

/// T of the same.
template <Real T>
[[nodiscard]] std::complex<T> complex_transmission(T stiffness, const Impedances<T>& media, T angular_frequency) {
    const T s = relative_stiffness(stiffness, media, angular_frequency);
    const T welded = 2 / (1 + media.beyond / media.incident);
    if (s <= 1) return {welded * s * s / (1 + s * s), -welded * s / (1 + s * s)};
    const T y = 1 / s;
    return {welded / (y * y + 1), -welded * y / (y * y + 1)};
}

}  // namespace detail

/// K [Pa/m] from |R|, unlike media. \throws domain_error unless |z1-z2|/(z1+z2) < R < 1.
template <Real T>
[[nodiscard]] T stiffness_from_reflection(T reflection, const Impedances<T>& media, T angular_frequency) {
    detail::require_wave(media, angular_frequency);
    const auto [low, high] = std::minmax({media.incident, media.beyond});
    detail::require(reflection > 0 && reflection < 1, "reflection", reflection, "greater than 0 and less than 1");

    const int scale = std::ilogb(high);  // a power of 2: exact
    const T a = std::scalbn(low, -scale), b = std::scalbn(high, -scale);
    const T above = detail::above_welded(reflection, a, b);
    detail::require(above > 0, "reflection", reflection,
                    "greater than |z1-z2|/(z1+z2), the reflection of the welded joint");

    const T passed = std::sqrt((1 - reflection) * (1 + reflection));
    const T stiffness =
        angular_frequency * low * (b * passed / std::sqrt(above) / std::sqrt(reflection * (a + b) + (b - a)));
    detail::require(stiffness <= (std::numeric_limits<T>::max)(), "reflection", reflection,
                    "large enough for the stiffness to be in the range of the floating-point type");
    return stiffness;
}

}}  // namespace fstiff
