// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/files.hpp"
#include "support/paper.hpp"
#include "support/user_laws.hpp"

#include <bit>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

namespace contact_law_test {

using namespace fstiff;

namespace {

const Roughness<double> fine = test::sand_blasted_fine.roughness();
const PeakDistribution<double> third = PeakDistribution<double>::exponential(std::numbers::pi / 3);
constexpr double modulus = 112.6e9;

RoughContact<double, HertzLaw<double>> hertz(const RoughContactOptions<double>& options = {}) {
    return {fine, third, HertzLaw<double>{}, modulus, options};
}

using Law = ContactLaw<double>;

/// Abbott and Firestone: mean pressure H, elastic on unloading: K is not a constant times -dp/dd.
struct YieldingLaw {
    double hardness_over_modulus;
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    double load_factor() const { return 2 * std::numbers::pi * hardness_over_modulus; }
    double stiffness_factor() const { return 2 * std::numbers::sqrt2; }
    double area_factor() const { return 2 * std::numbers::pi; }
};

RoughContact<double, YieldingLaw> plastic(const RoughContactOptions<double>& options = {}) {
    return {fine, third, YieldingLaw{0.01}, modulus, options};
}

/// Largest relative error of the law between the nodes, against the model, at seeded random pressures; of -dp/dd too
/// where K is not a constant times that.
template <class Contact>
double worst_error(const Law& law, const Contact& contact, int count = 400) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto [low, high] = law.pressures();
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        const double p = low * std::pow(high / low, uniform(random));
        const auto truth = contact.at_pressure(p, Quantity::stiffness | Quantity::loading_stiffness);
        const double separation = std::clamp(truth.separation.value, law.separations()[0], law.separations()[1]);
        const auto at = law.at_separation(separation);
        if constexpr (!Contact::stiffness_follows_slope)
            worst = std::max(worst, std::abs(law.slope_at_separation(separation) / truth.loading_stiffness.value - 1));
        worst = std::max({worst, std::abs(law.stiffness(p) / truth.stiffness.value - 1), std::abs(at.pressure / p - 1),
                          std::abs(at.stiffness / truth.stiffness.value - 1),
                          std::abs(law.separation(p) - truth.separation.value) / contact.rms_height()});
    }
    return worst;
}

}  // namespace

TEST_CASE("a tabulated law is right to 1e-10 and states its error") {
    const auto check = [](const auto& contact, double low, double high, double bound) {
        const Law law = Law::tabulate(contact, {low, high});
        const double worst = worst_error(law, contact);
        INFO("worst " << worst << " claimed " << law.relative_error());
        CHECK(worst <= law.relative_error());
        CHECK(law.relative_error() <= bound);
        CHECK(law.pressures() == std::array<double, 2>{low, high});
    };
    check(hertz(), 1e5, 1e8, 1e-10);
    check(RoughContact(fine, third, FractalLaw<double>(1.62), modulus), 1e5, 1e8, 1e-10);
    check(RoughContact(fine, PeakDistribution<double>(0, std::numbers::pi / 4), FractalConsistentLaw<double>(1.7),
                       modulus),
          1e5, 1e8, 1e-10);
    check(GreenwoodWilliamson<double>(fine, modulus), 1e5, 1e8, 1e-10);
    check(GreenwoodWilliamson<double>(fine, modulus, Heights::exponential), 1e5, 1e8, 1e-9);
    check(hertz({.interaction = {InteractionReading::effective_separation, std::sqrt(195e-6)}}), 1e5, 1e8, 1e-10);
    check(hertz(), 1e6, 1.01e6, 1e-9);  // a short range
    check(hertz(), 1e-20, 1e12, 1e-8);  // 32 decades
    check(RoughContact(fine, PeakDistribution<double>(0.9999, 1.5), HertzLaw<double>{}, modulus), 1e4, 1e8, 1e-9);
    check(plastic(), 1e5, 1e8, 1e-10);
    check(plastic({.interaction = {InteractionReading::effective_separation, 1e-4}}), 1e5, 1e8, 1e-10);
    check(RoughContact(fine, SingleRadius<double>{Heights::exponential}, YieldingLaw{0.01}, modulus), 1e5, 1e8, 1e-9);
    check(plastic(), 1e6, 1.01e6, 1e-9);
}

TEST_CASE(
    "elastic-plastic peaks without powers: p, K and the tangent of a tabulated law are right, and it says how right") {
    std::mt19937 random(7);
    const auto uniform = [&](double a, double b) { return a + (b - a) * double(random()) * 0x1p-32; };
    const auto decades = [&](double a, double b) { return std::pow(10, uniform(a, b)); };
    const auto check = [](const auto& contact, double low, double high) {
        const Law law = Law::tabulate(contact, {low, high});
        const double worst = worst_error(law, contact, 25);
        CAPTURE(worst, law.relative_error(), low, high);
        CHECK(worst <= law.relative_error());
        CHECK(law.relative_error() < 1e-7);
        CHECK_FALSE(law.stiffness_is_slope());
    };
    for (int i = 0; i < 12; ++i) {
        const Roughness<double> surface{decades(-6.5, -5.5), decades(-5.5, -4), decades(8, 10)};
        const double low = decades(4, 6), high = low * decades(0.05, 3);
        RoughContactOptions<double> options;
        if (i % 3 == 0) options.interaction = {InteractionReading::effective_separation, decades(-5, -3)};
        if (i % 4 == 0)
            check(RoughContact(surface, SingleRadius<double>{}, test::YieldByUser{}, modulus, options), low, high);
        else
            check(RoughContact(surface, PeakDistribution<double>(uniform(0, 0.8), uniform(0.3, 1.3)),
                               test::YieldByUser{}, modulus, options),
                  low, high);
    }
}

