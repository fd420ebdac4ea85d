// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A contact whose law is known by name only.
///
///     const auto contact = fstiff::contact_of(joint, fstiff::laws::hybrid);
///     const double p = 10e6;
///     contact->at_pressures(std::span(&p, 1), fstiff::Quantity::stiffness).front().state.stiffness.value    [Pa/m]
///
/// Reference   answer/chosen_law.hpp: the laws
/// Units       SI
/// Valid       as the law
/// Accuracy    that of the law: the same number as the contact by itself (tests/scene/laws_test.cpp)

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/load_means.hpp>
#include <fstiff/peaks/quantity.hpp>

#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 {

template <Real T>
class ContactLaw;
template <Real T>
struct LawRange;

/// A contact whose law is known by name only.
class AnyContact {
public:
    using Points = std::vector<ContactPoint<double>>;
    virtual ~AnyContact() = default;
    /// The states under pressures [Pa], and at separations [m]; a point out of reach has that status.
    [[nodiscard]] virtual Points at_pressures(std::span<const double> pressures, Quantity quantities) const = 0;
    [[nodiscard]] virtual Points at_separations(std::span<const double> separations, Quantity quantities) const = 0;
    /// How far the peaks are pressed in at each of \p etas, of states of this contact; empty where no range depends on
    /// it.
    [[nodiscard]] virtual std::vector<LoadMeans<double>> means_at(std::span<const double> /*etas*/) const { return {}; }
    [[nodiscard]] virtual bool has_table() const { return false; }
    /// The contact tabulated. \throws domain_error unless has_table(), and as
    /// ContactLaw::tabulate.
    [[nodiscard]] virtual ContactLaw<double> tabulate(const LawRange<double>& range) const;
};

}}  // namespace fstiff
