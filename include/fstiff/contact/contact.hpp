// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Concepts of a contact for curves, tabulated laws and fits. RoughContact fulfils them for all laws and peaks.

#include <fstiff/contact/interaction.hpp>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// A contact in the scalar T with states at a pressure [Pa] and at a separation [m], by exception or with a status, as
/// curves, bands and means over shifts need it.
template <class C, class T>
concept HasStates = requires(const C& contact, T x, Quantity quantities) {
    { contact.at_pressure(x, quantities) } -> std::same_as<ContactState<T>>;
    { contact.at_separation(x, quantities) } -> std::same_as<ContactState<T>>;
    { contact.point_at_pressure(x, quantities) } -> std::same_as<ContactPoint<T>>;
    { contact.point_at_separation(x, quantities) } -> std::same_as<ContactPoint<T>>;
    { contact.rms_height() } -> std::convertible_to<T>;
};

}  // namespace detail

/// One that can be tabulated and fitted: log p with its slope and log K against the separation over the rms height,
/// without interaction.
template <class C, class T>
concept Contact = detail::HasStates<C, T> && requires(const C& contact, T x) {
    { contact.log_pressure(x) } -> std::same_as<LogSlope<T>>;
    { contact.log_stiffness(x) } -> std::same_as<Estimate<T>>;
    { contact.interaction() } -> std::convertible_to<Interaction<T>>;
    { contact.bulk_compliance() } -> std::convertible_to<T>;
};

namespace detail {

/// One whose K is a constant times -dp/dd, so that one table by separation serves both; any other K has its own table,
/// and with interaction K itself is in series with the bulk.
template <class C, class T>
concept ProportionalContact = Contact<C, T> && requires(const C& contact) {
    { contact.stiffness_over_slope() } -> std::convertible_to<T>;
};

/// The state of \p point. \throws domain_error with its reason if it has no state.
template <Real T>
[[nodiscard]] ContactState<T> state_or_throw(const ContactPoint<T>& point) {
    if (!point.ok())
        throw domain_error(point.reason.empty() ? "a state is beyond the range of the scalar: must be less extreme"
                                                : point.reason);
    return point.state;
}

/// True if K(p) of \p contact has kinks, as that of a map where another summit touches.
template <class C>
[[nodiscard]] bool has_kinks(const C& contact) {
    if constexpr (requires { contact.has_kinks(); })
        return contact.has_kinks();
    else
        return false;
}

}  // namespace detail

}}  // namespace fstiff