namespace {

/// \p claimed and \p found, the largest error at \p points pressures of each, of 400 laws of random surfaces: every
/// law, a plastic one and Greenwood-Williamson too, one contact in three with interaction, over up to six decades of
/// pressure.
struct RandomLaws {
    std::vector<double> claimed, found;
};
RandomLaws random_laws(int points) {
    std::mt19937 random(5);
    // no std distribution: the same laws with every standard library
    const auto uniform = [&](double a, double b) { return a + (b - a) * double(random()) * 0x1p-32; };
    const auto decades = [&](double a, double b) { return std::pow(10, uniform(a, b)); };
    RandomLaws out;
    const auto check = [&](const auto& contact, double low, double high) {
        // points out of reach of the model or the table are refused, and others drawn
        if (!test::refusal([&] { static_cast<void>(contact.at_pressure(high, Quantity::pressure)); }).empty()) return;
        if (contact.at_pressure(high, Quantity::pressure).eta < -20) return;  // the planes are 20 rms heights through
        const Law law = Law::tabulate(contact, {low, high});
        const double worst = worst_error(law, contact, points);
        CAPTURE(worst, law.relative_error(), low, high, contact.rms_height(), contact.bulk_compliance());
        CHECK(worst <= law.relative_error());
        CHECK(law.at_separation(law.separation(low)).pressure <=
              law.at_separation(law.separation(high)).pressure);  // its own ends are taken
        out.claimed.push_back(law.relative_error());
        out.found.push_back(worst);
    };
    for (int i = 0; out.found.size() < 400; ++i) {
        const Roughness<double> surface{decades(-7.5, -5), decades(-6.5, -4), decades(7.5, 11)};
        const PeakDistribution<double> peaks(uniform(0, 0.98), uniform(0.05, 1.55));
        const double stiff = decades(9.5, 11.5), low = decades(3, 7), high = low * decades(0.05, 6);
        const double dimension = uniform(1.02, 1.95);
        RoughContactOptions<double> options;
        if (i % 3 == 0) options.interaction = {InteractionReading::effective_separation, decades(-4, -1)};
        switch (i % 7) {
            case 0: check(GreenwoodWilliamson<double>(surface, stiff), low, high); break;
            case 1:
            case 2: check(RoughContact(surface, peaks, HertzLaw<double>{}, stiff, options), low, high); break;
            case 3:
            case 4:
                check(RoughContact(surface, peaks, FractalConsistentLaw<double>(dimension), stiff, options), low, high);
                break;
            case 5:
                check(RoughContact(surface, peaks, FractalLaw<double>(dimension), stiff, options), low, high);
                break;
            default: check(RoughContact(surface, peaks, YieldingLaw{stiff / 1e12}, stiff, options), low, high);
        }
    }
    std::sort(out.claimed.begin(), out.claimed.end());
    std::sort(out.found.begin(), out.found.end());
    return out;
}

void check_accuracy(const RandomLaws& laws) {
    const auto quantile = [](const std::vector<double>& sorted, double part) {
        return sorted[static_cast<std::size_t>(part * double(sorted.size() - 1))];
    };
    CHECK(quantile(laws.claimed, 0.5) < 4e-12);
    CHECK(quantile(laws.claimed, 0.9) < 3e-10);
    CHECK(laws.claimed.back() < 1e-7);
    CHECK(quantile(laws.found, 0.5) < 1e-12);
    CHECK(quantile(laws.found, 0.9) < 5e-11);
    CHECK(laws.found.back() < 1e-8);
}

}  // namespace

TEST_CASE("no law of 400 random surfaces is further from the model than its stated error", "[more]") {
    check_accuracy(random_laws(401));
}

TEST_CASE("the tangent is exactly the slope of the returned pressure where the law states it") {
    const Law consistent =
        Law::tabulate(RoughContact(fine, third, FractalConsistentLaw<double>(1.62), modulus), {1e5, 1e8});
    const Law printed = Law::tabulate(RoughContact(fine, third, FractalLaw<double>(1.62), modulus), {1e5, 1e8});
    CHECK(Law::tabulate(hertz(), {1e5, 1e8}).stiffness_is_slope());
    CHECK(consistent.stiffness_is_slope());
    CHECK_FALSE(printed.stiffness_is_slope());
    const double f = detail::fractal_stiffness_factor(1.62);
    for (const Law* law : {&consistent, &printed}) {
        const auto [low, high] = law->separations();
        for (int i = 1; i < 200; ++i) {
            const double separation = low + (high - low) * (i + 0.123) / 201;
            // within one piece p is a polynomial: a five-point difference of it has only rounding for an error
            const double h = 1e-4 * fine.rms_height;
            const auto p = [&](double x) { return law->pressure_at_separation(x); };
            const double slope =
                -(8 * (p(separation + h) - p(separation - h)) - (p(separation + 2 * h) - p(separation - 2 * h))) /
                (12 * h);
            CHECK(test::relative_error(law->stiffness_at_separation(separation) / (law == &printed ? f : 1), slope) <
                  3e-10);
        }
    }
}

TEST_CASE("dK/dp is the derivative of K(p)") {
    const Law law = Law::tabulate(hertz(), {1e5, 1e8});
    for (double p = 1.3e5; p < 9e7; p *= 1.37) {
        const double h = 1e-4 * p;
        const double slope = (8 * (law.stiffness(p + h) - law.stiffness(p - h)) -
                              (law.stiffness(p + 2 * h) - law.stiffness(p - 2 * h))) /
                             (12 * h);
        CHECK(test::relative_error(law.stiffness_slope(p), slope) < 1e-8);
    }
}

