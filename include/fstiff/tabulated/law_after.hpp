// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The law of a contact after its greatest load: what yielded then stays flat, so that it opens and closes reversibly.
///
///     -dp/dd = K(p after p_max)  below p_max;   -dp/dd of the first loading above;   both meet at d(p_max)
///
///     const auto loading = fstiff::ContactLaw<double>::tabulate(plastic, {1e5, 1e8});       // a bolt is tightened
///     const auto law = fstiff::law_after(loading, 20e6, hardness / (modulus * gradient));   // the joint vibrates
///
/// Reference   contact/earlier_load.hpp
/// Units       SI
/// Valid       laws of peaks that yield, whose K is that of unloading; an elastic law is its own law after any load.
///             The law above p_max is for one more load. Friction goes on with K there: along the first loading, which
///             is softer, a cycle would gain energy, and what it flattens in truth leaves K
/// Accuracy    K that of contact/earlier_load.hpp; -dp/dd is the slope of the returned p, and the energy of a closed
///             cycle its integral, within rounding (tests/tabulated/law_after_test.cpp)

#include <fstiff/contact/earlier_load.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <algorithm>
#include <limits>

namespace fstiff { inline namespace v0_1 {

/// The law after \p greatest_pressure [Pa] of \p first_loading, whose separations it shares; \p relative_hardness is
/// H/(E g), 0 where it is not known. Its K is -dp/dd, so that friction takes it.
/// \throws domain_error for a pressure outside of the law or at its least one, and a law of a K that is neither -dp/dd
/// nor that of unloading, and of OutsideRange::exact.
template <Real T>
[[nodiscard]] ContactLaw<T> law_after(const ContactLaw<T>& first_loading, std::type_identity_t<T> greatest_pressure,
                                      std::type_identity_t<T> relative_hardness) {
    const auto [least, most] = first_loading.pressures();
    if (!(greatest_pressure > least && greatest_pressure <= most))
        detail::refuse("greatest_pressure", greatest_pressure, 6,
                       "above " + detail::rounded_text(least, 6) + " and at most " + detail::rounded_text(most, 6) +
                           " Pa, within the range of the law");
    if (first_loading.stiffness_is_slope()) return first_loading;
    if (!first_loading.has_unloading())
        detail::refuse("law", "of a K that is not -dp/dd", "elastic, or of peaks that yield: it has no unloading");
    const T K = first_loading.stiffness(greatest_pressure), d = first_loading.separation(greatest_pressure);
    const auto opening = [&](T p) {
        const T ratio = (std::min)(first_loading.stiffness(p) / K, T(1));
        return K * static_cast<T>(detail::stiffness_after_load(static_cast<double>(ratio),
                                                               static_cast<double>(relative_hardness)));
    };
    const auto closing = [&](T p) { return first_loading.slope_at_separation(first_loading.separation(p)); };
    const auto part = [&](const auto& slope, T from, T to) {
        return ContactLaw<T>::tabulate_slope(slope, {from, to, first_loading.outside()});
    };
    const bool ends = greatest_pressure > most * (1 - 64 * std::numeric_limits<T>::epsilon());
    return ContactLaw<T>::joined(part(opening, least, greatest_pressure),
                                 ends ? ContactLaw<T>() : part(closing, greatest_pressure, most), d);
}

}}  // namespace fstiff
