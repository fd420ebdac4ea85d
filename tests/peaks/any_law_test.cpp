// SPDX-License-Identifier: BSD-3-Clause
// Contacts of laws that a user writes. Truth: the closed integrals of the same law given its powers, the contact
// integrals themselves, and differences of p(d).
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/user_laws.hpp"

#include <numbers>

namespace any_law_test {

using namespace fstiff;
using test::HertzByUser;
using test::YieldByUser;

namespace {

constexpr double pi = std::numbers::pi;
const Roughness<double> fine{0.832e-6, 40e-6, 500e6};
constexpr double modulus = 112.6e9;

/// Hertz as plain functions of numbers.
struct PlainHertz {
    double load(double omega, double radius) const { return 4.0 / 3 * std::sqrt(radius * omega) * omega; }
    double stiffness(double omega, double radius) const { return 2 * std::sqrt(radius * omega); }
    double area(double omega, double radius) const { return pi * radius * omega; }
};

/// Abbott and Firestone: mean pressure H, elastic on unloading.
struct PlasticByUser {
    double hardness_over_modulus;
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    double load_factor() const { return 2 * pi * hardness_over_modulus; }
    double stiffness_factor() const { return 2 * std::numbers::sqrt2; }
    double area_factor() const { return 2 * pi; }
    auto load(const auto& omega, const auto& radius) const { return load_factor() * radius * omega; }
    auto stiffness(const auto& omega, const auto& radius) const {
        using std::sqrt;
        return stiffness_factor() * sqrt(radius * omega);
    }
    auto area(const auto& omega, const auto& radius) const { return area_factor() * radius * omega; }
};

/// No physics: at omega^0 the number of peaks, the slope of the load and the stiffness have three powers of R.
struct ThreePowers {
    static constexpr HalfPowers load_powers{2, 1}, stiffness_powers{0, 2}, area_powers{2, 2};
    static constexpr double load_factor() { return 2; }
    static constexpr double stiffness_factor() { return 3; }
    static constexpr double area_factor() { return 5; }
};

/// A layer of springs, as in docs/extending.md.
struct FoundationLaw {
    double thickness;
    static constexpr bool stiffness_is_slope = true;
    auto load(const auto& omega, const auto& radius) const { return pi / thickness * radius * omega * omega; }
    auto stiffness(const auto& omega, const auto& radius) const { return 2 * pi / thickness * radius * omega; }
    auto area(const auto& omega, const auto& radius) const { return 2 * pi * radius * omega; }
};

static_assert(detail::PowerLaw<HertzLaw<double>> && detail::PowerLaw<FractalLaw<float>, float> &&
              detail::PowerLaw<PlasticByUser>);
static_assert(!detail::PowerLaw<HertzByUser> && detail::ContactableLaw<HertzByUser, double>);

struct WithoutArea {
    auto load(const auto& omega, double) const { return omega; }
    auto stiffness(const auto& omega, double) const { return omega; }
};
static_assert(!detail::ContactableLaw<WithoutArea, double>);

/// Five points; the error of the formula is h^4, that of rounding eps/h.
template <class Contact>
double slope(const Contact& contact, double d, double h) {
    const auto p = [&](double x) { return contact.at_separation(x, Quantity::pressure).pressure.value; };
    return -(8 * (p(d + h) - p(d - h)) - (p(d + 2 * h) - p(d - 2 * h))) / (12 * h);
}

/// All quantities of two contacts of one law, at separations.
template <class A, class B>
void same(const A& a, const B& b, double bound) {
    for (const double eta : {-1.0, 0.3, 1.5, 3.0, 6.0}) {
        const auto x = a.at_separation(eta * fine.rms_height), y = b.at_separation(eta * fine.rms_height);
        INFO("eta " << eta);
        CHECK(test::relative_error(x.pressure.value, y.pressure.value) < bound);
        CHECK(test::relative_error(x.stiffness.value, y.stiffness.value) < bound);
        CHECK(test::relative_error(x.real_area_fraction.value, y.real_area_fraction.value) < bound);
        CHECK(test::relative_error(x.contact_density.value, y.contact_density.value) < bound);
        // by parts, terms of both signs cancel
        CHECK(test::relative_error(x.loading_stiffness.value, y.loading_stiffness.value) < 100 * bound);
        CHECK(std::abs(x.pressure.value - y.pressure.value) <= x.pressure.error + y.pressure.error);
    }
}

}  // namespace

TEST_CASE("a law without powers gives the results of its powers") {
    for (const auto& [r, theta] : {std::pair(0.0, 0.8), std::pair(0.5, 1.0), std::pair(0.9, 1.2)}) {
        const PeakDistribution<double> peaks(r, theta);
        INFO("r " << r);
        same(RoughContact(fine, peaks, HertzByUser{}, modulus), RoughContact(fine, peaks, HertzLaw<double>{}, modulus),
             1e-11);
    }
    for (const Heights heights : {Heights::gaussian, Heights::exponential})
        same(RoughContact(fine, SingleRadius<double>{heights}, HertzByUser{}, modulus),
             GreenwoodWilliamson<double>(fine, modulus, heights), 1e-10);
}

TEST_CASE("a law of plain functions gives the results of one of arrays") {
    const PeakDistribution<double> peaks(0.5, 1.0);
    // the rule in two dimensions has no information on the root of the plain law at omega = 0
    same(RoughContact(fine, peaks, PlainHertz{}, modulus), RoughContact(fine, peaks, HertzLaw<double>{}, modulus),
         1e-9);
}

TEST_CASE("each quantity of a law has powers of its own: plastic peaks") {
    const PeakDistribution<double> peaks(0.5, 1);
    const double hardness = 1.12e9;
    const RoughContact contact(fine, peaks, PlasticByUser{hardness / modulus}, modulus);
    const double curvature = detail::rms_curvature(fine, peaks);
    for (const double eta : {-1.0, 1.0, 3.0}) {
        const auto at = contact.at_separation(eta * fine.rms_height);
        const auto j = [&](double a, double b) { return contact_integral(a, b, peaks, eta).value; };
        INFO("eta " << eta);
        // theory: A = 2 pi D_p sigma/sigma_kappa J[1,-1], p = H A, K = sqrt(2) of Hertz, -dp/dd = 2 pi H D_p
        // J[0,-1]/sigma_kappa
        CHECK(test::relative_error(at.real_area_fraction.value,
                                   2 * pi * fine.peak_density * fine.rms_height / curvature * j(1, -1)) < 1e-14);
        CHECK(test::relative_error(at.pressure.value, hardness * at.real_area_fraction.value) < 1e-14);
        CHECK(test::relative_error(at.stiffness.value,
                                   std::numbers::sqrt2 * RoughContact(fine, peaks, HertzLaw<double>{}, modulus)
                                                             .at_separation(eta * fine.rms_height)
                                                             .stiffness.value) < 1e-14);
        CHECK(test::relative_error(at.loading_stiffness.value,
                                   2 * pi * hardness * fine.peak_density * j(0, -1) / curvature) < 1e-14);
        CHECK(test::relative_error(at.contact_density.value, fine.peak_density * j(0, 0)) < 1e-14);
        CHECK(test::relative_error(slope(contact, eta * fine.rms_height, 1e-3 * fine.rms_height),
                                   at.loading_stiffness.value) < 1e-10);
    }
    const auto back = contact.at_pressure(5e6);
    CHECK(test::relative_error(contact.at_separation(back.separation.value).pressure.value, 5e6) < 1e-12);
}

TEST_CASE("three powers of R at one power of omega take three passes") {
    const PeakDistribution<double> peaks(0.5, 1);
    const double eta = 0.7, curvature = detail::rms_curvature(fine, peaks);
    const auto at = RoughContact(fine, peaks, ThreePowers{}, modulus).at_separation(eta * fine.rms_height);
    const auto j = [&](double a, double b) { return fine.peak_density * contact_integral(a, b, peaks, eta).value; };
    CHECK(test::relative_error(at.contact_density.value, j(0, 0)) < 1e-14);
    CHECK(test::relative_error(at.loading_stiffness.value, 2 * modulus * j(0, -0.5) / std::sqrt(curvature)) < 1e-14);
    CHECK(test::relative_error(at.stiffness.value, 3 * modulus * j(0, -1) / curvature) < 1e-14);
    CHECK(test::relative_error(at.pressure.value, 2 * modulus * fine.rms_height * j(1, -0.5) / std::sqrt(curvature)) <
          1e-14);
    CHECK(test::relative_error(at.real_area_fraction.value, 5 * fine.rms_height * j(1, -1) / curvature) < 1e-14);
}

TEST_CASE("the loading stiffness of a law with a kink is the slope of its pressure") {
    const auto check = [](const auto& contact) {
        for (const double eta : {0.2, 1.5, 3.0}) {  // exponential heights begin at 0
            const double d = eta * fine.rms_height;
            const auto at = contact.at_separation(d);
            INFO("eta " << eta);
            CHECK(test::relative_error(slope(contact, d, 3e-3 * fine.rms_height), at.loading_stiffness.value) < 1e-7);
            CHECK(at.stiffness.value > at.loading_stiffness.value);
            const auto back = contact.at_pressure(at.pressure.value, Quantity::stiffness);
            CHECK(test::relative_error(back.stiffness.value, at.stiffness.value) < 1e-9);
        }
    };
    check(RoughContact(fine, PeakDistribution<double>(0.5, 1), YieldByUser{}, modulus));
    check(RoughContact(fine, SingleRadius<double>{}, YieldByUser{}, modulus));
    check(RoughContact(fine, SingleRadius<double>{Heights::exponential}, YieldByUser{}, modulus));
}

TEST_CASE("the layer of springs: a contact, a curve and a tabulated law") {
    const RoughContact contact(fine, PeakDistribution<double>(0.5, 1), FoundationLaw{1e-6}, modulus);
    const auto law = ContactLaw<double>::tabulate(contact, {.min_pressure = 1e5, .max_pressure = 1e7});
    for (const double p : {2e5, 1e6, 9e6}) {
        const auto at = contact.at_pressure(p);
        CHECK(test::relative_error(at.stiffness.value, at.loading_stiffness.value) < 1e-9);
        CHECK(test::relative_error(law.stiffness(p), at.stiffness.value) < 1e-8);
        CHECK(law.relative_error() < 1e-6);
    }
}

TEST_CASE("interaction is in series with every law, and with peaks of one radius") {
    const RoughContactOptions<double> interacting{.interaction = {InteractionReading::effective_separation, 1e-4}};
    const auto check = [](const auto& alone, const auto& contact) {
        for (const double p : {1e6, 1e8}) {
            const auto free = alone.at_pressure(p), at = contact.at_pressure(p);
            CHECK(test::relative_error(1 / at.stiffness.value, 1 / free.stiffness.value + 1e-4 / modulus) < 1e-12);
            CHECK(at.stiffness.value <= modulus / 1e-4);
            CHECK(test::relative_error(free.separation.value - at.separation.value, p * 1e-4 / modulus) < 1e-8);
            const auto back = contact.at_separation(at.separation.value);
            CHECK(test::relative_error(back.pressure.value, p) < 1e-9);
            CHECK(test::relative_error(slope(contact, at.separation.value, 1e-3 * fine.rms_height),
                                       at.loading_stiffness.value) < 1e-8);
        }
    };
    const PeakDistribution<double> peaks(0.5, 1);
    check(RoughContact(fine, peaks, FractalConsistentLaw<double>(1.62), modulus),
          RoughContact(fine, peaks, FractalConsistentLaw<double>(1.62), modulus, interacting));
    check(GreenwoodWilliamson<double>(fine, modulus),
          GreenwoodWilliamson<double>(fine, modulus, Heights::gaussian, interacting));
    check(RoughContact(fine, peaks, PlasticByUser{0.01}, modulus),
          RoughContact(fine, peaks, PlasticByUser{0.01}, modulus, interacting));
    // the printed law keeps K = f (-dp/dd), bulk included
    const RoughContact printed(fine, peaks, FractalLaw<double>(1.62), modulus, interacting);
    const auto at = printed.at_pressure(1e8);
    CHECK(test::relative_error(at.stiffness.value,
                               detail::fractal_stiffness_factor(1.62) * at.loading_stiffness.value) < 1e-14);
}

}  // namespace any_law_test