TEST_CASE("K rises with p, p and K fall with the separation, over every seam") {
    const Law law = Law::tabulate(hertz(), {1e3, 1e9});
    const int count = 20000;
    double k = 0, separation = 1;
    for (int i = 0; i <= count; ++i) {
        const double p = std::clamp(1e3 * std::pow(1e6, double(i) / count), 1e3, 1e9);
        REQUIRE(law.stiffness(p) > k);
        REQUIRE(law.separation(p) < separation);
        k = law.stiffness(p);
        separation = law.separation(p);
    }
    const auto [low, high] = law.separations();
    auto last = law.at_separation(low);
    for (int i = 1; i <= count; ++i) {
        const auto at = law.at_separation(std::min(low + (high - low) * i / count, high));
        REQUIRE(at.pressure < last.pressure);
        REQUIRE(at.stiffness < last.stiffness);
        last = at;
    }
}

TEST_CASE("outside the range: refuse, clamp or evaluate, as asked for") {
    const auto contact = hertz();
    const Law refuse = Law::tabulate(contact, {1e5, 1e8});
    const double near = refuse.separations()[0], far = refuse.separations()[1];
    // the value and the bounds with the digits that distinguish them
    CHECK(test::refusal([&] { static_cast<void>(refuse.at_separation(std::nextafter(far, 1.0))); }) ==
          "separation = " + detail::shortest_text(std::nextafter(far, 1.0)) + ": must be between " +
              detail::shortest_text(near) + " and " + detail::shortest_text(far) + " m, the range of the law");
    const Law clamp = Law::tabulate(contact, {1e5, 1e8, OutsideRange::clamp});
    const Law exact = Law::tabulate(contact, {1e5, 1e8, OutsideRange::exact});
    const auto said = [&](double p) { return test::refusal([&] { static_cast<void>(refuse.stiffness(p)); }); };
    CHECK(said(9e4) == "pressure = 90000: must be between 1e+05 and 1e+08 Pa, the range of the law");
    CHECK(said(1.1e8).starts_with("pressure = 1.1e+08: must be"));
    CHECK(said(std::nan("")) == "pressure = nan: must be a number");
    CHECK(said(-std::nan("")) == "pressure = nan: must be a number");
    CHECK(said(-1).starts_with("pressure = -1: must be"));
    CHECK(test::refusal([&] {
              static_cast<void>(refuse.at_separation(1.0));
          }).starts_with("separation = 1: must be between "));
    CHECK(test::refusal([&] { static_cast<void>(clamp.at_separation(std::nan(""))); }) ==
          "separation = nan: must be a number");
    CHECK(test::refusal([&] { static_cast<void>(clamp.stiffness(std::nan(""))); }).starts_with("pressure = nan"));
    CHECK(clamp.stiffness(1) == clamp.stiffness(1e5));
    CHECK(clamp.stiffness(1e30) == clamp.stiffness(1e8));
    CHECK(clamp.at_separation(1.0).pressure == clamp.at_separation(clamp.separations()[1]).pressure);
    CHECK(clamp.stiffness_slope(1) == 0);
    CHECK(clamp.slope_at_separation(1.0) == 0);  // p is constant there
    CHECK(clamp.at_separation(1.0).stiffness == clamp.at_separation(far).stiffness);
    CHECK(clamp.at_pressure(1e30).separation == clamp.separation(1e8));
    CHECK(clamp.at_pressure(1e30).stiffness_slope == 0);
    CHECK(clamp.stiffness(-1) == clamp.stiffness(1e5));
    CHECK(exact.stiffness(1e3) == contact.at_pressure(1e3).stiffness.value);
    CHECK(exact.separation(1e10) == contact.at_pressure(1e10).separation.value);
    CHECK(exact.at_separation(5e-6).pressure == contact.at_separation(5e-6).pressure.value);
    CHECK(exact.slope_at_separation(5e-6) == contact.at_separation(5e-6).stiffness.value);
    CHECK(exact.at_pressure(1e3).stiffness == exact.stiffness(1e3));
    CHECK(exact.at_pressure(1e3).stiffness_slope == exact.stiffness_slope(1e3));
    const Law exact_plastic = Law::tabulate(plastic(), {1e5, 1e8, OutsideRange::exact});
    CHECK(exact_plastic.at_separation(5e-6).stiffness == plastic().at_separation(5e-6).stiffness.value);
    CHECK(exact_plastic.slope_at_separation(5e-6) == plastic().at_separation(5e-6).loading_stiffness.value);
    const Law clamped_plastic = exact_plastic.with(OutsideRange::clamp);
    CHECK(clamped_plastic.at_separation(1.0).stiffness ==
          clamped_plastic.stiffness_at_separation(clamped_plastic.separations()[1]));
    CHECK(clamped_plastic.slope_at_separation(1.0) == 0);
    CHECK(refuse.stiffness(1e5) > 0);  // the ends belong to the range
    CHECK(refuse.stiffness(1e8) > 0);
    CHECK(refuse.at_separation(refuse.separations()[0]).pressure > 0);
    CHECK(refuse.at_separation(refuse.separations()[1]).pressure > 0);
}

namespace {

/// Laws of every kind over \p range: with and without interaction, and K over -dp/dd, 0 where it is not a constant.
template <class Check>
void for_laws(const LawRange<double>& range, const Check& check) {
    const RoughContactOptions<double> patch{.interaction = {InteractionReading::effective_separation, 0.1}};
    check(Law::tabulate(hertz(), range), 1.0);
    check(Law::tabulate(hertz(patch), range), 1.0);
    check(Law::tabulate(RoughContact(fine, third, FractalLaw<double>(1.62), modulus), range),
          detail::fractal_stiffness_factor(1.62));
    check(Law::tabulate(GreenwoodWilliamson<double>(fine, modulus, Heights::exponential), range), 1.0);
    check(Law::tabulate(plastic(), range), 0.0);
    check(Law::tabulate(plastic({.interaction = {InteractionReading::effective_separation, 1e-3}}), range), 0.0);
}

struct Whole {
    double pressure, stiffness, slope;
};
Whole all_at(const Law& law, double separation) {
    const auto [pressure, stiffness] = law.at_separation(separation);
    return {pressure, stiffness, law.slope_at_separation(separation)};
}

}  // namespace

