// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The contacts of the library in AnyContact. For answer/laws_inline.hpp.

#include <fstiff/answer/laws.hpp>

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/load_weighted.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/mean_over_shifts.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Whether \p Contact is a mean over contacts that can be tabulated.
template <class Contact>
inline constexpr bool is_mean_of_tabulated = false;
template <class One>
inline constexpr bool is_mean_of_tabulated<MeanOverShifts<One>> = fstiff::Contact<One, double>;

template <class Contact>
class ErasedContact : public AnyContact {
public:
    explicit ErasedContact(Contact contact) : contact_(std::move(contact)) {}
    Points at_pressures(std::span<const double> pressures, Quantity quantities) const override {
        return curve_at_pressures(contact_, pressures, quantities);
    }
    Points at_separations(std::span<const double> separations, Quantity quantities) const override {
        return curve_at_separations(contact_, separations, quantities);
    }
    bool has_table() const override { return fstiff::Contact<Contact, double> || is_mean_of_tabulated<Contact>; }
    ContactLaw<double> tabulate(const LawRange<double>& range) const override {
        if constexpr (fstiff::Contact<Contact, double>)
            return ContactLaw<double>::tabulate(contact_, range);
        else if constexpr (is_mean_of_tabulated<Contact>)
            return contact_.tabulate(range);
        else
            return AnyContact::tabulate(range);
    }

protected:
    Contact contact_;
};

/// A contact of plastic peaks, which begin to yield at omega_c = critical_over_radius R.
template <class Contact>
class ErasedPlasticContact final : public ErasedContact<Contact> {
public:
    ErasedPlasticContact(Contact contact, double critical_over_radius)
        : ErasedContact<Contact>(std::move(contact)), critical_over_radius_(critical_over_radius) {}
    std::vector<LoadMeans<double>> means_at(std::span<const double> etas) const override {
        std::vector<LoadMeans<double>> means;
        for (const double eta : etas) means.push_back(detail::load_means(this->contact_, eta, critical_over_radius_));
        return means;
    }

private:
    double critical_over_radius_;
};

/// Hybrid of one of many surfaces, as far as PlasticContact needs it.
class QuickElastic {
public:
    explicit QuickElastic(const ContactInputs& inputs) : inputs_(&inputs) {}
    double stiffness(double p) const {
        const auto K = inputs_->similar->stiffness(*inputs_, p);
        if (!K) throw domain_error("pressure: must be within the table of surfaces");
        return *K;
    }
    ContactState<double> at_pressure(double p, Quantity) const {
        ContactState<double> state;
        state.stiffness.value = stiffness(p);
        return state;
    }
    double full_pressure() const { return 2 * inputs_->effective_modulus * std::sqrt(2 * inputs_->moments.m2); }
    double rms_height() const { return std::sqrt(inputs_->moments.m0); }

private:
    const ContactInputs* inputs_;
};

/// K of a law of hybrid of one of many surfaces for a band, as \p of_hybrid makes K(K of hybrid, p) and p(d) of it; of
/// the law itself where that is not known.
template <class OfHybrid>
class QuickContact final : public AnyContact {
public:
    using Make = std::unique_ptr<AnyContact> (*)(const ContactInputs&);
    QuickContact(const ContactInputs& inputs, Make make, OfHybrid of_hybrid)
        : inputs_(inputs), make_(make), of_hybrid_(std::move(of_hybrid)) {}
    Points at_pressures(std::span<const double> pressures, Quantity quantities) const override {
        std::vector<ContactPoint<double>> points;
        for (const double& p : pressures) {
            const auto hybrid = inputs_.similar->stiffness(inputs_, p);
            const std::optional<double> K = hybrid ? of_hybrid_.stiffness(inputs_, *hybrid, p) : std::nullopt;
            if (!K) {
                points.push_back(itself().at_pressures(std::span(&p, 1), quantities).front());
                continue;
            }
            ContactState<double> state;
            state.pressure = {p, 0, 0};
            state.stiffness = {*K, 1.2e-3 * *K, 0};
            points.push_back(ContactPoint<double>::of(state));
        }
        return points;
    }
    Points at_separations(std::span<const double> separations, Quantity quantities) const override {
        std::vector<ContactPoint<double>> points;
        if (!pressure_) pressure_ = of_hybrid_.pressure(inputs_);
        for (const double& d : separations) {
            const double p = pressure_(d).value_or(0);
            points.push_back(p > 0 ? at_pressures(std::span(&p, 1), quantities).front()
                                   : itself().at_separations(std::span(&d, 1), quantities).front());
        }
        return points;
    }

private:
    const AnyContact& itself() const {
        if (!itself_) itself_ = make_(inputs_);
        return *itself_;
    }
    ContactInputs inputs_;
    Make make_;
    OfHybrid of_hybrid_;
    mutable std::unique_ptr<AnyContact> itself_;
    mutable QuickHybrid::PressureOver pressure_;
};

template <class Contact>
std::unique_ptr<AnyContact> erase(Contact contact) {
    return std::make_unique<ErasedContact<Contact>>(std::move(contact));
}

/// \p contacts of several shifts as their mean, one as it is.
template <class Contact>
std::unique_ptr<AnyContact> mean_over(std::vector<Contact> contacts) {
    if (contacts.size() == 1) return erase(std::move(contacts.front()));
    return erase(MeanOverShifts<Contact>(std::move(contacts)));
}

}}}  // namespace fstiff::detail
