// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A contact at many pressures or separations, with a status for each point in place of an exception.
///
///     const auto curve = fstiff::curve_at_pressures(contact, std::vector{1e6, 3e6, 1e7}, fstiff::Quantity::stiffness);
///     for (const auto& point : curve)
///         if (point.ok()) use(point.state.stiffness.value);
///
/// A contact is whatever has at_pressure(p, wanted), or at_separation(d, wanted), and returns a ContactState. A point that
/// the model does not reach (a pressure so small that it underflows, a separation below -1000 rms heights) is a result, not
/// a mistake of the caller: it leaves the other points alone.
///
/// Units       those of the contact: pressures [Pa], separations [m]
/// Valid       pressures finite and greater than 0, separations finite; any number of them, in any order
/// Accuracy    every state is that of at_pressure or at_separation, bit for bit (tests/contact/contact_curve_test.cpp)

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/quantity.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <vector>

namespace fstiff {

/// What can be asked for its state at a pressure.
template <class C, class T>
concept HasPressures = Real<T> && requires(const C& contact, T pressure, Quantity wanted) {
    { contact.at_pressure(pressure, wanted) } -> std::convertible_to<ContactState<T>>;
};

/// What can be asked for its state at a separation.
template <class C, class T>
concept HasSeparations = Real<T> && requires(const C& contact, T separation, Quantity wanted) {
    { contact.at_separation(separation, wanted) } -> std::convertible_to<ContactState<T>>;
};

enum class PointStatus {
    ok,
    out_of_reach,   ///< the model has no state there; ContactPoint::reason tells what it has
    beyond_numbers  ///< a value or an error, doubled, is beyond the range of the scalar
};

/// One point of a curve.
template <Real T>
struct ContactPoint {
    PointStatus status = PointStatus::ok;
    ContactState<T> state{};  ///< out of reach: all 0, but for a stiffness that is NaN
    std::string reason{};     ///< of out_of_reach: what the contact said; else empty

    [[nodiscard]] bool ok() const { return status == PointStatus::ok; }
};

/// Whether every value and error of \p state is a number that may be doubled: the tangential stiffness is up to 4/3 of K.
template <Real T>
[[nodiscard]] bool in_range(const ContactState<T>& state) {
    for (const Estimate<T>* one : {&state.separation, &state.pressure, &state.stiffness, &state.real_area_fraction,
                                   &state.contact_density, &state.loading_stiffness})
        if (!std::isfinite(2 * one->value) || !std::isfinite(2 * one->error)) return false;
    return true;
}

namespace detail {

/// The point that \p state_at gives, whatever it throws of the domain of the model.
template <Real T, class StateAt>
ContactPoint<T> contact_point(const StateAt& state_at) {
    ContactPoint<T> point;
    try {
        point.state = state_at();
        if (!in_range(point.state)) point.status = PointStatus::beyond_numbers;
    } catch (const domain_error& refusal) {
        point.status = PointStatus::out_of_reach;
        point.reason = refusal.what();
        point.state.stiffness.value = std::numeric_limits<T>::quiet_NaN();
    }
    return point;
}

}  // namespace detail

/// The states of \p contact under \p pressures [Pa], a container such as std::vector<double> or std::span<const double>.
/// \throws domain_error for a pressure that is not finite and greater than 0.
template <class Pressures, HasPressures<typename Pressures::value_type> Contact>
[[nodiscard]] auto curve_at_pressures(const Contact& contact, const Pressures& pressures,
                                      Quantity wanted = Quantity::all) {
    using T = typename Pressures::value_type;
    for (const T pressure : pressures) require_positive("pressure", pressure);
    std::vector<ContactPoint<T>> curve;
    curve.reserve(pressures.size());
    for (const T pressure : pressures)
        curve.push_back(detail::contact_point<T>([&] { return contact.at_pressure(pressure, wanted); }));
    return curve;
}

/// The states of \p contact at \p separations [m] of the mean planes.
/// \throws domain_error for a separation that is not finite.
template <class Separations, HasSeparations<typename Separations::value_type> Contact>
[[nodiscard]] auto curve_at_separations(const Contact& contact, const Separations& separations,
                                        Quantity wanted = Quantity::all) {
    using T = typename Separations::value_type;
    for (const T separation : separations) require(std::isfinite(separation), "separation", separation, "finite (m)");
    std::vector<ContactPoint<T>> curve;
    curve.reserve(separations.size());
    for (const T separation : separations)
        curve.push_back(detail::contact_point<T>([&] { return contact.at_separation(separation, wanted); }));
    return curve;
}

}  // namespace fstiff
