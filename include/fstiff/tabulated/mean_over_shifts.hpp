// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Mean over contacts that are equally likely: two rough faces meet at an unknown shift.
///
///     value = mean of the values        error = sqrt((mean error)^2 + s^2),   s^2 = sum (value_i - value)^2/(n - 1)
///
///     std::vector<fstiff::SummitContact<double>> contacts;      // one for each shift
///     const fstiff::MeanOverShifts mean(std::move(contacts));
///     mean.at_pressure(1e6).stiffness.error                     // the scatter of one shift is in it
///
/// Reference   JCGM 100:2008, 4.2.2 (the scatter s of one shift, not of the mean)
/// Units       SI
/// Valid       contacts of one kind, one at least; of a single one the mean is that contact. A point that one of them
///             does not reach has no mean
/// Accuracy    rounding (tests/tabulated/mean_over_shifts_test.cpp)

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// The mean over \p C, one contact for each shift.
template <class C>
class MeanOverShifts {
    using T = decltype(std::declval<const C&>().rms_height());

public:
    /// \throws domain_error for no contact.
    explicit MeanOverShifts(std::vector<C> contacts) : contacts_(std::move(contacts)) {
        detail::require(!contacts_.empty(), "contacts", contacts_.size(), "at least 1");
    }

    [[nodiscard]] ContactPoint<T> point_at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        return mean([&](const C& contact) { return contact.point_at_pressure(pressure, quantities); });
    }
    [[nodiscard]] ContactPoint<T> point_at_separation(T separation, Quantity quantities = Quantity::all) const {
        return mean([&](const C& contact) { return contact.point_at_separation(separation, quantities); });
    }
    /// \throws domain_error where there is no point.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        return detail::state_or_throw(point_at_pressure(pressure, quantities));
    }
    /// \throws domain_error where there is no point.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        return detail::state_or_throw(point_at_separation(separation, quantities));
    }
    /// Root of the mean square over the contacts [m].
    [[nodiscard]] T rms_height() const {
        T square = 0;
        for (const C& contact : contacts_) square += contact.rms_height() * contact.rms_height();
        return std::sqrt(square / static_cast<T>(contacts_.size()));
    }

    /// Mean K and mean separation under a pressure as a table; the former is not the slope of the latter.
    /// \throws domain_error as ContactLaw::tabulate_points, and for a pressure that a contact does not reach.
    [[nodiscard]] ContactLaw<T> tabulate(const LawRange<T>& range) const {
        const auto state_at = [this](T pressure) {
            return at_pressure(pressure, Quantity::separation | Quantity::stiffness);
        };
        const ContactState<T> first = state_at(range.min_pressure);
        return ContactLaw<T>::tabulate_points(
            [&](T pressure) {
                const ContactState<T> state = state_at(pressure);
                return detail::LawPoint<T>{state.separation.value, state.stiffness.value};
            },
            first.separation.value / first.eta, range);
    }

private:
    [[nodiscard]] static Estimate<T> mean_of(const std::vector<ContactPoint<T>>& points,
                                             Estimate<T> ContactState<T>::*quantity) {
        const auto n = static_cast<T>(points.size());
        Estimate<T> mean;
        T square = 0;
        for (const auto& point : points) {
            const Estimate<T>& term = point.state.*quantity;
            mean.value += term.value / n, mean.error += term.error / n, mean.evaluations += term.evaluations;
        }
        for (const auto& point : points) {
            const T away = (point.state.*quantity).value - mean.value;
            square += away * away / (n - 1);
        }
        mean.error = std::hypot(mean.error, std::sqrt(square));
        return mean;
    }
    template <class PointOf>
    [[nodiscard]] ContactPoint<T> mean(const PointOf& point_of) const {
        std::vector<ContactPoint<T>> points;
        for (const C& contact : contacts_) points.push_back(point_of(contact));
        for (auto point = points.rbegin(); point != points.rend(); ++point)
            if (!point->ok()) return *point;
        if (points.size() == 1) return points.front();
        ContactState<T> state;
        using State = ContactState<T>;
        for (const auto quantity : {&State::separation, &State::pressure, &State::stiffness, &State::real_area_fraction,
                                    &State::contact_density, &State::loading_stiffness})
            state.*quantity = mean_of(points, quantity);
        for (const auto& point : points) state.eta += point.state.eta / static_cast<T>(points.size());
        return {PointStatus::ok, state, {}};
    }

    std::vector<C> contacts_;
};

}}  // namespace fstiff
