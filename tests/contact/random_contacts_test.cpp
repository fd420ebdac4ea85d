// SPDX-License-Identifier: BSD-3-Clause
// 200 random contacts of every law. Truth: the load, the stiffness and the area of one asperity, integrated over the
// density of the peaks by panels, with (4.4)-(4.11) written out anew.
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/panels.hpp"

#include <numbers>
#include <random>

namespace random_contacts_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi;

/// Abbott and Firestone: mean pressure H, elastic on unloading.
struct PlasticLaw {
    double hardness_over_modulus;
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    double load_factor() const { return 2 * pi * hardness_over_modulus; }
    double stiffness_factor() const { return 2 * std::numbers::sqrt2; }
    double area_factor() const { return 2 * pi; }
    double load(double omega, double radius) const { return load_factor() * radius * omega; }
    double stiffness(double omega, double radius) const { return stiffness_factor() * std::sqrt(radius * omega); }
    double area(double omega, double radius) const { return area_factor() * radius * omega; }
};

struct Scene {
    Roughness<double> surface;
    double r, theta, modulus, dimension, hardness, eta, length;
};

/// The same with every standard library.
Scene random_scene(std::mt19937& random) {
    const auto uniform = [&](double a, double b) { return a + (b - a) * double(random()) * 0x1p-32; };
    const auto decades = [&](double a, double b) { return std::pow(10, uniform(a, b)); };
    Scene s{};
    s.surface = {decades(-7.5, -5), decades(-6.5, -4), decades(7.5, 11)};
    s.r = uniform(0, 0.98);
    s.theta = uniform(0.05, 1.55);
    s.modulus = decades(9.5, 11.5);
    s.dimension = uniform(1.02, 1.95);
    s.hardness = decades(-3, -1);
    s.eta = uniform(-1, 5.5);
    s.length = decades(-6, -2);
    return s;
}

/// Calls check(law) with the law of scene number \p i.
template <class Check>
void with_law(int i, const Scene& s, const Check& check) {
    if (i % 4 == 0) check(HertzLaw<double>{});
    if (i % 4 == 1) check(FractalLaw<double>(s.dimension));
    if (i % 4 == 2) check(FractalConsistentLaw<double>(s.dimension));
    if (i % 4 == 3) check(PlasticLaw{s.hardness});
}

/// The mean of f(omega, R) over all peaks, by (4.4) and (4.10) as printed.
template <class F>
double mean_over_peaks(const Scene& s, const F& f) {
    const double sigma = s.surface.rms_height, curvature = 3 * std::sqrt(pi) / (8 * s.surface.peak_radius);
    const double c = std::sqrt((1 - s.r) * (1 + s.r)), k = std::tan(s.theta) / std::numbers::sqrt2;
    const double sum = test::panels(0, 9 + s.r * std::max(s.eta, 0.0), 24, [&](double t) {
        const double begin = std::max(s.eta, s.r * t - 9 * c), end = std::max(s.eta, s.r * t) + 9 * c;
        return test::panels(begin, end, 5, [&](double zeta) {
            const double z = (zeta - s.r * t) / c;
            return f(sigma * (zeta - s.eta), 1 / (curvature * t)) * std::erf(k * t) * std::exp(-(z * z + t * t) / 2);
        });
    });
    return sum / (2 * s.theta * c);
}

/// The same over peaks of one radius.
template <class F>
double mean_over_heights(const Scene& s, Heights heights, const F& f) {
    const bool gaussian = heights == Heights::gaussian;
    const double begin = gaussian ? s.eta : std::max(s.eta, 0.0), reach = gaussian ? 10 : 40;
    return test::panels(begin, std::max(s.eta, 0.0) + reach, 24, [&](double height) {
        const double density = gaussian ? std::exp(-height * height / 2) / std::sqrt(2 * pi) : std::exp(-height);
        return f(s.surface.rms_height * (height - s.eta), s.surface.peak_radius) * density;
    });
}