TEST_CASE(
    "the slope -dp/dd is given for every law, K is a multiple of it, and at_pressure gives three values at once") {
    for_laws({1e5, 1e8}, [](const Law& law, double f) {
        CHECK(law.stiffness_is_slope() == (f == 1));
        const auto [near, far] = law.separations();
        for (int i = 1; i < 100; ++i) {
            const double separation = near + (far - near) * (i + 0.123) / 101, h = 1e-4 * fine.rms_height;
            const auto p = [&](double x) { return law.pressure_at_separation(x); };
            const double slope =
                -(8 * (p(separation + h) - p(separation - h)) - (p(separation + 2 * h) - p(separation - 2 * h))) /
                (12 * h);
            CHECK(test::relative_error(law.slope_at_separation(separation), slope) < 3e-10);
            const auto at = all_at(law, separation);
            CHECK(law.tangent_at_separation(separation).pressure == at.pressure);
            if (law.stiffness_is_slope()) CHECK(at.stiffness == at.slope);
            if (f > 0) CHECK(test::ulps(at.stiffness, f * at.slope) < 8);
            const auto back = law.at_pressure(at.pressure);
            CHECK(back.separation == law.separation(at.pressure));
            CHECK(back.stiffness == law.stiffness(at.pressure));
            CHECK(back.stiffness_slope == law.stiffness_slope(at.pressure));
        }
    });
}

TEST_CASE("a continued law is smooth at its ends: log p linear in the separation above, K linear below") {
    for_laws({1e5, 1e8, OutsideRange::extrapolate}, [](const Law& law, double) {
        const auto [near, far] = law.separations();
        const auto [low, high] = law.pressures();
        const auto light = all_at(law, far), heavy = all_at(law, near);
        const double sigma = fine.rms_height, error = law.relative_error();
        // p, -dp/dd and K are continuous at the end
        for (const double end : {near, far})
            for (const double way : {-1.0, 1.0}) {
                const auto at = all_at(law, end), beyond = all_at(law, std::nextafter(end, way));
                CHECK(test::ulps(beyond.pressure, at.pressure) < 100);
                CHECK(test::ulps(beyond.slope, at.slope) < 4000);  // of a derivative that cancels within the range
                CHECK(test::ulps(beyond.stiffness, at.stiffness) < 4000);
            }
        for (const double x : {0.1, 1.0, 3.0}) {
            const auto at = all_at(law, far + x * sigma);
            CHECK(test::relative_error(at.pressure,
                                       light.pressure * std::exp(-x * sigma * light.slope / light.pressure)) < 1e-14);
            CHECK(test::relative_error(at.stiffness / at.pressure, light.stiffness / light.pressure) < 1e-14);
        }
        // K linear: its differences do not depend on where; p is its integral over the ratio of the two, that of the
        // end
        const double k = law.stiffness_at_separation(near - sigma) - heavy.stiffness;
        CHECK(k > 0);
        CHECK(test::relative_error(law.stiffness_at_separation(near - 3 * sigma) - heavy.stiffness, 3 * k) < 1e-12);
        CHECK(test::relative_error(law.pressure_at_separation(near - sigma) - heavy.pressure,
                                   (heavy.slope + law.slope_at_separation(near - sigma)) / 2 * sigma) < 1e-13);
        for (const double separation : {far + 0.2 * sigma, far + 4 * sigma, near - 0.2 * sigma, near - 4 * sigma}) {
            const double h = 1e-3 * sigma;
            const auto p = [&](double x) { return law.pressure_at_separation(x); };
            const double slope =
                -(8 * (p(separation + h) - p(separation - h)) - (p(separation + 2 * h) - p(separation - 2 * h))) /
                (12 * h);
            CHECK(test::relative_error(law.slope_at_separation(separation), slope) < 1e-10);
            // by pressure the same law, to the difference of the tables at its ends
            const auto at = all_at(law, separation);
            const auto back = law.at_pressure(at.pressure);
            CHECK(std::abs(back.separation - separation) < 10 * error * sigma + 1e-14 * std::abs(separation));
            CHECK(test::relative_error(back.stiffness, at.stiffness) < 10 * error);
            CHECK(law.stiffness(at.pressure) == back.stiffness);
            CHECK(law.separation(at.pressure) == back.separation);
            const double dp = 1e-4 * at.pressure;
            const double rate = (law.stiffness(at.pressure + dp) - law.stiffness(at.pressure - dp)) / (2 * dp);
            CHECK(test::relative_error(law.stiffness_slope(at.pressure), rate) < 1e-7);
        }
        CHECK(test::ulps(law.stiffness(std::nextafter(high, 1e300)), law.stiffness(high)) < 100);
        CHECK(test::ulps(law.stiffness(std::nextafter(low, 0.0)), law.stiffness(low)) < 100);
        CHECK(test::ulps(law.stiffness_slope(std::nextafter(high, 1e300)), law.stiffness_slope(high)) < 4000);
        // an open contact, and one that is closed beyond reason
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double open : {1.0, infinity}) {
            CHECK(all_at(law, open).pressure == 0);
            CHECK(all_at(law, open).stiffness == 0);
            CHECK(all_at(law, open).slope == 0);
        }
        CHECK(law.stiffness(0) == 0);
        CHECK(law.separation(0) == infinity);
        CHECK(all_at(law, -1.0).pressure > 1e10);
        const auto said = [](const auto& call) { return test::refusal([&] { static_cast<void>(call()); }); };
        CHECK(said([&] { return law.stiffness(-1); }) ==
              "pressure = -1: must be finite and at least 0 Pa: the contact does not pull");
        CHECK(said([&] { return law.stiffness(infinity); }).starts_with("pressure = inf: must be finite"));
        CHECK(said([&] { return law.separation(std::nan("")); }).starts_with("pressure = nan: must be"));
        CHECK(said([&] { return all_at(law, -infinity).pressure; }).starts_with("separation = -inf: must be greater"));
        CHECK(said([&] { return all_at(law, std::nan("")).pressure; }).starts_with("separation = nan: must be"));
        CHECK(Law::from_text(law.to_text()) == law);
        CHECK(Law::from_text(law.to_text()).at_separation(far + sigma).pressure == all_at(law, far + sigma).pressure);
    });
}

