// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace microslip_test {

using namespace fstiff;
using detail::FlowedUnloading;
using detail::loss_factor;
using detail::PowerUnloading;

namespace {

constexpr double pi = std::numbers::pi;

/// Integral of \p f from 0 to \p x by the rule of Simpson.
template <class F>
double integral(const F& f, double x) {
    constexpr int parts = 4000;
    double sum = 0;
    for (int i = 0; i <= parts; ++i) sum += (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2) * f(x * i / parts);
    return sum * x / parts / 3;
}

/// Load, its integral and its second derivative belong together, and the loss factor to them.
template <class Unloading>
void check_one(const Unloading& contact, double x) {
    CAPTURE(x);
    CHECK(test::relative_error(contact.load(1e-9), 1 - 1e-9) < 1e-12);  // K is -dp/dd
    CHECK(test::relative_error(contact.work(x), integral([&](double t) { return contact.load(t); }, x)) < 1e-9);
    const double h = 1e-4 * x;
    const double bend = (contact.load(x + h) - 2 * contact.load(x) + contact.load(x - h)) / (h * h);
    CHECK(std::abs(bend - contact.bend(x)) < 1e-5 * (1 + contact.bend(x)));
    const double excess = integral([&](double t) { return t * (x - t) * contact.bend(t); }, x);
    CHECK(test::relative_error(loss_factor(contact, x), 4 / pi * excess / ((1 - contact.load(x)) * x)) < 1e-7);
}

}  // namespace

TEST_CASE("load, work and loss of an unloading belong together") {
    for (const double m : {0.0, 1.0 / 3, 0.7, 1.0, 1.3})
        for (const double x : {0.05, 0.3, 0.9}) check_one(PowerUnloading<double>{m}, x);
    for (const double x : {0.05, 0.3, 0.9, 1.2}) check_one(FlowedUnloading<double>{}, x);
    CHECK(std::abs(loss_factor(PowerUnloading<double>{1 / 3.0}, 1e6) - 4 / pi) < 1e-5);  // a slider of Coulomb
    CHECK(std::abs(loss_factor(FlowedUnloading<double>{}, 1e6) - 4 / pi) < 1e-5);
    const double endless = std::numeric_limits<double>::infinity();
    CHECK(std::abs(loss_factor(PowerUnloading<double>{0.9}, endless) - 4 / pi) < 1e-14);
    CHECK(loss_factor(PowerUnloading<double>{1}, 0.0) == 0);
    CHECK(std::abs(loss_factor(PowerUnloading<double>{0}, 0.9)) < 1e-14);  // slips nowhere, then all at once
}

TEST_CASE("the loss of one sphere is that of Mindlin and Deresiewicz, and an exponential law's is its own") {
    for (const double share : {0.001, 0.3, 0.9}) {  // Q/(mu P)
        const double x = 1.5 * (1 - std::pow(1 - share, 2.0 / 3));
        const double lost = 7.2 * (1 - std::pow(1 - share, 5.0 / 3) -
                                   5 * share / 6 * (1 + std::pow(1 - share, 2.0 / 3)));  // over mu^2 p^2/kt
        CHECK(test::relative_error(loss_factor(PowerUnloading<double>{1 / 3.0}, x), lost / (pi * share * x)) < 1e-5);
    }
    CHECK(test::relative_error(loss_factor(PowerUnloading<double>{1}, 2.0),
                               4 / pi * (1 + std::exp(-2.0) + std::expm1(-2.0)) / -std::expm1(-2.0)) < 1e-14);
}

TEST_CASE("a flowed spot is unloaded like springs under the load of a uniform pressure") {
    constexpr int springs = 200000;
    for (const double part : {0.1, 0.5, 0.95}) {  // of the displacement that frees the last spring
        double load = 0, whole = 0;
        for (int i = 0; i < springs; ++i) {
            const double at = (i + 0.5) / springs, pressed = std::sqrt(1 - at * at);
            whole += pressed, load += std::max(pressed - part, 0.0);
        }
        CHECK(test::relative_error(FlowedUnloading<double>{}.load(4 / pi * part), load / whole) < 1e-6);
    }
}

TEST_CASE("p, K and the fall of K give the loss factor of the law itself") {
    const Roughness<double> fine = test::sand_blasted_fine.roughness();
    constexpr double modulus = 112.6e9, mu = 0.3, ratio = 0.82;
    const LawRange<double> range{1e3, 1e9, OutsideRange::extrapolate};
    double worst = 0;
    const auto compare = [&](const auto& contact) {
        const auto law = ContactLaw<double>::tabulate(contact, range);
        const TangentialLaw<double> friction(law, mu, ratio);
        for (const double p : {1e5, 1e6, 1e7, 1e8})
            for (const double x : {0.01, 0.1, 0.3, 1.0}) {
                const double k = law.stiffness(p);
                const double growth = std::log(k / law.stiffness(0.6 * p)) / std::log(1 / 0.6);
                const double truth = friction.cycle(law.separation(p), x * mu * p / (ratio * k)).loss_factor;
                worst = std::max(worst, test::relative_error(loss_factor(PowerUnloading<double>{growth}, x), truth));
            }
    };
    compare(RoughContact(fine, PeakDistribution<double>::exponential(pi / 3), HertzLaw<double>{}, modulus));
    compare(GreenwoodWilliamson<double>(fine, modulus));
    compare(GreenwoodWilliamson<double>(fine, modulus, Heights::exponential));
    CAPTURE(worst);
    CHECK(worst < 0.03);
    CHECK(worst > 1e-4);
}

}  // namespace microslip_test
