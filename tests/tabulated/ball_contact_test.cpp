// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/tabulated/ball_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace ball_contact_test {

using namespace fstiff;
using std::numbers::pi;

namespace {

constexpr double radius = 5e-3, load = 10, stiffest = 1e9;

/// p = 1 GPa exp(-d/scale), whose K is p/scale.
ContactLaw<double> exponential(double scale) {
    return ContactLaw<double>::tabulate_points(
        [scale](double p) {
            return detail::LawPoint<double>{scale * std::log(stiffest / p), p / scale};
        },
        scale, {.min_pressure = 1e2, .max_pressure = 1e11, .outside = OutsideRange::extrapolate}, 1);
}

}  // namespace

TEST_CASE("Displacements of a disc are the integral of Boussinesq's over it") {
    // 1/(pi E) integral dA/distance in polar coordinates about the point: of a point inside, the chord in each
    // direction
    for (const double r : {0.0, 0.3, 0.9}) {
        double chords = 0;
        constexpr int directions = 20000;
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * pi * (i + 0.5) / directions;
            chords += -r * std::cos(angle) + std::sqrt(1 - r * r * std::sin(angle) * std::sin(angle));
        }
        CHECK(test::relative_error(detail::displacement_of_disc(r, 1), chords * 2 * pi / directions / pi) < 1e-10);
    }
    // far away the disc is a point; its edge is continuous, with a slope that is not
    CHECK(test::relative_error(detail::displacement_of_disc(1e4, 1), 1e-4) < 1e-8);
    for (const double beside : {1 - 1e-12, 1 + 1e-12})
        CHECK(test::relative_error(detail::displacement_of_disc(beside, 1), 4 / pi) < 1e-10);
}

TEST_CASE("Bodies that do not yield carry what the law has over the paraboloid") {
    for (const double scale : {1e-8, 1e-6}) {
        const ContactOfBall<double> ball = ball_on_rough_face(exponential(scale), radius, 1e18, load);
        // W = 2 pi R integral of p over d
        CHECK(test::relative_error(ball.pressure, load / (2 * pi * radius * scale)) < 1e-3);
        CHECK(test::relative_error(ball.stiffness, load / scale) < 1e-3);
        CHECK(test::relative_error(ball.radius, 8 / (3 * pi) * std::sqrt(2 * pi * radius * scale)) < 1e-3);
        CHECK(std::abs(ball.approach + scale * std::log(2 * pi * radius * stiffest * scale / load)) < 1e-3 * scale);
        CHECK(ball.error < 5e-3);
    }
}

TEST_CASE("Smooth faces give Hertz, and roughness parts from it in proportion") {
    const double modulus = 110e9, a = std::cbrt(0.75 * load * radius / modulus), approach = a * a / radius;
    double before = 0;
    for (const double scale : {1e-13, 1e-9, 2e-9, 4e-9, 8e-9}) {
        const ContactOfBall<double> ball = ball_on_rough_face(exponential(scale), radius, modulus, load);
        const double part = ball.radius / a - 1;
        CAPTURE(scale, part);
        CHECK(std::abs(part) < 1.6 * scale / approach + ball.error);
        CHECK(std::abs(ball.stiffness / (2 * modulus * a) - 1) < 1.2 * scale / approach + ball.error);
        CHECK(std::abs(ball.pressure / (1.5 * load / (pi * a * a)) - 1) < 2.5 * scale / approach + ball.error);
        if (scale > 1e-9) CHECK(part > before);
        before = part;
    }
}

TEST_CASE("The loading stiffness is the derivative of the load by the approach") {
    for (const double scale : {3e-8, 1e-7, 1e-6}) {
        const auto at = [&](double w) { return ball_on_rough_face(exponential(scale), radius, 110e9, w); };
        const ContactOfBall<double> ball = at(load), more = at(1.01 * load), less = at(0.99 * load);
        // the reach of the rings moves with the load, so that the difference has their error
        CHECK(test::relative_error(0.02 * load / (more.approach - less.approach), ball.loading_stiffness) < 3e-3);
        CHECK(test::relative_error(ball.stiffness, ball.loading_stiffness) < 1e-3);
    }
}

TEST_CASE("A ball without radius, modulus or load, and a law that ends, are refused") {
    const ContactLaw<double> law = exponential(1e-7);
    CHECK(test::refused_for("radius = 0: must be", [&] { return ball_on_rough_face(law, 0, 1e11, 1); }));
    CHECK(test::refused_for("modulus = -1: must be", [&] { return ball_on_rough_face(law, 1, -1, 1); }));
    CHECK(test::refused_for("load = 0: must be", [&] { return ball_on_rough_face(law, 1, 1e11, 0); }));
    CHECK(test::refused_for("pressure",
                            [&] { return ball_on_rough_face(law.with(OutsideRange::refuse), radius, 110e9, 1e-6); }));
}

}  // namespace ball_contact_test