TEST_CASE("a mass on a continued law opens and closes by Newton's method, which converges quadratically") {
    // m a = p(separation) A - weight by implicit Euler: thrown up, it leaves the contact, falls back and presses it
    // beyond its range
    for_laws({1e5, 2e6, OutsideRange::extrapolate}, [](const Law& law, double) {
        const auto [near, far] = law.separations();
        const double area = 1e-4, weight = 3e5 * area, mass = 0.1;
        // ten steps a radian of its oscillation at rest, and twenty times the speed of one in which it just opens
        const double time = std::sqrt(mass / (law.slope_at_separation(law.separation(3e5)) * area)), step = 0.1 * time;
        double separation = law.separation(3e5), speed = 20 * weight / mass * time;
        int open = 0, beyond = 0, hardest = 0;
        for (int i = 0; i < 6000; ++i) {
            const double from = separation, speed_before = speed;
            double last = 1;
            int iterations = 0;
            for (; iterations < 40; ++iterations) {
                const auto at = all_at(law, separation);
                const double inertia = mass * ((separation - from) / step - speed_before) / step;
                const double residual = std::abs(inertia - at.pressure * area + weight) / weight;
                if (last < 0.01) CHECK(residual < 10 * last * last + 1e-10);
                last = residual;
                if (residual < 1e-10) break;
                separation -= (inertia - at.pressure * area + weight) / (mass / step / step + at.slope * area);
            }
            REQUIRE(iterations < 40);
            speed = (separation - from) / step;
            hardest = std::max(hardest, iterations);
            open += separation > far ? 1 : 0;
            beyond += separation < near ? 1 : 0;
        }
        CAPTURE(law.stiffness_is_slope(), open, beyond, hardest);
        CHECK(open > 100);
        CHECK(beyond > 2);
        CHECK(hardest <= 12);
        CHECK(test::relative_error(law.pressure_at_separation(separation), 3e5) <
              1e-3);  // it came to rest under its weight
    });
}

TEST_CASE("an empty law refuses every evaluation with one sentence, and may be filled later") {
    const std::string empty = "contact law: is empty; must be tabulated or read from text to be evaluated";
    std::vector<Law> laws;
    laws.resize(3);
    const Law& law = laws[1];
    CHECK(law.empty());
    CHECK(law == Law{});
    CHECK(law.pressures() == std::array<double, 2>{0, 0});
    Eigen::ArrayXd x = Eigen::ArrayXd::Constant(5, 1e6), y = x, z = x;
    // the bits of every NaN, of 0 and of the greatest number: no table contains any of them
    const auto all_ones = std::bit_cast<double>(~std::uint64_t{0});
    for (const double value : {0.0, -0.0, 1e6, std::nan(""), all_ones, std::numeric_limits<double>::max()}) {
        CHECK(test::refusal([&] { static_cast<void>(law.stiffness(value)); }) == empty);
        CHECK(test::refusal([&] { static_cast<void>(law.separation(value)); }) == empty);
        CHECK(test::refusal([&] { static_cast<void>(law.stiffness_slope(value)); }) == empty);
        CHECK(test::refusal([&] { static_cast<void>(law.at_pressure(value)); }) == empty);
        CHECK(test::refusal([&] { static_cast<void>(law.at_separation(value)); }) == empty);
        CHECK(test::refusal([&] { static_cast<void>(law.slope_at_separation(value)); }) == empty);
        x.setConstant(value);
        CHECK(test::refusal([&] { law.stiffness(x, y); }) == empty);
        CHECK(test::refusal([&] { law.at_separation(x, y, z); }) == empty);
        CHECK(test::refusal([&] { law.tangent_at_separation(x, y, z); }) == empty);
    }
    CHECK(test::refusal([&] { static_cast<void>(law.to_text()); }) == empty);
    laws[1] = Law::tabulate(hertz(), {1e5, 1e8});
    CHECK_FALSE(law.empty());
    CHECK(law != Law{});
    laws.resize(100);
    CHECK(laws[1].stiffness(1e6) > 0);
    ContactLaw<float> of_floats;
    CHECK(test::refusal([&] { static_cast<void>(of_floats.stiffness(1.0F)); }) == empty);
}

