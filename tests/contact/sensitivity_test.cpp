// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/sensitivity.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/scalars.hpp"
#include "support/user_laws.hpp"

namespace sensitivity_test {

using namespace fstiff;

#ifdef FSTIFF_TEST_LONG_DOUBLE
namespace {

struct Parameters {
    long double rms_height = test::sand_blasted_fine.rms_height, peak_radius = test::sand_blasted_fine.peak_radius,
                peak_density = test::sand_blasted_fine.peak_density,
                dimension = test::sand_blasted_fine.fractal_dimension, modulus = 112.6e9L, r = 0.6L, theta = 1.1L,
                pressure = 3e6L;
};

/// Mean pressure 0.01 E, elastic on unloading.
struct YieldingLaw {
    static constexpr parts::HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    static long double load_factor() { return 0.06L; }
    static long double stiffness_factor() { return 2.8L; }
    static long double area_factor() { return 6.28L; }
    static long double log_load_slope() { return 0; }
    static long double log_stiffness_slope() { return 0; }
};
/// No physics: load ~ omega^(3/2) R^(Radius/2), and a stiffness that no approach changes.
template <int Radius>
struct SquareLaw : YieldingLaw {
    static constexpr parts::HalfPowers load_powers{3, Radius}, stiffness_powers{0, Radius};
};

template <class Law>
Law law_of(long double dimension) {
    if constexpr (!std::is_constructible_v<Law, long double>)
        return {};
    else
        return Law(dimension);
}

using Options = RoughContactOptions<long double>;

template <class Law>
RoughContact<long double, Law> contact_of(const Parameters& p, const Options& options) {
    return {Roughness<long double>{p.rms_height, p.peak_radius, p.peak_density, 0},
            PeakDistribution<long double>(p.r, p.theta), law_of<Law>(p.dimension), p.modulus, options};
}

template <class Law>
long double stiffness(const Parameters& p, const Options& options) {
    return contact_of<Law>(p, options).at_pressure(p.pressure, Quantity::stiffness).stiffness.value;
}

/// d K/d parameter by a six-point difference in long double: 1e-12 relative or so.
template <class Law>
long double difference(Parameters p, long double Parameters::*which, const Options& options,
                       long double relative_step) {
    const long double at = p.*which, h = relative_step * at;
    const auto k = [&](int steps) {
        p.*which = at + steps * h;
        return stiffness<Law>(p, options);
    };
    return (45 * (k(1) - k(-1)) - 9 * (k(2) - k(-2)) + (k(3) - k(-3))) / (60 * h);
}

template <class Law>
void check(const Parameters& p, const Options& options) {
    const auto s = sensitivity(contact_of<Law>(p, options), p.pressure);
    const long double k = stiffness<Law>(p, options);
    CHECK(test::relative_error(s.stiffness, k) < 1e-14L);
    const struct {
        const char* name;
        long double analytic;
        long double Parameters::*which;
    } rows[] = {{"p", s.pressure, &Parameters::pressure},
                {"sigma", s.rms_height, &Parameters::rms_height},
                {"R", s.peak_radius, &Parameters::peak_radius},
                {"D_p", s.peak_density, &Parameters::peak_density},
                {"D", s.fractal_dimension, &Parameters::dimension},
                {"E", s.effective_modulus, &Parameters::modulus},
                {"r", s.r, &Parameters::r},
                {"theta", s.theta, &Parameters::theta}};
    for (const auto& row : rows) {
        // steps within the range of r and theta: the distance to 1 and to pi/2 scales them
        const long double room = std::min({1.0L, (1 - p.r) / p.r, (1.57079632679489661923L - p.theta) / p.theta});
        const long double numeric = difference<Law>(p, row.which, options, 1e-3L * room);
        INFO(row.name << " r " << double(p.r) << " theta " << double(p.theta) << " p " << double(p.pressure) << ": "
                      << double(row.analytic) << " against " << double(numeric));
        // in units of K per relative change of the parameter
        CHECK(std::abs(row.analytic - numeric) * p.*row.which <= 1e-9L / room * k);
    }
}

}  // namespace

TEST_CASE("derivatives of K at constant pressure agree with differences, for every law and curvature scale") {
    for (const parts::CurvatureScale scale :
         {parts::CurvatureScale::bush_gibson_thomas, parts::CurvatureScale::consistent}) {
        check<HertzLaw<long double>>({}, {.curvature = scale});
        check<FractalLaw<long double>>({}, {.curvature = scale});
        check<FractalConsistentLaw<long double>>({}, {.curvature = scale});
        check<YieldingLaw>({}, {.curvature = scale});
        check<SquareLaw<0>>({}, {.curvature = scale});
        check<SquareLaw<2>>({}, {.curvature = scale});
    }
}

TEST_CASE("with interaction the derivatives agree with differences, for every law") {
    for (const long double length : {1e-5L, 1e-3L}) {
        const Options options{.interaction = {InteractionReading::effective_separation, length}};
        for (const long double pressure : {1e5L, 3e7L}) {
            Parameters p;
            p.pressure = pressure;
            check<HertzLaw<long double>>(p, options);
            check<FractalLaw<long double>>(p, options);
            check<FractalConsistentLaw<long double>>(p, options);
            check<YieldingLaw>(p, options);
        }
    }
}

TEST_CASE("derivatives agree with differences over pressure, r and theta") {
    for (const long double r : {0.05L, 0.5L, 0.9L, 0.99L})
        for (const long double theta : {0.2L, 0.9L, 1.4L})
            for (const long double pressure : {1e3L, 1e7L, 1e10L}) {
                Parameters p;
                p.r = r;
                p.theta = theta;
                p.pressure = pressure;
                check<FractalLaw<long double>>(p, {});
                p.pressure = std::min(pressure, 1e8L);  // the mean pressure of plastic peaks has an upper end
                check<YieldingLaw>(p, {});
                check<SquareLaw<2>>(p, {});
            }
}

TEST_CASE("double agrees with long double, also in hard regimes") {
    for (const double r : {0.0, 0.5, 0.999, 0.999999})
        for (const double theta : {0.01, 1.0, 1.57})
            for (const double pressure : {1e4, 1e8}) {
                const auto fast =
                    sensitivity(RoughContact(test::sand_blasted_fine.roughness(), PeakDistribution<double>(r, theta),
                                             FractalLaw<double>(1.62), 112.6e9),
                                pressure);
                const auto truth = sensitivity(
                    RoughContact(test::sand_blasted_fine.roughness<long double>(),
                                 PeakDistribution<long double>(r, theta), FractalLaw<long double>(1.62L), 112.6e9L),
                    static_cast<long double>(pressure));
                INFO("r " << r << " theta " << theta << " p " << pressure);
                // relative to K per parameter: sums of terms that partly cancel
                CHECK(std::abs(fast.rms_height - double(truth.rms_height)) * test::sand_blasted_fine.rms_height <=
                      1e-11 * fast.stiffness);
                CHECK(std::abs(fast.peak_density - double(truth.peak_density)) * 500e6 <= 1e-11 * fast.stiffness);
                CHECK(std::abs(fast.r - double(truth.r)) * (1 - r) <= 1e-10 * fast.stiffness);
                CHECK(std::abs(fast.theta - double(truth.theta)) * theta <= 1e-10 * fast.stiffness);
            }
}

#endif
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
    static constexpr parts::HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
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
    for (const parts::Heights heights : {parts::Heights::gaussian, parts::Heights::exponential}) {
        const parts::SingleRadius<double> peaks{heights};
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
