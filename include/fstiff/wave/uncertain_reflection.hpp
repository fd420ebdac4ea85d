// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Slopes of reflection coefficient and stiffness of a spring-like interface, and the error of one from the other.
///
///     s = K (z1+z2)/(omega z1 z2),  c = |z1-z2|/(z1+z2)
///     dR/dK = -(ds/dK) (s/R) (1-c^2)/(1+s^2)^2
///     dK/dR = -K R (1-c)(1+c) / [(1-R)(1+R) (R-c)(R+c)]
///     error of K = |dK/dR| error of R,  error of R = |dR/dK| error of K                                 to first order
///
/// For like media the relative error of K is least, 2.6 times the error of R, at R = 1/sqrt(3). Shear waves take the
/// shear impedances and the tangential K (asperity/material.hpp).
///
/// Reference   differentiates wave/spring_interface.hpp
/// Units       K [Pa/m], R dimensionless
/// Valid       as spring_interface.hpp
/// Accuracy    16 epsilon; dK/dR beyond R = c + 1e-3 (tests/wave/propagation_test.cpp)

#include <fstiff/wave/spring_interface.hpp>

#include <algorithm>
#include <optional>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// dR/dK [m/Pa] at \p stiffness: 0 for an open gap, negative beyond. \throws domain_error as reflection.
template <Real T>
[[nodiscard]] T reflection_slope(T stiffness, const Impedances<T>& media, T angular_frequency) {
    const T s = relative_stiffness(stiffness, media, angular_frequency);
    const T c = contrast(media);
    const T r = reflection(stiffness, media, angular_frequency);
    const T y = s <= 1 ? s : 1 / s;
    const T share = s <= 1 ? s / ((1 + s * s) * (1 + s * s)) : y * y * y / ((1 + y * y) * (1 + y * y));
    const auto [low, high] = std::minmax({media.incident, media.beyond});
    const T passed = 4 * (low / high) / ((1 + low / high) * (1 + low / high));  // 1 - c^2
    return r > 0 || c > 0 ? -share * passed / r / angular_frequency / joint_impedance(media) : T(0);
}

}  // namespace detail

/// |R| of the stiffness \p stiffness [Pa/m]; its error is that of the stiffness carried on to first order, and the
/// rounding of R. \throws domain_error as reflection.
template <Real T>
[[nodiscard]] Estimate<T> reflection(const Estimate<T>& stiffness, const Impedances<T>& media, T angular_frequency) {
    const T r = reflection(stiffness.value, media, angular_frequency);
    const T slope = std::abs(detail::reflection_slope(stiffness.value, media, angular_frequency));
    return {r, slope * stiffness.error + detail::spring_interface_ulps * std::numeric_limits<T>::epsilon() * r,
            stiffness.evaluations};
}

namespace detail {

/// A stiffness with its standard error [Pa/m].
template <Real T = double>
struct MeasuredStiffness {
    T value{};
    T error{};
    T slope{};  ///< dK/dR [Pa/m], negative
    bool bounded =
        true;  ///< R +- 2 errors stay within the range of R: else K has no upper or no lower bound, and an error
               ///< of first order is not enough
};

/// K and its error from |R| = \p reflection with the standard error \p reflection_error, to first order.
/// \throws domain_error unless |z1-z2|/(z1+z2) < R < 1 and the error is finite and not negative.
template <Real T>
[[nodiscard]] MeasuredStiffness<T> measured_stiffness(T reflection, T reflection_error, const Impedances<T>& media,
                                                      T angular_frequency) {
    require(reflection_error >= 0 && reflection_error <= (std::numeric_limits<T>::max)(), "reflection_error",
            reflection_error, "finite and not negative");
    const T k = stiffness_from_reflection(reflection, media, angular_frequency);
    const T c = contrast(media);
    const auto [low, high] = std::minmax({media.incident, media.beyond});
    const int scale = std::ilogb(high);
    const T a = std::scalbn(low, -scale), b = std::scalbn(high, -scale);
    const T above = above_welded(reflection, a, b) / (a + b);  // R - c
    const T passed = 4 * (low / high) / ((1 + low / high) * (1 + low / high));
    const T slope = -k * (passed / above) * (reflection / (reflection + c)) / ((1 - reflection) * (1 + reflection));
    return {k, -slope * reflection_error, slope, 2 * reflection_error < (std::min)(1 - reflection, above)};
}

}  // namespace detail

/// Both ends, in stiffness and in reflection coefficient, which falls with the stiffness.
template <Real T = double>
struct ResolvableStiffness {
    T low{}, high{};                       ///< K [Pa/m]
    T min_reflection{}, max_reflection{};  ///< at high, at low
};

/// The range of K whose |R| lies between \p least, or 1.01 times that of the perfect bond, and \p most; none where
/// the range is empty. \throws domain_error unless 0 < least < most < 1, and as reflection.
template <Real T>
[[nodiscard]] std::optional<ResolvableStiffness<T>> resolvable_stiffness(const Impedances<T>& media,
                                                                         T angular_frequency, T least = T(0.1),
                                                                         T most = T(0.99)) {
    detail::require(least > 0 && least < 1, "least", least, "greater than 0 and less than 1");
    detail::require(most > least && most < 1, "most", most, "greater than least and less than 1");
    least = (std::max)(least, T(1.01) * detail::welded_reflection(media));
    if (least >= most) return std::nullopt;
    return ResolvableStiffness<T>{stiffness_from_reflection(most, media, angular_frequency),
                                  stiffness_from_reflection(least, media, angular_frequency), least, most};
}

}}  // namespace fstiff
