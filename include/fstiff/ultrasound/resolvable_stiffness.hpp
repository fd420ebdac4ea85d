// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The stiffnesses that a wave can tell from a weld and from an open gap.
///
///     R_least = max(0.1, 1.01 |z1-z2|/(z1+z2)) <= |R| <= R_most = 0.99
///     K(R_most) <= K <= K(R_least)                                            by the inverse of (5.1)
///
/// Near |R| = 1 and near the weld a small error of R is a large one of K: for like bodies dK/K = -dR/(R (1-R)(1+R)),
/// that is 50 dR at 0.99 and 10 dR at 0.1, against 2.6 dR at best. The range of K moves with the frequency.
///
/// Reference   ultrasound/spring_interface.hpp; the ends 0.1 and 0.99 are this project's.
/// Units       K [Pa/m] per nominal area, impedances [kg/(m^2 s)], angular frequency [rad/s]
/// Valid       0 < least < most < 1
/// Accuracy    as stiffness_from_reflection (tests/ultrasound/resolvable_stiffness_test.cpp)

#include <fstiff/ultrasound/spring_interface.hpp>

#include <algorithm>
#include <optional>

namespace fstiff {

/// Both ends, in stiffness and in reflection coefficient, which falls with the stiffness.
template <Real T = double>
struct ResolvableStiffness {
    T low{}, high{};                       ///< K [Pa/m]
    T min_reflection{}, max_reflection{};  ///< at high, at low
};

/// The range of K whose |R| lies between \p least, or 1.01 times that of the perfect bond, and \p most; none where
/// nothing is left. \throws domain_error unless 0 < least < most < 1, and as reflection.
template <Real T>
[[nodiscard]] std::optional<ResolvableStiffness<T>> resolvable_stiffness(const Impedances<T>& media,
                                                                         T angular_frequency, T least = T(0.1),
                                                                         T most = T(0.99)) {
    require(least > 0 && least < 1, "least", least, "greater than 0 and less than 1");
    require(most > least && most < 1, "most", most, "greater than least and less than 1");
    least = (std::max)(least, T(1.01) * welded_reflection(media));
    if (least >= most) return std::nullopt;
    return ResolvableStiffness<T>{stiffness_from_reflection(most, media, angular_frequency),
                                  stiffness_from_reflection(least, media, angular_frequency), least, most};
}

}  // namespace fstiff
