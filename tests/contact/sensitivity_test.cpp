// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/sensitivity.hpp>
#include <fstiff/peaks/single_radius.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/user_laws.hpp"

#include <cmath>
#include <numbers>

namespace sensitivity_test {

using namespace fstiff;

namespace {

struct Parameters {
    double rms_height = test::sand_blasted_fine.rms_height, peak_radius = test::sand_blasted_fine.peak_radius,
           peak_density = test::sand_blasted_fine.peak_density, dimension = test::sand_blasted_fine.fractal_dimension,
           modulus = 112.6e9, r = 0.6, theta = 1.1, pressure = 3e6;
};

/// Mean pressure 0.01 E, elastic on unloading.
struct YieldingLaw {
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    static double load_factor() { return 0.06; }
    static double stiffness_factor() { return 2.8; }
    static double area_factor() { return 6.28; }
    static double log_load_slope() { return 0; }
    static double log_stiffness_slope() { return 0; }
};
/// No physics: load ~ omega^(3/2) R^(Radius/2), and a stiffness that no approach changes.
template <int Radius>
struct SquareLaw : YieldingLaw {
    static constexpr HalfPowers load_powers{3, Radius}, stiffness_powers{0, Radius};
};

template <class Law>
Law law_of(double dimension) {
    if constexpr (!std::is_constructible_v<Law, double>)
        return {};
    else
        return Law(dimension);
}

using Options = RoughContactOptions<double>;

template <class Law>
RoughContact<double, Law> contact_of(const Parameters& p, const Options& options) {
    return {Roughness<double>{p.rms_height, p.peak_radius, p.peak_density, 0}, PeakDistribution<double>(p.r, p.theta),
            law_of<Law>(p.dimension), p.modulus, options};
}

template <class Law>
double stiffness(const Parameters& p, const Options& options) {
    return contact_of<Law>(p, options).at_pressure(p.pressure, Quantity::stiffness).stiffness.value;
}

constexpr double half_pi = std::numbers::pi / 2;

/// d K/d parameter by a difference of six points: 1e-12 relative or so. The step is a power of two, so that they are
/// where they should be.
template <class Law>
double difference(Parameters p, double Parameters::*which, const Options& options, double step) {
    const double at = p.*which, h = std::exp2(std::floor(std::log2(step)));
    const auto k = [&](int steps) {
        p.*which = at + steps * h;
        return stiffness<Law>(p, options);
    };
    return (45 * (k(1) - k(-1)) - 9 * (k(2) - k(-2)) + (k(3) - k(-3))) / (60 * h);
}

template <class Law>
void check(const Parameters& p, const Options& options) {
    const auto s = sensitivity(contact_of<Law>(p, options), p.pressure);
    const double k = stiffness<Law>(p, options);
    CHECK(test::relative_error(s.stiffness, k) < 1e-13);
    const struct {
        const char* name;
        double analytic;
        double Parameters::*which;
    } rows[] = {{"p", s.pressure, &Parameters::pressure},
                {"sigma", s.rms_height, &Parameters::rms_height},
                {"R", s.peak_radius, &Parameters::peak_radius},
                {"D_p", s.peak_density, &Parameters::peak_density},
                {"D", s.fractal_dimension, &Parameters::dimension},
                {"E", s.effective_modulus, &Parameters::modulus},
                {"r", s.r, &Parameters::r},
                {"theta", s.theta, &Parameters::theta}};
    for (const auto& row : rows) {
        // steps within the range of D, r and theta: the distance to 2, 1 and pi/2 scales them
        const double room = std::min({1.0, (1 - p.r) / p.r, (half_pi - p.theta) / p.theta});
        const double scale = row.which == &Parameters::dimension ? 2 - p.dimension : room * p.*row.which;
        const double numeric = difference<Law>(p, row.which, options, 0.01 * scale);
        INFO(row.name << " r " << p.r << " theta " << p.theta << " p " << p.pressure << ": " << row.analytic
                      << " against " << numeric);
        // in units of K per relative change of the parameter
        CHECK(std::abs(row.analytic - numeric) * p.*row.which <= 1e-9 / room * k);
    }
}

}  // namespace

TEST_CASE("derivatives of K at constant pressure agree with differences, for every law and curvature scale") {
    for (const CurvatureScale scale : {CurvatureScale::bush_gibson_thomas, CurvatureScale::consistent}) {
        check<HertzLaw<double>>({}, {.curvature = scale});
        check<FractalLaw<double>>({}, {.curvature = scale});
        check<FractalConsistentLaw<double>>({}, {.curvature = scale});
        check<YieldingLaw>({}, {.curvature = scale});
        check<SquareLaw<0>>({}, {.curvature = scale});
        check<SquareLaw<2>>({}, {.curvature = scale});
    }
}

TEST_CASE("with interaction the derivatives agree with differences, for every law") {
    for (const double length : {1e-5, 1e-3}) {
        const Options options{.interaction = {InteractionReading::effective_separation, length}};
        for (const double pressure : {1e5, 3e7}) {
            Parameters p;
            p.pressure = pressure;
            check<HertzLaw<double>>(p, options);
            check<FractalLaw<double>>(p, options);
            check<FractalConsistentLaw<double>>(p, options);
            check<YieldingLaw>(p, options);
        }
    }
}

TEST_CASE("derivatives agree with differences over pressure, r and theta") {
    for (const double r : {0.05, 0.5, 0.9, 0.99})
        for (const double theta : {0.2, 0.9, 1.4})
            for (const double pressure : {1e3, 1e7, 1e10}) {
                Parameters p;
                p.r = r;
                p.theta = theta;
                p.pressure = pressure;
                check<FractalLaw<double>>(p, {});
                p.pressure = std::min(pressure, 1e8);  // the mean pressure of plastic peaks has an upper end
                check<YieldingLaw>(p, {});
                check<SquareLaw<2>>(p, {});
            }
}

TEST_CASE("derivatives agree with differences near independent, rigid and flat peaks") {
    for (const double r : {0.0, 0.5, 0.999, 0.999999})
        for (const double theta : {0.01, 1.0, 1.57})
            for (const double pressure : {1e4, 1e8}) {
                Parameters p;
                p.r = r, p.theta = theta, p.pressure = pressure;
                const auto s = sensitivity(contact_of<FractalLaw<double>>(p, {}), pressure);
                INFO("r " << r << " theta " << theta << " p " << pressure);
                // relative to K per parameter: sums of terms that partly cancel
                const auto agrees = [&](double slope, double Parameters::*which, double scale, double bound) {
                    const double numeric = difference<FractalLaw<double>>(p, which, {}, 0.005 * scale);
                    CHECK(std::abs(slope - numeric) * scale <= bound * s.stiffness);
                };
                agrees(s.rms_height, &Parameters::rms_height, p.rms_height, 1e-11);
                agrees(s.peak_density, &Parameters::peak_density, p.peak_density, 1e-11);
                if (r > 0) agrees(s.r, &Parameters::r, std::min(r, 1 - r), 1e-10);
                agrees(s.theta, &Parameters::theta, std::min(theta, half_pi - theta), 1e-10);
            }
}

TEST_CASE("scaling laws: K is of degree 0 in (p, E) less one, and does not depend on the unit of length") {
    // K(lambda p, lambda E) = lambda K: p dK/dp + E dK/dE = K; lengths: sigma K_sigma + R K_R - 2 D_p K_Dp = -K
    const auto s = sensitivity(RoughContact(test::sand_blasted_fine.roughness(), PeakDistribution<double>(0.6, 1.1),
                                            FractalConsistentLaw<double>(1.62), 112.6e9),
                               3e6);
    CHECK(test::relative_error(3e6 * s.pressure + 112.6e9 * s.effective_modulus, s.stiffness) < 1e-13);
    const test::PaperSurface& fine = test::sand_blasted_fine;
    CHECK(test::relative_error(-(fine.rms_height * s.rms_height + fine.peak_radius * s.peak_radius -
                                 2 * fine.peak_density * s.peak_density),
                               s.stiffness) < 1e-13);
}

namespace {

/// The plastic law without its powers, and with them.
struct PlasticByUser {
    auto load(const auto& omega, double radius) const { return (0.06 * radius * omega).eval(); }
    auto stiffness(const auto& omega, double radius) const { return (2.8 * std::sqrt(radius) * sqrt(omega)).eval(); }
    auto area(const auto& omega, double radius) const { return (6.28 * radius * omega).eval(); }
};
struct PlasticByPowers {
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    static double load_factor() { return 0.06; }
    static double stiffness_factor() { return 2.8; }
    static double area_factor() { return 6.28; }
};

/// The derivatives of two contacts of one law, in units of K per relative change of the parameter.
template <class A, class B>
void same(const A& found, const B& truth, double pressure, double bound) {
    const auto a = sensitivity(found, pressure), b = sensitivity(truth, pressure);
    const auto& surface = truth.surface();
    const double k = b.stiffness;
    CHECK(test::relative_error(a.stiffness, k) < 1e-10);
    CHECK(std::abs(a.pressure - b.pressure) * pressure < bound * k);
    CHECK(std::abs(a.rms_height - b.rms_height) * surface.rms_height < bound * k);
    CHECK(std::abs(a.peak_radius - b.peak_radius) * surface.peak_radius < bound * k);
    CHECK(std::abs(a.peak_density - b.peak_density) * surface.peak_density < bound * k);
    CHECK(std::abs(a.effective_modulus - b.effective_modulus) * truth.effective_modulus() < bound * k);
    CHECK(std::abs(a.r - b.r) < bound * k);
    CHECK(std::abs(a.theta - b.theta) < bound * k);
}

}  // namespace

TEST_CASE("a law without powers is differentiated to 1e-8 like one with powers") {
    const Roughness<double> fine = test::sand_blasted_fine.roughness();
    const RoughContactOptions<double> patch{.interaction = {InteractionReading::effective_separation, 1e-4}};
    for (const auto& [r, theta] : {std::pair(0.2, 0.4), std::pair(0.6, 1.1), std::pair(0.9, 1.3)})
        for (const double pressure : {1e5, 1e7})
            for (const auto& options : {RoughContactOptions<double>{}, patch}) {
                CAPTURE(r, pressure);
                const PeakDistribution<double> peaks(r, theta);
                same(RoughContact(fine, peaks, test::HertzByUser{}, 112.6e9, options),
                     RoughContact(fine, peaks, HertzLaw<double>{}, 112.6e9, options), pressure, 1e-8);
                same(RoughContact(fine, peaks, PlasticByUser{}, 112.6e9, options),
                     RoughContact(fine, peaks, PlasticByPowers{}, 112.6e9, options), pressure, 1e-8);
            }
    for (const Heights heights : {Heights::gaussian, Heights::exponential}) {
        const SingleRadius<double> peaks{heights};
        same(RoughContact(fine, peaks, test::HertzByUser{}, 112.6e9, patch),
             RoughContact(fine, peaks, HertzLaw<double>{}, 112.6e9, patch), 1e6, 1e-8);
        same(RoughContact(fine, peaks, PlasticByUser{}, 112.6e9), RoughContact(fine, peaks, PlasticByPowers{}, 112.6e9),
             1e6, 1e-8);
    }
    // neither states its dependence on D
    CHECK(std::isnan(sensitivity(RoughContact(fine, PeakDistribution<double>(0.5, 1), PlasticByPowers{}, 112.6e9), 1e6)
                         .fractal_dimension));
}

}  // namespace sensitivity_test