namespace {

/// K of the pressures and {p, K} of the separations by batch against the calls one by one; from arrays that begin \p
/// offset numbers after an aligned one.
template <class T>
void check_batch(const ContactLaw<T>& law, const Eigen::ArrayX<T>& pressure, const Eigen::ArrayX<T>& separation,
                 Eigen::Index offset) {
    using Array = Eigen::ArrayX<T>;
    const Eigen::Index count = pressure.size();
    Array p = Array::Constant(count + offset + 4, -1), k = p, g = p, p_of_separation = p, k_of_separation = p;
    p.segment(offset, count) = pressure;
    g.segment(offset, count) = separation;
    law.stiffness(p.segment(offset, count), k.segment(offset, count));
    law.at_separation(g.segment(offset, count), p_of_separation.segment(offset, count),
                      k_of_separation.segment(offset, count));
    Array p_again(count), slope(count);
    law.tangent_at_separation(g.segment(offset, count), p_again, slope);
    REQUIRE((p_again == p_of_separation.segment(offset, count)).all());
    for (Eigen::Index i = 0; i < k.size(); ++i) {
        if (i < offset || i >= offset + count) {  // nothing is written outside the results
            REQUIRE(k[i] == -1);
            REQUIRE(p_of_separation[i] == -1);
            REQUIRE(k_of_separation[i] == -1);
            continue;
        }
        // both evaluate the same polynomial: only the order of the operations differs
        const T bound = std::min(law.relative_error(), 200 * std::numeric_limits<T>::epsilon());
        const auto at = law.at_separation(g[i]);
        REQUIRE(test::relative_error(k[i], law.stiffness(p[i])) <= bound);
        REQUIRE(test::relative_error(p_of_separation[i], at.pressure) <= bound);
        REQUIRE(test::relative_error(k_of_separation[i], at.stiffness) <= bound);
        REQUIRE(test::relative_error(slope[i - offset], law.slope_at_separation(g[i])) <= bound);
    }
    Array in_place = pressure;
    law.stiffness(in_place, in_place);
    REQUIRE((in_place == k.segment(offset, count)).all());
}

/// \p count values in no order, at the ends of [low, high] and \p beyond them too.
template <class T>
Eigen::ArrayX<T> scattered(Eigen::Index count, T low, T high, T beyond) {
    Eigen::ArrayX<T> x(count);
    T fraction = T(0.3);
    for (Eigen::Index i = 0; i < count; ++i) {
        fraction = std::fmod(fraction + T(0.618034), T(1));
        x[i] = i % 7 == 2 ? low : i % 7 == 5 ? high : low + (high - low) * fraction * fraction * fraction;
        if (beyond > 0 && i % 5 == 3) x[i] = i % 2 == 0 ? low - beyond : high + beyond;
    }
    return x;
}

}  // namespace

TEST_CASE("a batch is the scalar calls within rounding: any length, any alignment, at the ends and outside") {
    const auto contact = hertz();
    const RoughContact<float, HertzLaw<float>> contact_of_floats(
        test::sand_blasted_fine.roughness<float>(), PeakDistribution<float>(0.5F, 1.0F), HertzLaw<float>{}, 112.6e9F);
    const auto check = [](const auto& law, auto beyond, auto beyond_separation) {
        using T = decltype(beyond);
        const auto [low, high] = law.pressures();
        const auto [near, far] = law.separations();
        for (const Eigen::Index count : {0, 1, 3, 4, 5, 7, 8, 9, 1000})
            for (const Eigen::Index offset : {0, 1, 3})
                check_batch<T>(law, scattered<T>(count, low, high, beyond),
                               scattered<T>(count, near, far, beyond_separation), offset);
    };
    check(Law::tabulate(contact, {1e5, 1e8}), 0.0, 0.0);
    check(Law::tabulate(contact, {1e5, 1e8, OutsideRange::clamp}), 9e4, 1e-6);
    check(Law::tabulate(contact, {1e5, 1e8, OutsideRange::exact}), 5e4, 1e-6);
    check(Law::tabulate(contact, {1e5, 1e8, OutsideRange::extrapolate}), 9e4, 1e-6);
    check(Law::tabulate(RoughContact(fine, third, FractalLaw<double>(1.62), modulus), {1e5, 1e8}), 0.0, 0.0);
    check(Law::tabulate(plastic(), {1e5, 1e8, OutsideRange::extrapolate}), 9e4, 1e-6);
    check(ContactLaw<float>::tabulate(contact_of_floats, {1e5F, 1e8F}), 0.0F, 0.0F);
    check(ContactLaw<float>::tabulate(contact_of_floats, {1e5F, 1e8F, OutsideRange::clamp}), 9e4F, 1e-6F);
}

TEST_CASE("a batch is right to the error that the law states whatever the position of an element") {
    const auto contact = hertz();
    const Law law = Law::tabulate(contact, {1e5, 1e8});
    const Eigen::Index count = 401;
    Eigen::ArrayXd p = scattered(count, 1e5, 1e8, 0.0), separation(count), k(count), p_of_separation(count),
                   k_of_separation(count);
    std::vector<double> truth;
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = contact.at_pressure(p[i], Quantity::stiffness);
        truth.push_back(at.stiffness.value);
        separation[i] = std::clamp(at.separation.value, law.separations()[0], law.separations()[1]);
    }
    law.stiffness(p, k);
    law.at_separation(separation, p_of_separation, k_of_separation);
    for (Eigen::Index i = 0; i < count; ++i) {
        REQUIRE(test::relative_error(k[i], truth[static_cast<std::size_t>(i)]) <= law.relative_error());
        REQUIRE(test::relative_error(k_of_separation[i], truth[static_cast<std::size_t>(i)]) <= law.relative_error());
        REQUIRE(test::relative_error(p_of_separation[i], p[i]) <= law.relative_error());
    }
    for (const Eigen::Index first : {1, 2, 398, 400}) {
        Eigen::ArrayXd again(count - first), again_p(count - first);
        law.stiffness(p.tail(count - first), again);
        CHECK((again == k.tail(count - first)).all());
        law.at_separation(separation.tail(count - first), again_p, again);
        CHECK((again_p == p_of_separation.tail(count - first)).all());
        CHECK((again == k_of_separation.tail(count - first)).all());
    }
}

