// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact at many pressures or separations, with a status for each point in place of an exception.
///
///     const auto curve = fstiff::curve_at_pressures(contact, std::vector{1e6, 3e6, 1e7}, fstiff::Quantity::stiffness);
///
/// A contact has point_at_pressure(p, quantities) or point_at_separation(d, quantities), which return a ContactPoint. A
/// point out of reach of the model is a result and leaves the other points alone.
///
/// Units       those of the contact: pressures [Pa], separations [m]
/// Valid       pressures finite and greater than 0, separations finite; any number of them, in any order
/// Accuracy    every state is that of at_pressure or at_separation, bit for bit (tests/contact/contact_curve_test.cpp)

#include <fstiff/contact/contact_state.hpp>

#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Contact with a point at each pressure.
template <class C, class T>
concept HasPressures = Real<T> && requires(const C& contact, T pressure, Quantity quantities) {
    { contact.point_at_pressure(pressure, quantities) } -> std::same_as<ContactPoint<T>>;
};

/// Contact with a point at each separation.
template <class C, class T>
concept HasSeparations = Real<T> && requires(const C& contact, T separation, Quantity quantities) {
    { contact.point_at_separation(separation, quantities) } -> std::same_as<ContactPoint<T>>;
};

}  // namespace detail

/// The states of \p contact under \p pressures [Pa], a container such as a vector or a span of numbers.
/// \throws domain_error for a pressure that is not finite and greater than 0.
template <class Pressures, detail::HasPressures<typename Pressures::value_type> Contact>
[[nodiscard]] auto curve_at_pressures(const Contact& contact, const Pressures& pressures,
                                      Quantity quantities = Quantity::all) {
    using T = typename Pressures::value_type;
    for (const T pressure : pressures) detail::require_positive("pressure", pressure);
    std::vector<ContactPoint<T>> curve;
    curve.reserve(pressures.size());
    for (const T pressure : pressures) curve.push_back(contact.point_at_pressure(pressure, quantities));
    return curve;
}

/// The states of \p contact at \p separations [m] of the mean planes.
/// \throws domain_error for a separation that is not finite.
template <class Separations, detail::HasSeparations<typename Separations::value_type> Contact>
[[nodiscard]] auto curve_at_separations(const Contact& contact, const Separations& separations,
                                        Quantity quantities = Quantity::all) {
    using T = typename Separations::value_type;
    for (const T separation : separations)
        detail::require(std::isfinite(separation), "separation", separation, "finite (m)");
    std::vector<ContactPoint<T>> curve;
    curve.reserve(separations.size());
    for (const T separation : separations) curve.push_back(contact.point_at_separation(separation, quantities));
    return curve;
}

}}  // namespace fstiff
