// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Common part of the contacts whose K is -dp/dd at every pressure, and which take no interaction: Persson's, the
/// hybrid one and that of the summits of a map. With it each of them is a Contact (contact/interaction.hpp).

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/math/quadrature.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/peaks/quantity.hpp>

#include <atomic>
#include <memory>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Numbers of panels or knots, each computed when it is first asked for. Copies share them; threads that ask at once
/// compute the same number.
template <Real T>
class Panels {
public:
    explicit Panels(std::size_t most) : known_(std::make_shared<std::vector<std::atomic<T>>>(most)) {
        for (auto& panel : *known_) panel.store(std::numeric_limits<T>::quiet_NaN(), std::memory_order_relaxed);
    }
    /// That of number \p i, which \p integral computes.
    template <class Integral>
    [[nodiscard]] T at(std::size_t i, const Integral& integral) const {
        if (i >= known_->size()) return integral();
        T value = (*known_)[i].load(std::memory_order_relaxed);
        if (std::isnan(value)) (*known_)[i].store(value = integral(), std::memory_order_relaxed);
        return value;
    }

private:
    std::shared_ptr<std::vector<std::atomic<T>>> known_;
};

/// Where panels of an integral over the logarithm of the pressure begin, from heavy loads on: after 0, 1, 2, 5, 8, 11,
/// ... e-folds, for lighter contacts are nearer to a power law; or after steps of one length.
template <Real T>
class PanelEdges {
public:
    PanelEdges() = default;
    explicit PanelEdges(T step) : step_(step) {}
    [[nodiscard]] T operator()(std::size_t panel) const {
        return step_ > 0 ? T(panel) * step_ : T(panel < 2 ? panel : 3 * panel - 4);
    }
    /// The number of panels that end at \p distance or before.
    [[nodiscard]] std::size_t before(T distance) const {
        const auto whole = static_cast<std::size_t>(step_ > 0 ? distance / step_ : distance);
        return step_ > 0 || whole < 2 ? whole : (whole + 4) / 3;
    }

private:
    T step_ = 0;
};

/// \p Derived has at_pressure, log_pressure and rms_height.
template <class Derived, Real T>
class SlopeContact {
public:
    /// The contact at the separation \p separation [m] of the mean planes; the error of its pressure enters every
    /// value. \throws domain_error as log_pressure.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        const T eta = separation / self().rms_height();
        const LogSlope<T> p = self().log_pressure(eta);
        const T pressure = std::exp(p.log);
        ContactState<T> state = self().at_pressure(pressure, quantities);
        for (Estimate<T>* e :
             {&state.stiffness, &state.loading_stiffness, &state.real_area_fraction, &state.contact_density})
            e->error += 2 * p.error * e->value;
        state.pressure =
            has(quantities, Quantity::pressure) ? Estimate<T>{pressure, p.error * pressure, 1} : Estimate<T>{};
        state.separation = {separation, 0, 0};
        state.eta = eta;
        return state;
    }
    /// at_pressure with a status: out_of_reach beyond the model. \throws domain_error unless positive.
    [[nodiscard]] ContactPoint<T> point_at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        require_positive("pressure", pressure);
        return point([&] { return self().at_pressure(pressure, quantities); });
    }
    /// at_separation with a status. \throws domain_error unless finite.
    [[nodiscard]] ContactPoint<T> point_at_separation(T separation, Quantity quantities = Quantity::all) const {
        require(std::isfinite(separation), "separation", separation, "finite (m)");
        return point([&] { return self().at_separation(separation, quantities); });
    }
    /// log(K/(Pa/m)) at eta, the separation over the rms height. \throws domain_error as log_pressure.
    [[nodiscard]] Estimate<T> log_stiffness(T eta) const {
        const LogSlope<T> p = self().log_pressure(eta);
        return {p.log + std::log(-p.slope / self().rms_height()), 2 * p.error};
    }
    [[nodiscard]] Interaction<T> interaction() const { return {}; }
    [[nodiscard]] T bulk_compliance() const { return T(0); }
    /// K is -dp/dd.
    [[nodiscard]] T stiffness_over_slope() const { return T(1); }

protected:
    // For a contact that has K(p) and, as an integral of it, the separation d(p): stiffness(p) and separation(p).

    /// int p/K d ln p = int dp/K over \p length of ln p from \p from on, by a Gauss-Legendre rule of so many points.
    template <std::size_t points>
    [[nodiscard]] T fall_of_separation(T from, T length) const {
        const auto& rule = math::GaussLegendre<T, points>::get();
        T sum = 0;
        for (std::size_t i = 0; i < points; ++i) {
            const T p = std::exp(from + length * (1 + rule.node[i]) / 2);
            sum += rule.weight[i] * p / self().stiffness(p);
        }
        return length / 2 * sum;
    }

    /// log p where d(p) = eta rms_height, between \p low and \p high. \throws domain_error naming eta, and \p reach.
    [[nodiscard]] LogSlope<T> searched_log_pressure(T eta, T low, T high, T guess, const char* reach) const {
        const T rms = self().rms_height(), tolerance = 16 * std::numeric_limits<T>::epsilon() * (1 + std::abs(high));
        const auto residual = [&](T log_p) {
            const T p = std::exp(log_p);
            return std::pair(self().separation(p).value - eta * rms, -p / self().stiffness(p));
        };
        const auto solution = math::newton_bracketed(residual, low, high, guess, tolerance);
        require(solution.converged(), "eta", eta, reach);
        const T p = std::exp(solution.root), per_height = self().stiffness(p) / p;
        return {solution.root, -per_height * rms, solution.error + self().separation(p).error * per_height};
    }

private:
    const Derived& self() const { return static_cast<const Derived&>(*this); }

    template <class Call>
    static ContactPoint<T> point(const Call& call) {
        try {
            return ContactPoint<T>::of(call());
        } catch (const domain_error& refusal) {
            return ContactPoint<T>::out_of_reach(refusal.what());
        }
    }
};

}}}  // namespace fstiff::detail