TEST_CASE("a batch refuses the arguments that scalar calls refuse") {
    const auto contact = hertz();
    for (const OutsideRange outside :
         {OutsideRange::refuse, OutsideRange::clamp, OutsideRange::exact, OutsideRange::extrapolate}) {
        const Law law = Law::tabulate(contact, {1e5, 1e8, outside});
        for (const Eigen::Index bad : {0, 6, 8, 9}) {  // in the first four, in the next, in the last
            Eigen::ArrayXd p = Eigen::ArrayXd::Constant(10, 3e6),
                           separation = Eigen::ArrayXd::Constant(10, law.separation(3e6)), k(10), q(10);
            for (const double value : {std::nan(""), -std::nan("")}) {
                p[bad] = separation[bad] = value;
                CHECK(test::refusal([&] { law.stiffness(p, k); }).find("nan") != std::string::npos);
                if (outside == OutsideRange::exact)
                    CHECK_FALSE(test::refusal([&] { law.at_separation(separation, q, k); }).empty());
                else
                    CHECK(test::refusal([&] { law.at_separation(separation, q, k); }).find("nan") != std::string::npos);
            }
            if (outside != OutsideRange::refuse) continue;
            p[bad] = 1.1e8;
            separation[bad] = 1;
            CHECK(test::refusal([&] { law.stiffness(p, k); }).starts_with("pressure = 1.1e+08: must be between"));
            CHECK(test::refusal([&] {
                      law.at_separation(separation, q, k);
                  }).starts_with("separation = 1: must be between"));
        }
        Eigen::ArrayXd p = Eigen::ArrayXd::Constant(37, 3e6), wrong(3);
        CHECK(test::refusal([&] { law.stiffness(p, wrong); }).starts_with("batch: the arrays have 37 and 3 elements"));
    }
}

TEST_CASE("the separation of every pressure in the range is one that the law takes") {
    // of two tables, which differ in the last digits: an initial state at the end of the range is what a solver begins
    // with
    for (const double low : {1e4, 1e5, 3.3e5, 7.7e6})
        for (const double ratio : {1.001, 2.0, 100.0, 12345.6}) {
            const Law law = Law::tabulate(hertz(), {low, low * ratio});
            for (const double p : {low, low * ratio, low * std::sqrt(ratio)})
                CHECK(test::relative_error(law.at_separation(law.separation(p)).pressure, p) <
                      100 * law.relative_error());
        }
}

namespace {

std::string without_sum(const std::string& text) { return text.substr(0, text.rfind('\n', text.size() - 2) + 1); }

/// \p text whose last line is the sum of those above.
std::string summed(const std::string& text) {
    const std::string above = without_sum(text);
    return above + detail::sum_of_text(above) + '\n';
}

}  // namespace

TEST_CASE("a law goes to text and back bit for bit, and other text is refused") {
    const Law law = Law::tabulate(hertz(), {1e5, 1e8, OutsideRange::clamp});
    const std::string text = law.to_text();
    const Law back = Law::from_text(text);
    CHECK(back == law);
    for (const double p : {1e5, 1.234e6, 7.7e7, 1e8, 1e9}) CHECK(back.stiffness(p) == law.stiffness(p));
    CHECK(back.at_separation(1e-6).stiffness == law.at_separation(1e-6).stiffness);
    CHECK(back.relative_error() == law.relative_error());
    for (const OutsideRange outside : {OutsideRange::refuse, OutsideRange::clamp, OutsideRange::extrapolate}) {
        CHECK(Law::from_text(law.with(outside).to_text()) == law.with(outside));
        CHECK(law.with(outside).outside() == outside);
        CHECK((law == law.with(outside)) == (outside == OutsideRange::clamp));
    }
    // its model is in no text, and a policy that changed on the way would be a surprise
    const Law exact = Law::tabulate(hertz(), {1e5, 1e8, OutsideRange::exact});
    CHECK(test::refusal([&] { static_cast<void>(exact.to_text()); }).starts_with("outside = exact: must be another"));
    CHECK(exact.with(OutsideRange::clamp).to_text() == text);
    CHECK(exact.with(OutsideRange::exact).stiffness(1e3) == exact.stiffness(1e3));
    CHECK(test::refusal([&] { static_cast<void>(law.with(OutsideRange::exact)); }).starts_with("outside = exact"));
    std::string crlf;  // as git or a mail may turn it
    for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
    CHECK(Law::from_text(crlf) == law);
    const auto refused_as_it_is = [](const std::string& t) {
        return test::refusal([&] { static_cast<void>(Law::from_text(t)); });
    };
    const auto refused = [&](const std::string& t) { return refused_as_it_is(summed(t)); };
    CHECK(refused_as_it_is("").starts_with("contact law text: begins with something else"));
    CHECK(refused_as_it_is("nonsense").starts_with("contact law text: begins"));
    std::string later = text;
    later.replace(later.find(" 3 "), 3, " 6 ");
    CHECK(refused(later).starts_with("contact law text: is of another version"));
    CHECK(text.starts_with("fstiff contact law 3 8\n"));
    // K by separation in a table of its own, which another version has; neither is taken for the other
    const Law hard = Law::tabulate(plastic(), {1e5, 1e8, OutsideRange::extrapolate});
    std::string own = hard.to_text();
    CHECK(own.starts_with("fstiff contact law 4 8\n"));
    CHECK(Law::from_text(own) == hard);
    CHECK(Law::from_text(own).stiffness_at_separation(2e-6) == hard.stiffness_at_separation(2e-6));
    CHECK(hard != law);
    own.replace(own.find(" 4 "), 3, " 3 ");
    CHECK(refused(own).find("contradicts itself") != std::string::npos);
    later.replace(later.find(" 6 "), 3, " 4 ");
    CHECK(refused(later).find("contradicts itself") != std::string::npos);
    CHECK(refused(without_sum(text) + "1\n" + "sum")
              .ends_with("goes on after its end: must be what to_text wrote for this scalar type"));
    CHECK_FALSE(refused(text.substr(0, text.size() / 2)).empty());
    std::string huge = text;
    const std::size_t pieces = huge.find('\n') + 1;
    huge.replace(pieces, huge.find(' ', pieces) - pieces, "999999999999");
    CHECK(test::contains(refused(huge), "impossible sizes"));
    std::string not_finite = text;
    not_finite.replace(text.rfind(' ') + 1, std::string::npos, "nan\nsum");
    CHECK(test::contains(refused(not_finite), "no number"));
    CHECK_FALSE(test::refusal([&] { static_cast<void>(ContactLaw<float>::from_text(text)); }).empty());
    // the third line begins with the range of pressures: one power of 2 more has more pieces than the text
    std::string longer = text;
    const std::size_t line = longer.find('\n', longer.find('\n') + 1) + 1, second = longer.find(' ', line) + 1;
    longer.replace(second, longer.find(' ', second) - second, "1.8p+27");
    CHECK(test::contains(refused(longer), "ends early"));
    longer.replace(second, longer.find(' ', second) - second, "1.8p+2");
    CHECK(refused(longer).find("contradicts itself") != std::string::npos);
}