/// p, K, A/A0 and n/A0 of \p state against means over the peaks; the stated errors cover the difference.
template <class Law, class Mean>
void check_state(const ContactState<double>& state, const Scene& s, const Law& law, const Mean& mean) {
    const double density = s.surface.peak_density;
    const auto same = [](const Estimate<double>& found, double truth) {
        CAPTURE(found.value, found.error, truth);
        CHECK(test::relative_error(found.value, truth) < 1e-13);
        CHECK(std::abs(found.value - truth) <= found.error + 3e-14 * truth);  // of the panels
    };
    same(state.pressure,
         s.modulus * density * mean([&](double omega, double radius) { return law.load(omega, radius); }));
    same(state.stiffness,
         s.modulus * density * mean([&](double omega, double radius) { return law.stiffness(omega, radius); }));
    same(state.real_area_fraction,
         density * mean([&](double omega, double radius) { return law.area(omega, radius); }));
    same(state.contact_density, density * mean([](double, double) { return 1.0; }));
}

}  // namespace

TEST_CASE("200 random contacts: p, K, area and contacts are the means over the peaks to 1e-13") {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const Scene s = random_scene(random);
        CAPTURE(i, s.r, s.theta, s.eta);
        with_law(i, s, [&](const auto& law) {
            const RoughContact contact(s.surface, PeakDistribution<double>(s.r, s.theta), law, s.modulus);
            check_state(contact.at_separation(s.eta * s.surface.rms_height), s, law,
                        [&](const auto& f) { return mean_over_peaks(s, f); });
        });
        for (const Heights heights : {Heights::gaussian, Heights::exponential})
            check_state(
                GreenwoodWilliamson<double>(s.surface, s.modulus, heights).at_separation(s.eta * s.surface.rms_height),
                s, HertzLaw<double>{}, [&](const auto& f) { return mean_over_heights(s, heights, f); });
    }
}

TEST_CASE("200 random contacts: pressure and separation are each other's inverse to 1e-13, with interaction too") {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const Scene s = random_scene(random);
        const double sigma = s.surface.rms_height;
        CAPTURE(i, s.r, s.theta, s.eta, s.length);
        with_law(i, s, [&](const auto& law) {
            const PeakDistribution<double> peaks(s.r, s.theta);
            const auto with = [&](InteractionReading reading) {
                return RoughContact(s.surface, peaks, law, s.modulus, {.interaction = {reading, s.length}});
            };
            const RoughContact alone(s.surface, peaks, law, s.modulus);
            const auto free = alone.at_separation(s.eta * sigma);
            const double p = free.pressure.value, k = free.stiffness.value, slope = free.loading_stiffness.value;
            const double bulk = s.length / s.modulus;
            CHECK(std::abs(alone.at_pressure(p).eta - s.eta) < 1e-13 * (1 + std::abs(s.eta)));

            // (4.11), the bulk in series: K is a constant times -dp/dd, or itself in series
            const auto series = with(InteractionReading::effective_separation);
            const auto pressed = series.at_pressure(p);
            using Contact = std::remove_cvref_t<decltype(alone)>;
            const double with_bulk = Contact::stiffness_follows_slope ? slope : k;
            CHECK(test::relative_error(pressed.stiffness.value, k / (1 + with_bulk * bulk)) < 1e-12);
            CHECK(test::relative_error(pressed.loading_stiffness.value, slope / (1 + slope * bulk)) < 1e-12);
            const double nominal = s.eta - p * bulk / sigma;
            CHECK(std::abs(pressed.separation.value / sigma - nominal) < 1e-12 * (1 + std::abs(nominal)));
            if (nominal > -1000) {
                // rounding of the separation, through its slope
                const double rounding = 4e-16 * std::abs(nominal) * sigma * pressed.loading_stiffness.value / p;
                CHECK(test::relative_error(series.at_separation(pressed.separation.value).pressure.value, p) <
                      1e-13 + rounding);
            }

            // as printed: K at eta_new against the pressure at eta_old
            const auto printed = with(InteractionReading::as_printed).point_at_pressure(p);
            CHECK(printed.ok() == (nominal >= -1000));
            if (printed.ok())
                CHECK(test::relative_error(printed.state.stiffness.value,
                                           alone.at_separation(nominal * sigma).stiffness.value) < 1e-12);
        });
    }
}

}  // namespace random_contacts_test
