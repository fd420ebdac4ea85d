// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/sensitivity.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/scalars.hpp"

using namespace fstiff;

#ifdef FSTIFF_TEST_LONG_DOUBLE
namespace {

struct Parameters {
    long double rms_height = test::sand_blasted_fine.rms_height, peak_radius = test::sand_blasted_fine.peak_radius,
                peak_density = test::sand_blasted_fine.peak_density,
                dimension = test::sand_blasted_fine.fractal_dimension, modulus = 112.6e9L, r = 0.6L, theta = 1.1L,
                pressure = 3e6L;
};

template <class Law>
Law law_of(long double dimension) {
    if constexpr (std::is_same_v<Law, HertzLaw<long double>>)
        return {};
    else
        return Law(dimension);
}

template <class Law>
long double stiffness(const Parameters& p, CurvatureScale scale) {
    const Roughness<long double> surface{p.rms_height, p.peak_radius, p.peak_density, 0};
    return RoughContact<long double, Law>(surface, PeakDensity<long double>(p.r, p.theta), law_of<Law>(p.dimension),
                                          p.modulus, {.curvature = scale})
        .at_pressure(p.pressure, Quantity::stiffness)
        .stiffness.value;
}

/// d K/d parameter by a six-point difference in long double: 1e-12 relative or so.
template <class Law>
long double difference(Parameters p, long double Parameters::*which, CurvatureScale scale, long double relative_step) {
    const long double at = p.*which, h = relative_step * at;
    const auto k = [&](int steps) {
        p.*which = at + steps * h;
        return stiffness<Law>(p, scale);
    };
    return (45 * (k(1) - k(-1)) - 9 * (k(2) - k(-2)) + (k(3) - k(-3))) / (60 * h);
}

template <class Law>
void check(const Parameters& p, CurvatureScale scale) {
    const auto s =
        sensitivity(Roughness<long double>{p.rms_height, p.peak_radius, p.peak_density, 0},
                    PeakDensity<long double>(p.r, p.theta), law_of<Law>(p.dimension), p.modulus, p.pressure, scale);
    const long double k = stiffness<Law>(p, scale);
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
        const long double numeric = difference<Law>(p, row.which, scale, 1e-3L * room);
        INFO(row.name << " r " << double(p.r) << " theta " << double(p.theta) << " p " << double(p.pressure) << ": "
                      << double(row.analytic) << " against " << double(numeric));
        // in units of K per relative change of the parameter
        CHECK(std::abs(row.analytic - numeric) * p.*row.which <= 1e-9L / room * k);
    }
}

}  // namespace

TEST_CASE("derivatives of K at constant pressure agree with differences, for every law and curvature scale") {
    for (const CurvatureScale scale : {CurvatureScale::bush_gibson_thomas, CurvatureScale::consistent}) {
        check<HertzLaw<long double>>({}, scale);
        check<FractalLaw<long double>>({}, scale);
        check<FractalConsistentLaw<long double>>({}, scale);
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
                check<FractalLaw<long double>>(p, CurvatureScale::bush_gibson_thomas);
            }
}

TEST_CASE("double agrees with long double, also in hard regimes") {
    for (const double r : {0.0, 0.5, 0.999, 0.999999})
        for (const double theta : {0.01, 1.0, 1.57})
            for (const double pressure : {1e4, 1e8}) {
                const auto fast = sensitivity(test::sand_blasted_fine.roughness(), PeakDensity<double>(r, theta),
                                              FractalLaw<double>(1.62), 112.6e9, pressure);
                const auto truth =
                    sensitivity(test::sand_blasted_fine.roughness<long double>(), PeakDensity<long double>(r, theta),
                                FractalLaw<long double>(1.62L), 112.6e9L, static_cast<long double>(pressure));
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
    const auto s = sensitivity(test::sand_blasted_fine.roughness(), PeakDensity<double>(0.6, 1.1),
                               FractalConsistentLaw<double>(1.62), 112.6e9, 3e6);
    CHECK(test::relative_error(3e6 * s.pressure + 112.6e9 * s.effective_modulus, s.stiffness) < 1e-13);
    const test::PaperSurface& fine = test::sand_blasted_fine;
    CHECK(test::relative_error(-(fine.rms_height * s.rms_height + fine.peak_radius * s.peak_radius -
                                 2 * fine.peak_density * s.peak_density),
                               s.stiffness) < 1e-13);
}

TEST_CASE("with interaction the derivatives are those of the bulk in series") {
    const Roughness<double> surface{0.832e-6, 40e-6, 500e6, 0};
    const Interaction<double> bulk{InteractionReading::effective_separation, 1e-4};
    const double pressure = 3e6, modulus = 112.6e9;
    const auto stiffness = [&](const Roughness<double>& s, double r, double p, double e, double dimension = 1.62) {
        return RoughContact(s, PeakDensity<double>(r, 1.1), FractalLaw<double>(dimension), e, {.interaction = bulk})
            .at_pressure(p)
            .stiffness.value;
    };
    const auto found = sensitivity(surface, PeakDensity<double>(0.6, 1.1), FractalLaw<double>(1.62), modulus, pressure,
                                   CurvatureScale::bush_gibson_thomas, bulk);
    CHECK(test::relative_error(found.stiffness, stiffness(surface, 0.6, pressure, modulus)) < 1e-13);
    // five points in relative steps of 1e-3: the formula errs by 1e-12, rounding by 1e-14/1e-3
    const auto slope = [](double at, auto value) {
        const double h = 1e-3 * at;
        return (8 * (value(at + h) - value(at - h)) - (value(at + 2 * h) - value(at - 2 * h))) / (12 * h);
    };
    const auto with_height = [&](double x) {
        auto changed = surface;
        changed.rms_height = x;
        return stiffness(changed, 0.6, pressure, modulus);
    };
    CHECK(test::relative_error(found.rms_height, slope(surface.rms_height, with_height)) < 1e-9);
    CHECK(test::relative_error(found.pressure,
                               slope(pressure, [&](double p) { return stiffness(surface, 0.6, p, modulus); })) < 1e-9);
    CHECK(test::relative_error(found.effective_modulus,
                               slope(modulus, [&](double e) { return stiffness(surface, 0.6, pressure, e); })) < 1e-9);
    CHECK(test::relative_error(found.fractal_dimension, slope(1.62, [&](double dimension) {
                                   return stiffness(surface, 0.6, pressure, modulus, dimension);
                               })) < 1e-8);  // the factor has a pole at 2: h^4 f^(5)/30 is 3e-9
    CHECK(test::relative_error(found.r,
                               slope(0.6, [&](double r) { return stiffness(surface, r, pressure, modulus); })) < 1e-8);
}