TEST_CASE("A law text of which any character was changed, left out or put in is refused") {
    CHECK(detail::sum_of_text("") == "cbf29ce484222325");  // the published vectors of FNV-1a with 64 bits
    CHECK(detail::sum_of_text("foobar") == "85944171f73967e8");
    const std::string refusal =
        "contact law text: was changed or cut short, as its check sum shows: must be what to_text wrote for this "
        "scalar "
        "type";
    for (const Law& law : {Law::tabulate(hertz(), {1e6, 3e6}), Law::tabulate(plastic(), {1e6, 3e6})}) {
        const std::string text = law.to_text();
        const std::size_t head = text.find('\n');
        std::size_t accepted = 0;
        const auto refused_or_the_same = [&](const std::string& changed, std::size_t place) {
            try {
                ++accepted;
                if (Law::from_text(changed) != law) FAIL("changed at " << place);
            } catch (const domain_error& error) {
                --accepted;
                if (place > head && error.what() != refusal) FAIL(error.what());
            }
        };
        for (std::size_t i = 0; i < text.size(); ++i) {
            for (const char other : {'0', '1', '7', 'f', 'p', '-', '+', '.', ' ', '\n', char(text[i] ^ 1), char(0)})
                if (other != text[i]) refused_or_the_same(text.substr(0, i) + other + text.substr(i + 1), i);
            refused_or_the_same(text.substr(0, i) + text.substr(i + 1), i);
            refused_or_the_same(text.substr(0, i) + "0" + text.substr(i), i);
            if (i % 16 == 0) refused_or_the_same(text.substr(0, i), i);
        }
        CHECK(accepted <= 2);  // the last line without its end, or with a blank there
        CHECK(test::refusal([&] { static_cast<void>(Law::from_text(without_sum(text))); }) ==
              refusal);  // no sum at all
    }
}

TEST_CASE("threads may share a law", "[threads]") {
    const Law law = Law::tabulate(hertz(), {1e5, 1e8});
    std::array<double, 4> sums{};
    std::vector<std::thread> threads;
    for (double& sum : sums)
        threads.emplace_back([&law, &sum] {
            for (double p = 1e5; p < 1e8; p *= 1.001)
                sum += law.stiffness(p) + law.at_separation(law.separation(p * 1.0001 < 1e8 ? p * 1.0001 : p)).pressure;
        });
    for (std::thread& thread : threads) thread.join();
    for (const double sum : sums) CHECK(sum == sums[0]);
}

TEST_CASE("float laws, and ranges that cannot be compiled") {
    const RoughContact<float, HertzLaw<float>> contact(
        test::sand_blasted_fine.roughness<float>(), PeakDistribution<float>(0.5F, 1.0F), HertzLaw<float>{}, 112.6e9F);
    const auto law = ContactLaw<float>::tabulate(contact, {1e5F, 1e8F});
    for (const float p : {1e5F, 3e6F, 9e7F})
        CHECK(test::relative_error(law.stiffness(p), contact.at_pressure(p).stiffness.value) <= law.relative_error());
    CHECK(law.relative_error() < 1e-3F);
    const RoughContact exact(test::sand_blasted_fine.roughness<double>(), PeakDistribution<double>(0.5, 1.0),
                             HertzLaw<double>{}, 112.6e9);
    const Law in_double = Law::tabulate(exact, {0.9e5, 1.1e8});
    double of_stiffness = 0, of_slope = 0;
    for (int i = 0; i < 2000; ++i) {
        const float p = 1e5F * std::pow(1e3F, static_cast<float>(i) / 2000), d = law.separation(p);
        const double slope = law.tangent_at_separation(d).slope, stiffness = law.stiffness(p);
        of_stiffness = std::max(of_stiffness, test::relative_error(stiffness, in_double.stiffness(p)));
        of_slope = std::max(of_slope, test::relative_error(slope, in_double.tangent_at_separation(d).slope));
    }
    CHECK(of_stiffness < 1e-5);
    CHECK(of_slope <= law.relative_error());
    CHECK(law.relative_error() < 4 * of_slope);
    const auto refused = [](double low, double high, const RoughContactOptions<double>& options = {}) {
        return test::refusal([&] { static_cast<void>(Law::tabulate(hertz(options), {low, high})); });
    };
    CHECK(refused(0, 1).starts_with("min_pressure = 0: must be"));
    CHECK(refused(2, 1).starts_with("max_pressure = 1: must be"));
    CHECK(refused(1, 1e40).starts_with("pressure = 1e+40: must be"));
    CHECK(refused(1, std::nan("")).starts_with("max_pressure = nan"));
    CHECK(refused(1, 2, {.interaction = {InteractionReading::as_printed, 1e-3}}).starts_with("interaction = "));
    // a stiffness of 0 and a negative one have no logarithm
    const auto of_law = [](double stiffness) {
        struct Slack : YieldingLaw {
            double factor;
            double stiffness_factor() const { return factor; }
        };
        const RoughContact slack(fine, third, Slack{{0.01}, stiffness}, modulus);
        return test::refusal([&] { static_cast<void>(Law::tabulate(slack, {1e5, 1e8})); });
    };
    CHECK(of_law(1).empty());
    CHECK(of_law(0).starts_with("stiffness = 0: must be"));
    CHECK(of_law(-1).starts_with("stiffness = "));
}

}  // namespace contact_law_test
